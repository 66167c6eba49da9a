// curve_of.h — the path of a motion as geometry.
#pragma once

#include "path/curve.h"
#include "path/motion.h"

namespace kadr::path {

/// The curve along which a motion takes the tip from one point to another; a Point if it stays.
///
/// from  mm, where the tip is; of an arc its centre belongs to it
Curve curve_of(const Motion& motion, const Vec3& from, const Vec3& to);

}  // namespace kadr::path
