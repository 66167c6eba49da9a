// known_position.h — where the tool is, as far as the program tells, and what changes of the frame
// have made of it. For the room expand only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/axes.h"
#include "base/source.h"

namespace kadr::expand {

inline constexpr auto kAllAxes = static_cast<AxisMask>((1u << kAxes) - 1u);

/// What has made modal state unknown.
enum class Loss : std::uint8_t { RawText, SkippedBlock, EndOfWith, Control };

/// … and by which statement.
struct LostBy {
    SourceId statement;
    Loss how = Loss::Control;  // Control: it alone knows what its block has done
};

/// In the programmable frame, mm, degrees. X is what its words are: a diameter, or not.
class KnownPosition {
  public:
    double operator[](std::size_t axis) const { return value_[axis]; }
    bool knows(std::size_t axis) const { return (known_ >> axis & 1u) != 0; }
    AxisMask known() const { return known_; }
    /// The statement that has made an axis unknown; it holds if it was known before.
    const LostBy& lost_by(std::size_t axis) const { return lost_by_[axis]; }

    void set(std::size_t axis, double value) {
        value_[axis] = value;
        known_ = static_cast<AxisMask>(known_ | 1u << axis);
    }
    void set_all(const AxisValues& value) {
        value_ = value;
        known_ = kAllAxes;
    }
    /// A distance is travelled: what was unknown stays so.
    void move(std::size_t axis, double by) { value_[axis] += by; }
    /// The number is another one, known or not.
    void restate(std::size_t axis, double value, bool is_known);
    void lose(AxisMask axes) { known_ &= static_cast<AxisMask>(~axes); }
    void lose_all() { known_ = 0; }
    void lose_all_but(AxisMask axes) { known_ &= axes; }
    /// What a statement has made unknown of `before`.
    void note_loss(AxisMask before, SourceId by, Loss how);
    /// Known is what both agree on.
    void join(const KnownPosition& other);

    /// Whether rotary axes may stand elsewhere than at 0.
    bool is_turned() const { return is_turned_; }
    void turn(bool is_turned) { is_turned_ = is_turned; }

  private:
    AxisValues value_{};
    AxisMask known_ = 0;
    bool is_turned_ = false;
    std::array<LostBy, kAxes> lost_by_{};
};

/// Position less the coordinate that was programmed last: what changes of the frame have made of it
/// since. Some controls travel it with the next increment. mm.
struct Drift {
    AxisValues by{};
    AxisMask has = 0;   // axes of which it is not 0
    AxisMask lost = 0;  // … and of which it is not known

    void add(std::size_t axis, double distance);
    void lose(AxisMask axes) { lost |= axes; }
    /// The tool is where only the control knows.
    void lose_all() { lost |= has; }
    /// Of these axes, where there is any.
    void lose_some(AxisMask axes) { lost |= has & axes; }
    /// Coordinates of these axes were named: increments count from there.
    void forget(AxisMask axes);
    AxisMask acts() const { return has | lost; }
};

/// The drift from what is programmed, and from what its text has, which names more.
class Drifts {
  public:
    const Drift& of_program() const { return of_program_; }
    const Drift& of_text() const { return of_text_; }
    /// Axes of which no position was named since a rotation began or ended.
    AxisMask unplaced() const { return unplaced_; }
    /// Axes whose words a block may have to give otherwise than the program does.
    AxisMask adapts() const { return of_program_.acts() | of_text_.acts() | unplaced_; }

    /// Of the program and of its text alike.
    void add(std::size_t axis, double distance);
    void forget(AxisMask axes);
    void lose(AxisMask axes);
    void lose_some(AxisMask axes);
    void lose_all() { lose_some(kAllAxes); }

    /// Axes that a rotation begins or ends to turn.
    void turn(AxisMask axes) { unplaced_ |= axes; }
    /// The block that is being made names this axis, which the program does not.
    void name_by_text(AxisMask axis) { named_by_text_ |= axis; }
    /// A block names axes. One that the operator may leave out may have gone nowhere.
    void take_named(AxisMask named, bool may_be_left_out) {
        const auto programmed =
            static_cast<AxisMask>(named & ~std::exchange(named_by_text_, AxisMask{0}));
        if (may_be_left_out || adapts() != 0) take_named(named, programmed, may_be_left_out);
    }

  private:
    void take_named(AxisMask named, AxisMask programmed, bool may_be_left_out);

    Drift of_program_;
    Drift of_text_;
    AxisMask named_by_text_ = 0;  // axes of the block that is made, not programmed
    AxisMask unplaced_ = 0;
};

}  // namespace kadr::expand
