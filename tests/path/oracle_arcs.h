// oracle_arcs.h — the arcs of tests/oracles/curves.json as the control's rules make them.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "path/arc.h"

namespace kadr::path::test {

using Json = nlohmann::json;

inline Vec3 vec3(const Json& json) {
    return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

/// The arc of a case's `input`.
inline Result<Arc, ArcFault> arc_of(const Json& input) {
    const ArcEnds ends{vec3(input["start"]), vec3(input["end"])};
    const std::string form = input["form"];
    if (form == "three_points") return arc_through(ends, vec3(input["intermediate"]));
    if (form == "tangent") return arc_along_tangent(ends, vec3(input["start_tangent"]));
    const std::string plane = input["plane"];
    const ArcTurning turning{plane == "G17"   ? Plane::Xy
                             : plane == "G18" ? Plane::Zx
                                              : Plane::Yz,
                             input["g"] == "G2", input.value("turns", 0)};
    if (form == "radius") return arc_of_radius(ends, input["radius"], turning);
    return arc_about_center(ends, vec3(input["center"]), turning, {});
}

}  // namespace kadr::path::test
