#include "interp/executor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/assert.h"
#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "base/units.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Group;
using nc::Invocation;
using nc::Slot;
using path::Command;
using path::FeedMode;
using path::Op;
using path::Plane;
using path::SpindleMode;

namespace {

/// Blocks of a batch: enough to hide the cost of a pull, few enough to stay in the nearest cache.
constexpr std::size_t kProgramBatch = 64;

/// Sets the member of a modal group; false if the function is no such member.
bool set_modal(Modal& modal, Function function) {
    switch (function) {
        case Function::Rapid:
        case Function::Line:
        case Function::ArcCw:
        case Function::ArcCcw:
        case Function::TapIn:
        case Function::TapOut:
        case Function::ArcThrough:
        case Function::ArcTangent:
        case Function::Thread: modal.motion = function; return true;
        case Function::PlaneXy: modal.plane = Plane::Xy; return true;
        case Function::PlaneZx: modal.plane = Plane::Zx; return true;
        case Function::PlaneYz: modal.plane = Plane::Yz; return true;
        case Function::Absolute: modal.is_incremental = false; return true;
        case Function::Incremental: modal.is_incremental = true; return true;
        case Function::FeedPerMinute: modal.feed_mode = FeedMode::PerMinute; return true;
        case Function::FeedPerRevolution: modal.feed_mode = FeedMode::PerRevolution; return true;
        case Function::FeedInverseTime: modal.feed_mode = FeedMode::InverseTime; return true;
        case Function::ExactStop:
        case Function::ContinuousPath:
            modal.has_exact_stop = function == Function::ExactStop;
            modal.blend = Function::None;
            return true;
        case Function::BlendDistance:
        case Function::BlendTolerance:
        case Function::BlendSmooth:
            modal.has_exact_stop = false;
            modal.blend = function;
            return true;
        default: return false;  // not modal, or the state of something else than the block
    }
}

/// What a control fixes before a tilted plane.
bool is_before_tilt(Function function) {
    switch (function) {
        case Function::WorkOffset:
        case Function::Shift:
        case Function::ReferencePoint:
        case Function::ReferenceReturn:
        case Function::ReferenceCheck:
        case Function::ReferenceLeave:
        case Function::PositionReset:
        case Function::SetPosition: return true;
        default: return false;
    }
}

bool is_running(SpindleMode mode) { return mode == SpindleMode::Cw || mode == SpindleMode::Ccw; }

/// X, Y, Z of a frame function, from its parameter `first` on. `x_scale` is 0.5 where X is a
/// diameter.
FrameWords frame_words(const Block& block, const Invocation& invocation, std::size_t first,
                       double x_scale) {
    FrameWords words;
    for (std::size_t i = 0; i < 3; ++i) words.values[i] = block.argument(invocation, first + i);
    words.values[0] *= x_scale;
    words.given = invocation.given >> first & 0b111u;
    return words;
}

std::int64_t count_of(const Block& block, const Invocation& invocation) {
    return std::llround(block.argument(invocation, 0));
}

}  // namespace

// ------------------------------------------------------------------------------ the run

Executor::Executor(const nc::Dialect& dialect, const machine::Machine& machine,
                   Stream<Block>& blocks, const nc::BlockPlaces* places, CycleExpander* cycles,
                   const InterpreterOptions& options, DiagnosticSink& sink)
    : dialect_(dialect),
      machine_(machine),
      tool_offsets_(machine),
      places_(places),
      cycles_(cycles),
      options_(options),
      sink_(sink),
      rules_(rules_of(dialect, sink)),
      program_(blocks, options.in_step ? 1 : kProgramBatch),
      clock_(machine) {
    lower_.fill(-std::numeric_limits<double>::infinity());
    upper_.fill(std::numeric_limits<double>::infinity());
    word_scale_.fill(1);
    is_lathe_ = machine.is_lathe || dialect.power_on(Group::Diameter) == Function::DiameterOn;
    if (is_lathe_) word_scale_[index(Axis::X)] = 0.5;
    for (const machine::MachineAxis& axis : machine.axes) {
        const auto degrees = [&](double value) {
            return axis.is_rotary ? deg_from_rad(value) : value;
        };
        axes_ |= bit(axis.axis);
        lower_[index(axis.axis)] = degrees(axis.lower);
        upper_[index(axis.axis)] = degrees(axis.upper);
        position_.base[index(axis.axis)] = degrees(axis.home);
        for (std::size_t point = 0; point < machine::kReferencePoints; ++point) {
            const std::optional<double> place =
                point == 0 ? axis.home : axis.further_homes[point - 1];
            if (!place) continue;
            reference_points_[point][index(axis.axis)] = degrees(*place);
            has_reference_point_[point] |= bit(axis.axis);
        }
    }
    for (const Group group :
         {Group::Motion, Group::Plane, Group::Distance, Group::FeedMode, Group::PathMode}) {
        set_modal(modal_, dialect.power_on(group));
    }
    returns_to_retract_ = dialect.power_on(Group::CycleReturn) == Function::CycleReturnRetract;
    for (const AxisValues& offset : machine.work_offsets)
        work_offsets_.push_back({.shift = offset});
    work_offset_ = rules_.default_work_offset;
    frames_.select_work_offset(work_offset_frame(work_offset_));
    frame_changed();
    clock_.start(position_.base);
    position_.programmed = position_.here;
    for (std::size_t i = 0; i < 3; ++i)
        came_from_[static_cast<Eigen::Index>(i)] = position_.base[i];
}

std::size_t Executor::pull(std::span<Command> out) {
    output_.open(out);
    timed_ = 0;
    follow_from_here();
    while (output_.has_room() && !ended_) execute_next();
    if (virtual_.axes.is_on()) follow_rotary();
    count_time();
    return output_.written();
}

void Executor::execute_next() {
    if (cycle_blocks_) {
        const Block* block = cycle_blocks_->next();
        if (block == nullptr) {
            finish_cycle();
            if (has_stages()) settle(caller_);
        } else {
            const Block& own = in_plane_of_cycle(*block);
            execute(own);
            if (has_stages()) settle(own);
        }
        return;
    }
    if (pattern_) return go_to_next_place();
    const Block* block = program_.next();
    if (block == nullptr) return end_of_blocks();
    if (places_ != nullptr && places_->is_behind_fault(*block)) {
        ended_ = alarmed_ = true;  // the control stops at the line that could not be read
        return;
    }
    if (move_plainly(*block)) return;
    if (virtual_.axes.is_on()) {
        block = in_virtual(*block);
        if (block == nullptr) return;
    }
    if (shape_ && !check_shape_block(*block)) return;
    execute(rules_.center_stays ? with_center(*block) : *block);
    const bool is_open = open_line_ || (corners_.is_active() && !acts(*block));
    if (has_stages() && !is_open) settle(*block);
    if (shape_ && !ended_) end_shape_block(*block);
    if (virtual_.axes.is_on() && !ended_) follow_rotary();
}

