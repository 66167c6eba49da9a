// arc_threads.cpp — threads along arcs: the spindle is geared to one axis of the plane, so the arc
// becomes a chain of lines, each with the pitch that its direction asks for.
// source: SINUMERIK reference 2.1 (G335, G336), FANUC reference 2.3 (G35, G36)
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "base/diagnostics/iso.h"
#include "interp/channel.h"
#include "interp/cornering.h"
#include "interp/motion_checks.h"
#include "interp/motions.h"
#include "interp/path_smoothing.h"
#include "interp/stages.h"
#include "interp/tool_in_use.h"
#include "path/linear.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Slot;
using nc::SlotMask;
using path::linear;
using path::Op;
using path::Vec3;

namespace {

/// How far the lines may leave the arc, mm: half of what a control rounds to.
constexpr double kSagitta = 0.0005;

/// A line of the chain that goes along the axis of the pitch by less than this part of its length
/// would be faster than any spindle allows.
constexpr double kLeastPart = 1e-3;

int lines_of(const path::Arc& arc) {
    const double radius = (arc.start - arc.center).norm();
    const double step = 2 * std::acos(std::max(0.0, 1 - kSagitta / radius));
    return std::max(1, static_cast<int>(std::ceil(arc.sweep / step)));
}

Vec3 arc_point_at(const path::Arc& arc, double part) {
    return part == 1 ? arc.end : path::point_at(arc, arc.sweep * part).position;
}

}  // namespace

void Motions::thread_along_arc(const Block& block, const Target& target, const Actions& actions) {
    const std::optional<path::Arc> arc = arc_of_thread(block, target);
    if (!arc) return;
    const std::optional<ThreadPitch> pitch = pitch_of_arc(block, arc->end - arc->start);
    if (!pitch) return;
    if (!require_thread_spindle(block)) return;
    channel_.cornering.leave_corners(diag::CornerNotContour);
    if (reporter_.has_ended()) return;
    channel_.checks.check_tool(block);
    if (tool_.has_changed) channel_.tool.activate_length(block, target.moved);
    const int lines = lines_of(*arc);
    const double whole = arc->end[pitch->axis] - arc->start[pitch->axis];
    // The whole arc is looked at before the first of its lines is put out.
    for (int i = 1; i <= lines; ++i) {
        const Vec3 delta = arc_point_at(*arc, static_cast<double>(i) / lines) -
                           arc_point_at(*arc, static_cast<double>(i - 1) / lines);
        if (delta[pitch->axis] * whole > 0 &&
            std::abs(delta[pitch->axis]) > kLeastPart * delta.norm())
            continue;
        reporter_.report(diag::ThreadArcAcross, block)
            .arg(kAxisNames[static_cast<std::size_t>(pitch->axis)]);
        return;
    }
    const Target begin{position_.here(), position_.base(), target.moved};
    for (int i = 1; i <= lines && !reporter_.has_ended(); ++i) {
        const double part = static_cast<double>(i) / lines;
        Target at = target;
        if (i < lines) {
            const Vec3 point = arc_point_at(*arc, part);
            for (std::size_t k = 0; k < kAxes; ++k) {
                at.here[k] = k < 3 ? point[static_cast<Eigen::Index>(k)]
                                   : begin.here[k] + part * (target.here[k] - begin.here[k]);
            }
            at.base = frames_.to_base(at.here);
        }
        if (!channel_.checks.require_within_limits(block, at.base, at.moved)) return;
        position_.note_motion();
        const Vec3 delta = linear(at.here) - linear(position_.here());
        const double length = (linear(at.base) - linear(position_.base())).norm();
        path::Motion& motion =
            channel_.stages.put(Op::Thread, block, i == 1 ? &target.orientation : nullptr).motion();
        motion.to = at.base;
        motion.moved = at.moved;
        motion.exact_stop = i == lines && channel_.smoothing.stops_exactly(actions.exact_stop);
        motion.feed_mode = path::FeedMode::PerRevolution;
        motion.feed = pitch->pitch * length / std::abs(delta[pitch->axis]);
        motion.shape = path::ThreadShape{0, actions.thread_start_deg};
        arrive(at);
    }
}

/// The arc of the block in the programmed system; nothing if it was reported. Where the words of
/// the centre are the pitch, the radius or the opening decides which arc it is.
std::optional<path::Arc> Motions::arc_of_thread(const Block& block, const Target& target) {
    Block words = block;
    if (!rules_.thread_pitch_is_feed) words.given &= ~SlotMask{nc::kCenterSlots};
    const bool has_form =
        (words.given & (nc::kCenterSlots | bit(Slot::Radius) | bit(Slot::Opening))) != 0;
    if (!has_form) {
        reporter_.report(diag::ThreadArcForm, block)
            .arg(rules_.thread_pitch_is_feed ? "centre or radius" : "radius or angle");
        return std::nullopt;
    }
    MotionView as_arc = motion_view();
    as_arc.motion = modal_.motion == Function::ThreadArcCw ? Function::ArcCw : Function::ArcCcw;
    MotionWords of_arc{as_arc, reporter_};
    Target end = target;
    return words.has(Slot::Opening) ? of_arc.arc_by_opening(words, end)
                                    : of_arc.resolve_arc(words, target);
}

/// Along which axis the pitch is, and how large; nothing if it was reported.
std::optional<ThreadPitch> Motions::pitch_of_arc(const Block& block, const Vec3& delta) {
    Eigen::Index longest = 0;
    delta.cwiseAbs().maxCoeff(&longest);
    const std::string_view name = kAxisNames[static_cast<std::size_t>(longest)];
    if (rules_.thread_pitch_is_feed) {
        if (modal_.has_feed && modal_.feed > 0) return ThreadPitch{modal_.feed, longest};
        reporter_.report(diag::ThreadPitchMissing, block).arg(name);
        return std::nullopt;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto word = static_cast<Slot>(static_cast<std::size_t>(Slot::CenterX) + axis);
        if (block.has(word) && block.at(word) > 0)
            return ThreadPitch{block.at(word), static_cast<Eigen::Index>(axis)};
    }
    reporter_.report(diag::ThreadPitchMissing, block).arg(name);
    return std::nullopt;
}

}  // namespace kadr::interp
