// value_statements.h — statements that set variables and declare them.
#pragma once

#include "macro/outcome.h"
#include "macro/program_frame.h"

namespace kadr::macro {

class ProgramBase;

/// Where the values of a list go.
struct ListTarget {
    nc::ControlInstruction load;  // Element, Global
    std::string name;             // for messages
    std::uint32_t first = 0;      // slot of the first one
    std::uint32_t left = 0;       // so many there are from it on
};

class ValueStatements {
  public:
    /// run  outlives it
    explicit ValueStatements(ProgramBase& run) : run_(run) {}

    /// Sets a variable, or those of a list; some act: `out` then is the block.
    Outcome assign(CompiledLine& line, const nc::ControlStatement& statement, nc::Block& out);
    /// Declares the variables of a line.
    Outcome declare(CompiledLine& line, const nc::ControlStatement& statement);
    /// Declares one, of a text with so many characters.
    Outcome declare_one(CompiledLine& line, const nc::Declaration& declaration, nc::ValueType type,
                        std::uint32_t text_size);
    /// Characters of a text variable.
    Outcome text_size(CompiledLine& line, const nc::Expression& expression, std::uint32_t& out);
    /// The program's own alarm.
    Outcome raise(CompiledLine& line, const nc::Span& span, double number, const std::string& text);

  private:
    Outcome fit_text(CompiledLine& line, const nc::ControlStatement& statement,
                     ControlValue& value);
    Outcome assign_list(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome fill_count(CompiledLine& line, std::span<const nc::Expression> expressions,
                       std::size_t most, std::size_t& out);
    Outcome list_target(CompiledLine& line, const nc::Reference& reference, ListTarget& out);
    VariableFault store_at(const ListTarget& target, std::uint32_t i, const ControlValue& value);
    Outcome limit(CompiledLine& line, const nc::ControlStatement& statement);
    Outcome stop_with_message(std::string_view text, nc::Block& out);

    ProgramBase& run_;
};

}  // namespace kadr::macro
