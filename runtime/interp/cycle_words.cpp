// cycle_words.cpp — the words of a cycle's call: what it gives, what it leaves to the calls before
// it, and what the state of the control adds to it.
#include <algorithm>
#include <cmath>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "interp/channel.h"
#include "interp/cycles.h"
#include "interp/danger_watch.h"
#include "interp/motions.h"
#include "interp/programmed_frames.h"
#include "interp/word_hints.h"
#include "macro/named_shape.h"
#include "nc/parameters.h"

namespace kadr::interp {

using macro::kPatternParameter;
using nc::Block;
using nc::find_parameter;
using nc::Function;
using nc::Invocation;
using nc::Slot;

namespace {

/// Whether the call gives its shift along both axes, so that it has a direction.
bool has_shift_vector(const nc::CycleInfo& cycle, const ModalCycle& call) {
    if (cycle.roles.shift < 0) return false;
    return call.has(static_cast<std::size_t>(cycle.roles.shift) + 1);
}

}  // namespace

/// A form of the cycle that the call gives by a letter ("E") is the number of the letter; 0: it is
/// none.
void Cycles::take_letter(const Block& block, ModalCycle& call) const {
    const std::vector<nc::Parameter>& parameters = dialect_.cycles()[call.cycle].parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (parameters[i].dimension != nc::Dimension::Text || parameters[i].name == "shape")
            continue;
        const char letter = block.text.size() == 1 ? block.text[0] : '\0';
        const bool is_letter = (letter >= 'A' && letter <= 'Z') || (letter >= 'a' && letter <= 'z');
        call.set(i, is_letter ? letter & ~0x20 : 0);
    }
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

/// Keeps what a call gives by its words; what its code has by itself is not for other cycles.
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
    // A distance that nobody gives is none: the cycle begins where the tool stands.
    if (!modal_cycles_.data.levels.retract.is_given && !retract_now(0).is_distance)
        reporter_.report(diag::CycleLevelMissing, block, Function::Cycle).arg("retract level");
    if (!modal_cycles_.data.levels.depth.is_given)
        reporter_.report(diag::CycleLevelMissing, block, Function::Cycle).arg("depth");
}

/// Fills the call with what its own words, and those of the cycles before it, have given.
void Cycles::complete_words(ModalCycle& call) {
    const nc::CycleInfo& info = dialect_.cycles()[call.cycle];
    const nc::CycleInfo::Roles& roles = info.roles;
    if (!is_modal(call.cycle) || roles.depth < 0) return;
    const auto set = [&](int parameter, double value) {
        if (parameter >= 0 && (call.by_form >> parameter & 1u) == 0)
            call.set(static_cast<std::size_t>(parameter), value);
    };
    const CycleData& programmed = modal_cycles_.data;
    const control::CallLevels levels =
        *complete_levels(rules_, programmed.levels, modal_.is_incremental, programmed.initial,
                         modal_cycles_.returns_to_retract);
    set(roles.retract, levels.retract);
    set(roles.depth, levels.depth);
    const double stroke = programmed.stroke.value_or(0);
    set(roles.stroke, stroke > 0 ? stroke : std::abs(levels.retract - levels.depth));
    if (!has_shift_vector(info, call)) set(roles.shift, stroke);
    if (programmed.dwell) set(roles.dwell, *programmed.dwell);
    call.set(find_parameter(info.parameters, "initial"), levels.back);
}

/// Where a scaling spares what a cycle gives for distances, the cycle runs without it, between the
/// levels that it gives.
void Cycles::take_off_scale(ModalCycle& call) {
    const nc::CycleInfo& info = dialect_.cycles()[call.cycle];
    if (rules_.cycle_distances_scaled || !frames_.is_scaled() || info.roles.depth < 0) return;
    const std::size_t normal = index(path::axes_of(cycle_plane()).normal);
    std::array<AxisValues, 3> points;
    const std::array<std::optional<std::size_t>, 3> levels = {
        static_cast<std::size_t>(info.roles.depth), static_cast<std::size_t>(info.roles.retract),
        find_parameter(info.parameters, "initial")};
    for (std::size_t i = 0; i < levels.size(); ++i) {
        points[i] = position_.here();
        if (call.has(levels[i])) points[i][normal] = call.arguments[*levels[i]];
        points[i] = frames_.to_base(points[i]);
    }
    cycle_.frames_outside = frames_;
    frames_.scale_off();
    channel_.frames.frame_changed();
    for (std::size_t i = 0; i < levels.size(); ++i) {
        if (call.has(levels[i])) call.arguments[*levels[i]] = frames_.from_base(points[i])[normal];
    }
}

