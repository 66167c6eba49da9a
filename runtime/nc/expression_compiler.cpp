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

void ExpressionCompiler::set_fault(const DiagnosticRow& row, Span span) {
    if (fault_) return;
    const std::size_t begin = std::min<std::size_t>(span.begin, line_.size());
    const std::size_t end = std::clamp<std::size_t>(span.end, begin, line_.size());
    std::string shown(line_.substr(begin, end - begin));
    if (shown.empty()) shown = "the end of the line";
    fault_ = LineFault{
        &row,
        {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(std::max(end, begin + 1))},
        {std::move(shown)}};
}

void ExpressionCompiler::set_fault_here(const DiagnosticRow& row) {
    skip();
    const LetterRun word = words_.word_at(at_);
    const std::size_t length = std::max<std::size_t>(1, word.text.size());
    set_fault(row, {static_cast<std::uint32_t>(at_), static_cast<std::uint32_t>(at_ + length)});
}

Done ExpressionCompiler::fail(const DiagnosticRow& row, Span span) {
    set_fault(row, span);
    return kFailed;
}

Done ExpressionCompiler::fail_here(const DiagnosticRow& row) {
    set_fault_here(row);
    return kFailed;
}

// ---------------- code

void ExpressionCompiler::emit(const ControlInstruction& instruction, std::size_t begin) {
    out_.code.push_back(instruction);
    out_.spans.push_back(span_from(begin));
}

void ExpressionCompiler::emit_number(double number, ValueType type, std::size_t begin) {
    ControlInstruction instruction;
    instruction.number = number;
    instruction.type = type;
    emit(instruction, begin);
}

void ExpressionCompiler::emit_operation(Operation operation, int count, std::size_t begin) {
    ControlInstruction instruction;
    instruction.kind = ControlInstruction::Kind::Operate;
    instruction.operation = operation;
    instruction.count = static_cast<std::uint8_t>(count);
    emit(instruction, begin);
}

Done ExpressionCompiler::take_expression(Expression& out) {
    return take_as_expression(
        out, [this](bool& is_logical) { return take_level(language_.lowest_level, is_logical); });
}

Done ExpressionCompiler::take_operand(Expression& out) {
    skip();
    const OperatorForm* const sign = find_operator(at_, true);
    const Done taken =
        take_as_expression(out, [this](bool& is_logical) { return take_level(0, is_logical); });
    out.keeps_vacant = sign != nullptr && sign->operation == Operation::Negate;
    return taken;
}

/// A value that is no comparison where the control does not store such.
Done ExpressionCompiler::take_stored(Expression& out) {
    if (!take_expression(out)) return kFailed;
    if (out.is_logical && !rules_.stores_comparisons) return fail(diag::ExpressionSyntax, out.span);
    return kDone;
}

// ---------------- operators

const OperatorForm* ExpressionCompiler::find_operator(std::size_t at, bool is_prefix) const {
    if (is_block_end(at)) return nullptr;
    const LetterRun word = words_.word_at(at);
    for (const OperatorForm& form : language_.operators) {
        if (form.is_prefix != is_prefix) continue;
        const bool is_there = form.is_word ? words_.matches_operator(word, form.text)
                                           : line_.substr(at).starts_with(form.text);
        if (is_there) return &form;
    }
    return nullptr;
}

/// Operators of this level and those that bind stronger, from left to right.
Done ExpressionCompiler::take_level(int level, bool& is_logical) {
    if (level == 0) return take_primary(is_logical);
    if (!take_level(level - 1, is_logical)) return kFailed;
    while (true) {
        skip();
        const OperatorForm* form = find_operator(at_, false);
        if (form == nullptr || form->level != level) return kDone;
        const std::size_t begin = at_;
        at_ += form->text.size();
        tables_.note(form);
        bool is_right_logical = false;
        if (!take_level(level - 1, is_right_logical)) return kFailed;
        const bool is_computed =
            (is_logical || is_right_logical) && !is_connective(form->operation);
        if (is_computed && !rules_.stores_comparisons)
            return fail(diag::ExpressionSyntax, span_from(begin));
        is_logical = is_comparison(form->operation) ||
                     (is_logical && is_right_logical && is_connective(form->operation));
        emit_operation(form->operation, 2, begin);
    }
}

