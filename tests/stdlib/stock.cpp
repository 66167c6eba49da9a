#include "tests/stdlib/stock.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stdlib_test {

namespace {

using nlohmann::json;
constexpr double kPi = std::numbers::pi;
constexpr double kEmpty = -1e9;   // no material here from the beginning
constexpr double kConeWidth = 6;  // mm
constexpr double kTouch = 1e-4;   // mm: what rounding of the text may do

Place place_of(const json& command) {
    const json& to = command.at("to");
    return {to.at("X"), to.at("Y"), to.at("Z")};
}

std::string number(double value) { return json(std::round(value * 1000) / 1000).dump(); }

}  // namespace

Shape disc(double d) {
    return [d](double x, double y) { return std::hypot(x, y) - d / 2; };
}

Shape rectangle(double w, double h, double r) {
    return [=](double x, double y) {
        const double dx = std::fabs(x) - (w / 2 - r), dy = std::fabs(y) - (h / 2 - r);
        const double outside = std::hypot(std::max(dx, 0.0), std::max(dy, 0.0));
        return outside + std::min(std::max(dx, dy), 0.0) - r;
    };
}

Shape stadium(double l, double w) { return rectangle(l, w, w / 2); }

Shape bent_stadium(double d, double start_deg, double arc_deg, double w) {
    return [=](double x, double y) {
        double angle = std::atan2(y, x) * 180 / kPi - start_deg;
        angle -= 360 * std::floor(angle / 360);
        double from_middle = std::fabs(std::hypot(x, y) - d / 2);
        if (angle > arc_deg) {
            const auto from_end = [&](double end_deg) {
                return std::hypot(x - d / 2 * std::cos(end_deg * kPi / 180),
                                  y - d / 2 * std::sin(end_deg * kPi / 180));
            };
            from_middle = std::min(from_end(start_deg), from_end(start_deg + arc_deg));
        }
        return from_middle - w / 2;
    };
}

Stock::Stock(double half, double cell, double top, const Shape& blank)
    : half_(half), cell_(cell), top_(top), n_(static_cast<int>(2 * half / cell)), blank_(blank) {
    height_.resize(static_cast<std::size_t>(n_) * static_cast<std::size_t>(n_));
    for (int j = 0; j < n_; ++j) {
        for (int i = 0; i < n_; ++i) {
            height_[static_cast<std::size_t>(j * n_ + i)] =
                blank(center(i), center(j)) <= 0 ? top : kEmpty;
        }
    }
}

void Stock::lower_outside(const Shape& shape, double to) {
    for (int j = 0; j < n_; ++j) {
        for (int i = 0; i < n_; ++i) {
            double& height = height_[static_cast<std::size_t>(j * n_ + i)];
            if (shape(center(i), center(j)) > 0) height = std::min(height, to);
        }
    }
}

double Stock::height_at(double x, double y) const {
    const int i = static_cast<int>(std::floor((x + half_) / cell_));
    const int j = static_cast<int>(std::floor((y + half_) / cell_));
    return height_[static_cast<std::size_t>(j * n_ + i)];
}

void Stock::cut(const std::vector<json>& commands, double tool_d, double tip_deg) {
    const bool is_cone = tip_deg < 180;
    tip_radius_ = tool_d / 2;
    radius_ = tip_radius_ + (is_cone ? kConeWidth : 0);
    rise_ = is_cone ? 1 / std::tan(tip_deg / 2 * kPi / 180) : 0;
    for (const json& command : commands) {
        const std::string op = command.at("op");
        if (op != "rapid" && op != "line" && op != "arc") continue;
        const Place to = place_of(command);
        if (!has_position_) {
            position_ = to;
            has_position_ = true;
        }
        before_ = height_;
        move(to, command);
        for (std::size_t i = 0; i < height_.size(); ++i) {
            deepest_ = std::max(deepest_, before_[i] - height_[i]);
        }
        position_ = to;
    }
}

