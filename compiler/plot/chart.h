// chart.h — curves over time (or over anything else) as a part of an SVG drawing: paper, grid,
// labelled axes, lines, marks.
//
// A chart knows numbers and names, not what they are of; drive_plot.cpp does.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plot/plot_layout.h"

namespace kadr::plot {

struct ChartLine {
    std::vector<double> across;  // ascending for a curve over time
    std::vector<double> up;      // same size
    std::string color;
    std::string name;  // for the legend in the head of the chart; empty: none
    bool is_dashed = false;
};

/// A moment that is worth a look: a line from top to bottom with a number above the chart.
struct ChartMark {
    double across = 0;
    std::string name;  // empty: only the line
};

/// A part of the chart that stands out from its neighbours.
struct ChartBand {
    double from = 0;
    double to = 0;
};

struct Chart {
    PlotFrame frame;
    std::string title;   // "Radius, mm"
    std::string across;  // "time, s"; empty: no labels below
    double lower = 0;    // of the quantity across; what lies outside is not drawn
    double upper = 1;
    std::optional<double> most;  // what goes above runs out of the chart
    std::vector<ChartLine> lines;
    std::vector<ChartMark> marks;
    std::vector<ChartBand> bands;
    std::vector<ChartBand> alerts;  // likewise, to be looked at
};

/// The number of a mark: a disc with its middle at this point.
void draw_badge(std::string& out, double x, double y, const std::string& name);

/// Appends the drawing; the scale upwards is chosen from what is seen.
void draw_chart(std::string& out, const Chart& chart);

}  // namespace kadr::plot
