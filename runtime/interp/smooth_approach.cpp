#include "interp/smooth_approach.h"

#include <cmath>
#include <utility>

#include "base/diagnostics/iso.h"

namespace kadr::interp {

using path::Command;
using path::Op;
using path::Vec2;

void SmoothApproach::begin(const ApproachMove& move, path::Plane plane, const AxisValues& from,
                           const AxisValues& to, bool has_point, bool has_level) {
    is_active_ = true;
    move_ = move;
    axes_ = path::axes_of(plane);
    from_ = from;
    to_ = to;
    has_point_ = has_point;
    has_level_ = has_level;
    empty_blocks_ = -1;  // its own block is none of them
    fresh_.clear();
    held_.clear();
}

const DiagnosticRow* SmoothApproach::end_block(int empty_blocks) {
    bool has_moved = false;
    const DiagnosticRow* fault = nullptr;
    for (Command& command : fresh_) {
        has_moved = has_moved || command.is_motion();
        // Behind the contour's beginning all goes through.
        if (!is_active_) held_.push_back(std::move(command));
        else if (fault == nullptr) fault = take(command);
    }
    fresh_.clear();
    if (fault != nullptr || has_moved || !is_active_) return fault;
    return ++empty_blocks_ > empty_blocks ? &diag::SoftEmptyBlocks : nullptr;
}

const DiagnosticRow* SmoothApproach::take(Command& command) {
    if (!command.is_motion()) {
        held_.push_back(std::move(command));
        return nullptr;
    }
    const path::Motion& motion = command.motion();
    const bool is_arc = motion.op() == Op::Arc;
    const bool is_straight = motion.op() == Op::Line || motion.op() == Op::Rapid;
    if (motion.machine_coordinates) return &diag::SoftNoPlace;
    const Vec2 delta = in_plane(motion.to) - in_plane(has_point_ ? to_ : from_);
    const bool moves = is_arc || delta.norm() > path::kSamePoint;
    if (!has_point_) return moves && is_straight ? take_point(motion) : &diag::SoftNoPlace;
    if (!is_arc && !is_straight) return &diag::SoftNoDirection;
    if (!moves) {
        // The level of the contour, if the approach has not given it.
        if (has_level_ || !is_straight) return &diag::SoftNoPlace;
        to_ = motion.to;
        has_level_ = true;
        return nullptr;
    }
    direction_ = delta.normalized();
    if (is_arc) {
        const path::ArcShape& arc = motion.arc();
        const Vec2 center{arc.center[static_cast<Eigen::Index>(index(axes_.first))],
                          arc.center[static_cast<Eigen::Index>(index(axes_.second))]};
        const double side = arc.normal.dot(path::unit(axes_.normal));
        if (std::abs(side) < 1 - 1e-9) return &diag::SoftNoDirection;
        const Vec2 arm = (in_plane(to_) - center).normalized();
        direction_ = Vec2(-arm.y(), arm.x()) * side;
    }
    is_active_ = false;
    held_.push_back(std::move(command));
    return nullptr;
}

/// The line behind the approach gives where the contour begins, and does not move by itself.
const DiagnosticRow* SmoothApproach::take_point(const path::Motion& motion) {
    const std::size_t normal = index(axes_.normal);
    const bool has_level = std::abs(motion.to[normal] - to_[normal]) > path::kSamePoint;
    if (has_level_ && has_level) return &diag::SoftNoPlace;
    to_ = motion.to;
    has_point_ = true;
    has_level_ = has_level_ || has_level;
    return nullptr;
}

Vec2 SmoothApproach::in_plane(const AxisValues& values) const {
    return {values[index(axes_.first)], values[index(axes_.second)]};
}

}  // namespace kadr::interp
