// named_shape.h — what kind of cycle it is: one whose call names the program in which its shape
// stands, one that names a contour for later, or a pattern of positions.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

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

/// The contour that a call names: parts of a text, and which they are.
struct NamedContour {
    std::vector<std::string> parts;
    ContourSource kind = ContourSource::Program;
};
/// What stands between colons: `"BEGIN:END"`.
std::vector<std::string> parts_of_contour(std::string_view text);
/// The contour that the call of a cycle in this block names. Its text is empty: it names none.
NamedContour contour_named_by(const nc::Block& block, const nc::CycleInfo& cycle);
/// The two labels around it, of one that editors name; of any other it stays as it is.
NamedContour with_labels(NamedContour contour);

/// A cycle that has it is a pattern of positions: whether something is called at each.
inline constexpr std::string_view kPatternParameter = "calls";

inline bool goes_to_positions(const nc::CycleInfo& cycle) {
    return std::ranges::any_of(cycle.parameters, [](const nc::Parameter& parameter) {
        return parameter.name == kPatternParameter;
    });
}

}  // namespace kadr::macro
