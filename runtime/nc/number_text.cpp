#include "nc/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/powers.h"
#include "base/readable.h"
#include "base/units.h"

namespace kadr::nc {

namespace {

constexpr double kMetersPerFoot = 0.3048;  // exact by definition

/// What 1 without a decimal point means; 0: one.
double increment_of(const NumberFormat& format, Dimension dimension, const TextUnits& units) {
    if (dimension == Dimension::Length && units.inch) return format.inch_increment;
    if (dimension == Dimension::Feed) {
        if (units.inverse_time) return 0;
        const bool is_inch = units.inch_feed && format.increment > 0 && format.inch_increment > 0;
        const double increment = is_inch ? format.inch_increment : format.increment;
        if (!units.per_revolution || format.revolution_increment == 0) return increment;
        // In inches it is smaller in the ratio in which a feed per minute is.
        return is_inch ? format.revolution_increment * increment / format.increment
                       : format.revolution_increment;
    }
    return dimension == Dimension::Factor ? 0 : format.increment;
}

/// Decimals that the control takes. F is the pitch of a thread under feed per revolution, if what
/// it belongs to is one (`G84 F1.5875`); the word by itself does not tell.
int read_decimals(const NumberFormat& format, Dimension dimension, const TextUnits& units) {
    const int decimals = text_decimals(format, dimension, units);
    if (dimension != Dimension::Feed || !units.per_revolution) return decimals;
    return std::max(decimals, text_decimals(pitch_format(format), dimension, units));
}

/// Whether the value in increments of its last decimal has more digits than the control takes.
bool has_too_many_digits(double number, const NumberFormat& format, int decimals) {
    if (format.max_digits == 0) return false;
    const int whole_digits = format.max_digits - decimals;
    return std::fabs(number) >=
           (whole_digits > 9 ? 1e10 : power_of_ten(whole_digits < 0 ? 0 : whole_digits));
}

/// `value`, which has `written` decimals, without those behind the first `kept`.
double truncated(double value, int written, int kept) {
    constexpr int kExactDecimals = 15;
    if (written > kExactDecimals || std::fabs(value) >= 1e15)
        return value;  // more digits than any control takes
    auto digits =
        static_cast<std::int64_t>(std::llround(std::fabs(value) * std::pow(10.0, written)));
    for (int i = kept; i < written; ++i) digits /= 10;
    const double cut = static_cast<double>(digits) / power_of_ten(kept);
    return value < 0 ? -cut : cut;
}

}  // namespace

NumberFormat pitch_format(const NumberFormat& format) {
    NumberFormat pitch = format;
    if (format.lead_decimals >= 0) pitch.decimals = format.lead_decimals;
    if (format.inch_lead_decimals >= 0) pitch.inch_decimals = format.inch_lead_decimals;
    return pitch;
}

NumberFormat frame_format(const NumberFormat& format) {
    NumberFormat frame = format;
    if (format.frame_decimals >= 0) frame.decimals = frame.inch_decimals = format.frame_decimals;
    return frame;
}

NumberFormat argument_format(const DialectTables& tables) {
    const AddressId address = tables.find_address("()");
    return address == kNoAddress ? NumberFormat{} : tables.addresses[address].format;
}

bool is_quantity(const FormWord& quantity, double number, const NumberFormat& format,
                 const TextUnits& units) {
    const double exact = quantity.number * text_scale(quantity.dimension, units, false);
    const double last = 1 / power_of_ten(text_decimals(format, quantity.dimension, units));
    return std::fabs(number - exact) < 0.51 * last;
}

double text_scale(Dimension dimension, const TextUnits& units, bool is_slot) {
    switch (dimension) {
        case Dimension::Length: return units.inch ? 1 / kMmPerInch : 1;
        case Dimension::Feed: return units.inch_feed && !units.inverse_time ? 1 / kMmPerInch : 1;
        case Dimension::Speed:
            return is_slot && units.cutting_speed && units.inch_feed ? 1 / kMetersPerFoot : 1;
        case Dimension::Number:
        case Dimension::Count:
        case Dimension::Angle:
        case Dimension::Time:
        case Dimension::Factor:
        case Dimension::Text: return 1;
    }
    return 1;
}

std::string quantity_words(double number, Dimension dimension, const TextUnits& units) {
    std::string unit;
    switch (dimension) {
        case Dimension::Length: unit = units.inch ? " in" : " mm"; break;
        case Dimension::Angle: unit = " deg"; break;
        case Dimension::Time: unit = " s"; break;
        case Dimension::Feed:
            if (units.inverse_time) unit = " 1/min";
            else
                unit = (units.inch_feed ? " in" : " mm") +
                       std::string(units.per_revolution ? "/rev" : "/min");
            break;
        case Dimension::Speed:
            // The speed of a cut, or a limit of revolutions: the message names the word.
            if (!units.cutting_speed) unit = " rpm";
            break;
        case Dimension::Number:
        case Dimension::Count:
        case Dimension::Factor:
        case Dimension::Text: break;
    }
    return readable(number) + unit;
}

double increment_size(const DialectTables& tables, Dimension dimension, const TextUnits& units) {
    const AddressId x = tables.slot_address[static_cast<std::size_t>(Slot::X)];
    const NumberFormat format = x == kNoAddress ? NumberFormat{} : tables.addresses[x].format;
    return 1 / power_of_ten(text_decimals(format, dimension, units));
}

char* write_scaled(char* out, std::uint64_t scaled, bool is_minus, int decimals, bool has_point) {
    if (is_minus) *out++ = '-';
    std::array<char, 32> digits;
    char* const end = digits.data() + digits.size();
    char* begin = write_digits_backwards(end, scaled);
    while (end - begin <= decimals) *--begin = '0';
    const char* const point = end - decimals;
    const char* last = end;
    while (last != point && last[-1] == '0') --last;
    while (begin != point) *out++ = *begin++;
    if (last != point || has_point) *out++ = '.';
    while (begin != last) *out++ = *begin++;
    return out;
}

std::uint64_t most_increments(const NumberFormat& format) {
    static constexpr auto kPowers = [] {
        std::array<std::uint64_t, 19> powers{1};
        for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = powers[i - 1] * 10;
        return powers;
    }();
    const auto digits = static_cast<std::size_t>(format.max_digits);
    const bool has_limit = digits != 0 && digits < kPowers.size();
    return has_limit ? kPowers[digits] - 1 : std::numeric_limits<std::uint64_t>::max();
}

namespace {

/// A coordinate of half an increment is 0; a feed, a speed or a wait of 0 is none any more.
bool is_lost_at_zero(Dimension dimension) {
    return dimension == Dimension::Time || dimension == Dimension::Feed ||
           dimension == Dimension::Speed;
}

/// The usual number: its rounding is certain, the control takes it, and what stands there is what
/// it means. False: it needs a second look, and nothing was written.
bool append_plain(std::string& out, double number, const NumberFormat& format, Dimension dimension,
                  const TextUnits& units) {
    const bool has_point = format.point == PointRule::Always;
    if (format.digits > 1 || (!has_point && increment_of(format, dimension, units) > 0))
        return false;
    const int decimals = text_decimals(format, dimension, units);
    if (format.point == PointRule::Never && decimals != 0) return false;
    std::uint64_t scaled = 0;
    if (!scaled_magnitude(number, decimals, scaled) || scaled > most_increments(format))
        return false;
    if (scaled == 0 && number != 0 && is_lost_at_zero(dimension)) return false;
    const bool is_minus = number < 0 && scaled != 0;
    if (is_minus && !format.allows_minus) return false;
    if (dimension == Dimension::Count && number != std::nearbyint(number)) return false;
    if (format.writes_plus && !is_minus) out += '+';
    std::array<char, 32> text;
    out.append(text.data(), write_scaled(text.data(), scaled, is_minus, decimals, has_point));
    return true;
}

}  // namespace

NumberFault append_number(std::string& out, double number, const NumberFormat& format,
                          Dimension dimension, const TextUnits& units) {
    if (append_plain(out, number, format, dimension, units)) return NumberFault::None;
    if (!std::isfinite(number)) return NumberFault::NotFinite;
    if (dimension == Dimension::Count && number != std::nearbyint(number))
        return NumberFault::NotReadBack;
    const int decimals = text_decimals(format, dimension, units);
    std::array<char, kMaxFixedLength> text;
    char* end = format_fixed(text.data(), number, decimals);
    if (decimals > 0) {
        while (end[-1] == '0') --end;
        if (end[-1] == '.' && format.point != PointRule::Always) --end;
    } else if (format.point == PointRule::Always) {
        *end++ = '.';
    }
    const char* const begin = text.data();
    if (format.digits > 1 && format.point == PointRule::Never) {
        for (std::ptrdiff_t missing = format.digits - (end - begin); missing > 0; --missing)
            out += '0';
    }
    if (format.writes_plus && *begin != '-') out += '+';
    out.append(text.data(), end);
    const Decimal decimal = parse_decimal(begin, end);
    const double meaning = read_meaning(decimal, format, dimension, units);
    if (decimal.value == 0 && number != 0 && is_lost_at_zero(dimension))
        return NumberFault::NotReadBack;
    const double half_increment = 0.5 / power_of_ten(decimals);
    // One part in 10^12 for the last bits of the product that made the number.
    if (!(std::fabs(meaning - number) <= half_increment + std::fabs(number) * 1e-12)) {
        return NumberFault::NotReadBack;
    }
    return check_read(decimal, *begin == '-', meaning, format, dimension, units);
}

double read_meaning(const Decimal& decimal, const NumberFormat& format, Dimension dimension,
                    const TextUnits& units) {
    double value = decimal.value;
    if (dimension == Dimension::Count) return value;
    if (!decimal.has_point) {
        const double increment = increment_of(format, dimension, units);
        if (increment > 0) value *= increment;
        // The product of two decimal numbers is a decimal number; take the double nearest to it.
        return increment > 0 ? round_to(value, 9) : value;
    }
    if (!format.truncates) return value;
    const int decimals = read_decimals(format, dimension, units);
    if (decimal.decimals <= decimals) return value;
    return truncated(value, decimal.decimals, decimals);
}

NumberFault check_read(const Decimal& decimal, bool has_minus, double meaning,
                       const NumberFormat& format, Dimension dimension, const TextUnits& units) {
    if (decimal.has_point && format.point == PointRule::Never) return NumberFault::Point;
    if (has_minus && !format.allows_minus) return NumberFault::Negative;
    if (!std::isfinite(meaning)) return NumberFault::TooLarge;
    if (format.max_digits != 0 && decimal.digits > format.max_digits) return NumberFault::TooLarge;
    const int decimals = text_decimals(format, dimension, units);
    return has_too_many_digits(meaning, format, decimals) ? NumberFault::TooLarge
                                                          : NumberFault::None;
}

}  // namespace kadr::nc
