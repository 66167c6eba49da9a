// What a dialect says about a word of the control's own language, in sentences.
#include <algorithm>

#include "base/text.h"
#include "nc/explain_parts.h"
#include "nc/quoted.h"

namespace kadr::nc {

namespace {

void explain_range(const VariableForm& form, const VariableRange& range,
                   std::vector<std::string>& lines) {
    std::string line = quoted(form.form);
    if (form.is_family && range.last > range.first) {
        line += " from " + std::to_string(range.first) + " to " + std::to_string(range.last);
    }
    switch (range.kind) {
        case VariableRange::Kind::Global: line += " is a variable of the whole run"; break;
        case VariableRange::Kind::Local: line += " is a variable of each level of calls"; break;
        case VariableRange::Kind::Constant: line += " is a constant"; break;
        case VariableRange::Kind::System:
            line.append(" is ").append(info(range.quantity).name);
            line.append(": ").append(info(range.quantity).meaning);
            break;
        case VariableRange::Kind::Same:
            line += " is another name of number " +
                    std::to_string(static_cast<std::int64_t>(range.value));
            break;
        case VariableRange::Kind::Unsupported:
            line += " is known to the control; Kadr does not read it";
            break;
    }
    if (!range.meaning.empty()) line += "; " + range.meaning;
    lines.push_back(std::move(line));
}

void explain_variables(const Language& language, std::string_view word,
                       std::vector<std::string>& lines) {
    for (const VariableForm& form : language.variables) {
        if (!form.closing.empty()) {
            if (word.starts_with(form.name) && word.ends_with(form.closing))
                explain_range(form, form.ranges[0], lines);
            continue;
        }
        if (!form.is_family) {
            if (form.name == word) explain_range(form, form.ranges[0], lines);
            continue;
        }
        if (!word.starts_with(form.name)) continue;
        const std::string_view digits = word.substr(form.name.size());
        const bool is_number = !digits.empty() && digits.size() < 10 &&
                               digits.find_first_not_of("0123456789") == std::string_view::npos;
        if (!is_number) continue;
        const VariableRange* range = find_range(form, std::stoll(std::string(digits)));
        if (range != nullptr) explain_range(form, *range, lines);
    }
}

std::string_view kind_of(const CallForm& call) {
    switch (call.kind) {
        case CallForm::Kind::Subprogram: return "calls a subprogram, behind the words of its block";
        case CallForm::Kind::Macro: return "calls a macro with arguments";
        case CallForm::Kind::Return: return "ends a program that was called";
        case CallForm::Kind::EndModal: return "ends a modal call";
    }
    return "";
}

/// Which address of the call says what: `P the program`.
void add_address(char letter, std::string_view meaning, std::string& line) {
    if (letter != '\0') line.append("; ").append(1, letter).append(" is ").append(meaning);
}

void explain_calls(const CallLanguage& calls, std::string_view word,
                   std::vector<std::string>& lines) {
    for (const CallForm& call : calls.calls) {
        if (call.code != word) continue;
        std::string line = quoted(call.code).append(" ").append(kind_of(call));
        if (call.modal == CallForm::Modal::Motion)
            line += ", behind every block that moves an axis";
        if (call.modal == CallForm::Modal::Block) line += ", instead of every block";
        if (!call.fixed.empty()) line += ": always " + shown_program(calls, call.fixed);
        add_address(call.program, "the program", line);
        add_address(call.repeats, "how often", line);
        add_address(call.start, "the block where it begins", line);
        add_address(call.target, "the block of the caller where that goes on", line);
        if (!call.value.empty()) line += "; " + quoted(call.value) + " gets the number";
        if (!call.doc.empty()) line += "; " + call.doc;
        lines.push_back(std::move(line));
    }
    for (const ArgumentForm& argument : calls.arguments) {
        if (word.size() != 1 || argument.letter != word[0]) continue;
        std::string line =
            quoted(word) + " as an argument of a call sets " + quoted(argument.variable);
        if (argument.in_series) line += ", said again the one three places behind";
        if (argument.only_block) line += ", only where whole blocks are arguments";
        lines.push_back(std::move(line));
    }
}

}  // namespace

void explain_language(const Language& language, std::string_view word,
                      std::vector<std::string>& lines) {
    for (const OperatorForm& form : language.operators) {
        if (form.text != word) continue;
        std::string line = quoted(word) + (form.is_prefix ? " before a value" : " between values");
        line.append(" is ").append(info(form.operation).name);
        line.append(": ").append(info(form.operation).meaning);
        line += "; level " + std::to_string(form.level) + " of " +
                std::to_string(language.lowest_level) + ", where 1 binds strongest";
        lines.push_back(std::move(line));
    }
    for (const FunctionForm& form : language.functions) {
        if (form.name != word) continue;
        std::string line = quoted(form.form).append(" is ").append(info(form.operation).name);
        line.append(": ").append(info(form.operation).meaning);
        if (!form.doc.empty()) line += "; " + form.doc;
        lines.push_back(std::move(line));
    }
    for (const StatementForm& form : language.statements) {
        if (form.tokens[0].text != word) continue;
        std::string line = quoted(form.form).append(" is ").append(info(form.statement).name);
        line.append(": ").append(info(form.statement).meaning);
        if (!form.doc.empty()) line += "; " + form.doc;
        lines.push_back(std::move(line));
    }
    explain_variables(language, word, lines);
    explain_calls(language.calls, word, lines);
}

}  // namespace kadr::nc
