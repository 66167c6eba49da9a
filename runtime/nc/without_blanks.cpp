#include "nc/without_blanks.h"

#include <algorithm>

#include "nc/control_words.h"
#include "nc/letters.h"

namespace kadr::nc {

namespace {

/// Every field in a compiled line that names columns.
class ColumnsOfLine {
  public:
    explicit ColumnsOfLine(const LineWithoutBlanks& written) : written_(written) {}

    void put_back(ControlLine& line) const {
        put_back(line.words.spans);
        for (LexedLine::Passed& passed : line.words.passed) put_back(passed.span);
        put_back(line.words.comment_form_span);
        for (ComputedValue& value : line.computed) put_back(value.value);
        for (ComputedAxis& axis : line.axes) put_back(axis.axis);
        for (ComputedCode& code : line.codes) {
            put_back(code.group);
            put_back(code.number);
        }
        put_back(line.statements);
        for (Call& call : line.calls) put_back(call);
        put_back(line.spans);
    }

  private:
    void put_back(Span& span) const { written_.put_back(span); }
    void put_back(Expression& expression) const { put_back(expression.span); }
    void put_back(Reference& reference) const {
        put_back(reference.indices);
        put_back(reference.span);
    }
    void put_back(JumpTarget& target) const {
        put_back(target.value);
        put_back(target.span);
    }
    void put_back(CallValue& value) const {
        put_back(value.value);
        put_back(value.span);
    }
    void put_back(PrintPiece& piece) const { put_back(piece.value); }
    void put_back(Declaration& declaration) const {
        put_back(declaration.span);
        for (Expression& size : declaration.sizes) put_back(size);
        put_back(declaration.values);
    }
    void put_back(ProcedureParameter& parameter) const {
        put_back(parameter.declaration);
        put_back(parameter.type_size);
    }
    void put_back(Call& call) const {
        put_back(call.span);
        for (CallValue* value :
             {&call.program, &call.repeats, &call.start, &call.target, &call.code})
            put_back(*value);
        for (CallArgument& argument : call.arguments) {
            put_back(static_cast<CallValue&>(argument));
            put_back(argument.variable);
        }
    }
    void put_back(ControlStatement& statement) const {
        put_back(statement.span);
        put_back(statement.scope);
        put_back(statement.variable);
        put_back(statement.table);
        for (Expression* value :
             {&statement.value, &statement.second, &statement.count, &statement.type_size})
            put_back(*value);
        for (JumpTarget* target : {&statement.target, &statement.from, &statement.to})
            put_back(*target);
        put_back(statement.declarations);
        put_back(statement.parameters);
        put_back(statement.list);
        put_back(statement.print);
        put_back(statement.inner);
    }
    template <typename T>
    void put_back(std::vector<T>& parts) const {
        for (T& part : parts) put_back(part);
    }

    const LineWithoutBlanks& written_;
};

}  // namespace

void LineWithoutBlanks::put_back(Span& span) const {
    const auto last = static_cast<std::uint32_t>(columns.size() - 1);
    const std::uint32_t begin = std::min(span.begin, last);
    const std::uint32_t end = std::min(span.end, last);
    const bool is_empty = end <= begin;
    span = {columns[begin], is_empty ? columns[begin] : columns[end - 1] + 1};
}

void LineWithoutBlanks::put_back(ControlLine& line) const { ColumnsOfLine(*this).put_back(line); }

bool has_split_words(const DialectTables& tables, std::string_view line) {
    if (!tables.notation.blanks_inside_words) return false;
    const auto is_part = [](char c) { return is_digit(c) || c == '.'; };
    const ControlWords words(tables, line);
    for (std::size_t at = 0; at + 2 < line.size(); ++at) {
        if (words.is_comment(at)) {
            at = words.skip_comments(at);
            if (at >= line.size() || words.is_comment(at)) return false;
        }
        const std::size_t next = words.skip_blanks(at + 1);
        if (next == at + 1 || next >= line.size()) continue;
        const char before = line[at];
        const char behind = line[next];
        if ((is_letter(before) && is_letter(behind)) || (is_part(before) && is_part(behind)))
            return true;
    }
    return false;
}

LineWithoutBlanks without_blanks(const DialectTables& tables, std::string_view line) {
    const ControlWords words(tables, line);
    LineWithoutBlanks out;
    std::size_t comment_end = 0;
    for (std::size_t at = 0; at < line.size(); ++at) {
        if (at >= comment_end && words.is_comment(at)) {
            comment_end = words.skip_comments(at);
            // One that nothing ends has its fault elsewhere.
            if (comment_end == at) comment_end = line.size();
        }
        if (at >= comment_end && is_blank(line[at])) continue;
        out.text += line[at];
        out.columns.push_back(static_cast<std::uint32_t>(at));
    }
    out.columns.push_back(static_cast<std::uint32_t>(line.size()));
    return out;
}

}  // namespace kadr::nc
