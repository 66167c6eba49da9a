// Targets of a block: which words stand in the text, and with which numbers. Arcs: writer_arcs.cpp.
#include <algorithm>
#include <cmath>
#include <span>

#include "base/diagnostics/dialect.h"
#include "base/numbers.h"
#include "base/units.h"
#include "write/block_writer.h"

namespace kadr::write {

void BlockWriter::place_targets(const Block& block, Targets& targets) {
    targets.needs_incremental = text_.needs_incremental(block);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if (block.has(static_cast<Slot>(axis))) place_target(block, axis, targets);
    }
    if (modal_.frame.turn.miss > 0 || modal_.frame.tilt.miss > 0) check_turn(block);
}

void BlockWriter::place_target(const Block& block, std::size_t axis, Targets& targets) {
    const auto slot = static_cast<Slot>(axis);
    const SlotMask mask = bit(slot);
    if (!text_.has_address(slot)) {
        messages_.cannot_express(block, "the axis " + std::string(kAxisNames[axis]));
        return;
    }
    const double scale = text_.to_text(slot, 1);
    const double value = block.at(slot);
    targets.written |= mask;
    const bool by_itself = ((block.incremental | block.absolute) & mask) != 0;
    if (block.function_count != 0 && block.find(Function::MachineCoordinates) != nullptr) {
        targets.number[axis] = value * scale;
        place_machine_target(block, axis, by_itself, targets);
        return;
    }
    const Function text_distance = modal_.text_of(Group::Distance);
    const Function meant_distance = modal_.meant_of(Group::Distance);
    if (!by_itself && meant_distance == Function::None) {
        // After raw text nobody knows what the number is; it goes through, the position is lost.
        targets.number[axis] = value * scale;
        state_.lose(axis);
        return;
    }
    const bool is_distance =
        by_itself ? (block.incremental & mask) != 0 : meant_distance == Function::Incremental;
    const bool was_known = text_.is_known(axis);
    const double old_text = state_.go(axis, value, is_distance);

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
    const double text = modal_.position.text[axis];
    targets.number[axis] = (writes_distance ? text - old_text : text) * scale;
}

/// Where machine coordinates count, no known position turns a distance into a coordinate.
void BlockWriter::place_machine_target(const Block& block, std::size_t axis, bool by_itself,
                                       Targets& targets) {
    const bool is_way = text_.is_distance(block, axis);
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
    const Function motion = text_.effective_motion(block);
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
    if (text_.leads_tip() || modal_.meant_of(Group::FeedMode) == Function::FeedInverseTime) return;
    if (!block.has(Slot::Feed) && !modal_.has_meant_feed) return;  // that has its message
    double way = 0;                                                // squares, mm
    double parallel = 0;                                           // of U, V, W
    double turn = 0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if (!block.has(static_cast<Slot>(axis))) continue;
        const std::optional<double> distance = text_.meant_way(block, start, axis);
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

}  // namespace kadr::write
