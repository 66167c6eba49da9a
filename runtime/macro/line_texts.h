// line_texts.h — names in a line that stand for text or for numbers of variables.
#pragma once

#include <string>
#include <string_view>

#include "macro/outcome.h"
#include "macro/program_frame.h"
#include "macro/variable_numbers.h"

namespace kadr::macro {

class ProgramBase;

class LineTexts {
  public:
    /// run  outlives it
    explicit LineTexts(ProgramBase& run) : run_(run) {}

    /// The line with what its names stand for; lives until the next one.
    std::string_view with_macros(std::string_view text);
    /// A word stands for text, in the program that runs.
    Outcome define_macro(CompiledLine& line, const nc::ControlStatement& statement);
    /// Names stand for numbers of variables, in all programs.
    Outcome name_variables(CompiledLine& line, const nc::ControlStatement& statement);

  private:
    ProgramBase& run_;
    VariableNumbers names_;      // that the program has given
    std::string named_text_;     // of the line that is read, with their numbers
    std::string expanded_text_;  // of the line that is read, if it has words that stand for text
};

}  // namespace kadr::macro
