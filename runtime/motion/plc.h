// plc.h — who acknowledges M functions, and when.
//
// The seam between the motion and what stands for the machine's PLC: the planner tells when an M
// function is issued, in the time of the plan, and gets the time at which it is done. MachinePlc
// answers as the machine's file has it; another one may simulate a clamp, a tool magazine, a door.
#pragma once

#include <cstdint>

#include "machine/machine.h"

namespace kadr::motion {

/// An M function that the program has issued.
struct IssuedFunction {
    std::int64_t code = 0;   // M10: 10
    double time = 0;         // s, from the start of the program
    std::uint32_t line = 0;  // of the ISO-7bit text
};

class Plc {
  public:
    virtual ~Plc() = default;
    /// When an M function is acknowledged, s from the start of the program, not before it is
    /// issued. Asked once for each, in the order of their times; the plan is the same every time
    /// only if the answer is.
    virtual double acknowledged(const IssuedFunction& function) = 0;
};

/// A function takes as long as the machine's file gives; one that it does not name no time.
class MachinePlc final : public Plc {
  public:
    explicit MachinePlc(const machine::Machine& machine) : machine_(machine) {}
    double acknowledged(const IssuedFunction& function) override;

  private:
    const machine::Machine& machine_;
};

}  // namespace kadr::motion
