// cycles.cpp — machining cycles: called, repeated as a modal cycle, and their blocks executed.
//
// What a cycle does is not known here: the expander runs its definition and hands back blocks, and
// those are executed like any others, with the caller's frames and feed.
#include "interp/cycles.h"

#include <algorithm>
#include <cmath>

#include "base/danger_limits.h"
#include "base/diagnostics/doubtful.h"
#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "interp/block_functions.h"
#include "interp/block_words.h"
#include "interp/channel.h"
#include "interp/cornering.h"
#include "interp/cycle_shapes.h"
#include "interp/cycle_strokes.h"
#include "interp/danger_watch.h"
#include "interp/executor.h"
#include "interp/motions.h"
#include "interp/path_smoothing.h"
#include "interp/programmed_frames.h"
#include "interp/radius_compensation.h"
#include "interp/stages.h"
#include "interp/word_hints.h"
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

void set_argument(ModalCycle& call, std::optional<std::size_t> parameter, double value) {
    if (!parameter) return;
    call.arguments[*parameter] = value;
    call.given |= 1u << *parameter;
}

/// The parameter of a cycle that is where its cut ends along the axis.
std::string_view end_name(Axis axis) {
    switch (axis) {
        case Axis::X: return "x";
        case Axis::Y: return "y";
        case Axis::Z: return "z";
        default: return "";
    }
}

bool is_given(const ModalCycle& call, std::optional<std::size_t> parameter) {
    return parameter && (call.given >> *parameter & 1u) != 0;
}

/// Whether the call says its shift along both axes, so that it has a direction.
bool has_shift_vector(const nc::CycleInfo& cycle, const ModalCycle& call) {
    if (cycle.roles.shift < 0) return false;
    return is_given(call, static_cast<std::size_t>(cycle.roles.shift) + 1);
}

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

/// A form of the cycle that the call says by a letter ("E") is the number of the letter; 0: it is
/// none.
void Cycles::take_letter(const Block& block, ModalCycle& call) const {
    const std::vector<nc::Parameter>& parameters = dialect_.cycles()[call.cycle].parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (parameters[i].dimension != nc::Dimension::Text || parameters[i].name == "shape")
            continue;
        const char letter = block.text.size() == 1 ? block.text[0] : '\0';
        const bool is_letter = (letter >= 'A' && letter <= 'Z') || (letter >= 'a' && letter <= 'z');
        set_argument(call, i, is_letter ? letter & ~0x20 : 0);
    }
}

namespace {

/// Whether a call says one of the words without which a modal cycle drills no hole.
///
/// source  F 5.1: a block drills with any of X, Y, Z, R or of another axis
bool names_place(const Block& block, const ModalCycle& call, const nc::CycleInfo::Roles& roles) {
    const auto says = [&](int parameter) {
        return parameter >= 0 && ((call.given & ~call.by_form) >> parameter & 1u) != 0;
    };
    return (block.given & (nc::kTargetSlots | bit(Slot::Radius))) != 0 || says(roles.depth) ||
           says(roles.retract);
}

/// What a block that drills no hole says of strokes and dwells is not stored (F 5.1).
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
        set_argument(call, find_parameter(info.parameters, "floating"), 0);
        if (rules_.rigid_tap_stops_spindle)
            set_argument(call, find_parameter(info.parameters, "after"), kStop);
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
        if (info.roles.depth >= 0 && !names_place(block, call, info.roles)) {
            forget_words(call, info.roles);
            modal_cycles_.modal = call;
            return warn_levels(block);
        }
        keep_call(call);
        if (info.roles.depth >= 0) keep_levels(block);
        keep_words(actions.cycle_words);
        warn_levels(block);
    }
    // A pattern leaves the modal cycle as it is, which is called at its places.
    if (find_parameter(info.parameters, kPatternParameter)) return start_cycle(block, call);
    modal_cycles_.modal = call;
    if (count_times(actions.cycle_words)) start_cycle(block, call);
}

