// axes.h — the logical axes of a program, shared by text, path and machine.
//
// Logical axes are what programs name: three linear, three rotary, three parallel ones. Which
// physical axis stands behind one, and by which address, is the machine's and the dialect's matter.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace kadr {

enum class Axis : std::uint8_t { X, Y, Z, A, B, C, U, V, W };

inline constexpr std::size_t kAxes = 9;
inline constexpr std::array<std::string_view, kAxes> kAxisNames = {"X", "Y", "Z", "A", "B",
                                                                   "C", "U", "V", "W"};

constexpr std::size_t index(Axis axis) { return static_cast<std::size_t>(axis); }
constexpr bool is_rotary(Axis axis) { return axis >= Axis::A && axis <= Axis::C; }

/// A set of axes, one bit each.
using AxisMask = std::uint16_t;
constexpr AxisMask bit(Axis axis) { return static_cast<AxisMask>(1u << index(axis)); }
inline constexpr AxisMask kLinearXYZ = 0b000000111;
inline constexpr AxisMask kRotaryABC = 0b000111000;

/// One value per logical axis; linear in mm, rotary in degrees.
using AxisValues = std::array<double, kAxes>;

}  // namespace kadr
