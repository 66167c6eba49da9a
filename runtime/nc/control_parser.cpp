#include <algorithm>
#include <cmath>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "base/text.h"
#include "nc/control_line.h"
#include "nc/control_words.h"

namespace kadr::nc {

void ControlLine::clear() {
    words.clear();
    computed.clear();
    statements.clear();
    code.clear();
    places.clear();
    texts.clear();
}

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

/// Reads one line; the lexer asks it wherever the control's language may stand.
class LineCompiler final : public ValueCompiler {
  public:
    LineCompiler(const DialectTables& tables, const SymbolTable& symbols, std::string_view line,
                 ControlLine& out)
        : tables_(tables),
          language_(tables.language),
          rules_(tables.language.rules),
          symbols_(symbols),
          words_(tables, line),
          line_(line),
          out_(out) {}

    std::optional<LineFault> run() {
        auto fault = lex_line(tables_, line_, out_.words, language_.is_present ? this : nullptr);
        if (!fault) fault = check_whole();
        return fault;
    }

    // ------------------------------------------------------------ what the lexer asks

    std::optional<LineFault> take_piece(std::size_t& at, bool& was_taken) override {
        was_taken = false;
        if (is_plain_word(at)) return {};
        begin(at);
        was_taken = take_main_number() || take_statement() || take_assignment();
        return finish(at, was_taken);
    }

    bool begins_value(std::size_t at) const override {
        if (rules_.values_need_assignment) return false;
        at = words_.skip_blanks(at);
        if (at < line_.size() && (line_[at] == '-' || line_[at] == '+'))
            at = words_.skip_blanks(at + 1);
        return at < line_.size() && (line_[at] == language_.open || words_.begins_variable(at));
    }

    bool continues(std::size_t at) const override {
        at = words_.skip_blanks(at);
        return find_operator(at, false) != nullptr;
    }

    std::optional<LineFault> take_value(std::size_t& at, std::uint16_t word,
                                        std::int32_t argument) override {
        begin(at);
        ComputedValue value;
        value.word = word;
        value.argument = argument;
        const bool is_operand = !rules_.values_need_assignment;
        const bool is_fine = is_operand ? take_operand(value.value) : take_expression(value.value);
        if (is_fine && value.value.is_logical && !rules_.stores_comparisons)
            fail(diag::ExpressionSyntax, value.value.span);
        if (!fault_) out_.computed.push_back(value);
        return finish(at, true);
    }

  private:
    /// A letter with its number, as most words are: nothing of the language begins so.
    bool is_plain_word(std::size_t at) const {
        const auto is_letter = [](char c) {
            return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
        };
        const char next = at + 1 < line_.size() ? line_[at + 1] : '\0';
        return is_letter(line_[at]) && !is_letter(next) &&
               !language_.variable_starts[static_cast<unsigned char>(line_[at])];
    }

    // ------------------------------------------------------------ the cursor

    void begin(std::size_t at) {
        at_ = at;
        depth_ = 0;
        fault_.reset();
    }
    std::optional<LineFault> finish(std::size_t& at, bool was_taken) {
        if (was_taken) at = at_;
        return std::move(fault_);
    }

    char peek() const { return at_ < line_.size() ? line_[at_] : '\0'; }
    void skip() { at_ = words_.skip_blanks(at_); }
    Span span_from(std::size_t begin) const {
        return {static_cast<std::uint32_t>(begin),
                static_cast<std::uint32_t>(std::max(begin + 1, words_.trim(begin, at_)))};
    }

    bool fail(const DiagnosticRow& row, Span span) {
        if (fault_) return false;
        const std::size_t begin = std::min<std::size_t>(span.begin, line_.size());
        const std::size_t end = std::clamp<std::size_t>(span.end, begin, line_.size());
        std::string shown(line_.substr(begin, end - begin));
        if (shown.empty()) shown = "the end of the line";
        fault_ = LineFault{&row,
                           {static_cast<std::uint32_t>(begin),
                            static_cast<std::uint32_t>(std::max(end, begin + 1))},
                           {std::move(shown)}};
        return false;
    }
    bool fail_here(const DiagnosticRow& row) {
        skip();
        const Word word = words_.word_at(at_);
        const std::size_t length = std::max<std::size_t>(1, word.text.size());
        return fail(row,
                    {static_cast<std::uint32_t>(at_), static_cast<std::uint32_t>(at_ + length)});
    }

