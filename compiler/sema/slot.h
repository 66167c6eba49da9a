// slot.h — a register of the code, and what it holds.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace kadr::sema {

/// A register, or one piece of an array's element. What it holds is the checker's knowledge.
union Slot {
    std::int64_t integer;
    double number;
};
static_assert(sizeof(Slot) == 8);

enum class SlotKind : std::uint8_t { Integer, Number, Text, Array };

/// "Not given" for whole numbers, truth values and handles. A real number that is not given is a
/// NaN: no calculation of the language yields one.
inline constexpr std::int64_t kNotGivenInteger = std::numeric_limits<std::int64_t>::min();
inline constexpr double kNotGivenNumber = std::numeric_limits<double>::quiet_NaN();

/// A feed or speed can be of two forms: per time or per revolution, of the spindle or of cutting.
/// Which one is known only when the program runs: the second form is stored multiplied by this, a
/// power of two far beyond any real value, so the two are told apart by size and nothing is lost.
inline constexpr double kSecondForm = 0x1p600;
/// Flag beside the form that an instruction asks for: it is one of a speed, not of a feed.
inline constexpr std::uint32_t kSpeedForm = 2;
inline bool is_second_form(double value) { return std::fabs(value) > 0x1p300; }

/// Whether a register that holds such a value (a SlotKind) holds one.
inline bool is_given(Slot slot, unsigned kind) {
    return kind == static_cast<unsigned>(SlotKind::Number) ? slot.number == slot.number
                                                           : slot.integer != kNotGivenInteger;
}

}  // namespace kadr::sema
