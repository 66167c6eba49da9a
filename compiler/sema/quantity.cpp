#include "sema/quantity.h"

#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <string_view>

#include "base/units.h"

namespace kadr::sema {

namespace {

constexpr double kDegPerRad = 180.0 / 3.14159265358979323846;

struct UnitSpelling {
    syntax::Unit unit;
    std::string_view text;
    UnitInfo info;
};

// One row a unit; the lexer knows the same spellings.
constexpr std::array kUnits = {
    UnitSpelling{syntax::Unit::Mm, "mm", {kLength, 1.0}},
    UnitSpelling{syntax::Unit::Cm, "cm", {kLength, 10.0}},
    UnitSpelling{syntax::Unit::M, "m", {kLength, 1000.0}},
    UnitSpelling{syntax::Unit::Um, "um", {kLength, 0.001}},
    UnitSpelling{syntax::Unit::Inch, "in", {kLength, kMmPerInch}},
    UnitSpelling{syntax::Unit::Inch, "inch", {kLength, kMmPerInch}},
    UnitSpelling{syntax::Unit::Deg, "deg", {kAngle, 1.0}},
    UnitSpelling{syntax::Unit::Rad, "rad", {kAngle, kDegPerRad}},
    UnitSpelling{syntax::Unit::S, "s", {kTime, 1.0}},
    UnitSpelling{syntax::Unit::Ms, "ms", {kTime, 0.001}},
    UnitSpelling{syntax::Unit::Min, "min", {kTime, 60.0}},
    UnitSpelling{syntax::Unit::MmPerMin, "mm/min", {kFeedPerTime, 1.0 / 60.0}},
    UnitSpelling{syntax::Unit::MPerMin, "m/min", {kFeedPerTime, 1000.0 / 60.0}},
    UnitSpelling{syntax::Unit::InchPerMin, "in/min", {kFeedPerTime, kMmPerInch / 60.0}},
    UnitSpelling{syntax::Unit::InchPerMin, "inch/min", {kFeedPerTime, kMmPerInch / 60.0}},
    UnitSpelling{syntax::Unit::MmPerS, "mm/s", {kFeedPerTime, 1.0}},
    UnitSpelling{syntax::Unit::MmPerRev, "mm/rev", {kFeedPerTurn, 1.0}},
    UnitSpelling{syntax::Unit::InchPerRev, "in/rev", {kFeedPerTurn, kMmPerInch}},
    UnitSpelling{syntax::Unit::InchPerRev, "inch/rev", {kFeedPerTurn, kMmPerInch}},
    UnitSpelling{syntax::Unit::Rpm, "rpm", {kSpindleSpeed, 1.0 / 60.0}},
    UnitSpelling{syntax::Unit::Percent, "%", {kNumber, 0.01}},
};

std::int8_t narrow(int value) { return static_cast<std::int8_t>(value); }

struct Known {
    Quantity quantity;
    std::string_view name;
};

/// The known name, or the product of the four base names: `length^2/time`.
std::string composed(Quantity q, std::span<const Known> known,
                     const std::array<std::string_view, 4>& base) {
    for (const Known& row : known) {
        if (row.quantity == q) return std::string(row.name);
    }
    std::string above;
    std::string below;
    const auto factor = [&](int exponent, std::string_view name) {
        if (exponent == 0) return;
        std::string& side = exponent > 0 ? above : below;
        if (!side.empty()) side += '*';
        side += name;
        if (std::abs(exponent) == 1) return;
        side += '^';
        side += std::to_string(std::abs(exponent));
    };
    factor(q.length, base[0]);
    factor(q.time, base[1]);
    factor(q.angle, base[2]);
    factor(q.turns, base[3]);
    if (above.empty()) above += '1';
    if (!below.empty()) {
        above += '/';
        above += below;
    }
    return above;
}

}  // namespace

Quantity operator*(Quantity a, Quantity b) {
    return {narrow(a.length + b.length), narrow(a.time + b.time), narrow(a.angle + b.angle),
            narrow(a.turns + b.turns)};
}

Quantity operator/(Quantity a, Quantity b) {
    return {narrow(a.length - b.length), narrow(a.time - b.time), narrow(a.angle - b.angle),
            narrow(a.turns - b.turns)};
}

Quantity power(Quantity a, int exponent) {
    return {narrow(a.length * exponent), narrow(a.time * exponent), narrow(a.angle * exponent),
            narrow(a.turns * exponent)};
}

std::optional<Quantity> root(Quantity a, int degree) {
    if (a.length % degree != 0 || a.time % degree != 0 || a.angle % degree != 0 ||
        a.turns % degree != 0) {
        return std::nullopt;
    }
    return Quantity{narrow(a.length / degree), narrow(a.time / degree), narrow(a.angle / degree),
                    narrow(a.turns / degree)};
}

std::string describe(Quantity q) {
    constexpr std::array kKnown = {
        Known{kNumber, "number"},
        Known{kLength, "length"},
        Known{kAngle, "angle"},
        Known{kTime, "time"},
        Known{kFeedPerTime, "feed (length per time)"},
        Known{kFeedPerTurn, "feed per revolution"},
        Known{kSpindleSpeed, "speed"},
        Known{kPerTime, "number per time"},
        Known{{2, 0, 0, 0}, "area"},
        Known{{3, 0, 0, 0}, "volume"},
        Known{{0, 0, 0, 1}, "revolutions"},
        Known{{1, -2, 0, 0}, "acceleration"},
        Known{{0, -1, 1, 0}, "angle per time"},
    };
    return composed(q, kKnown, {"length", "time", "angle", "revolutions"});
}

std::string unit_text(Quantity q, Units units) {
    constexpr std::array kMetric = {
        Known{kNumber, ""},
        Known{kFeedPerTime, "mm/min"},
        Known{kSpindleSpeed, "rpm"},
        Known{kPerTime, "1/min"},
    };
    constexpr std::array kInch = {
        Known{kNumber, ""},
        Known{kFeedPerTime, "in/min"},
        Known{kSpindleSpeed, "rpm"},
        Known{kPerTime, "1/min"},
    };
    if (units == Units::Inch) return composed(q, kInch, {"in", "s", "deg", "rev"});
    return composed(q, kMetric, {"mm", "s", "deg", "rev"});
}

double bare_factor(Quantity q, Units units) {
    double factor = units == Units::Inch ? std::pow(kMmPerInch, q.length) : 1.0;
    // F is per minute, S is rpm: nobody writes them per second.
    if (q == kFeedPerTime || q == kSpindleSpeed || q == kPerTime) factor /= 60.0;
    return factor;
}

UnitInfo unit_info(syntax::Unit unit) {
    for (const UnitSpelling& row : kUnits) {
        if (row.unit == unit) return row.info;
    }
    return {kNumber, 1.0};
}

std::optional<UnitInfo> find_unit(std::string_view text) {
    for (const UnitSpelling& row : kUnits) {
        if (row.text == text) return row.info;
    }
    return std::nullopt;
}

Quantity quantity_of(nc::Dimension dimension) {
    switch (dimension) {
        case nc::Dimension::Length: return kLength;
        case nc::Dimension::Angle: return kAngle;
        case nc::Dimension::Time: return kTime;
        case nc::Dimension::Feed: return kFeedPerTime;
        case nc::Dimension::Speed: return kSpindleSpeed;
        case nc::Dimension::Number:
        case nc::Dimension::Count:
        case nc::Dimension::Factor:
        case nc::Dimension::Text: return kNumber;
    }
    return kNumber;
}

Decimal parse_number(const char* begin, const char* end) {
    Decimal number = parse_decimal(begin, end);
    const char* at = number.end;
    if (at == begin || at == end || (*at != 'e' && *at != 'E')) return number;
    ++at;
    if (at != end && (*at == '+' || *at == '-')) ++at;
    if (at == end || *at < '0' || *at > '9') return number;
    const char* const first = *begin == '+' ? begin + 1 : begin;
    double value = 0;
    const auto read = std::from_chars(first, end, value);
    if (read.ec != std::errc() || !std::isfinite(value)) return number;
    number.value = value;
    number.end = read.ptr;
    return number;
}

}  // namespace kadr::sema
