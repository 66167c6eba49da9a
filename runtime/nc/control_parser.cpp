#include <algorithm>
#include <utility>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "base/text.h"
#include "nc/call_compiler.h"
#include "nc/control_line.h"
#include "nc/letters.h"
#include "nc/loop_front.h"
#include "nc/refused_words.h"
#include "nc/scope_words.h"
#include "nc/without_blanks.h"

namespace kadr::nc {

void ControlLine::clear() {
    words.clear();
    computed.clear();
    axes.clear();
    codes.clear();
    statements.clear();
    calls.clear();
    code.clear();
    spans.clear();
    texts.clear();
}

namespace {

/// Reads one line; the lexer asks it wherever the control's language may stand.
class ControlLineCompiler final : public ValueCompiler, private CallCompiler {
  public:
    ControlLineCompiler(const DialectTables& tables, const SymbolTable& symbols,
                        std::string_view line, ControlLine& out, const LineContext& context)
        : CallCompiler(tables, symbols, line, out), context_(context) {
        names_ = context.names;
        axis_names_ = context.axis_names;
        is_machine_data_ = context.is_machine_data;
    }

    std::optional<LineFault> run() {
        auto fault = lex_line(tables_, line_, out_.words, language_.is_present ? this : nullptr);
        if (!fault) fault = check_whole();
        return fault;
    }

    // ------------------------------------------------------------ what the lexer asks

    std::optional<LineFault> take_piece(std::size_t& at, bool& was_taken) override {
        was_taken = false;
        if (begins_call_word(at)) {
            begin(at);
            was_taken = take_call_word() == Try::Taken;
            if (!was_taken && !fault_) was_taken = take_named_call() == Try::Taken;
            if (was_taken || fault_) return finish(at, was_taken);
        }
        if (is_plain_word(at)) return {};
        begin(at);
        was_taken = take_main_number() || take_statement() != Try::Absent ||
                    take_assignment() != Try::Absent ||
                    (!fault_ && take_named_call() == Try::Taken);
        return finish(at, was_taken);
    }

    bool begins_value(std::size_t at) const override {
        if (rules_.values_need_assignment) return false;
        at = words_.skip_blanks(at);
        if (at < line_.size() && (line_[at] == '-' || line_[at] == '+'))
            at = words_.skip_blanks(at + 1);
        return at < line_.size() && (line_[at] == language_.open || words_.begins_variable(at));
    }

    std::optional<LineFault> take_axis(std::size_t& at, std::uint16_t word,
                                       bool& was_taken) override {
        was_taken = false;
        begin(at);
        const LetterRun name = words_.word_at(at_);
        const std::size_t next = words_.skip_blanks(at_ + name.text.size());
        if (next >= line_.size() || line_[next] != language_.index_open) return {};
        const bool is_alone = is_lone_axis_word(name.text);
        const bool is_axis = is_alone || words_.is_same(name.text, language_.axis_word);
        const bool is_of_spindle = !is_axis && is_spindle_word(name.text);
        const bool is_known =
            is_axis || is_of_spindle || takes_axis(tables_, words_.normal(name.text));
        if (!is_known) return {};
        // The names of axes and the numbers of spindles are words as they stand.
        const bool is_computed = begins_computed_index(words_.skip_blanks(next + 1), is_of_spindle);
        if (!is_axis && !is_computed) return {};
        at_ = next;
        ComputedAxis axis;
        axis.word = word;
        axis.is_alone = is_alone;
        const auto take_index = [&] {
            return is_of_spindle
                       ? take_expression(axis.axis)
                       : take_as_expression(axis.axis, [this](bool&) { return take_axis_index(); });
        };
        was_taken =
            take_open(language_.index_open) && take_index() && take_close(language_.index_close);
        if (was_taken) out_.axes.push_back(axis);
        return finish(at, was_taken);
    }

    std::optional<LineFault> take_code(std::size_t& at, std::uint16_t word) override {
        begin(at);
        ComputedCode code;
        code.word = word;
        const bool is_fine = take_open(language_.index_open) && take_expression(code.group) &&
                             take_close(language_.index_close) && take_sign('=') &&
                             take_expression(code.number);
        if (is_fine) out_.codes.push_back(code);
        return finish(at, true);
    }

    bool continues(std::size_t at) const override {
        at = words_.skip_blanks(at);
        return find_operator(at, false) != nullptr;
    }

    bool leaves_out(int level) const override { return (context_.skip_levels >> level & 1u) != 0; }

