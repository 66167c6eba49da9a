// quantity.h — numbers with units, as machine files write them: `30 m/min`, `-300..300 mm`.
//
// A unit is always written: a forgotten one is a factor of a thousand in an acceleration.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace kadr::machine {

enum class QuantityKind : std::uint8_t {
    Time,
    Length,
    Angle,
    Velocity,
    AngularVelocity,
    Acceleration,
    AngularAcceleration,
    Jerk,
    AngularJerk,
    Force,
    Torque,
    Inertia,
    Damping,
    Current,
    TorquePerCurrent,
    Rate,
    Frequency,
    Power,
    Share,
};

enum class QuantityFault : std::uint8_t { NotANumber, DecimalComma, UnitMissing, UnitUnknown };

struct QuantityError {
    QuantityFault fault;
    std::string_view text;  // the part that is wrong
};

struct Range {
    double lower = 0;
    double upper = 0;
};

/// A number and a unit of the dimension, in canonical units: mm or rad, and seconds; an
/// AngularVelocity in `rpm` is rad/s too. What belongs to drives is in SI units: N, N·m, kg·m²,
/// N·m·s, A, 1/s, Hz, W; a Share is a number, 1 for `100 %`.
Result<double, QuantityError> parse_quantity(std::string_view text, QuantityKind dimension);

/// `lower..upper unit`, canonical; the order of the two is the caller's matter.
Result<Range, QuantityError> parse_range(std::string_view text, QuantityKind dimension);

/// The unit's names, for messages: "`mm`, `m` or `in`".
std::string unit_names(QuantityKind dimension);
/// What the dimension is called in messages: "a length".
std::string_view dimension_name(QuantityKind dimension);

}  // namespace kadr::machine
