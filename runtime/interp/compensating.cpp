// compensating.cpp — what switches the cutter radius compensation, and what passes through it.
#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "base/diagnostics/doubtful.h"
#include "base/diagnostics/iso.h"
#include "base/diagnostics/orienting.h"
#include "base/units.h"
#include "interp/block_words.h"
#include "interp/carriers.h"
#include "interp/channel.h"
#include "interp/cycle_shapes.h"
#include "interp/danger_watch.h"
#include "interp/motion_checks.h"
#include "interp/radius_compensation.h"
#include "interp/stages.h"
#include "interp/tool_in_use.h"
#include "interp/tool_motion.h"
#include "interp/transformation.h"
#include "machine/kinematics.h"
#include "nc/tables.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;

namespace {

constexpr double kSameLie = 1e-9;          // of planes: the rounding of frames
constexpr std::size_t kCheckedBlocks = 3;  // MD20240 CUTCOM_MAXNUM_CHECK_BLOCKS

/// Where the tip lies, seen from the centre of the nose, in Z and X.
path::Vec2 tip_direction(int tip) {
    static constexpr std::array<double, 10> kZ = {0, 1, -1, -1, 1, 1, 0, -1, 0, 0};
    static constexpr std::array<double, 10> kX = {0, 1, 1, -1, -1, 0, 1, 0, -1, 0};
    return {kZ[static_cast<std::size_t>(tip)], kX[static_cast<std::size_t>(tip)]};
}

}  // namespace

RadiusCompensation::RadiusCompensation(Channel& channel)
    : channel_(channel),
      dialect_(channel.state.dialect),
      machine_(channel.state.machine),
      is_lathe_(channel.state.is_lathe),
      tool_offsets_(channel.state.tool.tool_offsets),
      reporter_(channel.state.reporter),
      rules_(channel.state.rules),
      output_(channel.state.stage.output),
      modal_(channel.state.motion.modal),
      position_(channel.state.motion.position),
      frames_(channel.state.frame.frames),
      tool_(channel.state.tool.tool),
      extra_(channel.state.tool.extra),
      orienting_(channel.state.tool.orienting),
      tilted_plane_(channel.state.tool.tilted_plane),
      surface_(channel.state.stage.surface),
      corners_(channel.state.stage.corners),
      comp_(channel.state.stage.comp),
      compensation_(channel.state.stage.compensation),
      comp_3d_(channel.state.stage.comp_3d),
      reported_(channel.state.reported) {}

void RadiusCompensation::choose(const Block& block, Function member, Actions& actions) {
    if (channel_.shapes.keeps_shape()) return;
    actions.comp_changed = true;
    switch (nc::group_of(member)) {
        case nc::Group::RadiusComp: choose_comp_side(block, member, actions); break;
        case nc::Group::CompStart: comp_.start = comp_start_of(member); break;
        case nc::Group::CompCorner: comp_.corner = comp_corner_of(member); break;
        case nc::Group::CompCheck: comp_.has_check = member == Function::CompCheckOn; break;
        case nc::Group::CompOrientation:
            comp_.orients_on_arc = member == Function::CompOrientOnArc;
            break;
        case nc::Group::CompKind:
            comp_.system = comp_system_of(member);
            if (comp_.system == CompKind::InPlane)
                comp_.is_in_frame = member == Function::CompInFrame;
            break;
        default: break;  // no other is sent here
    }
}

void RadiusCompensation::choose_feed(const Block& block, const Invocation& invocation,
                                     Actions& actions) {
    comp_.feed = std::clamp<std::int64_t>(
        count_of(block, invocation, nc::parameter_of<Function::CompFeed>("kind")), 0, 2);
    actions.comp_changed |= comp_.is_on();
}

