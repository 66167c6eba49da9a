// vm.h — the instructions. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// Runs instructions until the batch is full, or to the end of the program.
///
/// returns      how many blocks of `out` are filled; 0: the program has ended
std::size_t pull(Running& run, std::span<nc::Block> out);
/// Runs the function of a curve from an instruction on, until it returns. Every real number carries
/// its derivative by the curve's parameter (forward differentiation): it stands in `slopes` under
/// the number of its register. What comes out of an array counts as constant.
void execute_with_slopes(Running& run, std::uint32_t from);
/// Reports why the evaluation ends before the program does.
void report_end(Running& run, std::uint32_t at);

}  // namespace kadr::expand
