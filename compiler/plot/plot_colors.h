// plot_colors.h — which colour a feed or a line has in a plot, and their legend.
#pragma once

#include <string>
#include <vector>

#include "plot/choices.h"
#include "plot/plot_scene.h"

namespace kadr::plot {

struct LegendEntry {
    std::string color;  // "#1f6fb4"
    std::string label;  // "200", "200 to 350", "lines 10 to 24"
    double upper = 0;   // shades up to here have this colour
};

/// Few different feeds get a colour each; many are grouped from slow to fast, lines from first to
/// last. In ascending order; empty if nothing is cut.
std::vector<LegendEntry> legend_of(const PlotScene& scene, PlotColor color);

/// The entry that a shade belongs to.
const LegendEntry& entry_for(const std::vector<LegendEntry>& legend, double shade);

}  // namespace kadr::plot