    std::optional<LineFault> take_value(std::size_t& at, std::uint16_t word,
                                        std::int32_t argument) override {
        begin(at);
        ComputedValue value;
        value.word = word;
        value.argument = argument;
        const bool is_operand = !rules_.values_need_assignment;
        const Done taken = is_operand ? take_operand(value.value) : take_expression(value.value);
        if (taken && value.value.is_logical && !rules_.stores_comparisons)
            set_fault(diag::ExpressionSyntax, value.value.span);
        if (rules_.value_is_variable && !fault_) require_variable(value.value);
        if (!fault_) out_.computed.push_back(value);
        return finish(at, true);
    }

  private:
    /// `XE30`: neither a formula nor a sign stands there.
    void require_variable(const Expression& value) {
        using Kind = ControlInstruction::Kind;
        const std::string_view text =
            line_.substr(value.span.begin, value.span.end - value.span.begin);
        const bool is_operation = std::ranges::any_of(
            std::span(out_.code).subspan(value.first, value.count),
            [](const ControlInstruction& step) { return step.kind == Kind::Operate; });
        if (!is_operation && text.find(language_.open) == std::string_view::npos) return;
        set_fault(diag::ExpressionSyntax, value.span);
        fault_->fix = "a word takes one variable: give it the value in a block of its own first";
    }

    /// Whether a variable or a function gives the axis or the spindle of a word.
    bool begins_computed_index(std::size_t at, bool is_of_spindle) const {
        if (at >= line_.size()) return false;
        if (begins_reference(at) || (is_of_spindle && line_[at] == language_.open)) return true;
        const LetterRun word = words_.word_at(at);
        const bool is_function = std::ranges::any_of(
            language_.functions,
            [&](const FunctionForm& form) { return words_.matches(word, form.name); });
        if (!is_function) return false;
        // `SPI(2)`, but not `SPI(NUM)`, is a name as it stands.
        const std::string index = words_.normal(line_.substr(at));
        const std::size_t argument = index.find('(') + 1;
        const bool is_number = argument < index.size() && is_digit(index[argument]);
        return !is_spindle_name(index) || (argument > 0 && !is_number);
    }
    bool is_spindle_word(std::string_view name) const {
        return std::ranges::any_of(tables_.notation.spindle_words, [&](const std::string& word) {
            return words_.is_same(name, word);
        });
    }
    bool is_lone_axis_word(std::string_view name) const {
        return std::ranges::any_of(language_.lone_axis_words, [&](const std::string& word) {
            return words_.is_same(name, word);
        });
    }

    /// Whether a code of a call may begin here, or a word that belongs to one.
    bool begins_call_word(std::size_t at) const {
        if (context_.is_argument || !out_.calls.empty()) return true;
        const auto letter = static_cast<unsigned char>(words_.upper(line_[at]));
        return letter < 128 && language_.call_starts[letter];
    }

    /// A letter with its number, as most words are: nothing of the language begins so.
    bool is_plain_word(std::size_t at) const {
        const auto is_letter = [](char c) {
            return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
        };
        const char next = at + 1 < line_.size() ? line_[at + 1] : '\0';
        return is_letter(line_[at]) && !is_letter(next) &&
               !language_.variable_starts[static_cast<unsigned char>(line_[at])];
    }

    Try take_call_word() {
        if (context_.is_argument) return take_line_as_arguments();
        if (is_in_macro_call()) return take_words_of_macro();
        const Try code = take_code_call(context_);
        return code == Try::Taken ? code : take_word_of_call();
    }

    // ------------------------------------------------------------ assignments

    Try take_assignment() {
        ControlStatement statement;
        const Try taken = take_assign(statement);
        if (taken == Try::Taken) out_.statements.push_back(std::move(statement));
        return taken;
    }

    Try take_assign(ControlStatement& out) {
        skip();
        const std::size_t begin = at_;
        // A named variable stands between brackets, on the left as well: `[#_UO[3]]=1`.
        const bool is_bracketed =
            peek() == language_.open && begins_reference(words_.skip_blanks(at_ + 1));
        if (!is_bracketed && !begins_reference(at_)) return not_taken();
        if (is_bracketed && !take_open(language_.open)) return not_taken();
        if (!take_reference(out.variable)) return not_taken();
        if (is_bracketed && !take_close(language_.close)) return not_taken();
        skip();
        if (peek() != '=') return tried(fail_here(diag::AssignmentMissing));
        ++at_;
        out.kind = Statement::Assign;
        if (take_list(out) != Try::Taken && (fault_ || !take_stored(out.value))) return not_taken();
        out.span = span_from(begin);
        return Try::Taken;
    }