/// The library's cycles begin and end at their initial level; those of controls go straight to the
/// retract level. Where the tool is not at the initial level, the cycle takes it to be there: then
/// its first motion is the one to the retract level.
void Cycles::go_straight(ModalCycle& call) {
    cycle_.final_level.reset();
    cycle_.begins_at.reset();
    const nc::CycleInfo& info = dialect_.cycles()[call.cycle];
    const nc::CycleInfo::Roles& roles = info.roles;
    const std::optional<std::size_t> initial = find_parameter(info.parameters, "initial");
    if (!call.has(initial) || roles.retract < 0 || roles.depth < 0) return;
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
            if ((preset.given & ~call.given) >> i & 1u) call.set(i, preset.arguments[i]);
        }
    }
    for (const nc::CycleInfo::Setting& setting : dialect_.cycles()[call.cycle].settings) {
        const auto parameter = static_cast<std::size_t>(setting.parameter);
        if ((call.given >> parameter & 1u) == 0) call.set(parameter, setting.value);
    }
}

/// What counts is a whole number. Controls that round such numbers have no modal cycles.
Done Cycles::require_whole_counts(const Block& block, const ModalCycle& call) {
    if (!rules_.modal_cycles) return kDone;
    const std::vector<nc::Parameter>& parameters = dialect_.cycles()[call.cycle].parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const double value = call.arguments[i];
        const bool counts = parameters[i].dimension == nc::Dimension::Count;
        if (!counts || !call.has(i) || value == std::floor(value)) continue;
        refuse_cycle(block, '`' + std::string(parameters[i].name) + "` is " +
                                format_shortest(value) + ", and must be a whole number");
        return kFailed;
    }
    return kDone;
}

/// Cycles of a lathe have their end in X and Z. What a word of the call gives for it may be a
/// distance, and so is what the block gives besides, where the end has letters of its own for them.
void Cycles::take_ends(const Block& block, ModalCycle& call) const {
    for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
        const Slot slot = nc::slot_of(axis);
        const std::optional<std::size_t> end =
            find_parameter(dialect_.cycles()[call.cycle].parameters, end_name(axis));
        if (!end) continue;
        const double here = position_in_cycle()[index(axis)];
        if (call.has(end) && modal_.is_incremental) call.arguments[*end] += here;
        if (!block.has(slot)) continue;
        const bool is_distance = modal_.is_incremental ? (block.absolute & bit(slot)) == 0
                                                       : (block.incremental & bit(slot)) != 0;
        call.set(end, (is_distance ? here : 0) + block.at(slot));
    }
}

/// A modal cycle to an end in X and Z keeps what its calls before have programmed; what none has
/// programmed of the end is where the tool stands.
void Cycles::complete_ends(ModalCycle& call) const {
    const nc::CycleInfo& info = dialect_.cycles()[call.cycle];
    if (!is_modal(call.cycle) || !find_parameter(info.parameters, "x")) return;
    const bool goes_on = modal_cycles_.modal.is_active && modal_cycles_.modal.cycle == call.cycle;
    for (std::size_t i = 0; goes_on && i < info.parameters.size(); ++i) {
        if (static_cast<int>(i) == info.roles.start) continue;  // of its block alone
        if (!call.has(i) && modal_cycles_.modal.has(i))
            call.set(i, modal_cycles_.modal.arguments[i]);
    }
    end_where_tool_stands(call);
}

/// What nothing has programmed of the end of a cycle is where the tool stands.
void Cycles::end_where_tool_stands(ModalCycle& call) const {
    for (const Axis axis : {Axis::X, Axis::Z}) {
        const std::optional<std::size_t> end =
            find_parameter(dialect_.cycles()[call.cycle].parameters, end_name(axis));
        if (end && !call.has(end)) call.set(end, position_in_cycle()[index(axis)]);
    }
}

