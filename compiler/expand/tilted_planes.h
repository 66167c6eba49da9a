// tilted_planes.h — tilted planes in the words of the target, or worked out. For the room expand
// only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// Whether the plan programs a tilted plane, or something that does not stand in one.
bool is_about_tilted_plane(const Running& run, const sema::Plan& plan);
/// Executes a plan that is about a tilted plane.
Done emit_tilted_plane(Running& run, const sema::Plan& plan, const Instruction& instruction,
                       const Slot* registers, std::uint32_t at);
/// Reports what cannot stand in a tilted plane.
Done refuse_in_tilted_plane(Running& run, std::string_view what, std::uint32_t at);

}  // namespace kadr::expand
