// Modal codes: what the text has, and what is written again because nobody knows whether it has it.
#include <algorithm>

#include "write/block_writer.h"

namespace kadr::write {

/// Whether a form of the block stands under these dimensions only.
bool BlockWriter::needs_distance(const Block& block, const Choice& choice,
                                 Function distance) const {
    for (std::size_t i = 0; i < block.function_count; ++i) {
        if (!choice.is_open(i)) continue;
        const std::vector<Function>& during = tables_.forms[choice.forms[i]].during;
        if (std::ranges::find(during, distance) != during.end()) return true;
    }
    return false;
}

/// What the text no longer agrees upon with the program: after a conversion, or at the start.
void BlockWriter::restore_modal(const Block& block, const Choice& choice, Items& items) {
    const auto restore = [&](Group group) {
        const Function meant = modal_.meant_of(group);
        if (meant == Function::None || modal_.text_of(group) == meant) return;
        for (std::size_t i = 0; i < block.function_count; ++i) {
            const bool is_done = choice.is_done(i);  // before a line that changed it again
            if (!is_done && info(block.functions[i].function).group == group)
                return;  // the block programs it itself
        }
        add_code(block, meant, items);
    };
    // Modal codes outlive the program on many machines: none ends under G91 that did not mean to.
    const bool is_end = block.find(Fact::EndsProgram) != nullptr;
    const bool acts = is_end || (block.given & kTargetSlots) != 0 ||
                      needs_distance(block, choice, modal_.meant_of(Group::Distance));
    // Words that are written as distances whatever is meant leave the text as it is.
    const bool stays =
        text_.needs_incremental(block) && !needs_distance(block, choice, Function::Absolute);
    if (acts && !stays && !tables_.has_incremental_letters) restore(Group::Distance);
    if (is_arc(text_.effective_motion(block)) && (block.given & (kTargetSlots | kCenterSlots)) != 0)
        restore(Group::Plane);
    if (block.has(Slot::Feed)) restore(Group::FeedMode);
    if (block.has(Slot::Speed) && modal_.has_cutting_speed) restore(Group::SpeedMode);
    if (modal_.doubtful == 0 || (block.given & (kTargetSlots | kCenterSlots)) == 0) return;
    for (std::size_t i = 0; i < kGroups; ++i) {
        const auto group = static_cast<Group>(i);
        if (text_.is_restated(group)) restore(group);
    }
}

/// A cycle has no room for codes, and depends on them: they stand before it. So do those of other
/// functions.
void BlockWriter::say_doubtful(const Block& block, std::string& out) {
    const bool is_cycle = block.find(Function::Cycle) != nullptr;
    Block again;
    again.source = block.source;
    again.skip_level = block.skip_level;
    for (std::size_t i = 0; i < kGroups; ++i) {
        const auto group = static_cast<Group>(i);
        const Function meant = modal_.meant[i];
        // Another plane is another tool axis; a head that leaves it open is no head of ours.
        const bool is_other_plane = group == Group::Plane && meant != Function::None &&
                                    modal_.text[i] != Function::None && modal_.text[i] != meant;
        const bool is_of_cycle =
            is_cycle && modal_.doubtful != 0 && (text_.is_restated(group) || is_other_plane);
        if (is_of_cycle || text_.is_depended_on(block, group)) again.add(meant);
    }
    if (again.function_count != 0) write_block(again, out);
}

}  // namespace kadr::write
