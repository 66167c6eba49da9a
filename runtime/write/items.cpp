#include "write/items.h"

#include <algorithm>
#include <string>

namespace kadr::write {

namespace {

/// What a line has: words by address, groups of which it has a function.
struct LineRoom {
    std::array<std::uint8_t, 256> words{};
    std::array<bool, 256> is_closed{};  // a code that stands alone among its address is there
    std::uint64_t groups = 0;

    std::size_t index_of(const FormWord& word) const { return word.address % words.size(); }
};

/// Whether a line takes an item beside those that it has.
enum class ItemFit : std::uint8_t {
    Fits,
    Waits,    // a control that takes one M a block gets the others in lines of their own
    Refused,  // in one line the control would raise an alarm or drop the first, and a line further
              // on it would act behind the motion
};

/// The form's words that a line has to have room for; null: it takes any number of such items.
const std::vector<FormWord>* counted_words(const DialectTables& tables, const Item& item) {
    const bool is_comment = item.form != kNoForm && tables.forms[item.form].is_comment;
    return is_comment ? nullptr : words_of(tables, item);
}

bool is_written(const Item& item, const FormWord& word) {
    return word.address != kNoAddress &&
           (word.parameter < 0 || word.has_default || item.invocation == nullptr ||
            (item.invocation->given >> word.parameter & 1u) != 0);
}

ItemFit fit_of(const DialectTables& tables, const Item& item, const LineRoom& room) {
    const std::vector<FormWord>* const words = counted_words(tables, item);
    if (words == nullptr) return ItemFit::Fits;
    const std::uint64_t groups = item.form != kNoForm ? tables.forms[item.form].excludes : 0;
    bool is_taken = (room.groups & groups) != 0;
    bool may_wait = !is_taken;
    const bool is_alone = item.form != kNoForm && tables.forms[item.form].owns_address;
    for (const FormWord& word : *words) {
        if (!is_written(item, word)) continue;
        const Address& address = tables.addresses[word.address];
        const std::size_t index = room.index_of(word);
        const int most = is_alone ? 1 : std::max<int>(address.write_max, 1);
        if (room.words[index] < most && !room.is_closed[index]) continue;
        is_taken = true;
        may_wait &= address.kind == Address::Kind::Code;
    }
    if (!is_taken) return ItemFit::Fits;
    return may_wait ? ItemFit::Waits : ItemFit::Refused;
}

void count_words(const DialectTables& tables, const Item& item, LineRoom& room) {
    const std::vector<FormWord>* const words = counted_words(tables, item);
    if (words == nullptr) return;
    if (item.form != kNoForm) room.groups |= tables.forms[item.form].excludes;
    const bool is_alone = item.form != kNoForm && tables.forms[item.form].owns_address;
    for (const FormWord& word : *words) {
        if (!is_written(item, word)) continue;
        ++room.words[room.index_of(word)];
        room.is_closed[room.index_of(word)] |= is_alone;
    }
}

/// Whether the code that the piece begins with would take the word of the other form, with its own
/// form or another one of the code.
bool takes_word(const DialectTables& tables, const Item& item, const Form& other,
                const FormWord& word) {
    if (item.form == kNoForm || tables.forms[item.form].words.empty()) return false;
    const Form& form = tables.forms[item.form];
    // An offset beside the compensation that it belongs to: `G43 H1` is read as both.
    const Group group = info(form.function).group;
    const bool is_its_offset =
        (other.function == Function::LengthOffset && group == Group::LengthComp) ||
        (other.function == Function::RadiusOffset && group == Group::RadiusComp);
    const FormWord& head = form.words[0];
    if (is_its_offset || head.kind != FormWord::Kind::Fixed) return false;
    const CodeStart* code = tables.find_code(head.address, head.number);
    if (code == nullptr) return false;
    return std::ranges::any_of(code->forms, [&](FormId id) {
        const std::vector<FormWord>& words = tables.forms[id].words;
        return std::ranges::any_of(words.begin() + 1, words.end(), [&](const FormWord& taken) {
            return taken.address == word.address;
        });
    });
}

}  // namespace

const std::vector<FormWord>* words_of(const DialectTables& tables, const Item& item) {
    if (item.form != kNoForm) return &tables.forms[item.form].words;
    if (item.edge < 0) return item.words;
    const auto& edges = tables.forms_of[static_cast<std::size_t>(Function::ToolEdge)];
    return &tables.forms[edges[0]].words;
}

void remove_given(const DialectTables& tables, const Deferred& deferred, Items& items) {
    const auto is_given = [&](const Item& item) {
        if (item.form == kNoForm) return false;
        const std::vector<FormWord>& own = tables.forms[item.form].words;
        return std::ranges::all_of(own, [&](const FormWord& word) {
            return std::ranges::any_of(deferred.words, [&](const FormWord& other) {
                return word.address == other.address && word.kind == other.kind &&
                       word.number == other.number;
            });
        });
    };
    const auto end =
        std::remove_if(items.list.begin(),
                       items.list.begin() + static_cast<std::ptrdiff_t>(items.count), is_given);
    items.count = static_cast<std::size_t>(end - items.list.begin());
}

LineChoices line_choices_of(const DialectTables& tables, BlockMessages& messages,
                            const Block& block, const Items& items) {
    LineChoices choices{};
    LineRoom room;
    for (const Item& item : items.all()) {
        if (words_of(tables, item) != nullptr) continue;
        ++room.words[tables.slot_address[static_cast<std::size_t>(item.slot)] % room.words.size()];
    }
    const auto stops = [&](const Item& item) {
        return item.form != kNoForm &&
               has_fact(tables.forms[item.form].function, Fact::StopsProgram);
    };
    const bool moves = (block.given & (kTargetSlots | kCenterSlots)) != 0 ||
                       (block.function_count != 0 && block.find(Function::Cycle) != nullptr);
    for (const bool is_stop : {false, true}) {
        for (std::size_t i = 0; i < items.count; ++i) {
            const Item& item = items.list[i];
            if (stops(item) != is_stop) continue;
            const ItemFit fit = fit_of(tables, item, room);
            if (fit == ItemFit::Waits) {
                choices[i] = moves && !is_stop ? LineChoice::Before : LineChoice::Behind;
                continue;
            }
            if (fit == ItemFit::Refused) {
                const std::string what =
                    item.form != kNoForm ? std::string(info(tables.forms[item.form].function).name)
                                         : "H or D";
                messages.cannot_express(block,
                                        '`' + what + "` and the rest of the block in one line");
            }
            count_words(tables, item, room);
            choices[i] = LineChoice::Here;
        }
    }
    return choices;
}

void check_takers(const DialectTables& tables, BlockMessages& messages, const Block& block,
                  const Items& items) {
    for (const Item& item : items.all()) {
        if (item.form == kNoForm || item.invocation == nullptr) continue;
        const Form& form = tables.forms[item.form];
        for (const FormWord& word : form.words) {
            if (word.kind != FormWord::Kind::Value) continue;
            const bool is_written =
                word.has_default || (item.invocation->given >> word.parameter & 1u) != 0;
            if (!is_written) continue;
            for (const Item& other : items.all()) {
                if (&other == &item || !takes_word(tables, other, form, word)) continue;
                std::string both(1, '`');
                both += info(tables.forms[other.form].function).name;
                both.append("` and `").append(info(form.function).name).append("` in one line");
                messages.cannot_express(block, both);
            }
        }
    }
}

}  // namespace kadr::write