void RadiusCompensation::choose_by_words(const Block& block, const Invocation& invocation,
                                         Actions& actions) {
    if (channel_.shapes.keeps_shape()) return;
    actions.comp_changed = true;
    switch (invocation.function) {
        case Function::CompCornerPointed: choose_pointed_corners(block, invocation); break;
        case Function::CompOpenEnd:
            comp_.open_end = static_cast<path::OpenEnd>(std::clamp<std::int64_t>(
                count_of(block, invocation, nc::parameter_of<Function::CompOpenEnd>("kind")), 0,
                2));
            break;
        case Function::CompAllowance:
            comp_.allowance =
                block.argument(invocation, nc::parameter_of<Function::CompAllowance>("allowance"));
            break;
        case Function::CompDepth:
            comp_.depth =
                block.argument(invocation, nc::parameter_of<Function::CompDepth>("depth"));
            break;
        default: break;  // no other is sent here
    }
}

void RadiusCompensation::choose_pointed_corners(const Block& block, const Invocation& invocation) {
    comp_.pointed =
        block.argument(invocation, parameter_of<Function::CompCornerPointed>("percent"));
    if (comp_.pointed < 0 || comp_.pointed > 100)
        reporter_.report(diag::CompPointedRange, block, invocation.function).arg(comp_.pointed);
}

/// function  of the group RadiusComp
void RadiusCompensation::choose_comp_side(const Block& block, Function function, Actions& actions) {
    const CompSide side = comp_side_of(function);
    if (side != CompSide::Off) {
        const bool is_peripheral_code = !nc::has_fact(function, nc::Fact::CompSide);
        if (is_peripheral_code && !require_tcp_for_peripheral_comp(block, function)) return;
        comp_.is_peripheral_code = is_peripheral_code;
    }
    actions.radius_comp = side;
}

void RadiusCompensation::act_on_comp(const Block& block, const Actions& actions) {
    if (actions.radius_comp == CompSide::Off) {
        comp_.side = CompSide::Off;
        if (actions.smooth_approach != nullptr) return;  // its path still belongs to the contour
        CompChange leave;
        leave.kind = CompChange::Kind::Leave;
        leave.settings.corners.open_end = comp_.open_end;
        leave.plane = modal_.plane;
        leave.here = position_.base();
        leave.direction = leave_direction(block);
        send_comp(leave);
        return;
    }
    // A surface has one side: there both words are the same.
    const bool is_other_side = actions.radius_comp != comp_.side && !comp_.is_face_milling_acting();
    if (actions.radius_comp && is_other_side) {
        begin_comp(block, *actions.radius_comp);
        return;
    }
    if (!comp_.is_on()) return;
    const bool is_again = actions.radius_comp && rules_.comp_again_on_normal;
    if (is_again && comp_.acting == CompKind::InPlane)
        send_comp({CompChange::Kind::Again, {}, modal_.plane, 0, position_.base(), {}, {}});
    if (reporter_.has_ended()) return;
    const CompChange change = comp_change(block, CompChange::Kind::Set);
    if (!reporter_.has_ended()) send_comp(change);
}

/// A direction of the programmed system as one in the plane of the base system; none: it has no
/// length there.
std::optional<path::Vec2> RadiusCompensation::direction_in_base(
    const path::Vec3& programmed) const {
    const path::Vec3 base =
        channel_.compensation.comp_lie().transpose() * frames_.total().direction(programmed);
    const path::PlaneAxes axes = path::axes_of(modal_.plane);
    const path::Vec2 direction{base[static_cast<Eigen::Index>(index(axes.first))],
                               base[static_cast<Eigen::Index>(index(axes.second))]};
    if (direction.norm() < path::kSamePoint) return std::nullopt;
    return direction.normalized();
}

std::optional<path::Vec2> RadiusCompensation::leave_direction(const Block& block) const {
    if (!rules_.comp_end_by_center || block.find(Function::RadiusCompOff) == nullptr)
        return std::nullopt;
    path::Vec3 direction = path::Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
        const auto slot = static_cast<nc::Slot>(static_cast<std::size_t>(nc::Slot::CenterX) + i);
        if (block.has(slot)) direction[static_cast<Eigen::Index>(i)] = block.at(slot);
    }
    return direction_in_base(direction);
}

