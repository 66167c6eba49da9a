// setpoints.h — the position of every axis at every tick, as CSV or as an array of NumPy.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "driver/output.h"
#include "machine/machine.h"
#include "motion/pipeline.h"

namespace kadr::driver {

/// Rows `t,<machine axes…>,tip_x,tip_y,tip_z,tool_i,tool_j,tool_k,feed,iso`: s, mm, deg, mm/min.
/// On a machine with a laser a column follows: `pulse`, points burnt since the row before; or
/// `power` of a continuous beam, W, which falls with the path speed below the programmed feed.
class SetpointTable {
  public:
    virtual ~SetpointTable() = default;
    virtual void write(std::span<const motion::Setpoint> setpoints) = 0;
    /// Behind the last row.
    ///
    /// alarm  what ended the run before its end; empty: nothing did
    virtual void finish(const std::string& alarm) = 0;
};

/// A table that begins in `out`, whose name chooses the format: `.npy` is a one-dimensional array
/// of records, whose fields have the names of the columns (format 1.0, little-endian); anything
/// else CSV with nine decimals, trailing zeros left out: differences of third order still give a
/// jerk. Both outlive the table.
std::unique_ptr<SetpointTable> open_setpoints(const machine::Machine& machine, Output& out);

}  // namespace kadr::driver
