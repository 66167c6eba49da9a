// plot_layout.h — where things stand on the paper: views, scale, grid.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "plot/plot_scene.h"
#include "plot/plot_tools.h"

namespace kadr::plot {

/// A rectangle on paper, pixels, y downwards.
struct PlotFrame {
    double left = 0;
    double top = 0;
    double width = 0;
    double height = 0;
    double right() const { return left + width; }
    double bottom() const { return top + height; }
};

/// One view: two axes of the part on a frame of the paper.
struct View {
    PlotFrame frame;
    int across = 0;           // axis to the right: 0 X, 1 Y, 2 Z
    int up = 1;               // axis upwards
    double lower_across = 0;  // mm at the left edge
    double lower_up = 0;      // mm at the bottom edge
    double scale = 1;         // pixels a mm
    std::string name;
    double up_given = 1;  // what a mm upwards is called: 2 where a radius is given as a diameter
    /// Seen from above at the front, X to the right and Y into the depth, all three foreshortened
    /// alike; `across` and `up` mean nothing then.
    bool is_isometric = false;

    double x(double mm) const { return frame.left + (mm - lower_across) * scale; }
    double y(double mm) const { return frame.bottom() - (mm - lower_up) * scale; }
    double x(const path::Vec3& point) const {
        return x(is_isometric ? rightwards().dot(point) : point[across]);
    }
    double y(const path::Vec3& point) const {
        return y(is_isometric ? upwards().dot(point) : point[up]);
    }
    /// The directions of the part that lie along the edges of the paper, unit vectors.
    path::Vec3 rightwards() const;
    path::Vec3 upwards() const;
    /// The direction out of the paper.
    path::Vec3 towards_eye() const;
};

struct PlotLayout {
    double width = 0;
    double height = 0;
    SceneBox shown;           // what the views show, mm
    double grid = 10;         // mm between labelled lines
    std::vector<View> views;  // the plan view; then front and side view, if there is depth;
                              // then the isometric one, if it was asked for
    PlotFrame legend;
};

/// The next of 1, 2, 5, 10, 20 … at or above the value.
double round_step(double value);

/// Where grid lines stand: the multiples of the step within the bounds.
std::vector<double> grid_values(double lower, double upper, double step);

/// Chooses one scale at which all views fit the paper. A path without Y is a turned part: it has
/// one view, Z to the right and X upwards, as it lies in the chuck.
///
/// tools  along the path; with any of them there is an isometric view, and room for them in all
PlotLayout lay_out(const PlotScene& scene, std::span<const PlotTool> tools = {});

/// How long a tool is drawn, mm.
double tool_length(const PlotScene& scene);

}  // namespace kadr::plot