Done ExpressionCompiler::take_primary(bool& is_logical) {
    is_logical = false;
    skip();
    const std::size_t begin = at_;
    if (const OperatorForm* form = find_operator(at_, true)) {
        at_ += form->text.size();
        tables_.note(form);
        if (!take_level(std::max(0, form->level - 1), is_logical)) return kFailed;
        is_logical = is_logical && is_connective(form->operation);
        emit_operation(form->operation, 1, begin);
        return kDone;
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
    const LetterRun word = words_.word_at(at_);
    if (word.text.empty()) return fail_here(diag::ExpressionSyntax);
    return take_name(word);
}

Done ExpressionCompiler::take_sign(char sign) {
    skip();
    if (peek() != sign) return fail_here(diag::StatementSyntax);
    ++at_;
    return kDone;
}

Done ExpressionCompiler::take_open(char sign) {
    skip();
    if (peek() != sign) {
        set_fault_here(diag::OpenBracketMissing);
        const std::string_view shape = sign == '[' ? "square" : "round";
        fault_->fix = "it stands in " + std::string(shape) + " brackets";
        return kFailed;
    }
    if (rules_.depth > 0 && ++depth_ > rules_.depth) return fail_here(diag::BracketsTooDeep);
    ++at_;
    return kDone;
}

Done ExpressionCompiler::take_close(char sign) {
    skip();
    if (peek() != sign) {
        const bool is_end = at_ >= line_.size() || words_.is_comment(at_);
        return fail_here(is_end || peek() == ',' || find_operator(at_, false) == nullptr
                             ? diag::CloseBracketMissing
                             : diag::ExpressionSyntax);
    }
    ++at_;
    --depth_;
    return kDone;
}

Done ExpressionCompiler::take_bracket(bool& is_logical) {
    return Done(take_open(language_.open) && take_level(language_.lowest_level, is_logical) &&
                take_close(language_.close));
}

// ---------------- constants

Done ExpressionCompiler::take_number() {
    const std::size_t begin = at_;
    const Decimal decimal = parse_decimal(line_.data() + at_, line_.data() + line_.size());
    at_ = static_cast<std::size_t>(decimal.end - line_.data());
    if (at_ == begin) return fail_here(diag::ExpressionSyntax);
    double value = decimal.value;
    bool has_point = decimal.has_point;
    if (words_.has_exponents() && take_exponent(value) == Try::Taken) has_point = true;
    const bool is_too_long =
        !is_machine_data_ && rules_.constant_digits != 0 && decimal.digits > rules_.constant_digits;
    if (is_too_long || !std::isfinite(value)) {
        set_fault(diag::IsoTooManyDigits, span_from(begin));
        fault_->arguments = {std::string(line_.substr(begin, at_ - begin))};
        return kFailed;
    }
    const bool is_int = rules_.has_types && !has_point && std::fabs(value) <= 2147483648.0;
    emit_number(value, is_int ? ValueType::Int : ValueType::Real, begin);
    return Done(!fault_);
}

/// `1.5EX-3`
Try ExpressionCompiler::take_exponent(double& value) {
    if (!words_.starts_with(at_, "EX")) return not_taken();
    std::size_t at = at_ + 2;
    const bool is_minus = at < line_.size() && line_[at] == '-';
    if (at < line_.size() && (line_[at] == '-' || line_[at] == '+')) ++at;
    int exponent = 0;
    const std::size_t first = at;
    for (; at < line_.size() && line_[at] >= '0' && line_[at] <= '9' && exponent < 1000; ++at)
        exponent = exponent * 10 + (line_[at] - '0');
    if (at == first || exponent > 308) {
        return tried(fail_here(diag::ExpressionSyntax));
    }
    at_ = at;
    value *= std::pow(10.0, is_minus ? -exponent : exponent);
    return Try::Taken;
}

/// `'HFF'`, `'B1011'`
Done ExpressionCompiler::take_coded_number() {
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
        set_fault(diag::CodedNumberTooLong, span_from(begin));
        fault_->arguments = {kind == 'H' ? "hexadecimal" : "binary", written};
        return kFailed;
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
    return kDone;
}

Done ExpressionCompiler::take_text() {
    const std::size_t begin = at_;
    const std::size_t close = line_.find('"', at_ + 1);
    if (close == std::string_view::npos) return fail_here(diag::ExpressionSyntax);
    ControlInstruction instruction;
    instruction.kind = ControlInstruction::Kind::Text;
    instruction.index = static_cast<std::uint32_t>(out_.texts.size());
    out_.texts.push_back(utf8_text(line_.substr(at_ + 1, close - at_ - 1)));
    at_ = close + 1;
    const auto most = static_cast<std::size_t>(rules_.most_text);
    if (const std::size_t length = count_code_points(out_.texts.back()); length > most) {
        set_fault(diag::TextTooLong, span_from(begin));
        fault_->arguments = {std::to_string(length), std::to_string(most)};
        return kFailed;
    }
    emit(instruction, begin);
    return kDone;
}

// ---------------- names

Done ExpressionCompiler::take_name(const LetterRun& word) {
    const bool is_sign = word.text == "#" || word.text == "$";  // without a number or a name
    if (is_sign) return fail_here(diag::ExpressionSyntax);
    if (begins_reference(word.begin)) return take_variable();
    for (const FunctionForm& form : language_.functions) {
        // `SI` may stand for `SIN`, and `SINE` for nothing.
        const bool goes_on =
            word.text.size() > form.name.size() && is_letter(word.text[form.name.size()]);
        if (!goes_on && words_.matches(word, form.name)) return take_function(word, form);
    }
    if (const auto axis = axis_named(word.text)) {
        at_ += word.text.size();
        emit_axis(*axis, word.begin);
        return kDone;
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

Done ExpressionCompiler::fail_unknown(const LetterRun& word) {
    const std::string known = tables_.unsupported_words(words_.normal(word.text));
    const auto end = static_cast<std::uint32_t>(word.begin + word.text.size());
    if (!known.empty()) {
        fault_ = LineFault{
            &diag::IsoNotSupported, {static_cast<std::uint32_t>(word.begin), end}, {known}};
        return kFailed;
    }
    return fail(diag::NameUnknown, {static_cast<std::uint32_t>(word.begin), end});
}

/// The function whose first form was found; which form it is the arguments decide.
Done ExpressionCompiler::take_function(const LetterRun& word, const FunctionForm& found) {
    const std::size_t begin = at_;
    if (found.operation == Operation::List || found.operation == Operation::Fill)
        return fail_here(diag::ExpressionSyntax);
    at_ += word.text.size();
    int count = 0;
    bool is_divided = false;
    if (!take_open(language_.open)) return kFailed;
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
            return kFailed;
        const bool has_index = count < 32 && (found.indexed >> count & 1u) != 0;
        ++count;
        if (has_index) {
            if (!take_open(language_.index_open) ||
                !take_level(language_.lowest_level, is_logical) ||
                !take_close(language_.index_close))
                return kFailed;
            ++count;
        }
        skip();
        if (peek() != ',') break;
        ++at_;
    }
    if (!take_close(language_.close)) return kFailed;
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
            if (!take_bracket(is_logical)) return kFailed;
            ++count;
            is_divided = true;
        }
    }
    for (const FunctionForm& form : language_.functions) {
        if (!is_form(form, count, is_divided)) continue;
        tables_.note(&form);
        emit_operation(form.operation, count, begin);
        return kDone;
    }
    return fail(diag::ArgumentsWrong, span_from(begin));
}