void Cycles::call_behind_motion(const Block& block) {
    const bool is_circle_said =
        (block.given & nc::kArcSlots) != 0 && nc::has_fact(modal_.motion, nc::Fact::Circle);
    // An axis that moves by itself goes along no path.
    const bool is_path = ((block.given & nc::kTargetSlots) != 0 || is_circle_said) &&
                         block.find(Function::RapidOnce) == nullptr;
    if (reporter_.has_ended() || callers_.runs(Callers::Kind::Cycle) || shape_ || !is_path) return;
    Block call = *modal_cycles_.behind_motions;
    call.line = block.line;
    call.source = block.source;
    call.context = block.context;
    call.given = 0;
    const nc::CycleInfo& info = dialect_.cycles()[call.cycle];
    if (names_shape(info) && !patterns_.empty()) {  // its contour follows no motion to a place
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
    const Invocation* const said = block.find(Function::Cycle);
    if (said == nullptr || callers_.runs(Callers::Kind::Cycle) || is_lathe_ ||
        !is_modal(block.cycle))
        return block;
    const int depth = dialect_.cycles()[block.cycle].roles.depth;
    const bool is_said =
        depth >= 0 && (said->given >> depth & 1u) != 0 && (block.cycle_by_form >> depth & 1u) == 0;
    if (!is_said || channel_.executor.plane_in(block) == path::Plane::Xy) return block;
    called_ = block;
    called_.set(Slot::Z, block.argument(*said, static_cast<std::size_t>(depth)));
    for (std::size_t i = 0; i < called_.function_count; ++i) {
        Invocation& invocation = called_.functions[i];
        if (invocation.function == Function::Cycle) invocation.given &= ~(1u << depth);
    }
    return called_;
}

/// How often the block does the cycle; false: not at all.
bool Cycles::count_times(const CycleWords& words) {
    const auto times = static_cast<int>(words.times.value_or(1));
    cycle_.times_left = times - 1;
    return times > 0;
}

control::CycleLevel Cycles::depth_now(double value) const {
    return control::cycle_depth(rules_, value, modal_.is_incremental);
}

control::CycleLevel Cycles::retract_now(double value) const {
    return control::cycle_retract(rules_, value, modal_.is_incremental);
}

/// Keeps what a call says by its words; what its code says by itself is not for other cycles.
void Cycles::keep_call(const ModalCycle& call) {
    const nc::CycleInfo& info = dialect_.cycles()[call.cycle];
    const nc::CycleInfo::Roles& roles = info.roles;
    const auto says = [&](int parameter) {
        return parameter >= 0 && (call.given >> parameter & 1u) != 0 &&
               (call.by_form >> parameter & 1u) == 0;
    };
    const auto value = [&](int parameter) {
        return call.arguments[static_cast<std::size_t>(parameter)];
    };
    if (says(roles.depth)) modal_cycles_.data.levels.depth = depth_now(value(roles.depth));
    if (says(roles.retract)) modal_cycles_.data.levels.retract = retract_now(value(roles.retract));
    // A stroke and a shift have no direction: their sign does not count.
    if (says(roles.stroke)) modal_cycles_.data.stroke = std::abs(value(roles.stroke));
    if (says(roles.shift) && !has_shift_vector(info, call))
        modal_cycles_.data.stroke = std::abs(value(roles.shift));
    if (says(roles.dwell)) modal_cycles_.data.dwell = value(roles.dwell);
}

void Cycles::keep_words(const CycleWords& words) {
    if (words.stroke) modal_cycles_.data.stroke = std::abs(*words.stroke);
    if (words.dwell) modal_cycles_.data.dwell = *words.dwell;
}

void Cycles::keep_levels(const Block& block) {
    const Slot depth = nc::slot_of(path::axes_of(cycle_plane()).normal);
    if (block.has(depth)) {
        const bool is_distance = (block.incremental & bit(depth)) != 0;
        const double scale =
            cycle_.is_across ? channel_.motions.motion_words().x_scale(block, is_distance) : 1;
        modal_cycles_.data.levels.depth = depth_now(block.at(depth) * scale);
        modal_cycles_.data.levels.depth.is_distance |= is_distance;
    }
    if (block.has(Slot::Radius))
        modal_cycles_.data.levels.retract = retract_now(block.at(Slot::Radius));
}

void Cycles::warn_levels(const Block& block) {
    if (dialect_.cycles()[block.cycle].roles.depth < 0) return;
    // A distance that nobody says is none: the cycle begins where the tool stands.
    if (!modal_cycles_.data.levels.retract.is_given && !retract_now(0).is_distance)
        reporter_.report(diag::CycleLevelMissing, block, Function::Cycle).arg("retract level");
    if (!modal_cycles_.data.levels.depth.is_given)
        reporter_.report(diag::CycleLevelMissing, block, Function::Cycle).arg("depth");
}

/// Fills the call with what its own words, and those of the cycles before it, have said.
void Cycles::complete_words(ModalCycle& call) {
    const nc::CycleInfo& info = dialect_.cycles()[call.cycle];
    const nc::CycleInfo::Roles& roles = info.roles;
    if (!is_modal(call.cycle) || roles.depth < 0) return;
    const auto set = [&](int parameter, double value) {
        if (parameter >= 0 && (call.by_form >> parameter & 1u) == 0)
            set_argument(call, static_cast<std::size_t>(parameter), value);
    };
    const CycleData& said = modal_cycles_.data;
    const control::CallLevels levels = *complete_levels(
        rules_, said.levels, modal_.is_incremental, said.initial, modal_cycles_.returns_to_retract);
    set(roles.retract, levels.retract);
    set(roles.depth, levels.depth);
    const double stroke = said.stroke.value_or(0);
    set(roles.stroke, stroke > 0 ? stroke : std::abs(levels.retract - levels.depth));
    if (!has_shift_vector(info, call)) set(roles.shift, stroke);
    if (said.dwell) set(roles.dwell, *said.dwell);
    set_argument(call, find_parameter(info.parameters, "initial"), levels.back);
}

/// Where a scaling spares what a cycle says of ways, the cycle runs without it, between the levels
/// that it gives.
void Cycles::take_off_scale(ModalCycle& call) {
    const nc::CycleInfo& info = dialect_.cycles()[call.cycle];
    if (rules_.cycle_distances_scaled || !frames_.is_scaled() || info.roles.depth < 0) return;
    const std::size_t normal = index(path::axes_of(cycle_plane()).normal);
    std::array<AxisValues, 3> places;
    const std::array<std::optional<std::size_t>, 3> levels = {
        static_cast<std::size_t>(info.roles.depth), static_cast<std::size_t>(info.roles.retract),
        find_parameter(info.parameters, "initial")};
    for (std::size_t i = 0; i < levels.size(); ++i) {
        places[i] = position_.here();
        if (is_given(call, levels[i])) places[i][normal] = call.arguments[*levels[i]];
        places[i] = frames_.to_base(places[i]);
    }
    cycle_.frames_outside = frames_;
    frames_.scale_off();
    channel_.frames.frame_changed();
    for (std::size_t i = 0; i < levels.size(); ++i) {
        if (is_given(call, levels[i]))
            call.arguments[*levels[i]] = frames_.from_base(places[i])[normal];
    }
}

/// The library's cycles begin and end at their initial level; those of controls go straight to the
/// retract level. Where the tool is not at the initial level, the cycle takes it to be there: then
/// its first way is the one to the retract level.
void Cycles::go_straight(ModalCycle& call) {
    cycle_.final_level.reset();
    cycle_.begins_at.reset();
    const nc::CycleInfo& info = dialect_.cycles()[call.cycle];
    const nc::CycleInfo::Roles& roles = info.roles;
    const std::optional<std::size_t> initial = find_parameter(info.parameters, "initial");
    if (!is_given(call, initial) || roles.retract < 0 || roles.depth < 0) return;
    const double back = call.arguments[*initial];
    const double retract = call.arguments[static_cast<std::size_t>(roles.retract)];
    const double depth = call.arguments[static_cast<std::size_t>(roles.depth)];
    if (retract <= depth) return;  // boring from below
    if (back > retract) cycle_.begins_at = back;
    // Where cycles are modal, nothing forbids a retract level above the level they return to.
    if (back >= retract || !is_modal(call.cycle)) return;
    call.arguments[*initial] = retract;
    cycle_.final_level = back;
}

// ------------------------------------------------------------------------------ calls

void Cycles::preset_cycle(const Block& block, const Invocation& invocation) {
    // Words of a target are those of a call, which lacks something; they must move nothing.
    if ((block.given & nc::kTargetSlots) != 0) {
        reporter_.report(diag::CycleWordsMissing, block, Function::CyclePreset)
            .arg(dialect_.cycles()[block.cycle].name);
        return;
    }
    const auto old = std::ranges::find(modal_cycles_.presets, block.cycle, &ModalCycle::cycle);
    ModalCycle& preset =
        old != modal_cycles_.presets.end() ? *old : modal_cycles_.presets.emplace_back();
    preset.cycle = block.cycle;
    modal_cycles_.defined = block.cycle;
    preset.given = invocation.given;
    const std::size_t count = dialect_.cycles()[block.cycle].parameters.size();
    for (std::size_t i = 0; i < count; ++i) preset.arguments[i] = block.argument(invocation, i);
}

/// What the call does not give has been given before.
void Cycles::complete_call(ModalCycle& call) const {
    for (const ModalCycle& preset : modal_cycles_.presets) {
        if (preset.cycle != call.cycle) continue;
        const std::size_t count = dialect_.cycles()[call.cycle].parameters.size();
        for (std::size_t i = 0; i < count; ++i) {
            if ((preset.given & ~call.given) >> i & 1u) set_argument(call, i, preset.arguments[i]);
        }
    }
    for (const nc::CycleInfo::Setting& setting : dialect_.cycles()[call.cycle].settings) {
        const auto parameter = static_cast<std::size_t>(setting.parameter);
        if ((call.given >> parameter & 1u) == 0) set_argument(call, parameter, setting.value);
    }
}

/// What counts is a whole number. Controls that round such numbers have no modal cycles.
Done Cycles::require_whole_counts(const Block& block, const ModalCycle& call) {
    if (!rules_.modal_cycles) return kDone;
    const std::vector<nc::Parameter>& parameters = dialect_.cycles()[call.cycle].parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const double value = call.arguments[i];
        const bool counts = parameters[i].dimension == nc::Dimension::Count;
        if (!counts || !is_given(call, i) || value == std::floor(value)) continue;
        refuse_cycle(block, '`' + std::string(parameters[i].name) + "` is " +
                                format_shortest(value) + ", and must be a whole number");
        return kFailed;
    }
    return kDone;
}