    /// `SET(1,,3)`, `REP(0)`: values for an array.
    Try take_list(ControlStatement& out) {
        skip();
        const LetterRun word = words_.word_at(at_);
        const auto form = std::ranges::find_if(language_.functions, [&](const FunctionForm& f) {
            return (f.operation == Operation::List || f.operation == Operation::Fill) &&
                   words_.matches(word, f.name);
        });
        if (form == language_.functions.end()) return not_taken();
        at_ += word.text.size();
        tables_.note(&*form);
        out.fills = form->operation == Operation::Fill;
        if (!take_values(out.list)) return not_taken();
        // The value, and how many elements get it.
        const bool has_more = out.fills && out.list.size() > 2;
        return has_more ? tried(fail(diag::ArgumentsWrong, span_from(word.begin))) : Try::Taken;
    }

    Done take_values(std::vector<Expression>& out) {
        if (!take_open(language_.open)) return kFailed;
        do {
            if (!out.empty()) ++at_;
            out.emplace_back();
            skip();
            if (peek() != ',' && peek() != language_.close && !take_stored(out.back()))
                return kFailed;
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

    Try take_statement() {
        ControlStatement statement;
        const Try taken = take_pattern(statement, [](Statement) { return true; });
        if (taken == Try::Taken) out_.statements.push_back(std::move(statement));
        return taken;
    }

    /// One of the statements that `is_wanted` accepts. Of several patterns with one keyword the
    /// first that fits is taken; if none does, the fault of the one that came farthest is reported.
    template <typename IsWanted>
    Try take_pattern(ControlStatement& out, IsWanted is_wanted) {
        skip();
        const std::size_t start = at_;
        std::optional<LineFault> farthest;
        const std::size_t code = out_.code.size();
        for (const StatementForm& form : language_.statements) {
            const std::optional<std::size_t> front =
                form.front.empty() ? start : behind_front(words_, line_, form, start);
            if (!front) continue;
            const std::size_t begin = *front;
            const LetterRun word = words_.word_at(begin);
            const bool has_number_in_front = begins_with_loop(form);
            if (has_number_in_front ? !loop_in_front(words_, line_, form, begin)
                                    : word.text.size() < 2 && !language_.has_label_numbers)
                continue;
            if (!words_.matches_with_digits(word, form.tokens[0].text) ||
                !is_wanted(form.statement))
                continue;
            if (wants_call(form) && !begins_call(begin + word.text.size())) continue;
            at_ = begin;
            depth_ = 0;
            fault_.reset();
            out_.code.resize(code);
            out_.spans.resize(code);
            out_.calls.clear();
            ControlStatement statement;
            statement.kind = form.statement;
            statement.closes = form.closes;
            statement.span = {static_cast<std::uint32_t>(begin),
                              static_cast<std::uint32_t>(begin + word.text.size())};
            if (take_tokens(form, word, statement)) {
                tables_.note(&form);
                if (form.operation) join_values(*form.operation, statement);
                if (form.operation && statement.kind == Statement::Jump)
                    make_conditional(statement);
                if (statement.kind == Statement::IfDo && statement.inner.empty())
                    jump_to_target(statement);
                out = std::move(statement);
                return Try::Taken;
            }
            // One letter begins words of other kinds as well.
            if (form.tokens[0].text.size() == 1 && !has_number_in_front) fault_.reset();
            else if (!farthest || (fault_ && fault_->span.begin > farthest->span.begin))
                farthest = fault_;
        }
        fault_ = std::move(farthest);
        if (fault_) return Try::Failed;
        at_ = start;
        return Try::Absent;
    }

    /// `IF [VC1 EQ 2] N20`: a target alone is a jump.
    static void jump_to_target(ControlStatement& condition) {
        ControlStatement jump;
        jump.kind = Statement::Jump;
        jump.span = condition.target.span;
        jump.target = std::exchange(condition.target, {});
        condition.inner.push_back(std::move(jump));
    }

    /// The values of a statement stand in the code side by side; together they are one.
    void join_values(Operation operation, ControlStatement& out) {
        emit_operation(operation, out.second.is_given() ? 2 : 1, out.value.span.begin);
        out.value.count = static_cast<std::uint32_t>(out_.code.size()) - out.value.first;
        if (out.second.is_given()) out.value.span.end = out.second.span.end;
        out.second = {};
    }

    /// `D09 P01 {value} P02 {last} P03 {target}`: a jump that depends on what its values are.
    static void make_conditional(ControlStatement& jump) {
        ControlStatement outer;
        outer.kind = Statement::IfDo;
        outer.span = jump.span;
        outer.value = jump.value;
        jump.value = {};
        outer.inner.push_back(std::move(jump));
        jump = std::move(outer);
    }

    /// Whether a program must be named directly behind the keyword, or it is another word.
    static bool wants_call(const StatementForm& form) {
        return form.tokens.size() > 1 && form.tokens[1].kind == StatementToken::Kind::Hole &&
               form.tokens[1].hole == StatementToken::Hole::Call;
    }

    Done take_tokens(const StatementForm& form, const LetterRun& keyword, ControlStatement& out) {
        at_ += words_.length_of(keyword, form.tokens[0].text);
        for (std::size_t i = 1; i < form.tokens.size(); ++i) {
            const StatementToken& token = form.tokens[i];
            skip();
            if (may_follow_comment(token)) at_ = words_.skip_comments(at_);
            switch (token.kind) {
                case StatementToken::Kind::Word: {
                    const LetterRun word = words_.word_at(at_);
                    if (!words_.matches_with_digits(word, token.text)) {
                        if (token.is_optional) return require_finished();
                        if (at_ < line_.size()) return fail_here(diag::StatementSyntax);
                        return fail_missing(token.text);
                    }
                    at_ += words_.length_of(word, token.text);
                    break;
                }
                case StatementToken::Kind::Sign:
                    if (token.is_optional && peek() != token.text[0]) return require_finished();
                    if (!take_pattern_sign(token.text[0])) return kFailed;
                    break;
                case StatementToken::Kind::Hole: {
                    const StatementToken* next =
                        i + 1 < form.tokens.size() ? &form.tokens[i + 1] : nullptr;
                    if (token.is_optional && !begins_hole(token)) break;
                    const Try hole = take_hole(token.hole, next, out);
                    if (hole == Try::Absent) return fail_here(diag::StatementSyntax);
                    if (hole == Try::Failed) return kFailed;
                    break;
                }
            }
        }
        return form.repeats ? kDone : require_finished();
    }

    /// The line ends in front of a word of the statement.
    Done fail_missing(const std::string& word) {
        set_fault_here(diag::StatementWordMissing);
        fault_->arguments = {word};
        return kFailed;
    }

    /// Nothing but a comment behind the statement.
    Done require_finished() {
        skip();
        if (is_inner_ || words_.is_end(at_)) return kDone;
        return fail_here(rules_.mixes_words ? diag::StatementSyntax : diag::MixedStatement);
    }

    /// Comments stand between words, not between the letters and the number of one (`GOTO5`), and
    /// in what is taken as it stands they are text.
    static bool may_follow_comment(const StatementToken& token) {
        using Hole = StatementToken::Hole;
        return token.kind != StatementToken::Kind::Hole || token.hole == Hole::Condition ||
               token.hole == Hole::Statement || token.hole == Hole::Jump;
    }

    Done take_pattern_sign(char sign) {
        if (sign == language_.open) return take_open(sign);
        if (sign == language_.close) return take_close(sign);
        return take_sign(sign);
    }

    bool begins_hole(const StatementToken& token) {
        using Hole = StatementToken::Hole;
        if (words_.is_end(at_)) return false;
        if (token.hole == Hole::To || token.hole == Hole::From) {
            // `P=3` behind a label is none.
            const LetterRun word = words_.word_at(at_);
            const std::size_t next = words_.skip_blanks(at_ + word.text.size());
            return !word.text.empty() && (next >= line_.size() || line_[next] != '=');
        }
        return peek() != language_.close;
    }

    Try take_hole(StatementToken::Hole hole, const StatementToken* next, ControlStatement& out) {
        using Hole = StatementToken::Hole;
        switch (hole) {
            case Hole::Variable: return tried(take_reference(out.variable));
            case Hole::Condition:
                if (!take_expression(out.value)) return Try::Failed;
                if (rules_.stores_comparisons || out.value.is_logical) return Try::Taken;
                skip();
                if (!words_.is_end(at_) && peek() != language_.close)
                    return tried(fail_here(diag::ExpressionSyntax));
                return tried(fail(diag::ExpressionSyntax, out.value.span));
            case Hole::Value:
            case Hole::First:
            case Hole::Number: return tried(take_stored(out.value));
            case Hole::Last:
            case Hole::Text: return tried(take_stored(out.second));
            case Hole::Count: return tried(take_stored(out.count));
            case Hole::Target: return tried(take_target(out.target));
            case Hole::From: return tried(take_target(out.from));
            case Hole::To: return tried(take_target(out.to));
            case Hole::Loop: return tried(take_loop_number(out));
            case Hole::Type:
                return tried(Done(take_scope(out) && take_type(out) && take_scope(out)));
            case Hole::Declarations: return tried(take_declarations(out));
            case Hole::Cases: return take_cases(next, out);
            case Hole::Jump: return take_inner(out, false);
            case Hole::Statement: return take_inner(out, true);
            case Hole::Call: return tried(take_call_hole(out));
            case Hole::Procedure: return tried(take_procedure(out));
            case Hole::Print: return tried(take_print(out));
            case Hole::Rest: return take_rest(out.name);
            case Hole::Table: {
                takes_whole_arrays_ = true;
                const Done taken = take_reference(out.table);
                takes_whole_arrays_ = false;
                return tried(taken);
            }
            case Hole::Row: return tried(take_row(out.table));
        }
        return Try::Absent;
    }

    Try take_inner(ControlStatement& out, bool is_any) {
        const auto is_wanted = [](Statement statement) {
            return statement >= Statement::Jump && statement <= Statement::JumpToStart;
        };
        const bool was_inner = is_inner_;
        is_inner_ = true;
        ControlStatement inner;
        Try taken = take_pattern(inner, is_wanted);
        if (taken == Try::Absent && is_any) taken = take_assign(inner);
        is_inner_ = was_inner;
        if (taken == Try::Absent && is_any) {
            // `IF[#1 EQ 5]THEN` at the end of its line, for blocks that come behind.
            if (words_.is_end(at_)) return tried(fail_missing("assignment"));
            return tried(fail_here(diag::MixedStatement));
        }
        if (taken != Try::Taken) return taken;
        out.inner.push_back(std::move(inner));
        return Try::Taken;
    }

    /// `KTAB[3]`
    Done take_row(Reference& out) {
        takes_rows_ = true;
        const Done taken = take_reference(out);
        takes_rows_ = false;
        if (!taken) return kFailed;
        const bool is_row = out.load.kind == ControlInstruction::Kind::Element &&
                            out.load.count == 1 && symbols_.at(out.load.index).dimensions == 2;
        return is_row ? kDone : fail(diag::IndexWrong, out.span);
    }

    /// All up to the end of the block, or a comment.
    Try take_rest(std::string& out) {
        const std::size_t begin = at_;
        while (!words_.is_end(at_)) ++at_;
        const std::size_t end = words_.trim(begin, at_);
        out = line_.substr(begin, end - begin);
        return out.empty() ? Try::Absent : Try::Taken;
    }

    /// `X#100[53]**DEPTH`: text as it stands, a blank for each `*`, values with their digits.
    Done take_print(ControlStatement& statement) {
        std::vector<PrintPiece>& out = statement.print;
        const bool is_bytes = statement.kind == Statement::PrintBytes;
        while (at_ < line_.size() && peek() != language_.close) {
            if (words_.begins_variable(at_)) {
                out.emplace_back();
                if (!take_printed_value(out.back(), is_bytes)) return kFailed;
                continue;
            }
            if (out.empty() || out.back().value.is_given()) out.emplace_back();
            out.back().text += peek() == '*' ? ' ' : peek();
            ++at_;
        }
        return kDone;
    }

    /// is_bytes  only the decimals are given, `#100[3]`
    Done take_printed_value(PrintPiece& out, bool is_bytes) {
        const std::size_t begin = at_;
        if (!take_operand(out.value)) return kFailed;
        const auto digit = [this](std::size_t at) {
            return at < line_.size() && line_[at] >= '0' && line_[at] <= '9' ? line_[at] - '0' : -1;
        };
        const std::size_t digits_end = at_ + (is_bytes ? 2 : 3);
        const bool is_format = peek() == language_.index_open && digit(at_ + 1) >= 0 &&
                               (is_bytes || digit(at_ + 2) >= 0) && digits_end < line_.size() &&
                               line_[digits_end] == language_.index_close;
        if (is_format) {
            out.whole = is_bytes ? 0 : digit(at_ + 1);
            out.decimals = digit(digits_end - 1);
            at_ = digits_end + 1;
        } else {
            // What was meant to be one goes up to the bracket.
            const std::size_t close = line_.find(language_.index_close, at_);
            at_ = close < line_.size() ? close + 1 : line_.size();
        }
        const int digits = out.whole + out.decimals;
        if (is_format && (digits > 0 || is_bytes) && digits <= rules_.print_digits) return kDone;
        return fail(diag::PrintFormat, span_from(begin));
    }

    /// Whether letters stand on both sides: `END` of `ENDIF` is no statement.
    bool is_inside_word(std::size_t at) const {
        return at > 0 && at < line_.size() && is_letter(line_[at - 1]) && is_letter(line_[at]);
    }

    Done fail_whole_word(std::size_t at) {
        std::size_t begin = at;
        while (begin > 0 && is_letter(line_[begin - 1])) --begin;
        while (at < line_.size() && is_letter(line_[at])) ++at;
        fault_ = LineFault{&diag::IsoUnknownWord,
                           {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at)},
                           {std::string(line_.substr(begin, at - begin))}};
        return kFailed;
    }

    Done take_loop_number(ControlStatement& out) {
        skip();
        const std::size_t begin = at_;
        int number = 0;
        while (peek() >= '0' && peek() <= '9' && number < 100000)
            number = number * 10 + (line_[at_++] - '0');
        if (is_inside_word(begin)) return fail_whole_word(begin);
        if (at_ == begin || number < 1 || number > rules_.loop_numbers) {
            return at_ == begin ? fail_here(diag::LoopNumber)
                                : fail(diag::LoopNumber, span_from(begin));
        }
        out.loop = number;
        return kDone;
    }

    /// `100`, `N100`, `LABEL`, or a value that is one of them.
    Done take_target(JumpTarget& out) {
        skip();
        const std::size_t begin = at_;
        const LetterRun word = words_.word_at(at_);
        if (language_.has_label_numbers) return take_label_number(out);
        const bool has_labels = language_.has_labels();
        if (!language_.label_sign.empty() && line_.substr(at_).starts_with(language_.label_sign))
            ++at_;
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
            return require_no_label_sign(begin);
        }
        if (!has_labels && language_.names_blocks) return take_block_word(word, out);
        if (!has_labels && !require_lone_number(begin)) return kFailed;
        out.kind = JumpTarget::Kind::Computed;
        const Done taken = has_labels ? take_expression(out.value) : take_operand(out.value);
        out.span = out.value.span;
        return taken;
    }

