#include "write/sections.h"

#include <algorithm>
#include <bit>
#include <span>

namespace kadr::write {

namespace {

bool starts_spindle(const Block& block) {
    return block.find(Function::SpindleCw) != nullptr ||
           block.find(Function::SpindleCcw) != nullptr;
}

/// Whether the work offset could be another thing behind the block than in front of it: what moves,
/// and what changes the systems or the data under it.
bool leaves_offset(const Block& block) {
    if (block.given & kTargetSlots || block.motion != Function::None) return false;
    const auto functions = std::span(block.functions).first(block.function_count);
    return std::ranges::all_of(functions, [](const Invocation& invocation) {
        switch (info(invocation.function).group) {
            case Group::Plane:
            case Group::FeedMode:
            case Group::SpeedMode:
            case Group::Spindle:
            case Group::Coolant:
            case Group::Diameter:
            case Group::PathMode:
            case Group::WorkOffsets: return true;
            default: return false;
        }
    });
}

}  // namespace

void Sections::begin_section() {
    owes_speed_ = owes_position_ = true;
    owes_limit_ = limit_.is_known;
}

void Sections::follow(const Block& block) {
    if (const Invocation* limit = block.find(Function::SpeedLimit)) {
        constexpr std::size_t kLimit = parameter_of<Function::SpeedLimit>("limit");
        limit_ = {limit->has(kLimit), block.argument(*limit, kLimit)};
        owes_limit_ = false;
    }
    if (block.has(Slot::Speed)) owes_speed_ = false;
    has_said_offset_ = has_said_offset_ && leaves_offset(block);
    if ((block.given & (bit(Slot::X) | bit(Slot::Y) | bit(Slot::Z))) != 0) owes_position_ = false;
}

/// A spindle that starts without a speed has the one from before; so has one that a turret has left
/// turning, where the tool begins to cut.
void Sections::complete_speed(const WriterModal& modal, Block& block,
                              std::vector<Block>& before) const {
    const bool cuts = has_fact(block.motion, Fact::Cut) || block.find(Function::Cycle) != nullptr;
    const Function spindle = modal.meant_of(Group::Spindle);
    const bool is_turning =
        nc::code_of_spindle(spindle) != nc::code_of_spindle(Function::SpindleStop);
    if (owes_speed_ && modal.has_meant_speed && !block.has(Slot::Speed)) {
        if (starts_spindle(block)) {
            block.set(Slot::Speed, modal.meant_speed);
        } else if (is_turret_ && cuts && is_turning) {
            Block again;
            again.source = block.source;
            const Function mode = modal.meant_of(Group::SpeedMode);
            if (mode != Function::None) again.add(mode);
            again.add(spindle);
            again.set(Slot::Speed, modal.meant_speed);
            before.push_back(again);
        }
    }
    const bool says_speed = block.has(Slot::Speed) || !before.empty();
    const bool is_cutting_speed = modal.meant_of(Group::SpeedMode) == Function::CuttingSpeedOn ||
                                  block.find(Function::CuttingSpeedOn) != nullptr;
    if (!owes_limit_ || !says_speed || !is_cutting_speed) return;
    Block limit;
    limit.source = block.source;
    limit.set_argument(*limit.add(Function::SpeedLimit, 1),
                       parameter_of<Function::SpeedLimit>("limit"), limit_.value);
    before.insert(before.begin(), limit);
}

/// The first position in the plane has both coordinates: who starts here stands anywhere.
void Sections::complete_position(const WriterModal& modal, std::array<std::size_t, 3> plane,
                                 Block& block, std::vector<Block>& before) const {
    const SlotMask first = bit(static_cast<Slot>(plane[0]));
    const SlotMask second = bit(static_cast<Slot>(plane[1]));
    const SlotMask given = block.given & (first | second);
    const SlotMask across = bit(static_cast<Slot>(plane[2]));
    const SlotMask both = SlotMask{1} << plane[0] | SlotMask{1} << plane[1];
    if (owes_position_ && given == 0 && block.has(static_cast<Slot>(plane[2])) &&
        (block.incremental & across) == 0 && (modal.position.known & both) == both &&
        modal.meant_of(Group::Distance) == Function::Absolute && block.function_count == 0) {
        // Down, or up, above the position at which the whole does it.
        Block position;
        position.source = block.source;
        position.motion = Function::Rapid;
        for (const std::size_t axis : {plane[0], plane[1]})
            position.set(static_cast<Slot>(axis), modal.position.meant[axis]);
        before.push_back(position);
        return;
    }
    const bool is_straight = block.motion == Function::Rapid || block.motion == Function::Line;
    if (!owes_position_ || std::popcount(given) != 1 || !is_straight || block.function_count != 0)
        return;
    const bool is_coordinate =
        (block.incremental & given) == 0 && modal.meant_of(Group::Distance) == Function::Absolute;
    const std::size_t other = plane[given == first ? 1 : 0];
    if (!is_coordinate || (modal.position.known >> other & 1u) == 0) return;
    block.set(static_cast<Slot>(other), modal.position.meant[other]);
}

/// The offset that stands in the line above already.
void Sections::drop_offset(const WriterModal& modal, Block& block) {
    constexpr std::size_t kNumber = parameter_of<Function::WorkOffset>("number");
    const Invocation* offset = block.find(Function::WorkOffset);
    if (offset == nullptr || !modal.work_offset.is_known ||
        modal.work_offset.value != block.argument(*offset, kNumber))
        return;
    const auto at = offset - block.functions.data();
    std::shift_left(block.functions.begin() + at, block.functions.begin() + block.function_count,
                    1);
    --block.function_count;
}

void Sections::complete(const WriterModal& modal, std::array<std::size_t, 3> plane, Block& block,
                        std::vector<Block>& before) {
    if (block.kind != Block::Kind::Nc || block.skip_level >= 0) return;
    if (has_said_offset_) drop_offset(modal, block);
    complete_speed(modal, block, before);
    complete_position(modal, plane, block, before);
}

}  // namespace kadr::write