    // ------------------------------------------------------------ code

    void emit(const Instruction& instruction, std::size_t begin) {
        out_.code.push_back(instruction);
        out_.places.push_back(span_from(begin));
    }
    void emit_number(double number, ValueType type, std::size_t begin) {
        Instruction instruction;
        instruction.number = number;
        instruction.type = type;
        emit(instruction, begin);
    }
    void emit_operation(Operation operation, int count, std::size_t begin) {
        Instruction instruction;
        instruction.kind = Instruction::Kind::Operate;
        instruction.operation = operation;
        instruction.count = static_cast<std::uint8_t>(count);
        emit(instruction, begin);
    }

    /// Takes what `parse` takes as an expression of its own.
    template <typename Parse>
    bool take_as_expression(Expression& out, Parse parse) {
        skip();
        const std::size_t begin = at_;
        out.first = static_cast<std::uint32_t>(out_.code.size());
        bool is_logical = false;
        if (!parse(is_logical)) return false;
        out.count = static_cast<std::uint32_t>(out_.code.size()) - out.first;
        out.span = span_from(begin);
        out.is_logical = is_logical;
        return true;
    }
    bool take_expression(Expression& out) {
        return take_as_expression(out, [this](bool& is_logical) {
            return take_level(language_.lowest_level, is_logical);
        });
    }
    bool take_operand(Expression& out) {
        return take_as_expression(out,
                                  [this](bool& is_logical) { return take_level(0, is_logical); });
    }
    /// A value that is no comparison where the control does not store such.
    bool take_stored(Expression& out) {
        if (!take_expression(out)) return false;
        if (out.is_logical && !rules_.stores_comparisons)
            return fail(diag::ExpressionSyntax, out.span);
        return true;
    }

    // ------------------------------------------------------------ operators

