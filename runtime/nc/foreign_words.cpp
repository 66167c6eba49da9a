#include "nc/foreign_words.h"

#include <algorithm>
#include <string>

#include "base/text.h"
#include "nc/letters.h"

namespace kadr::nc {

namespace {

constexpr std::string_view kSigns = "#([;=,:<>!";

std::size_t end_of_word(std::string_view line, std::size_t begin) {
    std::size_t end = begin;
    while (end < line.size() && is_letter(line[end])) ++end;
    while (end < line.size() && (is_digit(line[end]) || line[end] == '.')) ++end;
    return end;
}

/// `G01` as the list has it: `G1`.
std::string spelled(std::string_view word) {
    std::string out = upper_ascii(word);
    const std::size_t digits = out.find_first_of("0123456789");
    if (digits == 1) {
        std::size_t zeros = 0;
        while (digits + zeros + 1 < out.size() && out[digits + zeros] == '0' &&
               is_digit(out[digits + zeros + 1]))
            ++zeros;
        out.erase(digits, zeros);
    }
    return out;
}

/// By the whole word, or by a front that the list ends with `*`: `CYCLE*`. Behind one letter only a
/// number may stand: `L*` is `L100`, and no `LT` or `LENGTH`.
///
/// where  `@cycle`: what it is where a cycle acts, `@arc` behind the code of an arc, `@head` as the
///        first word of a line
const std::string* entry(const DialectTables& tables, std::string_view word,
                         std::string_view where = {}) {
    const auto find = [&](std::string key) -> const std::string* {
        const auto found = tables.foreign.find(key.append(where));
        return found == tables.foreign.end() ? nullptr : &found->second;
    };
    if (const std::string* const found = find(std::string(word))) return found;
    for (std::size_t front = word.size(); front > 0; --front) {
        const bool is_number = std::ranges::all_of(word.substr(front), is_digit);
        const std::string* const found = find(std::string(word.substr(0, front)) + '*');
        if (found != nullptr && (front > 1 || (is_number && word.size() > 1))) return found;
    }
    return nullptr;
}

/// Whether the control's own language has the word: an operator, a function, or a part of a
/// statement. Where blanks do not count, letters may hold several: `LT`, `GOTO`.
bool is_of_language(const Language& language, std::string_view word) {
    const auto is_same = [word](std::string_view own) { return own == word; };
    return std::ranges::any_of(language.operators, is_same, &OperatorForm::text) ||
           std::ranges::any_of(language.functions, is_same, &FunctionForm::name) ||
           std::ranges::any_of(language.statements, [&](const StatementForm& form) {
               return std::ranges::any_of(form.tokens, is_same, &StatementToken::text);
           });
}

/// Whether the control has the word after all, as a code or in a form: where a dialect extends
/// another one, it may have what that one lacks.
bool is_own(const DialectTables& tables, const std::string& word) {
    const AddressId letter = tables.find_address(std::string_view(word).substr(0, 1));
    const bool is_code = word.size() > 1 && is_digit(word[1]);
    if (is_code && letter != kNoAddress && tables.find_code(letter, std::stod(word.substr(1))))
        return true;
    return std::ranges::any_of(tables.forms, [&](const Form& form) {
        return std::ranges::any_of(form.words, [&](const FormWord& own) {
            return own.kind == FormWord::Kind::Fixed && own.text == word;
        });
    });
}

/// Whether a word of the letter is a code; of a cycle's own code the interpreter tells.
bool begins_code(const DialectTables& tables, char letter) {
    const AddressId address = tables.find_address(upper_ascii(std::string_view(&letter, 1)));
    return address != kNoAddress && tables.addresses[address].kind == Address::Kind::Code;
}

/// Whether a condition has begun in front of the index.
bool is_in_condition(std::string_view line, std::size_t at) {
    for (std::size_t i = 0; i < at; ++i) {
        if (!is_letter(line[i])) continue;
        std::size_t end = i;
        while (end < at && is_letter(line[end])) ++end;
        const std::string word = upper_ascii(line.substr(i, end - i));
        if (word == "IF" || word == "WHILE" || word == "UNTIL") return true;
        i = end;
    }
    return false;
}

/// Whether a sign stands as people who come from other controls write it: a bracket behind a blank
/// opens a comment, a comma between digits is a decimal point, the second of two signs is no slip,
/// and where `=` assigns it is wrong in a condition alone.
bool is_out_of_habit(const DialectTables& tables, std::string_view line, std::size_t at) {
    const char before = at > 0 ? line[at - 1] : ' ';
    const char behind = at + 1 < line.size() ? line[at + 1] : ' ';
    switch (line[at]) {
        case '(': return is_blank(before) || tables.comment.open == "(";
        case ',': return is_digit(before) && is_digit(behind);
        case '=':
            return before != '=' && (!tables.notation.has_assignment || is_in_condition(line, at));
        default: return true;
    }
}

/// The list's word for a sign, the longest that stands there: `<=` before `<`. In a condition `=`
/// is what `==` is elsewhere.
const std::string* entry_of_sign(const DialectTables& tables, std::string_view line,
                                 std::size_t at) {
    if (!is_out_of_habit(tables, line, at)) return nullptr;
    const std::string* found = at + 1 < line.size() ? entry(tables, line.substr(at, 2)) : nullptr;
    if (found == nullptr && line[at] == '=' && is_in_condition(line, at))
        found = entry(tables, "==");
    return found != nullptr ? found : entry(tables, line.substr(at, 1));
}

/// Whether a letter with a number, `R5`, is used as a variable, in brackets or before an equals
/// sign.
bool is_variable(std::string_view line, std::size_t begin) {
    std::size_t end = end_of_word(line, begin);
    while (end < line.size() && is_blank(line[end])) ++end;
    const bool is_assigned = end < line.size() && line[end] == '=';
    const std::string_view front = line.substr(0, begin);
    const auto opened = std::ranges::count_if(front, [](char c) { return c == '[' || c == '('; });
    const auto closed = std::ranges::count_if(front, [](char c) { return c == ']' || c == ')'; });
    return is_assigned || opened > closed;
}

/// Whether nothing but blanks stands in front.
bool is_first(std::string_view line, std::size_t at) {
    return std::ranges::all_of(line.substr(0, at), is_blank);
}

/// Whether the code of an arc stands in front, G2 or G03.
bool is_behind_arc(std::string_view line, std::size_t at) {
    for (std::size_t i = 0; i < at;) {
        if (!is_letter(line[i])) {
            ++i;
            continue;
        }
        const std::size_t end = end_of_word(line, i);
        const std::string word = spelled(line.substr(i, end - i));
        if (word == "G2" || word == "G3") return true;
        i = end;
    }
    return false;
}

/// The word that holds the index, or the sign that stands there.
const std::string* entry_at(const DialectTables& tables, std::string_view line, std::size_t at) {
    if (at >= line.size()) return nullptr;
    if (kSigns.find(line[at]) != kSigns.npos) return entry_of_sign(tables, line, at);
    if (!is_letter(line[at])) return nullptr;
    const std::string word = spelled(line.substr(at, end_of_word(line, at) - at));
    const std::string* const found = entry(tables, word);
    // A letter of the list stands for itself with any number: `O100`.
    const bool is_numbered = word.size() > 1 && is_digit(word[1]) && !is_variable(line, at);
    if (found != nullptr) return found;
    if (!is_numbered) return nullptr;
    const std::string letter = word.substr(0, 1);
    const std::string* by_letter = entry(tables, letter);
    if (by_letter == nullptr && is_behind_arc(line, at)) by_letter = entry(tables, letter, "@arc");
    if (by_letter == nullptr && is_first(line, at)) by_letter = entry(tables, letter, "@head");
    return by_letter;
}

/// The word that ends in front of the index, without the blanks between them; empty: none does.
std::string_view word_before(std::string_view line, std::size_t at) {
    at = std::min(at, line.size());
    while (at > 0 && is_blank(line[at - 1])) --at;
    std::size_t begin = at;
    while (begin > 0 && (is_digit(line[begin - 1]) || line[begin - 1] == '.')) --begin;
    while (begin > 0 && is_letter(line[begin - 1])) --begin;
    return begin < at && is_letter(line[begin]) ? line.substr(begin, at - begin)
                                                : std::string_view();
}

/// Whether a value stands at the index, in brackets or behind an equals sign: what could be read
/// there is the control's own.
bool is_value(std::string_view line, std::size_t at) {
    return line.substr(0, at).find_first_of("[(=") != line.npos;
}

}  // namespace

std::string_view instead_of_foreign(const DialectTables& tables, std::string_view line,
                                    const Span& fault, const ForeignLocation& location) {
    if (tables.foreign.empty()) return {};
    if (location.in_cycle && fault.begin < line.size() && !begins_code(tables, line[fault.begin])) {
        const std::size_t end = end_of_word(line, fault.begin);
        const std::string word = spelled(line.substr(fault.begin, end - fault.begin));
        if (const std::string* found = entry(tables, word, "@cycle")) return *found;
    }
    // `POPEN` where programs have names: it was called, and there is none.
    const bool is_word = fault.begin < line.size() && is_letter(line[fault.begin]);
    if (location.is_executed && (!is_word || is_value(line, fault.begin))) return {};
    const std::size_t behind = end_of_word(line, fault.begin);
    if (location.is_executed &&
        is_own(tables, spelled(line.substr(fault.begin, behind - fault.begin))))
        return {};
    const bool is_in_remark = line.substr(0, fault.begin).find("//") != line.npos;
    const std::string* const at_fault =
        is_in_remark ? nullptr : entry_at(tables, line, fault.begin);
    if (at_fault != nullptr) return *at_fault;
    if (location.is_executed) return {};
    for (std::size_t at = 0; at < line.size();) {
        if (line[at] == ';' || line[at] == '"' || line[at] == '(') break;
        // A comment of other languages; what stands in it is no word.
        if (line.substr(at, 2) == "//") {
            const std::string* const remark = entry(tables, "//");
            return remark != nullptr ? std::string_view(*remark) : std::string_view();
        }
        if (!is_letter(line[at])) {
            ++at;
            continue;
        }
        const std::size_t end = end_of_word(line, at);
        const std::string word = spelled(line.substr(at, end - at));
        // `L2` of `M98 P1 L2` is the control's own, whatever `L*` is elsewhere.
        const bool is_numbered = word.size() > 1 && is_digit(word[1]);
        const bool is_named = tables.foreign.find(word) != tables.foreign.end();
        const bool is_candidate = word.size() > 1 && (!is_numbered || is_named);
        const std::string* found = is_candidate ? entry(tables, word) : nullptr;
        if (found != nullptr && !is_own(tables, word) && !is_of_language(tables.language, word))
            return *found;
        at = end;
    }
    // `X=5`, where no value stands behind a sign: it is the mistake, and not the word.
    const bool is_sign =
        !tables.notation.has_assignment && fault.end < line.size() && !is_letter(line[fault.end]);
    if (const std::string* found = is_sign ? entry_at(tables, line, fault.end) : nullptr)
        return *found;
    // A word of the control's own that elsewhere has other words behind it: `G4 P100`, `M98 P100`.
    const std::string_view before = word_before(line, fault.begin);
    if (before.empty()) return {};
    const auto begin = static_cast<std::size_t>(before.data() - line.data());
    if (is_variable(line, begin)) return {};
    const std::string* const found = entry_at(tables, line, begin);
    return found != nullptr ? std::string_view(*found) : std::string_view();
}

}  // namespace kadr::nc
