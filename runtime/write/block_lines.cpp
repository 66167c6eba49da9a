// The lines of a block: their pieces, what stands apart from them, and the words of a tool change
// that come with them.
#include <algorithm>

#include "base/numbers.h"
#include "base/text.h"
#include "write/block_writer.h"
#include "write/cycle_groups.h"

namespace kadr::write {

void BlockWriter::collect_slots(const Block& block, const Choice& choice, const Targets& targets,
                                Items& items) {
    const SlotMask scalars = bit(Slot::Turns) | bit(Slot::Feed) | bit(Slot::Speed) | kReadSlots;
    for (const Slot slot : tables_.slot_order) {
        const SlotMask mask = bit(slot);
        const bool is_target = (targets.written & mask) != 0;
        if (!is_target && (block.given & mask & scalars) == 0) continue;
        const bool may_stand = !options_.verbose_modal;
        if (slot == Slot::Feed && may_stand && !modal_.units.inverse_time &&
            text_.is_standing(slot, block.at(slot) * targets.feed_factor, modal_.feed)) {
            continue;
        }
        if (slot == Slot::Speed && may_stand &&
            text_.is_standing(slot, block.at(slot), modal_.speed)) {
            // The start of a spindle shows its speed, even if it is the old one.
            const bool starts = block.find(Function::SpindleCw) != nullptr ||
                                block.find(Function::SpindleCcw) != nullptr;
            if (!starts) continue;
        }
        items.add(Item::of_slot(text_.address_of(slot).order, slot));
    }
    for (std::size_t slot = 0; slot < kSlots; ++slot) {
        if (block.has(static_cast<Slot>(slot)) && tables_.slot_address[slot] == kNoAddress &&
            (scalars >> slot & 1u) != 0) {
            messages_.cannot_express(block,
                                     '`' + std::string(slot_name(static_cast<Slot>(slot))) + '`');
        }
    }
    if (repeats_feed(block, choice, targets)) {
        items.add(Item::of_slot(text_.address_of(Slot::Feed).order, Slot::Feed));
    }
}

/// Where F is not modal, every block at feed repeats it; where F was the pitch of a thread or one
/// of a helix, the first one behind it does; and so does a helix that needs an F of its own.
bool BlockWriter::repeats_feed(const Block& block, const Choice& choice,
                               const Targets& targets) const {
    const bool is_own = targets.feed_factor != 1;
    if (!text_.feed_word.every_block && !modal_.feed_is_other && !is_own) return false;
    if (!text_.has_address(Slot::Feed) || block.has(Slot::Feed) || !modal_.has_meant_feed)
        return false;
    const bool has_words = (block.given & (kTargetSlots | kCenterSlots)) != 0;
    const Function motion = text_.effective_motion(block);
    const bool is_cut = has_fact(motion, Fact::Cut);
    if (has_words && is_cut) {
        const double feed = modal_.meant_feed * targets.feed_factor;
        return text_.feed_word.every_block || !text_.is_standing(Slot::Feed, feed, modal_.feed);
    }
    const Invocation* cycle = block.find(Function::Cycle);
    // A call stands alone in its line: F has come before it.
    return modal_.feed_is_other && cycle != nullptr && !has_feed_word(block, choice, *cycle) &&
           !is_call(choice, block, *cycle);
}

/// Whether the cycle is written as a call, `CYCLE83(…)`.
bool BlockWriter::is_call(const Choice& choice, const Block& block, const Invocation& cycle) const {
    const FormId id = choice.forms[static_cast<std::size_t>(&cycle - block.functions.data())];
    return id != kNoForm && tables_.forms[id].words[0].kind == FormWord::Kind::Call;
}

/// Whether the cycle has its F in a word of its own: its pitch, mostly.
bool BlockWriter::has_feed_word(const Block& block, const Choice& choice,
                                const Invocation& cycle) const {
    const FormId id = choice.forms[static_cast<std::size_t>(&cycle - block.functions.data())];
    if (id == kNoForm) return false;
    return text_.has_feed_word(tables_.forms[id]);
}

/// Words that a tool change left for the block that moves the tool axis, or programs a function.
void BlockWriter::add_deferred(const Block& block, const Choice& choice, Items& items) {
    if (state_.pending().empty() && !modal_.edge.is_end_due) return;
    const bool is_cycle = block.function_count != 0 && block.find(Function::Cycle) != nullptr;
    const bool is_machine = block.find(Fact::AtMachinePosition) != nullptr;
    const Function length =
        block.function_count == 0 ? Function::None : programmed_in(block, Group::LengthComp);
    if (modal_.edge.is_end_due && length == Function::None && !is_machine &&
        (block.has(Slot::Z) || is_cycle)) {
        add_code(block, Function::LengthCompOff, items);
        state_.length_is_given(Function::LengthCompOff);
    }
    for (std::size_t i = 0; i < state_.pending().size();) {
        const Deferred& deferred = *state_.pending()[i].deferred;
        bool acts = false;
        if (deferred.axis >= 0 && !is_machine && length != Function::LengthCompOff)
            acts = block.has(static_cast<Slot>(deferred.axis)) || is_cycle;
        for (const Function function : deferred.functions) acts |= block.find(function) != nullptr;
        if (deferred.axis < 0) acts &= block.find(Function::RadiusOffset) == nullptr;
        if (!acts) {
            ++i;
            continue;
        }
        words_.set_held_offset(own_offset(choice, state_.pending()[i], block));
        remove_given(tables_, deferred, items);
        items.add(
            Item::of_words(tables_.addresses[deferred.words[0].address].order, deferred.words));
        // Functions may come again for the same tool; an axis word acts once.
        if (deferred.axis >= 0) {
            state_.length_is_given(Function::LengthCompOn);
            state_.drop_pending(i);
        } else {
            ++i;
        }
    }
}

/// The offset of held-back words: the tool's, unless the block has a word of its own for it, as
/// `H5` is for `G43 H{tool}`.
double BlockWriter::own_offset(const Choice& choice, const Pending& pending,
                               const Block& block) const {
    const AddressId offset = pending.deferred->words.back().address;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        if (choice.forms[i] == kNoForm) continue;
        for (const FormWord& word : tables_.forms[choice.forms[i]].words) {
            if (word.parameter < 0 || word.address != offset) continue;
            const auto parameter = static_cast<std::size_t>(word.parameter);
            const Invocation& invocation = block.functions[i];
            if ((invocation.given >> parameter & 1u) != 0)
                return block.argument(invocation, parameter);
        }
    }
    return pending.tool;
}

