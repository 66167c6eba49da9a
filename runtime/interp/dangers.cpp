// dangers.cpp — what every control executes without a word, and what spoils a spindle.
//
// Each `watch_…` looks at one thing where it begins to act, reports what is wrong with it, and
// changes nothing. Thresholds are rows of danger_limits.def, messages of diagnostics/danger.def.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "base/danger_limits.h"
#include "base/diagnostics/danger.h"
#include "base/diagnostics/doubtful.h"
#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "base/units.h"
#include "interp/block_words.h"
#include "interp/channel.h"
#include "interp/danger_watch.h"
#include "interp/spindles.h"
#include "interp/transformation.h"
#include "interp/word_hints.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Slot;
using nc::SlotMask;
using path::FeedMode;
using path::Vec3;

namespace {

constexpr SlotMask kRotarySlots = bit(Slot::A) | bit(Slot::B) | bit(Slot::C);

/// Whether only rotary axes move: F is in degrees then.
bool only_turns_axes(const Block& block) {
    const SlotMask targets = block.given & nc::kTargetSlots;
    return targets != 0 && (targets & ~kRotarySlots) == 0;
}

constexpr int kShownDecimals = 4;

}  // namespace

DangerWatch::DangerWatch(Channel& channel)
    : channel_(channel),
      dialect_(channel.state.dialect),
      machine_(channel.state.machine),
      is_lathe_(channel.state.is_lathe),
      options_(channel.state.options),
      reporter_(channel.state.reporter),
      modal_(channel.state.motion.modal),
      position_(channel.state.motion.position),
      spindle_(channel.state.spindle.spindle),
      tool_(channel.state.tool.tool),
      comp_(channel.state.stage.comp),
      is_scanning_(channel.state.motion.is_scanning),
      units_(channel.state.motion.units),
      reported_(channel.state.reported),
      dangers_(channel.state.stage.dangers),
      contour_(channel.state.cycle.contour) {}

/// Whether a comment in the line allows the warning: it silences this line, and not the next one.
bool DangerWatch::is_allowed(const DiagnosticRow& row, const Block& block) const {
    return options_.is_allowed && reporter_.locations() != nullptr &&
           options_.is_allowed(row, reporter_.locations()->location(block));
}

/// Whether a feed is to be warned of here: from here on it is reported, if no comment allows it.
bool DangerWatch::first_time_of_feed(const DiagnosticRow& row, const Block& block) {
    if (!is_allowed(row, block)) return reported_.first_time_of_feed(modal_.feed);
    dangers_.feed = std::numeric_limits<double>::quiet_NaN();  // the next cut is looked at again
    return false;
}

void DangerWatch::watch_feed(const Block& block) {
    if (only_turns_axes(block) || is_scanning_) return;
    dangers_.feed = modal_.feed;
    dangers_.feed_mode = modal_.feed_mode;
    const auto at_feed = [&](const DiagnosticRow& row) {
        return block.has(Slot::Feed) ? reporter_.report(row, block, Slot::Feed)
                                     : reporter_.report(row, block);
    };
    const double most = mm_min_from_feed(machine_.max_feed);
    double per_minute = 0;  // 0: it is not known
    switch (modal_.feed_mode) {
        case FeedMode::PerRevolution:
            if (modal_.feed > danger::kMostTurnFeed) {
                if (first_time_of_feed(diag::TurnFeedTooGreat, block))
                    at_feed(diag::TurnFeedTooGreat).arg(modal_.feed).arg(danger::kMostTurnFeed);
                return;
            }
            if (!spindle_.has_cutting_speed) per_minute = modal_.feed * spindle_.speed;
            break;
        case FeedMode::PerMinute:
            if (modal_.feed < danger::kLeastFeed) {
                if (first_time_of_feed(diag::FeedTooSmall, block))
                    at_feed(diag::FeedTooSmall).arg(modal_.feed);
                return;
            }
            per_minute = modal_.feed;
            break;
        case FeedMode::InverseTime: return;
    }
    const bool is_too_fast = most > 0 && per_minute > most * (1 + 1e-9);
    if (is_too_fast && first_time_of_feed(diag::FeedAboveMachine, block))
        at_feed(diag::FeedAboveMachine).arg(round_to(per_minute, kShownDecimals)).arg(most);
}

