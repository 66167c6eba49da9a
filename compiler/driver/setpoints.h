// setpoints.h — the position of every axis at every tick, as CSV.
#pragma once

#include <span>
#include <string>

#include "driver/output.h"
#include "machine/machine.h"
#include "motion/pipeline.h"

namespace kadr::driver {

/// Writes `t,<machine axes…>,tip_x,tip_y,tip_z,tool_i,tool_j,tool_k,feed,iso`: s, mm, deg, mm/min.
/// On a machine with a laser a column follows: `pulse`, points burnt since the row before; or
/// `power` of a continuous beam, W, which falls with the path speed below the programmed feed.
/// Nine decimals, trailing zeros left out: differences of third order still give a jerk.
class SetpointTable {
  public:
    /// Writes the header. References outlive the table.
    SetpointTable(const machine::Machine& machine, Output& out);

    void write(std::span<const motion::Setpoint> setpoints);

  private:
    const machine::Machine& machine_;
    Output& out_;
    std::string text_;
};

}  // namespace kadr::driver