    /// `N20`, where a jump says a block by its word.
    Done take_block_word(const LetterRun& word, JumpTarget& out) {
        out.number = words_.block_number(words_.normal(word.text));
        if (out.number < 0) return fail_here(diag::StatementSyntax);
        at_ += word.text.size();
        out.kind = JumpTarget::Kind::Number;
        out.span = span_from(word.begin);
        return kDone;
    }

    /// `GOTOF MARK1:`: the sign belongs to the label, and not to the jump.
    Done require_no_label_sign(std::size_t begin) {
        if (language_.label_sign.empty()) return kDone;
        if (!line_.substr(at_).starts_with(language_.label_sign)) return kDone;
        const std::string target(line_.substr(begin, at_ - begin));
        set_fault_here(diag::StatementSyntax);
        fault_->fix = "the target of a jump stands without it: `" + target + '`';
        return kFailed;
    }

    /// `GOTO N10` where the number stands alone.
    Done require_lone_number(std::size_t begin) {
        std::size_t end = begin + 1;
        while (end < line_.size() && is_digit(line_[end])) ++end;
        const std::string_view name = line_.substr(std::min(begin, line_.size()), end - begin);
        if (words_.block_number(name) < 0) return kDone;
        set_fault(diag::StatementSyntax,
                  {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)});
        fault_->fix = "the number stands alone: `" + std::string(name.substr(1)) + '`';
        return kFailed;
    }

