#include "plot/plot_layout.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace kadr::plot {

namespace {

using path::Vec3;

// Paper, pixels: what the views have together, and what stands around them.
constexpr double kAcross = 1060;
constexpr double kDown = 760;
constexpr double kLeft = 92;  // labels and the dimension of the plan view
constexpr double kTop = 106;  // title
constexpr double kGap = 74;   // between views: labels of the next one
constexpr double kRight = 44;
constexpr double kBottom = 66;
constexpr double kLegendWidth = 190;
constexpr double kLegendHeight = 210;
constexpr double kThinnest = 46;    // of a side view
constexpr double kGridPixels = 52;  // labelled lines are at least this far apart
constexpr double kNarrowest = 620;  // paper: room for the title

constexpr double kMargin = 0.06;      // around the part, share of its largest side
constexpr double kRapidReach = 0.35;  // rapids count up to this share outside of the part

SceneBox shown_box(const PlotScene& scene) {
    SceneBox box = scene.feed_box().is_empty() ? scene.rapid_box() : scene.feed_box();
    if (box.is_empty()) {
        box.add(Vec3(-10, -10, -10));
        box.add(Vec3(10, 10, 10));
    }
    const double side = std::max(box.largest_side(), 1e-3);
    if (!scene.rapid_box().is_empty()) {
        const Vec3 reach = Vec3::Constant(kRapidReach * side);
        SceneBox near;
        near.add(box.lower - reach);
        near.add(box.upper + reach);
        SceneBox rapids;
        rapids.add(scene.rapid_box().lower.cwiseMax(near.lower).cwiseMin(near.upper));
        rapids.add(scene.rapid_box().upper.cwiseMin(near.upper).cwiseMax(near.lower));
        box.add(rapids);
    }
    const double margin = kMargin * box.largest_side() + 1e-3;
    box.lower -= Vec3::Constant(margin);
    box.upper += Vec3::Constant(margin);
    return box;
}

}  // namespace

double round_step(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (step * decade >= value * (1 - 1e-9)) return step * decade;
    }
    return 10 * decade;
}

std::vector<double> grid_values(double lower, double upper, double step) {
    std::vector<double> values;
    for (double i = std::ceil(lower / step); i * step <= upper; ++i) values.push_back(i * step);
    return values;
}

Vec3 View::rightwards() const {
    if (is_isometric) return Vec3(1, 1, 0).normalized();
    return Vec3::Unit(across);
}

Vec3 View::upwards() const {
    if (is_isometric) return Vec3(-1, 1, 2).normalized();
    return Vec3::Unit(up);
}

Vec3 View::towards_eye() const { return rightwards().cross(upwards()); }

