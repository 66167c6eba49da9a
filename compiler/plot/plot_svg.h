// plot_svg.h — a plot scene as a drawing for a person: plan view, two side views, dimensions,
// legend.
#pragma once

#include <span>
#include <string>

#include "plot/choices.h"
#include "plot/plot_scene.h"
#include "plot/plot_tools.h"

namespace kadr::plot {

struct PlotText {
    std::string title;     // "bracket.kadr"
    std::string subtitle;  // "FANUC 30i · 34.2 s · 1.28 m"
    std::string warning;   // shown in red: "ended by an alarm: …"; empty: none
    std::string feed_unit = "mm/min";
    bool has_diameters = false;  // of a lathe: X is programmed as a diameter
};

/// The drawing as an SVG document. Views: plan X-Y, below it X-Z, beside it Z-Y, all to one scale,
/// so that edges line up. Feeds (or lines) have colours with a legend; rapids are dashed; arcs
/// stay arcs. Rapids far from the part are cut off at the frame.
///
/// tools  along the path, drawn where they have room; with any of them an isometric view is added
std::string plot_svg(const PlotScene& scene, const PlotText& text, PlotColor color,
                     std::span<const PlotTool> tools = {});

}  // namespace kadr::plot
