// drive_plot.h — what the drives do during a run, as a drawing.
//
// Radius, spindle speed, current and feed over time; beside them the same close to the centre, if
// the tool passes it; below, the current over the radius. The numbers are process/drive_run.h's.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "machine/machine.h"
#include "process/drive_run.h"

namespace kadr::plot {

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

struct DriveText {
    std::string title;
    std::string subtitle;
    std::string warning;  // empty: none
};

/// The drawing as an SVG document.
std::string drive_svg(const DriveTrace& trace, const machine::Drives& drives,
                      const DriveText& text);

}  // namespace kadr::plot
