// fixed_targets.h — what jumps and calls name: which line of a program, which program.
//
// For who executes them, with values that were worked out, and for who only reads them
// (references.h), where nothing has to be worked out.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "macro/program_map.h"
#include "nc/control_words.h"

namespace kadr::macro {

/// In which direction a jump looks for its target.
Direction direction_of(nc::Statement jump);

/// The target that a text names: a label, or a block by its number, `N120`.
LineTarget target_named(const nc::ControlWords& words, std::string_view text);
/// The block with this number; nothing: no block has one like it.
std::optional<LineTarget> block_numbered(const nc::DialectTables& tables, double number);
/// The target in a compiled line; nothing: there is none, or it is worked out where the line runs.
std::optional<LineTarget> fixed_target(const nc::DialectTables& tables, const nc::ControlLine& line,
                                       const nc::JumpTarget& target);

/// A program by the number that calls it: 30012 may be 3 times 12.
struct NumberedProgram {
    std::string name;
    std::int64_t passes = 1;
};
/// Nothing: no program has a number like this.
///
/// split  numbers with more digits hold the passes in front of so many; 0: they do not
std::optional<NumberedProgram> program_numbered(double number, int split);
/// How many digits of the number are the program's; 0: all are.
int split_of(const nc::CallForm* form, const nc::Call& call);

/// The number of a call; nothing: it is not given, or worked out where the line runs.
std::optional<double> fixed_number(const nc::ControlLine& line, const nc::CallValue& value);
/// The text that an expression is; nothing: it is another value, or worked out.
std::optional<std::string> fixed_text(const nc::ControlLine& line, const nc::Expression& value);

}  // namespace kadr::macro
