// approach_moves.cpp — smooth approaches and retractions: from the tool's level to the contour's
// beginning, and back, with the contour's own direction.
//
// The points have the names of the manual's figures: P0 where the tool comes from, P1 above the
// beginning of the path, P2 where the fast infeed ends, P3 where the path begins, P4 on the
// contour. The retraction has the same ones, backwards. Under cutter radius compensation the path
// is a part of the contour and is compensated with it: its size is that of the contour then.
#include <algorithm>
#include <cmath>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "interp/channel.h"
#include "interp/cornering.h"
#include "interp/motion_checks.h"
#include "interp/motions.h"
#include "interp/radius_compensation.h"
#include "interp/smooth_approaches.h"
#include "interp/stages.h"
#include "interp/tool_in_use.h"
#include "path/approach_path.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using nc::Slot;
using nc::SlotMask;
using path::Command;
using path::cross;
using path::Element;
using path::Op;
using path::Vec2;

namespace {

path::ApproachShape approach_shape_of(double number) {
    return number == 2   ? path::ApproachShape::Quarter
           : number == 3 ? path::ApproachShape::Half
                         : path::ApproachShape::Line;
}

}  // namespace

SmoothApproaches::SmoothApproaches(Channel& channel)
    : channel_(channel),
      reporter_(channel.state.reporter),
      rules_(channel.state.rules),
      output_(channel.state.stage.output),
      modal_(channel.state.motion.modal),
      position_(channel.state.motion.position),
      frames_(channel.state.frame.frames),
      tool_(channel.state.tool.tool),
      comp_(channel.state.stage.comp),
      orienting_(channel.state.tool.orienting),
      approach_choice_(channel.state.stage.approach_choice),
      smooth_approach_(channel.state.stage.smooth_approach),
      approached_(channel.state.stage.approached),
      compensation_(channel.state.stage.compensation) {}

/// The words of the block, and how the tool moves before and behind the slow infeed. Nothing: it
/// was reported.
std::optional<ApproachMove> SmoothApproaches::approach_move_of(const Block& block,
                                                               const Actions& actions) {
    // Its path would be laid without the tool, which the transformation holds or turns along it.
    const bool is_transformed = orienting_.is_on;
    if (is_transformed || frames_.is_plane_tilted(modal_.plane)) {
        reporter_.report(diag::IsoNotSupported, block)
            .arg(is_transformed ? "a smooth approach or retraction under the transformation"
                                : "a smooth approach or retraction in a tilted plane");
        return std::nullopt;
    }
    ApproachMove move;
    move.shape = approach_shape_of(
        block.argument(*actions.smooth_approach, parameter_of<Function::SmoothApproach>("shape")));
    move.choice = approach_choice_;
    const Invocation* radius = block.find(Function::ApproachRadius);
    if (radius == nullptr) {
        reporter_.report(diag::SoftSizeWrong, block).arg("there is none");
        return std::nullopt;
    }
    move.radius = block.argument(*radius, parameter_of<Function::ApproachRadius>("radius"));
    if (const Invocation* invocation = block.find(Function::ApproachClearance)) {
        constexpr std::size_t kDistance = parameter_of<Function::ApproachClearance>("distance");
        constexpr std::size_t kLevel = parameter_of<Function::ApproachClearance>("level");
        if (invocation->has(kDistance))
            move.clearance = std::abs(block.argument(*invocation, kDistance));
        else move.level = base_level(block.argument(*invocation, kLevel));
    }
    if (const Invocation* invocation = block.find(Function::ApproachFeed))
        move.slow_feed = block.argument(*invocation, parameter_of<Function::ApproachFeed>("feed"));
    if (!channel_.checks.require_feed(block, "smooth approach or retraction")) return std::nullopt;
    const auto motion = [&](bool is_rapid, double feed) {
        Command command(is_rapid ? Op::Rapid : Op::Line);
        command.motion().feed_mode = modal_.feed_mode;
        command.motion().plane = modal_.plane;
        command.motion().feed = is_rapid ? 0 : feed;
        command.source = block.source;
        command.line = block.line;
        return command;
    };
    const bool was_rapid = actions.was_rapid || !actions.had_feed;
    const bool is_rapid = modal_.motion == Function::Rapid;
    move.fast =
        motion(actions.smooth_approach->function == Function::SmoothApproach ? was_rapid : is_rapid,
               actions.smooth_approach->function == Function::SmoothApproach ? actions.feed_before
                                                                             : modal_.feed);
    const bool keeps_feed =
        actions.smooth_approach->function == Function::SmoothRetract && actions.had_feed;
    move.slow = motion(false, keeps_feed ? actions.feed_before : modal_.feed);
    return move;
}

