#include "plot/motion_plot.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/numbers.h"
#include "base/units.h"
#include "machine/kinematics.h"
#include "plot/chart.h"
#include "plot/svg_text.h"

namespace kadr::plot {

namespace {

using Bin = MotionTrace::Bin;
using Span = MotionTrace::Span;

constexpr std::size_t kMostBins = 1 << 13;
constexpr std::size_t kMostBlocks = 400;  // that can be told apart on paper
constexpr std::size_t kMostPoles = 200;
// Nearer to the axis R1 the tool is at the pole: there R1 turns many times as fast as the tool.
constexpr double kNearPole = rad_from_deg(0.5);

void begin(Span& span, double value) { span = {value, value, value, value}; }

void extend(Span& span, double value) {
    span.least = std::min(span.least, value);
    span.greatest = std::max(span.greatest, value);
    span.last = value;
}

void join(Span& span, const Span& next) {
    span.least = std::min(span.least, next.least);
    span.greatest = std::max(span.greatest, next.greatest);
    span.last = next.last;
}

/// Applies `act(span, value)` to all quantities of a bin.
template <typename Act>
void for_all(Bin& bin, const motion::Setpoint& setpoint,
             const std::array<std::array<double, kAxes>, MotionTrace::kQuantities>& now,
             std::size_t axes, const Act& act) {
    act(bin.feed, setpoint.feed);
    act(bin.programmed, setpoint.programmed_feed);
    for (std::size_t quantity = 0; quantity < now.size(); ++quantity) {
        for (std::size_t i = 0; i < axes; ++i) act(bin.axes[quantity][i], now[quantity][i]);
    }
}

}  // namespace

void MotionTrace::add(const motion::Setpoint& setpoint) {
    const std::size_t axes = machine_.axes.size();
    for (std::size_t i = 0; i < axes; ++i) {
        double value = setpoint.axis[i];
        for (std::size_t quantity = 0; quantity < kQuantities; ++quantity) {
            const double before = has_any_ ? now_[quantity][i] : quantity == 0 ? value : 0;
            now_[quantity][i] = value;
            value = (value - before) / tick_;
        }
    }
    has_any_ = true;
    const bool is_shown =
        setpoint.time >= window_.from && (window_.to <= 0 || setpoint.time <= window_.to);
    if (!is_shown) return;
    keep_block(setpoint);
    keep_pole(setpoint);
    keep(setpoint);
    last_time_ = setpoint.time;
}

void MotionTrace::keep(const motion::Setpoint& setpoint) {
    const std::size_t axes = machine_.axes.size();
    // Behind a wait, of whose middle nothing is recorded, a bin would begin long before its end.
    const bool follows = setpoint.time < last_time_ + 1.5 * tick_;
    if (pending_ > 0 && pending_ < stride_ && follows) {
        ++pending_;
        for_all(bins_.back(), setpoint, now_, axes, extend);
        return;
    }
    if (bins_.size() == kMostBins) halve();
    bins_.emplace_back().time = setpoint.time;
    for_all(bins_.back(), setpoint, now_, axes, begin);
    pending_ = 1;
}

void MotionTrace::keep_block(const motion::Setpoint& setpoint) {
    if (!blocks_.empty() && blocks_.back().line == setpoint.line) return;
    has_too_many_blocks_ = has_too_many_blocks_ || blocks_.size() == kMostBlocks;
    if (has_too_many_blocks_) blocks_.back().line = setpoint.line;
    else blocks_.push_back({setpoint.time, setpoint.line});
}

void MotionTrace::keep_pole(const motion::Setpoint& setpoint) {
    if (!machine_.kinematics || !machine_.kinematics->chain.orients()) return;
    const machine::Chain& chain = machine_.kinematics->chain;
    path::Vec3 rotary = path::Vec3::Zero();
    for (std::size_t k = 0; k < machine::kJoints; ++k) {
        for (std::size_t i = 0; chain.has(k) && i < machine_.axes.size(); ++i) {
            if (machine_.axes[i].axis == chain.joints[k].axis)
                rotary[static_cast<Eigen::Index>(k)] = setpoint.axis[i];
        }
    }
    const double tilt = machine::pole_angle_of(chain, machine::tool_vector(chain, rotary));
    if (std::min(tilt, std::numbers::pi - tilt) > kNearPole) return;
    const bool goes_on =
        !poles_.empty() && (poles_.back().to == last_time_ || poles_.size() == kMostPoles);
    if (goes_on) poles_.back().to = setpoint.time;
    else poles_.push_back({setpoint.time, setpoint.time});
}

void MotionTrace::halve() {
    for (std::size_t i = 0; 2 * i + 1 < bins_.size(); ++i) {
        const Bin second = bins_[2 * i + 1];
        bins_[i] = bins_[2 * i];
        join(bins_[i].feed, second.feed);
        join(bins_[i].programmed, second.programmed);
        for (std::size_t quantity = 0; quantity < kQuantities; ++quantity) {
            for (std::size_t axis = 0; axis < kAxes; ++axis)
                join(bins_[i].axes[quantity][axis], second.axes[quantity][axis]);
        }
    }
    bins_.resize(bins_.size() / 2);
    stride_ *= 2;
}

// ------------------------------------------------------------------------------------------ paper

namespace {

constexpr double kLeft = 96;
constexpr double kTop = 126;
constexpr double kWide = 980;
constexpr double kHigh = 150;
constexpr double kGap = 36;
constexpr double kStrip = 15;  // px, height of the row of blocks
constexpr const char* kColors[] = {"#1f6fb4", "#1e7d43", "#b45f06", "#6a3d9a", "#a6265b",
                                   "#0f7f86", "#7a5c1e", "#4b5563", "#b3261e"};

void add_span(ChartLine& line, double time, const Span& span, double factor) {
    const auto put_value = [&](double value) {
        line.across.push_back(time);
        line.up.push_back(factor * value);
    };
    put_value(span.first);
    if (span.least < std::min(span.first, span.last)) put_value(span.least);
    if (span.greatest > std::max(span.first, span.last)) put_value(span.greatest);
    if (span.last != span.first) put_value(span.last);
}

std::string neat(double value) { return fmt::format("{:.10g}", round_to(value, 3)); }

Chart feed_chart(const MotionTrace& trace) {
    Chart chart;
    chart.title = "Path speed, mm/min";
    ChartLine programmed{{}, {}, kSoft, "programmed", true};
    ChartLine real{{}, {}, kColors[0], "of the tool", false};
    for (const Bin& bin : trace.bins()) {
        add_span(programmed, bin.time, bin.programmed, mm_min_from_feed(1));
        add_span(real, bin.time, bin.feed, mm_min_from_feed(1));
    }
    chart.lines = {std::move(programmed), std::move(real)};
    // Rapids are many times as fast as a cut: they run out of the chart.
    constexpr double kAbove = 1.3;
    double most = 0;
    for (const Bin& bin : trace.bins()) most = std::max(most, bin.programmed.greatest);
    if (most > 0) chart.most = kAbove * mm_min_from_feed(most);
    return chart;
}

/// What people read, of what is calculated in.
double factor_of(const machine::MachineAxis& axis, MotionTrace::Quantity quantity) {
    const double angle = axis.is_rotary ? deg_from_rad(1) : 1;
    return quantity == MotionTrace::Velocity ? 60 * angle : angle;
}

double limit_of(const machine::MachineAxis& axis, MotionTrace::Quantity quantity) {
    switch (quantity) {
        case MotionTrace::Velocity: return axis.velocity;
        case MotionTrace::Acceleration: return axis.acceleration;
        case MotionTrace::Jerk: return axis.jerk;
        default: return 0;
    }
}

/// The limits of an axis on either side, infinite where there is none.
std::pair<double, double> limits_of(const machine::MachineAxis& axis,
                                    MotionTrace::Quantity quantity) {
    if (quantity == MotionTrace::Position) return {axis.lower, axis.upper};
    const double limit = limit_of(axis, quantity);
    return {-limit, limit};
}

/// Lines at the limits that a curve comes near to, in its colour.
void add_limits(Chart& chart, const MotionTrace& trace, MotionTrace::Quantity quantity,
                std::size_t i, const std::string& color) {
    constexpr double kNear = 0.15;  // share of the path that the curve has, or of the limit
    const machine::MachineAxis& axis = trace.machine().axes[i];
    const double factor = factor_of(axis, quantity);
    const auto [lower, upper] = limits_of(axis, quantity);
    double least = 0, greatest = 0;
    bool has_any = false;
    for (const Bin& bin : trace.bins()) {
        const Span& span = bin.axes[quantity][i];
        least = has_any ? std::min(least, span.least) : span.least;
        greatest = has_any ? std::max(greatest, span.greatest) : span.greatest;
        has_any = true;
    }
    const double reach = kNear * (greatest - least);
    const auto line_at = [&](double limit) {
        if (!std::isfinite(limit) || !(greatest > least)) return;
        const double from = trace.bins().front().time;
        const double to = trace.bins().back().time;
        chart.lines.push_back({{from, to}, {factor * limit, factor * limit}, color, {}, true});
    };
    if (least < lower + reach) line_at(lower);
    if (greatest > upper - reach) line_at(upper);
}

Chart axis_chart(const MotionTrace& trace, MotionTrace::Quantity quantity, bool is_rotary) {
    constexpr const char* kTitles[] = {"Position, {}", "Velocity, {}/min", "Acceleration, {}/s²",
                                       "Jerk, {}/s³"};
    Chart chart;
    chart.title = fmt::format(fmt::runtime(kTitles[quantity]), is_rotary ? "deg" : "mm");
    const std::vector<machine::MachineAxis>& axes = trace.machine().axes;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        if (axes[i].is_rotary != is_rotary) continue;
        const double factor = factor_of(axes[i], quantity);
        const double limit = limit_of(axes[i], quantity);
        ChartLine line{{}, {}, kColors[i % std::size(kColors)], axes[i].name, false};
        if (limit > 0 && std::isfinite(limit)) line.name += " (limit " + neat(factor * limit) + ')';
        for (const Bin& bin : trace.bins()) add_span(line, bin.time, bin.axes[quantity][i], factor);
        const std::string color = line.color;
        chart.lines.push_back(std::move(line));
        add_limits(chart, trace, quantity, i, color);
    }
    return chart;
}

/// The blocks as bands behind the curves, every second one shaded.
std::vector<ChartBand> bands_of(const MotionTrace& trace, double end) {
    std::vector<ChartBand> bands;
    const std::vector<MotionTrace::BlockStart>& blocks = trace.blocks();
    for (std::size_t i = 1; i < blocks.size(); i += 2)
        bands.push_back({blocks[i].time, i + 1 < blocks.size() ? blocks[i + 1].time : end});
    return bands;
}

/// The lines of the blocks in a row above the charts, as far as they have room.
void draw_strip(std::string& out, const MotionTrace& trace, const Chart& chart) {
    const std::vector<MotionTrace::BlockStart>& blocks = trace.blocks();
    const PlotFrame& f = chart.frame;
    const double per_second = f.width / (chart.upper - chart.lower);
    const double top = f.top - 24 - kStrip;
    put(out,
        "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"11\" text-anchor=\"end\" "
        "fill=\"{}\">line</text>\n",
        f.left - 6, top + kStrip - 4, kSoft);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const double from = f.left + (blocks[i].time - chart.lower) * per_second;
        const double to = i + 1 < blocks.size()
                              ? f.left + (blocks[i + 1].time - chart.lower) * per_second
                              : f.right();
        put(out,
            "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"/>\n",
            from, top, to - from, kStrip, i % 2 == 0 ? "#e9edf2" : "#d3dbe5");
        const std::string name = std::to_string(blocks[i].line);
        if (to - from < 6.6 * static_cast<double>(name.size()) + 2) continue;
        put(out,
            "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"10.5\" text-anchor=\"middle\" "
            "fill=\"{}\">{}</text>\n",
            (from + to) / 2, top + kStrip - 4, kInk, name);
    }
}

