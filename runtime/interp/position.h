// position.h — where the tool tip stands. Internal to interp.
#pragma once

#include <bit>

#include "base/axes.h"
#include "control/frames.h"
#include "path/command.h"

namespace kadr::interp {

/// The result of motions, in three systems. Lengths mm, angles deg; X of a lathe is a radius here.
class Position {
  public:
    /// The last coordinate programmed for each axis.
    const AxisValues& programmed() const { return programmed_; }
    /// In the programmed system in force.
    const AxisValues& here() const { return here_; }
    /// In the base coordinate system; the frame of `here`, but for axes that stand elsewhere.
    const AxisValues& base() const { return base_; }
    /// A point of the base system on the way to here: the path has come from there.
    const path::Vec3& came_from() const { return came_from_; }
    /// Whether the program has moved an axis.
    bool has_moved() const { return has_moved_; }

    /// A motion has ended.
    ///
    /// here, base  where, in both systems
    /// named       axes whose coordinate is programmed
    void arrive(const AxisValues& here, const AxisValues& base, AxisMask named) {
        const path::Vec3 before = point_of(base_);
        if (before != point_of(base)) came_from_ = before;
        here_ = here;
        base_ = base;
        for (AxisMask rest = named; rest != 0; rest = static_cast<AxisMask>(rest & (rest - 1))) {
            const auto i = static_cast<std::size_t>(std::countr_zero(rest));
            programmed_[i] = here[i];
        }
    }
    /// One axis has, where it was programmed.
    void arrive_on(std::size_t axis, double here, double base) {
        here_[axis] = programmed_[axis] = here;
        base_[axis] = base;
    }
    /// The path that ended here came from there.
    void come_from(const path::Vec3& point) { came_from_ = point; }
    void note_motion() { has_moved_ = true; }

    /// The tool stands there by no motion of the program; what was programmed stays.
    void stand_at(const AxisValues& base) { base_ = base; }
    /// The frames have changed, or the position in the base system: what are its coordinates now?
    void see_in(const control::Frames& frames) { here_ = frames.from_base(base_); }
    /// The system has changed and the coordinates are the same in it.
    void keep_coordinates(const control::Frames& frames) { base_ = frames.to_base(here_); }
    /// Increments count from here.
    void name() { programmed_ = here_; }
    void name(std::size_t axis) { programmed_[axis] = here_[axis]; }
    /// … from where they did then.
    void name_as(const Position& before, std::size_t axis) {
        programmed_[axis] = before.programmed_[axis];
    }

  private:
    static path::Vec3 point_of(const AxisValues& values) {
        return {values[0], values[1], values[2]};
    }

    AxisValues programmed_{};
    AxisValues here_{};
    AxisValues base_{};
    path::Vec3 came_from_ = path::Vec3::Zero();
    bool has_moved_ = false;
};

}  // namespace kadr::interp
