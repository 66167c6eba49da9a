// checks.cpp — what a block needs before it moves, and how far the axes may go.
#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <string_view>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "interp/block_words.h"
#include "interp/channel.h"
#include "interp/danger_watch.h"
#include "interp/motion_checks.h"
#include "interp/transformation.h"
#include "interp/word_hints.h"
#include "path/helix.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using nc::Slot;
using nc::SlotMask;
using path::FeedMode;
using path::SpindleMode;
using path::Vec3;

namespace {

/// Rounding of the text and of frames: an axis may stand this far behind its limit.
constexpr double kLimitSlack = 1e-6;  // mm, deg

}  // namespace

MotionChecks::MotionChecks(Channel& channel)
    : channel_(channel),
      dialect_(channel.state.dialect),
      machine_(channel.state.machine),
      options_(channel.state.options),
      reporter_(channel.state.reporter),
      rules_(channel.state.rules),
      modal_(channel.state.motion.modal),
      position_(channel.state.motion.position),
      frames_(channel.state.frame.frames),
      spindle_(channel.state.spindle.spindle),
      tool_(channel.state.tool.tool),
      area_(channel.state.stage.area),
      comp_(channel.state.stage.comp),
      is_scanning_(channel.state.motion.is_scanning),
      units_(channel.state.motion.units),
      taps_rigidly_(channel.state.cycle.taps_rigidly),
      reported_(channel.state.reported),
      dangers_(channel.state.stage.dangers),
      axes_(channel.state.axes),
      length_shift_(channel.state.motion.length_shift),
      contour_(channel.state.cycle.contour) {}

Done MotionChecks::require_no_move_before_tap(const Block& block, SlotMask targets) {
    if (!taps_rigidly_ || targets == 0 || block.is_of_cycle()) return kDone;
    if (block.find(Function::TapRigid) != nullptr) return kDone;
    reporter_.report(diag::TapMoveBefore, block, first_slot(targets));
    return kFailed;
}

Done MotionChecks::require_feed(const Block& block, std::string_view what) {
    if (contour_) return kDone;  // no axis moves
    if (!modal_.has_feed) {
        DiagnosticBuilder message = reporter_.report(diag::FeedMissing, block);
        message.arg(what);
        if (!block.is_of_cycle()) return kFailed;
        const std::string hint =
            hint_at_bare_cycle(dialect_.tables(), reporter_.locations(), *block.context->caller);
        if (!hint.empty()) message.fix(hint);
        return kFailed;
    }
    if (!(modal_.feed > 0)) {
        const double feed = modal_.feed;
        (block.has(Slot::Feed) ? reporter_.report(diag::FeedNotPositive, block, Slot::Feed)
                               : reporter_.report(diag::FeedNotPositive, block))
            .arg(feed);
        return kFailed;
    }
    if (modal_.feed_mode == FeedMode::InverseTime && rules_.inverse_time_feed_in_every_block &&
        !block.has(Slot::Feed)) {
        reporter_.report(diag::InverseTimeFeedMissing, block);
        return kFailed;
    }
    if (spindle_.mode == SpindleMode::Cw || spindle_.mode == SpindleMode::Ccw) {
        check_tool(block);
        if (tool_.current != dangers_.cut_tool) channel_.dangers.watch_missing_length(block);
        if (channel_.dangers.is_new_feed()) [[unlikely]]
            channel_.dangers.watch_feed(block);
        return kDone;
    }
    if (modal_.feed_mode == FeedMode::PerRevolution) {
        reporter_.report(diag::RevolutionFeedStands, block);
        return kFailed;
    }
    // The beam of a scanner comes with its marks.
    if (!is_scanning_ && reported_.first_time(RunNotice::SpindleStopped))
        reporter_.report(diag::FeedWithSpindleStopped, block);
    return kDone;
}

Done MotionChecks::require_probe_feed(const Block& block) {
    const bool has_feed = modal_.has_feed && modal_.feed > 0;
    if (has_feed && modal_.feed_mode == FeedMode::PerMinute) return kDone;
    return require_feed(block, "probing move");
}