namespace {

/// A view that would be a mere line gets some air, at the same scale.
void widen(SceneBox& shown, int axis, double least) {
    const double missing = least - (shown.upper[axis] - shown.lower[axis]);
    if (missing <= 0) return;
    shown.lower[axis] -= missing / 2;
    shown.upper[axis] += missing / 2;
}

void place_turning(PlotLayout& layout) {
    constexpr double kMost = 860;  // pixels along Z: the legend stands beside the view
    const auto scale_now = [&] {
        const Vec3 size = layout.shown.upper - layout.shown.lower;
        return std::min(kMost / size.z(), kDown / size.x());
    };
    widen(layout.shown, 0, kThinnest / scale_now());
    widen(layout.shown, 2, kThinnest / scale_now());
    const double scale = scale_now();
    const Vec3& low = layout.shown.lower;
    const Vec3 pixels = (layout.shown.upper - low) * scale;
    const PlotFrame frame{kLeft, kTop, pixels.z(), pixels.x()};
    layout.grid = round_step(kGridPixels / scale);
    layout.views.push_back({frame, 2, 0, low.z(), low.x(), scale, "Z-X"});
    layout.legend = {frame.right() + kGap, kTop, kLegendWidth, kLegendHeight};
    layout.width = std::max(layout.legend.right() + kRight, kNarrowest);
    layout.height = std::max(frame.bottom(), layout.legend.bottom()) + kBottom;
}

void place_three_views(PlotLayout& layout) {
    const auto scale_now = [&] {
        const Vec3 size = layout.shown.upper - layout.shown.lower;
        return std::min((kAcross - kGap) / (size.x() + size.z()),
                        (kDown - kGap) / (size.y() + size.z()));
    };
    const double first_scale = scale_now();
    for (int axis = 0; axis < 3; ++axis) widen(layout.shown, axis, kThinnest / first_scale);
    const double scale = scale_now();
    layout.grid = round_step(kGridPixels / scale);

    const Vec3& low = layout.shown.lower;
    const Vec3 pixels = (layout.shown.upper - low) * scale;
    const PlotFrame plan{kLeft, kTop, pixels.x(), pixels.y()};
    const PlotFrame front{kLeft, plan.bottom() + kGap, pixels.x(), pixels.z()};
    const PlotFrame side{plan.right() + kGap, kTop, pixels.z(), pixels.y()};
    layout.views = {{plan, 0, 1, low.x(), low.y(), scale, "X-Y"},
                    {front, 0, 2, low.x(), low.z(), scale, "X-Z"},
                    {side, 2, 1, low.z(), low.y(), scale, "Z-Y"}};
    // The legend has the corner that the views leave free.
    layout.legend = {side.left, front.top, std::max(side.width, kLegendWidth), kLegendHeight};
    layout.width = std::max(layout.legend.right() + kRight, kNarrowest);
    layout.height = std::max(front.bottom(), layout.legend.bottom()) + kBottom;
}

/// Beside the others, as high as they are together.
void place_isometric(PlotLayout& layout) {
    constexpr double kWidest = 760;
    constexpr double kMargins = 40;  // pixels that stay free, both sides together
    View view;
    view.is_isometric = true;
    view.name = "isometric";
    Vec3 lower = Vec3::Constant(1e300);
    Vec3 upper = -lower;
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 at;
        for (int axis = 0; axis < 3; ++axis)
            at[axis] =
                (corner >> axis & 1) != 0 ? layout.shown.upper[axis] : layout.shown.lower[axis];
        const Vec3 seen(view.rightwards().dot(at), view.upwards().dot(at), 0);
        lower = lower.cwiseMin(seen);
        upper = upper.cwiseMax(seen);
    }
    const double height = layout.height - kTop - kBottom;
    const Vec3 size = upper - lower;
    view.scale = std::min((height - kMargins) / size.y(), (kWidest - kMargins) / size.x());
    view.frame = {layout.width - kRight + kGap, kTop, size.x() * view.scale + kMargins, height};
    view.lower_across = lower.x() - kMargins / 2 / view.scale;
    view.lower_up = (lower.y() + upper.y()) / 2 - height / 2 / view.scale;
    layout.width = view.frame.right() + kRight;
    layout.views.push_back(view);
}

}  // namespace

double tool_length(const PlotScene& scene) {
    constexpr double kShare = 0.12;  // of the largest side of the part
    const SceneBox& box = scene.feed_box().is_empty() ? scene.rapid_box() : scene.feed_box();
    return kShare * std::max(box.largest_side(), 10.0);
}

PlotLayout lay_out(const PlotScene& scene, std::span<const PlotTool> tools) {
    PlotLayout layout;
    layout.shown = shown_box(scene);
    const double length = tool_length(scene);
    for (const PlotTool& tool : tools) layout.shown.add(tool.tip + length * tool.direction);
    const SceneBox& cut = scene.feed_box();
    const bool is_turning = !cut.is_empty() && cut.lower.y() == cut.upper.y() &&
                            cut.lower.x() < cut.upper.x() && cut.lower.z() < cut.upper.z();
    if (is_turning) place_turning(layout);
    else place_three_views(layout);
    if (!tools.empty()) place_isometric(layout);
    return layout;
}

}  // namespace kadr::plot
