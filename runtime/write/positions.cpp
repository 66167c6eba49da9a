// Targets of a block: which words stand in the text, and with which numbers. Arcs: writer_arcs.cpp.
#include <algorithm>
#include <cmath>
#include <span>

#include "base/diagnostics/dialect.h"
#include "base/numbers.h"
#include "base/units.h"
#include "write/block_writer.h"

namespace kadr::write {

/// The address that writes the slot. Of a slot without one, what calculations need to go on: the
/// word itself is never written (`append_slot`).
const Address& BlockWriter::address_of(Slot slot) const {
    static const Address kNone = [] {
        Address none;
        none.dimension = Dimension::Length;
        return none;
    }();
    return has_address(slot)
               ? tables_.addresses[tables_.slot_address[static_cast<std::size_t>(slot)]]
               : kNone;
}

bool BlockWriter::has_address(Slot slot) const {
    return tables_.slot_address[static_cast<std::size_t>(slot)] != kNoAddress;
}

double BlockWriter::to_text(Slot slot, double value) const {
    return value * text_scale(address_of(slot).dimension, modal_.units, true);
}

int BlockWriter::decimals(Slot slot) const {
    const Address& address = address_of(slot);
    if (slot == Slot::Feed && feed_is_lead_)
        return text_decimals(lead_format(address.format), address.dimension, modal_.units);
    return text_decimals(address.format, address.dimension, modal_.units);
}

/// First, second and third axis of the working plane.
std::array<std::size_t, 3> BlockWriter::plane_axes() const {
    switch (modal_.meant[static_cast<std::size_t>(Group::Plane)]) {
        case Function::PlaneZx: return {2, 0, 1};
        case Function::PlaneYz: return {1, 2, 0};
        default: return {0, 1, 2};
    }
}

/// Whether the block can be said under incremental dimensions only: all its words are distances,
/// and the control has neither AC() and IC() nor letters of distances to say them from places that
/// nobody knows.
bool BlockWriter::needs_incremental(const Block& block) const {
    const SlotMask given = block.given & kTargetSlots;
    if (given == 0 || (block.incremental & given) != given) return false;
    if (tables_.notation.has_modes || tables_.has_incremental_letters) return false;
    const bool has_functions = block.function_count != 0;
    if (has_functions && block.find(Function::MachineCoordinates) != nullptr) return false;
    // On the way to the reference point the control's own habit is a distance: G91 G28 Z0.
    const bool is_return = has_functions && block.find(Function::ReferenceReturn) != nullptr;
    return is_return || (modal_.position.known & given) != given;
}

void BlockWriter::place_targets(const Block& block, Targets& targets) {
    targets.needs_incremental = needs_incremental(block);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if (block.has(static_cast<Slot>(axis))) place_target(block, axis, targets);
    }
    if (modal_.turn.miss > 0 || modal_.tilt.miss > 0) check_turn(block);
}

void BlockWriter::place_target(const Block& block, std::size_t axis, Targets& targets) {
    const auto slot = static_cast<Slot>(axis);
    const SlotMask mask = bit(slot);
    if (!has_address(slot)) {
        messages_.cannot_express(block, "the axis " + std::string(kAxisNames[axis]));
        return;
    }
    const double scale = to_text(slot, 1);
    const int places = decimals(slot);
    const double value = block.at(slot);
    targets.written |= mask;
    const bool by_itself = ((block.incremental | block.absolute) & mask) != 0;
    if (block.function_count != 0 && block.find(Function::MachineCoordinates) != nullptr) {
        targets.number[axis] = value * scale;
        place_machine_target(block, axis, by_itself, targets);
        return;
    }
    WrittenPosition& position = modal_.position;
    const Function text_distance = modal_.text_of(Group::Distance);
    const Function meant_distance = modal_.meant_of(Group::Distance);
    if (!by_itself && meant_distance == Function::None) {
        // After raw text nobody knows what the number is; it goes through, the position is lost.
        targets.number[axis] = value * scale;
        position.known &= ~mask;
        return;
    }
    const bool is_distance =
        by_itself ? (block.incremental & mask) != 0 : meant_distance == Function::Incremental;
    const bool was_known = is_known(axis);
    // There an increment counts from the coordinate that was named last, whatever the frame.
    if (is_distance && rules_.incremental_frame == IncrementalFrame::Traversed &&
        (position.reframed & mask) != 0) {
        position.meant[axis] = position.named[axis][0];
        position.text[axis] = position.named[axis][1];
    }
    const double old_text = position.text[axis];
    position.meant[axis] = is_distance ? position.meant[axis] + value : value;
    position.text[axis] = round_to(position.meant[axis] * scale, places) / scale;
    if (!is_distance) position.known |= mask;
    position.name(mask);

    bool writes_distance = is_distance;
    if (by_itself && tables_.notation.has_modes) {
        (is_distance ? targets.wrapped_incremental : targets.wrapped_absolute) |= mask;
    } else if (tables_.has_incremental_letters) {
        if (is_distance && tables_.incremental_address[axis] == kNoAddress) {
            messages_.cannot_express(block, "a distance along " + std::string(kAxisNames[axis]));
        }
        if (is_distance) targets.by_letter |= mask;
    } else if (by_itself) {
        writes_distance = text_distance == Function::Incremental || targets.needs_incremental;
        if (writes_distance != is_distance && !was_known)
            messages_.position_unknown(block, kAxisNames[axis]);
    }
    targets.number[axis] =
        (writes_distance ? position.text[axis] - old_text : position.text[axis]) * scale;
}

