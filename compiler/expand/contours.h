// contours.h — contours: blocks that are kept, questions, and the blocks that `follow` makes of
// them. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// A contour outside of the heap, with the plane in which it lies.
/// Geometry as it is on the part; as words and as points of the program X may be a diameter.
struct PlaneContour {
    path::Contour elements;
    path::Plane plane = path::Plane::Xy;
    bool is_diameter = false;
};

/// A contour on the heap, as an array of this layout.
std::int64_t make_contour(Running& run, const PlaneContour& contour, std::uint32_t layout);
/// Executes ContourValue: what a contour answers, or another one that is made of it.
Done contour_value(Running& run, const Instruction& instruction, Slot* registers, std::uint32_t at);
/// From here on blocks are kept, until the end.
void begin_contour(Running& run);
/// What has been kept, as an array of this layout; the modal state is as it was before.
std::int64_t end_contour(Running& run, std::uint32_t layout);
/// A line to where it began, if there is anything between.
Done close_contour(Running& run, std::uint32_t at);
/// A block of a contour: it is filled as any other one, and its motion becomes an element.
Done keep_plan(Running& run, const sema::Plan& plan, const Instruction& instruction,
               const Slot* registers, std::uint32_t at);
/// Reports what cannot stand in a contour.
Done refuse_in_contour(Running& run, std::string_view what, std::uint32_t at);
/// Executes FollowStart: where `follow` begins, leads included.
Done follow_start(Running& run, const Instruction& instruction, Slot* registers, std::uint32_t at);
/// Executes FollowContour: the blocks along a contour, from where the tool is.
Done follow_contour(Running& run, const Instruction& instruction, const Slot* registers,
                    std::uint32_t at);
/// A line or an arc as a block in the present plane, in coordinates.
Done emit_element(Running& run, const path::Element& element, const FollowedBlock& next,
                  std::uint32_t at);
/// What every block that follows has behind its coordinates: the feed, checks, the modal state.
Done finish_followed(Running& run, nc::Block& block, const FollowedBlock& next, std::uint32_t at);

}  // namespace kadr::expand