/// A coordinate along the tool axis, in the base system.
double SmoothApproaches::base_level(double programmed) const {
    AxisValues here = position_.here();
    const std::size_t normal = index(path::axes_of(modal_.plane).normal);
    here[normal] = programmed;
    return frames_.to_base(here)[normal];
}

/// The path as an element of the contour, seen from the point P4 on it; `tool` is where the tool
/// comes from or goes to. Nothing: it was reported.
std::optional<path::ApproachPath> SmoothApproaches::approach_path(const Block& block,
                                                                  const ApproachMove& move,
                                                                  const ApproachPoint& at) {
    // A line is as long as it takes to keep the cutter DISR away from the contour's end.
    const double offset = compensation_.is_on() ? compensation_.distance() : 0;
    path::ApproachPath approach{move.shape, move.radius + std::abs(offset), offset > 0};
    if (move.shape == path::ApproachShape::Line) {
        if (approach.size > path::kSamePoint) return approach;
        reporter_.report(diag::SoftSizeWrong, block).arg("the line has no length");
        return std::nullopt;
    }
    switch (move.choice.side) {
        case ApproachChoice::Side::OfCutter:
            if (offset != 0) break;
            if (!compensation_.is_on() || !comp_.is_on()) {
                reporter_.report(diag::SoftNoDirection, block);
                return std::nullopt;
            }
            approach.is_left = (comp_.side == CompSide::Left) != frames_.is_mirrored(modal_.plane);
            break;
        case ApproachChoice::Side::Left:
        case ApproachChoice::Side::Right:
            approach.is_left = (move.choice.side == ApproachChoice::Side::Left) !=
                               frames_.is_mirrored(modal_.plane);
            break;
        case ApproachChoice::Side::OfTool:
            approach.is_left = cross(at.direction, at.tool - at.point) > 0;
            break;
    }
    // The centre's path has the radius DISR.
    approach.size = move.radius + (approach.is_left ? offset : -offset);
    if (move.radius > 0 && approach.size > path::kSamePoint) return approach;
    reporter_.report(diag::SoftSizeWrong, block)
        .arg(move.radius > 0 ? "the arc of the contour would have none"
                             : "the radius is not above zero");
    return std::nullopt;
}

/// Where fast and slow infeed meet, in the base system. Nothing: it was reported.
std::optional<double> SmoothApproaches::approach_level(const Block& block, const ApproachMove& move,
                                                       double contour, double tool) {
    const double sign = tool < contour ? -1 : 1;
    const double level = move.level.value_or(contour + sign * move.clearance);
    const double above = (level - contour) * sign;
    const bool is_between =
        above >= -path::kSamePoint && above <= std::abs(tool - contour) + path::kSamePoint;
    if (is_between) return level;
    reporter_.report(diag::SoftClearanceWrong, block).arg(round_to(level, 6));
    return std::nullopt;
}

void SmoothApproaches::approach_smoothly(const Block& block, const Actions& actions) {
    const std::optional<ApproachMove> move = approach_move_of(block, actions);
    if (!move) return;
    const SlotMask targets = block.given & nc::kTargetSlots;
    if (!channel_.motions.motion_words().require_axes(block, targets)) return;
    const path::PlaneAxes axes = path::axes_of(modal_.plane);
    const SlotMask plane = bit(nc::slot_of(axes.first)) | bit(nc::slot_of(axes.second));
    const Target target = channel_.motions.motion_words().target_of(block, targets);
    if (tool_.has_changed) channel_.tool.activate_length(block, target.moved);
    if (!channel_.checks.require_within_limits(block, target.base, target.moved)) return;
    channel_.cornering.leave_corners(diag::CornerWithoutMotion);
    if (reporter_.has_ended()) return;
    // A contour that was followed so far ends on its normal, and the compensation begins anew.
    const bool is_new = actions.radius_comp.has_value();
    if (compensation_.is_on() && !comp_.is_on()) {
        channel_.compensation.stop_comp();
    } else if (compensation_.is_on() && !is_new) {
        channel_.compensation.send_comp(
            channel_.compensation.comp_change(block, CompChange::Kind::Begin));
    }
    if (reporter_.has_ended()) return;
    position_.note_motion();
    smooth_approach_.begin(*move, modal_.plane, position_.base(), target.base,
                           (targets & plane) != 0, (targets & bit(nc::slot_of(axes.normal))) != 0);
    channel_.motions.arrive(target);
}

