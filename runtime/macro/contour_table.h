// contour_table.h — contours as tables of numbers, which programs for stock removal read.
//
// Elements of a contour → rows of a table; a row → its element; where two rows meet. Plain geometry
// in the working plane: no blocks, no variables, no axes. Coordinates are abscissa and ordinate in
// whatever unit the caller has.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "path/contour.h"

namespace kadr::macro {

/// What acted in the block of an element, as tables give it by digits. Each is the index of the
/// code in the list of its group, from 0.
struct ContourModes {
    bool is_incremental = false;
    bool is_metric = true;
    int units = 1;      // G70, G71, G700, G710
    int feed_mode = 1;  // G93, G94, G95, G96
    int path_mode = 0;  // G60, G64, G641, G642
    bool stops_once = false;

    friend bool operator==(const ContourModes&, const ContourModes&) = default;
};

struct ContourElement {
    path::Element shape;
    bool is_rapid = false;
    ContourModes modes;
    double feed = 0;  // in the unit of its mode; 0: none was programmed
};

/// What the control has of a contour that was read: mm, degrees; the units of its modes are those
/// of the text, and the program's to give.
using ContourElements = std::vector<ContourElement>;

/// How the material in front of a contour is to be taken away: it defines what an undercut is.
struct ContourCut {
    bool is_face = false;    // the infeed goes along the abscissa, else along the ordinate …
    bool is_inside = false;  // … in the positive direction, else in the negative one
    bool both_ways = false;  // the table has the contour backwards, too
};

enum class ContourFault : std::uint8_t {
    TooFew,         // elements
    FullCircle,     // an element is one, or more
    TableTooSmall,  // it has too few rows
};

inline constexpr std::size_t kContourColumns = 11;
using ContourRow = std::array<double, kContourColumns>;
inline constexpr std::size_t kCodedColumns = 6;
using CodedRow = std::array<double, kCodedColumns>;

/// A row with its index in the table.
template <typename Row>
struct RowAtNumber {
    std::size_t index = 0;
    Row cells{};
};

struct PreparedContour {
    std::vector<RowAtNumber<ContourRow>> rows;  // those that the contour fills, others stay
    int undercuts = 0;                          // forwards
};

/// The chained table of a contour. Row 0 is the path to its first point. Each element has the row
/// of its number, and what elements are divided into besides (arcs where they are highest or
/// lowest, elements that rise past the level at which an undercut has begun) the rows behind; a
/// contour that ends below such a level is closed by elements that rise to it. Backwards the same
/// stands from the last row on.
///
/// elements  the path to the first point, which may have no length, then the contour; each begins
///           where the one before ends
/// rows      of the table
/// source    S 8.4 CONTPRON: columns, both example tables. Which rows are marked in column 7, and
///           where elements are divided, is what those tables have in common (unsure elsewhere).
Result<PreparedContour, ContourFault> prepared_contour(std::span<const ContourElement> elements,
                                                       const ContourCut& cut, std::size_t rows);

/// The coded table of a contour, element by element as it was programmed: row 0 the point where it
/// begins.
///
/// source  S 8.4 CONTDCON: columns and example table
Result<std::vector<RowAtNumber<CodedRow>>, ContourFault> coded_contour(
    std::span<const ContourElement> elements, std::size_t rows);

/// What a row of a chained table gives; nothing: its code is none, or its arc has no radius.
std::optional<ContourElement> element_of(const ContourRow& row);

/// The point that two elements have in common; of several the first one on the path along `a`.
std::optional<path::Vec2> common_point(const ContourElement& a, const ContourElement& b);

}  // namespace kadr::macro
