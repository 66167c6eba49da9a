// contour_recording.h — contours that are made: their blocks are kept. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// From here on blocks are kept, until the end.
void begin_contour(Running& run);
/// What has been kept, as an array of this layout; the modal state is as it was before.
std::int64_t end_contour(Running& run, std::uint32_t layout);
/// A line to where it began, if there is anything between.
Done close_contour(Running& run, std::uint32_t at);
/// A block of a contour: it is filled as any other one, and its motion becomes an element.
Done keep_plan(Running& run, const sema::Plan& plan, const Instruction& instruction,
               const Slot* registers, std::uint32_t at);
/// One block more: its motion becomes an element.
Done keep(Running& run, const nc::Block& block, std::uint32_t where);
/// Reports what cannot stand in a contour.
Done refuse_in_contour(Running& run, std::string_view what, std::uint32_t at);

}  // namespace kadr::expand
