#include "write/text_state.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.h"
#include "base/units.h"
#include "nc/cycle_back.h"

namespace kadr::write {

TextState::TextState(const Dialect& dialect)
    : tables_(dialect.tables()),
      rules_(tables_.rules),
      changer_(dialect.is_of_lathe() ? nc::Changer::Turret : nc::Changer::Magazine) {}

void TextState::begin(bool is_inch) {
    modal_ = {};
    // The state in which every Kadr program begins; the start lines bring the control there.
    modal_.meant[index_of(Group::Motion)] = Function::Rapid;
    modal_.meant[index_of(Group::Plane)] = Function::PlaneXy;
    modal_.meant[index_of(Group::Units)] = is_inch ? Function::Inch : Function::Metric;
    modal_.meant[index_of(Group::Distance)] = Function::Absolute;
    modal_.meant[index_of(Group::FeedMode)] = Function::FeedPerMinute;
    modal_.meant[index_of(Group::SpeedMode)] = Function::CuttingSpeedOff;
    modal_.meant[index_of(Group::RadiusComp)] = Function::RadiusCompOff;
    modal_.units.inch = modal_.units.inch_feed = is_inch;
    stand_without_codes();
    // A shift that keeps its words may be left over from another program.
    const auto& shifts = tables_.forms_of[static_cast<std::size_t>(Function::Shift)];
    const bool is_kept =
        std::ranges::any_of(shifts, [&](FormId id) { return tables_.forms[id].remembers; });
    for (NumberInForce& s : modal_.frame.shift) s = {!is_kept, 0};
    modal_.frame.origin = modal_.frame.shift;
    has_ended_ = false;
}

/// What the control has no code for it cannot have left: feeds a minute, X as a diameter, where no
/// code sets it.
void TextState::stand_without_codes() {
    for (std::size_t group = 0; group < kGroups; ++group) {
        const Function standing = tables_.power_on[group];
        if (standing != Function::None && !view_.has_code(standing)) modal_.text[group] = standing;
    }
}

void TextState::forget() {
    modal_.forget();
    stand_without_codes();
}

void TextState::join(const WriterModal& before) { modal_.join(before); }

void TextState::take_position(const Block& block) {
    WrittenPosition& position = modal_.position;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if (!block.has(static_cast<Slot>(axis)) || view_.is_known(axis)) continue;
        if ((position.reframed & bit(static_cast<Slot>(axis))) == 0)
            position.named[axis] = {position.meant[axis], position.text[axis]};
        position.meant[axis] = position.text[axis] = block.at(static_cast<Slot>(axis));
        position.known |= bit(static_cast<Slot>(axis));
        position.written |= bit(static_cast<Slot>(axis));
        position.reframed |= bit(static_cast<Slot>(axis));
    }
}

// ---------------------------------------------------------------- what the program means

void TextState::mean(const Block& block) { follow_modal(rules_, block, modal_.meant); }

void TextState::mean(const ModalFunctions& functions) { modal_.meant = functions; }

void TextState::mean(Group group, Function function) { modal_.meant[index_of(group)] = function; }

/// Modal functions act in their own block already.
void TextState::mean_all(const Block& block) {
    const Function feed_mode = modal_.meant_of(Group::FeedMode);
    const Function speed_mode = modal_.meant_of(Group::SpeedMode);
    const Function plane = modal_.meant_of(Group::Plane);
    const std::size_t tool_axis = view_.plane_axes()[2];
    mean(block);
    // The length acts along another axis: both are somewhere else, and are written again.
    if (rules_.length_axis == LengthAxis::Plane && plane != Function::None &&
        plane != modal_.meant_of(Group::Plane)) {
        for (const std::size_t axis : {tool_axis, view_.plane_axes()[2]})
            modal_.position.written |= modal_.position.known & bit(static_cast<Slot>(axis));
    }
    for (std::size_t i = 0; i < block.function_count; ++i) {
        const Function function = block.functions[i].function;
        const Group group = info(function).group;
        if (group == Group::FeedMode && function != feed_mode) modal_.has_meant_feed = false;
        if (group == Group::SpeedMode && function != speed_mode) modal_.has_meant_speed = false;
    }
    if (block.has(Slot::Speed)) {
        modal_.meant_speed = block.at(Slot::Speed);
        modal_.has_meant_speed = true;
    }
    if (block.has(Slot::Feed)) {
        modal_.meant_feed = block.at(Slot::Feed);
        modal_.has_meant_feed = true;
    }
}