    /// `5`, `"CONTOUR"`: what the statement Label gives for a target.
    Done take_label_number(JumpTarget& out) {
        const std::size_t begin = at_;
        const std::string_view label = label_at(line_, at_);
        if (label.empty()) return fail_here(diag::StatementSyntax);
        at_ = begin + label.size() + (line_[begin] == '"' ? 2 : 0);
        out.kind = JumpTarget::Kind::Label;
        out.label = words_.normal(label);
        out.span = span_from(begin);
        return kDone;
    }

    // ------------------------------------------------------------ declarations

    /// `NCK`, `CHAN SYNR`, `APR 7` in front of the type tell for whom it is declared and who may
    /// read it, `PHU 3 LLI -5 ULI 10` behind it the unit, and what the variable may hold.
    Done take_scope(ControlStatement& out) {
        while (const std::string* const form = scope_word_here()) {
            const std::size_t begin = at_;
            if (!take_scope_word(*form, out)) return kFailed;
            if (out.scope.end == 0) out.scope = span_from(begin);
        }
        return kDone;
    }

    /// How the dialect writes the word of a declaration that stands here: `NCK`, `APR=` with a
    /// number behind it, `LLI..` with the least value, `..ULI` with the greatest. Null: none does.
    const std::string* scope_word_here() {
        skip();
        const LetterRun word = words_.word_at(at_);
        const auto& forms = language_.calls.scope_words;
        const auto found = std::ranges::find_if(forms, [&](const std::string& form) {
            return words_.is_same(word.text, scope_word(form));
        });
        return found == forms.end() ? nullptr : &*found;
    }