void SmoothApproaches::settle_approach(const Block& block) {
    if (reporter_.has_alarm()) return;
    if (const DiagnosticRow* fault = smooth_approach_.end_block(rules_.comp_empty_blocks)) {
        reporter_.report(*fault, block);
        return;
    }
    if (smooth_approach_.is_active()) {
        if (reporter_.has_ended()) reporter_.report(diag::SoftNoDirection, block);
        return;
    }
    put_smooth_approach();
    if (reporter_.has_alarm()) return;
    for (Command& command : smooth_approach_.waiting())
        channel_.stages.behind_corners() = std::move(command);
    smooth_approach_.waiting().clear();
}

void SmoothApproaches::put_smooth_approach() {
    const ApproachMove& move = smooth_approach_.move();
    const path::PlaneAxes axes = path::axes_of(modal_.plane);
    const std::size_t normal = index(axes.normal);
    const AxisValues& contour = smooth_approach_.position();
    const Block at = channel_.stages.block_at(move.slow.source,
                                              move.slow.line);  // messages are about the approach
    const ApproachPoint point{in_plane(contour), smooth_approach_.direction(),
                              in_plane(smooth_approach_.from())};
    const std::optional<path::ApproachPath> approach = approach_path(at, move, point);
    if (!approach) return;
    const std::optional<double> level =
        approach_level(at, move, contour[normal], smooth_approach_.from()[normal]);
    if (!level) return;
    const Element element = path::approach_path_to(point.point, point.direction, *approach);
    approached_ = Approached{contour, contour};
    set_in_plane(approached_->start, element.from);
    if (!move.choice.in_steps) approached_->start[normal] = *level;

    Command over = move.fast;  // P1
    over.motion().to = smooth_approach_.from();
    set_in_plane(over.motion().to, element.from);
    over.motion().moved = static_cast<AxisMask>(bit(axes.first) | bit(axes.second));
    AxisValues start = over.motion().to;  // P3
    if (compensation_.is_on()) {
        compensation_.begin_smooth_approach(std::move(over));
    } else if ((element.from - point.tool).norm() > path::kSamePoint) {
        output_.next() = std::move(over);
    }
    put_infeed(move.fast, start, *level);  // P2
    const double slow_feed = move.slow_feed.value_or(move.slow.motion().feed);
    if (move.choice.in_steps) {
        Command slow = move.slow;
        slow.motion().feed = slow_feed;
        put_infeed(slow, start, contour[normal]);
    }
    Command last = move.slow;
    if (!move.choice.in_steps) last.motion().feed = slow_feed;
    last.motion().to = contour;
    put_approach_path(last, element);
}

/// A move of the tool axis alone, from `here`, which follows it; none if it stands there.
void SmoothApproaches::put_infeed(Command command, AxisValues& here, double level) {
    const Axis normal = path::axes_of(modal_.plane).normal;
    if (std::abs(here[index(normal)] - level) < path::kSamePoint) return;
    here[index(normal)] = level;
    command.motion().to = here;
    command.motion().moved = bit(normal);
    channel_.stages.behind_corners() = std::move(command);
}

/// The path in the plane, with the level at which the motion ends.
void SmoothApproaches::put_approach_path(Command command, const Element& element) {
    const path::PlaneAxes axes = path::axes_of(modal_.plane);
    path::Motion& motion = command.motion();
    motion.moved = kLinearXYZ;
    set_in_plane(motion.to, element.to);
    if (element.is_arc()) {
        path::ArcShape arc;
        arc.center = {motion.to[0], motion.to[1], motion.to[2]};
        arc.center[static_cast<Eigen::Index>(index(axes.first))] = element.center.x();
        arc.center[static_cast<Eigen::Index>(index(axes.second))] = element.center.y();
        arc.normal = path::unit(axes.normal) * (element.sweep > 0 ? 1 : -1);
        arc.sweep = std::abs(element.sweep);
        arc.is_clockwise = element.sweep < 0;
        motion.shape = arc;
    }
    channel_.stages.behind_corners() = std::move(command);
}

