// number_text.h — the numbers of words: canonical value ↔ what stands in the text.
//
// Knows units of the text (inch or metric, kind of feed), decimals, the decimal point and what a
// number without one means. The writer checks every number it has written with the reader's rule.
#pragma once

#include <string>

#include "base/numbers.h"
#include "nc/tables.h"

namespace kadr::nc {

/// The modal state that the meaning of a number depends on.
struct TextUnits {
    bool inch = false;            // lengths are inches
    bool inch_feed = false;       // feeds are inches too
    bool per_revolution = false;  // F is per revolution
    bool inverse_time = false;    // F is 1/min
    bool cutting_speed = false;   // S is m/min, or ft/min
};

/// number in the text = canonical value · this. `is_slot`: of the word S itself; a speed that is a
/// parameter (a limit) is rpm always.
double text_scale(Dimension dimension, const TextUnits& units, bool is_slot);

/// A number of the text with its unit, for messages: "0.0001 s", "12.5 mm/rev".
std::string quantity_words(double number, Dimension dimension, const TextUnits& units);

/// Decimals with which the number is written.
inline int text_decimals(const NumberFormat& format, Dimension dimension, const TextUnits& units) {
    const bool is_inch = (dimension == Dimension::Length && units.inch) ||
                         (dimension == Dimension::Feed && units.inch_feed);
    return is_inch ? format.inch_decimals : format.decimals;
}

/// The format for the pitch of a thread.
NumberFormat pitch_format(const NumberFormat& format);
/// … and for a length that changes the frame: additive ones would add up what is rounded.
NumberFormat frame_format(const NumberFormat& format);
/// The format of the numbers in calls and in lines of the control's own language.
NumberFormat argument_format(const DialectTables& tables);
/// What one least increment of the control is, in the text's units; 0.001 mm as a rule.
double increment_size(const DialectTables& tables, Dimension dimension, const TextUnits& units);

/// Whether a number of the text is that of a form's quantity, rounded as the format has it.
bool is_quantity(const FormWord& quantity, double number, const NumberFormat& format,
                 const TextUnits& units);

enum class NumberFault : std::uint8_t { None, NotFinite, TooLarge, NotReadBack, Negative, Point };

/// Writes scaled·10^-decimals without zeros at its end, and past it; 24 bytes are enough. Its
/// digits are those of a whole number, so it reads back as exactly what was rounded to get
/// `scaled`. has_point   a whole number keeps its point: `10.`
char* write_scaled(char* out, std::uint64_t scaled, bool is_minus, int decimals, bool has_point);

/// The greatest number of increments that the format takes.
std::uint64_t most_increments(const NumberFormat& format);

/// Appends `number`, which is in the text's units, and checks that it reads back as it was meant.
NumberFault append_number(std::string& out, double number, const NumberFormat& format,
                          Dimension dimension, const TextUnits& units);

/// What a number that was read means, in the text's units: a missing decimal point may make it a
/// count of increments, and digits beyond the format may be dropped.
double read_meaning(const Decimal& decimal, const NumberFormat& format, Dimension dimension,
                    const TextUnits& units);

/// Whether the control takes the number as it stands.
NumberFault check_read(const Decimal& decimal, bool has_minus, double meaning,
                       const NumberFormat& format, Dimension dimension, const TextUnits& units);

}  // namespace kadr::nc
