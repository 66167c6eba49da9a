#include "machine/quantity.h"

#include <array>
#include <numbers>
#include <vector>

#include "base/numbers.h"
#include "base/units.h"
#include "machine/number_list.h"

namespace kadr::machine {

namespace {

struct MachineUnit {
    QuantityKind dimension;
    std::string_view name;
    double factor;  // canonical value of one
};

constexpr double kDegree = rad_from_deg(1);
constexpr double kTurn = 2 * std::numbers::pi;

constexpr std::array kUnits = {
    MachineUnit{QuantityKind::Time, "s", 1},
    MachineUnit{QuantityKind::Time, "ms", 1e-3},
    MachineUnit{QuantityKind::Time, "us", 1e-6},
    MachineUnit{QuantityKind::Length, "mm", 1},
    MachineUnit{QuantityKind::Length, "m", 1e3},
    MachineUnit{QuantityKind::Length, "um", 1e-3},
    MachineUnit{QuantityKind::Length, "in", kMmPerInch},
    MachineUnit{QuantityKind::Angle, "deg", kDegree},
    MachineUnit{QuantityKind::Angle, "rad", 1},
    MachineUnit{QuantityKind::Velocity, "m/min", 1e3 / 60},
    MachineUnit{QuantityKind::Velocity, "mm/min", 1.0 / 60},
    MachineUnit{QuantityKind::Velocity, "mm/s", 1},
    MachineUnit{QuantityKind::Velocity, "m/s", 1e3},
    MachineUnit{QuantityKind::Velocity, "in/min", kMmPerInch / 60},
    MachineUnit{QuantityKind::AngularVelocity, "rpm", kTurn / 60},
    MachineUnit{QuantityKind::AngularVelocity, "deg/s", kDegree},
    MachineUnit{QuantityKind::AngularVelocity, "deg/min", kDegree / 60},
    MachineUnit{QuantityKind::AngularVelocity, "rad/s", 1},
    MachineUnit{QuantityKind::Acceleration, "m/s2", 1e3},
    MachineUnit{QuantityKind::Acceleration, "mm/s2", 1},
    MachineUnit{QuantityKind::AngularAcceleration, "deg/s2", kDegree},
    MachineUnit{QuantityKind::AngularAcceleration, "rad/s2", 1},
    MachineUnit{QuantityKind::Jerk, "m/s3", 1e3},
    MachineUnit{QuantityKind::Jerk, "mm/s3", 1},
    MachineUnit{QuantityKind::AngularJerk, "deg/s3", kDegree},
    MachineUnit{QuantityKind::AngularJerk, "rad/s3", 1},
    MachineUnit{QuantityKind::Force, "N", 1},
    MachineUnit{QuantityKind::Force, "kN", 1e3},
    MachineUnit{QuantityKind::Torque, "Nm", 1},
    MachineUnit{QuantityKind::Inertia, "kg m2", 1},
    MachineUnit{QuantityKind::Inertia, "kg cm2", 1e-4},
    MachineUnit{QuantityKind::Damping, "Nm s", 1},
    MachineUnit{QuantityKind::Current, "A", 1},
    MachineUnit{QuantityKind::TorquePerCurrent, "Nm/A", 1},
    MachineUnit{QuantityKind::Rate, "1/s", 1},
    MachineUnit{QuantityKind::Frequency, "Hz", 1},
    MachineUnit{QuantityKind::Frequency, "kHz", 1e3},
    MachineUnit{QuantityKind::Power, "W", 1},
    MachineUnit{QuantityKind::Power, "kW", 1e3},
    MachineUnit{QuantityKind::Share, "%", 1e-2},
};

const MachineUnit* find_unit(std::string_view name, QuantityKind dimension) {
    for (const MachineUnit& unit : kUnits) {
        if (unit.dimension == dimension && unit.name == name) return &unit;
    }
    return nullptr;
}

/// The factor of the unit that `text` consists of.
Result<double, QuantityError> unit_factor(std::string_view text, QuantityKind dimension) {
    text = trimmed(text);
    if (text.empty()) return QuantityError{QuantityFault::UnitMissing, text};
    const MachineUnit* unit = find_unit(text, dimension);
    if (unit == nullptr) return QuantityError{QuantityFault::UnitUnknown, text};
    return unit->factor;
}

/// `0,5`: a comma where the number goes on.
bool has_decimal_comma(const char* number_end, const char* end) {
    return end - number_end >= 2 && number_end[0] == ',' && number_end[1] >= '0' &&
           number_end[1] <= '9';
}

}  // namespace

Result<double, QuantityError> parse_quantity(std::string_view text, QuantityKind dimension) {
    text = trimmed(text);
    const char* const end = text.data() + text.size();
    const Decimal number = parse_decimal(text.data(), end);
    if (number.end == text.data()) return QuantityError{QuantityFault::NotANumber, text};
    if (has_decimal_comma(number.end, end)) return QuantityError{QuantityFault::DecimalComma, text};
    const auto factor = unit_factor(
        std::string_view(number.end, static_cast<std::size_t>(end - number.end)), dimension);
    if (!factor) return factor.error();
    return number.value * *factor;
}

Result<Range, QuantityError> parse_range(std::string_view text, QuantityKind dimension) {
    text = trimmed(text);
    std::size_t dots = text.find("..");
    if (dots == std::string_view::npos) return QuantityError{QuantityFault::NotANumber, text};
    // The first number ends before the dots, even if it is written `300.`.
    if (text.substr(dots).starts_with("...")) ++dots;
    if (text.substr(dots).starts_with("...")) {
        return QuantityError{QuantityFault::NotANumber, text};
    }
    const std::string_view low = trimmed(text.substr(0, dots));
    const Decimal lower = parse_decimal(low.data(), low.data() + low.size());
    if (has_decimal_comma(lower.end, low.data() + low.size())) {
        return QuantityError{QuantityFault::DecimalComma, low};
    }
    if (low.empty() || lower.end != low.data() + low.size()) {
        return QuantityError{QuantityFault::NotANumber, low.empty() ? text : low};
    }
    const std::string_view rest = trimmed(text.substr(dots + 2));
    const char* const end = rest.data() + rest.size();
    const Decimal upper = parse_decimal(rest.data(), end);
    if (upper.end == rest.data()) {
        return QuantityError{QuantityFault::NotANumber, rest.empty() ? text : rest};
    }
    if (has_decimal_comma(upper.end, end)) return QuantityError{QuantityFault::DecimalComma, rest};
    const auto factor = unit_factor(
        std::string_view(upper.end, static_cast<std::size_t>(end - upper.end)), dimension);
    if (!factor) return factor.error();
    return Range{lower.value * *factor, upper.value * *factor};
}

std::string unit_names(QuantityKind dimension) {
    std::vector<std::string_view> names;
    for (const MachineUnit& unit : kUnits) {
        if (unit.dimension == dimension) names.push_back(unit.name);
    }
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
        text.append("`").append(names[i]).append("`");
    }
    return text;
}

std::string_view dimension_name(QuantityKind dimension) {
    switch (dimension) {
        case QuantityKind::Time: return "a time";
        case QuantityKind::Length: return "a length";
        case QuantityKind::Angle: return "an angle";
        case QuantityKind::Velocity: return "a velocity";
        case QuantityKind::AngularVelocity: return "a speed of rotation";
        case QuantityKind::Acceleration: return "an acceleration";
        case QuantityKind::AngularAcceleration: return "an angular acceleration";
        case QuantityKind::Jerk: return "a jerk";
        case QuantityKind::AngularJerk: return "an angular jerk";
        case QuantityKind::Force: return "a force";
        case QuantityKind::Torque: return "a torque";
        case QuantityKind::Inertia: return "an inertia";
        case QuantityKind::Damping: return "a damping";
        case QuantityKind::Current: return "a current";
        case QuantityKind::TorquePerCurrent: return "a torque constant";
        case QuantityKind::Rate: return "a gain";
        case QuantityKind::Frequency: return "a frequency";
        case QuantityKind::Power: return "a power";
        case QuantityKind::Share: return "a share";
    }
    return "a quantity";
}

}  // namespace kadr::machine
