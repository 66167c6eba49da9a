// functions.cpp — what each function of a block does to the state of the control.
#include <algorithm>
#include <cmath>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "interp/block_functions.h"
#include "interp/block_words.h"
#include "interp/carriers.h"
#include "interp/channel.h"
#include "interp/cornering.h"
#include "interp/cycle_shapes.h"
#include "interp/cycles.h"
#include "interp/danger_watch.h"
#include "interp/feed_words.h"
#include "interp/motion_checks.h"
#include "interp/motions.h"
#include "interp/path_smoothing.h"
#include "interp/programmed_frames.h"
#include "interp/radius_compensation.h"
#include "interp/spindles.h"
#include "interp/splines.h"
#include "interp/stages.h"
#include "interp/tilted_planes.h"
#include "interp/tool_in_use.h"
#include "interp/tool_motion.h"
#include "interp/transformation.h"
#include "interp/virtual_plane.h"
#include "nc/parameters.h"

namespace kadr::interp {

using control::Frames;
using nc::Block;
using nc::Function;
using nc::Group;
using nc::Invocation;
using nc::parameter_of;
using nc::Slot;
using path::Command;
using path::FeedMode;
using path::Op;
using path::Plane;
using path::SpindleMode;

BlockFunctions::BlockFunctions(Channel& channel)
    : channel_(channel),
      dialect_(channel.state.dialect),
      machine_(channel.state.machine),
      is_lathe_(channel.state.is_lathe),
      options_(channel.state.options),
      reporter_(channel.state.reporter),
      rules_(channel.state.rules),
      modal_(channel.state.motion.modal),
      position_(channel.state.motion.position),
      frames_(channel.state.frame.frames),
      spindle_(channel.state.spindle.spindle),
      other_spindles_(channel.state.spindle.other_spindles),
      tool_(channel.state.tool.tool),
      area_(channel.state.stage.area),
      position_words_(channel.state.motion.position_words),
      orienting_(channel.state.tool.orienting),
      tilted_plane_(channel.state.tool.tilted_plane),
      diameter_is_absolute_(channel.state.motion.diameter_is_absolute),
      comp_(channel.state.stage.comp),
      approach_choice_(channel.state.stage.approach_choice),
      smooth_approach_(channel.state.stage.smooth_approach),
      coolant_(channel.state.spindle.coolant),
      is_scanning_(channel.state.motion.is_scanning),
      taps_rigidly_(channel.state.cycle.taps_rigidly),
      dynamics_(channel.state.motion.dynamics),
      reported_(channel.state.reported),
      axes_(channel.state.axes),
      modal_cycles_(channel.state.cycle.modal_cycles) {}

Actions BlockFunctions::apply_functions(const Block& block) {
    Actions actions;
    std::uint8_t asked = nc::Effect::kMotionCode;  // the function that was looked at last …
    bool is_allowed = false;                       // … and whether it may stand here
    for (const nc::Effect& effect : nc::effects_of(rules_, block, changer())) {
        if (reporter_.has_ended()) break;
        if (effect.invocation != asked)
            is_allowed = static_cast<bool>(require_allowed(block, effect.function));
        asked = effect.invocation;
        // The motion code acts in motion.cpp.
        if (is_allowed && asked != nc::Effect::kMotionCode) apply(block, effect, actions);
    }
    return actions;
}

/// Whether the function would change, inside a rotation, what the control fixes before it.
bool BlockFunctions::is_too_late(Function function) const {
    if (!rules_.rotation_is_innermost) return false;
    if (tilted_plane_.is_on && nc::has_fact(function, nc::Fact::BeforeTiltedPlane)) return true;
    if (nc::has_fact(function, nc::Fact::Mirrors) && frames_.is_scaled()) return true;
    if (!frames_.is_rotated()) return false;
    return nc::has_fact(function, nc::Fact::BeforeRotation) || is_other_plane(function);
}

bool BlockFunctions::is_other_plane(Function function) const {
    return nc::info(function).group == Group::Plane && plane_of(function) != modal_.plane;
}

/// Refuses a function that cannot stand where it does.
Done BlockFunctions::require_allowed(const Block& block, Function function) {
    if (channel_.compensation.needs_comp_off(block, function)) {
        reporter_.report(diag::CompFrame, block, function).arg(reporter_.word_of(block, function));
        return kFailed;
    }
    if (taps_rigidly_ && !block.is_of_cycle() && is_other_plane(function)) {
        reporter_.report(diag::TapPlane, block, function);
        return kFailed;
    }
    if (is_too_late(function)) {
        reporter_.report(diag::FrameInsideRotation, block, function)
            .arg(reporter_.word_of(block, function))
            .arg(frames_.is_rotated() || tilted_plane_.is_on ? "rotation" : "scaling");
        return kFailed;
    }
    if (!orienting_.has_length) return kDone;
    return channel_.transformation.require_allowed_under_tcp(block, function);
}

/// What an effect does, or that the block asks for it later.
void BlockFunctions::apply(const Block& block, const nc::Effect& effect, Actions& actions) {
    using Kind = nc::EffectKind;
    const Invocation& invocation = effect.invocation_in(block);
    switch (effect.kind) {
        case Kind::Sets: set_member(block, effect, actions); break;
        case Kind::Shift: channel_.frames.change_frame(block, invocation, &Frames::shift); break;
        case Kind::ShiftAdd:
            channel_.frames.change_frame(block, invocation, &Frames::shift_add);
            break;
        case Kind::Rotate: channel_.frames.rotate(block, invocation); break;
        case Kind::Scale: channel_.frames.scale(block, invocation); break;
        case Kind::Mirror: channel_.frames.change_frame(block, invocation, &Frames::mirror); break;
        case Kind::RotateOff: channel_.frames.end_rotation(); break;
        case Kind::ScaleOff: channel_.frames.end_scaling(); break;
        case Kind::MirrorOff: channel_.frames.end_mirroring(block, invocation); break;
        case Kind::SetPosition: channel_.frames.set_position(block, invocation); break;
        case Kind::WorkOffset:
            channel_.frames.select_work_offset(
                block, count_of(block, invocation, parameter_of<Function::WorkOffset>("number")));
            channel_.transformation.offset_is_given();
            break;
        case Kind::WritesWorkOffset: actions.data = &invocation; break;
        case Kind::CorrectsWorkOffset: channel_.motions.use_probed(block, invocation); break;
        case Kind::EndsTiltedPlane: channel_.tilted_planes.end_tilted_plane(block); break;
        case Kind::SwitchesTcp: switch_tcp(block, invocation, actions); break;
        case Kind::SelectsTool: channel_.tool.select_tool(block, invocation, actions); break;
        case Kind::ChangesTool: actions.tool_change = true; break;
        case Kind::SelectsEdge: channel_.tool.select_edge(block, invocation, actions); break;
        case Kind::ChangesLength: channel_.tool.change_length(block, invocation, actions); break;
        case Kind::SelectsLength:
            channel_.tool.choose_offset(
                count_of(block, invocation, parameter_of<Function::LengthOffset>("offset")));
            if (tool_.source == Tool::Source::Offset)
                channel_.tool.set_length_source(Tool::Source::Offset, actions);
            break;
        case Kind::SelectsRadius:
            if (channel_.shapes.keeps_shape()) break;
            actions.comp_changed = true;
            channel_.tool.choose_radius_offset(
                count_of(block, invocation, parameter_of<Function::RadiusOffset>("offset")));
            break;
        case Kind::EndsProgram: actions.ends = true; break;
        case Kind::Own: apply_own(block, invocation, actions); break;
        case Kind::TurnsSpindle:
        case Kind::Tilts:
        case Kind::TurnsAxes:
        case Kind::TurnsSystem:
        case Kind::WritesLength:
        case Kind::LeavesWords:
        case Kind::GoesToPoint:
        case Kind::RunsCycle: break;  // how, its own part decides: the position stays known
    }
}

/// Another member of a modal group acts.
void BlockFunctions::set_member(const Block& block, const nc::Effect& effect, Actions& actions) {
    const Function member = effect.function;
    switch (effect.group()) {
        case Group::Motion: break;  // the motion code acts in motion.cpp
        case Group::Distance: modal_.is_incremental = member == Function::Incremental; break;
        case Group::PathMode: modal_.set_path_mode(member); break;
        case Group::Plane: change_plane(block, member); break;
        case Group::Units:
            channel_.checks.check_units(block, member);
            break;  // the reader has made mm of lengths
        case Group::FeedMode: channel_.feed.select_feed_mode(member); break;
        case Group::SpeedMode:
            if (member == Function::CuttingSpeedOn) spindle_.has_cutting_speed = true;
            else channel_.spindles.leave_cutting_speed();
            break;
        case Group::RadiusComp:
        case Group::CompStart:
        case Group::CompCorner:
        case Group::CompCheck:
        case Group::CompKind:
        case Group::CompOrientation: channel_.compensation.choose(block, member, actions); break;
        case Group::Spindle:
            if (member == Function::SpindleOrient) break;
            actions.stops_behind |= effect.when == nc::When::Behind;
            actions.spindle = member == Function::SpindleCw    ? SpindleMode::Cw
                              : member == Function::SpindleCcw ? SpindleMode::Ccw
                                                               : SpindleMode::Stop;
            break;
        case Group::Coolant:
            actions.stops_behind |= effect.when == nc::When::Behind;
            actions.flood |= member == Function::CoolantFlood;
            actions.mist |= member == Function::CoolantMist;
            actions.coolant_off |= member == Function::CoolantOff;
            break;
        case Group::CycleReturn:
            channel_.cycles.return_to_retract(member == Function::CycleReturnRetract);
            break;
        case Group::Diameter: set_diameter(block, member); break;
        case Group::Compressor:
            channel_.smoothing.choose_smoothing(block, effect.invocation_in(block));
            break;
        case Group::OrientInterpolation:
        case Group::OrientAngles:
        case Group::OrientSystem:
        case Group::Spinning: channel_.transformation.choose(member); break;
        case Group::NonModal:
        case Group::LengthComp:
        case Group::WorkOffsets:
        case Group::CycleMode:
        case Group::Transformation:
        case Group::DataInput: break;  // the other effects of these functions do it
    }
}

void BlockFunctions::set_diameter(const Block& block, Function member) {
    axes_.count_x_as(member == Function::DiameterOff ? 1 : 0.5);
    diameter_is_absolute_ = member == Function::DiameterAbsolute;
    if (member != Function::DiameterOff) channel_.dangers.watch_diameter(block, member);
}

void BlockFunctions::switch_tcp(const Block& block, const Invocation& invocation,
                                Actions& actions) {
    const Function function = invocation.function;
    if (nc::info(function).group == Group::LengthComp)
        return channel_.transformation.begin_length_transformation(block, invocation, actions);
    if (function == Function::TcpBased &&
        !channel_.transformation.require_transformation(block, invocation))
        return;
    if (!channel_.carriers.require_no_carrier(block, function)) return;
    if (nc::has_fact(function, nc::Fact::VirtualAxes))
        return channel_.virtual_plane.begin_virtual(block, invocation);
    channel_.virtual_plane.end_virtual(block);
    if (!reporter_.has_ended()) channel_.transformation.switch_transformation(block, invocation);
}

/// What of a function only the interpreter knows.
void BlockFunctions::apply_own(const Block& block, const Invocation& invocation, Actions& actions) {
    switch (invocation.function) {
        case Function::SpeedLimit: actions.limit = &invocation; break;
        case Function::CompCornerPointed:
        case Function::CompOpenEnd:
        case Function::CompAllowance:
        case Function::CompDepth:
            channel_.compensation.choose_by_words(block, invocation, actions);
            break;
        case Function::CompKeepVector:
        case Function::CompCornerHere:
            if (!comp_.is_on()) {
                reporter_.report(diag::CompNoVector, block, invocation.function);
                return;
            }
            if (!channel_.compensation.require_comp_in_plane(block, invocation.function)) return;
            actions.keeps_vector |= invocation.function == Function::CompKeepVector;
            if (invocation.function == Function::CompCornerHere) actions.comp_corner = &invocation;
            break;
        case Function::SmoothApproach:
        case Function::SmoothRetract:
            if (actions.smooth_approach != nullptr || smooth_approach_.is_active()) {
                reporter_.report(diag::SoftTwice, block, invocation.function);
                return;
            }
            if (is_lathe_) {
                reporter_.report(diag::IsoNotSupported, block).arg("a smooth approach on a lathe");
                return;
            }
            actions.smooth_approach = &invocation;
            break;
        case Function::ApproachRadius:  // beside the approach, in approach_moves.cpp
        case Function::ApproachClearance:
        case Function::ApproachFeed: break;
        case Function::ApproachSide:
            approach_choice_.side = static_cast<ApproachChoice::Side>(std::clamp<std::int64_t>(
                count_of(block, invocation, parameter_of<Function::ApproachSide>("side")), 0, 3));
            break;
        case Function::CompFeed:
            channel_.compensation.choose_feed(block, invocation, actions);
            break;
        case Function::FeedOnce:
            actions.feed_once =
                block.argument(invocation, parameter_of<Function::FeedOnce>("feed"));
            break;
        case Function::AreaLimit: channel_.checks.set_area_limit(block, invocation); break;
        case Function::AreaOn:
        case Function::AreaOff: area_.switch_on(invocation.function == Function::AreaOn); break;
        case Function::SpeedBound:
            channel_.spindles.bound_speed(
                block, invocation.function,
                count_of(block, invocation, parameter_of<Function::SpeedBound>("upper")) != 0,
                block.argument(invocation, parameter_of<Function::SpeedBound>("speed")));
            break;
        case Function::CompPause:
        case Function::CompResume:
            if (comp_.is_on() && !channel_.shapes.keeps_shape()) {
                if (!channel_.compensation.require_comp_in_plane(block, invocation.function))
                    return;
                channel_.compensation.send_comp({invocation.function == Function::CompPause
                                                     ? CompChange::Kind::Pause
                                                     : CompChange::Kind::Resume,
                                                 {},
                                                 modal_.plane,
                                                 0,
                                                 position_.base(),
                                                 {},
                                                 {}});
            }
            break;
        case Function::ApproachSteps:
            approach_choice_.in_steps =
                count_of(block, invocation, parameter_of<Function::ApproachSteps>("steps")) != 0;
            break;
        case Function::SumOffset:
            channel_.tool.choose_sum_offset(block, invocation, actions);
            break;
        case Function::PathMoves:
        case Function::PointMoves:
        case Function::PointRapids:
            channel_.transformation.choose_point_to_point(invocation.function);
            break;
        case Function::AxisConfiguration:
        case Function::AxisSigns:
            channel_.tool_motion.choose_axes(block, invocation, actions.tool);
            break;
        case Function::OrientReset: actions.orient_reset = &invocation; break;
        case Function::ToolVector:
        case Function::ToolAngle:
        case Function::ToolLead:
        case Function::SurfaceLead:
        case Function::SurfaceTilt:
        case Function::SurfaceNormal:
        case Function::ConeAxis:
        case Function::ConeOpening:
        case Function::ToolBetween:
        case Function::ToolPoint:
        case Function::ToolSpin:
            channel_.tool_motion.take_orientation(block, invocation, actions);
            break;
        case Function::Tilt:
        case Function::TiltedPlaneEuler:
        case Function::TiltedPlaneByAngles:
            channel_.tilted_planes.tilt(block, invocation);
            if (invocation.function == Function::Tilt) actions.align = &invocation;
            break;
        case Function::TiltedPlaneByPoints:
        case Function::TiltedPlaneByVectors:
            channel_.tilted_planes.set_plane_by_blocks(block, invocation);
            break;
        case Function::TiltedPlaneAlongTool:
            channel_.tilted_planes.tilt_along_tool(block, invocation);
            break;
        case Function::AlignTool:
        case Function::AlignToolAtTip: actions.align = &invocation; break;
        case Function::Rotation3d:
            channel_.tilted_planes.rotate_about_axis(block, invocation);
            break;
        case Function::Swivel: channel_.tilted_planes.swivel(block, invocation); break;
        case Function::ToolFrame: channel_.tilted_planes.frame_along_tool(block, invocation); break;
        case Function::ToolFrameOff:
            frames_.set_tool_frame(std::nullopt);
            channel_.frames.frame_changed();
            position_.name();
            break;
        case Function::TableFrame:
        case Function::TableFrameOff:
            channel_.tilted_planes.follow_tables(block,
                                                 invocation.function == Function::TableFrame);
            break;
        case Function::ToolCarrier:
        case Function::CarrierByData:
        case Function::CarrierByFrame:
            channel_.carriers.choose_carrier(block, invocation, actions);
            break;
        case Function::SplineDegree: channel_.splines.set_spline_degree(block, invocation); break;
        case Function::SplineWeight:  // beside the control point, in splines.cpp
        case Function::SplineInterval:
        case Function::SplineKnot:
        case Function::PolynomialAxis:  // in polynomials.cpp
        case Function::PolynomialWeight:
        case Function::PolynomialRange:
        case Function::ThreadChange: break;  // beside the pitch, in motion.cpp
        case Function::SplineStart:
        case Function::SplineEnd: channel_.splines.choose_spline_end(block, invocation); break;
        case Function::ExactStopOnce:
            actions.exact_stop = true;
            channel_.dangers.watch_dwell(block);
            break;
        case Function::BlendFeedDistance:
        case Function::BlendRapidDistance:
        case Function::PathTolerance:
        case Function::OrientTolerance:
        case Function::OrientSmooth:
        case Function::OrientSmoothOff:
        case Function::HighSpeed: channel_.smoothing.choose_smoothing(block, invocation); break;
        case Function::MachineCoordinates: actions.machine_coordinates = true; break;
        case Function::LengthSuspend: actions.suspends_length = true; break;
        case Function::Preset: actions.preset = &invocation; break;
        case Function::ToothFeed:
            actions.tooth_feed =
                block.argument(invocation, parameter_of<Function::ToothFeed>("feed"));
            break;
        case Function::MeasureLength: actions.measure = &invocation; break;
        case Function::ParameterData: write_parameter(block, invocation); break;
        case Function::LifeData: report_life_data(block); break;
        case Function::ReferencePoint:
        case Function::ReferenceReturn:
        case Function::ReferenceCheck:
        case Function::ReferenceLeave: actions.reference = &invocation; break;
        case Function::RapidOnce: actions.at_rapid = true; break;
        case Function::ToolOffsetIncrease:
            actions.tool_offset_increase =
                block.argument(invocation, parameter_of<Function::ToolOffsetIncrease>("times"));
            break;
        case Function::TapFloating: actions.taps = true; break;
        case Function::FeedOverride:
        case Function::RapidOverride: dynamics_.set_override(block, invocation); break;
        case Function::AxisVelocity:
        case Function::AxisAcceleration:
        case Function::AxisJerk: dynamics_.set_axis_limit(block, invocation); break;
        case Function::FeedAxes: dynamics_.choose_feed_axes(block, invocation); break;
        case Function::FeedRadius: dynamics_.set_feed_radius(block, invocation); break;
        case Function::FeedCourse: dynamics_.choose_feed_characteristic(block, invocation); break;
        case Function::AxisSpeed:
        case Function::AxisFeed:
        case Function::AxisOverride: dynamics_.set_axis_speed(block, invocation); break;
        case Function::FeedPolynomial: channel_.feed.take_polynomial(block, invocation); break;
        case Function::Probe: actions.probes = true; break;
        case Function::ProbeCheck:
        case Function::ProbeClear:
        case Function::ProbeKeep: channel_.motions.use_probed(block, invocation); break;
        case Function::ThreadStart:
            actions.thread_start_deg =
                block.argument(invocation, parameter_of<Function::ThreadStart>("angle"));
            break;
        case Function::TapRigid: channel_.cycles.tap_rigidly(); break;
        case Function::Pole:
            position_words_.set_pole(block, invocation, channel_.motions.motion_words());
            break;
        case Function::PolarPoint: break;  // the motion's matter
        case Function::PolarOn:
            position_words_.switch_polar(true, channel_.motions.motion_words());
            break;
        case Function::PolarOff:
            position_words_.switch_polar(false, channel_.motions.motion_words());
            break;
        case Function::CornerChamfer:
        case Function::CornerRound:
        case Function::CornerRoundModal:
        case Function::CornerFeed:
        case Function::CornerFeedModal:
            channel_.cornering.choose_corner(block, invocation, actions);
            break;
        case Function::ContourAngle: actions.angle = &invocation; break;
        case Function::MachineFunction:
            pass_machine_function(
                block,
                count_of(block, invocation, parameter_of<Function::MachineFunction>("number")));
            break;
        case Function::LatheOffsetData:
        case Function::ToolOffsetData: actions.data = &invocation; break;
        case Function::ShiftAxes:
            channel_.frames.change_frame(block, invocation, &Frames::shift);
            break;
        case Function::ShiftAxesAdd:
            channel_.frames.change_frame(block, invocation, &Frames::shift_add);
            break;
        case Function::ShiftCoarse:
            channel_.frames.change_frame(block, invocation, &Frames::set_coarse);
            break;
        case Function::ShiftFine:
            channel_.frames.change_frame(block, invocation, &Frames::set_fine);
            break;
        case Function::SetPositionAxes: channel_.frames.set_position(block, invocation); break;
        case Function::PositionReset: channel_.frames.reset_position(block, invocation); break;
        case Function::RotateSpace:
        case Function::RotateSolid: channel_.frames.rotate_in_space(block, invocation); break;
        case Function::SpindleOrient: actions.orient = &invocation; break;
        case Function::MasterSpindle: channel_.spindles.select_master(block, invocation); break;
        case Function::SpindleTurn:
            // The master stops when M5 alone would stop it.
            if (count_of(block, invocation, parameter_of<Function::SpindleTurn>("spindle")) ==
                spindle_.number) {
                actions.spindle = sense_by_code(
                    count_of(block, invocation, parameter_of<Function::SpindleTurn>("sense")));
                actions.stops_behind |= nc::time_of_stop(rules_) == nc::When::Behind;
                break;
            }
            [[fallthrough]];
        case Function::SpindleSpeed:
        case Function::SpindleLimit:
        case Function::SpindleBound: channel_.spindles.act_on_spindle(block, invocation); break;
        case Function::SpindleStand: break;  // which takes its time: before the motion
        case Function::Dwell:
        case Function::SpindleDwell: actions.dwell = &invocation; break;
        case Function::Stop: actions.stop = Actions::Stop::Always; break;
        case Function::OptionalStop: actions.stop = Actions::Stop::Optional; break;
        case Function::Message: actions.message = &invocation; break;
        case Function::CycleOff:
            actions.cycle_is_cancelled = actions.cycle != nullptr;
            if (actions.cycle == nullptr) channel_.cycles.cancel();
            break;
        case Function::CycleCall: actions.calls_defined = true; break;
        case Function::CycleModal: actions.calls_behind_motions = true; break;
        case Function::CycleWords: {
            constexpr std::size_t kStroke = parameter_of<Function::CycleWords>("stroke");
            constexpr std::size_t kDwell = parameter_of<Function::CycleWords>("dwell");
            constexpr std::size_t kTimes = parameter_of<Function::CycleWords>("times");
            constexpr std::size_t kStart = parameter_of<Function::CycleWords>("start");
            CycleWords& words = actions.cycle_words;
            if (invocation.has(kStroke)) words.stroke = block.argument(invocation, kStroke);
            if (invocation.has(kDwell)) words.dwell = block.argument(invocation, kDwell);
            if (invocation.has(kTimes)) words.times = block.argument(invocation, kTimes);
            if (invocation.has(kStart)) words.start_deg = block.argument(invocation, kStart);
            break;
        }
        case Function::CyclePreset: channel_.cycles.preset_cycle(block, invocation); break;
        case Function::Cycle: actions.cycle = &invocation; break;
        case Function::None:
        case Function::Rapid:
        case Function::Line:
        case Function::ArcCw:
        case Function::ArcCcw:
        case Function::Spline:
        case Function::TapIn:
        case Function::TapOut:
        case Function::Thread:
        case Function::OffsetToEdge:
        case Function::OffsetToMiddle:
        case Function::PlaneXy:
        case Function::PlaneZx:
        case Function::PlaneYz:
        case Function::Inch:
        case Function::Metric:
        case Function::Absolute:
        case Function::Incremental:
        case Function::FeedPerMinute:
        case Function::FeedPerRevolution:
        case Function::FeedInverseTime:
        case Function::CuttingSpeedOn:
        case Function::CuttingSpeedOff:
        case Function::RadiusCompOff:
        case Function::RadiusCompLeft:
        case Function::RadiusCompRight:
        case Function::PeripheralCompLeft:
        case Function::PeripheralCompRight:
        case Function::RadiusOffset:
        case Function::CompStartNormal:
        case Function::CompStartAround:
        case Function::CompStartTangent:
        case Function::CompStartSmooth:
        case Function::CompCornerArc:
        case Function::CompCornerIntersection:
        case Function::CompCheckOn:
        case Function::CompCheckOff:
        case Function::CompInPlane:
        case Function::CompInFrame:
        case Function::CompPeripheral:
        case Function::CompFaceMilling:
        case Function::CompFaceMillingInFrame:
        case Function::CompFaceMillingInPlane:
        case Function::CompOrientOnArc:
        case Function::CompOrientBefore:
        case Function::LengthCompOn:
        case Function::TcpLength:
        case Function::TcpVector:
        case Function::LengthCompOff:
        case Function::LengthOffset:
        case Function::ExactStop:
        case Function::ContinuousPath:
        case Function::TappingMode:
        case Function::BlendDistance:
        case Function::BlendTolerance:
        case Function::BlendSmooth:
        case Function::CompressOn:
        case Function::CompressOff:
        case Function::WorkOffset:
        case Function::Shift:
        case Function::ShiftAdd:
        case Function::Rotate:
        case Function::RotateOff:
        case Function::Scale:
        case Function::ScaleOff:
        case Function::Mirror:
        case Function::MirrorOff:
        case Function::SetPosition:
        case Function::WorkOffsetData:
        case Function::DiameterOn:
        case Function::DiameterOff:
        case Function::ToolSelect:
        case Function::ToolChange:
        case Function::ToolEdge:
        case Function::Tool:
        case Function::TcpOn:
        case Function::TcpBased:
        case Function::TcpOff:
        case Function::PolarInterpolationOn:
        case Function::CylindricalInterpolationOn:
        case Function::InclinedAxisOn:
        case Function::OrientGreatCircle:
        case Function::OrientAxes:
        case Function::OrientSurface:
        case Function::OrientConeCw:
        case Function::OrientConeCcw:
        case Function::OrientConeThrough:
        case Function::OrientConeTangential:
        case Function::OrientSecondPoint:
        case Function::AnglesEuler:
        case Function::AnglesZyz:
        case Function::AnglesRpy:
        case Function::AnglesXyz:
        case Function::OrientInWork:
        case Function::OrientInBase:
        case Function::SpinFixed:
        case Function::SpinPlane:
        case Function::SpinTurn:
        case Function::SpinPath:
        case Function::TiltedPlaneOff:
        case Function::SpindleCw:
        case Function::SpindleCcw:
        case Function::SpindleStop:
        case Function::CoolantFlood:
        case Function::CoolantMist:
        case Function::CoolantOff:
        case Function::End:
        case Function::EndRewind:
        case Function::CycleReturnInitial:
        case Function::CycleReturnRetract:
        case Function::ArcThrough:
        case Function::ArcTangent:
        case Function::DiameterAbsolute:
        case Function::LengthCompMinus:
        case Function::AkimaSpline:
        case Function::CubicSpline:
        case Function::Polynomial:
        case Function::InvoluteCw:
        case Function::InvoluteCcw:
        case Function::ThreadIncreasing:
        case Function::ThreadDecreasing:
        case Function::ThreadArcCw:
        case Function::ThreadArcCcw:
        case Function::ParameterInput:
        case Function::LifeInput:
        case Function::DataInputOff: break;  // their effects do it all
    }
}

void BlockFunctions::change_plane(const Block& block, Function plane) {
    const Plane before = modal_.plane;
    modal_.plane = plane_of(plane);
    // Where a tool's lengths act may depend on the plane.
    if (channel_.tool.wanted_lengths() != tool_.lengths) channel_.tool.expect_length();
    if (modal_.plane == before) return;
    position_words_.leave_plane();
    // Along another tool axis the holes begin where the tool stands.
    if (modal_cycles_.modal.is_active && !block.is_of_cycle() && !is_lathe_)
        channel_.cycles.begin_level_here();
}

void BlockFunctions::act_before_motion(const Block& block, const Actions& actions) {
    if (actions.data != nullptr) write_data(block, *actions.data);
    if (actions.tool_change) channel_.tool.change_tool(block);
    if (tool_.edge_called != 0 && !reporter_.has_ended()) channel_.tool.take_edge(block);
    if (!reporter_.has_ended() && channel_.carriers.takes_carrier(block, actions))
        channel_.carriers.take_carrier(block);
    if (actions.comp_changed) channel_.compensation.act_on_comp(block, actions);
    if (actions.keeps_vector)
        channel_.compensation.send_comp(
            {CompChange::Kind::KeepVector, {}, modal_.plane, 0, position_.base(), {}, {}});
    if (actions.comp_corner != nullptr)
        channel_.compensation.round_comp_corner(block, *actions.comp_corner);
    if (reporter_.has_ended()) return;
    if (actions.limit != nullptr) {
        channel_.spindles.limit_speed(
            block, Function::SpeedLimit,
            block.argument(*actions.limit, parameter_of<Function::SpeedLimit>("limit")));
    }
    if (block.has(Slot::Speed)) channel_.spindles.program_speed(block);
    if (spindle_.has_cutting_speed && !(spindle_.cutting_speed > 0) &&
        block.find(Function::CuttingSpeedOn) != nullptr) {
        reporter_.report(diag::CuttingSpeedMissing, block, Function::CuttingSpeedOn);
        return;
    }
    if (actions.spindle) reported_.renew_spindle();
    if (actions.spindle && is_running(*actions.spindle)) channel_.spindles.turn(*actions.spindle);
    if (!actions.stops_behind) stop_spindle_and_coolant(block, actions);
    channel_.spindles.update_spindle(block);
    if (actions.orient != nullptr) channel_.spindles.orient_spindle(block, *actions.orient);
    if (!other_spindles_.empty() || block.find(Function::SpindleStand) != nullptr)
        channel_.spindles.update_other_spindles(block);
    if (reporter_.has_ended()) return;
    if (actions.flood) set_coolant(block, path::CoolantMode::Flood);
    if (actions.mist) set_coolant(block, path::CoolantMode::Mist);
    issue_functions(block, actions, MotionMoment::Before);
    if (actions.message != nullptr)
        channel_.stages.put(Op::Message, block).message().text = block.text;
    if (actions.dwell != nullptr) {
        if (actions.dwell->function == Function::SpindleDwell) {
            channel_.spindles.dwell_by_spindle(block, *actions.dwell);
        } else {
            dwell(block, *actions.dwell);
        }
    }
    if (actions.align != nullptr && !reporter_.has_ended())
        channel_.tilted_planes.align(block, *actions.align);
}

void BlockFunctions::act_after_motion(const Block& block, const Actions& actions) {
    if (actions.stops_behind) stop_spindle_and_coolant(block, actions);
    issue_functions(block, actions, MotionMoment::Behind);
    if (actions.stop == Actions::Stop::Always) channel_.stages.put(Op::Stop, block);
    if (actions.stop == Actions::Stop::Optional && options_.optional_stop) {
        channel_.stages.put(Op::OptionalStop, block);
    }
    if (actions.ends) {
        channel_.stages.put(Op::End, block);
        reporter_.end();
    }
}

void BlockFunctions::stop_spindle_and_coolant(const Block& block, const Actions& actions) {
    if (actions.spindle == SpindleMode::Stop) {
        channel_.dangers.watch_spindle_stop(block);
        channel_.spindles.turn(SpindleMode::Stop);
        channel_.spindles.update_spindle(block);
    }
    if (actions.coolant_off) set_coolant(block, path::CoolantMode::Off);
}

void BlockFunctions::dwell(const Block& block, const Invocation& invocation) {
    const double time = block.argument(invocation, parameter_of<Function::Dwell>("time"));
    const double revolutions =
        block.argument(invocation, parameter_of<Function::Dwell>("revolutions"));
    if (time < 0 || revolutions < 0) {
        reporter_.report(diag::DwellInvalid, block, Function::Dwell).arg("it is negative");
        return;
    }
    if (revolutions > 0 && !is_running(spindle_.mode)) {
        reporter_.report(diag::DwellInvalid, block, Function::Dwell).arg("the spindle stands");
        return;
    }
    if (time == 0 && revolutions == 0) return;
    path::Dwell& dwell = channel_.stages.put(Op::Dwell, block).dwell();
    dwell.time = time;
    dwell.revolutions = revolutions;
}

void BlockFunctions::write_data(const Block& block, const Invocation& invocation) {
    switch (invocation.function) {
        case Function::WorkOffsetData: channel_.frames.write_work_offset(block, invocation); break;
        case Function::LatheOffsetData: channel_.tool.write_lathe_offset(block, invocation); break;
        case Function::ToolOffsetData: channel_.tool.write_tool_offset(block, invocation); break;
        default: break;  // no other is sent here
    }
}

}  // namespace kadr::interp
