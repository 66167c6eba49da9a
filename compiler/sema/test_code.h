// test_code.h — what tests and properties leave in the code: figures, calls that are executed,
// expectations, ranges.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sema/slot.h"

namespace kadr::sema {

/// What a test asks about an execution.
enum class Figure : std::uint8_t {
#define KADR_FIGURE(name, word, result, parameters, meaning) name,
#include "sema/figures.def"
#undef KADR_FIGURE
};
enum class FigureResult : std::uint8_t {
    Count,
    Length,
    Time,
    Truth,
    Text,
    Point,
    Counts,
    Lengths,
};
struct FigureInfo {
    Figure figure;
    std::string_view name;
    FigureResult result;
    std::string_view parameters;  // as in figures.def; empty: it is not a function
    std::string_view meaning;
};
std::span<const FigureInfo> all_figures();

/// A call that a test has executed instead of evaluating it. In the registers from `a` of its
/// instruction stand the options, then the arguments.
struct TestCall {
    enum class Purpose : std::uint8_t { Execute, Attempt, Text, ExpectError };
    Purpose purpose = Purpose::Execute;
    std::uint32_t function = 0;
    std::uint32_t given = 0;             // bit i: argument i was given
    std::vector<std::uint32_t> layouts;  // of the parameters
};
/// Registers in front of the arguments: where a cycle begins (a point), feed, speed, and the text
/// that the purpose needs: the dialect, or the code of the error. What is not given is the default.
inline constexpr std::uint32_t kTestOptions = 6;

/// Why an expectation failed, as far as the instruction knows.
enum class Expectation : std::uint8_t { Compared, Untrue, UntrueOfText };
/// Flag beside an Expectation: a figure that is a function was asked, its reason is worth a note.
inline constexpr std::uint32_t kHasReason = 8;

/// Lengths, angles and times in a test are equal up to here, in mm, degrees, seconds: half of a
/// thousandth is what the last digit of the text rounds, the rest is for the last binary digit.
inline constexpr double kExpectTolerance = 0.0005 + 1e-9;

/// The values that a parameter of a property takes.
struct PropertyRange {
    Slot from{};  // as in a register
    Slot to{};
    double factor = 1;  // of the unit that the value is shown in
    std::string unit;
};

}  // namespace kadr::sema
