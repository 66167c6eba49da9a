#include "nc/statement_holes.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace kadr::nc {

namespace {

using Hole = StatementToken::Hole;

/// In the order of Hole.
constexpr std::string_view kNames[] = {
    "variable",  "value", "condition", "target", "loop", "first",        "last",  "number",
    "text",      "count", "from",      "to",     "type", "declarations", "cases", "jump",
    "statement", "call",  "procedure", "print",  "rest", "table",        "row"};

/// Of a statement: the holes that it needs, `a|b` one of both, and those that it may have besides.
struct Row {
    Statement statement;
    std::string_view needed;
    std::string_view others;
};

constexpr Row kRows[] = {
    {Statement::Assign, "variable value", "last"},
    {Statement::Jump, "target", "value last"},
    {Statement::JumpForward, "target", ""},
    {Statement::JumpBackward, "target", ""},
    {Statement::JumpIfThere, "target", ""},
    {Statement::JumpToStart, "", ""},
    {Statement::IfDo, "condition jump|statement|target", ""},
    {Statement::If, "condition", "loop"},
    {Statement::Else, "", "loop"},
    {Statement::EndIf, "", "loop"},
    {Statement::While, "condition", "loop"},
    {Statement::Loop, "", "loop count"},
    {Statement::For, "variable first last", "loop"},
    {Statement::EndLoop, "", "loop"},
    {Statement::Repeat, "", "loop"},
    {Statement::Until, "condition", "loop"},
    {Statement::Break, "", "loop"},
    {Statement::Continue, "", "loop"},
    {Statement::Case, "value cases", "jump"},
    {Statement::RepeatSection, "from", "to count"},
    {Statement::RepeatBlock, "from", "count"},
    {Statement::Label, "from", ""},
    {Statement::CallSection, "from", "count"},
    {Statement::EndSection, "", ""},
    {Statement::Declare, "type declarations", ""},
    {Statement::DefineMacro, "rest", ""},
    {Statement::Alarm, "number", "text"},
    {Statement::RunText, "text", ""},
    {Statement::Synchronous, "rest", ""},
    {Statement::Print, "print", ""},
    {Statement::PrintBytes, "print", ""},
    {Statement::NameVariables, "rest", ""},
    {Statement::PrintOpen, "", ""},
    {Statement::PrintClose, "", ""},
    {Statement::ContourBegin, "table value variable", "count"},
    {Statement::ContourCode, "table", "count"},
    {Statement::ContourEnd, "variable", ""},
    {Statement::ContourRow, "row", ""},
    {Statement::WriteFile, "variable value text", ""},
    {Statement::ReadFile, "variable value last count table", ""},
    {Statement::DeleteFile, "variable value", ""},
    {Statement::Call, "call", "count"},
    {Statement::CallModal, "call", ""},
    {Statement::CallByText, "text", "from to"},
    {Statement::EndModal, "", ""},
    {Statement::Return, "", "target value count"},
    {Statement::Procedure, "procedure", ""},
    {Statement::External, "procedure", ""},
};

std::vector<std::string_view> pieces(std::string_view text, char separator) {
    std::vector<std::string_view> out;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(separator), text.size());
        if (end > 0) out.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return out;
}

/// `{jump} or {statement}`
std::string shown(std::string_view alternatives) {
    std::string out;
    for (const std::string_view name : pieces(alternatives, '|'))
        out += (out.empty() ? "{" : " or {") + std::string(name) + '}';
    return out;
}

bool has_hole(const StatementForm& form, std::string_view name) {
    return std::ranges::any_of(form.tokens, [&](const StatementToken& token) {
        return token.kind == StatementToken::Kind::Hole && name_of(token.hole) == name;
    });
}

bool is_among(std::string_view name, std::string_view list) {
    return std::ranges::any_of(pieces(list, ' '), [&](std::string_view alternatives) {
        const std::vector<std::string_view> names = pieces(alternatives, '|');
        return std::ranges::find(names, name) != names.end();
    });
}

}  // namespace

std::string_view name_of(Hole hole) { return kNames[static_cast<std::size_t>(hole)]; }

std::optional<Hole> hole_named(std::string_view name) {
    const auto found = std::ranges::find(kNames, name);
    if (found == std::end(kNames)) return std::nullopt;
    return static_cast<Hole>(found - std::begin(kNames));
}

std::string shown_holes(Statement statement) {
    const auto row = std::ranges::find(kRows, statement, &Row::statement);
    std::string out;
    if (row == std::end(kRows)) return out;
    for (const std::string_view needed : pieces(row->needed, ' ')) {
        std::string_view joint = out.empty() ? "`{" : " `{";
        for (const std::string_view name : pieces(needed, '|')) {
            out += std::string(joint) + std::string(name) + "}`";
            joint = " or `{";
        }
    }
    for (const std::string_view name : pieces(row->others, ' '))
        out += (out.empty() ? "`{" : " `{") + std::string(name) + "?}`";
    return out;
}

std::string fault_of_holes(const StatementForm& form) {
    const auto row = std::ranges::find(kRows, form.statement, &Row::statement);
    if (row == std::end(kRows)) return {};
    const std::string statement(info(form.statement).name);
    for (const std::string_view needed : pieces(row->needed, ' ')) {
        const std::vector<std::string_view> names = pieces(needed, '|');
        const bool is_there =
            std::ranges::any_of(names, [&](std::string_view name) { return has_hole(form, name); });
        if (!is_there) return "`" + statement + "` needs " + shown(needed);
    }
    for (const StatementToken& token : form.tokens) {
        if (token.kind != StatementToken::Kind::Hole) continue;
        const std::string_view name = name_of(token.hole);
        if (is_among(name, row->needed) || is_among(name, row->others)) continue;
        return '`' + statement + "` executes no {" + std::string(name) + '}';
    }
    return {};
}

}  // namespace kadr::nc
