// frame.h — the programmable frame as the expander follows it: shift, rotation in a plane, mirrors.
#pragma once

#include <array>
#include <cstdint>

#include "nc/vocabulary.h"

namespace kadr::expand {

/// point in the outer system = shift + rotation(angle) · mirror · point. In the canonical order of
/// the vocabulary: shift, then rotate, then mirror.
struct ProgramFrame {
    std::array<double, 3> shift{};     // mm
    std::array<bool, 3> is_shifted{};  // component was named somewhere
    double angle_deg = 0;
    nc::Function plane = nc::Function::PlaneXy;  // of the rotation
    std::array<bool, 3> is_mirrored{};

    friend bool operator==(const ProgramFrame&, const ProgramFrame&) = default;
    bool has_mirror() const { return is_mirrored[0] || is_mirrored[1] || is_mirrored[2]; }
    bool is_identity() const;
    /// The angle of the rotation if it is said behind the mirrors.
    double angle_behind_mirrors_deg() const;

    /// A shift in the system reached so far.
    void add_shift(const std::array<double, 3>& by, const std::array<bool, 3>& given);
    /// A rotation in the system reached so far; false: a rotation in another plane is active.
    bool add_rotation(double by_deg, nc::Function in_plane);
    /// Mirrors axes in the system reached so far; false: cannot be said as shift, rotate, mirror.
    bool add_mirror(const std::array<bool, 3>& axes);
    bool turns_sense() const;
};

/// Positions in a frame of which some components may be unknown.
struct KnownPoint {
    std::array<double, 3> value{};
    std::array<bool, 3> is_known{};
};
/// The same place seen from another frame.
KnownPoint change_frame(const KnownPoint& point, const ProgramFrame& from, const ProgramFrame& to);

}  // namespace kadr::expand