void MotionChecks::check_rapid(const Block& block, const Target& target) {
    constexpr auto kZ = static_cast<std::size_t>(Axis::Z);
    const bool stands = spindle_.mode == SpindleMode::Stop;
    const bool dives = (target.moved >> kZ & 1u) != 0 && target.here[kZ] < 0 &&
                       target.here[kZ] < position_.here()[kZ];
    const bool is_mill = axes_.word_scale[0] == 1 && modal_.plane == path::Plane::Xy;
    const bool is_danger = stands && dives && is_mill && !contour_;
    if (!is_danger || !reported_.first_time(RunNotice::Rapid)) return;
    reporter_.report(diag::RapidBelowPlane, block, Slot::Z).arg(round_to(target.here[kZ], 4));
}

void MotionChecks::check_tool(const Block& block) {
    const bool asks = options_.asks_for_tool && machine_.tool_change_time != 0;
    if (!asks || tool_.current != 0 || !reported_.first_time(RunNotice::NoTool)) return;
    DiagnosticBuilder message = reporter_.report(diag::ToolNeverCalled, block);
    // `T0101` is a lathe's tool with its offset.
    const std::int64_t tool = tool_.selected / 100;
    const std::int64_t offset = tool_.selected % 100;
    const auto lathe = dialect_.tables().foreign.find("T@lathe");
    if (tool > 0 && offset == tool && lathe != dialect_.tables().foreign.end()) {
        message.fix(lathe->second);
    } else if (tool_.selected != 0) {
        message.fix("`T" + std::to_string(tool_.selected) +
                    "` only selects a tool: `M6` changes it");
    }
}

void MotionChecks::check_units(const Block& block, nc::Function function) {
    const ProgrammedUnits units = units_of(function);
    const bool changes = units_ != ProgrammedUnits::Unsaid && units_ != units;
    const std::string_view acts = comp_.is_on()          ? "cutter radius compensation"
                                  : frames_.is_rotated() ? "a rotation"
                                  : frames_.is_scaled()  ? "a scaling"
                                                         : "";
    if (changes && rules_.comp_is_innermost && !acts.empty()) {
        reporter_.report(diag::UnitsInside, block, function)
            .arg(units == ProgrammedUnits::Inch ? "inches" : "millimetres")
            .arg(acts);
        return;
    }
    if (changes && position_.has_moved() && reported_.first_time(RunNotice::Units)) {
        const bool to_inch = units == ProgrammedUnits::Inch;
        reporter_.report(diag::UnitsMixed, block, function)
            .arg(to_inch ? "millimetres" : "inches")
            .arg(to_inch ? "inches" : "millimetres");
    }
    units_ = units;
}

Done MotionChecks::require_within_limits(const Block& block, const AxisValues& base,
                                         AxisMask moved) {
    // No axis goes along a contour that is only read; but it does not leave every machine.
    constexpr double kAnyMachine = 1e7;  // mm, deg
    const auto is_near = [](double parameter) { return std::abs(parameter) < kAnyMachine; };
    if (contour_ && std::ranges::all_of(base, is_near)) return kDone;
    // Where the axes go under a transformation is worked out along the path (motion/axis_check.h).
    if (channel_.transformation.is_transformed())
        return area_.acts() ? require_within_area(block, base, moved) : kDone;
    if (!require_within_machine(block, base, moved)) return kFailed;
    return area_.acts() ? require_within_area(block, base, moved) : kDone;
}

/// The tip stays inside of the working area that the program has set.
Done MotionChecks::require_within_area(const Block& block, const AxisValues& base, AxisMask moved) {
    const AxisMask axes =
        frames_.is_shift() ? moved : static_cast<AxisMask>(moved | (axes_.present & kLinearXYZ));
    const std::optional<WorkArea::Excess> excess = area_.excess(base, axes);
    if (!excess) return kDone;
    const Slot word = nc::slot_of(excess->axis);
    (block.has(word) ? reporter_.report(diag::AreaLeft, block, word)
                     : reporter_.report(diag::AreaLeft, block))
        .arg(kAxisNames[index(excess->axis)])
        .arg(round_to(excess->at, 6))
        .arg(round_to(excess->limit, 6));
    return kFailed;
}

