#include "nc/expression_compiler.h"

#include <algorithm>
#include <cmath>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "base/text.h"
#include "nc/letters.h"

namespace kadr::nc {

namespace {

bool is_comparison(Operation operation) {
    return operation >= Operation::Equal && operation <= Operation::LessEqual;
}

/// What connects comparisons to a comparison again.
bool is_connective(Operation operation) {
    switch (operation) {
        case Operation::And:
        case Operation::Or:
        case Operation::Xor:
        case Operation::Not:
        case Operation::BitAnd:
        case Operation::BitOr:
        case Operation::BitXor: return true;
        default: return false;
    }
}

}  // namespace

// ---------------- the cursor

void ExpressionCompiler::begin(std::size_t at) {
    at_ = at;
    depth_ = 0;
    fault_.reset();
}

std::optional<LineFault> ExpressionCompiler::finish(std::size_t& at, bool was_taken) {
    if (was_taken) at = at_;
    return std::move(fault_);
}

char ExpressionCompiler::peek() const { return at_ < line_.size() ? line_[at_] : '\0'; }

void ExpressionCompiler::skip() { at_ = words_.skip_blanks(at_); }

Span ExpressionCompiler::span_from(std::size_t begin) const {
    return {static_cast<std::uint32_t>(begin),
            static_cast<std::uint32_t>(std::max(begin + 1, words_.trim(begin, at_)))};
}

bool ExpressionCompiler::fail(const DiagnosticRow& row, Span span) {
    if (fault_) return false;
    const std::size_t begin = std::min<std::size_t>(span.begin, line_.size());
    const std::size_t end = std::clamp<std::size_t>(span.end, begin, line_.size());
    std::string shown(line_.substr(begin, end - begin));
    if (shown.empty()) shown = "the end of the line";
    fault_ = LineFault{
        &row,
        {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(std::max(end, begin + 1))},
        {std::move(shown)}};
    return false;
}

bool ExpressionCompiler::fail_here(const DiagnosticRow& row) {
    skip();
    const Word word = words_.word_at(at_);
    const std::size_t length = std::max<std::size_t>(1, word.text.size());
    return fail(row, {static_cast<std::uint32_t>(at_), static_cast<std::uint32_t>(at_ + length)});
}

// ---------------- code

void ExpressionCompiler::emit(const Instruction& instruction, std::size_t begin) {
    out_.code.push_back(instruction);
    out_.places.push_back(span_from(begin));
}

void ExpressionCompiler::emit_number(double number, ValueType type, std::size_t begin) {
    Instruction instruction;
    instruction.number = number;
    instruction.type = type;
    emit(instruction, begin);
}

void ExpressionCompiler::emit_operation(Operation operation, int count, std::size_t begin) {
    Instruction instruction;
    instruction.kind = Instruction::Kind::Operate;
    instruction.operation = operation;
    instruction.count = static_cast<std::uint8_t>(count);
    emit(instruction, begin);
}

bool ExpressionCompiler::take_expression(Expression& out) {
    return take_as_expression(
        out, [this](bool& is_logical) { return take_level(language_.lowest_level, is_logical); });
}

bool ExpressionCompiler::take_operand(Expression& out) {
    skip();
    const OperatorForm* const sign = find_operator(at_, true);
    const bool is_fine =
        take_as_expression(out, [this](bool& is_logical) { return take_level(0, is_logical); });
    out.keeps_vacant = sign != nullptr && sign->operation == Operation::Negate;
    return is_fine;
}

/// A value that is no comparison where the control does not store such.
bool ExpressionCompiler::take_stored(Expression& out) {
    if (!take_expression(out)) return false;
    if (out.is_logical && !rules_.stores_comparisons) return fail(diag::ExpressionSyntax, out.span);
    return true;
}

// ---------------- operators

const OperatorForm* ExpressionCompiler::find_operator(std::size_t at, bool is_prefix) const {
    if (is_block_end(at)) return nullptr;
    const Word word = words_.word_at(at);
    for (const OperatorForm& form : language_.operators) {
        if (form.is_prefix != is_prefix) continue;
        const bool is_there = form.is_word ? words_.says_operator(word, form.text)
                                           : line_.substr(at).starts_with(form.text);
        if (is_there) return &form;
    }
    return nullptr;
}

/// Operators of this level and those that bind stronger, from left to right.
bool ExpressionCompiler::take_level(int level, bool& is_logical) {
    if (level == 0) return take_primary(is_logical);
    if (!take_level(level - 1, is_logical)) return false;
    while (true) {
        skip();
        const OperatorForm* form = find_operator(at_, false);
        if (form == nullptr || form->level != level) return true;
        const std::size_t begin = at_;
        at_ += form->text.size();
        tables_.note(form);
        bool is_right_logical = false;
        if (!take_level(level - 1, is_right_logical)) return false;
        const bool is_computed =
            (is_logical || is_right_logical) && !is_connective(form->operation);
        if (is_computed && !rules_.stores_comparisons)
            return fail(diag::ExpressionSyntax, span_from(begin));
        is_logical = is_comparison(form->operation) ||
                     (is_logical && is_right_logical && is_connective(form->operation));
        emit_operation(form->operation, 2, begin);
    }
}

bool ExpressionCompiler::take_primary(bool& is_logical) {
    is_logical = false;
    skip();
    const std::size_t begin = at_;
    if (const OperatorForm* form = find_operator(at_, true)) {
        at_ += form->text.size();
        tables_.note(form);
        if (!take_level(std::max(0, form->level - 1), is_logical)) return false;
        is_logical = is_logical && is_connective(form->operation);
        emit_operation(form->operation, 1, begin);
        return true;
    }
    const char c = peek();
    if (c == '+') {
        ++at_;
        return take_primary(is_logical);
    }
    if (c == language_.open) return take_bracket(is_logical);
    if ((c >= '0' && c <= '9') || c == '.') return take_number();
    if (c == '"') return take_text();
    if (c == '\'') return take_coded_number();
    if (words_.begins_variable(at_)) return take_variable();
    const Word word = words_.word_at(at_);
    if (word.text.empty()) return fail_here(diag::ExpressionSyntax);
    return take_name(word);
}

bool ExpressionCompiler::take_sign(char sign) {
    skip();
    if (peek() != sign) return fail_here(diag::StatementSyntax);
    ++at_;
    return true;
}

bool ExpressionCompiler::take_open(char sign) {
    skip();
    if (peek() != sign) {
        fail_here(diag::OpenBracketMissing);
        const std::string_view shape = sign == '[' ? "square" : "round";
        fault_->fix = "it stands in " + std::string(shape) + " brackets";
        return false;
    }
    if (rules_.depth > 0 && ++depth_ > rules_.depth) return fail_here(diag::BracketsTooDeep);
    ++at_;
    return true;
}

bool ExpressionCompiler::take_close(char sign) {
    skip();
    if (peek() != sign) {
        const bool is_end = at_ >= line_.size() || words_.is_comment(at_);
        return fail_here(is_end || peek() == ',' || find_operator(at_, false) == nullptr
                             ? diag::CloseBracketMissing
                             : diag::ExpressionSyntax);
    }
    ++at_;
    --depth_;
    return true;
}

bool ExpressionCompiler::take_bracket(bool& is_logical) {
    return take_open(language_.open) && take_level(language_.lowest_level, is_logical) &&
           take_close(language_.close);
}

// ---------------- constants

bool ExpressionCompiler::take_number() {
    const std::size_t begin = at_;
    const Decimal decimal = parse_decimal(line_.data() + at_, line_.data() + line_.size());
    at_ = static_cast<std::size_t>(decimal.end - line_.data());
    if (at_ == begin) return fail_here(diag::ExpressionSyntax);
    double value = decimal.value;
    bool has_point = decimal.has_point;
    if (words_.has_exponents() && take_exponent(value)) has_point = true;
    const bool is_too_long =
        !is_told_ && rules_.constant_digits != 0 && decimal.digits > rules_.constant_digits;
    if (is_too_long || !std::isfinite(value)) {
        fail(diag::IsoTooManyDigits, span_from(begin));
        fault_->arguments = {std::string(line_.substr(begin, at_ - begin))};
        return false;
    }
    const bool is_int = rules_.has_types && !has_point && std::fabs(value) <= 2147483648.0;
    emit_number(value, is_int ? ValueType::Int : ValueType::Real, begin);
    return !fault_;
}

/// `1.5EX-3`
bool ExpressionCompiler::take_exponent(double& value) {
    if (!words_.starts_with(at_, "EX")) return false;
    std::size_t at = at_ + 2;
    const bool is_minus = at < line_.size() && line_[at] == '-';
    if (at < line_.size() && (line_[at] == '-' || line_[at] == '+')) ++at;
    int exponent = 0;
    const std::size_t first = at;
    for (; at < line_.size() && line_[at] >= '0' && line_[at] <= '9' && exponent < 1000; ++at)
        exponent = exponent * 10 + (line_[at] - '0');
    if (at == first || exponent > 308) {
        fail_here(diag::ExpressionSyntax);
        return false;
    }
    at_ = at;
    value *= std::pow(10.0, is_minus ? -exponent : exponent);
    return true;
}

/// `'HFF'`, `'B1011'`
bool ExpressionCompiler::take_coded_number() {
    const std::size_t begin = at_;
    const std::size_t close = line_.find('\'', at_ + 1);
    if (close == std::string_view::npos || close < begin + 3)
        return fail_here(diag::ExpressionSyntax);
    const char kind = words_.upper(line_[begin + 1]);
    const double base = kind == 'H' ? 16 : 2;
    at_ = close + 1;
    const std::size_t digits = close - begin - 2;
    if (digits > (kind == 'H' ? 8u : 32u)) {
        const std::string written(line_.substr(begin, at_ - begin));
        fail(diag::CodedNumberTooLong, span_from(begin));
        fault_->arguments = {kind == 'H' ? "hexadecimal" : "binary", written};
        return false;
    }
    at_ = begin;
    double value = 0;
    for (std::size_t i = begin + 2; i < close; ++i) {
        const char c = words_.upper(line_[i]);
        const int digit = c >= '0' && c <= '9' ? c - '0' : c >= 'A' && c <= 'F' ? c - 'A' + 10 : 99;
        if ((kind != 'H' && kind != 'B') || digit >= base || value > 4294967295.0)
            return fail_here(diag::ExpressionSyntax);
        value = value * base + digit;
    }
    at_ = close + 1;
    if (value > 2147483647.0) value -= 4294967296.0;
    emit_number(value, ValueType::Int, begin);
    return true;
}

bool ExpressionCompiler::take_text() {
    const std::size_t begin = at_;
    const std::size_t close = line_.find('"', at_ + 1);
    if (close == std::string_view::npos) return fail_here(diag::ExpressionSyntax);
    Instruction instruction;
    instruction.kind = Instruction::Kind::Text;
    instruction.index = static_cast<std::uint32_t>(out_.texts.size());
    out_.texts.push_back(utf8_text(line_.substr(at_ + 1, close - at_ - 1)));
    at_ = close + 1;
    const auto most = static_cast<std::size_t>(rules_.most_text);
    if (const std::size_t length = count_code_points(out_.texts.back()); length > most) {
        fail(diag::TextTooLong, span_from(begin));
        fault_->arguments = {std::to_string(length), std::to_string(most)};
        return false;
    }
    emit(instruction, begin);
    return true;
}

// ---------------- names

bool ExpressionCompiler::take_name(const Word& word) {
    const bool is_sign = word.text == "#" || word.text == "$";  // without a number or a name
    if (is_sign) return fail_here(diag::ExpressionSyntax);
    if (begins_reference(word.begin)) return take_variable();
    for (const FunctionForm& form : language_.functions) {
        // `SI` may stand for `SIN`, and `SINE` for nothing.
        const bool goes_on =
            word.text.size() > form.name.size() && is_letter(word.text[form.name.size()]);
        if (!goes_on && words_.says(word, form.name)) return take_function(word, form);
    }
    if (const auto axis = axis_named(word.text)) {
        at_ += word.text.size();
        emit_axis(*axis, word.begin);
        return true;
    }
    return fail_unknown(word);
}

std::optional<Axis> ExpressionCompiler::axis_named(std::string_view name) const {
    if (!language_.has_axes) return std::nullopt;
    const auto found = std::ranges::find(kAxisNames, words_.normal(name));
    if (found == kAxisNames.end() || tables_.find_address(*found) == kNoAddress)
        return std::nullopt;
    return static_cast<Axis>(found - kAxisNames.begin());
}

/// A name of an axis stands below zero, the count of an axis above.
void ExpressionCompiler::emit_axis(Axis axis, std::size_t begin) {
    const ValueType type = language_.has_axes ? ValueType::Axis : ValueType::Int;
    emit_number(-1.0 - static_cast<double>(index(axis)), type, begin);
}

bool ExpressionCompiler::fail_unknown(const Word& word) {
    const std::string known = tables_.unsupported_words(words_.normal(word.text));
    const auto end = static_cast<std::uint32_t>(word.begin + word.text.size());
    if (!known.empty()) {
        fault_ = LineFault{
            &diag::IsoNotSupported, {static_cast<std::uint32_t>(word.begin), end}, {known}};
        return false;
    }
    return fail(diag::NameUnknown, {static_cast<std::uint32_t>(word.begin), end});
}

/// The function whose first form was found; which form it is the arguments tell.
bool ExpressionCompiler::take_function(const Word& word, const FunctionForm& found) {
    const std::size_t begin = at_;
    if (found.operation == Operation::List || found.operation == Operation::Fill)
        return fail_here(diag::ExpressionSyntax);
    at_ += word.text.size();
    int count = 0;
    bool is_divided = false;
    if (!take_open(language_.open)) return false;
    skip();
    const bool takes_none = std::ranges::any_of(language_.functions, [&](const FunctionForm& form) {
        return form.name == found.name && form.takes_any;
    });
    while (!takes_none || peek() != language_.close) {
        const bool is_reference = count < 32 && (found.references >> count & 1u) != 0;
        bool is_logical = false;
        // Where no value is an axis, the name of one stands here alone: `AXNUM[X]`.
        const bool is_axis = found.operation == Operation::AxisNumber && !language_.has_axes;
        if (is_reference ? !take_variable_itself()
            : is_axis    ? !take_axis_index()
                         : !take_level(language_.lowest_level, is_logical))
            return false;
        const bool has_index = count < 32 && (found.indexed >> count & 1u) != 0;
        ++count;
        if (has_index) {
            if (!take_open(language_.index_open) ||
                !take_level(language_.lowest_level, is_logical) ||
                !take_close(language_.index_close))
                return false;
            ++count;
        }
        skip();
        if (peek() != ',') break;
        ++at_;
    }
    if (!take_close(language_.close)) return false;
    skip();
    const auto is_form = [&](const FunctionForm& form, int arguments, bool divided) {
        const bool has_as_many =
            form.takes_any
                ? arguments >= info(form.operation).least_arguments &&
                      arguments <= info(form.operation).most_arguments &&
                      (arguments % 2 == 0 || form.form.find("{pairs}") > form.form.size())
                : form.arguments == arguments;
        return form.name == found.name && has_as_many && form.is_divided == divided;
    };
    if (count == 1 && peek() == '/' && has_divided_form(found)) {
        const std::size_t next = words_.skip_blanks(at_ + 1);
        if (next < line_.size() && line_[next] == language_.open) {
            at_ = next;
            bool is_logical = false;
            if (!take_bracket(is_logical)) return false;
            ++count;
            is_divided = true;
        }
    }
    for (const FunctionForm& form : language_.functions) {
        if (!is_form(form, count, is_divided)) continue;
        tables_.note(&form);
        emit_operation(form.operation, count, begin);
        return true;
    }
    return fail(diag::ArgumentsWrong, span_from(begin));
}

/// A variable that the program has declared, by its place among them.
bool ExpressionCompiler::take_variable_itself() {
    skip();
    const Word word = words_.word_at(at_);
    const Symbol* symbol = symbols_.find(words_.normal(word.text));
    if (symbol == nullptr) return fail_here(diag::ArgumentNoVariable);
    at_ += word.text.size();
    emit_number(symbols_.index_of(*symbol), ValueType::Int, word.begin);
    return true;
}

bool ExpressionCompiler::has_divided_form(const FunctionForm& found) const {
    return std::ranges::any_of(language_.functions, [&](const FunctionForm& form) {
        return form.name == found.name && form.is_divided;
    });
}

// ---------------- variables

bool ExpressionCompiler::take_variable() {
    const std::size_t begin = at_;
    Reference reference;
    if (!take_reference(reference)) return false;
    emit(reference.load, begin);
    return true;
}

/// The code of the indices goes out at once; the load is left to the caller.
bool ExpressionCompiler::take_reference(Reference& out) {
    skip();
    const std::size_t begin = at_;
    out.indices.first = static_cast<std::uint32_t>(out_.code.size());
    const Word word = words_.word_at(at_);
    const Word whole = whole_name(word);
    const bool is_spelled_out = whole.text.size() > word.text.size();
    const bool is_fine = (is_spelled_out && take_named(whole, out)) ||
                         (!fault_ && take_own_name(out)) || (!fault_ && take_family(word, out)) ||
                         (!fault_ && take_named(word, out)) || (!fault_ && take_open(word, out)) ||
                         (!fault_ && take_symbol(word, out));
    const bool is_sign = word.text == "#" || word.text == "$";  // without a number or a name
    if (!is_fine && !fault_ && is_sign) return fail_here(diag::ExpressionSyntax);
    if (!is_fine) return fault_ ? false : fail_unknown(word);
    out.indices.count = static_cast<std::uint32_t>(out_.code.size()) - out.indices.first;
    out.indices.span = out.span = span_from(begin);
    return !refuses_second_index(begin);
}

/// `$P_UIFR[1][X,TR]`: all indices stand in one bracket, with commas between them.
bool ExpressionCompiler::refuses_second_index(std::size_t begin) {
    const bool is_indexed = at_ > begin && line_[at_ - 1] == language_.index_close;
    if (language_.index_open == language_.open || !is_indexed || peek() != language_.index_open)
        return false;
    fail_here(diag::ExpressionSyntax);
    const std::size_t close = std::min(line_.find(language_.index_close, at_), line_.size() - 1);
    fault_->fix = "all indices stand in one bracket: `" +
                  std::string(line_.substr(begin, at_ - 1 - begin)) + ',' +
                  std::string(line_.substr(at_ + 1, close - at_)) + '`';
    return true;
}

/// `#1`, `#[expression]`, `R5`
bool ExpressionCompiler::take_family(const Word& word, Reference& out) {
    for (std::size_t i = 0; i < language_.variables.size(); ++i) {
        const VariableForm& form = language_.variables[i];
        if (!form.is_family || !words_.starts_with(at_, form.name)) continue;
        const std::size_t begin = at_;
        std::size_t at = at_ + form.name.size();
        const std::size_t next = words_.skip_blanks(at);
        if (next < line_.size() && line_[next] == language_.index_open &&
            word.text.size() == form.name.size()) {
            at_ = next;
            bool is_logical = false;
            if (!take_open(language_.index_open) ||
                !take_level(language_.lowest_level, is_logical) ||
                !take_close(language_.index_close))
                return false;
            out.load.kind = Instruction::Kind::Family;
            out.load.index = static_cast<std::uint32_t>(i);
            out.load.count = 1;
            return true;
        }
        if (next < line_.size() && words_.is_blank_insensitive()) at = next;
        std::size_t end = at;
        std::int64_t number = 0;
        for (; end < line_.size() && line_[end] >= '0' && line_[end] <= '9'; ++end)
            number = std::min<std::int64_t>(number * 10 + (line_[end] - '0'), 1'000'000'000);
        if (end == at) continue;
        const bool is_name_longer =
            !words_.is_blank_insensitive() && word.begin + word.text.size() > end;
        if (is_name_longer) continue;
        at_ = end;
        return place_in_family(form, i, number, begin, out.load);
    }
    return false;
}

bool ExpressionCompiler::place_in_family(const VariableForm& form, std::size_t family,
                                         std::int64_t number, std::size_t begin,
                                         Instruction& load) {
    const VariableRange* range = find_range(form, number);
    if (range == nullptr) return fail(diag::VariableNumber, span_from(begin));
    load.type = range->type;
    tables_.note(range);
    if (range->kind == VariableRange::Kind::Global || range->kind == VariableRange::Kind::Local) {
        const bool is_global = range->kind == VariableRange::Kind::Global;
        load.kind = is_global ? Instruction::Kind::Global : Instruction::Kind::Local;
        load.index = range->slot + static_cast<std::uint32_t>(number - range->first);
        return true;
    }
    if (range->kind == VariableRange::Kind::Unsupported) return fail_unsupported(*range, begin);
    // Constants and quantities: by their number, as an index that is computed is.
    emit_number(static_cast<double>(number), ValueType::Int, begin);
    load.kind = Instruction::Kind::Family;
    load.index = static_cast<std::uint32_t>(family);
    load.count = 1;
    return true;
}

bool ExpressionCompiler::fail_unsupported(const VariableRange& range, std::size_t begin) {
    const Span span = span_from(begin);
    const std::string written(line_.substr(span.begin, span.end - span.begin));
    fault_ = LineFault{&diag::IsoNotSupported, span, {'`' + written + "` (" + range.meaning + ')'}};
    return false;
}

Word ExpressionCompiler::whole_name(Word word) const {
    if (!language_.has_names_with_signs) return word;
    for (const VariableForm& form : language_.variables) {
        if (form.has_signs && form.closing.empty() && !form.is_family &&
            form.name.size() > word.text.size() && words_.starts_with(at_, form.name))
            word.text = line_.substr(at_, form.name.size());
    }
    return word;
}

/// `$P_EP[X]`, `$PI`, `TRUE`, `#_ABSIO[1]`
bool ExpressionCompiler::take_named(const Word& word, Reference& out) {
    const std::size_t next = words_.skip_blanks(at_ + word.text.size());
    const bool has_index = next < line_.size() && line_[next] == language_.index_open;
    for (const VariableForm& form : language_.variables) {
        if (form.is_family || form.is_open || !words_.is_same(word.text, form.name)) continue;
        // With an index it may be another variable than without: `TOFFL[2]` and `TOFFL`.
        if (form.has_namesake && has_index == form.indices.empty()) continue;
        const std::size_t begin = at_;
        at_ += word.text.size();
        const VariableRange& range = form.ranges[0];
        tables_.note(&range);
        Instruction& load = out.load;
        load.type = range.type;
        load.count = static_cast<std::uint8_t>(std::ranges::count_if(
            form.indices, [](const IndexHole& h) { return h.kind != IndexHole::Kind::Word; }));
        const bool is_quantity = range.kind == VariableRange::Kind::System;
        const std::size_t code = out_.code.size();
        if (!is_quantity && !take_indices(form, load)) return false;
        switch (range.kind) {
            case VariableRange::Kind::Unsupported: return fail_unsupported(range, begin);
            case VariableRange::Kind::Same: return take_numbered(range, load.count, begin, load);
            case VariableRange::Kind::Constant:
                load.kind = range.is_vacant ? Instruction::Kind::Vacant : Instruction::Kind::Number;
                load.number = range.value;
                load.count = 0;  // the indices do not count
                out_.code.resize(code);
                out_.places.resize(code);
                break;
            case VariableRange::Kind::System:
                load.kind = Instruction::Kind::System;
                load.index = static_cast<std::uint32_t>(range.quantity);
                if (!take_indices(form, load)) return false;
                if (range.first != 0) add_datum(range.first, begin, load);
                return true;
            case VariableRange::Kind::Input:
            case VariableRange::Kind::Bits:
                if (load.count == 0)
                    emit_number(static_cast<double>(range.first), ValueType::Int, begin);
                load.kind = Instruction::Kind::Family;
                load.index = static_cast<std::uint32_t>(&form - language_.variables.data());
                load.count = 1;
                break;
            case VariableRange::Kind::Global:
            case VariableRange::Kind::Local:
                load.kind = load.count != 0                             ? Instruction::Kind::Family
                            : range.kind == VariableRange::Kind::Global ? Instruction::Kind::Global
                                                                        : Instruction::Kind::Local;
                load.index = load.count != 0
                                 ? static_cast<std::uint32_t>(&form - language_.variables.data())
                                 : range.slot;
                break;
        }
        return true;
    }
    return false;
}

/// `$MN_USER_DATA_INT[3]`, `$MA_REF_VELO[AX1,0]`: whatever of this kind the machine has.
bool ExpressionCompiler::take_open(const Word& word, Reference& out) {
    const auto form = std::ranges::find_if(language_.variables, [&](const VariableForm& each) {
        return each.is_open && word.text.size() > each.name.size() &&
               words_.starts_with(word.begin, each.name);
    });
    if (form == language_.variables.end()) return false;
    const std::size_t begin = at_;
    at_ += word.text.size();
    tables_.note(&form->ranges[0]);
    const std::string name = words_.normal(word.text);
    const auto number = static_cast<double>(names_ == nullptr ? 1 : names_->number_of(name));
    emit_number(number, ValueType::Int, begin);
    Instruction& load = out.load;
    load.kind = Instruction::Kind::Input;
    load.type = form->ranges[0].type;
    load.index = static_cast<std::uint32_t>(form - language_.variables.begin());
    load.count = 1;
    const std::size_t next = words_.skip_blanks(at_);
    if (next >= line_.size() || line_[next] != language_.index_open) return true;
    constexpr std::uint8_t kMostIndices = 2;
    for (bool is_first = true; is_first || (skip(), peek() == ','); is_first = false) {
        if (is_first ? !take_open_bracket() : !take_sign(',')) return false;
        if (load.count > kMostIndices) return fail_here(diag::CloseBracketMissing);
        if (!take_machine_axis() && (fault_ || !take_any_index())) return false;
        ++load.count;
    }
    return take_close(language_.index_close);
}

bool ExpressionCompiler::take_open_bracket() { return take_open(language_.index_open); }

bool ExpressionCompiler::take_any_index() {
    // `S1`: a spindle is an axis of the machine, told by its number.
    const Word word = words_.word_at(at_);
    const std::string name = words_.normal(word.text);
    const bool is_spindle = language_.has_axes && name.size() == 2 && name[0] == 'S' &&
                            name[1] >= '1' && name[1] <= '9' && symbols_.find(name) == nullptr;
    if (is_spindle) {
        const std::size_t begin = at_;
        at_ += word.text.size();
        emit_number(name[1] - '0', ValueType::Int, begin);
        return true;
    }
    bool is_logical = false;
    return take_level(language_.lowest_level, is_logical);
}

/// `AX1`, `X1`: an axis as the machine calls it. A name that the program has declared comes first.
bool ExpressionCompiler::take_machine_axis() {
    skip();
    const Word word = words_.word_at(at_);
    const std::string name = words_.normal(word.text);
    if (name.empty() || symbols_.find(name) != nullptr) return false;
    static const MachineAxisNames kUsual = usual_axis_names({});
    const MachineAxisNames& names = axis_names_ == nullptr ? kUsual : *axis_names_;
    const auto found = names.find(name);
    if (found == names.end()) return false;
    const std::size_t begin = at_;
    at_ += word.text.size();
    emit_axis(found->second, begin);
    return true;
}

bool ExpressionCompiler::take_own_name(Reference& out) {
    const VariableForm* form = nullptr;  // the one with the longest beginning: `#<_` before `#<`
    std::size_t place = 0;
    for (std::size_t i = 0; i < language_.variables.size(); ++i) {
        const VariableForm& other = language_.variables[i];
        const bool is_here = !other.closing.empty() && words_.starts_with(at_, other.name);
        if (!is_here || (form != nullptr && form->name.size() > other.name.size())) continue;
        form = &other;
        place = i;
    }
    if (form == nullptr) return false;
    const std::size_t begin = at_;
    const std::size_t first = at_ + form->name.size();
    const std::size_t close = line_.find(form->closing, first);
    std::string name = form->name;  // of two families names may be alike
    for (const char c : line_.substr(first, std::min(close, line_.size()) - first))
        if (c != ' ' && c != '\t') name += c;
    if (close == std::string_view::npos || name.size() == form->name.size()) {
        at_ = std::min(first, line_.size());
        return fail_here(diag::ExpressionSyntax);
    }
    at_ = close + form->closing.size();
    const std::int64_t number = names_ == nullptr ? 1 : names_->number_of(words_.normal(name));
    return place_in_family(*form, place, number, begin, out.load);
}

/// The edge behind the number of a datum, as Quantity::ToolDatum has them. A datum of the whole
/// tool has no index of an edge.
void ExpressionCompiler::add_datum(std::int64_t datum, std::size_t begin, Instruction& load) {
    emit_number(static_cast<double>(datum * kDatum), ValueType::Int, begin);
    if (load.count == 1) {
        load.count = 2;
    } else {
        emit_operation(Operation::Add, 2, begin);
    }
}

/// A name of a numbered variable; an index in front of it is added to the number.
bool ExpressionCompiler::take_numbered(const VariableRange& range, int indices, std::size_t begin,
                                       Instruction& load) {
    const auto family = std::ranges::find_if(language_.variables, &VariableForm::is_family);
    if (family == language_.variables.end()) return fail_unsupported(range, begin);
    const auto place = static_cast<std::size_t>(family - language_.variables.begin());
    if (indices == 0)
        return place_in_family(*family, place, static_cast<std::int64_t>(range.value), begin, load);
    emit_number(range.value, ValueType::Int, begin);
    emit_operation(Operation::Add, 2, begin);
    load.kind = Instruction::Kind::Family;
    load.index = static_cast<std::uint32_t>(place);
    load.count = 1;
    return true;
}

bool ExpressionCompiler::take_indices(const VariableForm& form, Instruction& load) {
    const bool is_frame = load.type == ValueType::Frame;
    if (form.indices.empty()) {
        const std::size_t next = words_.skip_blanks(at_);
        const bool has_part =
            is_frame && next < line_.size() && line_[next] == language_.index_open;
        if (!has_part) return true;
    }
    if (!take_open(language_.index_open)) return false;
    for (std::size_t i = 0; i < form.indices.size(); ++i) {
        if (i > 0 && !take_sign(',')) return false;
        if (!take_index(form.indices[i])) return false;
    }
    skip();
    const bool has_part = is_frame && (form.indices.empty() || peek() == ',');
    if (has_part && !take_frame_part(form.indices.empty(), load)) return false;
    return take_close(language_.index_close);
}

bool ExpressionCompiler::take_frame_part(bool is_first, Instruction& load) {
    if (!is_first && !take_sign(',')) return false;
    if (!take_axis_index() || !take_sign(',')) return false;
    skip();
    const Word word = words_.word_at(at_);
    const auto named = std::ranges::find_if(language_.frame_parts, [&](const FramePartName& name) {
        return words_.is_same(word.text, name.word);
    });
    if (named == language_.frame_parts.end()) return fail_here(diag::NameUnknown);
    at_ += word.text.size();
    load.kind = load.kind == Instruction::Kind::System ? Instruction::Kind::SystemPart
                                                       : Instruction::Kind::ElementPart;
    load.type = ValueType::Real;
    load.number = static_cast<double>(named->part);
    ++load.count;
    return true;
}

bool ExpressionCompiler::take_index(const IndexHole& hole) {
    skip();
    const Word word = words_.word_at(at_);
    if (hole.kind == IndexHole::Kind::Word) {
        if (!words_.is_same(word.text, hole.word)) {
            fail_here(diag::IsoNotSupported);
            return false;
        }
        at_ += word.text.size();
        return true;
    }
    if (hole.kind == IndexHole::Kind::Axis) return take_axis_index();
    bool is_logical = false;
    return take_level(language_.lowest_level, is_logical);
}

/// `X`, or where values may be axes one of them; elsewhere the number of an axis.
bool ExpressionCompiler::take_axis_index() {
    skip();
    const std::size_t begin = at_;
    const Word word = words_.word_at(at_);
    const auto axis = std::ranges::find(kAxisNames, words_.normal(word.text));
    if (axis != kAxisNames.end()) {
        at_ += word.text.size();
        emit_axis(static_cast<Axis>(axis - kAxisNames.begin()), begin);
        return true;
    }
    if (language_.has_axes && take_machine_axis()) return true;
    bool is_logical = false;
    if (!take_level(language_.lowest_level, is_logical)) return false;
    if (language_.has_axes) emit_operation(Operation::ToAxis, 1, begin);
    return true;
}

bool ExpressionCompiler::take_symbol(const Word& word, Reference& out) {
    const Symbol* symbol = symbols_.find(words_.normal(word.text));
    if (symbol == nullptr) return false;
    at_ += word.text.size();
    out.load.type = symbol->type;
    out.load.kind = Instruction::Kind::Element;
    out.load.index = symbols_.index_of(*symbol);
    const bool is_frame = symbol->type == ValueType::Frame;
    std::uint8_t count = 0;
    const std::size_t next = words_.skip_blanks(at_);
    if (next < line_.size() && line_[next] == language_.index_open) {
        at_ = next;
        if (!take_open(language_.index_open)) return false;
        const std::uint8_t most = is_frame ? symbol->dimensions : 4;
        for (; count < most && (count == 0 || peek() == ','); ++count) {
            if (count > 0) ++at_;
            bool is_logical = false;
            if (!take_level(language_.lowest_level, is_logical)) return false;
            skip();
        }
        const bool has_part = is_frame && (count == 0 || peek() == ',');
        out.load.count = count;
        if (has_part && !take_frame_part(count == 0, out.load)) return false;
        if (!take_close(language_.index_close)) return false;
        if (has_part) return true;
    }
    const bool is_text = symbol->type == ValueType::Text;
    const bool is_whole = (takes_whole_arrays_ && count == 0) ||
                          (takes_rows_ && count == 1 && symbol->dimensions == 2);
    if (count != symbol->dimensions && !(is_text && count == symbol->dimensions + 1) && !is_whole)
        return fail(diag::IndexWrong, span_from(word.begin));
    if (symbol->is_plain()) {
        out.load.kind = Instruction::Kind::Local;
        out.load.index = symbol->slot;
        return true;
    }
    out.load.count = count;
    if (count > symbol->dimensions) out.load.type = ValueType::Char;
    return true;
}

bool ExpressionCompiler::begins_reference(std::size_t at) const {
    if (words_.begins_variable(at)) return true;
    const Word word = words_.word_at(at);
    if (word.text.empty()) return false;
    if (symbols_.find(words_.normal(word.text)) != nullptr) return true;
    return std::ranges::any_of(language_.variables, [&](const VariableForm& form) {
        if (form.is_open) return words_.starts_with(word.begin, form.name);
        return !form.is_family && words_.is_same(word.text, form.name);
    });
}

}  // namespace kadr::nc