void TextState::refuse_frame() { modal_.frame.is_refused = true; }

void TextState::end_lead(const NumberInForce& feed, bool is_other) {
    feed_word_.is_pitch = false;
    modal_.meant_feed = feed.value;
    modal_.has_meant_feed = feed.is_known;
    if (is_other) modal_.feed_is_other = true;
}

void TextState::mean_shared_feed(double feed) {
    modal_.meant_feed = feed;
    modal_.feed_is_other = true;
}

// ---------------------------------------------------------------- what words write

void TextState::say(const Form& form) {
    say(form.function, form);
    for (const Function also : form.sets) say(also, form);
}

void TextState::say(Function function, const Form& form) {
    const Group group = info(function).group;
    if (group == Group::NonModal) return;
    modal_.text[index_of(group)] = function;
    modal_.doubtful &= ~bit(group);
    if (group == Group::Units) {
        modal_.units.inch = function == Function::Inch;
        modal_.units.inch_feed = modal_.units.inch && !form.feed_stays_metric;
        modal_.feed.is_known = modal_.speed.is_known = false;
    }
    if (group == Group::FeedMode) {
        modal_.units.per_revolution = function == Function::FeedPerRevolution;
        modal_.units.inverse_time = function == Function::FeedInverseTime;
        modal_.feed.is_known = false;
        feed_word_.every_block = form.feed_every_block;
        feed_word_.arc_by_radius = form.feed_by_radius;
    }
    if (group == Group::SpeedMode) {
        modal_.units.cutting_speed = function == Function::CuttingSpeedOn;
        modal_.speed.is_known = false;
    }
}

void TextState::assume(Function function) {
    modal_.text[index_of(info(function).group)] = function;
}

void TextState::say_feed(double number, bool is_other) {
    modal_.feed = {true, number};
    modal_.feed_is_other = is_other;
}

void TextState::say_speed(double number) { modal_.speed = {true, number}; }

void TextState::doubt_feed() { modal_.feed.is_known = false; }

void TextState::doubt_speed() { modal_.speed.is_known = false; }

void TextState::begin_lead(bool is_pitch) { feed_word_.is_pitch = is_pitch; }

void TextState::say_shift(std::size_t argument, double value) {
    modal_.frame.shift[argument % modal_.frame.shift.size()] = {true, value};
}

/// Only 0 is the same in every unit.
void TextState::start_shift(const Form& form, AddressId address, double value) {
    for (const FormWord& word : form.words) {
        if (word.parameter < 0 || word.address != address || value != 0) continue;
        const auto axis = static_cast<std::size_t>(word.parameter) % modal_.frame.shift.size();
        modal_.frame.shift[axis] = modal_.frame.origin[axis] = {true, 0};
    }
}

void TextState::say_turn(const Block& block, const Invocation& invocation, double angle_deg,
                         int places) {
    const double miss = std::fabs(round_to(angle_deg, places) - angle_deg);
    switch (invocation.function) {
        case Function::Rotate:
            modal_.frame.turn.miss += rad_from_deg(miss);
            modal_.frame.turn.source = block.source;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                modal_.frame.turn.center[axis] =
                    block.argument(invocation, parameter_of<Function::Rotate>("x") + axis);
            }
            break;
        case Function::Tilt:
        case Function::TiltedPlaneEuler:
            modal_.frame.tilt.miss += rad_from_deg(miss);
            modal_.frame.tilt.source = block.source;
            modal_.frame.tilt.center = {};
            break;
        default: break;
    }
}