void RadiusCompensation::round_comp_corner(const Block& block, const Invocation& invocation) {
    if ((block.given & nc::kTargetSlots) != 0) {
        reporter_.report(diag::CompCornerMoves, block, invocation.function);
        return;
    }
    if (!channel_.checks.require_feed(block, "arc")) return;
    path::Vec3 direction = path::Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
        direction[static_cast<Eigen::Index>(i)] =
            block.argument(invocation, parameter_of<Function::CompCornerHere>("x") + i);
    }
    CompChange change{CompChange::Kind::RoundCorner, {}, modal_.plane, 0, position_.base(),
                      direction_in_base(direction),  {}};
    change.motion.become(path::Op::Arc);
    change.motion.source = block.source;
    change.motion.line = block.line;
    path::Motion& motion = change.motion.motion();
    motion.feed_mode = modal_.feed_mode;
    motion.plane = modal_.plane;
    motion.feed = modal_.feed;
    send_comp(change);
}

void RadiusCompensation::send_comp(const CompChange& change) {
    if (corners_.is_active()) return corners_.change(change);
    change_comp(change);
}

void RadiusCompensation::change_comp(const CompChange& change) {
    if (comp_3d_.is_on() || change.space) return change_comp_3d(change);
    switch (change.kind) {
        case CompChange::Kind::Leave:
            compensation_.leave(change.direction, change.settings.corners.open_end);
            break;
        case CompChange::Kind::KeepVector: compensation_.keep_vector(); break;
        case CompChange::Kind::Pause: take_comp(compensation_.pause()); break;
        case CompChange::Kind::Resume: compensation_.resume(); break;
        case CompChange::Kind::LetGo: take_comp(compensation_.let_go()); break;
        case CompChange::Kind::Again: take_comp(compensation_.begin_again()); break;
        case CompChange::Kind::RoundCorner:
            take_comp(compensation_.round_corner(change.motion, change.direction));
            break;
        case CompChange::Kind::Set:
            compensation_.set_settings(change.settings);
            compensation_.set_distance(change.distance);
            compensation_.set_aside(change.aside);
            break;
        case CompChange::Kind::Begin:
            // From one side to the other: the contour so far ends on its normal.
            if (compensation_.is_on()) flush_comp();
            if (reporter_.has_ended()) return;
            compensation_.begin(change.settings, change.plane, change.distance, change.here);
            compensation_.set_aside(change.aside);
            break;
    }
}

Done RadiusCompensation::require_comp_in_plane(const Block& block, Function function) {
    if (!comp_3d_.is_on()) return kDone;
    reporter_.report(diag::IsoNotSupported, block, function)
        .arg(reporter_.word_of(block, function) + " beside a contour in space");
    return kFailed;
}

/// What can be programmed of it in 3D; the rest is of the working plane.
void RadiusCompensation::change_comp_3d(const CompChange& change) {
    switch (change.kind) {
        case CompChange::Kind::Leave: comp_3d_.leave(); break;
        case CompChange::Kind::Set:
            if (change.space) comp_3d_.set_settings(*change.space);
            break;
        case CompChange::Kind::Begin:
            // From one side to the other, or from the plane: the contour so far ends here.
            if (is_any_comp_on()) flush_comp();
            if (reporter_.has_ended()) return;
            if (!change.space) {
                stop_comp();
                if (!reporter_.has_ended()) change_comp(change);
                return;
            }
            comp_3d_.begin(*change.space, change.here);
            break;
        case CompChange::Kind::KeepVector:
        case CompChange::Kind::RoundCorner:
        case CompChange::Kind::Pause:
        case CompChange::Kind::Resume:
        case CompChange::Kind::LetGo:
        case CompChange::Kind::Again: break;  // refused before: require_comp_in_plane()
    }
}

