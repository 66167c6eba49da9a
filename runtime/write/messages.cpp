#include "write/messages.h"

#include <functional>

#include "base/diagnostics/dialect.h"

namespace kadr::write {

SourceRange BlockMessages::location(SourceId source) const {
    return source.index < statements_.size() ? statements_[source.index] : SourceRange{};
}

/// The word of the statement that sets the address: `Z+=10`, `Z=h`, `Z5`. The statement, if no such
/// word stands in it.
SourceRange BlockMessages::word_location(const Block& block, std::string_view address) const {
    SourceRange statement = location(block);
    if (sources_ == nullptr || !statement.file.is_valid()) return statement;
    const std::string_view text = sources_->text(statement);
    const auto is_part_of_name = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
               c == '_' || c == '.' || (static_cast<unsigned char>(c) & 0x80u) != 0;
    };
    // A word stands outside brackets, and nothing in front of it waits for a value.
    int depth = 0;
    char before = ' ';
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == ' ' || c == '\t' || c == '\n') continue;
        if (c == '(' || c == '[' || c == '{') ++depth;
        if (c == ')' || c == ']' || c == '}') --depth;
        const std::size_t behind = i + address.size();
        const bool is_first = i == 0 || !is_part_of_name(text[i - 1]);
        const bool is_operand =
            std::string_view("=+-*/%<>?:,&|!").find(before) != std::string::npos;
        before = c;
        if (depth != 0 || !is_first || is_operand || behind >= text.size()) continue;
        const bool is_word =
            text.substr(i).starts_with(address) &&
            std::string_view("=+-.0123456789").find(text[behind]) != std::string::npos;
        if (!is_word) continue;
        std::size_t end = behind;
        int inside = 0;
        for (; end < text.size(); ++end) {
            if (text[end] == '(') ++inside;
            if (text[end] == ')') --inside;
            if (inside == 0 && (text[end] == ' ' || text[end] == ';' || text[end] == '\n')) break;
        }
        return {statement.file, statement.begin + static_cast<std::uint32_t>(i),
                statement.begin + static_cast<std::uint32_t>(end)};
    }
    return statement;
}

/// The writing failed; whether the statement has not reported this yet: a loop reports once.
bool BlockMessages::fails_first_time(const Block& block, std::string_view what) {
    failed_ = true;
    return first_time(block, what);
}

/// Whether the statement has not had this reported yet.
bool BlockMessages::first_time(const Block& block, std::string_view what) {
    const std::uint64_t key =
        std::hash<std::string_view>()(what) ^ (std::uint64_t{block.source.index} << 32);
    return reported_.insert(key).second;
}

void BlockMessages::position_unknown(const Block& block, std::string_view name, SlotMask axes) {
    if (!fails_first_time(block, name)) return;
    std::string names;
    std::string words;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if ((axes >> axis & 1u) == 0) continue;
        axes &= ~(SlotMask{1} << axis);
        const bool is_last = (axes & kTargetSlots) == 0;
        names += names.empty() ? "" : is_last ? " and " : ", ";
        names += kAxisNames[axis];
        words += ' ' + std::string(kAxisNames[axis]) + "…";
    }
    DiagnosticBuilder builder =
        sink_.report(diag::WriterPositionUnknown, word_location(block, name));
    builder.arg(name).arg(names);
    if (name == "F" && !block.has(Slot::Feed))
        builder.note("the feed that acts is worked out again for this block");
    builder.fix("say where it is in a block before it: `G0" + words + '`');
}

void BlockMessages::cannot_express(const Block& block, const std::string& what) {
    if (!fails_first_time(block, what)) return;
    sink_.report(diag::CannotExpress, location(block)).arg(tables_.name).arg(what);
}

void BlockMessages::number_fault(const Block& block, NumberFault fault, double value,
                                 Dimension dimension, std::string_view name) {
    if (!fails_first_time(block, name)) return;
    const std::string quantity = quantity_words(value, dimension, units_);
    switch (fault) {
        case NumberFault::None: break;
        case NumberFault::NotFinite:
            sink_.report(diag::ValueNotFinite, word_location(block, name)).arg(name);
            break;
        case NumberFault::TooLarge:
            sink_.report(diag::ValueTooLarge, word_location(block, name)).arg(quantity).arg(name);
            break;
        case NumberFault::Negative:
            sink_.report(diag::ValueNegative, word_location(block, name)).arg(name).arg(quantity);
            break;
        case NumberFault::Point:
        case NumberFault::NotReadBack:
            sink_.report(diag::ValueNotReadBack, word_location(block, name))
                .arg(quantity)
                .arg(name);
            break;
    }
}

void BlockMessages::line_too_long(std::size_t length) {
    failed_ = true;
    if (!reported_.insert(length).second) return;
    sink_.report(diag::LineTooLong).arg(length).arg(tables_.name).arg(tables_.notation.write_line);
}

bool BlockMessages::first_time_of_frame(SourceId statement) {
    return reported_.insert(~std::uint64_t{statement.index}).second;
}

}  // namespace kadr::write
