#include "write/cycle_groups.h"

#include <algorithm>
#include <span>
#include <utility>

#include "write/writer.h"

namespace kadr::write {

namespace {

/// Two calls that do the same wherever they stand.
bool are_equal(const Block& a, const Block& b) {
    const Invocation& first = a.functions[0];
    const Invocation& second = b.functions[0];
    if (a.cycle != b.cycle || first.given != second.given || a.cycle_by_form != b.cycle_by_form ||
        a.text != b.text)
        return false;
    for (std::size_t i = 0; i < kMaxArguments; ++i) {
        if (i < 32 && (first.given >> i & 1u) != 0 && a.argument(first, i) != b.argument(second, i))
            return false;
    }
    return true;
}

bool is_plain(const Block& block) {
    return block.kind == Block::Kind::Nc && block.skip_level < 0 && block.number < 0 &&
           block.comment.empty();
}

}  // namespace

bool is_modal_call(const Block& block) {
    return block.function_count > 1 && block.find(Function::Cycle) != nullptr &&
           block.find(Function::CycleModal) != nullptr;
}

CycleGroups::CycleGroups(const Dialect& dialect, const Writer& writer, Put put)
    : tables_(dialect.tables()),
      writer_(writer),
      put_(std::move(put)),
      style_(style_of(dialect)),
      can_open_(tables_.forms_of_cycle.size()) {
    for (std::size_t cycle = 0; cycle < can_open_.size(); ++cycle) {
        const auto& forms = tables_.forms_of_cycle[cycle];
        const auto ends_itself = [&](FormId id) { return !tables_.forms[id].extra.empty(); };
        const bool can_stay = style_ == Style::Behind || std::ranges::all_of(forms, ends_itself);
        can_open_[cycle] =
            style_ != Style::None && !forms.empty() && can_stay && dialect.cycles()[cycle].is_modal;
    }
}

CycleGroups::Style CycleGroups::style_of(const Dialect& dialect) const {
    if (tables_.rules.modal_cycles) return Style::Inside;
    return dialect.can_write(Function::CycleModal) ? Style::Behind : Style::None;
}

/// A move at rapid to a position beside the tool axis, in coordinates.
/// also  slots that may be given besides
bool CycleGroups::is_move(const Block& block, SlotMask also) const {
    if (block.function_count != 0 || block.motion != Function::Rapid || !is_plain(block))
        return false;
    const auto axes = writer_.plane_axes();
    const SlotMask beside = kTargetSlots & ~bit(static_cast<Slot>(axes[2]));
    const SlotMask plane = bit(static_cast<Slot>(axes[0])) | bit(static_cast<Slot>(axes[1]));
    if ((block.given & plane) == 0 || (block.given & ~(beside | also)) != 0) return false;
    if (block.x_measure != nc::XMeasure::Modal || block.rotary_approaches != 0) return false;
    const bool are_coordinates = writer_.means(Group::Distance) == Function::Absolute ||
                                 (block.absolute & block.given) == block.given;
    return are_coordinates && (block.incremental & block.given) == 0;
}

bool CycleGroups::is_call(const Block& block) const {
    return block.function_count == 1 && block.functions[0].function == Function::Cycle &&
           block.given == 0 && block.motion == Function::None && is_plain(block) &&
           can_open_[block.cycle];
}

void CycleGroups::take(const Block& block, std::uint64_t number) {
    if (is_open_ ? take_in_group(block, number) : call_ && take_behind_call(block, number)) return;
    // The feed that stands beside the first position is that of all.
    if (is_move(block, bit(Slot::Feed))) {
        if (move_) put_(move_->block, move_->number);
        move_ = Held{block, number};
    } else if (is_call(block)) {
        call_ = Held{block, number};
    } else {
        if (move_) put_(move_->block, move_->number);
        move_.reset();
        put_(block, number);
    }
}

/// False: the group has ended in front of the block.
bool CycleGroups::take_in_group(const Block& block, std::uint64_t number) {
    if (!next_ && is_move(block)) {
        next_ = Held{block, number};
        return true;
    }
    if (next_ && is_call(block) && are_equal(block, call_->block)) {
        put_position(next_->block, block.source, number);
        next_.reset();
        return true;
    }
    close();
    return false;
}

/// False: no group has begun, and the call has been put.
bool CycleGroups::take_behind_call(const Block& block, std::uint64_t number) {
    if (!next_ && is_move(block)) {
        next_ = Held{block, number};
        return true;
    }
    // Where positions stand behind the cycle, the first one needs a move, too.
    const bool has_first = move_ || style_ == Style::Inside;
    if (next_ && has_first && is_call(block) && are_equal(block, call_->block)) {
        open();
        put_position(next_->block, block.source, number);
        next_.reset();
        return true;
    }
    release();
    return false;
}

/// Where the tool does not stand at the level from which the cycle starts, it goes there above the
/// position: the move stays in front.
void CycleGroups::open() {
    is_open_ = true;
    const bool is_ready = move_ && writer_.is_ready_for(call_->block, move_->block);
    if (move_ && !is_ready) put_(move_->block, move_->number);
    Block modal = call_->block;
    modal.add(Function::CycleModal);
    const bool has_position = is_ready && style_ == Style::Inside;
    if (has_position) {
        modal.given |= move_->block.given;
        modal.absolute |= move_->block.absolute;
        modal.values = move_->block.values;
    }
    put_(modal, call_->number);
    if (style_ == Style::Behind) put_position(move_->block, call_->block.source, call_->number);
    move_.reset();
}

/// What happens there is the cycle: the position is that of the statement which calls it.
void CycleGroups::put_position(const Block& move, SourceId call, std::uint64_t number) {
    Block position = move;
    position.source = call;
    last_ = {call, number};
    if (style_ == Style::Inside) position.motion = Function::None;
    put_(position, number);
}

void CycleGroups::close() {
    Block end;
    end.source = last_.source;
    end.add(Function::CycleModal);
    put_(end, last_.number);
    is_open_ = false;
    call_.reset();
    move_ = std::exchange(next_, std::nullopt);
}

/// The call stays one by itself; a move behind it may belong to another one.
void CycleGroups::release() {
    if (move_) put_(move_->block, move_->number);
    put_(call_->block, call_->number);
    call_.reset();
    move_ = std::exchange(next_, std::nullopt);
}

void CycleGroups::finish() {
    if (is_open_) close();
    else if (call_) release();
    if (move_) put_(move_->block, move_->number);
    move_.reset();
}

bool CycleGroups::holds(std::uint64_t number) const {
    if (is_open_ && last_.number == number) return true;
    return std::ranges::any_of(std::array{&move_, &call_, &next_}, [&](const auto* held) {
        return *held && (*held)->number == number;
    });
}

}  // namespace kadr::write