/// Whether commands pass through something that keeps them back; nearly never.
bool Executor::has_stages() const {
    return corners_.is_active() || is_any_comp_on() || soft_approach_.is_active();
}

void Executor::end_of_blocks() {
    finish_open_spline();
    if (ended_) return;
    if (open_line_) report(diag::AngleSecondMissing, *open_line_);
    if (ended_) return;
    leave_corners(diag::CornerWithoutMotion);
    if (ended_) return;
    if (soft_approach_.is_active()) {
        Block at{};
        at.source = soft_approach_.move().slow.source;
        at.line = soft_approach_.move().slow.line;
        report(diag::SoftNoDirection, at);
        return;
    }
    if (is_any_comp_on()) flush_comp();
    if (ended_) return;
    ended_ = true;
    if (places_ != nullptr && places_->stopped()) return;
    // The reader has said already why it stopped.
    if (places_ != nullptr && places_->failed()) {
        alarmed_ = true;
        return;
    }
    const bool is_alarm = rules_.missing_end == MissingEnd::Alarm;
    Block nowhere{};
    nowhere.line = places_ != nullptr ? static_cast<std::uint32_t>(places_->lines()) : 0;
    LinePlace place = places_ != nullptr ? places_->place(nowhere) : LinePlace{};
    report(is_alarm ? diag::EndOfRecord : diag::EndMissing, std::move(place));
}

/// Whether it is a block of the control that the operator lets run.
bool Executor::acts(const Block& block) const {
    if (block.kind != Block::Kind::Nc) return false;
    return block.skip < 0 || ((1u << block.skip | block.skip_also) & options_.skip_levels) == 0;
}

void Executor::execute(const Block& block) {
    if (!acts(block)) {
        if (block.kind == Block::Kind::Raw) report(diag::RawInCycle, block);
        return;
    }
    if (open_line_) return close_line(block);
    if (block.function_count != 0 && opens_line(block)) return;
    run(block);
}

void Executor::run(const Block& block) {
    const bool ends_spline =
        (spline_ && !continues_spline(block)) || (through_ && !continues_through(block));
    if (ends_spline) {
        finish_open_spline(&block);
        if (ended_) return;
    }
    ++block_count_;
    if (options_.max_blocks != 0 && block_count_ > options_.max_blocks) {
        --block_count_;
        report(diag::TooManyBlocks, block).arg(static_cast<std::size_t>(options_.max_blocks));
        return;
    }
    if (tilting_.open && !check_open_plane(block)) return;
    if (block.function_count != 0) return run_functions(block);
    // Nothing but words: nearly every block.
    static constexpr Actions kNone{};
    if (block.has(Slot::Feed)) set_feed(block);
    if (block.has(Slot::Speed)) program_speed(block);
    if (block.has(Slot::Speed) || owes_speed_) update_spindle(block);
    if (rounding_ > 0) wish_corner(block, kNone);
    const bool has_others = polar_.is_on || (block.given & nc::kPolarSlots) != 0;
    const Block* places = has_others ? with_places(block) : &block;
    if (places == nullptr) return;
    move(*places, kNone);
    if (call_behind_motions_) call_behind_motion(*places);
}

void Executor::run_functions(const Block& said) {
    const Block& block = with_depth_apart(said);
    Actions actions = apply_functions(block);
    if (ended_) return;
    actions.motion_before = modal_.motion;
    actions.feed_before = modal_.feed;
    actions.had_feed = modal_.has_feed;
    actions.spindle_before = spindle_.told.mode;
    actions.coolant_before = coolant_;
    if (block.has(Slot::Feed)) set_feed(block);
    if (actions.tooth_feed) set_tooth_feed(block, *actions.tooth_feed);
    if (actions.preset != nullptr) preset_axes(block, *actions.preset);
    if (actions.corner != nullptr || rounding_ > 0) wish_corner(block, actions);
    if (ended_) return;
    act_before_motion(block, actions);
    if (ended_) return;
    const bool was_in_cycle = cycle_blocks_.has_value();
    const Block* places = with_places(block);
    if (places != nullptr && actions.angle != nullptr) places = with_angle(*places, *actions.angle);
    if (places == nullptr) return;
    move_with_own_feed(*places, actions);
    if (call_behind_motions_) call_behind_motion(*places);
    if (actions.calls_defined && !ended_ && !shape_) call_defined(block);
    if (ended_) return;
    if (cycle_blocks_ && !was_in_cycle) {
        after_cycle_ = actions;  // what the calling block does after its motion waits for the cycle
    } else {
        act_after_motion(block, actions);
    }
}

/// A feed that the block alone has acts in its motion, or in those of its cycle; behind it the
/// modal one does again.
void Executor::move_with_own_feed(const Block& places, const Actions& actions) {
    if (!actions.feed_once) return move(places, actions);
    const bool was_in_cycle = cycle_blocks_.has_value();
    const bool was_in_shape = shape_.has_value();
    const double feed = std::exchange(modal_.feed, *actions.feed_once);
    const bool has_feed = std::exchange(modal_.has_feed, true);
    move(places, actions);
    const auto take_back = [&](Modal& modal) {
        modal.feed = feed;
        modal.has_feed = has_feed;
    };
    if (cycle_blocks_ && !was_in_cycle) return take_back(modal_before_cycle_);
    if (shape_ && !was_in_shape) take_back(shape_->modal);
    take_back(modal_);
}

// ------------------------------------------------------------------------------ functions

Actions Executor::apply_functions(const Block& block) {
    Actions actions;
    const auto apply = [&](bool is_plane) {
        for (std::size_t i = 0; i < block.function_count && !ended_; ++i) {
            const Invocation& invocation = block.functions[i];
            const bool sets_plane = nc::info(invocation.function).group == Group::Plane;
            if (sets_plane == is_plane) apply_function(block, invocation, actions);
        }
    };
    if (block.find(Function::Rotate) != nullptr) {
        // A rotation turns in the plane of its block, wherever that is said.
        apply(true);
        apply(false);
        return actions;
    }
    for (std::size_t i = 0; i < block.function_count && !ended_; ++i) {
        apply_function(block, block.functions[i], actions);
    }
    return actions;
}