    Done take_scope_word(const std::string& form, ControlStatement& out) {
        at_ += scope_word(form).size();
        Expression passed;
        if (form.starts_with("..")) return take_stored(out.second);
        if (form.ends_with("..")) return take_stored(out.value);
        return form.ends_with('=') ? take_stored(passed) : kDone;
    }

    Done take_type(ControlStatement& out) {
        const LetterRun word = words_.word_at(at_);
        const auto found = std::ranges::find_if(language_.types, [&](const TypeName& type) {
            return words_.is_same(word.text, type.name);
        });
        if (found == language_.types.end()) {
            const std::string known = tables_.unsupported_words(words_.normal(word.text));
            return known.empty() ? fail_here(diag::StatementSyntax) : fail_unknown(word);
        }
        at_ += word.text.size();
        out.type = found->type;
        if (found->type != ValueType::Text) return kDone;
        return Done(take_open(language_.index_open) && take_stored(out.type_size) &&
                    take_close(language_.index_close));
    }

    Done take_declarations(ControlStatement& out) {
        do {
            if (!out.declarations.empty()) ++at_;
            out.declarations.emplace_back();
            if (!take_declaration(out.declarations.back())) return kFailed;
            skip();
        } while (peek() == ',');
        return kDone;
    }

    /// `VAR REAL LIST[4]`, of an external procedure without the name.
    Done take_parameter(ProcedureParameter& out, bool is_named) override {
        LetterRun word = words_.word_at(words_.skip_blanks(at_));
        skip();
        out.is_reference = !language_.calls.reference_word.empty() &&
                           words_.is_same(word.text, language_.calls.reference_word);
        if (out.is_reference) at_ += word.text.size();
        skip();
        ControlStatement typed;
        if (!take_type(typed)) return kFailed;
        out.type = typed.type;
        out.type_size = typed.type_size;
        skip();
        if (is_named) return take_declaration(out.declaration, true);
        // The name may stand there all the same.
        word = words_.word_at(at_);
        at_ += word.text.size();
        skip();
        return peek() != language_.index_open ? kDone : take_sizes(out.declaration, true);
    }