/// A variable that the program has declared, by its index among them.
Done ExpressionCompiler::take_variable_itself() {
    skip();
    const LetterRun word = words_.word_at(at_);
    const ControlSymbol* symbol = symbols_.find(words_.normal(word.text));
    if (symbol == nullptr) return fail_here(diag::ArgumentNoVariable);
    at_ += word.text.size();
    emit_number(symbols_.index_of(*symbol), ValueType::Int, word.begin);
    return kDone;
}

bool ExpressionCompiler::has_divided_form(const FunctionForm& found) const {
    return std::ranges::any_of(language_.functions, [&](const FunctionForm& form) {
        return form.name == found.name && form.is_divided;
    });
}

// ---------------- variables

Done ExpressionCompiler::take_variable() {
    const std::size_t begin = at_;
    Reference reference;
    if (!take_reference(reference)) return kFailed;
    emit(reference.load, begin);
    return kDone;
}

/// The code of the indices goes out at once; the load is left to the caller.
Done ExpressionCompiler::take_reference(Reference& out) {
    skip();
    const std::size_t begin = at_;
    out.indices.first = static_cast<std::uint32_t>(out_.code.size());
    const LetterRun word = words_.word_at(at_);
    const LetterRun whole = whole_name(word);
    const bool is_spelled_out = whole.text.size() > word.text.size();
    Try taken = is_spelled_out ? take_named(whole, out) : Try::Absent;
    const auto is_open = [&] { return taken == Try::Absent && !fault_; };
    if (is_open()) taken = take_own_name(out);
    if (is_open()) taken = take_family(word, out);
    if (is_open()) taken = take_named(word, out);
    if (is_open()) taken = take_open_name(word, out);
    if (is_open()) taken = take_symbol(word, out);
    const bool is_sign = word.text == "#" || word.text == "$";  // without a number or a name
    if (is_open() && is_sign) return fail_here(diag::ExpressionSyntax);
    if (taken != Try::Taken) return fault_ ? kFailed : fail_unknown(word);
    out.indices.count = static_cast<std::uint32_t>(out_.code.size()) - out.indices.first;
    out.indices.span = out.span = span_from(begin);
    return require_one_bracket(begin);
}

