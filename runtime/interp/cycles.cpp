// cycles.cpp — machining cycles: called, repeated as a modal cycle, and their blocks executed.
//
// What a cycle does is not known here: the expander runs its definition and hands back blocks, and
// those are executed like any others, with the caller's frames and feed.
#include "interp/cycles.h"

#include <algorithm>
#include <cmath>

#include "base/diagnostics/iso.h"
#include "interp/block_functions.h"
#include "interp/block_words.h"
#include "interp/channel.h"
#include "interp/cornering.h"
#include "interp/cycle_shapes.h"
#include "interp/cycle_strokes.h"
#include "interp/executor.h"
#include "interp/motions.h"
#include "interp/path_smoothing.h"
#include "interp/programmed_frames.h"
#include "interp/radius_compensation.h"
#include "interp/stages.h"
#include "macro/named_shape.h"
#include "nc/parameters.h"

namespace kadr::interp {

using macro::kPatternParameter;
using macro::names_contour;
using macro::names_shape;
using nc::Block;
using nc::find_parameter;
using nc::Function;
using nc::Invocation;
using nc::Slot;
using nc::SlotMask;

namespace {

constexpr std::size_t kCycleBatch = 16;

/// … and this one of a cycle whose tool axis is X of a lathe.
constexpr std::string_view kAcrossParameter = "across";

}  // namespace

Cycles::Cycles(Channel& channel)
    : channel_(channel),
      dialect_(channel.state.dialect),
      is_lathe_(channel.state.is_lathe),
      tool_offsets_(channel.state.tool.tool_offsets),
      cycles_(channel.state.cycle.cycles),
      reporter_(channel.state.reporter),
      rules_(channel.state.rules),
      modal_(channel.state.motion.modal),
      position_(channel.state.motion.position),
      frames_(channel.state.frame.frames),
      spindle_(channel.state.spindle.spindle),
      tool_(channel.state.tool.tool),
      position_words_(channel.state.motion.position_words),
      corners_(channel.state.stage.corners),
      comp_(channel.state.stage.comp),
      taps_rigidly_(channel.state.cycle.taps_rigidly),
      axes_(channel.state.axes),
      modal_cycles_(channel.state.cycle.modal_cycles),
      cycle_(channel.state.cycle.cycle),
      shape_(channel.state.cycle.shape),
      patterns_(channel.state.cycle.patterns),
      callers_(channel.state.cycle.callers) {}

namespace {

/// Whether a call has one of the words without which a modal cycle drills no hole.
///
/// source  F 5.1: a block drills with any of X, Y, Z, R or of another axis
bool names_position(const Block& block, const ModalCycle& call, const nc::CycleInfo::Roles& roles) {
    const auto says = [&](int parameter) {
        return parameter >= 0 && ((call.given & ~call.by_form) >> parameter & 1u) != 0;
    };
    return (block.given & (nc::kTargetSlots | bit(Slot::Radius))) != 0 || says(roles.depth) ||
           says(roles.retract);
}

/// What a block that drills no hole gives for strokes and dwells is not stored (F 5.1).
void forget_words(ModalCycle& call, const nc::CycleInfo::Roles& roles) {
    for (const int parameter : {roles.stroke, roles.shift, roles.dwell}) {
        if (parameter < 0 || (call.by_form >> parameter & 1u) != 0) continue;
        call.given &= ~(std::uint32_t{1} << parameter);
        call.arguments[static_cast<std::size_t>(parameter)] = 0;
    }
}

}  // namespace

/// Whether further axis words repeat the cycle, so that its words stay in force.
bool Cycles::is_modal(nc::CycleId cycle) const {
    return rules_.modal_cycles && dialect_.cycles()[cycle].is_modal;
}

void Cycles::call_cycle(const Block& block, const Actions& actions) {
    const Invocation& invocation = *actions.cycle;
    const nc::CycleInfo& info = dialect_.cycles()[block.cycle];
    if (!info.curve.empty()) return channel_.motions.move_along_curve(block, invocation);
    if (names_contour(info)) return;  // the program keeps it for the cycles behind
    if (cycles_ == nullptr || callers_.runs(Callers::Kind::Cycle) || shape_) {
        reporter_.report(diag::CycleUnavailable, block, Function::Cycle).arg(info.name);
        return;
    }
    ModalCycle call;
    call.cycle = block.cycle;
    call.given = invocation.given;
    call.by_form = block.cycle_by_form;
    for (std::size_t i = 0; i < info.parameters.size(); ++i) {
        call.arguments[i] = block.argument(invocation, i);
    }
    complete_call(call);
    if (!require_whole_counts(block, call)) return;
    cycle_.is_across = is_lathe_ && find_parameter(info.parameters, kAcrossParameter).has_value();
    cycle_.lies_flat = !cycle_.is_across && (is_lathe_ || cycles_->turns(info.name));
    if (!require_surroundings(block, call) || !require_words_of_cycle(block, actions)) return;
    complete_surroundings(call, calls_program_at(block));
    take_ends(block, call);
    complete_ends(call);
    take_letter(block, call);
    if (info.takes_shape() || names_shape(info)) return channel_.shapes.begin_shape(block, call);
    call.is_active = is_modal(call.cycle);
    if (taps_rigidly_) {
        constexpr double kStop = 5;  // M5
        call.set(find_parameter(info.parameters, "floating"), 0);
        if (rules_.rigid_tap_stops_spindle)
            call.set(find_parameter(info.parameters, "after"), kStop);
    }
    if (call.is_active) {
        if (block.motion != Function::None)
            reporter_.report(diag::CycleBesideMotion, block, Function::Cycle).arg("the cycle");
        // The level where the cycle mode begins stays the initial level until the mode ends.
        const Axis tool_axis = path::axes_of(cycle_plane()).normal;
        if (!modal_cycles_.modal.is_active) {
            modal_cycles_.data = {};
            modal_cycles_.data.initial = position_.here()[index(tool_axis)];
        }
        if (info.roles.depth >= 0 && !names_position(block, call, info.roles)) {
            forget_words(call, info.roles);
            modal_cycles_.modal = call;
            return warn_levels(block);
        }
        keep_call(call);
        if (info.roles.depth >= 0) keep_levels(block);
        keep_words(actions.cycle_words);
        warn_levels(block);
    }
    // A pattern leaves the modal cycle as it is, which is called at its positions.
    if (find_parameter(info.parameters, kPatternParameter)) return start_cycle(block, call);
    modal_cycles_.modal = call;
    if (count_times(actions.cycle_words)) start_cycle(block, call);
}

void Cycles::call_behind_motion(const Block& block) {
    const bool is_circle_given =
        (block.given & nc::kArcSlots) != 0 && nc::has_fact(modal_.motion, nc::Fact::Circle);
    // An axis that moves by itself goes along no path.
    const bool is_path = ((block.given & nc::kTargetSlots) != 0 || is_circle_given) &&
                         block.find(Function::RapidOnce) == nullptr;
    if (reporter_.has_ended() || callers_.runs(Callers::Kind::Cycle) || shape_ || !is_path) return;
    Block call = *modal_cycles_.behind_motions;
    call.line = block.line;
    call.source = block.source;
    call.context = block.context;
    call.given = 0;
    const nc::CycleInfo& info = dialect_.cycles()[call.cycle];
    if (names_shape(info) && !patterns_.empty()) {  // its contour follows no motion to a position
        reporter_.report(diag::CycleUnavailable, call, Function::Cycle).arg(info.name);
        return;
    }
    Actions actions;
    actions.cycle = call.find(Function::Cycle);
    call_cycle(call, actions);
}

void Cycles::call_defined(const Block& block) {
    if (!modal_cycles_.defined) {
        reporter_.report(diag::CycleUndefined, block, Function::CycleCall);
        return;
    }
    Block call{};
    call.line = block.line;
    call.source = block.source;
    call.context = block.context;
    call.cycle = *modal_cycles_.defined;
    call.add(Function::Cycle, dialect_.cycles()[*modal_cycles_.defined].parameters.size());
    Actions actions;
    actions.cycle = call.find(Function::Cycle);
    call_cycle(call, actions);
}

void Cycles::move_instead_of_cycle(const Block& block, const Actions& actions) {
    reporter_.report(diag::CycleBesideMotion, block, Function::Cycle).arg("the motion");
    const int depth = dialect_.cycles()[block.cycle].roles.depth;
    const Invocation& cycle = *actions.cycle;
    Block moves = block;
    moves.given &= ~(nc::kCenterSlots | bit(Slot::Radius));
    if (depth >= 0 && (cycle.given >> depth & 1u) != 0) {
        moves.set(nc::slot_of(path::axes_of(cycle_plane()).normal),
                  block.argument(cycle, static_cast<std::size_t>(depth)));
    }
    Actions rest = actions;
    rest.cycle = nullptr;
    rest.cycle_is_cancelled = false;
    channel_.motions.move(moves, rest);
}

// ------------------------------------------------------------------------------ words of modal
// cycles

const Block& Cycles::with_depth_apart(const Block& block) {
    const Invocation* const call = block.find(Function::Cycle);
    if (call == nullptr || callers_.runs(Callers::Kind::Cycle) || is_lathe_ ||
        !is_modal(block.cycle))
        return block;
    const int depth = dialect_.cycles()[block.cycle].roles.depth;
    const bool is_given =
        depth >= 0 && (call->given >> depth & 1u) != 0 && (block.cycle_by_form >> depth & 1u) == 0;
    if (!is_given || channel_.executor.plane_in(block) == path::Plane::Xy) return block;
    called_ = block;
    called_.set(Slot::Z, block.argument(*call, static_cast<std::size_t>(depth)));
    for (std::size_t i = 0; i < called_.function_count; ++i) {
        Invocation& invocation = called_.functions[i];
        if (invocation.function == Function::Cycle) invocation.given &= ~(1u << depth);
    }
    return called_;
}

// ------------------------------------------------------------------------------ calls

bool Cycles::is_among_positions() const {
    const ModalCycle& modal = modal_cycles_.modal;
    return modal.is_active && !find_parameter(dialect_.cycles()[modal.cycle].parameters, "x");
}

/// All that the block programs beside a cycle to an end in X and Z is the cycle's. Drilling
/// cycles take words that wait for another cycle, and go to a position by any axis.
Done Cycles::require_words_of_cycle(const Block& block, const Actions& actions) {
    const bool is_called = actions.cycle != nullptr;
    const nc::CycleInfo& info =
        dialect_.cycles()[is_called ? block.cycle : modal_cycles_.modal.cycle];
    const bool is_turning = info.takes_shape() || find_parameter(info.parameters, "x").has_value();
    if (!rules_.modal_cycles || !is_turning || info.roles.depth >= 0) return kDone;
    const CycleWords& words = actions.cycle_words;
    if (words.stroke || words.dwell || words.times) {
        reporter_.report(diag::IsoWordUnused, block, Function::CycleWords)
            .arg(reporter_.word_of(block, Function::CycleWords));
        return kFailed;
    }
    for (std::size_t i = 0; i < kAxes; ++i) {
        const auto axis = static_cast<Axis>(i);
        const Slot slot = nc::slot_of(axis);
        if (!block.has(slot) || find_parameter(info.parameters, end_name(axis))) continue;
        reporter_.report(info.is_modal ? diag::CycleAxis : diag::CycleAxisBeside, block, slot)
            .arg(kAxisNames[i]);
        return kFailed;
    }
    return kDone;
}

void Cycles::repeat_cycle(const Block& block, const Actions& actions) {
    if (!require_words_of_cycle(block, actions)) return;
    const nc::CycleInfo& info = dialect_.cycles()[modal_cycles_.modal.cycle];
    if (const SlotMask centers = block.given & nc::kCenterSlots; centers != 0)
        channel_.motions.warn_arc_word(block, centers);
    keep_levels(block);
    keep_words(actions.cycle_words);
    ModalCycle ends = modal_cycles_.modal;
    ends.given = 0;  // what the calls before have programmed are positions already
    take_ends(block, ends);
    for (std::size_t i = 0; i < info.parameters.size(); ++i) {
        if ((ends.given >> i & 1u) != 0) modal_cycles_.modal.set(i, ends.arguments[i]);
    }
    if (find_parameter(info.parameters, "x")) end_where_tool_stands(modal_cycles_.modal);
    if (block.has(Slot::Radius)) {
        modal_cycles_.modal.set(find_parameter(info.parameters, "taper"), block.at(Slot::Radius));
    }
    if (info.roles.start >= 0) {
        const auto start = static_cast<std::size_t>(info.roles.start);
        modal_cycles_.modal.given &= ~(1u << start);
        if (actions.cycle_words.start_deg)
            modal_cycles_.modal.set(start, *actions.cycle_words.start_deg);
    }
    if (count_times(actions.cycle_words)) start_cycle(block, modal_cycles_.modal);
}

void Cycles::start_cycle(const Block& block, ModalCycle call, const CycleShape* shape) {
    if (comp_.is_on()) {
        reporter_.report(diag::CycleCompensated, block);
        return;
    }
    const path::PlaneAxes plane = path::axes_of(cycle_plane());
    const SlotMask place =
        block.given & nc::kTargetSlots & ~SlotMask{bit(nc::slot_of(plane.normal))};
    if (!channel_.motions.motion_words().require_axes(block, place)) return;
    const bool has_end = find_parameter(dialect_.cycles()[call.cycle].parameters, "x").has_value();
    if (place != 0 && !has_end)
        channel_.motions.line(block, channel_.motions.motion_words().target_of(block, place),
                              path::Op::Rapid, channel_.smoothing.stops_exactly());
    if (reporter_.has_ended()) return;

    if (is_modal(call.cycle) && modal_cycles_.data.stroke.value_or(0) > 0) {
        if (const auto in_strokes = call_in_strokes(dialect_, call)) {
            call = *in_strokes;
            complete_call(call);
        }
    }
    const nc::CycleInfo& info = dialect_.cycles()[call.cycle];
    complete_words(call);
    take_off_scale(call);
    go_straight(call);
    if (!time_turns(block, call)) return;
    if (!complete_tap(block, call) || !complete_thread(block, call)) return;

    CycleCall request;
    request.cycle = call.cycle;
    request.name = info.name;
    request.arguments = {call.arguments.data(), info.parameters.size()};
    request.given = call.given;
    request.position = position_in_cycle();
    if (cycle_.begins_at) request.position[2] = *cycle_.begins_at;
    request.feed = modal_.feed;
    request.feed_mode = modal_.feed_mode;
    request.speed = spindle_.speed;
    if (is_running(spindle_.mode)) request.spindle = spindle_.mode;
    request.source = block.source;
    if (reporter_.locations() != nullptr) request.location = reporter_.locations()->location(block);
    // Without a shape it is the plane alone, in which turning cycles work.
    const CycleShape plane_of_lathe{{}, modal_.plane, true};
    request.shape = shape != nullptr || !cycle_.lies_flat ? shape : &plane_of_lathe;
    request.x_is_diameter = !cycle_.lies_flat || axes_.word_scale[index(Axis::X)] != 1;
    std::unique_ptr<Stream<Block>> blocks = cycles_->expand(request);
    if (blocks == nullptr) {
        if (require_no_refusal(block)) reporter_.stop();  // the expander has reported why
        return;
    }
    cycle_.context = {&cycle_.caller, info.name, static_cast<std::uint16_t>(call.cycle + 1),
                      info.taps};
    if (call.has(find_parameter(info.parameters, kPatternParameter)))
        return begin_pattern(block, std::move(blocks));
    open_cycle(block, std::move(blocks));
}

/// From here on the blocks of the cycle are executed.
void Cycles::open_cycle(const Block& block, std::unique_ptr<Stream<Block>> blocks) {
    cycle_.caller = block;
    cycle_.modal_before = modal_;
    cycle_.x_scale_before = axes_.word_scale[index(Axis::X)];
    cycle_.after = {};
    begin_blocks();
    // The cycle's own motions neither repeat it nor end its mode.
    cycle_.is_modal_behind = modal_cycles_.modal.is_active;
    modal_cycles_.modal.is_active = false;
    if (corners_.is_active()) channel_.stages.settle(block);
    channel_.cornering.leave_corners(diag::CornerWithoutMotion);
    callers_.call(Callers::Kind::Cycle, std::move(blocks), kCycleBatch, &cycle_.context);
}

/// What the definition of the cycle finds wrong in its parameters is reported.
Done Cycles::require_no_refusal(const Block& block) {
    const std::optional<std::string> words = cycles_->refusal();
    if (!words) return kDone;
    refuse_cycle(block, *words);
    return kFailed;
}

/// An alarm of the cycle in these words, which tell what number it has on the control.
void Cycles::refuse_cycle(const Block& block, std::string_view words) {
    DiagnosticBuilder message = reporter_.report(diag::CycleRefused, block);
    message.arg(words);
    if (std::optional<nc::AlarmText> alarm = dialect_.alarm(diag::CycleRefused, words))
        message.alarm(std::move(alarm->number), std::move(alarm->text));
}

/// Where the control's cycles look around before they begin.
Done Cycles::require_surroundings(const Block& block, const ModalCycle& call) {
    const nc::CycleInfo& info = dialect_.cycles()[call.cycle];
    const auto has = [&](std::string_view name) {
        return find_parameter(info.parameters, name).has_value();
    };
    if (!rules_.cycles_check_surroundings || has(kPatternParameter)) return kDone;
    const bool has_feed = (modal_.has_feed && modal_.feed > 0) ||
                          call.has(find_parameter(info.parameters, "cut")) ||
                          call.has(find_parameter(info.parameters, "in_feed"));
    const bool needs_feed =
        !has("lead") && !has("pitch") && !has("per_turn") && !has("thread_size");
    const bool turns_by_itself = has("turns") || has("after");
    const bool turns =
        spindle_.mode == path::SpindleMode::Cw || spindle_.mode == path::SpindleMode::Ccw;
    // A program that calls no tool at all finds the one from before; it is warned where it cuts.
    std::string_view missing;
    if (comp_.is_on()) {
        missing = "cutter radius compensation must be off before a cycle";
    } else if (tool_.source == Tool::Source::None && tool_.current != 0) {
        missing = "no tool offset acts, and the cycle needs one";
    } else if (tool_.source != Tool::Source::None && tool_.current == 0) {
        missing = "the tool in the spindle is number 0, and the cycle needs one";
    } else if (needs_feed && !has_feed) {
        missing = "no feed is set for the cycle";
    } else if (!turns_by_itself && !turns) {
        missing = "no spindle direction is set for the cycle";
    }
    if (missing.empty()) return kDone;
    refuse_cycle(block, missing);
    return kFailed;
}

void Cycles::begin_blocks() {
    modal_.is_incremental = false;
    modal_.motion = Function::Rapid;
}

void Cycles::begin_level_here() {
    modal_cycles_.data.initial = position_.here()[index(path::axes_of(modal_.plane).normal)];
}

void Cycles::finish_cycle() {
    if (!require_no_refusal(channel_.stages.block_at(cycle_.caller.source, cycle_.caller.line)))
        return;
    // Compensation that the cycle has not ended is over; the cutter stays where it is.
    if (comp_.is_on()) {
        channel_.compensation.leave();
        channel_.compensation.stop_comp();
        if (reporter_.has_ended()) return;
        position_.stand_at(channel_.compensation.cutter_position());
        channel_.frames.frame_changed();
    }
    callers_.leave(Callers::Kind::Cycle);
    take_back(cycle_.modal_before);
    axes_.count_x_as(cycle_.x_scale_before);
    modal_cycles_.modal.is_active = cycle_.is_modal_behind;
    if (cycle_.final_level) return_to_level();
    if (reporter_.has_ended()) return;
    if (cycle_.frames_outside) {
        channel_.frames.go_back_to(*cycle_.frames_outside);
        cycle_.frames_outside.reset();
        channel_.frames.frame_changed();
    }
    if (cycle_.times_left > 0) {
        --cycle_.times_left;
        const Actions after = cycle_.after;
        MotionWords words = channel_.motions.motion_words();
        const Block* const again = position_words_.repeated(words);
        const Block caller = again != nullptr ? *again : cycle_.caller;
        start_cycle(caller, modal_cycles_.modal);
        cycle_.after = after;
        return;
    }
    channel_.functions.act_after_motion(cycle_.caller, cycle_.after);
}

/// From the retract level down to where the cycle mode began.
void Cycles::return_to_level() {
    Block way{};
    way.line = cycle_.caller.line;
    way.source = cycle_.caller.source;
    const Slot slot = nc::slot_of(path::axes_of(cycle_plane()).normal);
    way.set(slot, *cycle_.final_level);
    way.absolute = bit(slot);
    if (cycle_.is_across) way.x_measure = nc::XMeasure::Radius;
    channel_.motions.line(way, channel_.motions.motion_words().target_of(way, bit(slot)),
                          path::Op::Rapid, channel_.smoothing.stops_exactly());
}

/// The plane in which a cycle works. Lathes drill along Z whatever their plane.
path::Plane Cycles::cycle_plane() const {
    if (cycle_.is_across) return path::Plane::Yz;
    return is_lathe_ || cycle_.lies_flat ? path::Plane::Xy : modal_.plane;
}

/// The programmed position as a cycle sees it: first and second axis of the plane, tool axis. X of
/// a lathe is the diameter that is programmed.
AxisValues Cycles::position_in_cycle() const {
    AxisValues position = position_.here();
    if (!cycle_.is_across) {
        for (std::size_t i = 0; i < kAxes; ++i) position[i] /= axes_.word_scale[i];
    }
    const path::PlaneAxes plane = path::axes_of(cycle_plane());
    const AxisValues all = position;
    position[0] = all[index(plane.first)];
    position[1] = all[index(plane.second)];
    position[2] = all[index(plane.normal)];
    return position;
}

const Block& Cycles::in_plane_of_cycle(const Block& block) {
    if (cycle_plane() == path::Plane::Xy || block.kind != Block::Kind::Nc) return block;
    const path::PlaneAxes plane = path::axes_of(cycle_plane());
    const std::array<std::size_t, 3> axes = {index(plane.first), index(plane.second),
                                             index(plane.normal)};
    cycle_.remapped = block;
    if (cycle_.is_across) cycle_.remapped.x_measure = nc::XMeasure::Radius;
    for (const std::size_t base : {std::size_t{0}, static_cast<std::size_t>(Slot::CenterX)}) {
        const SlotMask three = SlotMask{0b111} << base;
        cycle_.remapped.given &= ~three;
        cycle_.remapped.incremental &= ~three;
        cycle_.remapped.absolute &= ~three;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t from = base + i;
            const std::size_t to = base + axes[i];
            cycle_.remapped.values[to] = block.values[from];
            cycle_.remapped.given |= (block.given >> from & 1u) << to;
            cycle_.remapped.incremental |= (block.incremental >> from & 1u) << to;
            cycle_.remapped.absolute |= (block.absolute >> from & 1u) << to;
        }
    }
    return cycle_.remapped;
}

Done Cycles::require_no_cycle(const Block& block, const Actions& actions) {
    if (!modal_cycles_.modal.is_active && actions.cycle == nullptr) return kDone;
    if (actions.cycle == nullptr && !actions.probes && !is_among_positions()) {
        forget_ends();
        return kDone;
    }
    const Function own = actions.probes ? Function::Probe : Function::MachineCoordinates;
    reporter_.report(diag::MotionInCycle, block, own).arg(reporter_.word_of(block, own));
    return kFailed;
}

}  // namespace kadr::interp