    Done take_declaration(Declaration& out, bool is_parameter = false) {
        skip();
        const LetterRun word = words_.word_at(at_);
        out.name = words_.normal(word.text);
        out.span = {static_cast<std::uint32_t>(at_),
                    static_cast<std::uint32_t>(at_ + std::max<std::size_t>(1, word.text.size()))};
        if (word.text.empty()) return fail_here(diag::StatementSyntax);
        if (out.name.size() > 31) return fail(diag::NameTooLong, out.span);
        const auto is_name_char = [](char c) { return (c >= 'A' && c <= 'Z') || c == '_'; };
        if (out.name.size() < 2 || !is_name_char(out.name[0]) || !is_name_char(out.name[1]))
            return fail(diag::NameInvalid, out.span);
        // The parameters of a program that was called are there already.
        if (is_taken(out.name, word) && !(is_parameter && symbols_.find(out.name) != nullptr))
            return fail(diag::NameTwice, out.span);
        at_ += word.text.size();
        skip();
        if (peek() == language_.index_open && !take_sizes(out, is_parameter)) return kFailed;
        skip();
        if (peek() != '=') return kDone;
        ++at_;
        return take_initial_values(out);
    }

    bool is_taken(const std::string& name, const LetterRun& word) const {
        if (symbols_.has_own(name) || tables_.find_address(name) != kNoAddress) return true;
        const auto same = [&](const auto& form) { return words_.is_same(word.text, form.name); };
        return words_.is_same(word.text, language_.axis_word) || is_lone_axis_word(word.text) ||
               std::ranges::any_of(language_.functions, same) ||
               std::ranges::any_of(language_.variables, same) ||
               std::ranges::any_of(language_.types, same) ||
               std::ranges::any_of(language_.statements, [&](const StatementForm& form) {
                   return words_.is_same(word.text, form.tokens[0].text);
               });
    }