/// `$P_UIFR[1][X,TR]`: all indices stand in one bracket, with commas between them.
Done ExpressionCompiler::require_one_bracket(std::size_t begin) {
    const bool is_indexed = at_ > begin && line_[at_ - 1] == language_.index_close;
    if (language_.index_open == language_.open || !is_indexed || peek() != language_.index_open)
        return kDone;
    set_fault_here(diag::ExpressionSyntax);
    const std::size_t close = std::min(line_.find(language_.index_close, at_), line_.size() - 1);
    fault_->fix = "all indices stand in one bracket: `" +
                  std::string(line_.substr(begin, at_ - 1 - begin)) + ',' +
                  std::string(line_.substr(at_ + 1, close - at_)) + '`';
    return kFailed;
}

/// `#1`, `#[expression]`, `R5`
Try ExpressionCompiler::take_family(const LetterRun& word, Reference& out) {
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
                return not_taken();
            out.load.kind = ControlInstruction::Kind::Family;
            out.load.index = static_cast<std::uint32_t>(i);
            out.load.count = 1;
            return Try::Taken;
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
        return tried(index_in_family(form, i, number, begin, out.load));
    }
    return not_taken();
}

Done ExpressionCompiler::index_in_family(const VariableForm& form, std::size_t family,
                                         std::int64_t number, std::size_t begin,
                                         ControlInstruction& load) {
    const VariableRange* range = find_range(form, number);
    if (range == nullptr) return fail(diag::VariableNumber, span_from(begin));
    load.type = range->type;
    tables_.note(range);
    if (range->kind == VariableRange::Kind::Global || range->kind == VariableRange::Kind::Local) {
        const bool is_global = range->kind == VariableRange::Kind::Global;
        load.kind = is_global ? ControlInstruction::Kind::Global : ControlInstruction::Kind::Local;
        load.index = range->slot + static_cast<std::uint32_t>(number - range->first);
        return kDone;
    }
    if (range->kind == VariableRange::Kind::Unsupported) return fail_unsupported(*range, begin);
    // Constants and system variables: by their number, as an index that is computed is.
    emit_number(static_cast<double>(number), ValueType::Int, begin);
    load.kind = ControlInstruction::Kind::Family;
    load.index = static_cast<std::uint32_t>(family);
    load.count = 1;
    return kDone;
}

Done ExpressionCompiler::fail_unsupported(const VariableRange& range, std::size_t begin) {
    const Span span = span_from(begin);
    const std::string written(line_.substr(span.begin, span.end - span.begin));
    fault_ = LineFault{&diag::IsoNotSupported, span, {'`' + written + "` (" + range.meaning + ')'}};
    return kFailed;
}

LetterRun ExpressionCompiler::whole_name(LetterRun word) const {
    if (!language_.has_names_with_signs) return word;
    for (const VariableForm& form : language_.variables) {
        if (form.has_signs && form.closing.empty() && !form.is_family &&
            form.name.size() > word.text.size() && words_.starts_with(at_, form.name))
            word.text = line_.substr(at_, form.name.size());
    }
    return word;
}

