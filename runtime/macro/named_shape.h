// named_shape.h — what kind of cycle it is: one whose call names the program in which its shape
// stands, one that names a contour for later, or a pattern of positions.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "nc/dialect.h"

namespace kadr::macro {

inline bool names_shape(const nc::CycleInfo& cycle) {
    return std::ranges::any_of(cycle.parameters, [](const nc::Parameter& parameter) {
        return parameter.dimension == nc::Dimension::Text && parameter.name == "shape";
    });
}

/// A cycle that machines nothing but names the contour for those behind it that name none
/// (CYCLE62).
inline bool names_contour(const nc::CycleInfo& cycle) {
    return std::ranges::any_of(cycle.parameters, [](const nc::Parameter& parameter) {
        return parameter.dimension == nc::Dimension::Text && parameter.name == "contour";
    });
}

/// Where such a contour stands, `kind` of its call.
enum class ContourSource : std::uint8_t {
    Program = 0,        // the text is its name
    Named = 1,          // between the labels that editors put around a contour of this name
    Labels = 2,         // the text is the two labels, in the program that runs
    ProgramLabels = 3,  // … behind the name of a program, in that
};

/// What editors of contours write in front of its name, as labels around it.
inline constexpr std::string_view kContourBegin = "E_LAB_A_";
inline constexpr std::string_view kContourEnd = "E_LAB_E_";

/// A cycle that has it is a pattern of positions: whether something is called at each.
inline constexpr std::string_view kPatternParameter = "calls";

inline bool goes_to_positions(const nc::CycleInfo& cycle) {
    return std::ranges::any_of(cycle.parameters, [](const nc::Parameter& parameter) {
        return parameter.name == kPatternParameter;
    });
}

}  // namespace kadr::macro