/// Of the tool, from tip to holder: as the transformation has it, else square to the plane; or as
/// is programmed to stay.
path::Vec3 RadiusCompensation::tool_direction() const {
    if (orienting_.is_on)
        return machine::tool_vector(machine_.kinematics->chain,
                                    channel_.transformation.joints_of(position_.base()));
    if (comp_.acting == CompKind::FaceMillingInPlane)
        return path::unit(path::axes_of(modal_.plane).normal);
    if (comp_.acting == CompKind::FaceMillingInFrame)
        return frames_.total().direction(path::Vec3::UnitZ()).normalized();
    return frames_.total().direction(path::unit(path::axes_of(modal_.plane).normal)).normalized();
}

Comp3dSettings RadiusCompensation::comp_3d_settings() const {
    Comp3dSettings settings;
    if (orienting_.is_on)
        settings.orientation_limits = {&machine_.kinematics->chain,
                                       channel_.tool_motion.joint_limits()};
    settings.direction = tool_direction();
    settings.cutter.contact.kind = path::ContactKind::Flank;
    settings.cutter.contact.depth = comp_.depth;
    settings.extends_lines = comp_settings().corners.outside == path::OutsideCorner::Intersection;
    settings.limit = rad_from_deg(rules_.comp_corner_limit);
    settings.orients_on_arc = comp_.orients_on_arc;
    settings.takes_inverse_time = rules_.comp_takes_inverse_time;
    settings.empty_blocks = rules_.comp_empty_blocks;
    return settings;
}

void RadiusCompensation::begin_comp(const Block& block, CompSide side) {
    comp_.side = side;
    if (!comp_offset()) {
        reporter_.report(diag::CompWithoutTool, block, function_of(comp_.side));
        return;
    }
    const bool has_number =
        tool_.radius_offset != 0 || block.find(Function::RadiusOffset) != nullptr;
    // A lathe's T calls it with the tool.
    const bool has_word =
        !dialect_.tables().forms_of[static_cast<std::size_t>(Function::RadiusOffset)].empty();
    if (rules_.comp_radius_by_offset && !has_number && (has_word || is_lathe_)) {
        DiagnosticBuilder message =
            reporter_.report(diag::CompWithoutOffset, block, function_of(comp_.side));
        message.arg(reporter_.word_of(block, function_of(comp_.side))).arg(has_word ? "D" : "T");
        if (const Invocation* const length = block.find(Function::LengthOffset)) {
            const std::string number = std::to_string(std::llround(
                block.argument(*length, parameter_of<Function::LengthOffset>("offset"))));
            message.fix("`D" + number + "` calls the radius; `H` does where No.5001#2 is set");
        }
    }
    comp_.acting = comp_.chosen();
    comp_.is_mirrored = frames_.is_mirrored(modal_.plane);
    const bool is_of_tool = comp_.acting == CompKind::InPlane && !comp_.is_in_frame;
    if (is_of_tool && channel_.carriers.is_turned_by_carrier() &&
        !channel_.carriers.is_plane_on_carrier()) {
        reporter_.report(diag::CarrierPlane, block, function_of(comp_.side));
        return;
    }
    if (comp_.acting != CompKind::InPlane && comp_settings().start == nc::CompStart::Around) {
        reporter_.report(diag::CompSpaceStart, block, function_of(comp_.side));
        return;
    }
    if (!require_constant_tool(block)) return;
    CompChange change = comp_change(block, CompChange::Kind::Begin);
    if (!reporter_.has_ended()) send_comp(change);
}

CompChange RadiusCompensation::comp_change(const Block& block, CompChange::Kind kind) {
    CompChange change;
    change.kind = kind;
    change.settings = comp_settings();
    change.plane = modal_.plane;
    change.here = position_.base();
    take_comp_tool(block, comp_offset().value_or(0), change);
    if (is_in_space(kind)) {
        change.space = comp_3d_settings();
        change.space->cutter.contact.radius = -change.distance;
        if (const auto cutter = mill_shape_now(block)) change.space->cutter = *cutter;
    }
    return change;
}

