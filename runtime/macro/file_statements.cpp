// Statements that write, read and delete files of the control.
#include "macro/file_statements.h"

#include <algorithm>
#include <cmath>

#include "base/diagnostics/control.h"
#include "macro/program_base.h"
#include "nc/calls.h"

namespace kadr::macro {

using nc::ControlStatement;
using nc::Statement;

namespace {

/// A file beside the program, line by line.
ControlFiles::Lines lines_of(nc::TextSource& text) {
    ControlFiles::Lines lines;
    std::string rest;
    for (std::string_view piece = text.next(); !piece.empty(); piece = text.next()) rest += piece;
    std::size_t at = 0;
    while (at < rest.size()) {
        const std::size_t end = std::min(rest.find('\n', at), rest.size());
        std::string line = rest.substr(at, end - at);
        if (line.ends_with('\r')) line.pop_back();
        lines.push_back(std::move(line));
        at = end + 1;
    }
    return lines;
}

}  // namespace

/// The path is not looked at, and the control's own marks of names do not count: `_N_PROT_MPF` is
/// `PROT`.
std::string FileStatements::name_of(std::string_view path) const {
    return nc::program_of_path(run_.language.calls, path, run_.tables.notation.ignores_case);
}

/// Files wait for the blocks in front: what stands behind an alarm is never written.
Outcome FileStatements::execute(CompiledLine& line, const ControlStatement& statement) {
    if (run_.counts.given > 0) return Outcome::Wait;
    ControlValue path;
    Outcome done = run_.evaluate(line, statement.value, path);
    if (!goes_on(done)) return done;
    if (!path.is_text()) {
        return run_.fail(line, diag::TypesDiffer, statement.value.span,
                         {"the name of a file", std::string(kind_name(path))});
    }
    const std::string name = name_of(run_.evaluator.text(path));
    const bool is_beside = !name.empty() && !files_.knows(name) && run_.options.files != nullptr;
    if (is_beside) {
        if (const auto file = run_.options.files->open(run_.dialect, name, {}))
            files_.add(name, lines_of(*file->text));
    }
    ControlFiles::Error error = ControlFiles::Error::None;
    if (statement.kind == Statement::DeleteFile) {
        error = files_.remove(name);
    } else if (statement.kind == Statement::ReadFile) {
        done = read_file(line, statement, name, error);
        if (!goes_on(done)) return done;
    } else {
        ControlValue text;
        done = run_.evaluate(line, statement.second, text);
        if (!goes_on(done)) return done;
        if (!text.is_text()) {
            return run_.fail(line, diag::TypesDiffer, statement.second.span,
                             {"a line of a file", std::string(kind_name(text))});
        }
        error = files_.write(name, run_.evaluator.text(text));
        if (run_.options.printer != nullptr && error == ControlFiles::Error::None)
            run_.options.printer->line(run_.evaluator.text(text));
    }
    const auto number = static_cast<double>(error);
    return run_.store(line, statement.variable, ControlValue::of(number, nc::ValueType::Int));
}

/// Elements of the array for which there is no line stay as they are, and of a line there is as
/// much as the texts take (unsure).
Outcome FileStatements::read_file(CompiledLine& line, const ControlStatement& statement,
                                  const std::string& name, ControlFiles::Error& error) {
    ControlValue first;
    ControlValue count;
    Outcome done = run_.evaluate(line, statement.second, first);
    if (!goes_on(done)) return done;
    done = run_.evaluate(line, statement.count, count);
    if (!goes_on(done)) return done;
    const nc::ControlInstruction& load = statement.table.load;
    const nc::ControlSymbol* result = load.kind == nc::ControlInstruction::Kind::Element
                                          ? &run_.variables.level().symbols.at(load.index)
                                          : nullptr;
    const bool is_fine = result != nullptr && load.count == 0 && result->dimensions < 2 &&
                         result->type == nc::ValueType::Text;
    if (!is_fine)
        return run_.fail(line, diag::ArgumentDiffers, statement.table.span,
                         {"what takes the lines", "a text, or an array of texts"});
    ControlFiles::Lines found;
    error = files_.read(name, std::round(first.number), std::round(count.number), found);
    if (found.empty()) return Outcome::Nothing;
    if (found.size() > result->count()) {
        error = ControlFiles::Error::ResultTooSmall;
        return Outcome::Nothing;
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
        const ControlValue text =
            run_.evaluator.keep_text(std::string(code_points(found[i], 0, result->text_size)));
        const auto fault =
            run_.variables.store_element(*result, result->slot + static_cast<std::uint32_t>(i),
                                         text, run_.evaluator.content(text));
        if (fault.row != nullptr)
            return run_.fail(line, *fault.row, statement.table.span, fault.arguments);
    }
    return Outcome::Nothing;
}

}  // namespace kadr::macro
