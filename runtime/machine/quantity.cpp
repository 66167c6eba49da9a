#include "machine/quantity.h"

#include <array>
#include <numbers>
#include <vector>

#include "base/numbers.h"
#include "base/units.h"
#include "machine/number_list.h"

namespace kadr::machine {

namespace {

struct Unit {
    Dimension dimension;
    std::string_view name;
    double factor;  // canonical value of one
};

constexpr double kDegree = rad_from_deg(1);
constexpr double kTurn = 2 * std::numbers::pi;

constexpr std::array kUnits = {
    Unit{Dimension::Time, "s", 1},
    Unit{Dimension::Time, "ms", 1e-3},
    Unit{Dimension::Time, "us", 1e-6},
    Unit{Dimension::Length, "mm", 1},
    Unit{Dimension::Length, "m", 1e3},
    Unit{Dimension::Length, "um", 1e-3},
    Unit{Dimension::Length, "in", kMmPerInch},
    Unit{Dimension::Angle, "deg", kDegree},
    Unit{Dimension::Angle, "rad", 1},
    Unit{Dimension::Velocity, "m/min", 1e3 / 60},
    Unit{Dimension::Velocity, "mm/min", 1.0 / 60},
    Unit{Dimension::Velocity, "mm/s", 1},
    Unit{Dimension::Velocity, "m/s", 1e3},
    Unit{Dimension::Velocity, "in/min", kMmPerInch / 60},
    Unit{Dimension::AngularVelocity, "rpm", kTurn / 60},
    Unit{Dimension::AngularVelocity, "deg/s", kDegree},
    Unit{Dimension::AngularVelocity, "deg/min", kDegree / 60},
    Unit{Dimension::AngularVelocity, "rad/s", 1},
    Unit{Dimension::Acceleration, "m/s2", 1e3},
    Unit{Dimension::Acceleration, "mm/s2", 1},
    Unit{Dimension::AngularAcceleration, "deg/s2", kDegree},
    Unit{Dimension::AngularAcceleration, "rad/s2", 1},
    Unit{Dimension::Jerk, "m/s3", 1e3},
    Unit{Dimension::Jerk, "mm/s3", 1},
    Unit{Dimension::AngularJerk, "deg/s3", kDegree},
    Unit{Dimension::AngularJerk, "rad/s3", 1},
    Unit{Dimension::Force, "N", 1},
    Unit{Dimension::Force, "kN", 1e3},
    Unit{Dimension::Torque, "Nm", 1},
    Unit{Dimension::Inertia, "kg m2", 1},
    Unit{Dimension::Inertia, "kg cm2", 1e-4},
    Unit{Dimension::Damping, "Nm s", 1},
    Unit{Dimension::Current, "A", 1},
    Unit{Dimension::TorquePerCurrent, "Nm/A", 1},
    Unit{Dimension::Rate, "1/s", 1},
    Unit{Dimension::Frequency, "Hz", 1},
    Unit{Dimension::Frequency, "kHz", 1e3},
    Unit{Dimension::Power, "W", 1},
    Unit{Dimension::Power, "kW", 1e3},
    Unit{Dimension::Share, "%", 1e-2},
};

const Unit* find_unit(std::string_view name, Dimension dimension) {
    for (const Unit& unit : kUnits) {
        if (unit.dimension == dimension && unit.name == name) return &unit;
    }
    return nullptr;
}

/// The factor of the unit that `text` consists of.
Result<double, QuantityError> unit_factor(std::string_view text, Dimension dimension) {
    text = trimmed(text);
    if (text.empty()) return QuantityError{QuantityFault::UnitMissing, text};
    const Unit* unit = find_unit(text, dimension);
    if (unit == nullptr) return QuantityError{QuantityFault::UnitUnknown, text};
    return unit->factor;
}

/// `0,5`: a comma where the number goes on.
bool has_decimal_comma(const char* number_end, const char* end) {
    return end - number_end >= 2 && number_end[0] == ',' && number_end[1] >= '0' &&
           number_end[1] <= '9';
}

}  // namespace

Result<double, QuantityError> parse_quantity(std::string_view text, Dimension dimension) {
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

Result<Range, QuantityError> parse_range(std::string_view text, Dimension dimension) {
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

std::string unit_names(Dimension dimension) {
    std::vector<std::string_view> names;
    for (const Unit& unit : kUnits) {
        if (unit.dimension == dimension) names.push_back(unit.name);
    }
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
        text.append("`").append(names[i]).append("`");
    }
    return text;
}

std::string_view dimension_name(Dimension dimension) {
    switch (dimension) {
        case Dimension::Time: return "a time";
        case Dimension::Length: return "a length";
        case Dimension::Angle: return "an angle";
        case Dimension::Velocity: return "a velocity";
        case Dimension::AngularVelocity: return "a speed of rotation";
        case Dimension::Acceleration: return "an acceleration";
        case Dimension::AngularAcceleration: return "an angular acceleration";
        case Dimension::Jerk: return "a jerk";
        case Dimension::AngularJerk: return "an angular jerk";
        case Dimension::Force: return "a force";
        case Dimension::Torque: return "a torque";
        case Dimension::Inertia: return "an inertia";
        case Dimension::Damping: return "a damping";
        case Dimension::Current: return "a current";
        case Dimension::TorquePerCurrent: return "a torque constant";
        case Dimension::Rate: return "a gain";
        case Dimension::Frequency: return "a frequency";
        case Dimension::Power: return "a power";
        case Dimension::Share: return "a share";
    }
    return "a quantity";
}

}  // namespace kadr::machine