void BlockWriter::write_items(const Block& block, Items& items, const Targets& targets,
                              std::string& out) {
    if (items.is_full) messages_.cannot_express(block, "so many words in one block");
    // A comment that is too long to stand behind the block stands before it, as does that of a line
    // which is read letter by letter.
    const std::size_t most = tables_.comment.max_length;
    const bool is_verbatim = std::ranges::any_of(items.all(), [&](const Item& item) {
        return item.form != kNoForm && tables_.forms[item.form].is_verbatim;
    });
    const bool fits = !is_verbatim && (most == 0 || count_code_points(block.comment) <= most);
    if (!fits && !block.comment.empty()) lines_.write_comment(block.comment, out);
    check_takers(tables_, messages_, block, items);
    const LineChoices choices = line_choices_of(tables_, messages_, block, items);
    const bool has_all = std::ranges::all_of(std::span(choices).first(items.count),
                                             [](LineChoice p) { return p == LineChoice::Here; });
    if (!has_all) write_apart(block, items, choices, false, out);
    lines_.open(block.skip_level, true, out);
    // Where the cycle is called, an operator reads behind its code, before its depth.
    const bool has_position = (block.given & kTargetSlots) != 0 && is_modal_call(block);
    const auto is_position = [&](const Item& item) {
        return has_position && words_of(tables_, item) == nullptr &&
               (bit(item.slot) & kTargetSlots) != 0;
    };
    for (std::size_t i = 0; i < items.count; ++i) {
        const Item& item = items.list[i];
        if (choices[i] != LineChoice::Here || is_position(item)) continue;
        const bool is_cycle = has_position && item.form != kNoForm &&
                              tables_.forms[item.form].function == Function::Cycle;
        if (!is_cycle) {
            words_.append_item(block, item, targets, out);
            continue;
        }
        const std::span<const FormWord> words = tables_.forms[item.form].words;
        words_.append_words(block, words.first(1), item.invocation, false, out);
        for (const Item& position : items.all())
            if (is_position(position)) words_.append_item(block, position, targets, out);
        words_.append_words(block, words.subspan(1), item.invocation, false, out);
    }
    lines_.end_block(out);
    if (!block.comment.empty() && fits) lines_.append_comment(block.comment, out);
    lines_.close(out);
    for (std::size_t i = 0; i < items.count; ++i) {
        const Item& item = items.list[i];
        if (item.form == kNoForm || choices[i] != LineChoice::Here) continue;
        const Form& form = tables_.forms[item.form];
        // They end a modal cycle, which goes on.
        if (form.function == Function::Cycle && is_modal_call(block)) continue;
        write_further_lines(form, block, item.invocation, out);
    }
    if (!has_all) write_apart(block, items, choices, true, out);
}

void BlockWriter::write_further_lines(const Form& form, const Block& block,
                                      const Invocation* invocation, std::string& out) {
    for (const std::vector<FormWord>& line : form.extra) {
        lines_.open(block.skip_level, true, out);
        words_.append_words(block, line, invocation, false, out);
        lines_.end_block(out);
        lines_.close(out);
        note_line(line);
    }
}

/// The words that stand in lines before the block's, or behind it.
void BlockWriter::write_apart(const Block& block, const Items& items, const LineChoices& choices,
                              bool is_behind, std::string& out) {
    Items apart;
    for (std::size_t i = 0; i < items.count; ++i) {
        if (choices[i] == (is_behind ? LineChoice::Behind : LineChoice::Before))
            apart.add(items.list[i]);
    }
    if (apart.count == 0) return;
    Block rest;
    rest.skip_level = block.skip_level;
    rest.source = block.source;
    rest.text = block.text;
    rest.arguments = block.arguments;
    write_items(rest, apart, {}, out);
}

/// Codes that stand in a form's further lines change the state of the text, too.
void BlockWriter::note_line(const std::vector<FormWord>& words) {
    for (const FormWord& word : words) {
        if (word.kind != FormWord::Kind::Fixed || word.is_quantity) continue;
        const CodeStart* code = tables_.find_code(word.address, word.number);
        if (code != nullptr && code->simple != kNoForm) state_.say(tables_.forms[code->simple]);
    }
}

}  // namespace kadr::write