/// What the red ground means.
void draw_pole_legend(std::string& out, const Chart& chart) {
    const PlotFrame& f = chart.frame;
    put(out,
        "<rect x=\"{:.1f}\" y=\"46\" width=\"16\" height=\"12\" fill=\"{}\"/>\n"
        "<text x=\"{:.1f}\" y=\"56\" font-size=\"11\" fill=\"{}\">tool along the first rotary axis "
        "(pole)</text>\n",
        f.right() - 246, kAlertGround, f.right() - 224, kSoft);
}

}  // namespace

std::string motion_svg(const MotionTrace& trace, const MotionText& text) {
    std::vector<Chart> charts;
    charts.push_back(feed_chart(trace));
    for (const auto quantity : {MotionTrace::Position, MotionTrace::Velocity,
                                MotionTrace::Acceleration, MotionTrace::Jerk}) {
        for (const bool is_rotary : {false, true}) {
            Chart chart = axis_chart(trace, quantity, is_rotary);
            if (!chart.lines.empty()) charts.push_back(std::move(chart));
        }
    }
    const std::vector<Bin>& bins = trace.bins();
    const double from = bins.empty() ? 0 : bins.front().time;
    const double to = bins.size() < 2 ? from + 1 : bins.back().time;
    double top = kTop;
    for (Chart& chart : charts) {
        chart.frame = {kLeft, top, kWide, kHigh};
        chart.lower = from;
        chart.upper = to;
        if (!trace.has_too_many_blocks()) chart.bands = bands_of(trace, to);
        for (const MotionTrace::PoleSpan& pole : trace.poles())
            chart.alerts.push_back({pole.from, pole.to});
        top += kHigh + kGap;
    }
    charts.back().across = "time, s";
    std::string out;
    put_start(out, kLeft + kWide + 30, top + 14);
    put_paper(out, text.title);
    put_title(out, text.title, text.subtitle, text.warning);
    if (!trace.poles().empty()) draw_pole_legend(out, charts.front());
    if (!trace.has_too_many_blocks()) draw_strip(out, trace, charts.front());
    for (const Chart& chart : charts) draw_chart(out, chart);
    return out + "</svg>\n";
}

}  // namespace kadr::plot
