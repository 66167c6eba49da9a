#include "write/targets.h"

#include <cmath>

#include "base/units.h"

namespace kadr::write {

namespace {

/// Where machine coordinates count, no known position turns a distance into a coordinate.
void place_machine_target(const TextView& text, BlockMessages& messages, const Block& block,
                          std::size_t axis, Targets& targets) {
    const SlotMask mask = bit(static_cast<Slot>(axis));
    const bool by_itself = ((block.incremental | block.absolute) & mask) != 0;
    const bool is_distance = text.is_distance(block, axis);
    // FANUC ignores it under G91, SINUMERIK travels or not as SD42440 is set.
    const bool is_machine = block.find(Function::MachineCoordinates) != nullptr;
    if (is_distance && is_machine && (by_itself || text.tables.notation.has_modes))
        return messages.cannot_express(block, "a distance in machine coordinates");
    if (by_itself && text.tables.notation.has_modes) {
        (is_distance ? targets.wrapped_incremental : targets.wrapped_absolute) |= mask;
    } else if (is_distance && (by_itself || text.tables.has_incremental_letters)) {
        messages.cannot_express(block, "a distance in machine coordinates");
    }
}

void place_target(TextState& state, BlockMessages& messages, const Block& block, std::size_t axis,
                  Targets& targets) {
    const TextView& view = state.view();
    const auto slot = static_cast<Slot>(axis);
    const SlotMask mask = bit(slot);
    if (!view.has_address(slot)) {
        messages.cannot_express(block, "the axis " + std::string(kAxisNames[axis]));
        return;
    }
    const double scale = view.to_text(slot, 1);
    const double value = block.at(slot);
    targets.written |= mask;
    const bool by_itself = ((block.incremental | block.absolute) & mask) != 0;
    if (block.function_count != 0 && block.find(Function::MachineCoordinates) != nullptr) {
        targets.number[axis] = value * scale;
        place_machine_target(view, messages, block, axis, targets);
        return;
    }
    const Function text_distance = state.modal().text_of(Group::Distance);
    const Function meant_distance = state.modal().meant_of(Group::Distance);
    if (!by_itself && meant_distance == Function::None) {
        // After raw text nobody knows what the number is; it goes through, the position is lost.
        targets.number[axis] = value * scale;
        state.lose(axis);
        return;
    }
    const bool is_distance =
        by_itself ? (block.incremental & mask) != 0 : meant_distance == Function::Incremental;
    const bool was_known = view.is_known(axis);
    const double old_text = state.go(axis, value, is_distance);

    bool writes_distance = is_distance;
    if (by_itself && view.tables.notation.has_modes) {
        (is_distance ? targets.wrapped_incremental : targets.wrapped_absolute) |= mask;
    } else if (view.tables.has_incremental_letters) {
        if (is_distance && view.tables.incremental_address[axis] == kNoAddress) {
            messages.cannot_express(block, "a distance along " + std::string(kAxisNames[axis]));
        }
        if (is_distance) targets.by_letter |= mask;
    } else if (by_itself) {
        writes_distance = text_distance == Function::Incremental || targets.needs_incremental;
        if (writes_distance != is_distance && !was_known)
            messages.position_unknown(block, kAxisNames[axis], axis);
    }
    const double text = state.modal().position.text[axis];
    targets.number[axis] = (writes_distance ? text - old_text : text) * scale;
}

}  // namespace

void place_targets(TextState& state, BlockMessages& messages, const Block& block,
                   Targets& targets) {
    targets.needs_incremental = state.view().needs_incremental(block);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if (block.has(static_cast<Slot>(axis))) place_target(state, messages, block, axis, targets);
    }
}

void drop_unchanged(const TextView& text, const Block& block, const WrittenPosition& start,
                    Targets& targets) {
    const Function motion = text.effective_motion(block);
    if (motion != Function::Rapid && motion != Function::Line) return;
    if (((block.incremental | block.absolute) & block.given) != 0) return;
    if (text.modal.text_of(Group::Distance) != Function::Absolute) return;
    SlotMask unchanged = 0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const SlotMask mask = bit(static_cast<Slot>(axis));
        if ((targets.written & start.known & ~start.written & mask) == 0) continue;
        if (std::fabs(start.text[axis] - text.modal.position.text[axis]) < kSame) unchanged |= mask;
    }
    if (unchanged != targets.written) targets.written &= ~unchanged;
}

void place_axes_feed(const TextView& text, BlockMessages& messages, const Block& block,
                     const WrittenPosition& start, Targets& targets) {
    constexpr SlotMask kFollowers = kTargetSlots & ~SlotMask{kLinearXYZ};
    if (block.feed_of_all_axes == text.tables.rules.feed_of_all_axes ||
        (block.given & kFollowers) == 0)
        return;
    if (text.leads_tip() || text.modal.meant_of(Group::FeedMode) == Function::FeedInverseTime)
        return;
    if (!block.has(Slot::Feed) && !text.modal.has_meant_feed) return;  // that has its message
    double length = 0;                                                 // squares, mm
    double parallel = 0;                                               // of U, V, W
    double turn = 0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if (!block.has(static_cast<Slot>(axis))) continue;
        const std::optional<double> distance = text.meant_distance(block, start, axis);
        if (!distance)
            return messages.position_unknown(block, "F", text.unknown_ends(block, start));
        const bool turns = is_rotary(static_cast<Axis>(axis));
        const double unit = turns && text.modal.units.inch_feed ? kMmPerInch : 1;
        (turns ? turn : axis < 3 ? length : parallel) += *distance * *distance * unit * unit;
    }
    const double all = std::sqrt(length + parallel + turn);
    const double counted = std::sqrt(length > kSame * kSame ? length : parallel);
    if (counted < kSame || all - counted < kSame)
        return;  // where rotary axes are alone, F is theirs
    targets.feed_factor = block.feed_of_all_axes ? counted / all : all / counted;
}

}  // namespace kadr::write
