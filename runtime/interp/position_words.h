// position_words.h — blocks that give their positions otherwise become blocks of coordinates.
#pragma once

#include <array>
#include <optional>

#include "interp/motion_words.h"

namespace kadr::interp {

/// Polar coordinates, angles of lines, and the centre that stays where a control keeps it.
///
/// The blocks that it answers with are its own, until the next one is asked for. Null: a message
/// was given.
class PositionWords {
  public:
    /// Whether blocks that give coordinates mean them.
    bool is_plain() const { return !polar_.is_on && !polar_.is_by_points; }
    const Polar& polar() const { return polar_; }

    void set_pole(const nc::Block& block, const nc::Invocation& invocation,
                  const MotionWords& words);
    /// A pole belongs to its plane.
    void leave_plane();
    void switch_polar(bool is_on, const MotionWords& words);

    const nc::Block* with_positions(const nc::Block& block, MotionWords& words);
    /// The block once more: angles and radii that are distances go on from where they have come to.
    /// Null: its words were no polar coordinates.
    const nc::Block* repeated(MotionWords& words);
    const nc::Block* with_angle(const nc::Block& block, const nc::Invocation& angle,
                                MotionWords& words);
    const nc::Block& with_center(const nc::Block& block, const MotionWords& words);

  private:
    const nc::Block* with_polar_point(const nc::Block& block, const nc::Invocation& point,
                                      MotionWords& words);
    Done take_pole(const nc::Block& block, const MotionWords& words);
    const nc::Block* with_polar_slots(const nc::Block& block, MotionWords& words);
    const nc::Block* with_polar_axes(const nc::Block& block, MotionWords& words);

    Polar polar_;
    std::array<std::optional<double>, 3> centers_;  // programmed last, in the programmed system
    nc::Block cartesian_{};
    nc::Block centered_{};
    std::optional<nc::Block> original_;  // what `cartesian_` was made of, by words of the axes
};

inline constexpr double kFullTurn = 360;  // deg

}  // namespace kadr::interp