    /// `[3,4]`; of a parameter `[,]` as well.
    Done take_sizes(Declaration& out, bool is_parameter = false) {
        if (!take_open(language_.index_open)) return kFailed;
        do {
            if (out.dimensions > 0) ++at_;
            if (out.dimensions == 3) return fail_here(diag::TooManyDimensions);
            Expression& size = out.sizes[out.dimensions++];
            skip();
            const bool is_open = is_parameter && (peek() == ',' || peek() == language_.index_close);
            if (!is_open && !take_stored(size)) return kFailed;
            skip();
        } while (peek() == ',');
        return take_close(language_.index_close);
    }

    Done take_initial_values(Declaration& out) {
        ControlStatement list;
        const Try taken = take_list(list);
        if (taken == Try::Taken) {
            out.values = std::move(list.list);
            out.fills = list.fills;
            return kDone;
        }
        if (taken == Try::Failed) return kFailed;
        skip();
        if (out.dimensions > 0 && peek() == language_.open) return take_values(out.values);
        out.values.emplace_back();
        return take_stored(out.values.back());
    }

    // ------------------------------------------------------------ cases

    Try take_cases(const StatementToken* next, ControlStatement& out) {
        while (true) {
            skip();
            if (words_.is_end(at_)) return out.list.empty() ? Try::Absent : Try::Taken;
            if (next != nullptr && words_.matches(words_.word_at(at_), next->text))
                return Try::Taken;
            out.list.emplace_back();
            if (!take_operand(out.list.back())) return Try::Failed;
            const Try jump = take_inner(out, false);
            if (jump != Try::Taken) return jump;
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
        if (is_call_with_words(statements[0])) return {};
        if (!rules_.mixes_words && (has_words || statements.size() > 1)) {
            return fault(diag::MixedStatement,
                         statements.size() > 1 ? statements[1].span : statements[0].span);
        }
        const bool are_jumps = std::ranges::all_of(
            statements, [](const ControlStatement& s) { return s.kind == Statement::IfDo; });
        if (!are_assignments && (has_words || (statements.size() > 1 && !are_jumps)))
            return fault(diag::MixedStatement, statements.back().span);
        const bool is_structure =
            statements[0].kind >= Statement::If && statements[0].kind <= Statement::Until;
        if (is_structure && rules_.mixes_words &&
            (out_.words.skip_level >= 0 || !out_.words.label.empty()))
            return fault(diag::StructureWithLabel, statements[0].span);
        return {};
    }

    /// A subprogram is called, or ended, behind the words of its block.
    bool is_call_with_words(const ControlStatement& statement) const {
        const bool is_call = statement.kind == Statement::Call ||
                             statement.kind == Statement::Return ||
                             statement.kind == Statement::EndModal;
        if (!is_call || out_.statements.size() != 1 || out_.calls.empty()) return false;
        const std::int32_t form = out_.calls[0].form;
        return form >= 0 && !language_.calls.calls[static_cast<std::size_t>(form)].is_name;
    }

    const LineContext context_;
    bool is_inner_ = false;
};

}  // namespace

MachineAxisNames usual_axis_names(std::span<const Axis> axes) {
    MachineAxisNames names;
    for (std::size_t i = 0; i < kAxes; ++i) {
        const auto axis = static_cast<Axis>(i);
        names.emplace(std::string(kAxisNames[i]) + '1', axis);
        if (axes.empty()) names.emplace("AX" + std::to_string(i + 1), axis);
    }
    for (std::size_t i = 0; i < axes.size(); ++i)
        names.emplace("AX" + std::to_string(i + 1), axes[i]);
    return names;
}

std::optional<LineFault> compile_line(const DialectTables& tables, const SymbolTable& symbols,
                                      std::string_view line, ControlLine& out,
                                      const LineContext& context) {
    out.clear();
    if (has_split_words(tables, line)) {
        const LineWithoutBlanks whole = without_blanks(tables, line);
        if (!ControlLineCompiler(tables, symbols, whole.text, out, context).run()) {
            whole.put_back(out);
            return {};
        }
        out.clear();  // what is wrong is reported of the line as it was written
    }
    return ControlLineCompiler(tables, symbols, line, out, context).run();
}

}  // namespace kadr::nc
