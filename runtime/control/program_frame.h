// program_frame.h — the programmable frame as the expander follows it: shift, rotation in a plane,
// scale, mirrors.
#pragma once

#include <array>
#include <cstdint>

#include "base/axes.h"
#include "nc/vocabulary.h"

namespace kadr::control {

/// Why a frame cannot be written as one shift, one rotation, one scale and mirrors.
enum class FrameFormFault : std::uint8_t {
    None,
    Planes,     // rotations in two planes
    Stretched,  // a rotation inside a scale that makes an ellipse of a circle
};

/// point in the outer system = shift + center + rotation(angle) · (scale · mirror · point −
/// center).
struct ProgramFrame {
    std::array<double, 3> shift{};     // mm
    std::array<bool, 3> is_shifted{};  // component was named somewhere
    double angle_deg = 0;
    nc::Function plane = nc::Function::PlaneXy;  // of the rotation
    std::array<double, 3> center{};              // of the rotation, mm; 0 across the plane
    std::array<double, 3> scale{1, 1, 1};        // > 0
    std::array<bool, 3> is_mirrored{};

    friend bool operator==(const ProgramFrame&, const ProgramFrame&) = default;
    bool has_mirror() const { return is_mirrored[0] || is_mirrored[1] || is_mirrored[2]; }
    bool has_scale() const { return scale != std::array<double, 3>{1, 1, 1}; }
    bool has_center() const { return center != std::array<double, 3>{}; }
    bool is_identity() const;
    /// The axes that its rotation turns.
    AxisMask plane_mask() const;
    /// Whether it moves the part and nothing else.
    bool is_shift() const { return angle_deg == 0 && !has_scale() && !has_mirror(); }
    /// Whether a right-hand screw becomes a left-hand one.
    bool is_left_handed() const { return is_mirrored[0] != (is_mirrored[1] != is_mirrored[2]); }
    /// Whether the axis may have another coordinate in the other frame.
    bool differs(const ProgramFrame& other, std::size_t axis) const;
    /// Whether circles of the plane become ellipses.
    bool is_stretched(nc::Function in_plane) const;
    /// The center as the innermost system of the control has it, scale and mirrors worked in.
    std::array<double, 3> inner_center() const;
    /// Angle of a rotation inside the mirrors that is the same as this one outside of them.
    double inner_angle_deg() const;

    /// A shift in the system reached so far.
    void add_shift(const std::array<double, 3>& by, const std::array<bool, 3>& given);
    /// A rotation in the system reached so far, about a point of it.
    FrameFormFault add_rotation(double by_deg, nc::Function in_plane,
                                const std::array<double, 3>& about);
    /// Factors > 0 in the system reached so far, about a point of it.
    void add_scale(const std::array<double, 3>& by, const std::array<double, 3>& about);
    /// Mirrors axes in the system reached so far.
    void add_mirror(const std::array<bool, 3>& axes);
    /// Ends the mirroring of the axes of a mask, 0: of all.
    void remove_mirror(std::uint32_t axes);

  private:
    void move_shift(const std::array<double, 3>& by);
};

/// Positions in a frame of which some components may be unknown.
struct KnownPoint {
    std::array<double, 3> value{};
    std::array<bool, 3> is_known{};
};
/// The same point seen from another frame.
KnownPoint change_frame(const KnownPoint& point, const ProgramFrame& from, const ProgramFrame& to);

}  // namespace kadr::control
