// What a dialect holds about a word of the control's own language, in sentences.
#include <algorithm>

#include "base/text.h"
#include "nc/explain_parts.h"
#include "nc/quoted.h"
#include "nc/scope_words.h"

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
        case VariableRange::Kind::Input:
            line += range.is_shared ? " is a value that the machine and the program write"
                                    : " is a value of the machine";
            line += "; without one 0 and a warning (docs/inputs.md)";
            break;
        case VariableRange::Kind::Bits:
            line += " is 32 bits, those of number " +
                    std::to_string(static_cast<std::int64_t>(range.value)) + " on";
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
        if (form.is_open) {
            if (word.starts_with(form.name)) explain_range(form, form.ranges[0], lines);
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

/// Which address of the call gives what: `P the program`.
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
        if (argument.in_series) line += ", programmed again the one three numbers behind";
        if (argument.only_block) line += ", only where whole blocks are arguments";
        lines.push_back(std::move(line));
    }
}

/// Whether a word stands at the front of a statement, or further on in it (`TO`, `DEFAULT`); `DO1`
/// is the word `DO` with the number that stands behind it.
bool has_word(const StatementForm& form, std::string_view word) {
    const std::string_view name = word.substr(0, word.find_last_not_of("0123456789") + 1);
    for (std::size_t i = 0; i < form.tokens.size(); ++i) {
        if (form.tokens[i].kind != StatementToken::Kind::Word) continue;
        const StatementToken::Hole next =
            i + 1 < form.tokens.size() ? form.tokens[i + 1].hole : StatementToken::Hole{};
        const bool takes_number =
            next == StatementToken::Hole::Loop || next == StatementToken::Hole::Target;
        if (form.tokens[i].text == word || (takes_number && form.tokens[i].text == name))
            return true;
    }
    return false;
}

bool is_among(const std::vector<std::string>& words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

std::string_view name_of(ValueType type) {
    switch (type) {
        case ValueType::Real: return "numbers";
        case ValueType::Int: return "whole numbers";
        case ValueType::Bool: return "TRUE and FALSE";
        case ValueType::Char: return "characters";
        case ValueType::Text: return "texts";
        case ValueType::Axis: return "axes";
        case ValueType::Frame: return "frames";
    }
    return "";
}

/// What a word beside the type of a declaration means.
std::string_view meaning_of_scope(std::string_view form) {
    if (form.starts_with(".."))
        return "behind the type of a variable says the greatest value that it holds";
    if (form.ends_with(".."))
        return "behind the type of a variable says the least value that it holds";
    if (form.ends_with('='))
        return "with a number, beside the type of a variable, has no effect here";
    return "before the type of a variable says for whom it is declared";
}

/// Words beside statements: types, what a head of a program declares, components, words with an
/// axis.
void explain_names(const Language& language, std::string_view word,
                   std::vector<std::string>& lines) {
    const auto add = [&](bool is_given, std::string_view meaning) {
        if (is_given) lines.push_back(quoted(word).append(" ").append(meaning));
    };
    for (const TypeName& type : language.types)
        add(type.name == word,
            std::string("is a type of variables, of ").append(name_of(type.type)));
    const CallLanguage& calls = language.calls;
    add(word == calls.save_word,
        "in the head of a program: what its caller had set acts again behind it");
    add(word == calls.reference_word,
        "before a parameter: it is the caller's variable, and not its value");
    add(is_among(calls.options, word),
        "in the head of a program says what the operator sees; it has no effect here");
    for (const std::string& form : calls.scope_words)
        add(scope_word(form) == word, meaning_of_scope(form));
    for (const FramePartName& part : language.frame_parts)
        add(part.word == word,
            std::string("behind the axis of a frame is its component ")
                .append(all_frame_parts()[static_cast<std::size_t>(part.part)].meaning));
    add(word == language.axis_word,
        "is the word of an axis that is worked out, `[axis]` behind it");
    add(is_among(language.lone_axis_words, word),
        "is the word of an axis that moves by itself, `[axis]` behind it");
    add(word == language.end_label, "is the label that ends a section that is repeated");
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
        if (!has_word(form, word)) continue;
        std::string line = quoted(form.form).append(" is ").append(info(form.statement).name);
        line.append(": ").append(info(form.statement).meaning);
        if (!form.doc.empty()) line += "; " + form.doc;
        lines.push_back(std::move(line));
    }
    explain_names(language, word, lines);
    explain_variables(language, word, lines);
    explain_calls(language.calls, word, lines);
}

}  // namespace kadr::nc
