// contour_recording.h — contours that are made: their blocks are kept. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// From here on blocks are kept, until the end.
void begin_contour(Running& run);
/// What has been kept, as an array of this layout; the modal state is as it was before.
Done end_contour(Running& run, std::uint32_t layout, Slot& result);
/// A line to where it began, if there is anything between.
Done close_contour(Running& run, std::uint32_t at);
/// A block of a contour: it is filled as any other one, and its motion becomes an element.
Done keep_plan(Running& run, const sema::Plan& plan, const Instruction& instruction,
               const Slot* registers, std::uint32_t at);
/// One element more, behind the corner between it and the last one.
///
/// corner       at its end
Done add_element(Running& run, path::Element element, const std::optional<WantedCorner>& corner);
/// The line or the arc of a block between two points of the plane that acts. Nothing: there is no
/// such arc, or its words are none; reported.
std::optional<path::Element> element_of(Running& run, const nc::Block& block,
                                        const path::Vec2& from, const path::Vec2& to,
                                        std::uint32_t where);
/// One block more: its motion becomes an element.
Done keep(Running& run, const nc::Block& block, std::uint32_t where);
/// Reports what cannot stand in a contour.
Done refuse_in_contour(Running& run, std::string_view what, std::uint32_t at);

}  // namespace kadr::expand
