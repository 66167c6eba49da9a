// quantity.h — what a number measures: exponents of millimetre, second, degree and revolution.
//
// Values inside the evaluator are coherent in these four, so products and quotients need no
// factors: feed × time is length. Only bare numbers and printing know the units of a file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/numbers.h"
#include "nc/vocabulary.h"
#include "syntax/ast.h"

namespace kadr::sema {

struct Quantity {
    std::int8_t length = 0;  // mm
    std::int8_t time = 0;    // s
    std::int8_t angle = 0;   // degrees
    std::int8_t turns = 0;   // revolutions

    friend bool operator==(const Quantity&, const Quantity&) = default;
    bool is_number() const { return *this == Quantity{}; }
};

inline constexpr Quantity kNumber{};
inline constexpr Quantity kLength{1, 0, 0, 0};
inline constexpr Quantity kAngle{0, 0, 1, 0};
inline constexpr Quantity kTime{0, 1, 0, 0};
inline constexpr Quantity kFeedPerTime{1, -1, 0, 0};
inline constexpr Quantity kFeedPerTurn{1, 0, 0, -1};
inline constexpr Quantity kPerTime{0, -1, 0, 0};
inline constexpr Quantity kSpindleSpeed{0, -1, 0, 1};

Quantity operator*(Quantity a, Quantity b);
Quantity operator/(Quantity a, Quantity b);
Quantity power(Quantity a, int exponent);
/// The root of this degree, 2 or 3; nothing if an exponent is no multiple of it.
std::optional<Quantity> root(Quantity a, int degree);

/// `length`, `feed per revolution`, `area`, `length^2/time`: for messages.
std::string describe(Quantity quantity);

/// Units of a file: what its bare numbers mean, how its values print.
enum class Units : std::uint8_t { Metric, Inch };

/// The unit that values of a quantity print in: `mm`, `in/min`, `mm^2`; empty for numbers.
std::string unit_text(Quantity quantity, Units units);

/// What one bare number of this quantity is worth: `F 200` is 200/60 mm/s, `X 1` in an inch file
/// 25.4 mm.
double bare_factor(Quantity quantity, Units units);

struct UnitInfo {
    Quantity quantity;
    double factor;  // to mm, s, degrees, revolutions
};
UnitInfo unit_info(syntax::Unit unit);

/// Reads the longest number at `begin` of a value from outside of a program: decimal, or with an
/// exponent, `1e5`, `2.5E-3`, as computers write it.
Decimal parse_number(const char* begin, const char* end);

/// Reads a unit as it stands behind a number (`mm`, `mm/min`, `in`); nothing if it is none.
std::optional<UnitInfo> find_unit(std::string_view text);

/// What a parameter of the vocabulary measures. Feed and Speed mean their usual form.
Quantity quantity_of(nc::Dimension dimension);

}  // namespace kadr::sema
