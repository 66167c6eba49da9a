// curve_of.h — the way of a command as geometry.
#pragma once

#include "path/command.h"
#include "path/curve.h"

namespace kadr::path {

/// The curve along which a motion takes the tip from one place to another; a Point if it stays.
///
/// command  is_motion()
/// from     mm, where the tip is; of an arc its centre belongs to it
Curve curve_of(const Command& command, const Vec3& from, const Vec3& to);

}  // namespace kadr::path
