// axis_table.h — a path as the machine's axes see it: rates, limits, travel.
//
// Compiled once from the Machine. An axis stands for one coordinate, X Y Z of the tip plus the tool
// length, the others directly; under a transformation the machine's chain turns the path into axes
// (axis_table_transformed.cpp).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/axes.h"
#include "machine/machine.h"
#include "motion/bent_cell.h"
#include "motion/corner.h"
#include "motion/segment.h"
#include "motion/spline_pieces.h"
#include "path/dynamics.h"

namespace kadr::motion {

struct SplineBend;  // spline_pieces.h

/// What the axes allow on one piece.
struct PathLimits {
    double speed = 0;         // infinite if nothing limits it
    double acceleration = 0;  // along the path, at this speed
    double jerk = 0;          // along the path, at this speed and acceleration
    /// The acceleration along the path at which the turning path takes its share of the jerk;
    /// infinite on a straight line.
    double turning_acceleration = 0;
};

struct AxisBounds;

class AxisTable {
  public:
    /// The machine outlives the table.
    explicit AxisTable(const machine::Machine& machine);

    /// The same axes with the parts of their limits that a program leaves them.
    AxisTable under(const path::Dynamics& dynamics) const;

    std::size_t size() const { return axes_.size(); }
    /// The machine's axis behind a logical one; size() if it has none.
    std::size_t slot(Axis axis) const { return slots_[index(axis)]; }
    double acceleration(std::size_t i) const { return axes_[i].acceleration; }
    double jerk(std::size_t i) const { return axes_[i].jerk; }
    /// Without a joint if the machine has no rotary axes that its file places.
    const machine::Chain& chain() const { return *chain_; }
    /// Velocities and accelerations of the logical axes.
    AxisBounds bounds() const;
    /// Whether the jerk of any axis is limited.
    bool limits_jerk() const { return limits_jerk_; }

    /// What X, Y and Z may do.
    const LinearLimits& linear_limits() const { return linear_; }
    /// The greatest speed up to `wanted` and the acceleration that the axes beside X, Y, Z allow.
    PathLimits follower_limits(const Segment& piece, double wanted) const;

    /// dq/ds of every axis at the start and at the end of a piece.
    AxisRates start_rates(const Segment& piece) const;
    AxisRates end_rates(const Segment& piece) const;
    /// d²q/ds² of every axis at the start and at the end of a piece.
    AxisRates start_bends(const Segment& piece) const;
    AxisRates end_bends(const Segment& piece) const;

    /// The greatest path speed up to `wanted`, the acceleration that then remains, and the jerk
    /// that remains with both. `start` are the start_rates of the piece, here and below.
    ///
    /// On an arc the centripetal acceleration takes its share first: at most kNormalShare of what
    /// an axis has, so that enough is left to reach the speed at all. Of the jerk, what turning at
    /// the speed takes and what speeding up while turning takes have fixed shares at most.
    /// source       reference motion §2.1
    PathLimits limits(const Segment& piece, const AxisRates& start, double wanted) const;
    /// The speed along the path at which the tool is nowhere faster than `wanted`.
    static double path_speed(const Segment& piece, double wanted);

    /// What a path does at one moment.
    struct PathState {
        double speed = 0;
        double acceleration = 0;
        double jerk = 0;  // may be infinite
    };
    /// What the acceleration of each axis is made of on a piece: at the path speed v and the path
    /// acceleration a it is at most hypot(turning·a, bend·v²) + rising·a, and at most
    /// hypot(a, curvature·v²) where a curvature is given. The jerk, with that of the path j, is at
    /// most hypot(turning·j + third·v³, 3·bend·v·a) + rising·j, or the sum of all where a curvature
    /// is given.
    struct Loads {
        AxisRates turning{};
        AxisRates bend{};
        AxisRates rising{};
        AxisRates third{};
        double curvature = 0;

        double at(std::size_t i, double speed, double along) const {
            if (bend[i] == 0) return turning[i] * along + rising[i] * along;
            const double sum =
                std::hypot(turning[i] * along, bend[i] * speed * speed) + rising[i] * along;
            if (curvature == 0) return sum;
            return std::min(sum, std::hypot(along, curvature * speed * speed));
        }
        double jerk_at(std::size_t i, const PathState& state) const;
    };
    Loads loads(const Segment& piece, const AxisRates& start) const;

    /// Greatest axis velocities, accelerations and jerks of a piece with these loads under its
    /// profile.
    struct Peaks {
        AxisRates velocity{};
        AxisRates acceleration{};
        AxisRates jerk{};
    };
    Peaks peaks(const Segment& piece, const Loads& loads) const;
    /// The same of the linear axes on a cell, where speeding up and turning never meet in full.
    void measure_cell(const Segment& piece, const BentCell& cell, Peaks& peaks) const;

    /// Positions of the axes at a distance along the piece.
    AxisRates positions(const Segment& piece, double distance) const;

    /// Least and greatest axis positions on the piece.
    struct Travel {
        AxisRates lower{};
        AxisRates upper{};
    };
    Travel travel(const Segment& piece, double length) const;

  private:
    struct Entry {
        std::size_t coordinate;  // logical index: 0…2 of the tip, 3… a follower
        double velocity;
        double acceleration;
        double jerk;
    };
    PathLimits line_limits(const AxisRates& along, double wanted) const;
    PathLimits helix_limits(const path::Helix& helix, const Segment& piece, double wanted) const;
    static double jerk_left(const path::Helix& helix, const Segment& piece, const Entry& axis,
                            const PathLimits& limits);
    PathLimits spline_limits(const SplineBend& bend, double wanted) const;
    PathLimits glide_limits(const path::Glide& glide, double wanted) const;
    AxisRates bends(const Segment& piece, double distance) const;
    // Of a transformed piece; u is the part of its path, 0 … 1.
    AxisRates rates_on(const Segment& piece, double u) const;
    AxisRates bends_on(const Segment& piece, double u) const;
    Loads transformed_loads(const Segment& piece) const;
    PathLimits transformed_limits(const Segment& piece, double wanted) const;
    Travel transformed_travel(const Segment& piece) const;
    AxisRates transformed_positions(const Segment& piece, double distance) const;
    AxisRates rates(const path::Vec3& tangent, const Segment& piece) const;

    const machine::Chain* chain_ = &kNoChain;
    std::vector<Entry> axes_;
    std::array<std::size_t, kAxes> slots_{};
    LinearLimits linear_;
    bool limits_jerk_ = false;
};

}  // namespace kadr::motion
