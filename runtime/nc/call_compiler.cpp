#include "nc/call_compiler.h"

#include <algorithm>
#include <cmath>

#include "base/diagnostics/iso.h"
#include "nc/letters.h"

namespace kadr::nc {

namespace {

/// How many variables the next round of a series lies behind.
constexpr std::uint32_t kSeriesStep = 3;

}  // namespace

bool CallCompiler::comes_to_end() {
    skip();
    return words_.is_end(at_);
}

// ---------------------------------------------------------------- codes

/// The form whose code stands at `at`, which then is behind it; of `T{n}` behind the letter.
const CallForm* CallCompiler::find_code(std::size_t& at, const LineContext& context) const {
    const char letter = words_.upper(line_[at]);
    if (static_cast<unsigned char>(letter) >= 128 ||
        !language_.call_starts[static_cast<unsigned char>(letter)])
        return nullptr;
    const std::size_t first = words_.is_blank_insensitive() ? words_.skip_blanks(at + 1) : at + 1;
    const Decimal decimal =
        parse_decimal(line_.data() + std::min(first, line_.size()), line_.data() + line_.size());
    const auto end = static_cast<std::size_t>(decimal.end - line_.data());
    for (const CallForm& form : language_.calls.calls) {
        if (form.is_name || form.letter != letter) continue;
        if (context.has_plain_codes && !form.fixed.empty()) continue;
        if (form.any_number) {
            // `S1000`, `S#1`; in `SETVN` the letter begins a name.
            if (first < line_.size() && is_letter(line_[first])) continue;
            at = first;
            return &form;
        }
        const bool is_same = end > first && is_digit(line_[first]) && decimal.value == form.number;
        if (!is_same) continue;
        at = end;
        return &form;
    }
    return nullptr;
}

ControlStatement& CallCompiler::add_call(const CallForm& form, Statement kind, std::size_t begin) {
    ControlStatement statement;
    statement.kind = kind;
    statement.call = static_cast<std::uint32_t>(out_.calls.size());
    statement.span = span_from(begin);
    out_.calls.emplace_back();
    out_.calls.back().form = static_cast<std::int32_t>(&form - language_.calls.calls.data());
    out_.calls.back().span = statement.span;
    out_.statements.push_back(std::move(statement));
    return out_.statements.back();
}

Try CallCompiler::take_code_call(const LineContext& context) {
    skip();
    if (at_ >= line_.size()) return not_taken();
    const std::size_t begin = at_;
    std::size_t behind = at_;
    const CallForm* const form = find_code(behind, context);
    if (form == nullptr) return not_taken();
    at_ = behind;
    if (open_call_ >= 0) return tried(fail(diag::CallTwice, span_from(begin)));
    using Kind = CallForm::Kind;
    const bool is_macro = form->kind == Kind::Macro;
    const Statement kind = form->kind == Kind::Return             ? Statement::Return
                           : form->kind == Kind::EndModal         ? Statement::EndModal
                           : form->modal != CallForm::Modal::None ? Statement::CallModal
                                                                  : Statement::Call;
    if (is_macro && (!out_.words.words.empty() || !out_.statements.empty()))
        return tried(fail(diag::MixedStatement, span_from(begin)));
    add_call(*form, kind, begin);
    open_call_ = static_cast<std::int32_t>(out_.calls.size()) - 1;
    Call& call = out_.calls.back();
    if (form->any_number && !take_value_of_word(call.code)) return not_taken();
    if (form->program != '\0' && !take_program_in_brackets(call)) return not_taken();
    if (is_macro) take_words_of_macro();
    return tried(Done(!fault_));
}

bool CallCompiler::is_in_macro_call() const {
    if (open_call_ < 0) return false;
    const Call& call = out_.calls[static_cast<std::size_t>(open_call_)];
    const CallForm& form = language_.calls.calls[static_cast<std::size_t>(call.form)];
    return form.kind == CallForm::Kind::Macro;
}

Try CallCompiler::take_words_of_macro() {
    const std::size_t begin = at_;
    while (!comes_to_end()) {
        if (take_word_of_call() == Try::Taken) continue;
        Call& call = out_.calls[static_cast<std::size_t>(open_call_)];
        if (fault_ || !take_letter_argument(call, false)) return not_taken();
    }
    return at_ != begin ? Try::Taken : Try::Absent;
}

/// `<PART_17>` directly behind the code.
Done CallCompiler::take_program_in_brackets(Call& call) {
    const std::size_t begin = words_.skip_comments(at_);
    if (begin >= line_.size() || line_[begin] != '<') return kDone;
    at_ = begin;
    const std::size_t close = line_.find('>', at_);
    if (close == std::string_view::npos || close == at_ + 1) {
        return fail(diag::CallIncomplete,
                    {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(line_.size())});
    }
    call.name = program_of_path(language_.calls, line_.substr(at_ + 1, close - at_ - 1),
                                tables_.notation.ignores_case);
    at_ = close + 1;
    call.program.span = span_from(begin);
    return kDone;
}

/// P and L of a call, wherever they stand behind its code.
Try CallCompiler::take_word_of_call() {
    if (open_call_ < 0) return not_taken();
    skip();
    if (at_ >= line_.size() || !is_letter(line_[at_])) return not_taken();
    Call& call = out_.calls[static_cast<std::size_t>(open_call_)];
    const CallForm& form = language_.calls.calls[static_cast<std::size_t>(call.form)];
    const char letter = words_.upper(line_[at_]);
    CallValue* const value = letter == form.program   ? &call.program
                             : letter == form.repeats ? &call.repeats
                             : letter == form.start   ? &call.start
                             : letter == form.target  ? &call.target
                                                      : nullptr;
    if (value == nullptr || letter == '\0' || value->is_given) return not_taken();
    if (value == &call.program && !call.name.empty()) return not_taken();
    const std::size_t begin = at_++;
    if (!take_value_of_word(*value)) return not_taken();
    value->span = span_from(begin);
    if (value->is_plain && value->decimal.has_point && !rules_.values_need_assignment)
        return tried(fail(diag::IsoPointNotAllowed, value->span));
    return Try::Taken;
}

/// `12`, `-1.5`, `#3`, `[#1*2]` behind a letter.
Done CallCompiler::take_value_of_word(CallValue& out) {
    skip();
    const std::size_t begin = at_;
    if (peek() == '=' && tables_.notation.has_assignment) ++at_;
    skip();
    const std::size_t first = at_;
    const Decimal decimal = parse_decimal(line_.data() + at_, line_.data() + line_.size());
    const auto end = static_cast<std::size_t>(decimal.end - line_.data());
    out.is_given = true;
    out.is_plain = end > first;
    if (out.is_plain) {
        out.decimal = decimal;
        at_ = end;
        out.span = span_from(begin);
        return kDone;
    }
    const std::size_t value = words_.skip_blanks(peek() == '-' || peek() == '+' ? at_ + 1 : at_);
    const bool begins_value =
        value < line_.size() && (line_[value] == language_.open || words_.begins_variable(value));
    if (!begins_value && !rules_.values_need_assignment) {
        fault_ =
            LineFault{&diag::IsoNoValue,
                      {static_cast<std::uint32_t>(begin - 1), static_cast<std::uint32_t>(begin)},
                      {std::string(line_.substr(begin - 1, 1))}};
        return kFailed;
    }
    const Done taken =
        rules_.values_need_assignment ? take_expression(out.value) : take_operand(out.value);
    out.span = span_from(begin);
    return taken;
}

Done CallCompiler::take_letter_argument(Call& call, bool is_block) {
    const std::size_t begin = at_;
    const char letter = words_.upper(line_[at_]);
    const auto& forms = language_.calls.arguments;
    const auto form = std::ranges::find_if(forms, [&](const ArgumentForm& f) {
        return f.letter == letter && (is_block || !f.only_block);
    });
    ++at_;
    if (form == forms.end()) return fail(diag::ArgumentLetter, span_from(begin));
    CallArgument argument;
    argument.slot = form->slot;
    argument.like = form->like == '\0' ? kNoAddress : tables_.find_address({&form->like, 1});
    if (form->in_series) {
        // Given again, or out of order: the next round of the series begins.
        const bool is_later = std::ranges::any_of(series_, [&](char c) { return c >= letter; });
        if (is_later) {
            series_.clear();
            ++rounds_;
        }
        series_.push_back(letter);
        if (rounds_ >= rules_.argument_series && rules_.argument_series > 1)
            return fail(diag::TooManyArgumentRounds, span_from(begin));
        if (rules_.argument_series > 1)
            argument.slot += kSeriesStep * static_cast<std::uint32_t>(rounds_);
    }
    if (!take_value_of_word(argument)) return kFailed;
    argument.span = span_from(begin);
    call.arguments.push_back(argument);
    return kDone;
}

Try CallCompiler::take_line_as_arguments() {
    if (comes_to_end()) return not_taken();  // a comment that is not closed is none
    const std::size_t first = at_;
    if (out_.calls.empty()) {
        ControlStatement statement;
        statement.kind = Statement::Call;
        statement.span.begin = static_cast<std::uint32_t>(first);
        out_.statements.push_back(std::move(statement));
        out_.calls.emplace_back();
    }
    // Behind a comment between its words the same line goes on.
    Call& call = out_.calls.back();
    const std::size_t begin = out_.statements.back().span.begin;
    while (!comes_to_end()) {
        if (!is_letter(line_[at_])) return tried(fail_here(diag::ArgumentLetter));
        if (!take_letter_argument(call, true)) return not_taken();
    }
    call.span = span_from(begin);
    out_.statements.back().span = call.span;
    return Try::Taken;
}

// ---------------------------------------------------------------- names

/// The name of a program at `at`, which then is behind it; empty: none stands there.
std::string CallCompiler::program_name(std::size_t& at) const {
    std::size_t end = at;
    while (end < line_.size() && (is_letter(line_[end]) || (end > at && is_digit(line_[end]))))
        ++end;
    std::string name = words_.normal(line_.substr(at, end - at));
    if (!name.empty() && form_of_name(name) == nullptr) {
        // `L10P2`: the passes stand directly behind the number of the program.
        const std::size_t behind = std::min(name.find_first_not_of("0123456789", 1), name.size());
        const CallForm* const form = form_of_name(name.substr(0, behind));
        if (form == nullptr || behind == name.size() || name[behind] != form->repeats) return {};
        end = at + behind;
        name.resize(behind);
    }
    if (name.empty()) return {};
    at = end;
    return name;
}

/// The form that takes the name: letters first for `{name}`, a letter and digits for `L{digits}`.
const CallForm* CallCompiler::form_of_name(std::string_view name) const {
    for (const CallForm& form : language_.calls.calls) {
        if (!form.is_name || name.size() < 2) continue;
        const bool is_digits = form.letter != '\0' && name.size() <= 8 && name[0] == form.letter &&
                               std::ranges::all_of(name.substr(1), is_digit);
        const bool is_free = form.letter == '\0' && is_letter(name[0]) && is_letter(name[1]);
        if (is_digits || is_free) return &form;
    }
    return nullptr;
}

bool CallCompiler::is_known_name(std::string_view name) const {
    if (symbols_.find(name) != nullptr || tables_.find_address(name) != kNoAddress) return true;
    const auto same = [&](const auto& form) { return words_.is_same(name, form.name); };
    return std::ranges::any_of(language_.functions, same) ||
           std::ranges::any_of(language_.types, same) ||
           std::ranges::any_of(language_.variables,
                               [&](const VariableForm& form) {
                                   return !form.is_family && words_.is_same(name, form.name);
                               }) ||
           std::ranges::any_of(language_.statements, [&](const StatementForm& form) {
               return words_.is_same(name, form.tokens[0].text);
           });
}

bool CallCompiler::begins_call(std::size_t at) const {
    at = words_.skip_blanks(at);
    if (at < line_.size() && line_[at] == '/') return true;
    const std::string name = program_name(at);
    return !name.empty() && !is_known_name(name);
}

Try CallCompiler::take_named_call() {
    if (!out_.words.words.empty() || !out_.statements.empty()) return not_taken();
    skip();
    const std::size_t begin = at_;
    const std::size_t code = out_.code.size();
    const auto give_up = [&] {
        at_ = begin;
        depth_ = 0;
        fault_.reset();
        out_.code.resize(code);
        out_.spans.resize(code);
        if (!out_.calls.empty()) out_.calls.pop_back();
        return Try::Absent;
    };
    Call call;
    // `P=3 NAME`: the passes before the name.
    const CallForm* form = nullptr;
    for (const CallForm& candidate : language_.calls.calls) {
        if (!candidate.is_name || candidate.repeats == '\0') continue;
        if (words_.upper(line_[at_]) != candidate.repeats) continue;
        const std::size_t next = words_.skip_blanks(at_ + 1);
        if (next >= line_.size() || (line_[next] != '=' && !is_digit(line_[next]))) continue;
        if (take_repeats(candidate, call.repeats) != Try::Taken) return give_up();
        skip();
        break;
    }
    const std::size_t name_begin = at_;
    call.name = program_name(at_);
    if (call.name.empty() || is_known_name(call.name) || tables_.is_passed(call.name))
        return give_up();
    form = form_of_name(call.name);
    call.form = static_cast<std::int32_t>(form - language_.calls.calls.data());
    call.span = span_from(name_begin);
    // Names that the control has for itself are not called; the lexer tells what they are.
    const bool is_own = !tables_.unsupported_words(call.name).empty();
    skip();
    if (peek() == ':' || (peek() == '=' && !call.repeats.is_given)) return give_up();
    out_.calls.push_back(std::move(call));
    Call& added = out_.calls.back();
    const bool has_list = peek() == language_.open;
    if (has_list && !take_call_list(added)) {
        if (is_own) return give_up();
        return not_taken();
    }
    skip();
    if (!added.repeats.is_given && words_.upper(peek()) == form->repeats &&
        take_repeats(*form, added.repeats) != Try::Taken)
        return give_up();
    if (!comes_to_end()) {
        const LineFault not_alone{&diag::CallNotAlone, added.span, {added.name}};
        give_up();
        if (has_list && !is_own) fault_ = not_alone;
        return not_taken();
    }
    ControlStatement statement;
    statement.kind = Statement::Call;
    statement.call = static_cast<std::uint32_t>(out_.calls.size()) - 1;
    statement.span = added.span;
    out_.statements.push_back(std::move(statement));
    return Try::Taken;
}

/// `P3`, `P=3`
Try CallCompiler::take_repeats(const CallForm& form, CallValue& out) {
    skip();
    if (words_.upper(peek()) != form.repeats) return not_taken();
    const std::size_t next = words_.skip_blanks(at_ + 1);
    if (next >= line_.size() || (line_[next] != '=' && !is_digit(line_[next]))) return not_taken();
    const bool is_assigned = line_[next] == '=';
    at_ = next;
    if (!is_assigned) return tried(take_value_of_word(out));
    ++at_;
    out.is_given = true;
    const std::size_t begin = at_;
    if (!take_stored(out.value)) return not_taken();
    out.span = span_from(begin);
    return Try::Taken;
}

Done CallCompiler::take_call_hole(ControlStatement& out) {
    skip();
    const std::size_t begin = at_;
    out.call = static_cast<std::uint32_t>(out_.calls.size());
    out_.calls.emplace_back();
    Call& call = out_.calls.back();
    if (peek() == '/') {
        std::size_t end = line_.find_first_of("( \t;", at_);
        end = std::min(end, line_.size());
        const std::string_view path = line_.substr(at_, end - at_);
        call.name = program_of_path(language_.calls, path, tables_.notation.ignores_case);
        call.kind = kind_of_path(language_.calls, path, tables_.notation.ignores_case);
        at_ = end;
    } else {
        call.name = program_name(at_);
    }
    call.span = span_from(begin);
    if (call.name.empty()) return fail(diag::CallIncomplete, call.span);
    skip();
    return peek() != language_.open ? kDone : take_call_list(call);
}

/// `(10,,R1,"TEXT")`
Done CallCompiler::take_call_list(Call& call) {
    call.has_list = true;
    if (!take_open(language_.open)) return kFailed;
    skip();
    if (peek() == language_.close) return take_close(language_.close);
    do {
        if (!call.arguments.empty()) ++at_;
        CallArgument argument;
        if (!take_listed(argument)) return kFailed;
        call.arguments.push_back(argument);
        skip();
    } while (peek() == ',');
    return take_close(language_.close);
}

/// An argument; of a variable alone its location is kept as well, for who takes it by reference.
Done CallCompiler::take_listed(CallArgument& out) {
    skip();
    if (peek() == ',' || peek() == language_.close) return kDone;
    const std::size_t begin = at_;
    out.is_given = true;
    if (begins_reference(at_)) {
        const std::size_t code = out_.code.size();
        takes_whole_arrays_ = true;
        const Done is_variable = take_reference(out.variable);
        takes_whole_arrays_ = false;
        skip();
        if (is_variable && (peek() == ',' || peek() == language_.close)) {
            const ControlInstruction& load = out.variable.load;
            out.is_array = load.kind == ControlInstruction::Kind::Element && load.count == 0 &&
                           symbols_.at(load.index).dimensions > 0;
            // The value as well, unless it is many.
            if (!out.is_array) {
                out.value = out.variable.indices;
                emit(load, begin);
                out.value.count = static_cast<std::uint32_t>(out_.code.size()) - out.value.first;
            }
            out.span = out.value.span = span_from(begin);
            return kDone;
        }
        fault_.reset();
        out.variable = {};
        out_.code.resize(code);
        out_.spans.resize(code);
        at_ = begin;
    }
    const Done taken = take_stored(out.value);
    out.span = span_from(begin);
    return taken;
}

// ---------------------------------------------------------------- procedures

/// `NAME(REAL A, VAR INT B=3) SAVE`; of an external one the types alone may stand there.
Done CallCompiler::take_procedure(ControlStatement& out) {
    skip();
    const std::size_t begin = at_;
    const bool is_named = out.kind == Statement::Procedure;
    out.name = program_name(at_);
    // Nobody is called by what stands in the head: there the name may be of any form.
    if (const LetterRun word = words_.word_at(at_);
        is_named && out.name.empty() && !word.text.empty()) {
        out.name = words_.normal(word.text);
        at_ += word.text.size();
    }
    if (out.name.empty()) return fail_here(diag::StatementSyntax);
    out.span = span_from(begin);
    skip();
    if (peek() == language_.open) {
        if (!take_open(language_.open)) return kFailed;
        skip();
        while (peek() != language_.close) {
            if (!out.parameters.empty() && !take_sign(',')) return kFailed;
            out.parameters.emplace_back();
            if (!take_parameter(out.parameters.back(), is_named)) return kFailed;
            const Declaration& added = out.parameters.back().declaration;
            const auto is_same = [&](const ProcedureParameter& other) {
                return is_named && other.declaration.name == added.name;
            };
            if (std::ranges::count_if(out.parameters, is_same) > 1)
                return fail(diag::NameTwice, added.span);
            skip();
        }
        if (!take_close(language_.close)) return kFailed;
    }
    while (!comes_to_end()) {
        const LetterRun word = words_.word_at(at_);
        const bool is_option = std::ranges::any_of(
            language_.calls.options,
            [&](const std::string& option) { return words_.is_same(word.text, option); });
        const bool is_save = words_.is_same(word.text, language_.calls.save_word);
        if (word.text.empty() || (!is_option && !is_save)) return fail_here(diag::StatementSyntax);
        out.saves |= is_save;
        at_ += word.text.size();
    }
    return kDone;
}

}  // namespace kadr::nc