Done MotionChecks::require_within_machine(const Block& block, const AxisValues& base,
                                          AxisMask moved) {
    const AxisMask axes =
        frames_.is_shift() ? moved : static_cast<AxisMask>(moved | (axes_.present & kLinearXYZ));
    for (AxisMask rest = axes; rest != 0; rest = static_cast<AxisMask>(rest & (rest - 1))) {
        const auto i = static_cast<std::size_t>(std::countr_zero(rest));
        const double at = base[i] + length_shift_[i];
        if (at < axes_.lower[i] - kLimitSlack || at > axes_.upper[i] + kLimitSlack) {
            report_limit(block, static_cast<Axis>(i), at);
            return kFailed;
        }
    }
    return kDone;
}

Done MotionChecks::require_arc_within_limits(const Block& block, const path::Arc& arc,
                                             const Target& target) {
    if (!require_within_limits(block, target.base, target.moved)) return kFailed;
    if (contour_) return kDone;
    // Far from every limit, which is nearly always, the whole circle is the quick answer.
    const path::ArcMeasures shape = path::measures_of(arc);
    if (channel_.transformation.is_transformed()) return kDone;
    const double reach = std::max(shape.start_radius, shape.end_radius) + std::abs(shape.height);
    bool is_far = !area_.acts();
    for (std::size_t i = 0; i < 3; ++i) {
        const double center = arc.center[static_cast<Eigen::Index>(i)] + length_shift_[i];
        is_far &= center - reach >= axes_.lower[i] && center + reach <= axes_.upper[i];
    }
    if (is_far) return kDone;
    return require_box_within_limits(
        block,
        path::bounds(path::make_helix(arc.start, arc.end, arc.center, arc.normal, arc.sweep)));
}

Done MotionChecks::require_box_within_limits(const Block& block, const path::Box& box) {
    for (std::size_t i = 0; i < 3; ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        for (const double edge : {box.lower[k], box.upper[k]}) {
            const double at = edge + length_shift_[i];
            if (at >= axes_.lower[i] - kLimitSlack && at <= axes_.upper[i] + kLimitSlack) continue;
            report_limit(block, static_cast<Axis>(i), at);
            return kFailed;
        }
    }
    if (!area_.acts()) return kDone;
    const auto corner = [](const Vec3& at) {
        AxisValues values{};
        for (std::size_t i = 0; i < 3; ++i) values[i] = at[static_cast<Eigen::Index>(i)];
        return values;
    };
    if (!require_within_area(block, corner(box.lower), kLinearXYZ)) return kFailed;
    return require_within_area(block, corner(box.upper), kLinearXYZ);
}

void MotionChecks::report_limit(const Block& block, Axis axis, double at) {
    const std::size_t i = index(axis);
    const double limit = at < axes_.lower[i] ? axes_.lower[i] : axes_.upper[i];
    DiagnosticBuilder builder = block.has(nc::slot_of(axis))
                                    ? reporter_.report(diag::AxisLimit, block, nc::slot_of(axis))
                                    : reporter_.report(diag::AxisLimit, block);
    builder.arg(kAxisNames[i]).arg(round_to(at, 6)).arg(round_to(limit, 6));
}

void MotionChecks::set_area_limit(const Block& block, const Invocation& invocation) {
    const bool is_upper =
        count_of(block, invocation, parameter_of<Function::AreaLimit>("upper")) != 0;
    const control::FrameWords words =
        frame_words(block, invocation, parameter_of<Function::AreaLimit>("x"),
                    axes_.word_scale[index(Axis::X)]);
    for (std::size_t i = 0; i < 3; ++i) {
        if (words.has(i)) area_.set(static_cast<Axis>(i), is_upper, words.values[i]);
    }
}

}  // namespace kadr::interp