void Stock::move(const Place& to, const json& command) {
    const bool is_rapid = command.at("op") == "rapid";
    const double dz = to.z - position_.z;
    const double flat = std::hypot(to.x - position_.x, to.y - position_.y);
    const bool is_arc = command.at("op") == "arc";
    const bool is_plunge = !is_arc && dz < 0 && flat < 1e-6;
    double sweep = 0, from = 0, r = 0;
    std::array<double, 2> middle{};
    double length = flat;
    if (is_arc) {
        middle = {command.at("center")[0], command.at("center")[1]};
        const double sign = command.at("dir") == "ccw" ? 1 : -1;
        from = std::atan2(position_.y - middle[1], position_.x - middle[0]);
        const double end = std::atan2(to.y - middle[1], to.x - middle[0]);
        sweep = sign * (end - from);
        while (sweep <= 1e-9) sweep += 2 * kPi;
        sweep += 2 * kPi * command.value("turns", 0);
        sweep *= sign;
        r = std::hypot(position_.x - middle[0], position_.y - middle[1]);
        length = std::fabs(sweep) * r;
    }
    const int pieces =
        std::max(1, static_cast<int>(std::ceil(std::hypot(length, dz) / (cell_ / 2))));
    for (int i = 0; i <= pieces; ++i) {
        const double t = static_cast<double>(i) / pieces;
        Place at{position_.x + (to.x - position_.x) * t, position_.y + (to.y - position_.y) * t,
                 position_.z + dz * t};
        if (is_arc) {
            at.x = middle[0] + r * std::cos(from + sweep * t);
            at.y = middle[1] + r * std::sin(from + sweep * t);
        }
        press(at, is_rapid, is_plunge, command);
    }
}

void Stock::press(const Place& at, bool is_rapid, bool is_plunge, const json& command) {
    lowest_ = std::min(lowest_, at.z);
    const auto index = [this](double v) {
        return std::clamp(static_cast<int>(std::floor((v + half_) / cell_)), 0, n_ - 1);
    };
    for (int j = index(at.y - radius_); j <= index(at.y + radius_); ++j) {
        for (int i = index(at.x - radius_); i <= index(at.x + radius_); ++i) {
            const double dx = center(i) - at.x, dy = center(j) - at.y;
            if (dx * dx + dy * dy > radius_ * radius_) continue;
            double& height = height_[static_cast<std::size_t>(j * n_ + i)];
            const double over = std::sqrt(dx * dx + dy * dy) - tip_radius_;
            const double edge = at.z + std::max(over, 0.0) * rise_;
            if (height <= edge + kTouch) continue;
            if ((is_rapid || is_plunge) &&
                (faults_.empty() || faults_.back().command != command.dump())) {
                faults_.push_back({is_rapid ? "rapid into material" : "straight down into material",
                                   command.dump()});
            }
            height = edge;
        }
    }
}

std::string Stock::difference(const Shape& shape, double floor, double margin, double edge) const {
    for (int j = 0; j < n_; ++j) {
        for (int i = 0; i < n_; ++i) {
            const double x = center(i), y = center(j);
            if (blank_(x, y) > 0) continue;
            const double height = height_[static_cast<std::size_t>(j * n_ + i)];
            const double distance = shape(x, y);
            const bool is_floor = distance < -margin && std::fabs(height - floor) > 1e-3;
            const bool is_top = distance > edge && height < top_;
            if (!is_floor && !is_top) continue;
            return (is_top ? "gouged at " : "not right inside at ") + number(x) + ", " + number(y) +
                   ": " + number(height) + ", " + number(distance) + " from the border";
        }
    }
    return "";
}

std::string Stock::spigot_difference(const Shape& shape, double floor, double margin,
                                     double edge) const {
    return difference([&shape](double x, double y) { return -shape(x, y); }, floor, margin, edge);
}

}  // namespace stdlib_test