    const OperatorForm* find_operator(std::size_t at, bool is_prefix) const {
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
    bool take_level(int level, bool& is_logical) {
        if (level == 0) return take_primary(is_logical);
        if (!take_level(level - 1, is_logical)) return false;
        while (true) {
            skip();
            const OperatorForm* form = find_operator(at_, false);
            if (form == nullptr || form->level != level) return true;
            const std::size_t begin = at_;
            at_ += form->text.size();
            bool is_right_logical = false;
            if (!take_level(level - 1, is_right_logical)) return false;
            is_logical = is_comparison(form->operation) ||
                         (is_logical && is_right_logical && is_connective(form->operation));
            emit_operation(form->operation, 2, begin);
        }
    }

    bool take_primary(bool& is_logical) {
        is_logical = false;
        skip();
        const std::size_t begin = at_;
        if (const OperatorForm* form = find_operator(at_, true)) {
            at_ += form->text.size();
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

    bool take_open(char sign) {
        skip();
        if (peek() != sign) return fail_here(diag::OpenBracketMissing);
        if (rules_.depth > 0 && ++depth_ > rules_.depth) return fail_here(diag::BracketsTooDeep);
        ++at_;
        return true;
    }
    bool take_close(char sign) {
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
    bool take_bracket(bool& is_logical) {
        return take_open(language_.open) && take_level(language_.lowest_level, is_logical) &&
               take_close(language_.close);
    }

    // ------------------------------------------------------------ constants

    bool take_number() {
        const std::size_t begin = at_;
        const Decimal decimal = parse_decimal(line_.data() + at_, line_.data() + line_.size());
        at_ = static_cast<std::size_t>(decimal.end - line_.data());
        if (at_ == begin) return fail_here(diag::ExpressionSyntax);
        double value = decimal.value;
        bool has_point = decimal.has_point;
        if (words_.has_exponents() && take_exponent(value)) has_point = true;
        const bool is_int = rules_.has_types && !has_point && std::fabs(value) <= 2147483648.0;
        emit_number(value, is_int ? ValueType::Int : ValueType::Real, begin);
        return !fault_;
    }

    /// `1.5EX-3`
    bool take_exponent(double& value) {
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
    bool take_coded_number() {
        const std::size_t begin = at_;
        const std::size_t close = line_.find('\'', at_ + 1);
        if (close == std::string_view::npos || close < begin + 3)
            return fail_here(diag::ExpressionSyntax);
        const char kind = words_.upper(line_[begin + 1]);
        const double base = kind == 'H' ? 16 : 2;
        double value = 0;
        for (std::size_t i = begin + 2; i < close; ++i) {
            const char c = words_.upper(line_[i]);
            const int digit = c >= '0' && c <= '9'   ? c - '0'
                              : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                                     : 99;
            if ((kind != 'H' && kind != 'B') || digit >= base || value > 4294967295.0)
                return fail_here(diag::ExpressionSyntax);
            value = value * base + digit;
        }
        at_ = close + 1;
        if (value > 2147483647.0) value -= 4294967296.0;
        emit_number(value, ValueType::Int, begin);
        return true;
    }

    bool take_text() {
        const std::size_t begin = at_;
        const std::size_t close = line_.find('"', at_ + 1);
        if (close == std::string_view::npos) return fail_here(diag::ExpressionSyntax);
        Instruction instruction;
        instruction.kind = Instruction::Kind::Text;
        instruction.index = static_cast<std::uint32_t>(out_.texts.size());
        out_.texts.emplace_back(line_.substr(at_ + 1, close - at_ - 1));
        at_ = close + 1;
        emit(instruction, begin);
        return true;
    }

    // ------------------------------------------------------------ names

    bool take_name(const Word& word) {
        if (begins_reference(word.begin)) return take_variable();
        for (const FunctionForm& form : language_.functions) {
            if (words_.says(word, form.name)) return take_function(word, form);
        }
        return fail_unknown(word);
    }

    bool fail_unknown(const Word& word) {
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
    bool take_function(const Word& word, const FunctionForm& found) {
        const std::size_t begin = at_;
        if (found.operation == Operation::List || found.operation == Operation::Fill)
            return fail_here(diag::ExpressionSyntax);
        at_ += word.text.size();
        int count = 0;
        bool is_divided = false;
        if (!take_open(language_.open)) return false;
        while (true) {
            bool is_logical = false;
            if (!take_level(language_.lowest_level, is_logical)) return false;
            ++count;
            skip();
            if (peek() != ',') break;
            ++at_;
        }
        if (!take_close(language_.close)) return false;
        skip();
        const auto is_form = [&](const FunctionForm& form, int arguments, bool divided) {
            return form.name == found.name && form.arguments == arguments &&
                   form.is_divided == divided;
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
            emit_operation(form.operation, count, begin);
            return true;
        }
        return fail(diag::ArgumentsWrong, span_from(begin));
    }
    bool has_divided_form(const FunctionForm& found) const {
        return std::ranges::any_of(language_.functions, [&](const FunctionForm& form) {
            return form.name == found.name && form.is_divided;
        });
    }

    // ------------------------------------------------------------ variables

    bool take_variable() {
        const std::size_t begin = at_;
        Reference reference;
        if (!take_reference(reference)) return false;
        emit(reference.load, begin);
        return true;
    }

    /// The code of the indices goes out at once; the load is left to the caller.
    bool take_reference(Reference& out) {
        skip();
        const std::size_t begin = at_;
        out.indices.first = static_cast<std::uint32_t>(out_.code.size());
        const Word word = words_.word_at(at_);
        const bool is_fine = take_family(word, out) || (!fault_ && take_named(word, out)) ||
                             (!fault_ && take_symbol(word, out));
        if (!is_fine) return fault_ ? false : fail_unknown(word);
        out.indices.count = static_cast<std::uint32_t>(out_.code.size()) - out.indices.first;
        out.indices.span = out.span = span_from(begin);
        return true;
    }

    /// `#1`, `#[expression]`, `R5`
    bool take_family(const Word& word, Reference& out) {
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

    bool place_in_family(const VariableForm& form, std::size_t family, std::int64_t number,
                         std::size_t begin, Instruction& load) {
        const VariableRange* range = find_range(form, number);
        if (range == nullptr) return fail(diag::VariableNumber, span_from(begin));
        load.type = range->type;
        if (range->kind == VariableRange::Kind::Global ||
            range->kind == VariableRange::Kind::Local) {
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
    bool fail_unsupported(const VariableRange& range, std::size_t begin) {
        const Span span = span_from(begin);
        const std::string written(line_.substr(span.begin, span.end - span.begin));
        fault_ =
            LineFault{&diag::IsoNotSupported, span, {'`' + written + "` (" + range.meaning + ')'}};
        return false;
    }

    /// `$P_EP[X]`, `$PI`, `TRUE`, `#_ABSIO[1]`
    bool take_named(const Word& word, Reference& out) {
        for (const VariableForm& form : language_.variables) {
            if (form.is_family || !words_.is_same(word.text, form.name)) continue;
            const std::size_t begin = at_;
            at_ += word.text.size();
            if (!form.indices.empty() && !take_indices(form)) return false;
            const VariableRange& range = form.ranges[0];
            Instruction& load = out.load;
            load.type = range.type;
            load.count = static_cast<std::uint8_t>(std::ranges::count_if(
                form.indices, [](const IndexHole& h) { return h.kind != IndexHole::Kind::Word; }));
            switch (range.kind) {
                case VariableRange::Kind::Unsupported: return fail_unsupported(range, begin);
                case VariableRange::Kind::Constant:
                    load.kind =
                        range.is_vacant ? Instruction::Kind::Vacant : Instruction::Kind::Number;
                    load.number = range.value;
                    break;
                case VariableRange::Kind::System:
                    load.kind = Instruction::Kind::System;
                    load.index = static_cast<std::uint32_t>(range.quantity);
                    break;
                case VariableRange::Kind::Global:
                case VariableRange::Kind::Local:
                    load.kind = load.count != 0 ? Instruction::Kind::Family
                                : range.kind == VariableRange::Kind::Global
                                    ? Instruction::Kind::Global
                                    : Instruction::Kind::Local;
                    load.index =
                        load.count != 0
                            ? static_cast<std::uint32_t>(&form - language_.variables.data())
                            : range.slot;
                    break;
            }
            return true;
        }
        return false;
    }

    bool take_indices(const VariableForm& form) {
        if (!take_open(language_.index_open)) return false;
        for (std::size_t i = 0; i < form.indices.size(); ++i) {
            if (i > 0 && !take_sign(',')) return false;
            if (!take_index(form.indices[i])) return false;
        }
        return take_close(language_.index_close);
    }
    bool take_index(const IndexHole& hole) {
        skip();
        const std::size_t begin = at_;
        const Word word = words_.word_at(at_);
        if (hole.kind == IndexHole::Kind::Word) {
            if (!words_.is_same(word.text, hole.word)) {
                fail_here(diag::IsoNotSupported);
                return false;
            }
            at_ += word.text.size();
            return true;
        }
        if (hole.kind == IndexHole::Kind::Axis) {
            const auto axis = std::ranges::find(kAxisNames, words_.normal(word.text));
            if (axis == kAxisNames.end()) return fail_here(diag::NameUnknown);
            at_ += word.text.size();
            // A name stands below zero, the count of an axis above.
            emit_number(-1.0 - static_cast<double>(axis - kAxisNames.begin()), ValueType::Int,
                        begin);
            return true;
        }
        bool is_logical = false;
        return take_level(language_.lowest_level, is_logical);
    }

    bool take_symbol(const Word& word, Reference& out) {
        const Symbol* symbol = symbols_.find(words_.normal(word.text));
        if (symbol == nullptr) return false;
        at_ += word.text.size();
        out.load.type = symbol->type;
        std::uint8_t count = 0;
        const std::size_t next = words_.skip_blanks(at_);
        if (next < line_.size() && line_[next] == language_.index_open) {
            at_ = next;
            if (!take_open(language_.index_open)) return false;
            do {
                if (count > 0) ++at_;
                bool is_logical = false;
                if (!take_level(language_.lowest_level, is_logical)) return false;
                ++count;
                skip();
            } while (peek() == ',' && count < 4);
            if (!take_close(language_.index_close)) return false;
        }
        const bool is_text = symbol->type == ValueType::Text;
        if (count != symbol->dimensions && !(is_text && count == symbol->dimensions + 1))
            return fail(diag::IndexWrong, span_from(word.begin));
        if (symbol->dimensions == 0 && !is_text) {
            out.load.kind = Instruction::Kind::Local;
            out.load.index = symbol->slot;
            return true;
        }
        out.load.kind = Instruction::Kind::Element;
        out.load.index = symbols_.index_of(*symbol);
        out.load.count = count;
        if (count > symbol->dimensions) out.load.type = ValueType::Char;
        return true;
    }

    // ------------------------------------------------------------ assignments

    bool begins_reference(std::size_t at) const {
        if (words_.begins_variable(at)) return true;
        const Word word = words_.word_at(at);
        if (word.text.empty()) return false;
        if (symbols_.find(words_.normal(word.text)) != nullptr) return true;
        return std::ranges::any_of(language_.variables, [&](const VariableForm& form) {
            return !form.is_family && words_.is_same(word.text, form.name);
        });
    }

    bool take_assignment() {
        ControlStatement statement;
        if (!take_assign(statement)) return fault_.has_value();
        out_.statements.push_back(std::move(statement));
        return true;
    }

    /// False without a fault: no assignment begins here.
    bool take_assign(ControlStatement& out) {
        skip();
        const std::size_t begin = at_;
        // A named variable stands between brackets, on the left as well: `[#_UO[3]]=1`.
        const bool is_bracketed =
            peek() == language_.open && begins_reference(words_.skip_blanks(at_ + 1));
        if (!is_bracketed && !begins_reference(at_)) return false;
        if (is_bracketed && !take_open(language_.open)) return false;
        if (!take_reference(out.variable)) return false;
        if (is_bracketed && !take_close(language_.close)) return false;
        skip();
        if (peek() != '=') return fail_here(diag::AssignmentMissing);
        ++at_;
        out.kind = Statement::Assign;
        if (!take_list(out) && (fault_ || !take_stored(out.value))) return false;
        out.span = span_from(begin);
        return true;
    }

    /// `SET(1,,3)`, `REP(0)`: values for an array.
    bool take_list(ControlStatement& out) {
        skip();
        const Word word = words_.word_at(at_);
        const auto form = std::ranges::find_if(language_.functions, [&](const FunctionForm& f) {
            return (f.operation == Operation::List || f.operation == Operation::Fill) &&
                   words_.says(word, f.name);
        });
        if (form == language_.functions.end()) return false;
        at_ += word.text.size();
        out.fills = form->operation == Operation::Fill;
        return take_values(out.list);
    }

    bool take_values(std::vector<Expression>& out) {
        if (!take_open(language_.open)) return false;
        do {
            if (!out.empty()) ++at_;
            out.emplace_back();
            skip();
            if (peek() != ',' && peek() != language_.close && !take_stored(out.back()))
                return false;
            skip();
        } while (peek() == ',');
        return take_close(language_.close);
    }

    // ------------------------------------------------------------ statements

    /// `:10`, a main block.
    bool take_main_number() {
        if (language_.label_sign.empty() || !line_.substr(at_).starts_with(language_.label_sign))
            return false;
        if (out_.words.number >= 0 || !out_.words.label.empty()) return false;
        std::size_t at = at_ + language_.label_sign.size();
        std::int64_t number = 0;
        const std::size_t first = at;
        for (; at < line_.size() && line_[at] >= '0' && line_[at] <= '9' && number < 1'000'000'000;
             ++at)
            number = number * 10 + (line_[at] - '0');
        if (at == first || number > tables_.block_numbers.most) return false;
        out_.words.number = static_cast<std::int32_t>(number);
        at_ = at;
        return true;
    }

    bool take_statement() {
        ControlStatement statement;
        if (!take_pattern(statement, [](Statement) { return true; })) return fault_.has_value();
        out_.statements.push_back(std::move(statement));
        return true;
    }

    /// One of the statements that `is_wanted` accepts. False without a fault: none begins here. Of
    /// several patterns with one keyword the first that fits is taken; if none does, the fault of
    /// the one that came farthest is told.
    template <typename IsWanted>
    bool take_pattern(ControlStatement& out, IsWanted is_wanted) {
        skip();
        const std::size_t begin = at_;
        const Word word = words_.word_at(at_);
        if (word.text.size() < 2) return false;
        std::optional<LineFault> farthest;
        const std::size_t code = out_.code.size();
        for (const StatementForm& form : language_.statements) {
            if (!words_.says(word, form.tokens[0].text) || !is_wanted(form.statement)) continue;
            at_ = begin;
            depth_ = 0;
            fault_.reset();
            out_.code.resize(code);
            out_.places.resize(code);
            ControlStatement statement;
            statement.kind = form.statement;
            statement.closes = form.closes;
            statement.span = {static_cast<std::uint32_t>(begin),
                              static_cast<std::uint32_t>(begin + word.text.size())};
            if (take_tokens(form, word, statement)) {
                out = std::move(statement);
                return true;
            }
            if (!farthest || (fault_ && fault_->span.begin > farthest->span.begin))
                farthest = fault_;
        }
        fault_ = std::move(farthest);
        if (fault_) return false;
        at_ = begin;
        return false;
    }

    bool take_tokens(const StatementForm& form, const Word& keyword, ControlStatement& out) {
        at_ += words_.length_of(keyword, form.tokens[0].text);
        for (std::size_t i = 1; i < form.tokens.size(); ++i) {
            const StatementToken& token = form.tokens[i];
            skip();
            switch (token.kind) {
                case StatementToken::Kind::Word: {
                    const Word word = words_.word_at(at_);
                    if (!words_.says(word, token.text)) {
                        if (token.is_optional) return is_finished();
                        return fail_here(diag::StatementSyntax);
                    }
                    at_ += words_.length_of(word, token.text);
                    break;
                }
                case StatementToken::Kind::Sign:
                    if (token.is_optional && peek() != token.text[0]) return is_finished();
                    if (!take_pattern_sign(token.text[0])) return false;
                    break;
                case StatementToken::Kind::Hole: {
                    const StatementToken* next =
                        i + 1 < form.tokens.size() ? &form.tokens[i + 1] : nullptr;
                    if (token.is_optional && !begins_hole(token)) break;
                    if (!take_hole(token.hole, next, out)) {
                        if (!fault_) fail_here(diag::StatementSyntax);
                        return false;
                    }
                    break;
                }
            }
        }
        return form.repeats || is_finished();
    }

    /// Nothing but a comment behind the statement.
    bool is_finished() {
        skip();
        if (is_inner_ || at_ >= line_.size() || words_.is_comment(at_)) return true;
        return fail_here(rules_.mixes_words ? diag::StatementSyntax : diag::MixedStatement);
    }

    bool take_sign(char sign) {
        skip();
        if (peek() != sign) return fail_here(diag::StatementSyntax);
        ++at_;
        return true;
    }
    bool take_pattern_sign(char sign) {
        if (sign == language_.open) return take_open(sign);
        if (sign == language_.close) return take_close(sign);
        return take_sign(sign);
    }

    bool begins_hole(const StatementToken& token) {
        using Hole = StatementToken::Hole;
        if (at_ >= line_.size() || words_.is_comment(at_)) return false;
        if (token.hole == Hole::To || token.hole == Hole::From) {
            // `P=3` behind a label is none.
            const Word word = words_.word_at(at_);
            const std::size_t next = words_.skip_blanks(at_ + word.text.size());
            return !word.text.empty() && (next >= line_.size() || line_[next] != '=');
        }
        return peek() != language_.close;
    }

    bool take_hole(StatementToken::Hole hole, const StatementToken* next, ControlStatement& out) {
        using Hole = StatementToken::Hole;
        switch (hole) {
            case Hole::Variable: return take_reference(out.variable);
            case Hole::Condition:
                if (!take_expression(out.value)) return false;
                if (!rules_.stores_comparisons && !out.value.is_logical)
                    return fail(diag::ExpressionSyntax, out.value.span);
                return true;
            case Hole::Value:
            case Hole::First:
            case Hole::Number: return take_stored(out.value);
            case Hole::Last:
            case Hole::Text: return take_stored(out.second);
            case Hole::Count: return take_stored(out.count);
            case Hole::Target: return take_target(out.target);
            case Hole::From: return take_target(out.from);
            case Hole::To: return take_target(out.to);
            case Hole::Loop: return take_loop_number(out);
            case Hole::Type: return take_type(out);
            case Hole::Declarations: return take_declarations(out);
            case Hole::Cases: return take_cases(next, out);
            case Hole::Jump: return take_inner(out, false);
            case Hole::Statement: return take_inner(out, true);
        }
        return false;
    }

    bool take_inner(ControlStatement& out, bool is_any) {
        const auto is_wanted = [](Statement statement) {
            return statement >= Statement::Jump && statement <= Statement::JumpToStart;
        };
        const bool was_inner = is_inner_;
        is_inner_ = true;
        ControlStatement inner;
        bool was_taken = take_pattern(inner, is_wanted);
        if (!was_taken && !fault_ && is_any) was_taken = take_assign(inner);
        is_inner_ = was_inner;
        if (!was_taken) {
            if (!fault_ && is_any) fail_here(diag::MixedStatement);
            return false;
        }
        out.inner.push_back(std::move(inner));
        return true;
    }

    bool take_loop_number(ControlStatement& out) {
        skip();
        const std::size_t begin = at_;
        int number = 0;
        while (peek() >= '0' && peek() <= '9' && number < 100000)
            number = number * 10 + (line_[at_++] - '0');
        if (at_ == begin || number < 1 || number > rules_.loop_numbers)
            return at_ == begin ? fail_here(diag::LoopNumber)
                                : fail(diag::LoopNumber, span_from(begin));
        out.loop = number;
        return true;
    }

    /// `100`, `N100`, `LABEL`, or a value that is one of them.
    bool take_target(JumpTarget& out) {
        skip();
        const std::size_t begin = at_;
        const Word word = words_.word_at(at_);
        const bool has_labels = !language_.label_sign.empty();
        if (has_labels && line_.substr(at_).starts_with(language_.label_sign)) ++at_;
        if (has_labels && !word.text.empty() && !begins_reference(at_)) {
            at_ += word.text.size();
            out.kind = JumpTarget::Kind::Label;
            out.label = words_.normal(word.text);
            out.span = span_from(begin);
            const std::int64_t number = words_.block_number(out.label);
            if (number >= 0) {
                out.kind = JumpTarget::Kind::Number;
                out.number = number;
            }
            return true;
        }
        out.kind = JumpTarget::Kind::Computed;
        const bool is_fine = has_labels ? take_expression(out.value) : take_operand(out.value);
        out.span = out.value.span;
        return is_fine;
    }

    // ------------------------------------------------------------ declarations

    bool take_type(ControlStatement& out) {
        const Word word = words_.word_at(at_);
        const auto found = std::ranges::find_if(language_.types, [&](const TypeName& type) {
            return words_.is_same(word.text, type.name);
        });
        if (found == language_.types.end()) {
            const std::string known = tables_.unsupported_words(words_.normal(word.text));
            return known.empty() ? fail_here(diag::StatementSyntax) : fail_unknown(word);
        }
        at_ += word.text.size();
        out.type = found->type;
        if (found->type != ValueType::Text) return true;
        return take_open(language_.index_open) && take_stored(out.type_size) &&
               take_close(language_.index_close);
    }

    bool take_declarations(ControlStatement& out) {
        do {
            if (!out.declarations.empty()) ++at_;
            out.declarations.emplace_back();
            if (!take_declaration(out.declarations.back())) return false;
            skip();
        } while (peek() == ',');
        return true;
    }

    bool take_declaration(Declaration& out) {
        skip();
        const Word word = words_.word_at(at_);
        out.name = words_.normal(word.text);
        out.span = {static_cast<std::uint32_t>(at_),
                    static_cast<std::uint32_t>(at_ + std::max<std::size_t>(1, word.text.size()))};
        if (word.text.empty()) return fail_here(diag::StatementSyntax);
        if (out.name.size() > 31) return fail(diag::NameTooLong, out.span);
        const auto is_name_char = [](char c) { return (c >= 'A' && c <= 'Z') || c == '_'; };
        if (out.name.size() < 2 || !is_name_char(out.name[0]) || !is_name_char(out.name[1]))
            return fail(diag::NameInvalid, out.span);
        if (is_taken(out.name, word)) return fail(diag::NameTwice, out.span);
        at_ += word.text.size();
        skip();
        if (peek() == language_.index_open && !take_sizes(out)) return false;
        skip();
        if (peek() != '=') return true;
        ++at_;
        return take_initial_values(out);
    }

    bool is_taken(const std::string& name, const Word& word) const {
        if (symbols_.find(name) != nullptr || tables_.find_address(name) != kNoAddress) return true;
        const auto same = [&](const auto& form) { return words_.is_same(word.text, form.name); };
        return std::ranges::any_of(language_.functions, same) ||
               std::ranges::any_of(language_.variables, same) ||
               std::ranges::any_of(language_.types, same) ||
               std::ranges::any_of(language_.statements, [&](const StatementForm& form) {
                   return words_.is_same(word.text, form.tokens[0].text);
               });
    }

    bool take_sizes(Declaration& out) {
        if (!take_open(language_.index_open)) return false;
        do {
            if (out.dimensions > 0) ++at_;
            if (out.dimensions == 3) return fail_here(diag::IndexWrong);
            if (!take_stored(out.sizes[out.dimensions++])) return false;
            skip();
        } while (peek() == ',');
        return take_close(language_.index_close);
    }

    bool take_initial_values(Declaration& out) {
        ControlStatement list;
        if (take_list(list)) {
            out.values = std::move(list.list);
            out.fills = list.fills;
            return true;
        }
        if (fault_) return false;
        skip();
        if (out.dimensions > 0 && peek() == language_.open) return take_values(out.values);
        out.values.emplace_back();
        return take_stored(out.values.back());
    }

    // ------------------------------------------------------------ cases

    bool take_cases(const StatementToken* next, ControlStatement& out) {
        while (true) {
            skip();
            if (at_ >= line_.size() || words_.is_comment(at_)) return !out.list.empty();
            if (next != nullptr && words_.says(words_.word_at(at_), next->text)) return true;
            out.list.emplace_back();
            if (!take_operand(out.list.back()) || !take_inner(out, false)) return false;
        }
    }

    // ------------------------------------------------------------ the whole

    std::optional<LineFault> check_whole() {
        const std::vector<ControlStatement>& statements = out_.statements;
        if (statements.empty()) return {};
        const bool has_words = !out_.words.words.empty();
        const auto fault = [](const DiagnosticRow& row, Span span) {
            return LineFault{&row, span, {}};
        };
        const bool are_assignments = std::ranges::all_of(
            statements, [](const ControlStatement& s) { return s.kind == Statement::Assign; });
        if (!rules_.mixes_words && (has_words || statements.size() > 1))
            return fault(diag::MixedStatement,
                         statements.size() > 1 ? statements[1].span : statements[0].span);
        const bool are_jumps = std::ranges::all_of(
            statements, [](const ControlStatement& s) { return s.kind == Statement::IfDo; });
        if (!are_assignments && (has_words || (statements.size() > 1 && !are_jumps)))
            return fault(diag::MixedStatement, statements.back().span);
        const bool is_structure =
            statements[0].kind >= Statement::If && statements[0].kind <= Statement::Until;
        if (is_structure && rules_.mixes_words &&
            (out_.words.skip >= 0 || !out_.words.label.empty()))
            return fault(diag::StructureWithLabel, statements[0].span);
        return {};
    }

    const DialectTables& tables_;
    const Language& language_;
    const LanguageRules& rules_;
    const SymbolTable& symbols_;
    ControlWords words_;
    std::string_view line_;
    ControlLine& out_;
    std::size_t at_ = 0;
    int depth_ = 0;
    bool is_inner_ = false;
    std::optional<LineFault> fault_;
};

}  // namespace

std::optional<LineFault> compile_line(const DialectTables& tables, const SymbolTable& symbols,
                                      std::string_view line, ControlLine& out) {
    out.clear();
    return LineCompiler(tables, symbols, line, out).run();
}

}  // namespace kadr::nc