/// What is chosen counts where the compensation begins.
bool RadiusCompensation::is_in_space(CompChange::Kind kind) const {
    return kind == CompChange::Kind::Begin ? comp_.acting != CompKind::InPlane : comp_3d_.is_on();
}

static path::OutsideCorner corner_of(nc::CompCorner corner) {
    switch (corner) {
        case nc::CompCorner::Arc: return path::OutsideCorner::Arc;
        case nc::CompCorner::Intersection: return path::OutsideCorner::Intersection;
        case nc::CompCorner::Square: return path::OutsideCorner::Square;
    }
    return path::OutsideCorner::Arc;
}

CompSettings RadiusCompensation::comp_settings() const {
    CompSettings settings;
    path::CompRules& corners = settings.corners;
    corners.outside = corner_of(comp_.corner.value_or(rules_.comp_corner));
    corners.pointed = std::min(comp_.pointed, rules_.comp_pointed_limit) / 100;
    corners.limit = rad_from_deg(rules_.comp_corner_limit);
    corners.sharp = corner_of(rules_.comp_sharp_corner);
    corners.extends_tangents = rules_.comp_extends_tangents;
    corners.leaves_out = comp_.has_check;
    corners.open_end = comp_.open_end;
    corners.look_ahead = comp_.has_check
                             ? kCheckedBlocks
                             : static_cast<std::size_t>(std::max(1, rules_.comp_look_ahead));
    settings.start = comp_.start.value_or(rules_.comp_start);
    settings.feed = comp_.feed ? static_cast<nc::CompFeed>(*comp_.feed) : rules_.comp_feed;
    settings.radius_changes_in_lines = rules_.comp_keeps_tool;
    settings.takes_inverse_time = rules_.comp_takes_inverse_time;
    settings.empty_blocks = rules_.comp_empty_blocks;
    settings.more_empty_is_fault = rules_.comp_more_empty_is_alarm;
    if (orienting_.is_on)
        settings.orientation_limits = {&machine_.kinematics->chain,
                                       channel_.tool_motion.joint_limits()};
    settings.lie = comp_lie();
    return settings;
}

path::Mat3 RadiusCompensation::comp_lie() const {
    const bool is_in_base = rules_.comp_in_base_plane && !tilted_plane_.is_on &&
                            !comp_.is_in_frame && !channel_.carriers.is_turned_by_carrier();
    return is_in_base ? path::Mat3::Identity() : plane_lie();
}

path::Mat3 RadiusCompensation::plane_lie() const {
    if (!frames_.is_plane_tilted(modal_.plane)) return path::Mat3::Identity();
    const path::PlaneAxes axes = path::axes_of(modal_.plane);
    const path::Frame& frame = frames_.total();
    const path::Vec3 first = frame.direction(path::unit(axes.first)).normalized();
    const path::Vec3 second = frame.direction(path::unit(axes.second));
    const path::Vec3 normal = first.cross(second).normalized();
    path::Mat3 lie;
    lie.col(static_cast<Eigen::Index>(index(axes.first))) = first;
    lie.col(static_cast<Eigen::Index>(index(axes.second))) = normal.cross(first);
    lie.col(static_cast<Eigen::Index>(index(axes.normal))) = normal;
    return lie;
}

/// Number of the offset whose radius acts, 0 for none; nothing: no edge of a tool acts.
std::optional<std::int64_t> RadiusCompensation::comp_offset() const {
    if (rules_.comp_radius_by_offset || tool_.radius_offset != 0) return tool_.radius_offset;
    if (tool_.source == Tool::Source::None || tool_.current == 0) return std::nullopt;
    return tool_.edge_number();
}