void Cycles::forget_ends() {
    ModalCycle& modal = modal_cycles_.modal;
    for (const std::string_view name : {"x", "z", "taper"}) {
        const std::optional<std::size_t> programmed =
            find_parameter(dialect_.cycles()[modal.cycle].parameters, name);
        if (programmed) modal.given &= ~(1u << *programmed);
    }
}

/// A tapping cycle whose words do not give the pitch has it from the feed: F itself where it counts
/// by the revolution, else F divided by the speed.
Done Cycles::complete_tap(const Block& block, ModalCycle& call) {
    const std::optional<std::size_t> pitch =
        find_parameter(dialect_.cycles()[call.cycle].parameters, "pitch");
    if (!pitch || call.has(pitch)) return kDone;
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
    call.set(pitch, turn);
    // Reported where the cycle is called or gets another feed, not at each of its holes.
    const bool is_new = block.find(Function::Cycle) != nullptr || block.has(Slot::Feed);
    if (!is_pitch && is_new) channel_.dangers.watch_tap(block, Function::Cycle);
    return kDone;
}

/// Where F is the pitch of a thread, that of a cycle is F too.
Done Cycles::complete_thread(const Block& block, ModalCycle& call) {
    const std::optional<std::size_t> lead =
        find_parameter(dialect_.cycles()[call.cycle].parameters, "lead");
    if (!lead || call.has(lead) || !rules_.thread_pitch_is_feed) return kDone;
    if (!modal_.has_feed || !(modal_.feed > 0)) {
        DiagnosticBuilder message = reporter_.report(diag::ThreadPitchMissing, block);
        message.arg(kAxisNames[index(Axis::Z)]);
        const std::string hint =
            hint_at_bare_cycle(dialect_.tables(), reporter_.locations(), block);
        if (!hint.empty()) message.fix(hint);
        return kFailed;
    }
    call.set(lead, modal_.feed);
    return kDone;
}

/// Dwells below 0 count revolutions of the spindle on some controls.
Done Cycles::time_turns(const Block& block, ModalCycle& call) {
    if (!rules_.negative_dwell_turns) return kDone;
    const std::vector<nc::Parameter>& parameters = dialect_.cycles()[call.cycle].parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        double& time = call.arguments[i];
        const bool counts_turns = parameters[i].dimension == nc::Dimension::Time && time < 0;
        if (!counts_turns || !call.has(i)) continue;
        if (!(spindle_.speed > 0)) {
            reporter_.report(diag::DwellInvalid, block, Function::Cycle)
                .arg("it counts turns of the spindle, and no speed is set");
            return kFailed;
        }
        time *= -60 / spindle_.speed;
    }
    return kDone;
}

/// What a call does not give because the control knows it: the cutter's diameter, the radius of the
/// offset that it names or else the last D (whatever has ended the compensation), the plane (17 to
/// 19), and whether a cycle is called at the positions of a pattern.
void Cycles::complete_surroundings(ModalCycle& call, bool calls_program) const {
    const nc::CycleInfo& info = dialect_.cycles()[call.cycle];
    call.set(find_parameter(info.parameters, "tool_d"),
             2 * tool_offsets_.radius(tool_.edge_number()));
    const auto programmed = find_parameter(info.parameters, "radius_offset");
    const std::int64_t offset =
        call.has(programmed) ? std::llround(call.arguments[*programmed]) : tool_.radius_offset;
    call.set(find_parameter(info.parameters, "offset_r"), tool_offsets_.radius(offset));
    const bool calls =
        calls_program || modal_cycles_.behind_motions || modal_cycles_.modal.is_active;
    call.set(find_parameter(info.parameters, kPatternParameter), calls ? 1 : 0);
    const path::Plane plane = cycle_plane();
    call.set(find_parameter(info.parameters, "plane"), plane == path::Plane::Xy   ? 17
                                                       : plane == path::Plane::Zx ? 18
                                                                                  : 19);
}

}  // namespace kadr::interp
