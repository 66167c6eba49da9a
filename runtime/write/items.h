// items.h — what a line has: its pieces in their order, and which of them it has room for.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "write/messages.h"

namespace kadr::write {

/// One piece of a line: a form with its parameters, deferred words, or the word of a slot.
struct Item {
    int order;
    FormId form;  // kNoForm: the words, the edge, or the slot
    Slot slot;
    const Invocation* invocation;
    const std::vector<FormWord>* words;
    int edge;  // a cutting edge that the writer sets itself; -1 none

    static Item of_form(int order, FormId form, const Invocation* invocation) {
        return {order, form, Slot::X, invocation, nullptr, -1};
    }
    static Item of_words(int order, const std::vector<FormWord>& words) {
        return {order, kNoForm, Slot::X, nullptr, &words, -1};
    }
    static Item of_slot(int order, Slot slot) {
        return {order, kNoForm, slot, nullptr, nullptr, -1};
    }
    static Item of_edge(int order, int edge) {
        return {order, kNoForm, Slot::X, nullptr, nullptr, edge};
    }
};
/// The pieces of a line in their order; among equals the first comes first. Not initialised,
/// because every block that goes the long path has one.
struct Items {
    static constexpr std::size_t kMost = 96;
    std::array<Item, kMost> list;
    std::size_t count = 0;
    bool is_full = false;  // a piece found no room

    void add(const Item& item) {
        is_full |= count == kMost;
        if (is_full) return;
        std::size_t at = count++;
        for (; at > 0 && list[at - 1].order > item.order; --at) list[at] = list[at - 1];
        list[at] = item;
    }
    std::span<const Item> all() const { return {list.data(), count}; }
};

/// The words of a piece that are not the word of a slot; nullptr: there are none.
const std::vector<FormWord>* words_of(const DialectTables& tables, const Item& item);

/// Held-back words stand for the codes and offsets that the block has in words of its own.
void remove_given(const DialectTables& tables, const Deferred& deferred, Items& items);

enum class LineChoice : std::uint8_t { Here, Before, Behind };  // the line of the block
using LineChoices = std::array<LineChoice, Items::kMost>;

/// Where the words of a block stand: what its line has no room for stands in lines of its own, a
/// stop or an end behind it, anything else in front of a motion, since it acts before that.
///
/// source       F 1.3, S 1.5
LineChoices line_choices_of(const DialectTables& tables, BlockMessages& messages,
                            const Block& block, const Items& items);

/// A number that belongs to one code of the line must not be read as another's: in `G54 G30 P3` the
/// control would find an additional work offset, and the second reference point.
void check_takers(const DialectTables& tables, BlockMessages& messages, const Block& block,
                  const Items& items);

}  // namespace kadr::write