Vec2 SmoothApproaches::in_plane(const AxisValues& values) const {
    const path::PlaneAxes axes = path::axes_of(modal_.plane);
    return {values[index(axes.first)], values[index(axes.second)]};
}

void SmoothApproaches::set_in_plane(AxisValues& values, const Vec2& point) const {
    const path::PlaneAxes axes = path::axes_of(modal_.plane);
    values[index(axes.first)] = point.x();
    values[index(axes.second)] = point.y();
}

void SmoothApproaches::retract_smoothly(const Block& block, const Actions& actions) {
    const std::optional<ApproachMove> move = approach_move_of(block, actions);
    if (!move) return;
    const SlotMask targets = block.given & nc::kTargetSlots;
    if (!channel_.motions.motion_words().require_axes(block, targets)) return;
    channel_.cornering.leave_corners(diag::CornerWithoutMotion);
    if (reporter_.has_ended()) return;
    const path::PlaneAxes axes = path::axes_of(modal_.plane);
    const std::size_t normal = index(axes.normal);
    const SlotMask plane = bit(nc::slot_of(axes.first)) | bit(nc::slot_of(axes.second));
    const bool has_place = (targets & plane) != 0;
    const Target target = channel_.motions.motion_words().target_of(block, targets);
    AxisValues before = position_.base();
    for (std::size_t i = 0; i < 3; ++i)
        before[i] = position_.came_from()[static_cast<Eigen::Index>(i)];
    const Vec2 came = in_plane(position_.base()) - in_plane(before);
    if (came.norm() < path::kSamePoint) {
        reporter_.report(diag::SoftNoDirection, block);
        return;
    }
    if (move->choice.side == ApproachChoice::Side::OfTool && !has_place) {
        reporter_.report(diag::SoftNoWay, block);
        return;
    }
    const ApproachPoint point{in_plane(position_.base()), came.normalized(), in_plane(target.base)};
    const std::optional<path::ApproachPath> approach = approach_path(block, *move, point);
    if (!approach) return;
    const bool has_level = (targets & bit(nc::slot_of(axes.normal))) != 0;
    const double contour = position_.base()[normal];
    const double tool =
        has_level ? target.base[normal] : move->level.value_or(contour + move->clearance);
    const std::optional<double> level = approach_level(block, *move, contour, tool);
    if (!level || !channel_.checks.require_within_limits(block, target.base, target.moved)) return;
    position_.note_motion();

    const Element element = path::approach_path_from(point.point, point.direction, *approach);
    Command first = move->slow;  // P4 to P3
    AxisValues here = position_.base();
    set_in_plane(here, element.to);
    if (!move->choice.in_steps) here[normal] = *level;
    first.motion().to = here;
    put_approach_path(first, element);
    Command slow = move->slow;
    slow.motion().feed = move->slow_feed.value_or(slow.motion().feed);
    put_infeed(slow, here, *level);      // P2
    put_infeed(move->fast, here, tool);  // P1
    const bool was_on = compensation_.is_on();
    if (was_on) {
        channel_.compensation.settle_comp(block, here);
        if (!reporter_.has_ended()) channel_.compensation.stop_comp();
        if (reporter_.has_ended()) return;
        here = compensation_.position();
    }
    if (has_place) {  // P0
        Command away = move->fast;
        away.motion().to = here;
        set_in_plane(away.motion().to, in_plane(target.base));
        away.motion().moved = static_cast<AxisMask>(bit(axes.first) | bit(axes.second));
        here = away.motion().to;
        output_.next() = std::move(away);
    }
    channel_.motions.arrive(
        {frames_.from_base(here), here,
         static_cast<AxisMask>(target.moved | bit(axes.first) | bit(axes.second))});
    if (comp_.is_on() && was_on)
        channel_.compensation.send_comp(
            channel_.compensation.comp_change(block, CompChange::Kind::Begin));
}

}  // namespace kadr::interp
