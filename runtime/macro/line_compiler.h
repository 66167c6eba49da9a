// line_compiler.h — lines of the control's own language, compiled once.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "macro/program_frame.h"

namespace kadr::macro {

class ProgramRun;

/// Compiles a block of the control's own language. Where whole blocks are arguments of a modal call
/// (`context.is_argument`), those are taken so that are no statements.
std::optional<nc::LineFault> compile_block(const nc::DialectTables& tables,
                                           const nc::SymbolTable& symbols, std::string_view text,
                                           const nc::LineContext& context, nc::ControlLine& out);

/// The words behind the keyword of a line that declares variables and could not be read: the names
/// among them are lost. Empty: the line declares none.
std::vector<std::string> words_of_declaration(const nc::DialectTables& tables,
                                              std::string_view text);

class LineCompiler {
  public:
    /// run  outlives it
    explicit LineCompiler(ProgramRun& run) : run_(run) {}

    /// What kind of line it is; one that cannot be read stays New.
    void compile(CompiledLine& line, nc::Block& out);
    /// … of the control's own language.
    void compile_language(CompiledLine& line);

  private:
    bool is_lost(const CompiledLine& line, const nc::LineFault& fault) const;

    ProgramRun& run_;
    std::set<std::string> lost_names_;  // of declarations that could not be read
};

}  // namespace kadr::macro