/// Whether the function would change, inside a rotation, what the control fixes before it.
bool Executor::is_too_late(Function function) const {
    if (!rules_.rotation_is_innermost) return false;
    if (tilting_.is_on && is_before_tilt(function)) return true;
    if (!frames_.is_rotated()) return false;
    switch (function) {
        case Function::WorkOffset:
        case Function::Shift:
        case Function::ShiftAdd:
        case Function::Mirror:
        case Function::MirrorOff:
        case Function::Scale:
        case Function::ReferencePoint:
        case Function::ReferenceReturn:
        case Function::ReferenceCheck:
        case Function::ReferenceLeave:
        case Function::MachineCoordinates:
        case Function::PositionReset:
        case Function::Tilt:
        case Function::TiltEuler:
        case Function::TiltPlane:
        case Function::TiltPoint:
        case Function::TiltVector:
        case Function::TiltAlongTool:
        case Function::SetPosition: return true;
        default: return is_other_plane(function);
    }
}

bool Executor::is_other_plane(Function function) const {
    switch (function) {
        case Function::PlaneXy: return modal_.plane != Plane::Xy;
        case Function::PlaneZx: return modal_.plane != Plane::Zx;
        case Function::PlaneYz: return modal_.plane != Plane::Yz;
        default: return false;
    }
}

/// Whether cutter radius compensation must have ended before the function.
bool Executor::needs_comp_off(const Block& block, Function function) const {
    const bool acts =
        comp_.side != Function::RadiusCompOff && block.find(Function::RadiusCompOff) == nullptr;
    if (!rules_.comp_is_innermost || !acts || cycle_blocks_) return false;
    switch (function) {
        case Function::Rotate:
        case Function::Shift:
        case Function::ShiftAdd:
        case Function::PositionReset:
        case Function::SetPosition:
        case Function::ReferencePoint:
        case Function::ReferenceReturn:
        case Function::ReferenceCheck:
        case Function::ReferenceLeave: return true;
        default: return false;
    }
}

