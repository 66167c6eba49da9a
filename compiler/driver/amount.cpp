#include "driver/amount.h"

#include <algorithm>

#include "base/numbers.h"

namespace kadr::driver {

std::optional<Amount> amount_of(std::string_view text) {
    const Decimal number = parse_decimal(text.data(), text.data() + text.size());
    if (number.end == text.data()) return std::nullopt;
    std::string_view unit = text.substr(static_cast<std::size_t>(number.end - text.data()));
    unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
    return Amount{number.value, unit.substr(0, unit.find_last_not_of(' ') + 1)};
}

std::optional<double> seconds_of(std::string_view text) {
    const auto amount = amount_of(text);
    if (!amount || amount->value <= 0) return std::nullopt;
    if (amount->unit == "s") return amount->value;
    if (amount->unit == "ms") return amount->value * 1e-3;
    if (amount->unit == "us") return amount->value * 1e-6;
    if (amount->unit == "min") return amount->value * 60;
    return std::nullopt;
}

}  // namespace kadr::driver
