#include "tests/stdlib/profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stdlib_test {

namespace {

using nlohmann::json;

constexpr double kAir = -1e9;
constexpr double kStep = 0.01;   // mm: from point to point of a path
constexpr double kTouch = 2e-4;  // mm: what rounding of the text may do
constexpr double kInsert = 6;    // mm: length of the tool's back
constexpr double kAlways = 1e6;

struct Arc {
    ProfilePoint center;
    double from = 0, sweep = 0, radius = 0;
};

/// The shorter arc; t to the right, h up.
Arc arc_of(const ProfilePoint& a, const ProfilePoint& b, double radius, bool is_left) {
    const double dt = b.t - a.t, dh = b.h - a.h;
    const double chord = std::hypot(dt, dh);
    const double apart = std::sqrt(std::max(0.0, radius * radius - chord * chord / 4)) / chord;
    const double sign = is_left ? 1 : -1;
    Arc arc;
    arc.center = {(a.h + b.h) / 2 + sign * apart * dt, (a.t + b.t) / 2 - sign * apart * dh};
    arc.radius = radius;
    arc.from = std::atan2(a.h - arc.center.h, a.t - arc.center.t);
    arc.sweep = sign * 2 * std::asin(std::min(1.0, chord / (2 * radius)));
    return arc;
}

void add_line(std::vector<ProfilePoint>& points, const ProfilePoint& a, const ProfilePoint& b) {
    const double length = std::hypot(b.h - a.h, b.t - a.t);
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / kStep)));
    for (int i = 0; i <= pieces; ++i) {
        const double share = static_cast<double>(i) / pieces;
        points.push_back({a.h + (b.h - a.h) * share, a.t + (b.t - a.t) * share});
    }
}

void add_arc(std::vector<ProfilePoint>& points, const Arc& arc) {
    const double length = std::fabs(arc.sweep) * arc.radius;
    const int pieces = std::max(2, static_cast<int>(std::ceil(length / kStep)));
    for (int i = 0; i <= pieces; ++i) {
        const double angle = arc.from + arc.sweep * i / pieces;
        points.push_back({arc.center.h + arc.radius * std::sin(angle),
                          arc.center.t + arc.radius * std::cos(angle)});
    }
}

ProfilePoint seen(double x, double z, const ProfileView& view) {
    if (view.is_facing) return {z, view.side * x};
    return {view.side * x, z};
}

}  // namespace

// ---------------------------------------------------------------- shapes

std::vector<ProfilePoint> ProfileShape::path() const {
    std::vector<ProfilePoint> result;
    ProfilePoint here = start;
    for (const ProfileElement& element : elements) {
        if (element.radius > 0) {
            add_arc(result, arc_of(here, element.to, element.radius, element.is_left));
        } else {
            add_line(result, here, element.to);
        }
        here = element.to;
    }
    return result;
}

std::vector<ProfilePoint> ProfileShape::points() const {
    std::vector<ProfilePoint> result;
    add_line(result, {lowest() - 10, start.t}, start);
    for (const ProfilePoint& point : path()) result.push_back(point);
    add_line(result, end(), {highest() + 20, end().t});
    return result;
}

double ProfileShape::lowest() const {
    double low = start.h;
    for (const ProfilePoint& point : path()) low = std::min(low, point.h);
    return low;
}

double ProfileShape::highest() const {
    double high = start.h;
    for (const ProfilePoint& point : path()) high = std::max(high, point.h);
    return high;
}

// ---------------------------------------------------------------- the material

Profile::Profile(double t_low, double t_high, double cell) : t_low_(t_low), cell_(cell) {
    height_.assign(static_cast<std::size_t>((t_high - t_low) / cell) + 1, kAir);
}

std::size_t Profile::index(double t) const {
    const double i = std::floor((t - t_low_) / cell_);
    return static_cast<std::size_t>(std::clamp(i, 0.0, static_cast<double>(height_.size()) - 1));
}

void Profile::fill(double t_low, double t_high, double h) {
    for (std::size_t i = 0; i < height_.size(); ++i) {
        if (place(i) > t_low && place(i) < t_high) height_[i] = h;
    }
}

void Profile::cut(const std::vector<json>& commands, const ProfileView& view,
                  const TurningTool& tool) {
    for (const json& command : commands) {
        const std::string op = command.at("op");
        if (op != "rapid" && op != "line" && op != "arc") continue;
        const double x = command.at("to").at("X"), z = command.at("to").at("Z");
        const bool is_first = !has_position_;
        const bool is_single = std::fabs(x - x_) < 1e-9 || std::fabs(z - z_) < 1e-9;
        const ProfilePoint from = seen(is_first ? x : x_, is_first ? z : z_, view);
        const ProfilePoint to = seen(x, z, view);
        has_position_ = true;
        x_ = x;
        z_ = z;
        if (op == "rapid" && !is_single && !is_first && !tool.rapids_in_both)
            faults_.push_back("rapid in two axes: " + command.dump());
        std::vector<ProfilePoint> points;
        if (op == "arc") {
            const ProfilePoint center =
                seen(command.at("center")[0], command.at("center")[2], view);
            const bool is_ccw = command.at("dir") == "ccw";
            // The plane Z-X: Z to the right, X up. Swapping the axes mirrors, so does a bore.
            const bool is_left = is_ccw == ((view.is_facing ? -view.side : view.side) > 0);
            add_arc(points,
                    arc_of(from, to, std::hypot(from.h - center.h, from.t - center.t), is_left));
        } else {
            add_line(points, from, to);
        }
        const std::vector<double> before = height_;
        travel(points, tool);
        double deepest = 0;
        for (std::size_t i = 0; i < height_.size(); ++i) {
            if (before[i] > kAir) deepest = std::max(deepest, before[i] - height_[i]);
        }
        if (op == "rapid" && deepest > kTouch) {
            faults_.push_back("rapid into material: " + command.dump());
        } else {
            deepest_ = std::max(deepest_, deepest);
        }
        if (tool.width > 0) continue;
        for (std::size_t i = 0; i < points.size(); i += 25)
            check_back(points[i], tool, command.dump());
        check_back(points.back(), tool, command.dump());
    }
}

