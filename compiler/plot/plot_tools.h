// plot_tools.h — how the tool stands along the motion of a run, for a plot.
//
// Collects in bounded memory; the drawing takes of it what has room.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "machine/chain.h"
#include "motion/segment.h"

namespace kadr::plot {

/// The tool at one point of the path.
struct PlotTool {
    path::Vec3 tip = path::Vec3::Zero();
    path::Vec3 direction = path::Vec3::UnitZ();  // from tip to holder, unit vector
};

class PlotTools {
  public:
    /// Adds a piece of motion; only one under a transformation has an orientation that changes.
    void add(const machine::Chain& chain, const motion::Segment& segment);

    std::span<const PlotTool> all() const { return tools_; }

  private:
    void append(const PlotTool& tool);

    std::vector<PlotTool> tools_;
    std::size_t every_ = 1;  // of those that come by one in so many is kept
    std::size_t passed_ = 0;
};

}  // namespace kadr::plot
