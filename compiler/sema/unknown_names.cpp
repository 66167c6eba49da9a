#include "sema/unknown_names.h"

#include <algorithm>

#include "base/diagnostics/dialect.h"
#include "base/diagnostics/sema.h"
#include "base/diagnostics/syntax.h"
#include "base/text.h"
#include "sema/checking.h"
#include "sema/scope.h"
#include "syntax/habits.h"
#include "syntax/parse.h"

namespace kadr::sema {

namespace {

bool fix_as_word(Check& check, std::string_view name, const SourceRange& range,
                 DiagnosticBuilder& builder);

}  // namespace

namespace {

/// `mm` in `X=5 mm` and `min` in `100mm / min`, which are no names: the unit stands apart.
Done require_no_unit(Check& check, std::string_view name, const SourceRange& range) {
    if (range.file == check.told.unit.file && range.begin >= check.told.unit.begin &&
        range.end <= check.told.unit.end)
        return kFailed;
    const std::string_view source = check.sources.text(range.file);
    const std::string_view before = source.substr(0, range.begin);
    const auto behind_blanks = [&](std::size_t end) {
        while (end > 0 && before[end - 1] == ' ') --end;
        return end;
    };
    std::size_t number = behind_blanks(before.size());
    std::string unit(name);
    if (number > 0 && before[number - 1] == '/') {
        const std::size_t end = behind_blanks(number - 1);
        number = before.substr(0, end).find_last_not_of("abcdefghijklmnopqrstuvwxyz") + 1;
        unit = std::string(before.substr(number, end - number)) + '/' + unit;
    }
    const bool is_behind_number =
        number > 0 && std::string_view("0123456789.").find(before[number - 1]) != std::string::npos;
    if (!is_behind_number || !find_unit(unit)) return kDone;
    // `100 mm/min`: all of it.
    std::size_t end = range.end;
    if (end < source.size() && source[end] == '/') {
        const std::size_t past = std::min(
            source.find_first_not_of("abcdefghijklmnopqrstuvwxyz", end + 1), source.size());
        const std::string whole = unit + std::string(source.substr(end, past - end));
        if (find_unit(whole)) {
            unit = whole;
            end = past;
        }
    }
    check.told.unit = {range.file, range.begin, static_cast<std::uint32_t>(end)};
    check.report(diag::UnitApart, check.told.unit)
        .arg(unit)
        .fix({range.file, static_cast<std::uint32_t>(number), check.told.unit.end}, unit,
             "write it right behind the number");
    return kFailed;
}

}  // namespace

/// Whether this is a word with a number: `X10`.
bool is_numbered_word(const Check& check, std::string_view word) {
    const std::size_t letters = word.find_first_of("0123456789");
    return letters != std::string_view::npos && letters > 0 &&
           word.find_first_not_of("0123456789", letters) == std::string_view::npos &&
           nc::word_kind(check.dialect(), word.substr(0, letters)) == nc::WordKind::Address;
}

/// A keyword of English in a file of another keyword language: `program`, `warn(…)`.
Done require_no_foreign_keyword(Check& check, std::string_view name, const SourceRange& range) {
    const auto found = check.ast().keyword_words.find(name);
    if (found == check.ast().keyword_words.end()) return kDone;
    check.report(diag::ForeignKeyword, range)
        .arg(name)
        .arg(found->second)
        .arg(check.ast().language)
        .fix(range, found->second, "use the word of the keyword language");
    return kFailed;
}

namespace {

/// The word of another control where the target of a block may stand: `G1 X10 Q5`.
Done require_no_foreign_word(Check& check, std::string_view name, const SourceRange& range) {
    const std::size_t digit = name.find_first_of("0123456789");
    const bool is_like_word =
        digit != 0 && digit != std::string_view::npos && upper_ascii(name) == name;
    const syntax::Habit* habit = syntax::habit_of(name);
    const bool is_statement = habit != nullptr && habit->is_statement;  // `N20 END1`
    if (!is_like_word || is_statement || !(range == check.here.target)) return kDone;
    check.report(diag::BlockWordUnknown, range)
        .arg(name)
        .arg(check.dialect().name())
        .fix(syntax::kForeignWord);
    return kFailed;
}

/// Whether a statement begins with the name at `range`.
bool is_statement_at(const Check& check, const SourceRange& range) {
    const std::string_view before = check.sources.text(range.file).substr(0, range.begin);
    const std::size_t last = before.find_last_not_of(" \t\r\n");
    return last == std::string_view::npos ||
           std::string_view(";{}):").find(before[last]) != std::string_view::npos;
}

/// R1: a variable of a control, and no word of a block.
bool is_control_parameter(std::string_view word) {
    return word.size() > 1 && word[0] == 'R' &&
           word.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

/// `GO` and `XO` where words stand: a letter for a digit. Not `NO = 5;`, nor the loop `DO1;`.
Done require_no_letter_for_digit(Check& check, std::string_view name, const SourceRange& range) {
    const std::string_view behind = check.sources.text(range.file).substr(range.end);
    const std::size_t at = behind.find_first_not_of(" \t");
    const char next = at == std::string_view::npos ? ';' : behind[at];
    const bool is_lone =
        is_statement_at(check, range) && (next == ';' || (next >= 'A' && next <= 'Z'));
    if ((!(range == check.here.target) && !is_lone) || name.starts_with("DO")) return kDone;
    const std::string word = syntax::word_with_digits(check.dialect(), name);
    if (word.empty()) return kDone;
    check.report(diag::LetterForDigit, range).arg(name).arg(word).fix(range, word, "write digits");
    return kFailed;
}

/// `G1 X=dY5`: a variable with the next word right behind it.
bool fix_next_word(Check& check, std::string_view name, const SourceRange& range,
                   DiagnosticBuilder& builder) {
    constexpr std::size_t kMostLetters = 8;  // of an address
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    const std::size_t first = digits > kMostLetters ? digits - kMostLetters : 1;
    for (std::size_t i = first; i < digits; ++i) {
        if (!is_numbered_word(check, name.substr(i))) continue;
        const Found value = find(check, name.substr(0, i));
        if (value.symbol < 0) continue;
        const std::uint32_t at = range.begin + static_cast<std::uint32_t>(i);
        builder.fix({range.file, at, at}, " ", "a blank ends the name in front of the next word");
        return true;
    }
    return false;
}

/// `for (k = 0; k < 5; k++)`: a loop declares its variable.
bool fix_loop_variable(Check& check, const SourceRange& range, DiagnosticBuilder& builder) {
    const std::string_view source = check.sources.text(range.file);
    std::string_view before = source.substr(0, range.begin);
    before = before.substr(0, before.find_last_not_of(" \t") + 1);
    if (!before.ends_with('(')) return false;
    before.remove_suffix(1);
    before = before.substr(0, before.find_last_not_of(" \t") + 1);
    const std::size_t behind = source.find_first_not_of(" \t", range.end);
    const bool is_assigned = behind != std::string_view::npos && source[behind] == '=';
    if (!before.ends_with("for") || !is_assigned) return false;
    builder.fix({range.file, range.begin, range.begin}, "int ", "a loop declares its variable");
    return true;
}

}  // namespace

/// A name that is a statement by itself, as only words of a language are: `BREAK;`, `E5;`, `L100;`.
bool fix_statement(Check& check, std::string_view name, const SourceRange& range,
                   DiagnosticBuilder& builder) {
    const std::string_view behind = check.sources.text(range.file).substr(range.end);
    const std::size_t next = behind.find_first_not_of(" \t");
    const bool is_alone = next != std::string_view::npos && behind[next] == ';';
    const std::string lower = syntax::lower_ascii(name);
    if (!is_statement_at(check, range)) return false;
    if (lower != name && syntax::is_keyword(lower)) {  // `RETURN -a;`: a difference to the parser
        builder.fix(range, lower, "keywords are written in lower case");
        return true;
    }
    const std::size_t letters = name.find_first_of("0123456789");
    const bool is_word = letters != std::string_view::npos && letters > 0 &&
                         name.find_first_not_of("0123456789", letters) == std::string_view::npos &&
                         upper_ascii(name) == name;
    if (!is_alone || !is_word) return false;
    const std::string_view address = name.substr(0, letters);
    if (address == "O")
        builder.fix("a program that is called so has this number: `program " + std::string(name) +
                    "() { … }`");
    else if (address == "DO") builder.fix("a loop is `while (…) { … }`, its body stands in braces");
    else if (address == "L" || address == "P") builder.fix(syntax::kCallByName);
    else builder.fix(syntax::kForeignWord);
    return true;
}

/// Letters of the address of a word that has its value without `=`, where words stand: 1 of
/// `G0 Xd/2;` and of `Xd;`. 0: it is none.
std::size_t glued_letters(Check& check, std::string_view name, const SourceRange& range) {
    const std::size_t letters = syntax::glued_address(check.dialect(), name);
    if (letters == 0) return 0;
    const bool is_small = name[letters] >= 'a' && name[letters] <= 'z';
    const bool is_target =
        range.file == check.here.target.file && range.begin == check.here.target.begin;
    if (is_target && is_small) return letters;
    const std::string_view before = check.sources.text(range.file).substr(0, range.begin);
    const std::size_t last = before.find_last_not_of(" \t\r\n");
    const bool begins = last == std::string_view::npos ||
                        std::string_view(";{}").find(before[last]) != std::string_view::npos;
    const Found value = find(check, name.substr(letters));
    const bool is_known = value.symbol >= 0 || value.name != nullptr;
    return is_known && (begins || is_target) ? letters : 0;
}

/// `=` between an address and its value.
void fix_glued(std::size_t letters, const SourceRange& range, DiagnosticBuilder& builder) {
    const auto value = range.begin + static_cast<std::uint32_t>(letters);
    builder.fix({range.file, value, value}, "=", syntax::kValueBehindSign);
}

namespace {

/// `SIN[30]` and `sin[30]`: a function of a control, its argument in square brackets.
Done require_no_control_index(Check& check, std::string_view name, const SourceRange& range) {
    const std::string_view source = check.sources.text(range.file);
    const std::string function = syntax::lower_ascii(name);
    const std::vector<std::string_view> functions = known_names(check, true);
    if (range.end >= source.size() || source[range.end] != '[' ||
        !std::binary_search(functions.begin(), functions.end(), function))
        return kDone;
    std::size_t close = range.end;
    for (int depth = 0; close < source.size() && source[close] != '\n'; ++close) {
        if (source[close] == '[') ++depth;
        if (source[close] == ']' && --depth == 0) break;
    }
    if (close >= source.size() || source[close] != ']') return kDone;
    std::string argument(source.substr(range.end + 1, close - range.end - 1));
    const bool is_number = argument.find_first_not_of("0123456789.-") == std::string::npos;
    const bool takes_angle = function == "sin" || function == "cos" || function == "tan";
    if (is_number && takes_angle) argument += "deg";
    check.report(diag::UnknownName, range)
        .arg(name)
        .fix({range.file, range.begin, static_cast<std::uint32_t>(close + 1)},
             function + '(' + argument + ')',
             "functions are in small letters, their arguments in round brackets");
    return kFailed;
}

/// A Latin `c` where a Cyrillic one is declared, and the other way round.
bool fix_lookalike(Check& check, std::string_view name, const SourceRange& range,
                   DiagnosticBuilder& builder) {
    const std::string skeleton = latin_skeleton(name);
    for (const std::string_view known : known_names(check, false)) {
        if (known == name || latin_skeleton(known) != skeleton) continue;
        const bool is_cyrillic = latin_skeleton(known) != known;
        builder.fix(range, std::string(known),
                    std::string("a name that looks alike is declared, in ") +
                        (is_cyrillic ? "Cyrillic" : "Latin") + " letters");
        return true;
    }
    return false;
}

}  // namespace

/// Another look for a name that was meant, among all names. False: there were enough. BehindWords
/// so many mistakes of this kind nobody reads what it would report, and each takes as long as there
/// are names.
bool take_proposal(Check& check) {
    constexpr std::uint32_t kMost = 100;
    return ++check.told.proposals <= kMost;
}

void report_unknown(Check& check, std::string_view name, const SourceRange& range) {
    if (!require_not_lost(check, name)) return;
    for (std::size_t i = check.body.defaults_from;
         check.here.function != nullptr && i < check.here.function->parameters.size(); ++i) {
        if (check.here.function->parameters[i].name != name) continue;
        check.scopes[static_cast<std::int32_t>(i)].is_read = true;
        check.report(diag::DefaultOrder, range)
            .arg(check.here.function->parameters[check.body.defaults_from].name)
            .arg(name)
            .note(check.here.function->parameters[i].range, "it is declared here");
        return;
    }
    if (!require_no_unit(check, name, range) || !require_no_foreign_keyword(check, name, range))
        return;
    if (!require_no_letter_for_digit(check, name, range) ||
        !require_no_foreign_word(check, name, range) ||
        !require_no_control_index(check, name, range))
        return;
    auto builder = check.report(diag::UnknownName, range);
    builder.arg(name);
    if (name == check.here.declared) {
        builder.note(range, "it is used in its own value, before it has one");
        return;
    }
    if (fix_as_word(check, name, range, builder)) return;
    if (const syntax::Habit* habit = syntax::habit_of(name)) {
        syntax::advise(builder, *habit, range);
        return;
    }
    if (!take_proposal(check) || fix_lookalike(check, name, range, builder)) return;
    const std::vector<std::string_view> functions = known_names(check, true);
    const std::string lower = syntax::lower_ascii(name);
    for (const std::string_view function : {name, std::string_view(lower)}) {
        const bool is_it = std::binary_search(functions.begin(), functions.end(), function);
        if (!is_it || (function != name && !is_statement_at(check, range))) continue;
        builder.fix(range, std::string(function) + "()", "it is a function: call it");
        return;
    }
    if (fix_statement(check, name, range, builder) || fix_next_word(check, name, range, builder) ||
        fix_loop_variable(check, range, builder))
        return;
    // Every letter is near to every other.
    if (count_code_points(name) == 1 || is_control_parameter(upper_ascii(name))) {
        builder.fix("declare it first, with its type");
        return;
    }
    const std::vector<std::string_view> names = known_names(check, false);
    if (const auto near = nearest_name(name, names.data(), names.size())) {
        builder.fix(range, std::string(*near), "did you mean " + quoted(*near) + "?");
    }
}

namespace {

/// `G1 x10 y-5 Zd`: words in lower case, and one that has its value without `=`.
bool fix_as_word(Check& check, std::string_view name, const SourceRange& range,
                 DiagnosticBuilder& builder) {
    const std::string word = upper_ascii(name);
    const bool is_target =
        range.file == check.here.target.file && range.begin == check.here.target.begin;
    const bool is_address = name.size() == 1 && name != word &&
                            nc::word_kind(check.dialect(), word) == nc::WordKind::Address;
    const bool is_number = is_numbered_word(check, word) && !is_control_parameter(word);
    if (is_number || (is_target && is_address)) {
        builder.fix(range, word, "words of blocks are written in upper case");
        return true;
    }
    const std::size_t letters = glued_letters(check, name, range);
    if (letters > 0) fix_glued(letters, range, builder);
    return letters > 0;
}

}  // namespace

}  // namespace kadr::sema
