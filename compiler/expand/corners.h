// corners.h — chamfers and roundings of a program and of its contours: cut between two motions, and
// lines and arcs of their own where the target has no word for them. For the room expand only.
#pragma once

#include <optional>

#include "expand/running.h"
#include "path/contour_corner.h"

namespace kadr::expand {

/// The line at an angle that waits for its end: of the contour that is made, or of the program.
std::optional<OpenLine>& open_line(Running& run);
/// The block that is being made has closed it.
Done take_closed_line(Running& run, const path::Element& line,
                      const std::optional<WantedCorner>& corner, std::uint32_t at);

/// The corner that the block that was made last wants at its end, by a word of its own or by that
/// of all corners; it is taken.
std::optional<WantedCorner> take_wanted(Running& run, std::uint32_t at);
/// What takes the place of the corner between two elements; nothing where they go on straight.
Done cut_corner(Running& run, const WantedCorner& corner, const path::Element& a,
                const path::Element& b, std::optional<path::CornerCut>& cut);
/// Reports a corner that has no second side, and why.
Done refuse_open_corner(Running& run, const WantedCorner& corner, std::string_view why);

/// Whether the block that was made last may be a side of a corner, or wants one.
inline bool is_about_corner(const Running& run) {
    return !run.recordings.is_open() && (run.corners.acts() || run.modal.drawing.rounding > 0);
}
/// The block that was made last, behind the motion before it and with the modal state behind it.
///
/// before       where the tool was before the block
Done finish_side(Running& run, const KnownPosition& before, std::uint32_t at);
/// Another block may wait for the second side.
Done require_room_to_wait(Running& run);
/// The program has ended.
void finish_corners(Running& run);

}  // namespace kadr::expand