void Executor::apply_function(const Block& block, const Invocation& invocation, Actions& actions) {
    if (needs_comp_off(block, invocation.function)) {
        report(diag::CompFrame, block, invocation.function).arg(nc::info(invocation.function).name);
        return;
    }
    if (taps_rigidly_ && !cycle_blocks_ && is_other_plane(invocation.function)) {
        report(diag::TapPlane, block, invocation.function);
        return;
    }
    if (is_too_late(invocation.function)) {
        report(diag::FrameInsideRotation, block, invocation.function)
            .arg(nc::info(invocation.function).name);
        return;
    }
    if (orienting_.has_length && refuses_under_tcp(block, invocation.function)) return;
    switch (invocation.function) {
        case Function::None: break;
        case Function::Inch:  // lengths have become mm in the reader
        case Function::Metric: check_units(block, invocation.function); break;

        case Function::Rapid:
        case Function::Line:
        case Function::ArcCw:
        case Function::ArcCcw:
        case Function::TapIn:
        case Function::TapOut:
        case Function::Spline:
        case Function::AkimaSpline:
        case Function::CubicSpline:
        case Function::Polynomial:
        case Function::InvoluteCw:
        case Function::InvoluteCcw:
        case Function::ThreadIncreasing:
        case Function::ThreadDecreasing:
        case Function::Thread:
        case Function::ThreadArcCw:
        case Function::ThreadArcCcw:
        case Function::PlaneXy:
        case Function::PlaneZx:
        case Function::PlaneYz:
        case Function::Absolute:
        case Function::Incremental:
        case Function::ExactStop:
        case Function::ContinuousPath:
        case Function::BlendDistance:
        case Function::BlendTolerance:
        case Function::BlendSmooth:
        case Function::ArcThrough:
        case Function::ArcTangent:
            if (nc::info(invocation.function).group == Group::Plane) {
                change_plane(invocation.function);
                // Where a tool's lengths act may depend on the plane.
                tool_.has_changed |= wanted_lengths() != tool_.lengths;
            }
            set_modal(modal_, invocation.function);
            break;

        case Function::FeedPerMinute: select_feed_mode(FeedMode::PerMinute); break;
        case Function::FeedPerRevolution: select_feed_mode(FeedMode::PerRevolution); break;
        case Function::FeedInverseTime: select_feed_mode(FeedMode::InverseTime); break;
        case Function::CuttingSpeedOn: spindle_.has_cutting_speed = true; break;
        case Function::CuttingSpeedOff: leave_cutting_speed(); break;
        case Function::SpeedLimit: actions.limit = &invocation; break;

        case Function::RadiusCompOff:
        case Function::RadiusCompLeft:
        case Function::RadiusCompRight:
        case Function::RadiusOffset:
        case Function::CompStartNormal:
        case Function::CompStartAround:
        case Function::CompStartTangent:
        case Function::CompStartSmooth:
        case Function::CompCornerArc:
        case Function::CompCornerIntersection:
        case Function::CompCornerPointed:
        case Function::CompCheckOn:
        case Function::CompCheckOff:
        case Function::CompAllowance:
        case Function::CompInPlane:
        case Function::CompBySide:
        case Function::CompByFace:
        case Function::CompByFaceInFrame:
        case Function::CompByFaceInPlane:
        case Function::SideCompLeft:
        case Function::SideCompRight:
        case Function::CompTurnOnArc:
        case Function::CompTurnBefore:
        case Function::CompDepth:
            // Roughing works along the programmed shape; where it is followed, it is compensated.
            if (!keeps_shape()) choose_comp(block, invocation, actions);
            break;
        case Function::CompKeepVector:
        case Function::CompCornerHere:
            if (comp_.side == Function::RadiusCompOff) {
                report(diag::CompNoVector, block, invocation.function);
                return;
            }
            if (!is_comp_in_plane(block, invocation.function)) return;
            actions.keeps_vector |= invocation.function == Function::CompKeepVector;
            if (invocation.function == Function::CompCornerHere) actions.comp_corner = &invocation;
            break;
        case Function::SoftApproach:
        case Function::SoftRetract:
            if (actions.soft != nullptr || soft_approach_.is_active()) {
                report(diag::SoftTwice, block, invocation.function);
                return;
            }
            if (machine_.is_lathe) {
                report(diag::IsoNotSupported, block).arg("a soft approach on a lathe");
                return;
            }
            actions.soft = &invocation;
            break;
        case Function::SoftRadius:  // beside the approach, in soft_moves.cpp
        case Function::SoftClearance:
        case Function::SoftFeed: break;
        case Function::SoftSide:
            soft_.side = static_cast<SoftState::Side>(
                std::clamp<std::int64_t>(count_of(block, invocation), 0, 3));
            break;
        case Function::CompFeed:
            comp_.feed = std::clamp<std::int64_t>(count_of(block, invocation), 0, 2);
            actions.comp_changed |= comp_.side != Function::RadiusCompOff;
            break;
        case Function::FeedOnce: actions.feed_once = block.argument(invocation, 0); break;
        case Function::AreaLimit: set_area_limit(block, invocation); break;
        case Function::AreaOn:
        case Function::AreaOff: area_.switch_on(invocation.function == Function::AreaOn); break;
        case Function::SpeedBound: set_speed_bound(block, invocation); break;
        case Function::CompPause:
        case Function::CompResume:
            if (comp_.side != Function::RadiusCompOff && !keeps_shape()) {
                if (!is_comp_in_plane(block, invocation.function)) return;
                send_comp({invocation.function == Function::CompPause ? CompChange::Kind::Pause
                                                                      : CompChange::Kind::Resume,
                           {},
                           modal_.plane,
                           0,
                           position_.base,
                           {},
                           {}});
            }
            break;
        case Function::SoftSteps: soft_.in_steps = count_of(block, invocation) != 0; break;
        case Function::TcpLength:
        case Function::TcpVector: begin_length_transformation(block, invocation, actions); break;
        case Function::LengthCompOn:
        case Function::LengthCompMinus:
            if (orienting_.has_length) end_length_transformation(actions);
            tool_.is_taken_off = invocation.function == Function::LengthCompMinus;
            if ((invocation.given & 1u) != 0) tool_.offset = count_of(block, invocation);
            set_length_source(Tool::Source::Offset, actions);
            break;
        case Function::LengthCompOff:
            if (orienting_.has_length) end_length_transformation(actions);
            set_length_source(Tool::Source::None, actions);
            break;
        case Function::LengthOffset:
            tool_.offset = count_of(block, invocation);
            if (tool_.source == Tool::Source::Offset) {
                set_length_source(Tool::Source::Offset, actions);
            }
            break;
        case Function::ToolEdge:
            warn_of_edge(block, count_of(block, invocation));
            set_length_source(
                count_of(block, invocation) == 0 ? Tool::Source::None : Tool::Source::Edge,
                actions);
            if (!keeps_shape()) actions.comp_changed |= comp_.side != Function::RadiusCompOff;
            break;
        case Function::ToolSelect:
            tool_.selected = tool_number(block, invocation);
            actions.tool_change |= selects_at_once();
            if ((invocation.given & 2u) != 0) {
                // The offset of a turret's station has length, radius and tip.
                tool_.offset = tool_.radius_offset = std::llround(block.argument(invocation, 1));
                set_length_source(tool_.offset == 0 ? Tool::Source::None : Tool::Source::Offset,
                                  actions);
            }
            break;
        case Function::ToolChange: actions.tool_change = true; break;
        case Function::Tool:
            tool_.selected = tool_number(block, invocation);
            actions.tool_change = true;
            set_length_source(Tool::Source::Edge, actions);
            break;

        case Function::TcpOn:
        case Function::TcpOff:
            end_virtual(block);
            if (!ended_) switch_transformation(block, invocation);
            break;
        case Function::FaceOn:
        case Function::CylinderOn:
        case Function::InclinedOn: begin_virtual(block, invocation); break;
        case Function::TurnPlane:
        case Function::TurnAxes:
        case Function::TurnSurface:
        case Function::TurnConeCw:
        case Function::TurnConeCcw:
        case Function::TurnConeOver:
        case Function::TurnConeOn:
        case Function::TurnPoint: orienting_.turning = invocation.function; break;
        case Function::AnglesEuler:
        case Function::AnglesZyz:
        case Function::AnglesRpy:
        case Function::AnglesXyz: orienting_.angles = invocation.function; break;
        case Function::SpinFixed:
        case Function::SpinPlane:
        case Function::SpinTurn:
        case Function::SpinPath: orienting_.spin = invocation.function; break;
        case Function::OrientInWork:
        case Function::OrientInBase:
            orienting_.is_in_base = invocation.function == Function::OrientInBase;
            break;
        case Function::OrientReset: actions.orient_reset = &invocation; break;
        case Function::ToolVector:
        case Function::ToolAngle:
        case Function::ToolLead:
        case Function::LeanLead:
        case Function::LeanTilt:
        case Function::SurfaceNormal:
        case Function::ConeAxis:
        case Function::ConeOpening:
        case Function::ToolBetween:
        case Function::ToolPoint:
        case Function::ToolSpin: take_orientation(block, invocation, actions); break;

        case Function::Tilt:
        case Function::TiltEuler:
        case Function::TiltPlane:
            tilt(block, invocation);
            if (invocation.function == Function::Tilt) actions.align = &invocation;
            break;
        case Function::TiltPoint:
        case Function::TiltVector: tilt_by_blocks(block, invocation); break;
        case Function::TiltAlongTool: tilt_along_tool(block, invocation); break;
        case Function::TiltAlign:
        case Function::TiltAlignTip: actions.align = &invocation; break;
        case Function::TiltOff: end_tilt(block); break;
        case Function::Swivel: swivel(block, invocation); break;
        case Function::ToolFrame: frame_along_tool(block, invocation); break;
        case Function::ToolFrameOff:
            frames_.set_tool_frame(std::nullopt);
            frame_changed();
            position_.programmed = position_.here;
            break;
        case Function::TableFrame:
        case Function::TableFrameOff:
            follow_tables(block, invocation.function == Function::TableFrame);
            break;

        case Function::SplineDegree: set_spline_degree(block, invocation); break;
        case Function::SplineWeight:  // beside the pole, in splines.cpp
        case Function::SplineInterval:
        case Function::SplineKnot:
        case Function::PolynomialAxis:  // in polynomials.cpp
        case Function::PolynomialWeight:
        case Function::PolynomialRange:
        case Function::ThreadChange: break;  // beside the pitch, in motion.cpp
        case Function::SplineStart:
        case Function::SplineEnd: choose_spline_end(block, invocation); break;

        case Function::ExactStopOnce: actions.exact_stop = true; break;
        case Function::BlendFeedDistance:
        case Function::BlendRapidDistance:
        case Function::PathTolerance:
        case Function::OrientTolerance:
        case Function::CompressOn:
        case Function::CompressOff: choose_smoothing(block, invocation); break;
        case Function::MachineCoordinates: actions.machine_coordinates = true; break;
        case Function::LengthSuspend: actions.suspends_length = true; break;
        case Function::Preset: actions.preset = &invocation; break;
        case Function::ToothFeed: actions.tooth_feed = block.argument(invocation, 0); break;
        case Function::MeasureLength: actions.measure = &invocation; break;
        case Function::ParameterInput:
        case Function::LifeInput:
        case Function::DataInputOff: break;  // the reader reads their blocks so
        case Function::ParameterData: write_parameter(block, invocation); break;
        case Function::LifeData: tell_life_data(block); break;
        case Function::ReferencePoint:
        case Function::ReferenceReturn:
        case Function::ReferenceCheck:
        case Function::ReferenceLeave: actions.reference = &invocation; break;
        case Function::RapidOnce: actions.at_rapid = true; break;
        case Function::WayOffset: actions.way_offset = block.argument(invocation, 0); break;
        case Function::TapFloating: actions.taps = true; break;
        case Function::Probe: actions.probes = true; break;
        // Here the part lies where the program expects it, and every probe finds it.
        case Function::ProbeCheck:
        case Function::ProbeClear:
        case Function::ProbeKeep:
        case Function::OffsetToEdge:
        case Function::OffsetToMiddle: break;
        case Function::ThreadStart: actions.thread_start_deg = block.argument(invocation, 0); break;
        case Function::TapRigid: taps_rigidly_ = true; break;
        case Function::DiameterOn:
        case Function::DiameterOff:
        case Function::DiameterAbsolute:
            word_scale_[index(Axis::X)] = invocation.function == Function::DiameterOff ? 1 : 0.5;
            diameter_is_absolute_ = invocation.function == Function::DiameterAbsolute;
            break;
        case Function::Pole: set_pole(block, invocation); break;
        case Function::PolarOn: switch_polar(true); break;
        case Function::PolarOff: switch_polar(false); break;
        case Function::CornerChamfer:
        case Function::CornerRound:
        case Function::CornerRoundModal:
        case Function::CornerFeed:
        case Function::CornerFeedModal: choose_corner(block, invocation, actions); break;
        case Function::ContourAngle: actions.angle = &invocation; break;
        case Function::MachineFunction:
            pass_machine_function(block, count_of(block, invocation));
            break;
        case Function::WorkOffset: select_work_offset(block, count_of(block, invocation)); break;
        case Function::WorkOffsetData:
        case Function::LatheOffsetData:
        case Function::ToolOffsetData: actions.data = &invocation; break;
        case Function::Shift:
        case Function::ShiftAdd:
        case Function::ShiftCoarse:
        case Function::ShiftFine:
        case Function::Rotate:
        case Function::RotateSpace:
        case Function::RotateSolid:
        case Function::RotateOff:
        case Function::Scale:
        case Function::ScaleOff:
        case Function::Mirror:
        case Function::MirrorOff:
        case Function::PositionReset:
        case Function::SetPosition: apply_frame(block, invocation); break;

        case Function::SpindleCw:
        case Function::SpindleCcw:
        case Function::SpindleStop: actions.spindle = invocation.function; break;
        case Function::SpindleOrient: actions.orient = &invocation; break;
        case Function::CoolantFlood: actions.flood = true; break;
        case Function::CoolantMist: actions.mist = true; break;
        case Function::CoolantOff: actions.coolant_off = true; break;

        case Function::Dwell: actions.dwell = &invocation; break;
        case Function::Stop:
        case Function::OptionalStop: actions.stop = invocation.function; break;
        case Function::End:
        case Function::EndRewind: actions.end = invocation.function; break;
        case Function::Message: actions.message = &invocation; break;

        case Function::CycleOff:
            actions.cycle_is_cancelled = actions.cycle != nullptr;
            if (actions.cycle == nullptr) modal_cycle_.is_active = taps_rigidly_ = false;
            break;
        case Function::CycleCall: actions.calls_defined = true; break;
        case Function::CycleModal: actions.calls_behind_motions = true; break;
        case Function::CycleWords: {
            CycleWords& words = actions.cycle_words;
            if ((invocation.given & 1u) != 0) words.stroke = block.argument(invocation, 0);
            if ((invocation.given & 2u) != 0) words.dwell = block.argument(invocation, 1);
            if ((invocation.given & 4u) != 0) words.times = block.argument(invocation, 2);
            break;
        }
        case Function::CycleReturnInitial: returns_to_retract_ = false; break;
        case Function::CycleReturnRetract: returns_to_retract_ = true; break;
        case Function::CyclePreset: preset_cycle(block, invocation); break;
        case Function::Cycle: actions.cycle = &invocation; break;
    }
}

