// plc_handshake.h — M functions are issued where a piece begins, and waited for where one stands
// until they are acknowledged.
#pragma once

#include <deque>

#include "machine/machine.h"
#include "motion/piece.h"
#include "motion/plc.h"

namespace kadr::motion {

class PlcHandshake {
  public:
    /// plc  who acknowledges; null: the machine's file tells when. References outlive it
    PlcHandshake(const machine::Machine& machine, Plc* plc) : machine_plc_(machine), plc_(plc) {}

    /// A piece begins, and with it its M functions; one that awaits them stands until all that was
    /// issued so far is acknowledged.
    ///
    /// issued  M functions that pieces issue, in their order; those of this piece are taken
    /// time    at which the piece begins, s
    void begin(Piece& piece, std::deque<IssuedFunction>& issued, double time);

  private:
    MachinePlc machine_plc_;
    Plc* plc_;                 // null: machine_plc_
    double acknowledged_ = 0;  // s, all that was issued so far
};

}  // namespace kadr::motion
