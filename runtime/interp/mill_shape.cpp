#include "interp/mill_shape.h"

#include <array>
#include <numbers>

#include "base/units.h"

namespace kadr::interp {

namespace {

enum class End : std::uint8_t { Ball, Sharp, Rounded };

struct Shape {
    int type;
    End end;
    bool tapers;
};

constexpr std::array kShapes = {
    Shape{110, End::Ball, false},    Shape{111, End::Ball, true},   Shape{120, End::Sharp, false},
    Shape{121, End::Rounded, false}, Shape{130, End::Sharp, false}, Shape{131, End::Rounded, false},
    Shape{140, End::Sharp, false},   Shape{155, End::Sharp, true},  Shape{156, End::Rounded, true},
    Shape{157, End::Ball, true},
};

// Numbers of the data among $TC_DP.
constexpr std::int64_t kEdge = 7;
constexpr std::int64_t kEdgeWear = 16;
constexpr std::int64_t kFlank = 11;
constexpr std::int64_t kFlankWear = 20;

}  // namespace

Result<MillShape, MillShapeFault> mill_shape(const ToolOffsets& offsets, std::int64_t number,
                                             double extra) {
    Shape shape{0, End::Ball, false};
    for (const Shape& row : kShapes)
        if (row.type == offsets.type(number)) shape = row;
    MillShape cutter;
    cutter.is_known = shape.type != 0;
    cutter.radius = offsets.radius(number) + extra;
    if (shape.end == End::Ball) cutter.edge = cutter.radius;
    if (shape.end == End::Rounded)
        cutter.edge = offsets.datum(number, kEdge) + offsets.datum(number, kEdgeWear);
    if (shape.tapers)
        cutter.flank =
            rad_from_deg(offsets.datum(number, kFlank) + offsets.datum(number, kFlankWear));
    if (cutter.edge < 0 || cutter.edge > cutter.radius) return MillShapeFault::EdgeTooLarge;
    if (!(cutter.flank >= 0 && cutter.flank < std::numbers::pi / 2))
        return MillShapeFault::FlankTooLarge;
    return cutter;
}

}  // namespace kadr::interp