/// How far beside the contour the cutter's centre goes, positive to the left: a frame that mirrors
/// the plane changes the side. A lathe's tool is programmed by its tip.
void RadiusCompensation::take_comp_tool(const Block& block, std::int64_t number,
                                        CompChange& change) {
    const double radius =
        tool_offsets_.radius(number) + extra_.radius + channel_.tool.sum_offset(4);
    channel_.dangers.watch_radius(block, number);
    const int tip = tool_offsets_.tip(number);
    const bool is_turned = tool_offsets_.is_turning(number) && modal_.plane == path::Plane::Zx;
    const bool has_no_tip = is_turned && radius != 0 && tip == 0;
    const bool is_gap = (radius == 0 || has_no_tip) && number != 0;
    if (is_gap && reported_.first_time(NoticeEach::Radius, number)) {
        reporter_
            .report(has_no_tip ? diag::CompTipUnknown : diag::CompRadiusUnknown, block,
                    function_of(comp_.side))
            .arg(ToolOffsets::tool_of(number));
    }
    const bool is_left =
        (comp_.side == CompSide::Left) !=
        (change.settings.lie == path::Mat3::Identity() && frames_.is_mirrored(modal_.plane));
    change.distance = (radius + comp_.allowance) * (is_left ? 1 : -1);
    if (is_turned) change.aside = radius * tip_direction(tip);
}

void RadiusCompensation::settle_comp(const Block& block, const AxisValues& here, bool is_last) {
    std::optional<CompAlarm> alarm;
    if (comp_3d_.is_on()) {
        if (!reporter_.has_alarm()) alarm = comp_3d_.end_block(block);
        if (!reporter_.has_alarm() && !alarm && reporter_.has_ended() && is_last)
            alarm = comp_3d_.flush();
        return take_comp(alarm);
    }
    const bool is_same_plane =
        modal_.plane == compensation_.plane() && compensation_.lie().isApprox(comp_lie(), kSameLie);
    if (!reporter_.has_alarm() && !is_same_plane) reporter_.report(diag::CompPlane, block);
    if (!reporter_.has_alarm()) alarm = compensation_.end_block(here, block);
    if (!reporter_.has_alarm() && !alarm && reporter_.has_ended() && is_last)
        alarm = compensation_.flush();
    take_comp(alarm);
    // A frame that mirrors the plane from here on changes the side, as the other word would.
    const bool goes_on = !reporter_.has_ended() && comp_.is_on() && is_same_plane;
    if (goes_on && frames_.is_mirrored(modal_.plane) != comp_.is_mirrored)
        begin_comp(block, comp_.side);
}

void RadiusCompensation::flush_comp() {
    take_comp(comp_3d_.is_on() ? comp_3d_.flush() : compensation_.flush());
}

void RadiusCompensation::stop_comp() {
    take_comp(comp_3d_.is_on() ? comp_3d_.stop() : compensation_.stop());
}

/// What the compensation has settled goes out.
void RadiusCompensation::take_comp(const std::optional<CompAlarm>& alarm) {
    for (auto* settled : {&compensation_.settled(), &comp_3d_.settled()}) {
        for (path::Command& command : *settled) output_.next() = std::move(command);
        settled->clear();
    }
    if (alarm) report_comp(*alarm);
}

void RadiusCompensation::report_comp(const CompAlarm& alarm) {
    const Block at = channel_.stages.block_at(alarm.source, alarm.line);
    reporter_.report(*alarm.row, at);
}

bool RadiusCompensation::needs_comp_off(const Block& block, Function function) const {
    const bool acts = comp_.is_on() && block.find(Function::RadiusCompOff) == nullptr;
    if (!rules_.comp_is_innermost || !acts || block.is_of_cycle()) return false;
    if (nc::has_fact(function, nc::Fact::NeedsCompOff)) return true;
    // It begins anew behind, which it can in a plane alone.
    return nc::has_fact(function, nc::Fact::TakesCompBack) && comp_.acting != CompKind::InPlane;
}

}  // namespace kadr::interp