/// Cycles of a lathe have their end in X and Z. What a word of the call says of it may be a
/// distance, and so is what the block says besides, where the end has letters of its own for them.
void Cycles::take_ends(const Block& block, ModalCycle& call) const {
    for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
        const Slot slot = nc::slot_of(axis);
        const std::optional<std::size_t> end =
            find_parameter(dialect_.cycles()[call.cycle].parameters, end_name(axis));
        if (!end) continue;
        const double here = position_in_cycle()[index(axis)];
        if (is_given(call, end) && modal_.is_incremental) call.arguments[*end] += here;
        if (!block.has(slot)) continue;
        const bool is_distance = modal_.is_incremental ? (block.absolute & bit(slot)) == 0
                                                       : (block.incremental & bit(slot)) != 0;
        set_argument(call, end, (is_distance ? here : 0) + block.at(slot));
    }
}

/// A modal cycle to an end in X and Z keeps what its calls before have said; what none has said of
/// the end is where the tool stands.
void Cycles::complete_ends(ModalCycle& call) const {
    const nc::CycleInfo& info = dialect_.cycles()[call.cycle];
    if (!is_modal(call.cycle) || !find_parameter(info.parameters, "x")) return;
    const bool goes_on = modal_cycles_.modal.is_active && modal_cycles_.modal.cycle == call.cycle;
    for (std::size_t i = 0; goes_on && i < info.parameters.size(); ++i) {
        if (static_cast<int>(i) == info.roles.start) continue;  // of its block alone
        if (!is_given(call, i) && is_given(modal_cycles_.modal, i))
            set_argument(call, i, modal_cycles_.modal.arguments[i]);
    }
    end_where_tool_stands(call);
}