/// A pole belongs to its plane.
void Executor::change_plane(Function plane) {
    const Plane before = modal_.plane;
    set_modal(modal_, plane);
    if (modal_.plane == before) return;
    polar_.pole = path::Vec2::Zero();
    polar_.angle_deg = 0;
}

void Executor::act_before_motion(const Block& block, const Actions& actions) {
    if (actions.data != nullptr) write_data(block, *actions.data);
    if (actions.tool_change) change_tool(block);
    if (actions.comp_changed) act_on_comp(block, actions);
    if (actions.keeps_vector)
        send_comp({CompChange::Kind::KeepVector, {}, modal_.plane, 0, position_.base, {}, {}});
    if (actions.comp_corner != nullptr) round_comp_corner(block, *actions.comp_corner);
    if (ended_) return;
    if (actions.limit != nullptr) set_speed_limit(block, *actions.limit);
    if (block.has(Slot::Speed)) program_speed(block);
    if (spindle_.has_cutting_speed && !(spindle_.cutting_speed > 0) &&
        block.find(Function::CuttingSpeedOn) != nullptr) {
        report(diag::CuttingSpeedMissing, block, Function::CuttingSpeedOn);
        return;
    }
    // What was said of a standing spindle is said anew when it stands again.
    if (actions.spindle != Function::None) warned_spindle_stopped_ = warned_rapid_ = false;
    if (actions.spindle == Function::SpindleCw) spindle_.mode = SpindleMode::Cw;
    if (actions.spindle == Function::SpindleCcw) spindle_.mode = SpindleMode::Ccw;
    if (!rules_.stops_after_motion) stop_spindle_and_coolant(block, actions);
    update_spindle(block);
    if (actions.orient != nullptr) orient_spindle(block, *actions.orient);
    if (actions.flood) set_coolant(block, path::CoolantMode::Flood);
    if (actions.mist) set_coolant(block, path::CoolantMode::Mist);
    issue_functions(block, actions, Side::Before);
    if (actions.message != nullptr) put(Op::Message, block).text = block.text;
    if (actions.dwell != nullptr) dwell(block, *actions.dwell);
    if (actions.align != nullptr && !ended_) align(block, *actions.align);
}