/// `$P_EP[X]`, `$PI`, `TRUE`, `#_ABSIO[1]`
Try ExpressionCompiler::take_named(const LetterRun& word, Reference& out) {
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
        ControlInstruction& load = out.load;
        load.type = range.type;
        load.count = static_cast<std::uint8_t>(std::ranges::count_if(
            form.indices, [](const IndexHole& h) { return h.kind != IndexHole::Kind::Word; }));
        const bool is_quantity = range.kind == VariableRange::Kind::System;
        const std::size_t code = out_.code.size();
        if (!is_quantity && !take_indices(form, load)) return not_taken();
        switch (range.kind) {
            case VariableRange::Kind::Unsupported: return tried(fail_unsupported(range, begin));
            case VariableRange::Kind::Same:
                return tried(take_numbered(range, load.count, begin, load));
            case VariableRange::Kind::Constant:
                load.kind = range.is_vacant ? ControlInstruction::Kind::Vacant
                                            : ControlInstruction::Kind::Number;
                load.number = range.value;
                load.count = 0;  // the indices do not count
                out_.code.resize(code);
                out_.spans.resize(code);
                break;
            case VariableRange::Kind::System:
                load.kind = ControlInstruction::Kind::System;
                load.index = static_cast<std::uint32_t>(range.quantity);
                if (!take_indices(form, load)) return not_taken();
                if (range.first != 0) add_datum(range.first, begin, load);
                return Try::Taken;
            case VariableRange::Kind::Input:
            case VariableRange::Kind::Bits:
                if (load.count == 0)
                    emit_number(static_cast<double>(range.first), ValueType::Int, begin);
                load.kind = ControlInstruction::Kind::Family;
                load.index = static_cast<std::uint32_t>(&form - language_.variables.data());
                load.count = 1;
                break;
            case VariableRange::Kind::Global:
            case VariableRange::Kind::Local:
                load.kind = load.count != 0 ? ControlInstruction::Kind::Family
                            : range.kind == VariableRange::Kind::Global
                                ? ControlInstruction::Kind::Global
                                : ControlInstruction::Kind::Local;
                load.index = load.count != 0
                                 ? static_cast<std::uint32_t>(&form - language_.variables.data())
                                 : range.slot;
                break;
        }
        return Try::Taken;
    }
    return not_taken();
}

/// `$MN_USER_DATA_INT[3]`, `$MA_REF_VELO[AX1,0]`: whatever of this kind the machine has.
Try ExpressionCompiler::take_open_name(const LetterRun& word, Reference& out) {
    const auto form = std::ranges::find_if(language_.variables, [&](const VariableForm& each) {
        return each.is_open && word.text.size() > each.name.size() &&
               words_.starts_with(word.begin, each.name);
    });
    if (form == language_.variables.end()) return not_taken();
    const std::size_t begin = at_;
    at_ += word.text.size();
    tables_.note(&form->ranges[0]);
    const std::string name = words_.normal(word.text);
    const auto number = static_cast<double>(names_ == nullptr ? 1 : names_->number_of(name));
    emit_number(number, ValueType::Int, begin);
    ControlInstruction& load = out.load;
    load.kind = ControlInstruction::Kind::Input;
    load.type = form->ranges[0].type;
    load.index = static_cast<std::uint32_t>(form - language_.variables.begin());
    load.count = 1;
    const std::size_t next = words_.skip_blanks(at_);
    if (next >= line_.size() || line_[next] != language_.index_open) return Try::Taken;
    constexpr std::uint8_t kMostIndices = 2;
    for (bool is_first = true; is_first || (skip(), peek() == ','); is_first = false) {
        if (is_first ? !take_open_bracket() : !take_sign(',')) return not_taken();
        if (load.count > kMostIndices) return tried(fail_here(diag::CloseBracketMissing));
        if (!take_machine_axis() && (fault_ || !take_any_index())) return not_taken();
        ++load.count;
    }
    return tried(take_close(language_.index_close));
}

Done ExpressionCompiler::take_open_bracket() { return take_open(language_.index_open); }

Done ExpressionCompiler::take_any_index() {
    // `S1`: a spindle is an axis of the machine, named by its number.
    const LetterRun word = words_.word_at(at_);
    const std::string name = words_.normal(word.text);
    const bool is_spindle = language_.has_axes && name.size() == 2 && name[0] == 'S' &&
                            name[1] >= '1' && name[1] <= '9' && symbols_.find(name) == nullptr;
    if (is_spindle) {
        const std::size_t begin = at_;
        at_ += word.text.size();
        emit_number(name[1] - '0', ValueType::Int, begin);
        return kDone;
    }
    bool is_logical = false;
    return take_level(language_.lowest_level, is_logical);
}

