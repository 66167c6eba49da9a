// plane.h — the working plane as the expander needs it: by its function, and its axes as indices.
#pragma once

#include "nc/vocabulary.h"
#include "path/frame.h"

namespace kadr::expand {

/// The plane of G17, G18, G19.
inline path::Plane plane_of(nc::Function function) {
    switch (function) {
        case nc::Function::PlaneZx: return path::Plane::Zx;
        case nc::Function::PlaneYz: return path::Plane::Yz;
        default: return path::Plane::Xy;
    }
}

/// First and second axis of a plane, and the one across it, as indices into positions and points.
struct PlaneIndices {
    std::size_t first;
    std::size_t second;
    std::size_t across;
};
inline PlaneIndices indices_of(path::Plane plane) {
    const path::PlaneAxes axes = path::axes_of(plane);
    return {index(axes.first), index(axes.second), index(axes.normal)};
}

}  // namespace kadr::expand
