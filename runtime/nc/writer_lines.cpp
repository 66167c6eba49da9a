// Lines: words in their order, numbers, comments, block numbers, lengths.
#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "nc/block_writer.h"
#include "nc/comment_text.h"

namespace kadr::nc {

void BlockWriter::collect_slots(const Block& block, const Targets& targets, Items& items) {
    const SlotMask scalars = bit(Slot::Turns) | bit(Slot::Feed) | bit(Slot::Speed);
    for (const Slot slot : tables_.slot_order) {
        const SlotMask mask = bit(slot);
        const bool is_target = (targets.written & mask) != 0;
        if (!is_target && (block.given & mask & scalars) == 0) continue;
        const bool may_stand = !options_.verbose_modal;
        if (slot == Slot::Feed && may_stand && !modal_.units.inverse_time &&
            is_standing(slot, block.at(slot), modal_.feed)) {
            continue;
        }
        if (slot == Slot::Speed && may_stand && is_standing(slot, block.at(slot), modal_.speed)) {
            // The start of a spindle shows its speed, even if it is the old one.
            const bool starts = block.find(Function::SpindleCw) != nullptr ||
                                block.find(Function::SpindleCcw) != nullptr;
            if (!starts) continue;
        }
        items.add({.order = address_of(slot).order, .slot = slot});
    }
    for (std::size_t slot = 0; slot < kSlots; ++slot) {
        if (block.has(static_cast<Slot>(slot)) && tables_.slot_address[slot] == kNoAddress &&
            (scalars >> slot & 1u) != 0) {
            cannot_express(block,
                           slot == static_cast<std::size_t>(Slot::Feed) ? "a feed" : "a speed");
        }
    }
    // Where F is not modal, every block at feed repeats it.
    const Function motion = effective_motion(block);
    const bool is_cut = motion == Function::Line || is_arc(motion);
    if (feed_every_block_ && is_cut && !block.has(Slot::Feed) && modal_.has_meant_feed &&
        (block.given & (kTargetSlots | kCenterSlots)) != 0) {
        items.add({.order = address_of(Slot::Feed).order, .slot = Slot::Feed});
    }
}

/// Words that a tool change left for the block that moves the tool axis, or says a function.
void BlockWriter::add_deferred(const Block& block, Items& items) {
    if (pending_.empty()) return;
    const bool is_cycle = block.function_count != 0 && block.find(Function::Cycle) != nullptr;
    const bool is_machine =
        block.function_count != 0 && (block.find(Function::MachineCoordinates) != nullptr ||
                                      block.find(Function::ReferenceReturn) != nullptr);
    for (std::size_t i = 0; i < pending_.size();) {
        const Deferred& deferred = *pending_[i].deferred;
        bool acts = false;
        if (deferred.axis >= 0 && !is_machine)
            acts = block.has(static_cast<Slot>(deferred.axis)) || is_cycle;
        for (const Function function : deferred.functions) acts |= block.find(function) != nullptr;
        if (deferred.axis < 0) acts &= block.find(Function::RadiusOffset) == nullptr;
        if (!acts) {
            ++i;
            continue;
        }
        deferred_tool_ = pending_[i].tool;
        items.add({.order = tables_.addresses[deferred.words[0].address].order,
                   .words = &deferred.words});
        // Functions may come again for the same tool; an axis word acts once.
        if (deferred.axis >= 0) {
            pending_.erase(pending_.begin() + static_cast<std::ptrdiff_t>(i));
        } else {
            ++i;
        }
    }
}

void BlockWriter::write_items(const Block& block, Items& items, const Targets& targets,
                              std::string& out) {
    std::stable_sort(items.list.begin(),
                     items.list.begin() + static_cast<std::ptrdiff_t>(items.count),
                     [](const Item& a, const Item& b) { return a.order < b.order; });
    // A comment that is too long to stand behind the block stands before it.
    const std::size_t most = tables_.comment.max_length;
    const bool fits = most == 0 || count_code_points(block.comment) <= most;
    if (!fits) write_comment(block, out);
    Items later;
    std::array<std::uint8_t, 256> used{};
    open_line(block.number, block.skip, true, out);
    for (std::size_t i = 0; i < items.count; ++i) {
        const Item& item = items.list[i];
        if (item.form != kNoForm && !tables_.forms[item.form].is_comment) {
            // A control that takes one M a block gets the others in lines of their own.
            const AddressId head = tables_.forms[item.form].words[0].address;
            if (used[head & 255u] >= tables_.addresses[head].write_max) {
                later.add(item);
                continue;
            }
            ++used[head & 255u];
        }
        append_item(block, item, targets, out);
    }
    if (!block.comment.empty() && fits) append_comment(block.comment, out);
    close_line(out);
    for (std::size_t i = 0; i < items.count; ++i) {
        if (items.list[i].form == kNoForm) continue;
        for (const std::vector<FormWord>& line : tables_.forms[items.list[i].form].extra) {
            open_line(-1, block.skip, true, out);
            append_words(block, line, items.list[i].invocation, false, out);
            close_line(out);
            note_line(line);
        }
    }
    if (later.count == 0) return;
    Block rest;
    rest.skip = block.skip;
    rest.source = block.source;
    rest.text = block.text;
    rest.arguments = block.arguments;
    write_items(rest, later, {}, out);
}

/// Codes that stand in a form's further lines change the state of the text, too.
void BlockWriter::note_line(const std::vector<FormWord>& words) {
    for (const FormWord& word : words) {
        if (word.kind != FormWord::Kind::Fixed) continue;
        const Code* code = tables_.find_code(word.address, word.number);
        if (code != nullptr && code->simple != kNoForm) note_written(tables_.forms[code->simple]);
    }
}

void BlockWriter::append_item(const Block& block, const Item& item, const Targets& targets,
                              std::string& out) {
    if (item.form != kNoForm) {
        const Form& form = tables_.forms[item.form];
        blank(out);
        if (form.is_comment) {
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

void BlockWriter::append_edge(const Block& block, int edge, std::string& out) {
    const Form& form =
        tables_.forms[tables_.forms_of[static_cast<std::size_t>(Function::ToolEdge)][0]];
    Block words;
    words.source = block.source;
    Invocation* invocation = words.add(Function::ToolEdge, 1);
    words.set_argument(*invocation, 0, edge);
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
        Standing& kept = modal_.shift[parameter % modal_.shift.size()];
        if (kept.is_known && kept.value == value) unchanged |= 1u << word.parameter;
        kept = {true, value};
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

void BlockWriter::append_call(const Block& block, const FormWord& word,
                              const Invocation* invocation, std::string& out) {
    blank(out);
    out += word.text;
    out += '(';
    std::size_t last = 0;  // past the last argument that is not empty
    for (std::size_t i = 0; i < word.arguments.size(); ++i) {
        const FormWord& argument = word.arguments[i];
        if (i > 0) out += ',';
        const std::size_t before = out.size();
        const bool is_given = argument.parameter >= 0 && invocation != nullptr &&
                              (invocation->given >> argument.parameter & 1u) != 0;
        if (argument.kind == FormWord::Kind::Fixed) {
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
            const AddressId format = tables_.find_address("()");
            append_parameter(
                block, argument, invocation,
                format == kNoAddress ? NumberFormat{} : tables_.addresses[format].format, "()",
                out);
        }
        if (out.size() != before) last = out.size();
    }
    // Empty places at the end are left out.
    if (last != 0) out.resize(last);
    while (out.ends_with(',')) out.pop_back();
    out += ')';
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
    const double number =
        (value * word.factor + word.offset) * text_scale(word.dimension, modal_.units, false);
    if (word.dimension == Dimension::Factor) {
        append_factor(block, number, std::abs(word.factor) == 1000, name, out);
        return;
    }
    const NumberFault fault = append_number(out, number, format, word.dimension, modal_.units);
    if (fault != NumberFault::None) number_fault(block, fault, number, name);
}

/// A ratio is as exact as it is meant, whatever the decimals of its letter; in thousandths it is a
/// whole number, and what is finer cannot be said.
void BlockWriter::append_factor(const Block& block, double number, bool in_thousandths,
                                std::string_view name, std::string& out) {
    constexpr int kDecimals = 6;
    constexpr double kNoise = 1e-6;  // of a product with 1000
    NumberFormat format;
    format.decimals = in_thousandths ? 0 : kDecimals;
    if (in_thousandths) format.point = PointRule::Never;
    NumberFault fault = append_number(out, number, format, Dimension::Factor, modal_.units);
    if (in_thousandths && std::fabs(number - std::nearbyint(number)) > kNoise)
        fault = NumberFault::NotReadBack;
    if (fault != NumberFault::None) number_fault(block, fault, number, name);
}

void BlockWriter::append_slot(const Block& block, Slot slot, const Targets& targets,
                              std::string& out) {
    const Address& address = address_of(slot);
    double number = 0;
    if ((targets.written & bit(slot)) != 0) {
        number = targets.number[static_cast<std::size_t>(slot)];
    } else {
        const double value =
            slot == Slot::Feed && !block.has(slot) ? modal_.meant_feed : block.at(slot);
        number = to_text(slot, value) * (slot == Slot::Feed ? targets.feed_factor : 1);
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
    const NumberFault fault =
        append_number(out, number, address.format, address.dimension, modal_.units);
    if (is_absolute || is_incremental) out += ')';
    if (fault != NumberFault::None) number_fault(block, fault, number, address.name);
    if (slot == Slot::Feed) modal_.feed = {true, round_to(number, decimals(slot))};
    if (slot == Slot::Speed) modal_.speed = {true, round_to(number, decimals(slot))};
}

/// A text between quotes; one that would end early is an error.
void BlockWriter::append_text(const Block& block, std::string& out) {
    if (block.text.find_first_of("\"\n\r") != std::string::npos) {
        failed_ = true;
        sink_.report(diag::RawTextBroken, place(block)).arg("text");
        return;
    }
    out += block.text;
}

// ---------------------------------------------------------------- lines

void BlockWriter::open_line(std::int32_t number, int skip, bool is_numbered, std::string& out) {
    line_start_ = out.size();
    if (skip >= 0) {
        out += '/';
        if (skip != tables_.rules.default_skip) out += static_cast<char>('0' + skip);
        out += ' ';
    }
    const BlockNumbers& numbers = tables_.block_numbers;
    std::int64_t n = number;
    if (numbers.is_on && options_.number_blocks) {
        if (!is_numbered) return;
        n = number_;
        number_ += numbers.step;
        if (number_ > numbers.most) number_ = numbers.start;
    }
    if (n < 0) return;
    std::array<char, 24> digits;
    char* end = digits.data() + digits.size();
    char* begin = end;
    do *--begin = static_cast<char>('0' + n % 10);
    while ((n /= 10) != 0);
    out += 'N';
    out.append(begin, end);
}

void BlockWriter::close_line(std::string& out) {
    const std::size_t length = out.size() - line_start_;
    if (length + 1 > tables_.rules.write_line) {
        failed_ = true;
        if (reported_.insert(length).second) {
            sink_.report(diag::LineTooLong)
                .arg(length)
                .arg(tables_.name)
                .arg(tables_.rules.write_line);
        }
    }
    if (tables_.rules.crlf) out += '\r';
    out += '\n';
    ++lines_;
}

void BlockWriter::append_comment(const std::string& comment, std::string& out) {
    blank(out);
    out += tables_.comment.open;
    out += comment_text(comment, tables_.comment);
    out += tables_.comment.close;
}

void BlockWriter::write_line(std::string_view line, bool is_numbered, std::string& out) {
    open_line(-1, -1, is_numbered, out);
    if (is_numbered) blank(out);
    out += line;
    close_line(out);
}

void BlockWriter::write_start_line(std::string_view line, std::string& out) {
    write_line(line, true, out);
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
            if (code != nullptr && code->simple != kNoForm)
                note_written(tables_.forms[code->simple]);
        }
        at = end;
    }
}

}  // namespace kadr::nc
