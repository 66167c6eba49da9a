// recording.h — contours whose blocks are being kept, and curves that are being followed. For the
// room expand only.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/source.h"
#include "expand/corner_state.h"
#include "expand/modal.h"
#include "nc/block.h"
#include "path/contour.h"
#include "path/frame.h"
#include "path/spline_fit.h"

namespace kadr::expand {

/// A contour whose blocks are being kept.
struct ContourRecording {
    ModalState before;
    path::Contour elements;
    path::Plane plane = path::Plane::Xy;
    bool is_diameter = false;
    path::Vec2 start = path::Vec2::Zero();
    path::Vec2 at = path::Vec2::Zero();
    bool has_start = false;
    bool is_closed = false;
    std::optional<WantedCorner> corner;  // at the end of the last element
    std::optional<OpenLine> open;
};

/// The contours around the statement that runs: their blocks become elements, and none is output.
class Recordings {
  public:
    bool is_open() const { return !open_.empty(); }
    void begin(const ModalState& before) { open_.emplace_back().before = before; }
    ContourRecording& innermost() { return open_.back(); }
    ContourRecording end() {
        ContourRecording recording = std::move(open_.back());
        open_.pop_back();
        return recording;
    }
    /// Takes the words of the block that is being kept.
    nc::Block& block() { return block_; }
    bool is_kept(const nc::Block& block) const { return &block == &block_; }

  private:
    std::vector<ContourRecording> open_;  // innermost last
    nc::Block block_;
};

/// What the blocks that follow a contour or a curve have in common.
struct FollowedBlock {
    SourceId source;
    unsigned depth = 0;        // loops around the statement
    double feed = 0;           // of the block, second form included; NaN: none
    bool is_diameter = false;  // the word X is a diameter
    std::int32_t number = -1;  // N of the block; -1: none
};

/// A curve that is being followed: its blocks may fill several batches.
struct Following {
    std::unique_ptr<path::CurveFit> fit;
    path::Nurbs spline;  // its control points are the blocks, if it has any; then there is no fit
    std::size_t next_knot = 0;  // of the spline: block number
    path::Plane plane = path::Plane::Xy;
    std::array<bool, 3> is_given{};  // coordinates, in the order of the plane
    bool has_coordinates = false;    // is_given holds
    path::Vec2 at = path::Vec2::Zero();
    FollowedBlock next;
};

/// The curve that is followed, if one is; only curves.cpp writes it.
struct CurveAtWork {
    std::optional<Following> following;
    bool is_in_point = false;  // a point of it is being calculated
};

}  // namespace kadr::expand