/// Where machine coordinates count, no known position turns a distance into a coordinate.
void BlockWriter::place_machine_target(const Block& block, std::size_t axis, bool by_itself,
                                       Targets& targets) {
    const bool is_way = is_distance(block, axis);
    // FANUC ignores it under G91, SINUMERIK travels or not as SD42440 says.
    const bool is_machine = block.find(Function::MachineCoordinates) != nullptr;
    if (is_way && is_machine && (by_itself || tables_.notation.has_modes))
        return messages_.cannot_express(block, "a distance in machine coordinates");
    if (by_itself && tables_.notation.has_modes) {
        (is_way ? targets.wrapped_incremental : targets.wrapped_absolute) |=
            bit(static_cast<Slot>(axis));
    } else if (is_way && (by_itself || tables_.has_incremental_letters)) {
        messages_.cannot_express(block, "a distance in machine coordinates");
    }
}

/// Words of axes that stay where they are need not be written, as long as one moves.
void BlockWriter::drop_unchanged(const Block& block, const WrittenPosition& start,
                                 Targets& targets) {
    const Function motion = effective_motion(block);
    if (motion != Function::Rapid && motion != Function::Line) return;
    if (((block.incremental | block.absolute) & block.given) != 0) return;
    if (modal_.text_of(Group::Distance) != Function::Absolute) return;
    SlotMask unchanged = 0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const SlotMask mask = bit(static_cast<Slot>(axis));
        if ((targets.written & start.known & ~start.told & mask) == 0) continue;
        if (std::fabs(start.text[axis] - modal_.position.text[axis]) < kSame) unchanged |= mask;
    }
    if (unchanged != targets.written) targets.written &= ~unchanged;
}
/// The axes of a straight block shall be as fast as the program means it, where program and control
/// count different ones: X, Y and Z, or all of them, of which a degree is a unit of length.
void BlockWriter::place_axes_feed(const Block& block, const WrittenPosition& start,
                                  Targets& targets) {
    constexpr SlotMask kFollowers = kTargetSlots & ~SlotMask{kLinearXYZ};
    if (block.feed_of_all_axes == rules_.feed_of_all_axes || (block.given & kFollowers) == 0)
        return;
    if (leads_tip() || modal_.meant_of(Group::FeedMode) == Function::FeedInverseTime) return;
    if (!block.has(Slot::Feed) && !modal_.has_meant_feed) return;  // that has its message
    double way = 0;                                                // squares, mm
    double parallel = 0;                                           // of U, V, W
    double turn = 0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if (!block.has(static_cast<Slot>(axis))) continue;
        const std::optional<double> distance = meant_way(block, start, axis);
        if (!distance) return messages_.position_unknown(block, "F");
        const bool turns = is_rotary(static_cast<Axis>(axis));
        const double unit = turns && modal_.units.inch_feed ? kMmPerInch : 1;
        (turns ? turn : axis < 3 ? way : parallel) += *distance * *distance * unit * unit;
    }
    const double all = std::sqrt(way + parallel + turn);
    const double counted = std::sqrt(way > kSame * kSame ? way : parallel);
    if (counted < kSame || all - counted < kSame)
        return;  // where rotary axes are alone, F is theirs
    targets.feed_factor = block.feed_of_all_axes ? counted / all : all / counted;
}

/// How far an axis goes in a block, frames included; none where nobody knows where it stands.
std::optional<double> BlockWriter::meant_way(const Block& block, const WrittenPosition& start,
                                             std::size_t axis) const {
    const bool is_way = is_distance(block, axis);
    if (!is_way && (start.known >> axis & 1u) == 0) return std::nullopt;
    const double way = block.at(static_cast<Slot>(axis)) - (is_way ? 0 : start.meant[axis]);
    return axis < modal_.factors.size() ? way * on_part(axis) * modal_.factors[axis] : way;
}

/// Whether F is the speed of the tip, whatever the axes do.
bool BlockWriter::leads_tip() {
    const Function length = modal_.meant_of(Group::LengthComp);
    const Function transformation = modal_.meant_of(Group::Transformation);
    const bool is_axes = transformation == Function::None || transformation == Function::TcpOff;
    return !is_axes || length == Function::TcpLength || length == Function::TcpVector;
}

}  // namespace kadr::write