void Profile::travel(const std::vector<ProfilePoint>& points, const TurningTool& tool) {
    if (tool.nose > 0 || tool.width > 0) {
        for (const ProfilePoint& point : points) press(point, tool);
        return;
    }
    // A sharp tip: the cells that it passes, each at the height of the tip over its middle.
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        const ProfilePoint& a = points[k];
        const ProfilePoint& b = points[k + 1];
        const double low = std::min(a.t, b.t), high = std::max(a.t, b.t);
        for (std::size_t i = index(low); i <= index(high); ++i) {
            if (place(i) < low || place(i) > high) continue;
            const double share = high - low < 1e-12 ? 0 : (place(i) - a.t) / (b.t - a.t);
            height_[i] = std::min(height_[i], a.h + (b.h - a.h) * share);
        }
    }
}

void Profile::press(const ProfilePoint& tip, const TurningTool& tool) {
    const double r = tool.nose;
    for (std::size_t i = index(tip.t); tool.width > 0 && i <= index(tip.t + tool.width); ++i) {
        if (place(i) > tip.t && place(i) < tip.t + tool.width)
            height_[i] = std::min(height_[i], tip.h);
    }
    if (tool.width > 0) return;
    const ProfilePoint center{tip.h + r, tip.t + r};
    for (std::size_t i = index(center.t - r); i <= index(center.t + r); ++i) {
        const double dt = place(i) - center.t;
        if (std::fabs(dt) > r) continue;
        height_[i] = std::min(height_[i], center.h - std::sqrt(r * r - dt * dt));
    }
}

/// The back of the tool rises from its nose at a constant angle; no material may be above it.
void Profile::check_back(const ProfilePoint& tip, const TurningTool& tool,
                         const std::string& command) {
    const double r = tool.nose, angle = tool.back_deg * std::numbers::pi / 180;
    const ProfilePoint center{tip.h + r, tip.t + r};
    const double from = center.t + r * std::sin(angle);
    for (std::size_t i = index(from) + 2; i < index(from + kInsert); ++i) {
        const double back =
            center.h + (place(i) - center.t) * std::tan(angle) - r / std::cos(angle);
        if (height_[i] <= back + 0.02) continue;
        if (faults_.empty() || !faults_.back().ends_with(command))
            faults_.push_back("the back of the tool is in material: " + command);
        return;
    }
}

std::vector<double> Profile::kept(const ProfileShape& shape, double allowance, double more_h,
                                  double more_t, double nose) const {
    // Where the centre of the nose may be at the lowest …
    const double r = allowance + nose;
    std::vector<double> centers(height_.size(), kAir);
    const std::vector<ProfilePoint> points = shape.points();
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        const ProfilePoint a{points[k].h + more_h, points[k].t + more_t};
        const ProfilePoint b{points[k + 1].h + more_h, points[k + 1].t + more_t};
        const double low = std::min(a.t, b.t) - r, high = std::max(a.t, b.t) + r;
        for (std::size_t i = index(low); i <= index(high); ++i) {
            if (place(i) < low || place(i) > high) continue;
            double h = kAir;
            if (r == 0) {
                h = std::fabs(b.t - a.t) < 1e-12
                        ? std::max(a.h, b.h)
                        : a.h + (b.h - a.h) * (place(i) - a.t) / (b.t - a.t);
            } else if (std::fabs(place(i) - a.t) <= r) {
                h = a.h + std::sqrt(r * r - (place(i) - a.t) * (place(i) - a.t));
            }
            centers[i] = std::max(centers[i], h);
        }
    }
    // Behind the end nothing is touched.
    for (std::size_t i = 0; i < centers.size(); ++i) {
        if (place(i) < shape.end().t + more_t) centers[i] = kAlways;
    }
    if (nose == 0) return centers;
    // … and what it then leaves.
    std::vector<double> result(height_.size(), kAlways);
    for (std::size_t c = 0; c < centers.size(); ++c) {
        for (std::size_t i = index(place(c) - nose); i <= index(place(c) + nose); ++i) {
            const double dt = place(i) - place(c);
            if (std::fabs(dt) > nose) continue;
            result[i] = std::min(result[i], centers[c] - std::sqrt(nose * nose - dt * dt));
        }
    }
    return result;
}

}  // namespace stdlib_test
