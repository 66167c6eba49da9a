// mode_words.h — words around a value that tell how it is meant: `X=AC(10)`, `C=DC(90)`.
#pragma once

#include <array>
#include <string_view>

#include "nc/match.h"

namespace kadr::nc {

struct ModeWord {
    std::string_view name;
    GivenWord::Mode mode;
    std::string_view meaning;
};

/// Of the dialects whose rules have `modes`.
inline constexpr std::array<ModeWord, 15> kModeWords = {
    {{"AC", GivenWord::Mode::Absolute, "a coordinate, whatever acts"},
     {"IC", GivenWord::Mode::Incremental, "a distance from where the axis is, whatever acts"},
     {"DAC", GivenWord::Mode::DiameterAbsolute, "a coordinate as a diameter"},
     {"DIC", GivenWord::Mode::DiameterIncremental, "a distance as a diameter"},
     {"RAC", GivenWord::Mode::RadiusAbsolute, "a coordinate as a radius"},
     {"RIC", GivenWord::Mode::RadiusIncremental, "a distance as a radius"},
     {"DC", GivenWord::Mode::Shortest, "a position of a rotary axis, by the shorter path"},
     {"ACP", GivenWord::Mode::Positive, "a position of a rotary axis, in the positive direction"},
     {"ACN", GivenWord::Mode::Negative, "a position of a rotary axis, in the negative direction"},
     {"CAC", GivenWord::Mode::Indexed, "the number of a position in a table; not executed"},
     {"CIC", GivenWord::Mode::Indexed, "so many positions of a table on; not executed"},
     {"CDC", GivenWord::Mode::Indexed, "a position in a table, by the shorter path; not executed"},
     {"CACP", GivenWord::Mode::Indexed, "a position in a table, upwards; not executed"},
     {"CACN", GivenWord::Mode::Indexed, "a position in a table, downwards; not executed"},
     // Without an acknowledgement of the machine.
     {"QU", GivenWord::Mode::Modal, "a function that the machine need not acknowledge"}}};

}  // namespace kadr::nc