void Executor::act_after_motion(const Block& block, const Actions& actions) {
    if (rules_.stops_after_motion) stop_spindle_and_coolant(block, actions);
    issue_functions(block, actions, Side::Behind);
    if (actions.stop == Function::Stop) put(Op::Stop, block);
    if (actions.stop == Function::OptionalStop && options_.optional_stop) {
        put(Op::OptionalStop, block);
    }
    if (actions.end != Function::None) {
        put(Op::End, block);
        ended_ = true;
    }
}

void Executor::stop_spindle_and_coolant(const Block& block, const Actions& actions) {
    if (actions.spindle == Function::SpindleStop) {
        spindle_.mode = SpindleMode::Stop;
        update_spindle(block);
    }
    if (actions.coolant_off) set_coolant(block, path::CoolantMode::Off);
}

void Executor::dwell(const Block& block, const Invocation& invocation) {
    const double time = block.argument(invocation, 0);
    const double revolutions = block.argument(invocation, 1);
    if (time < 0 || revolutions < 0) {
        report(diag::DwellInvalid, block, Function::Dwell).arg("it is negative");
        return;
    }
    if (revolutions > 0 && !is_running(spindle_.mode)) {
        report(diag::DwellInvalid, block, Function::Dwell).arg("the spindle stands");
        return;
    }
    if (time == 0 && revolutions == 0) return;
    Command& command = put(Op::Dwell, block);
    command.time = time;
    command.revolutions = revolutions;
}

// ------------------------------------------------------------------------------ feed, spindle

void Executor::select_feed_mode(FeedMode mode) {
    if (mode != modal_.feed_mode && rules_.feed_deleted_on_mode_change) {
        modal_.has_feed = false;
        tooth_feed_ = 0;
    }
    modal_.feed_mode = mode;
}

void Executor::set_feed(const Block& block) {
    modal_.feed = block.at(Slot::Feed);
    modal_.has_feed = true;
    tooth_feed_ = 0;
}

void Executor::program_speed(const Block& block) {
    (spindle_.has_cutting_speed ? spindle_.cutting_speed : spindle_.speed) = block.at(Slot::Speed);
}

/// The spindle keeps the speed that it has at this moment.
void Executor::leave_cutting_speed() {
    if (!spindle_.has_cutting_speed) return;
    spindle_.has_cutting_speed = false;
    const double speed = turning_speed();
    if (std::isfinite(speed)) spindle_.speed = speed;  // in the centre without a limit: as before
}

/// Speed under constant cutting speed where the tool is, rpm; infinite in the centre without a
/// limit.
double Executor::turning_speed() const {
    const double diameter = 2 * std::abs(position_.here[index(Axis::X)]);
    double highest = machine_.max_speed > 0 ? rpm_from_speed(machine_.max_speed)
                                            : std::numeric_limits<double>::infinity();
    if (highest_speed() > 0) highest = std::min(highest, highest_speed());
    const double mm_min = 1000 * spindle_.cutting_speed;
    return std::min(mm_min / (std::numbers::pi * diameter), highest);
}

void Executor::set_speed_limit(const Block& block, const Invocation& invocation) {
    const double limit = block.argument(invocation, 0);
    if (!(limit > 0)) {
        report(diag::SpeedLimitInvalid, block, Function::SpeedLimit).arg(limit);
        return;
    }
    const double before = highest_speed();
    spindle_.limit = limit;
    tell_speed_limit(block, before);
}

/// The limit that acts under constant cutting speed, rpm; 0: none.
double Executor::highest_speed() const {
    if (spindle_.limit == 0 || spindle_.most == 0) return std::max(spindle_.limit, spindle_.most);
    return std::min(spindle_.limit, spindle_.most);
}

void Executor::tell_speed_limit(const Block& block, double before) {
    const double now = highest_speed();
    if (now != before) put(Op::SpeedLimit, block).speed = now;
}

void Executor::set_speed_bound(const Block& block, const Invocation& invocation) {
    const bool is_upper = count_of(block, invocation) != 0;
    const double bound = block.argument(invocation, 1);
    if (bound < 0 || (is_upper && bound == 0)) {
        report(diag::SpeedLimitInvalid, block, invocation.function).arg(bound);
        return;
    }
    const double before = highest_speed();
    (is_upper ? spindle_.most : spindle_.least) = bound;
    tell_speed_limit(block, before);
}

/// The programmed speed within the bounds of the spindle, rpm; said once of each speed.
double Executor::bounded_speed(const Block& block) {
    const double wanted = spindle_.speed;
    if (!(wanted > 0)) return wanted;
    double speed = std::max(wanted, spindle_.least);
    if (spindle_.most > 0) speed = std::min(speed, spindle_.most);
    if (speed != wanted && wanted != warned_bound_) {
        warned_bound_ = wanted;
        report(diag::SpeedBounded, block).arg(wanted).arg(speed);
    }
    return speed;
}

void Executor::set_area_limit(const Block& block, const Invocation& invocation) {
    constexpr std::size_t kFirst = 1;
    const FrameWords words = frame_words(block, invocation, kFirst, word_scale_[index(Axis::X)]);
    for (std::size_t i = 0; i < 3; ++i) {
        if (words.has(i))
            area_.set(static_cast<Axis>(i), count_of(block, invocation) != 0, words.values[i]);
    }
}

