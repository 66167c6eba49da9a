// corner_state.h — chamfers, roundings and lines at an angle whose other side is still to come. For
// the room expand only.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "control/program_frame.h"
#include "path/contour_corner.h"
#include "path/frame.h"

namespace kadr::expand {

/// A chamfer or a rounding at the end of a motion.
struct WantedCorner {
    path::CornerShape shape;
    bool is_modal = false;
    std::uint32_t at = 0;  // the instruction of its word

    std::string_view name() const {
        return shape.kind == path::CornerShape::Kind::Rounding ? "rounding" : "chamfer";
    }
};

/// A line whose end the next block gives.
struct OpenLine {
    double angle_deg = 0;
    path::Vec2 from = path::Vec2::Zero();
    std::optional<WantedCorner> corner;
    std::uint32_t at = 0;
    std::size_t held = 0;  // blocks, its own is the last of them
};

/// What may not change between the two sides of a corner.
struct SideState {
    path::Plane plane = path::Plane::Xy;
    bool is_diameter = false;
    control::ProgramFrame frame;
    double work_offset = 0;
    std::optional<double> tool;

    friend bool operator==(const SideState&, const SideState&) = default;
};

/// The motion before a corner; its block is the first of those that the batch holds.
struct WaitingSide {
    WantedCorner corner;
    path::Element element;
    SideState state;
    bool begins_compensation = false;
    bool is_incremental = false;  // its words, by the dimensions of then
};

/// Of the blocks of the program; a contour that is made has its own.
struct CornersInWork {
    std::optional<WantedCorner> wanted;  // by the block that is being made
    std::optional<WaitingSide> waiting;
    std::optional<OpenLine> open;         // its block is the last that is held …
    std::optional<path::Element> closed;  // … or the one before the block that has closed it
    std::optional<WantedCorner> of_closed;
    bool opens = false;  // the block that is being made is such a line

    bool acts() const { return wanted || waiting || open || closed; }
};

}  // namespace kadr::expand
