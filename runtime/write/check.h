// check.h — whether what a dialect file shows is true: its examples, and the lines around a
// program.
//
// What a file holds is checked when it is loaded; here it is tried out, by writing and reading.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "nc/refusals.h"
#include "write/names.h"

namespace kadr::write {

/// Where two meanings, a block a line, or two outcomes part: the block and the first word in it.
std::string first_difference(std::string_view found, std::string_view example);

/// Writes the frame of a program, in mm and in inches, and reads it again. An alarm is reported at
/// the file's `<program>`.
void check_frame(const Dialect& dialect, DiagnosticSink& sink);

/// Whether the blocks that an example's source gives are written as its text, and whether the text
/// reads as what they mean or as what the example gives instead. Without blocks (the example has no
/// source) only the reading is tried. Reported at the attribute that is wrong.
///
/// refusals  forms that were passed over when the blocks were made of the source
void check_example(const Dialect& dialect, const Example& example, std::span<const Block> blocks,
                   DiagnosticSink& sink, std::vector<Refusal> refusals = {});

}  // namespace kadr::write
