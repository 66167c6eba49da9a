// curve_registry.h — the kinds of curve that this program knows beside lines, arcs and splines.
//
// A kind is one file and one registration, linked into the program:
//
//     constexpr path::CurveKind kClothoid = {"clothoid", make, at};
//     const path::CurveRegistration registered(kClothoid);
//
// A dialect names it (`<cycle name="CLOTHOID" curve="clothoid" …>`), and programs call it. Complete
// example: examples/curves. The registry is filled before `main` begins and only read from then on.
#pragma once

#include <string_view>
#include <vector>

#include "path/parametric.h"

namespace kadr::path {

/// Makes a kind known; it outlives the program's run. Two kinds of one name are our own fault.
void register_curve(const CurveKind& kind);

/// Null: there is none of this name.
const CurveKind* find_curve(std::string_view name);

/// In the order of their names.
std::vector<std::string_view> curve_names();

/// Registers a kind where it is defined, as a constant of a file's own namespace.
struct CurveRegistration {
    explicit CurveRegistration(const CurveKind& kind) { register_curve(kind); }
};

}  // namespace kadr::path
