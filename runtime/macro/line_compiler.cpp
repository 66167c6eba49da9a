// line_compiler.cpp — lines of the control's own language, compiled once.
#include "macro/line_compiler.h"

#include <algorithm>
#include <utility>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "macro/program_run.h"
#include "nc/control_words.h"

namespace kadr::macro {

using nc::Block;
using nc::LineFault;
using nc::Statement;

std::optional<LineFault> compile_block(const nc::DialectTables& tables,
                                       const nc::SymbolTable& symbols, std::string_view text,
                                       const nc::LineContext& context, nc::ControlLine& out) {
    nc::LineContext plain = context;
    plain.is_argument = false;
    auto fault = compile_line(tables, symbols, text, out, plain);
    const bool is_argument = context.is_argument && out.statements.empty() &&
                             (fault ? out.calls.empty() : !out.words.words.empty());
    return is_argument ? compile_line(tables, symbols, text, out, context) : fault;
}

std::vector<std::string> words_of_declaration(const nc::DialectTables& tables,
                                              std::string_view text) {
    const nc::ControlWords words(tables, text);
    std::vector<std::string> found;
    bool is_declaration = false;
    for (std::size_t at = 0; !words.is_end(at);) {
        const nc::LetterRun word = words.word_at(at);
        const auto declares = [&](const nc::StatementForm& form) {
            return form.statement == Statement::Declare && words.matches(word, form.tokens[0].text);
        };
        if (is_declaration && !word.text.empty()) found.push_back(words.normal(word.text));
        is_declaration |= std::ranges::any_of(tables.language.statements, declares);
        at += std::max<std::size_t>(1, word.text.size());
    }
    return found;
}

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
    const auto fault = compile_block(run_.tables, run_.variables.level().symbols, line.text,
                                     line.context, line.line);
    if (!fault) line.kind = CompiledLine::Kind::Compiled;
    if (!fault) return;
    for (std::string& name : words_of_declaration(run_.tables, line.text))
        lost_names_.insert(std::move(name));
    // A name that a line with a mistake should have declared is no second mistake.
    if (is_lost(line, *fault)) run_.lines.faults().note_fault();
    else run_.lines.report_fault(line.text, *fault);
}

bool LineCompiler::is_lost(const CompiledLine& line, const LineFault& fault) const {
    const bool is_of_name = fault.row == &diag::NameUnknown || fault.row == &diag::IsoUnknownWord;
    if (!is_of_name || lost_names_.empty()) return false;
    const nc::ControlWords words(run_.tables, line.text);
    return lost_names_.contains(words.normal(words.word_at(fault.span.begin).text));
}

}  // namespace kadr::macro