/// What nothing has said of the end of a cycle is where the tool stands.
void Cycles::end_where_tool_stands(ModalCycle& call) const {
    for (const Axis axis : {Axis::X, Axis::Z}) {
        const std::optional<std::size_t> end =
            find_parameter(dialect_.cycles()[call.cycle].parameters, end_name(axis));
        if (end && !is_given(call, end)) set_argument(call, end, position_in_cycle()[index(axis)]);
    }
}

void Cycles::forget_ends() {
    ModalCycle& modal = modal_cycles_.modal;
    for (const std::string_view name : {"x", "z", "taper"}) {
        const std::optional<std::size_t> said =
            find_parameter(dialect_.cycles()[modal.cycle].parameters, name);
        if (said) modal.given &= ~(1u << *said);
    }
}

bool Cycles::is_among_positions() const {
    const ModalCycle& modal = modal_cycles_.modal;
    return modal.is_active && !find_parameter(dialect_.cycles()[modal.cycle].parameters, "x");
}

/// All that the block says beside a cycle to an end in X and Z is the cycle's. Drilling
/// cycles take words that wait for another cycle, and go to a place by any axis.
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
    ends.given = 0;  // what the calls before have said are places already
    take_ends(block, ends);
    for (std::size_t i = 0; i < info.parameters.size(); ++i) {
        if ((ends.given >> i & 1u) != 0) set_argument(modal_cycles_.modal, i, ends.arguments[i]);
    }
    if (find_parameter(info.parameters, "x")) end_where_tool_stands(modal_cycles_.modal);
    if (block.has(Slot::Radius)) {
        set_argument(modal_cycles_.modal, find_parameter(info.parameters, "taper"),
                     block.at(Slot::Radius));
    }
    if (info.roles.start >= 0) {
        const auto start = static_cast<std::size_t>(info.roles.start);
        modal_cycles_.modal.given &= ~(1u << start);
        if (actions.cycle_words.start_deg)
            set_argument(modal_cycles_.modal, start, *actions.cycle_words.start_deg);
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
    if (reporter_.locations() != nullptr) request.place = reporter_.locations()->place(block);
    // Without a shape it is the plane alone, in which turning cycles work.
    const CycleShape plane_of_lathe{{}, modal_.plane, true};
    request.shape = shape != nullptr || !cycle_.lies_flat ? shape : &plane_of_lathe;
    request.x_is_diameter = !cycle_.lies_flat || axes_.word_scale[index(Axis::X)] != 1;
    std::unique_ptr<Stream<Block>> blocks = cycles_->expand(request);
    if (blocks == nullptr) {
        if (require_no_refusal(block)) reporter_.stop();  // the expander has said why
        return;
    }
    cycle_.context = {&cycle_.caller, info.name, static_cast<std::uint16_t>(call.cycle + 1),
                      info.taps};
    if (is_given(call, find_parameter(info.parameters, kPatternParameter)))
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

/// A tapping cycle whose words do not say the pitch has it from the feed: F itself where it counts
/// by the revolution, else F divided by the speed.
Done Cycles::complete_tap(const Block& block, ModalCycle& call) {
    const std::optional<std::size_t> pitch =
        find_parameter(dialect_.cycles()[call.cycle].parameters, "pitch");
    if (!pitch || is_given(call, pitch)) return kDone;
    if (!modal_.has_feed || !(modal_.feed > 0) || modal_.feed_mode == path::FeedMode::InverseTime) {
        reporter_.report(diag::TapPitchMissing, block, Function::Cycle);
        return kFailed;
    }
    if (spindle_.has_cutting_speed || !(spindle_.speed > 0)) {
        reporter_.report(diag::TapSpeedMissing, block, Function::Cycle);
        return kFailed;
    }
    const bool is_pitch = modal_.feed_mode == path::FeedMode::PerRevolution;
    const double turn = is_pitch ? modal_.feed : modal_.feed / spindle_.speed;
    set_argument(call, pitch, turn);
    // Told where the cycle is called or gets another feed, not at each of its holes.
    const bool is_new = block.find(Function::Cycle) != nullptr || block.has(Slot::Feed);
    if (!is_pitch && is_new) channel_.dangers.watch_tap(block, Function::Cycle);
    return kDone;
}

/// Where F is the pitch of a thread, that of a cycle is F too.
Done Cycles::complete_thread(const Block& block, ModalCycle& call) {
    const std::optional<std::size_t> lead =
        find_parameter(dialect_.cycles()[call.cycle].parameters, "lead");
    if (!lead || is_given(call, lead) || !rules_.thread_pitch_is_feed) return kDone;
    if (!modal_.has_feed || !(modal_.feed > 0)) {
        DiagnosticBuilder message = reporter_.report(diag::ThreadPitchMissing, block);
        message.arg(kAxisNames[index(Axis::Z)]);
        const std::string hint =
            hint_at_bare_cycle(dialect_.tables(), reporter_.locations(), block);
        if (!hint.empty()) message.fix(hint);
        return kFailed;
    }
    set_argument(call, lead, modal_.feed);
    return kDone;
}

/// Dwells below 0 count turns of the spindle on some controls.
Done Cycles::time_turns(const Block& block, ModalCycle& call) {
    if (!rules_.negative_dwell_turns) return kDone;
    const std::vector<nc::Parameter>& parameters = dialect_.cycles()[call.cycle].parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        double& time = call.arguments[i];
        const bool counts_turns = parameters[i].dimension == nc::Dimension::Time && time < 0;
        if (!counts_turns || !is_given(call, i)) continue;
        if (!(spindle_.speed > 0)) {
            reporter_.report(diag::DwellInvalid, block, Function::Cycle)
                .arg("it counts turns of the spindle, and no speed is set");
            return kFailed;
        }
        time *= -60 / spindle_.speed;
    }
    return kDone;
}

