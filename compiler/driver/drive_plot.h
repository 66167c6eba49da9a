// drive_plot.h — what the drives do during a run: as a drawing for a person, as rows for a program.
//
// Radius, spindle speed, current and feed over time; beside them the same close to the centre, if
// the tool passes it; below, the current over the radius. The numbers are process/drive_run.h's.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "driver/output.h"
#include "machine/machine.h"
#include "process/drive_run.h"

namespace kadr::driver {

/// The samples of a run, thinned evenly so that a long program needs no more memory than a short
/// one; of those that are left out the one with the greatest current stands for its neighbours.
class DriveTrace {
  public:
    void add(const process::DriveSample& sample);
    const std::vector<process::DriveSample>& samples() const { return samples_; }

  private:
    std::vector<process::DriveSample> samples_;
    std::size_t stride_ = 1;   // samples that one stands for
    std::size_t pending_ = 0;  // of the last one, so far
};

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

struct DriveText {
    std::string title;
    std::string subtitle;
    std::string warning;  // empty: none
};

/// The drawing as an SVG document.
std::string drive_svg(const DriveTrace& trace, const machine::Drives& drives,
                      const DriveText& text);

}  // namespace kadr::driver