// ---------------------------------------------------------------- positions

double TextState::go(std::size_t axis, double value, bool is_distance) {
    const auto slot = static_cast<Slot>(axis);
    const SlotMask mask = bit(slot);
    WrittenPosition& position = modal_.position;
    // There an increment counts from the coordinate that was named last, whatever the frame.
    if (is_distance && rules_.incremental_frame == IncrementalFrame::Traversed &&
        (position.reframed & mask) != 0) {
        position.meant[axis] = position.named[axis][0];
        position.text[axis] = position.named[axis][1];
    }
    const double before = position.text[axis];
    const double scale = view_.to_text(slot, 1);
    position.meant[axis] = is_distance ? position.meant[axis] + value : value;
    position.text[axis] = round_to(position.meant[axis] * scale, view_.decimals(slot)) / scale;
    if (!is_distance) position.known |= mask;
    position.name(mask);
    return before;
}

void TextState::lose(std::size_t axis) {
    modal_.position.known &= static_cast<SlotMask>(~(SlotMask{1} << axis));
}

void TextState::change_diameter(Function before) {
    const Function now = modal_.text_of(Group::Diameter);
    if (before == Function::None || now == Function::None) {
        modal_.position.known &= ~bit(Slot::X);
        return;
    }
    const auto factor = [](Function member) { return member == Function::DiameterOff ? 1.0 : 2.0; };
    modal_.position.meant[kX] *= factor(now) / factor(before);
    modal_.position.text[kX] *= factor(now) / factor(before);
}

void TextState::follow_back(const Block& block, const Invocation& cycle) {
    const nc::CycleBack back = cycle_back(tables_.cycles[block.cycle].parameters, cycle.given);
    if (!back.is_elsewhere) return;
    WrittenPosition& position = modal_.position;
    if (back.moves_in_plane)
        position.known &= static_cast<SlotMask>(~(bit(Slot::X) | bit(Slot::Y) | bit(Slot::Z)));
    const std::size_t across = view_.plane_axes()[2];
    const SlotMask mask = bit(static_cast<Slot>(across));
    position.known &= static_cast<SlotMask>(~mask);
    if (!back.level) return;
    const auto slot = static_cast<Slot>(across);
    const double scale = view_.to_text(slot, 1);
    position.meant[across] = block.argument(cycle, *back.level);
    position.text[across] = round_to(position.meant[across] * scale, view_.decimals(slot)) / scale;
    position.known |= mask;
    position.written |= mask;
    position.reframed &= ~mask;
}

// ---------------------------------------------------------------- edges, held-back words

double TextState::call_waiting_edge() { return std::exchange(modal_.edge.waiting, 0); }

void TextState::edge_is_given(const WrittenPosition& position) {
    modal_.position = position;
    modal_.edge.is_length_due = true;
}

void TextState::length_acts() { modal_.edge.is_length_due = false; }

void TextState::hold_length(const Block& block, const Deferred* deferred, double number) {
    drop_pending_length();
    if (deferred != nullptr) pending_.push_back({deferred, number});
    modal_.edge.is_end_due = deferred == nullptr;
    modal_.edge.length = number;
    mean(Group::LengthComp, deferred != nullptr ? Function::LengthCompOn : Function::LengthCompOff);
    change_length(block);
}

void TextState::length_is_given(Function function) {
    assume(function);
    modal_.edge.is_end_due = false;
}

NumberInForce TextState::drop_edge() {
    return std::exchange(modal_.edge.number, NumberInForce{true, 0});
}

void TextState::let_wait(double edge) { modal_.edge.waiting = edge; }

void TextState::set_offset(std::size_t pending, double tool) { pending_[pending].tool = tool; }

void TextState::drop_pending(std::size_t pending) {
    pending_.erase(pending_.begin() + static_cast<std::ptrdiff_t>(pending));
}

}  // namespace kadr::write