/// What the definition of the cycle says against its parameters is told.
Done Cycles::require_no_refusal(const Block& block) {
    const std::optional<std::string> words = cycles_->refusal();
    if (!words) return kDone;
    refuse_cycle(block, *words);
    return kFailed;
}

/// An alarm of the cycle in these words, which say what number it has on the control.
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
                          is_given(call, find_parameter(info.parameters, "cut")) ||
                          is_given(call, find_parameter(info.parameters, "in_feed"));
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

/// What a call does not say because the control knows it: the cutter's diameter, the radius of the
/// offset that it names or else the last D (whatever has ended the compensation), the plane (17 to
/// 19), and whether a cycle is called at the places of a pattern.
void Cycles::complete_surroundings(ModalCycle& call, bool calls_program) const {
    const nc::CycleInfo& info = dialect_.cycles()[call.cycle];
    set_argument(call, find_parameter(info.parameters, "tool_d"),
                 2 * tool_offsets_.radius(tool_.edge_number()));
    const auto said = find_parameter(info.parameters, "radius_offset");
    const std::int64_t offset =
        is_given(call, said) ? std::llround(call.arguments[*said]) : tool_.radius_offset;
    set_argument(call, find_parameter(info.parameters, "offset_r"), tool_offsets_.radius(offset));
    const bool calls =
        calls_program || modal_cycles_.behind_motions || modal_cycles_.modal.is_active;
    set_argument(call, find_parameter(info.parameters, kPatternParameter), calls ? 1 : 0);
    const path::Plane plane = cycle_plane();
    set_argument(call, find_parameter(info.parameters, "plane"),
                 plane == path::Plane::Xy   ? 17
                 : plane == path::Plane::Zx ? 18
                                            : 19);
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
/// a lathe is the diameter that programs say.
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