/// `AX1`, `X1`: an axis as the machine calls it. A name that the program has declared comes first.
bool ExpressionCompiler::take_machine_axis() {
    skip();
    const LetterRun word = words_.word_at(at_);
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

Try ExpressionCompiler::take_own_name(Reference& out) {
    const VariableForm* form = nullptr;  // the one with the longest beginning: `#<_` before `#<`
    std::size_t index = 0;
    for (std::size_t i = 0; i < language_.variables.size(); ++i) {
        const VariableForm& other = language_.variables[i];
        const bool is_here = !other.closing.empty() && words_.starts_with(at_, other.name);
        if (!is_here || (form != nullptr && form->name.size() > other.name.size())) continue;
        form = &other;
        index = i;
    }
    if (form == nullptr) return not_taken();
    const std::size_t begin = at_;
    const std::size_t first = at_ + form->name.size();
    const std::size_t close = line_.find(form->closing, first);
    std::string name = form->name;  // of two families names may be alike
    for (const char c : line_.substr(first, std::min(close, line_.size()) - first))
        if (c != ' ' && c != '\t') name += c;
    if (close == std::string_view::npos || name.size() == form->name.size()) {
        at_ = std::min(first, line_.size());
        return tried(fail_here(diag::ExpressionSyntax));
    }
    at_ = close + form->closing.size();
    const std::int64_t number = names_ == nullptr ? 1 : names_->number_of(words_.normal(name));
    return tried(index_in_family(*form, index, number, begin, out.load));
}

/// The edge behind the number of a datum, as SystemQuantity::ToolDatum has them. A datum of the
/// whole tool has no index of an edge.
void ExpressionCompiler::add_datum(std::int64_t datum, std::size_t begin,
                                   ControlInstruction& load) {
    emit_number(static_cast<double>(datum * kDatum), ValueType::Int, begin);
    if (load.count == 1) {
        load.count = 2;
    } else {
        emit_operation(Operation::Add, 2, begin);
    }
}

/// A name of a numbered variable; an index in front of it is added to the number.
Done ExpressionCompiler::take_numbered(const VariableRange& range, int indices, std::size_t begin,
                                       ControlInstruction& load) {
    const auto family = std::ranges::find_if(language_.variables, &VariableForm::is_family);
    if (family == language_.variables.end()) return fail_unsupported(range, begin);
    const auto index = static_cast<std::size_t>(family - language_.variables.begin());
    if (indices == 0)
        return index_in_family(*family, index, static_cast<std::int64_t>(range.value), begin, load);
    emit_number(range.value, ValueType::Int, begin);
    emit_operation(Operation::Add, 2, begin);
    load.kind = ControlInstruction::Kind::Family;
    load.index = static_cast<std::uint32_t>(index);
    load.count = 1;
    return kDone;
}

Done ExpressionCompiler::take_indices(const VariableForm& form, ControlInstruction& load) {
    const bool is_frame = load.type == ValueType::Frame;
    if (form.indices.empty()) {
        const std::size_t next = words_.skip_blanks(at_);
        const bool has_part =
            is_frame && next < line_.size() && line_[next] == language_.index_open;
        if (!has_part) return kDone;
    }
    if (!take_open(language_.index_open)) return kFailed;
    for (std::size_t i = 0; i < form.indices.size(); ++i) {
        if (i > 0 && !take_sign(',')) return kFailed;
        if (!take_index(form.indices[i])) return kFailed;
    }
    skip();
    const bool has_part = is_frame && (form.indices.empty() || peek() == ',');
    if (has_part && !take_frame_part(form.indices.empty(), load)) return kFailed;
    return take_close(language_.index_close);
}

Done ExpressionCompiler::take_frame_part(bool is_first, ControlInstruction& load) {
    if (!is_first && !take_sign(',')) return kFailed;
    if (!take_axis_index() || !take_sign(',')) return kFailed;
    skip();
    const LetterRun word = words_.word_at(at_);
    const auto named = std::ranges::find_if(language_.frame_parts, [&](const FramePartName& name) {
        return words_.is_same(word.text, name.word);
    });
    if (named == language_.frame_parts.end()) return fail_here(diag::NameUnknown);
    at_ += word.text.size();
    load.kind = load.kind == ControlInstruction::Kind::System
                    ? ControlInstruction::Kind::SystemPart
                    : ControlInstruction::Kind::ElementPart;
    load.type = ValueType::Real;
    load.number = static_cast<double>(named->part);
    ++load.count;
    return kDone;
}

Done ExpressionCompiler::take_index(const IndexHole& hole) {
    skip();
    const LetterRun word = words_.word_at(at_);
    if (hole.kind == IndexHole::Kind::Word) {
        if (!words_.is_same(word.text, hole.word)) {
            return fail_here(diag::IsoNotSupported);
        }
        at_ += word.text.size();
        return kDone;
    }
    if (hole.kind == IndexHole::Kind::Axis) return take_axis_index();
    bool is_logical = false;
    return take_level(language_.lowest_level, is_logical);
}

/// `X`, or where values may be axes one of them; elsewhere the number of an axis.
Done ExpressionCompiler::take_axis_index() {
    skip();
    const std::size_t begin = at_;
    const LetterRun word = words_.word_at(at_);
    const auto axis = std::ranges::find(kAxisNames, words_.normal(word.text));
    if (axis != kAxisNames.end()) {
        at_ += word.text.size();
        emit_axis(static_cast<Axis>(axis - kAxisNames.begin()), begin);
        return kDone;
    }
    if (language_.has_axes && take_machine_axis()) return kDone;
    bool is_logical = false;
    if (!take_level(language_.lowest_level, is_logical)) return kFailed;
    if (language_.has_axes) emit_operation(Operation::ToAxis, 1, begin);
    return kDone;
}

Try ExpressionCompiler::take_symbol(const LetterRun& word, Reference& out) {
    const ControlSymbol* symbol = symbols_.find(words_.normal(word.text));
    if (symbol == nullptr) return not_taken();
    at_ += word.text.size();
    out.load.type = symbol->type;
    out.load.kind = ControlInstruction::Kind::Element;
    out.load.index = symbols_.index_of(*symbol);
    const bool is_frame = symbol->type == ValueType::Frame;
    std::uint8_t count = 0;
    const std::size_t next = words_.skip_blanks(at_);
    if (next < line_.size() && line_[next] == language_.index_open) {
        at_ = next;
        if (!take_open(language_.index_open)) return not_taken();
        const std::uint8_t most = is_frame ? symbol->dimensions : 4;
        for (; count < most && (count == 0 || peek() == ','); ++count) {
            if (count > 0) ++at_;
            bool is_logical = false;
            if (!take_level(language_.lowest_level, is_logical)) return not_taken();
            skip();
        }
        const bool has_part = is_frame && (count == 0 || peek() == ',');
        out.load.count = count;
        if (has_part && !take_frame_part(count == 0, out.load)) return not_taken();
        if (!take_close(language_.index_close)) return not_taken();
        if (has_part) return Try::Taken;
    }
    const bool is_text = symbol->type == ValueType::Text;
    const bool is_whole = (takes_whole_arrays_ && count == 0) ||
                          (takes_rows_ && count == 1 && symbol->dimensions == 2);
    if (count != symbol->dimensions && !(is_text && count == symbol->dimensions + 1) && !is_whole)
        return tried(fail(diag::IndexWrong, span_from(word.begin)));
    if (symbol->is_plain()) {
        out.load.kind = ControlInstruction::Kind::Local;
        out.load.index = symbol->slot;
        return Try::Taken;
    }
    out.load.count = count;
    if (count > symbol->dimensions) out.load.type = ValueType::Char;
    return Try::Taken;
}

bool ExpressionCompiler::begins_reference(std::size_t at) const {
    if (words_.begins_variable(at)) return true;
    const LetterRun word = words_.word_at(at);
    if (word.text.empty()) return false;
    if (symbols_.find(words_.normal(word.text)) != nullptr) return true;
    return std::ranges::any_of(language_.variables, [&](const VariableForm& form) {
        if (form.is_open) return words_.starts_with(word.begin, form.name);
        return !form.is_family && words_.is_same(word.text, form.name);
    });
}

}  // namespace kadr::nc
