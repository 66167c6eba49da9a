// scopes.h — what `with` sets back, what a cycle needs and preserves. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// The innermost `with` ends: what it found acts again.
Done leave_with(Running& run, SourceId source, std::uint32_t at, unsigned depth);
/// Where no work offset is programmed, that of the text's head acts.
void take_offset_of_head(const Running& run, ModalState& state);
/// Blocks that bring back what was found.
Done set_back(Running& run, const OpenWith& scope, SourceId source, std::uint32_t at,
              unsigned depth);
/// What a cycle preserves it also relies on: `preserves G90` called under G91 would work with
/// distances where its author wrote coordinates.
Done check_needs(Running& run, std::uint32_t at);
/// Executes CheckPreserves: what a cycle has promised holds where it ends.
Done check_preserves(Running& run, std::uint32_t at);

}  // namespace kadr::expand
