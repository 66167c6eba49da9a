// line_compiler.cpp — lines of the control's own language, compiled once.
#include "macro/line_compiler.h"

#include <algorithm>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "macro/program_run.h"
#include "nc/control_words.h"

namespace kadr::macro {

using nc::Block;
using nc::LineFault;
using nc::Statement;

/// What kind of line it is; one that cannot be read stays New.
void LineCompiler::compile(CompiledLine& line, Block& out) {
    line.kind = CompiledLine::Kind::Nothing;
    line.context = run_.context();
    if (run_.lines.check_kind(line.text) != nc::LineReader::LineKind::Words) {
        if (run_.lines.bounds().has_ended()) line.kind = CompiledLine::Kind::End;
        return;
    }
    // Of anybody else's line only what it is counts: `#100=#5061` is an assignment.
    line.kind = CompiledLine::Kind::Known;
    if (run_.source().is_phrase(line.program_line.line.line) && run_.lines.knows(line.text, out))
        return;
    compile_language(line);
}

void LineCompiler::compile_language(CompiledLine& line) {
    line.kind = CompiledLine::Kind::New;
    const nc::SymbolTable& symbols = run_.variables.level().symbols;
    nc::LineContext plain = line.context;
    plain.is_argument = false;
    auto fault = compile_line(run_.tables, symbols, line.text, line.line, plain);
    // Under a modal call of blocks those that are no statements are its arguments.
    const bool is_argument =
        line.context.is_argument &&
        (fault ? line.line.statements.empty() && line.line.calls.empty()
               : line.line.statements.empty() && !line.line.words.words.empty());
    if (is_argument) fault = compile_line(run_.tables, symbols, line.text, line.line, line.context);
    if (!fault) line.kind = CompiledLine::Kind::Compiled;
    if (!fault) return;
    note_lost_names(line);
    // A name that a line with a mistake should have declared is no second mistake.
    if (is_lost(line, *fault)) run_.lines.faults().note_fault();
    else run_.lines.report_fault(line.text, *fault);
}

/// The names of a line that declares variables and could not be read.
void LineCompiler::note_lost_names(const CompiledLine& line) {
    const nc::ControlWords words(run_.tables, line.text);
    bool is_declaration = false;
    for (std::size_t at = 0; !words.is_end(at);) {
        const nc::LetterRun word = words.word_at(at);
        const auto declares = [&](const nc::StatementForm& form) {
            return form.statement == Statement::Declare && words.matches(word, form.tokens[0].text);
        };
        if (is_declaration && !word.text.empty()) lost_names_.insert(words.normal(word.text));
        is_declaration |= std::ranges::any_of(run_.language.statements, declares);
        at += std::max<std::size_t>(1, word.text.size());
    }
}

bool LineCompiler::is_lost(const CompiledLine& line, const LineFault& fault) const {
    const bool is_of_name = fault.row == &diag::NameUnknown || fault.row == &diag::IsoUnknownWord;
    if (!is_of_name || lost_names_.empty()) return false;
    const nc::ControlWords words(run_.tables, line.text);
    return lost_names_.contains(words.normal(words.word_at(fault.span.begin).text));
}

}  // namespace kadr::macro
