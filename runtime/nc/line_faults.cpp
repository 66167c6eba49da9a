#include "nc/line_faults.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "base/text.h"
#include "nc/control_words.h"
#include "nc/letters.h"

namespace kadr::nc {

namespace {

/// `ENDWIHLE`: the word of a statement that is written nearly so.
std::optional<std::string_view> nearest_statement(const DialectTables& tables,
                                                  std::string_view word) {
    constexpr std::size_t kShortest = 4;  // below it nearly everything is near
    if (word.size() < kShortest) return std::nullopt;
    std::vector<std::string_view> names;
    for (const StatementForm& form : tables.language.statements) {
        const std::string& first = form.tokens[0].text;
        if (form.tokens[0].kind == StatementToken::Kind::Word && first.size() >= kShortest)
            names.push_back(first);
    }
    return nearest_name(word, names.data(), names.size());
}

/// A word of small letters as `x5` is one in capital letters; three in a row are a remark.
std::string fix_of_small_letters(const DialectTables& tables, std::string_view line,
                                 std::size_t at) {
    constexpr std::size_t kRemark = 3;
    const auto begin = line.begin() + static_cast<std::ptrdiff_t>(at);
    const auto end = std::find_if_not(begin, line.end(), is_letter);
    if (tables.comment.open != "(" || static_cast<std::size_t>(end - begin) < kRemark)
        return "write capital letters";
    return "a comment stands in brackets: `(…)`";
}

/// What a number is written as whose exponent begins at `at`, as `1e3`: with the exponent of the
/// control's language, or without one. Empty: there is none.
std::string fix_of_exponent(const DialectTables& tables, std::string_view line, std::size_t at) {
    if (at >= line.size() || (line[at] != 'e' && line[at] != 'E')) return "";
    std::size_t begin = at;
    while (begin > 0 && (is_digit(line[begin - 1]) || line[begin - 1] == '.')) --begin;
    if (begin == at) return "";
    if (begin > 0 && line[begin - 1] == '-') --begin;
    double value = 0;
    const char* const end = line.data() + line.size();
    const auto read = std::from_chars(line.data() + begin, end, value);
    if (read.ec != std::errc() || read.ptr <= line.data() + at) return "";
    if (tables.language.is_present && ControlWords(tables, line).has_exponents()) {
        const auto behind = static_cast<std::size_t>(read.ptr - line.data());
        return "an exponent begins with `EX`: `" + std::string(line.substr(begin, at - begin)) +
               "EX" + std::string(line.substr(at + 1, behind - at - 1)) + '`';
    }
    std::array<char, 400> text;
    const auto written =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
    if (written.ec != std::errc() || written.ptr - text.data() > 12) return "";
    std::string number(text.data(), written.ptr);
    if (number.find('.') == number.npos) number += '.';
    return "numbers have no exponent: `" + number + '`';
}

}  // namespace

bool is_about_words(const DiagnosticRow& row) {
    static constexpr std::array kRows = {
        &diag::IsoUnknownWord,       &diag::IsoUnknownCode,  &diag::IsoNoValue,
        &diag::IsoWordsMissing,      &diag::IsoWordUnused,   &diag::IsoSyntax,
        &diag::ExpressionSyntax,     &diag::StatementSyntax, &diag::AssignmentMissing,
        &diag::StatementWordMissing, &diag::LoopNumber,      &diag::CallNotAlone,
        &diag::NameUnknown};
    return std::ranges::find(kRows, &row) != kRows.end();
}

DiagnosticBuilder LineFaults::report(std::string_view line, const LineFault& fault,
                                     const ForeignLocation& came_up) {
    note_fault();
    DiagnosticBuilder builder = message(*fault.row, line, fault.span);
    std::string detail;
    for (const std::string& argument : fault.arguments) {
        builder.arg(argument);
        detail += argument + ' ';
    }
    if (const auto alarm = dialect_.alarm(*fault.row, detail))
        builder.alarm(alarm->number, alarm->text);
    const std::string_view instead = came_up.is_executed || is_about_words(*fault.row)
                                         ? instead_of_foreign(tables_, line, fault.span, came_up)
                                         : std::string_view();
    const std::size_t at = fault.span.begin;
    const bool is_small = !tables_.notation.ignores_case && at < line.size() && is_lower(line[at]);
    const std::string number =
        is_about_words(*fault.row) ? fix_of_exponent(tables_, line, at) : std::string();
    if (!fault.fix.empty()) builder.fix(fault.fix);
    else if (!number.empty()) builder.fix(number);
    else if (!instead.empty()) builder.fix(std::string(instead));
    else if (fault.row == &diag::MachineAxisWanted)
        builder.fix("name the axis of the machine: `" + fault.arguments[1].substr(0, 1) + "1=0`");
    else if (is_small && fault.row == &diag::IsoSyntax)
        builder.fix(fix_of_small_letters(tables_, line, at));
    else if (fault.row == &diag::IsoUnknownWord)
        if (const auto meant = nearest_statement(tables_, fault.arguments[0]))
            builder.fix("is `" + std::string(*meant) + "` meant?");
    write_notes(builder);
    return builder;
}

}  // namespace kadr::nc
