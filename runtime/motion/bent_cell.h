// bent_cell.h — a short piece of bent path as the accelerations of the axes see it.
//
// Where dq/ds = p and d²q/ds² = c an axis accelerates by p·a + c·v². In a cell a is constant, so v²
// is linear in the distance, and p and c nearly are: what holds at both ends holds between them but
// for a remainder, which the limits leave. Fixed shares for turning and for speeding up, as on a
// whole arc, are then not needed; the axis that turns the path is not the one that speeds it up.
// Under a transformation the same holds of every axis, with its own p and c (transformed_cells.h).
//
// Knows the two ends of one cell; the speeds over many are lookahead.h's. Speeds are squared.
//
// source       reference motion §2.6 (the constraints of TOPP-RA at both ends of every cell)
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "base/axes.h"
#include "motion/profile.h"
#include "path/curve.h"

namespace kadr::motion {

/// What the linear axes may do; infinite where the path has no such axis.
struct LinearLimits {
    path::Vec3 velocity = path::Vec3::Constant(std::numeric_limits<double>::infinity());
    path::Vec3 acceleration = path::Vec3::Constant(std::numeric_limits<double>::infinity());
};

struct CellWishes {
    double speed = 0;  // asked for; may be infinite
    double least = 0;  // no cell is shorter, mm
};

struct BentCell {
    /// p and c of every logical axis in parts of what it may accelerate; 0 where there is none.
    struct End {
        AxisValues along{};
        AxisValues across{};
        double speed = std::numeric_limits<double>::infinity();  // limit there
    };
    double length = 0;        // > 0
    double speed = 0;         // limit inside, not squared
    double acceleration = 0;  // along the path, of the axes that do not bend it; may be infinite
    End entry;
    End exit;
};

/// Where to cut a curve so that its parts can be cells: ascending, with 0 and the length at the
/// ends. A part that would have to be cut too finely is no cell.
std::vector<double> cell_bounds(const path::Curve& curve, double length, const LinearLimits& limits,
                                const CellWishes& wishes);

/// A part between two such bounds as a cell.
///
/// speed        wanted; that of the cell is what the velocities of the axes leave of it
std::optional<BentCell> cell_of(const path::Curve& part, double length, const LinearLimits& limits,
                                double speed);

/// The profile over a cell between two speeds that suit it: one acceleration, but for a cell from
/// rest to rest, as at the end of a short look-ahead.
Profile profile_over(const BentCell& cell, double entry, double exit);

/// The greatest entry speed up to `entry_most` from which an exit speed up to `exit_most` can be
/// had; all squared.
double entry_square(const BentCell& cell, double entry_most, double exit_most);

/// The greatest exit speed up to `exit_most`; all squared.
double exit_square(const BentCell& cell, double entry, double exit_most);

/// Greatest acceleration of each axis, in parts of its limit: between two speeds, and at
/// most if the acceleration and the squared speed are not above those given.
AxisValues load_between(const BentCell& cell, double entry_speed, double exit_speed);
AxisValues greatest_load(const BentCell& cell, double acceleration, double square);

}  // namespace kadr::motion