/// Tells the motion side what has become of the spindle, if anything has.
void Executor::update_spindle(const Block& block) {
    owes_speed_ = false;
    const bool runs = is_running(spindle_.mode);
    const bool is_bounded = runs && !spindle_.has_cutting_speed;
    const double speed = spindle_.has_cutting_speed ? spindle_.cutting_speed
                         : is_bounded               ? bounded_speed(block)
                                                    : spindle_.speed;
    const Spindle::Told now{spindle_.mode, runs ? speed : 0, runs && spindle_.has_cutting_speed};
    if (now == spindle_.told) return;
    if (runs && !(speed > 0)) report(diag::SpindleWithoutSpeed, block);
    spindle_.told = now;
    Command& command = put(Op::Spindle, block);
    command.spindle = now.mode;
    command.speed = now.speed;
    command.cutting_speed = now.has_cutting_speed;
    command.angle_deg = 0;
}

void Executor::orient_spindle(const Block& block, const Invocation& invocation) {
    constexpr std::size_t kBy = 1;
    double angle = block.argument(invocation, 0);
    if ((invocation.given >> kBy & 1u) != 0) {
        if (spindle_.mode != SpindleMode::Orient) {
            report(diag::SpindleAngleUnknown, block, invocation.function);
            return;
        }
        angle = std::fmod(spindle_.angle_deg + block.argument(invocation, kBy), 360);
        if (angle < 0) angle += 360;
    }
    spindle_.angle_deg = angle;
    spindle_.mode = SpindleMode::Orient;
    spindle_.told = {SpindleMode::Orient, 0, false};
    Command& command = put(Op::Spindle, block);
    command.spindle = SpindleMode::Orient;
    command.speed = 0;
    command.cutting_speed = false;
    command.angle_deg = angle;
}

void Executor::set_coolant(const Block& block, path::CoolantMode mode) {
    if (mode == coolant_) return;
    coolant_ = mode;
    put(Op::Coolant, block).coolant = mode;
}

// ------------------------------------------------------------------------------ tool

void Executor::set_length_source(Tool::Source source, Actions& actions) {
    tool_.source = source;
    tool_.has_changed = true;
    actions.length_changed = true;
}

/// Of a tool one cutting edge is kept.
void Executor::warn_of_edge(const Block& block, std::int64_t edge) {
    if (edge <= 1 || warned_edge_) return;
    warned_edge_ = true;
    report(diag::EdgeUnknown, block, Function::ToolEdge).arg(edge);
}

std::int64_t Executor::tool_number(const Block& block, const Invocation& invocation) {
    if ((invocation.given & 1u) != 0 || block.text.empty()) return count_of(block, invocation);
    const auto named = std::find_if(machine_.tools.begin(), machine_.tools.end(),
                                    [&](const auto& tool) { return tool.name == block.text; });
    if (named != machine_.tools.end()) return named->number;
    return unlisted_tool(block);
}

/// The number inside the control of a tool by a name that the table does not have: they count on
/// from the table's, in the order in which the program names them.
std::int64_t Executor::unlisted_tool(const Block& block) {
    std::int64_t last = 0;
    for (const machine::ToolData& tool : machine_.tools) last = std::max(last, tool.number);
    const auto known = std::find(unlisted_tools_.begin(), unlisted_tools_.end(), block.text);
    const std::int64_t number = last + 1 + (known - unlisted_tools_.begin());
    if (known != unlisted_tools_.end()) return number;
    unlisted_tools_.emplace_back(block.text);
    unknown_tools_.push_back(number);
    report(diag::ToolUnknown, block).arg(block.text);
    return number;
}

bool Executor::selects_at_once() const {
    return rules_.tool_select_changes == ToolSelectChanges::Yes ||
           (rules_.tool_select_changes == ToolSelectChanges::Lathe && machine_.is_lathe);
}

void Executor::change_tool(const Block& block) {
    const bool is_other = tool_.selected != tool_.current;
    if (is_other && rules_.comp_keeps_tool && comp_.side != Function::RadiusCompOff) {
        report(diag::CompToolChange, block);
        return;
    }
    if (tool_.selected != tool_.current) {
        tool_.current = tool_.selected;
        extra_ = {};
        put(Op::Tool, block).tool = tool_.current;
    }
    if (rules_.tool_change_stops_spindle && !machine_.is_lathe) {
        spindle_.mode = SpindleMode::Stop;
        warned_spindle_stopped_ = warned_rapid_ = false;
        update_spindle(block);
    }
    // What the block says of the edge itself is said.
    if (rules_.tool_change_activates_length && block.find(Function::ToolEdge) == nullptr)
        tool_.source = Tool::Source::Edge;
    tool_.has_changed |= tool_.source == Tool::Source::Edge;
    take_tooth_feed();
}

// ------------------------------------------------------------------------------ frames

void Executor::select_work_offset(const Block& block, std::int64_t number) {
    if (number < 0 || number > rules_.work_offsets) {
        report(diag::WorkOffsetUnknown, block, Function::WorkOffset).arg(number);
        return;
    }
    frames_.select_work_offset(work_offset_frame(number));
    work_offset_ = number;
    frame_changed();
}

void Executor::apply_frame(const Block& block, const Invocation& invocation) {
    const bool is_set = invocation.function == Function::SetPosition ||
                        invocation.function == Function::PositionReset;
    if (is_set && modal_cycle_.is_active) {
        report(diag::SetPositionInCycle, block, invocation.function);
        return;
    }
    const double x_scale = rules_.shift_in_diameter ? word_scale_[index(Axis::X)] : 1;
    const FrameWords words = frame_words(block, invocation, 0, x_scale);
    switch (invocation.function) {
        case Function::Shift: frames_.shift(words); break;
        case Function::ShiftAdd: frames_.shift_add(words); break;
        case Function::ShiftCoarse: frames_.set_coarse(words); break;
        case Function::ShiftFine: frames_.set_fine(words); break;
        case Function::RotateSpace:
        case Function::RotateSolid: rotate_in_space(block, invocation); break;
        case Function::Rotate:
            frames_.rotate(plane_in(block),
                           rad_from_deg(block.argument(invocation, 0, rules_.rotation_angle)),
                           center_of(block, invocation));
            break;
        case Function::Scale: scale(block, invocation); break;
        case Function::ScaleOff: frames_.scale_off(); break;
        case Function::RotateOff:
            if (rules_.place_behind_rotation && frames_.is_rotated()) unplaced_ = plane_mask();
            frames_.rotate_off();
            if (rules_.rotation_off_ends_tilt) end_tilt(block);
            break;
        case Function::Mirror: frames_.mirror(words); break;
        case Function::MirrorOff: frames_.mirror_off(static_cast<AxisMask>(words.given)); break;
        case Function::SetPosition:
            frames_.set_position(words, position_.here, position_.base);
            break;
        case Function::PositionReset:
            frames_.reset_position(static_cast<AxisMask>(words.given));
            break;
        default: KADR_ASSERT(false, "not a function of frames");
    }
    frame_changed();
    for (std::size_t i = 0; is_set && i < 3; ++i) {
        if (words.has(i)) position_.programmed[i] = position_.here[i];
    }
}