void DangerWatch::watch_cutting_speed(const Block& block, double from, double to) {
    if (reported_.has_reported(RunNotice::SpeedLimit) || channel_.spindles.highest_speed() > 0 ||
        contour_)
        return;
    if (spindle_.mode != path::SpindleMode::Cw && spindle_.mode != path::SpindleMode::Ccw) return;
    const double radius = from * to < 0 ? 0 : std::abs(to);
    const double most = rpm_from_speed(machine_.max_speed_of(spindle_.number));
    const double mm_min = 1000 * spindle_.cutting_speed;
    const double wanted = mm_min / (2 * std::numbers::pi * radius);
    const bool is_in_centre = !std::isfinite(wanted);
    if (!(mm_min > 0) || (!is_in_centre && !(most > 0 && wanted > most))) return;
    if (is_allowed(diag::NoSpeedLimit, block)) return;
    reported_.count_as_reported(RunNotice::SpeedLimit);
    const std::string shown =
        is_in_centre ? "infinitely many" : std::to_string(std::llround(wanted));
    (block.has(Slot::X) ? reporter_.report(diag::NoSpeedLimit, block, Slot::X)
                        : reporter_.report(diag::NoSpeedLimit, block))
        .arg(shown);
}

void DangerWatch::watch_length(const Block& block, Axis axis) {
    const std::int64_t number = tool_.source == Tool::Source::None ? 0 : tool_.length_number();
    const bool is_same_length = number == dangers_.length;
    if (is_same_length && tool_.current == dangers_.tool) return;
    dangers_.length = number;
    dangers_.tool = tool_.current;
    const Slot word = nc::slot_of(axis);
    const SlotMask distances = modal_.is_incremental ? ~block.absolute : block.incremental;
    if (!is_same_length && block.has(word) && (distances & bit(word)) != 0 && !block.is_of_cycle())
        reporter_.report(diag::IncrementTakesLength, block, word)
            .arg(tool_.current != 0 ? tool_.current : ToolOffsets::tool_of(number));
    const bool is_by_number = tool_.source == Tool::Source::Offset && number != 0;
    dangers_.has_lengths |= is_by_number;
    if (is_by_number && is_lathe_) watch_turret_offset(block, number);
    if (!is_by_number || tool_.current == 0 || number == tool_.current || is_lathe_) return;
    const bool has_offset = block.find(Function::LengthOffset) != nullptr;
    const Function function =
        has_offset ? Function::LengthOffset : nc::programmed_in(block, nc::Group::LengthComp);
    (function != Function::None ? reporter_.report(diag::OtherToolsLength, block, function)
                                : reporter_.report(diag::OtherToolsLength, block))
        .arg(number)
        .arg(tool_.current);
}

void DangerWatch::watch_missing_length(const Block& block) {
    if (contour_ || block.is_of_cycle()) return;
    dangers_.cut_tool = tool_.current;
    const bool has_length = tool_.source != Tool::Source::None && tool_.length_number() != 0;
    if (has_length || tool_.current == 0 || is_lathe_ || !dangers_.has_lengths) return;
    reporter_.report(diag::LengthForgotten, block).arg(tool_.current);
}

/// T0204: on a turret a tool has several offsets, but not that of another tool.
void DangerWatch::watch_turret_offset(const Block& block, std::int64_t number) {
    auto& own = dangers_.own_offsets;
    const auto is_of = [&](std::int64_t tool) { return std::ranges::find(own, tool) != own.end(); };
    if (number == tool_.current && !is_of(number)) own.push_back(number);
    const bool is_other_tool =
        is_of(number) || std::ranges::any_of(machine_.tools, [&](const auto& tool) {
            return tool.number == number;
        });
    if (tool_.current == 0 || number == tool_.current || !is_other_tool) return;
    reporter_.report(diag::OtherToolsOffset, block).arg(number).arg(tool_.current);
}

void DangerWatch::watch_dwell(const Block& block) {
    const SlotMask targets = block.given & nc::kTargetSlots;
    const SlotMask others = block.given & (bit(Slot::Feed) | bit(Slot::Speed));
    if (others == 0 && targets == 0) return;
    const std::string code = reporter_.word_of(block, Function::ExactStopOnce);
    if (code != "G04" && code != "G4") return;
    if (targets != 0) {  // a time unknown to the control, or a position: no axis moves for it
        const Slot slot = first_slot(targets);
        reporter_.report(diag::IsoWordUnused, block, slot).arg(slot_word(slot));
        return;
    }
    reporter_.report(diag::DwellWithoutTime, block, Function::ExactStopOnce)
        .arg(code)
        .arg((others & bit(Slot::Feed)) != 0 ? "F" : "S");
}

void DangerWatch::watch_tap(const Block& block, Function function) {
    const double pitch = modal_.feed / spindle_.speed;
    if (!(pitch < danger::kLeastPitch)) return;
    const double unit = units_ == ProgrammedUnits::Inch ? kMmPerInch : 1;
    (block.has(Slot::Feed) ? reporter_.report(diag::TapPitchTiny, block, Slot::Feed)
                           : reporter_.report(diag::TapPitchTiny, block, function))
        .arg(round_to(pitch, 6))
        .arg("F" + format_shortest(round_to(modal_.feed / unit, 6)))
        .arg(round_to(spindle_.speed, 3))
        .arg(unit == 1 ? "mm/min" : "in/min");
}

