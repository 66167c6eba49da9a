// Words of a line: in their order, with their numbers.
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/diagnostics/dialect.h"
#include "base/text.h"
#include "nc/comment_text.h"
#include "write/block_writer.h"

namespace kadr::write {

void BlockWriter::collect_slots(const Block& block, const Targets& targets, Items& items) {
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
    if (repeats_feed(block, targets)) {
        items.add(Item::of_slot(text_.address_of(Slot::Feed).order, Slot::Feed));
    }
}

/// Where F is not modal, every block at feed repeats it; where F was the pitch of a thread or one
/// of a helix, the first one behind it does; and so does a helix that needs an F of its own.
bool BlockWriter::repeats_feed(const Block& block, const Targets& targets) const {
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
    return modal_.feed_is_other && cycle != nullptr && !has_feed_word(block, *cycle);
}

/// Whether the cycle has its F in a word of its own: its pitch, mostly.
bool BlockWriter::has_feed_word(const Block& block, const Invocation& cycle) const {
    const FormId id = chosen_[static_cast<std::size_t>(&cycle - block.functions.data())];
    if (id == kNoForm) return false;
    const Form& form = tables_.forms[id];
    const auto is_feed = [&](const FormWord& word) {
        return word.kind == FormWord::Kind::Value &&
               tables_.addresses[word.address].slot == static_cast<int>(Slot::Feed);
    };
    return std::ranges::any_of(form.words, is_feed) || std::ranges::any_of(form.lead, is_feed);
}

/// Words that a tool change left for the block that moves the tool axis, or says a function.
void BlockWriter::add_deferred(const Block& block, Items& items) {
    if (state_.pending().empty()) return;
    const bool is_cycle = block.function_count != 0 && block.find(Function::Cycle) != nullptr;
    const bool is_machine = block.find(Fact::AtMachinePlace) != nullptr;
    for (std::size_t i = 0; i < state_.pending().size();) {
        const Deferred& deferred = *state_.pending()[i].deferred;
        bool acts = false;
        if (deferred.axis >= 0 && !is_machine)
            acts = block.has(static_cast<Slot>(deferred.axis)) || is_cycle;
        for (const Function function : deferred.functions) acts |= block.find(function) != nullptr;
        if (deferred.axis < 0) acts &= block.find(Function::RadiusOffset) == nullptr;
        if (!acts) {
            ++i;
            continue;
        }
        deferred_tool_ = own_offset(state_.pending()[i], block);
        remove_said(deferred, items);
        items.add(
            Item::of_words(tables_.addresses[deferred.words[0].address].order, deferred.words));
        // Functions may come again for the same tool; an axis word acts once.
        if (deferred.axis >= 0) {
            state_.drop_pending(i);
        } else {
            ++i;
        }
    }
}

/// Held-back words stand for the codes and offsets that the block has in words of its own.
void BlockWriter::remove_said(const Deferred& deferred, Items& items) const {
    const auto is_said = [&](const Item& item) {
        if (item.form == kNoForm) return false;
        const std::vector<FormWord>& own = tables_.forms[item.form].words;
        return std::ranges::all_of(own, [&](const FormWord& word) {
            return std::ranges::any_of(deferred.words, [&](const FormWord& other) {
                return word.address == other.address && word.kind == other.kind &&
                       word.number == other.number;
            });
        });
    };
    const auto end = std::remove_if(
        items.list.begin(), items.list.begin() + static_cast<std::ptrdiff_t>(items.count), is_said);
    items.count = static_cast<std::size_t>(end - items.list.begin());
}

/// The offset of held-back words: the tool's, unless the block has a word of its own for it, as
/// `H5` is for `G43 H{tool}`.
double BlockWriter::own_offset(const Pending& pending, const Block& block) const {
    const AddressId offset = pending.deferred->words.back().address;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        if (chosen_[i] == kNoForm) continue;
        for (const FormWord& word : tables_.forms[chosen_[i]].words) {
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
    check_takers(block, items);
    Places places{};
    const bool has_all = find_places(block, items, places);
    if (!has_all) write_apart(block, items, places, false, out);
    lines_.open(block.skip, true, out);
    for (std::size_t i = 0; i < items.count; ++i) {
        if (places[i] == Place::Here) append_item(block, items.list[i], targets, out);
    }
    lines_.end_block(out);
    if (!block.comment.empty() && fits) lines_.append_comment(block.comment, out);
    lines_.close(out);
    for (std::size_t i = 0; i < items.count; ++i) {
        const Item& item = items.list[i];
        if (item.form == kNoForm || places[i] != Place::Here) continue;
        for (const std::vector<FormWord>& line : tables_.forms[item.form].extra) {
            lines_.open(block.skip, true, out);
            append_words(block, line, item.invocation, false, out);
            lines_.end_block(out);
            lines_.close(out);
            note_line(line);
        }
    }
    if (!has_all) write_apart(block, items, places, true, out);
}

/// Where the words of a block stand: what its line has no room for stands in lines of its own, a
/// stop or an end behind it, anything else in front of a motion, since it acts before that. True:
/// the line has room for all.
///
/// source       F 1.3, S 1.5
bool BlockWriter::find_places(const Block& block, const Items& items, Places& places) {
    LineRoom room;
    for (const Item& item : items.all()) {
        if (words_of(item) != nullptr) continue;
        ++room.words[tables_.slot_address[static_cast<std::size_t>(item.slot)] % room.words.size()];
    }
    const auto stops = [&](const Item& item) {
        return item.form != kNoForm &&
               has_fact(tables_.forms[item.form].function, Fact::StopsProgram);
    };
    const bool moves = (block.given & (kTargetSlots | kCenterSlots)) != 0 ||
                       (block.function_count != 0 && block.find(Function::Cycle) != nullptr);
    bool has_all = true;
    for (const bool is_stop : {false, true}) {
        for (std::size_t i = 0; i < items.count; ++i) {
            const Item& item = items.list[i];
            if (stops(item) != is_stop) continue;
            const bool has_place = take_room(block, item, room);
            places[i] = has_place ? Place::Here : moves && !is_stop ? Place::Before : Place::Behind;
            has_all &= has_place;
        }
    }
    return has_all;
}

/// The words that stand in lines before the block's, or behind it.
void BlockWriter::write_apart(const Block& block, const Items& items, const Places& places,
                              bool is_behind, std::string& out) {
    Items apart;
    for (std::size_t i = 0; i < items.count; ++i) {
        if (places[i] == (is_behind ? Place::Behind : Place::Before)) apart.add(items.list[i]);
    }
    if (apart.count == 0) return;
    Block rest;
    rest.skip = block.skip;
    rest.source = block.source;
    rest.text = block.text;
    rest.arguments = block.arguments;
    write_items(rest, apart, {}, out);
}

/// Counts the item's words. False: the line does not take it beside those that it has. A control
/// that takes one M a block gets the others in lines of their own. What else does not go together
/// is an error: in one line the control would raise an alarm or drop the first, and a line further
/// on it would act behind the motion.
bool BlockWriter::take_room(const Block& block, const Item& item, LineRoom& room) {
    if (words_of(item) == nullptr) return true;
    const Form* form = item.form == kNoForm ? nullptr : &tables_.forms[item.form];
    if (form != nullptr && form->is_comment) return true;
    const std::vector<FormWord>& words = *words_of(item);
    const std::uint64_t groups = form != nullptr ? form->excludes : 0;
    bool is_taken = (room.groups & groups) != 0;
    bool may_wait = !is_taken;
    const auto count_of = [&](const FormWord& word) -> std::uint8_t& {
        return room.words[word.address % room.words.size()];
    };
    const auto is_written = [&](const FormWord& word) {
        return word.address != kNoAddress &&
               (word.parameter < 0 || word.has_default || item.invocation == nullptr ||
                (item.invocation->given >> word.parameter & 1u) != 0);
    };
    for (const FormWord& word : words) {
        const Address* address = is_written(word) ? &tables_.addresses[word.address] : nullptr;
        if (address == nullptr || count_of(word) < std::max<int>(address->write_max, 1)) continue;
        is_taken = true;
        may_wait &= address->kind == Address::Kind::Code;
    }
    if (is_taken && may_wait) return false;
    if (is_taken) {
        const std::string what =
            form != nullptr ? std::string(info(form->function).name) : "H or D";
        messages_.cannot_express(block, '`' + what + "` and the rest of the block in one line");
    }
    room.groups |= groups;
    for (const FormWord& word : words) {
        if (is_written(word)) ++count_of(word);
    }
    return true;
}

/// The words of a piece that are not the word of a slot; nullptr: there are none.
const std::vector<FormWord>* BlockWriter::words_of(const Item& item) const {
    if (item.form != kNoForm) return &tables_.forms[item.form].words;
    if (item.edge < 0) return item.words;
    const auto& edges = tables_.forms_of[static_cast<std::size_t>(Function::ToolEdge)];
    return &tables_.forms[edges[0]].words;
}

/// A number that belongs to one code of the line must not be read as another's: in `G54 G30 P3` the
/// control would find an additional work offset, and the second reference point.
void BlockWriter::check_takers(const Block& block, const Items& items) {
    for (const Item& item : items.all()) {
        if (item.form == kNoForm || item.invocation == nullptr) continue;
        const Form& form = tables_.forms[item.form];
        for (const FormWord& word : form.words) {
            if (word.kind != FormWord::Kind::Value) continue;
            const bool is_written =
                word.has_default || (item.invocation->given >> word.parameter & 1u) != 0;
            if (!is_written) continue;
            for (const Item& other : items.all()) {
                if (&other == &item || !takes_word(other, form, word)) continue;
                std::string both(1, '`');
                both += info(tables_.forms[other.form].function).name;
                both.append("` and `").append(info(form.function).name).append("` in one line");
                messages_.cannot_express(block, both);
            }
        }
    }
}

/// Whether the code that the piece begins with would take the word of the other form, with its own
/// form or another one of the code.
bool BlockWriter::takes_word(const Item& item, const Form& other, const FormWord& word) const {
    if (item.form == kNoForm || tables_.forms[item.form].words.empty()) return false;
    const Form& form = tables_.forms[item.form];
    // An offset beside the compensation that it belongs to: `G43 H1` is read as both.
    const Group group = info(form.function).group;
    const bool is_its_offset =
        (other.function == Function::LengthOffset && group == Group::LengthComp) ||
        (other.function == Function::RadiusOffset && group == Group::RadiusComp);
    const FormWord& head = form.words[0];
    if (is_its_offset || head.kind != FormWord::Kind::Fixed) return false;
    const Code* code = tables_.find_code(head.address, head.number);
    if (code == nullptr) return false;
    return std::ranges::any_of(code->forms, [&](FormId id) {
        const std::vector<FormWord>& words = tables_.forms[id].words;
        return std::ranges::any_of(words.begin() + 1, words.end(), [&](const FormWord& taken) {
            return taken.address == word.address;
        });
    });
}

/// Codes that stand in a form's further lines change the state of the text, too.
void BlockWriter::note_line(const std::vector<FormWord>& words) {
    for (const FormWord& word : words) {
        if (word.kind != FormWord::Kind::Fixed || word.is_quantity) continue;
        const Code* code = tables_.find_code(word.address, word.number);
        if (code != nullptr && code->simple != kNoForm) state_.say(tables_.forms[code->simple]);
    }
}

void BlockWriter::append_item(const Block& block, const Item& item, const Targets& targets,
                              std::string& out) {
    if (item.form != kNoForm) {
        const Form& form = tables_.forms[item.form];
        blank(out);
        if (form.is_verbatim) {
            append_verbatim(block, form, *item.invocation, out);
        } else if (form.is_comment) {
            out += tables_.comment.open;
            out += form.words[0].text;
            out += comment_text(block.text, tables_.comment);
            out += tables_.comment.close;
        } else {
            append_words(block, form.words, item.invocation, form.remembers, out);
        }
        return;
    }
    if (item.edge >= 0) return append_edge(block, item.edge, out);
    if (item.words != nullptr) {
        blank(out);
        append_words(block, *item.words, nullptr, false, out);
        return;
    }
    append_slot(block, item.slot, targets, out);
}

/// A line of the control's own language: letters as they are, numbers as in arguments.
void BlockWriter::append_verbatim(const Block& block, const Form& form,
                                  const Invocation& invocation, std::string& out) {
    const NumberFormat format = argument_format(tables_);
    for (const FormWord& word : form.words) {
        if (word.is_quantity) {
            append_quantity(block, word, format, "()", out);
            continue;
        }
        out += word.text;
        if (word.parameter >= 0) append_parameter(block, word, &invocation, format, "()", out);
    }
}

void BlockWriter::append_edge(const Block& block, int edge, std::string& out) {
    const Form& form =
        tables_.forms[tables_.forms_of[static_cast<std::size_t>(Function::ToolEdge)][0]];
    Block words;
    words.source = block.source;
    Invocation* invocation = words.add(Function::ToolEdge, 1);
    words.set_argument(*invocation, parameter_of<Function::ToolEdge>("edge"), edge);
    append_words(words, form.words, invocation, false, out);
}

void BlockWriter::append_words(const Block& block, const std::vector<FormWord>& words,
                               const Invocation* invocation, bool remembers, std::string& out) {
    // Of words that keep their value, only those that change are written; one at least.
    std::uint32_t unchanged = 0;
    std::size_t values = 0;
    for (const FormWord& word : words) {
        if (!remembers || word.parameter < 0 || invocation == nullptr) continue;
        ++values;
        const auto parameter = static_cast<std::size_t>(word.parameter);
        const double value = block.argument(*invocation, parameter, word.fallback);
        const Standing& kept = modal_.frame.shift[parameter % modal_.frame.shift.size()];
        if (kept.is_known && kept.value == value) unchanged |= 1u << word.parameter;
        state_.say_shift(parameter, value);
    }
    const bool writes_all = values == static_cast<std::size_t>(std::popcount(unchanged));
    for (const FormWord& word : words) {
        if (!writes_all && word.parameter >= 0 && (unchanged >> word.parameter & 1u) != 0) continue;
        append_word(block, word, invocation, out);
    }
}

void BlockWriter::append_word(const Block& block, const FormWord& word,
                              const Invocation* invocation, std::string& out) {
    switch (word.kind) {
        case FormWord::Kind::Fixed:
            if (word.is_quantity) {
                blank(out);
                append_quantity(block, word, tables_.addresses[word.address].format,
                                tables_.addresses[word.address].name, out);
                break;
            }
            [[fallthrough]];
        case FormWord::Kind::Name:
            blank(out);
            out += word.text;
            break;
        case FormWord::Kind::Call: append_call(block, word, invocation, out); break;
        case FormWord::Kind::Value:
        case FormWord::Kind::Quoted: {
            const auto parameter = static_cast<std::size_t>(word.parameter);
            const bool is_quoted = word.kind == FormWord::Kind::Quoted;
            const bool is_given = invocation == nullptr ||
                                  (invocation->given >> parameter & 1u) != 0 || word.has_default ||
                                  (is_quoted && !block.text.empty());
            if (!is_given) return;
            blank(out);
            out += word.text;
            if (is_quoted) out += '"';
            append_parameter(block, word, invocation, tables_.addresses[word.address].format,
                             tables_.addresses[word.address].name, out);
            if (is_quoted) out += '"';
            break;
        }
        case FormWord::Kind::Empty:
        case FormWord::Kind::Text: break;
    }
}

/// Decimals of an angle among the arguments of a call: they are real numbers, and an angle of
/// thousandths moves a point that is far from its centre.
constexpr int kArgumentAngleDecimals = 9;

void BlockWriter::append_call(const Block& block, const FormWord& word,
                              const Invocation* invocation, std::string& out) {
    blank(out);
    out += word.text;
    out += '(';
    std::size_t last = 0;  // past the last argument that is not empty
    const NumberFormat format = argument_format(tables_);
    NumberFormat angles = format;
    angles.decimals = std::max(format.decimals, kArgumentAngleDecimals);
    for (std::size_t i = 0; i < word.arguments.size(); ++i) {
        const FormWord& argument = word.arguments[i];
        if (i > 0) out += ',';
        const std::size_t before = out.size();
        const bool is_given = argument.parameter >= 0 && invocation != nullptr &&
                              (invocation->given >> argument.parameter & 1u) != 0;
        if (argument.is_quantity) {
            append_quantity(block, argument, format, word.text, out);
        } else if (argument.kind == FormWord::Kind::Fixed) {
            out += argument.text;
        } else if (argument.kind == FormWord::Kind::Text) {
            if (!block.text.empty()) {
                out += '"';
                append_text(block, out);
                out += '"';
            }
        } else if (argument.adds) {
            out += '0';
        } else if (argument.kind == FormWord::Kind::Value && (is_given || argument.has_default)) {
            const bool is_angle = argument.dimension == Dimension::Angle;
            append_parameter(block, argument, invocation, is_angle ? angles : format, word.text,
                             out);
        }
        if (out.size() != before) last = out.size();
    }
    // Empty places at the end are left out.
    if (last != 0) out.resize(last);
    while (out.ends_with(',')) out.pop_back();
    out += ')';
}

/// A number of the form itself, in the units of the text.
void BlockWriter::append_quantity(const Block& block, const FormWord& word,
                                  const NumberFormat& format, std::string_view name,
                                  std::string& out) {
    out += word.text;
    const double number = word.number * text_scale(word.dimension, modal_.units, false);
    const NumberFault fault = append_number(out, number, format, word.dimension, modal_.units);
    if (fault != NumberFault::None)
        messages_.number_fault(block, fault, number, word.dimension, name);
}

void BlockWriter::append_parameter(const Block& block, const FormWord& word,
                                   const Invocation* invocation, const NumberFormat& format,
                                   std::string_view name, std::string& out) {
    const auto parameter = static_cast<std::size_t>(word.parameter);
    const bool is_given = invocation != nullptr && (invocation->given >> parameter & 1u) != 0;
    if (word.kind == FormWord::Kind::Quoted && !is_given) {
        append_text(block, out);
        return;
    }
    double value = invocation == nullptr ? deferred_tool_
                                         : block.argument(*invocation, parameter, word.fallback);
    if (word.is_named_only) value = 0;
    if (word.in_increments || word.tail_digits > 0) {
        append_whole(block, word, value, invocation, name, out);
        return;
    }
    const double scale = text_scale(word.dimension, modal_.units, false);
    const double number = (value * word.factor + word.offset) * scale;
    const double said = value * scale;  // in the unit that messages name
    if (word.dimension == Dimension::Factor) {
        append_factor(block, number, std::abs(word.factor) == 1000, format, name, out);
        return;
    }
    if (word.plain_factor > 0) {
        NumberFormat pointed = format;  // without its point the number would mean another unit
        pointed.point = PointRule::Always;
        const NumberFault fault = append_number(out, number, pointed, word.dimension, modal_.units);
        if (fault != NumberFault::None)
            messages_.number_fault(block, fault, said, word.dimension, name);
        return;
    }
    const bool is_of_frame = invocation != nullptr && word.dimension == Dimension::Length &&
                             has_fact(invocation->function, Fact::SetsFrame);
    const NumberFormat own = word.is_lead  ? lead_format(format)
                             : is_of_frame ? frame_format(format)
                                           : format;
    const NumberFault fault = append_number(out, number, own, word.dimension, modal_.units);
    if (fault != NumberFault::None)
        messages_.number_fault(block, fault, said, word.dimension, name);
    const int places = text_decimals(own, word.dimension, modal_.units);
    check_rounding(block, number, places, word.dimension, name);
    if (word.dimension == Dimension::Angle && invocation != nullptr)
        state_.say_turn(block, *invocation, number, places);
}

/// A whole number without a point: so many increments, or a number in two parts, the first of two
/// digits at least.
void BlockWriter::append_whole(const Block& block, const FormWord& word, double value,
                               const Invocation* invocation, std::string_view name,
                               std::string& out) {
    NumberFormat format;
    format.decimals = format.inch_decimals = 0;
    format.point = PointRule::Never;
    format.max_digits = 8;
    format.allows_minus = false;
    double number = value;
    if (word.in_increments) {
        number *= text_scale(word.dimension, modal_.units, false) /
                  increment_size(tables_, word.dimension, modal_.units);
    } else {
        const double front = std::pow(10.0, word.tail_digits);
        const auto tail_at = static_cast<std::size_t>(std::max(word.tail_parameter, 0));
        const double tail = word.tail_parameter < 0 ? word.tail_value
                            : invocation == nullptr ? value
                                                    : block.argument(*invocation, tail_at);
        if (!(tail >= 0 && tail < front))
            return messages_.number_fault(block, NumberFault::TooLarge, tail, Dimension::Count,
                                          name);
        number = value * front + tail;
        format.digits = word.tail_digits + 2;
    }
    const Dimension dimension = word.in_increments ? Dimension::Number : Dimension::Count;
    const NumberFault fault = append_number(out, number, format, dimension, modal_.units);
    const double said =
        word.in_increments ? value * text_scale(word.dimension, modal_.units, false) : value;
    if (fault != NumberFault::None)
        messages_.number_fault(block, fault, said, word.dimension, name);
}

/// A ratio is as exact as it is meant, whatever the decimals of its letter; in thousandths it is a
/// whole number, and what is finer cannot be said.
void BlockWriter::append_factor(const Block& block, double number, bool in_thousandths,
                                const NumberFormat& address, std::string_view name,
                                std::string& out) {
    constexpr int kDecimals = 9;     // a factor is a real number on the controls that take one
    constexpr double kNoise = 1e-6;  // of a product with 1000
    NumberFormat format;
    format.allows_minus = address.allows_minus;
    format.decimals = in_thousandths ? 0 : kDecimals;
    if (in_thousandths) format.point = PointRule::Never;
    const NumberFault fault = append_number(out, number, format, Dimension::Factor, modal_.units);
    if (in_thousandths && std::fabs(number - std::nearbyint(number)) > kNoise) {
        if (!messages_.fails_first_time(block, name)) return;
        messages_.report(diag::FactorTooFine, block).arg(number / 1000).arg(name);
        return;
    }
    const double said = in_thousandths ? number / 1000 : number;
    if (fault != NumberFault::None)
        messages_.number_fault(block, fault, said, Dimension::Factor, name);
}

void BlockWriter::append_slot(const Block& block, Slot slot, const Targets& targets,
                              std::string& out) {
    const bool by_letter = (targets.by_letter & bit(slot)) != 0;
    const auto at = static_cast<std::size_t>(slot);
    const AddressId id = by_letter ? tables_.incremental_address[at] : tables_.slot_address[at];
    if (id == kNoAddress)
        return messages_.cannot_express(block, '`' + std::string(slot_name(slot)) + '`');
    const Address& address = tables_.addresses[id];
    double number = 0;
    if ((targets.written & bit(slot)) != 0) {
        number = targets.number[static_cast<std::size_t>(slot)];
    } else {
        const double value =
            slot == Slot::Feed && !block.has(slot) ? modal_.meant_feed : block.at(slot);
        number = text_.to_text(slot, value) * (slot == Slot::Feed ? targets.feed_factor : 1);
    }
    blank(out);
    out += address.name;
    const bool is_absolute = (targets.wrapped_absolute & bit(slot)) != 0;
    const bool is_incremental = (targets.wrapped_incremental & bit(slot)) != 0;
    if (is_absolute || is_incremental) {
        out += is_absolute ? "=AC(" : "=IC(";
    } else if (address.name.size() > 1) {
        out += '=';
    }
    const bool is_lead = slot == Slot::Feed && text_.feed_word.is_lead;
    const NumberFault fault =
        is_lead ? append_number(out, number, lead_format(address.format), address.dimension,
                                modal_.units)
                : append_number(out, number, address.format, address.dimension, modal_.units);
    if (is_absolute || is_incremental) out += ')';
    if (fault != NumberFault::None)
        messages_.number_fault(block, fault, number, address.dimension, address.name);
    check_rounding(block, number,
                   text_decimals(is_lead ? lead_format(address.format) : address.format,
                                 address.dimension, modal_.units),
                   address.dimension, address.name);
    if (slot == Slot::Feed)
        state_.say_feed(round_to(number, text_.decimals(slot)), targets.feed_factor != 1);
    if (slot == Slot::Speed) state_.say_speed(round_to(number, text_.decimals(slot)));
}

/// A text between quotes; one that would end early is an error, what is only shown has apostrophes.
void BlockWriter::append_text(const Block& block, std::string& out) {
    std::string text = block.text;
    if (block.find(Function::Message) != nullptr) std::ranges::replace(text, '"', '\'');
    if (text.find_first_of("\"\n\r") != std::string::npos) {
        messages_.fail();
        messages_.report(diag::RawTextBroken, block).arg("text");
        return;
    }
    out += text;
}

void BlockWriter::write_start_line(std::string_view line, std::string& out) {
    lines_.write(line, true, out);
    const Form* shift = nullptr;  // that the line says
    // The codes of the safety line are what the text begins with.
    for (std::size_t at = 0; at < line.size();) {
        const std::size_t begin = line.find_first_not_of(' ', at);
        if (begin == std::string_view::npos) break;
        const std::size_t end = std::min(line.find(' ', begin), line.size());
        const std::string_view word = line.substr(begin, end - begin);
        const AddressId address = tables_.find_address(word.substr(0, 1));
        if (address != kNoAddress && word.size() > 1) {
            const Decimal number = parse_decimal(word.data() + 1, word.data() + word.size());
            const Code* code = tables_.find_code(address, number.value);
            if (code != nullptr && code->simple != kNoForm) state_.say(tables_.forms[code->simple]);
            if (shift != nullptr) state_.start_shift(*shift, address, number.value);
            if (shift == nullptr) shift = text_.kept_shift(address, number.value);
        }
        at = end;
    }
}

}  // namespace kadr::write