/// Center of a rotation or a scaling; it stands behind their first parameter.
FrameWords Executor::center_of(const Block& block, const Invocation& invocation) const {
    constexpr std::size_t kFirst = 1;
    const double x_scale = rules_.shift_in_diameter ? word_scale_[index(Axis::X)] : 1;
    FrameWords center = frame_words(block, invocation, kFirst, x_scale);
    for (std::size_t i = 0; rules_.frame_center_at_tool && i < 3; ++i) {
        if (!center.has(i)) center.values[i] = position_.here[i];
    }
    return center;
}

/// About X, Y and Z, as far as they are named.
void Executor::rotate_in_space(const Block& block, const Invocation& invocation) {
    std::vector<AxisAndValue> angles;
    for (std::size_t i = 0; i < 3; ++i) {
        if ((invocation.given >> i & 1u) != 0)
            angles.push_back({static_cast<Axis>(i), block.argument(invocation, i)});
    }
    if (invocation.function == Function::RotateSpace) {
        frames_.turn(rotation_frame(angles).linear);
    } else if (angles.size() <= 2) {
        frames_.turn(solid_frame(angles).linear);
    } else {
        report(diag::SolidAngles, block, invocation.function).arg(angles.size());
    }
}

/// One factor, or one for each axis; the axes that nothing is said of keep their size.
void Executor::scale(const Block& block, const Invocation& invocation) {
    constexpr std::size_t kFactors = 4;
    const double all = block.argument(invocation, 0, 1);
    path::Vec3 factors;
    for (std::size_t i = 0; i < 3; ++i) {
        const double factor = block.argument(invocation, kFactors + i, all);
        if (factor == 0) {
            report(diag::ScaleInvalid, block, Function::Scale).arg(factor);
            return;
        }
        factors[static_cast<Eigen::Index>(i)] = factor;
    }
    frames_.scale(factors, center_of(block, invocation));
}

/// What it does the machine file says, or the machine builder alone knows; then each is said once.
void Executor::pass_machine_function(const Block& block, std::int64_t number) {
    if (const auto& scanner = machine_.scanner) {
        if (number == scanner->on_function || number == scanner->off_function) {
            is_scanning_ = number == scanner->on_function;
            put(is_scanning_ ? Op::ScannerOn : Op::ScannerOff, block);
            return;
        }
    }
    if (machine_.find_function(number) != nullptr) return;  // it takes time, which is known
    if (std::ranges::find(known_machine_functions_, number) != known_machine_functions_.end())
        return;
    known_machine_functions_.push_back(number);
    report(diag::MachineFunctionPassed, block, Function::MachineFunction).arg(number);
}

/// No axis moves when a frame changes, but the tool has other coordinates now.
void Executor::frame_changed() { position_.here = frames_.from_base(position_.base); }

// ------------------------------------------------------------------------------ out

/// Where a command goes that no corner waits for.
Command& Executor::behind_corners() {
    if (keeps_shape()) return shape_->commands.emplace_back();
    if (soft_approach_.is_active()) return soft_approach_.next();
    if (space_comp_.is_on()) return space_comp_.next();
    return compensation_.is_on() ? compensation_.next() : output_.next();
}

Command& Executor::put(Op op, const Block& block) {
    const Block& from = origin(block);
    Command& command = corners_.is_active() ? corners_.next() : behind_corners();
    command.op = op;
    command.feed_mode = modal_.feed_mode;
    command.plane = modal_.plane;
    command.exact_stop = false;
    command.blending = blending(op);
    command.compress = compressing(op);
    command.machine_coordinates = false;
    command.is_unshifted = false;
    command.keeps_feed = false;
    command.is_swivelled = false;
    command.moved = 0;
    command.source = from.source;
    command.line = from.line;
    command.to = position_.base;
    command.turning = path::Turning::None;
    command.contact.clear();
    const bool reaches_comp = space_comp_.is_on() || corners_.is_active();
    if (comp_.acts_on_faces() && reaches_comp && path::is_motion(op))
        command.contact.push_back({face_, path::Vec3::Zero(), path::Vec3::Zero()});
    command.virtual_axes = {};
    if (is_transformed()) put_turn(command);
    command.text.clear();
    return command;
}

const Block& Executor::origin(const Block& block) const { return cycle_blocks_ ? caller_ : block; }

DiagnosticBuilder Executor::report(const DiagnosticRow& row, const Block& block) {
    const Block& from = origin(block);
    return note_calls(
        report(row, places_ != nullptr ? places_->place(from) : LinePlace{{}, from.line, 1, 1, {}}),
        from);
}

DiagnosticBuilder Executor::report(const DiagnosticRow& row, const Block& block, Slot slot) {
    if (places_ == nullptr || cycle_blocks_) return report(row, block);
    return note_calls(report(row, places_->place(block, slot)), block);
}

DiagnosticBuilder Executor::report(const DiagnosticRow& row, const Block& block,
                                   Function function) {
    if (places_ == nullptr || cycle_blocks_) return report(row, block);
    return note_calls(report(row, places_->place(block, function)), block);
}

/// Adds where the program of the block was called.
DiagnosticBuilder Executor::note_calls(DiagnosticBuilder builder, const Block& block) const {
    if (places_ == nullptr) return builder;
    for (LinePlace& place : places_->calls(block)) builder.note(std::move(place), "called here");
    return builder;
}

DiagnosticBuilder Executor::report(const DiagnosticRow& row, LinePlace place) {
    if (row.severity == Severity::Alarm) ended_ = alarmed_ = true;
    DiagnosticBuilder builder = sink_.report(row, std::move(place));
    if (std::optional<nc::AlarmText> alarm = dialect_.alarm(row)) {
        builder.alarm(std::move(alarm->number), std::move(alarm->text));
    }
    if (cycle_blocks_) builder.note("inside the cycle `" + std::string(cycle_name_) + "`");
    return builder;
}

}  // namespace kadr::interp