void DangerWatch::watch_diameter(const Block& block, Function function) {
    if (options_.has_named_machine || is_lathe_ ||
        reported_.has_reported(RunNotice::DiameterOnMill))
        return;
    if (is_allowed(diag::DiameterOnMill, block)) return;
    reported_.count_as_reported(RunNotice::DiameterOnMill);
    reporter_.report(diag::DiameterOnMill, block, function)
        .arg(reporter_.word_of(block, function))
        .fix("`-m lathe` runs it on one");
}

void DangerWatch::watch_radius(const Block& block, std::int64_t number) {
    const bool is_by_number = tool_.radius_offset != 0 && number == tool_.radius_offset;
    if (!is_by_number || tool_.current == 0 || number == tool_.current || is_lathe_) return;
    const bool is_of_length = tool_.source == Tool::Source::Offset && number == tool_.offset;
    const bool is_other_tool = std::ranges::any_of(
        machine_.tools, [&](const auto& tool) { return tool.number == number; });
    if (is_of_length || !is_other_tool) return;
    if (reported_.has_reported(NoticeEach::OtherToolsRadius, number)) return;
    if (is_allowed(diag::OtherToolsRadius, block)) return;
    reported_.count_as_reported(NoticeEach::OtherToolsRadius, number);
    const bool is_given_here = block.find(Function::RadiusOffset) != nullptr;
    (is_given_here ? reporter_.report(diag::OtherToolsRadius, block, Function::RadiusOffset)
                   : reporter_.report(diag::OtherToolsRadius, block, function_of(comp_.side)))
        .arg(number)
        .arg(tool_.current);
}

/// How far the tip stands below the end of the last rapid, mm; 0 where there was none.
double DangerWatch::below_retract() const {
    if (!dangers_.has_rapid_end) return 0;
    const auto axis = static_cast<Eigen::Index>(index(path::axes_of(modal_.plane).normal));
    return dangers_.rapid_end[axis] - position_.base()[static_cast<std::size_t>(axis)];
}

void DangerWatch::watch_spindle_stop(const Block& block) {
    const bool turns =
        spindle_.mode == path::SpindleMode::Cw || spindle_.mode == path::SpindleMode::Ccw;
    const bool is_in_cut = dangers_.has_moved && !dangers_.is_at_rapid && !is_lathe_;
    if (!turns || !is_in_cut || contour_ || block.is_of_cycle() ||
        channel_.transformation.is_transformed())
        return;
    const double below = below_retract();
    const Vec3 delta =
        Vec3(position_.base()[0], position_.base()[1], position_.base()[2]) - dangers_.rapid_end;
    const double aside = std::sqrt(std::max(0.0, delta.squaredNorm() - below * below));
    if (below <= danger::kRetractSlack || aside <= danger::kRetractSlack) return;
    reporter_.report(diag::SpindleStopsInCut, block, Function::SpindleStop)
        .arg(format_shortest(round_to(below, kShownDecimals)));
}

void DangerWatch::watch_change(const Block& block) {
    if (!dangers_.has_moved || dangers_.is_at_rapid || contour_ ||
        channel_.transformation.is_transformed())
        return;
    if (is_lathe_) {
        reporter_.report(diag::ChangeInCut, block).arg("where the last cut has ended");
        return;
    }
    const double below = below_retract();
    if (below <= danger::kRetractSlack) return;
    reporter_.report(diag::ChangeInCut, block)
        .arg("in the cut, " + format_shortest(round_to(below, kShownDecimals)) +
             " mm below the last retract");
}

void DangerWatch::watch_turn_of_part(const Block& block, const Target& target) {
    if (!is_lathe_ || !block.has(nc::Slot::C)) return;
    constexpr auto kC = index(Axis::C);
    const double turn = std::abs(target.here[kC] - position_.here()[kC]);
    const bool turns =
        spindle_.mode == path::SpindleMode::Cw || spindle_.mode == path::SpindleMode::Ccw;
    const bool cuts = modal_.motion == Function::Line && (block.given & kLinearXYZ) != 0;
    // From zero, as where nobody has used C as an axis.
    const bool is_tiny = position_.here()[kC] == 0 && turn > 0 && turn < danger::kLeastSpindleTurn;
    const std::string hint = hint_at_comma(dialect_.tables(), Axis::C, block.at(nc::Slot::C));
    if (!turns || !cuts || !is_tiny || hint.empty() || block.is_of_cycle()) return;
    reporter_.report(diag::TinyRotation, block, nc::Slot::C)
        .arg("C" + format_shortest(round_to(block.at(nc::Slot::C), 4)))
        .arg(round_to(target.here[kC], 4))
        .fix(hint);
}

}  // namespace kadr::interp
