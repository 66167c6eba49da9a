// frame_steps.h — the steps of a programmable frame, in their order, since the last shift.
//
// A deletion takes its own steps out and leaves the others as they were programmed: behind
// `rotate(90deg, x: 2mm); rotate(30deg, x: 7mm); rotate_off();` the origin is where it was before.
// The normal form (program_frame.h) does not know any more which share of its shift a rotation has
// made.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "control/program_frame.h"

namespace kadr::control {

/// More steps than this come only from a loop that adds frames; controls that do so can delete
/// nothing but the whole, so the oldest two may become one.
inline constexpr std::size_t kMaxSteps = 64;

class FrameSteps {
  public:
    /// A shift that replaces the whole frame, mm.
    void shift(const std::array<double, 3>& by, const std::array<bool, 3>& given);
    void shift_add(const std::array<double, 3>& by, const std::array<bool, 3>& given);
    void rotate(double angle_deg, nc::Function plane, const std::array<double, 3>& about);
    /// The same on a control that scales first, wherever the rotation is programmed (F 3.7 G68):
    /// about the scaled point, where it stays when the scale is deleted.
    void rotate_scaled(double angle_deg, nc::Function plane, const std::array<double, 3>& about);
    /// by  factors > 0
    void scale(const std::array<double, 3>& by, const std::array<double, 3>& about);
    /// replaces  a further mirror of an axis goes on mirroring, in the place of undoing it
    void mirror(const std::array<bool, 3>& axes, bool replaces = false);

    void rotate_off() { erase(Step::Kind::Rotation); }
    void scale_off() { erase(Step::Kind::Scale); }
    /// Of the axes of a mask, 0: of all.
    void mirror_off(std::uint32_t axes);

    /// A frame as blocks give it: the whole shift, then mirrors, scale and rotation, an unequal
    /// scale inside of the rotation.
    void say(const ProgramFrame& frame);

    struct Made {
        ProgramFrame frame;
        FrameFormFault fault = FrameFormFault::None;
    };
    Made frame() const;

  private:
    struct Step {
        enum class Kind : std::uint8_t { Rotation, Scale, Mirror, Shift };
        Kind kind = Kind::Shift;
        ProgramFrame frame;  // what functions of this kind have made, one behind the other
    };

    ProgramFrame& last(Step::Kind kind);
    void erase(Step::Kind kind);
    void join_oldest();

    ProgramFrame shift_;       // before any step: shifts alone
    std::vector<Step> steps_;  // those of a kind in a row are one
};

/// Whether two frames are one but for rounding.
bool is_same(const ProgramFrame& a, const ProgramFrame& b);

}  // namespace kadr::control
