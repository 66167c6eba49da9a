// drive_table.h — what the drives do during a run, as rows for a program (plot/drive_plot.h draws
// it).
#pragma once

#include <string>

#include "driver/output.h"
#include "process/drive_run.h"

namespace kadr::driver {

/// Rows `t,tip_x,tip_y,tip_z,speed_set,speed,current,load,power,feed,cutting_speed,iso`: s, mm,
/// rpm, A, N·m, W, mm/min, m/min. `tip_x` is the radius.
class DriveTable {
  public:
    /// Writes the header. The output outlives the table.
    explicit DriveTable(Output& out);
    void add(const process::DriveSample& sample);
    void finish();

  private:
    void flush();

    Output& out_;
    std::string text_;
};

}  // namespace kadr::driver
