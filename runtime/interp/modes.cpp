// modes.cpp — which functions of the vocabulary choose what.
#include "interp/modes.h"

#include <algorithm>
#include <array>

#include "base/assert.h"

namespace kadr::interp {

using nc::Function;

namespace {

// One row for each enumerator, in their order.
constexpr std::array kCompSides = {Function::RadiusCompOff, Function::RadiusCompLeft,
                                   Function::RadiusCompRight};
constexpr std::array kCompSystems = {Function::CompInPlane, Function::CompPeripheral,
                                     Function::CompFaceMilling, Function::CompFaceMillingInFrame,
                                     Function::CompFaceMillingInPlane};
constexpr std::array kOrientInterpolations = {
    Function::OrientGreatCircle,    Function::OrientAxes,       Function::OrientSurface,
    Function::OrientConeCw,         Function::OrientConeCcw,    Function::OrientConeThrough,
    Function::OrientConeTangential, Function::OrientSecondPoint};
constexpr std::array kToolAngles = {Function::AnglesEuler, Function::AnglesZyz, Function::AnglesRpy,
                                    Function::AnglesXyz};
constexpr std::array kSpins = {Function::SpinFixed, Function::SpinPlane, Function::SpinTurn,
                               Function::SpinPath};
constexpr std::array kPointToPoint = {Function::PathMoves, Function::PointRapids,
                                      Function::PointMoves};

constexpr std::array kFeedModes = {Function::FeedPerMinute, Function::FeedPerRevolution,
                                   Function::FeedInverseTime};
constexpr std::array kPlanes = {Function::PlaneXy, Function::PlaneZx, Function::PlaneYz};
constexpr std::array kCompCorners = {Function::CompCornerArc, Function::CompCornerIntersection};

template <typename Mode>
Mode mode_of(const auto& rows, Function function) {
    const auto row = std::ranges::find(rows, function);
    KADR_ASSERT(row != rows.end(), "a function of another group");
    return static_cast<Mode>(row - rows.begin());
}

}  // namespace

/// The side of a cutter that is compensated square to the tool is the same choice.
CompSide comp_side_of(Function function) {
    if (function == Function::PeripheralCompLeft) return CompSide::Left;
    if (function == Function::PeripheralCompRight) return CompSide::Right;
    return mode_of<CompSide>(kCompSides, function);
}

Function function_of(CompSide side) { return kCompSides.at(static_cast<std::size_t>(side)); }

CompKind comp_system_of(Function function) {
    if (function == Function::CompInFrame) return CompKind::InPlane;
    return mode_of<CompKind>(kCompSystems, function);
}

bool is_face_milling(CompKind system) {
    return nc::has_fact(kCompSystems.at(static_cast<std::size_t>(system)),
                        nc::Fact::ForFaceMilling);
}

OrientInterpolation orient_interpolation_of(Function function) {
    return mode_of<OrientInterpolation>(kOrientInterpolations, function);
}

Function function_of(OrientInterpolation interpolation) {
    return kOrientInterpolations.at(static_cast<std::size_t>(interpolation));
}

bool is_on_cone(OrientInterpolation interpolation) {
    return nc::has_fact(function_of(interpolation), nc::Fact::ConeOrientation);
}

ToolAngles tool_angles_of(Function function) { return mode_of<ToolAngles>(kToolAngles, function); }

SpinFrom spin_from_of(Function function) { return mode_of<SpinFrom>(kSpins, function); }

Function function_of(SpinFrom from) { return kSpins.at(static_cast<std::size_t>(from)); }

PointToPoint point_to_point_of(Function function) {
    return mode_of<PointToPoint>(kPointToPoint, function);
}

/// The other members of the group round no corner.
Blend blend_of(Function function) {
    if (function == Function::BlendDistance) return Blend::Distance;
    if (function == Function::BlendTolerance) return Blend::Tolerance;
    return function == Function::BlendSmooth ? Blend::Smooth : Blend::None;
}

path::FeedMode feed_mode_of(Function function) {
    return mode_of<path::FeedMode>(kFeedModes, function);
}

path::Plane plane_of(Function function) { return mode_of<path::Plane>(kPlanes, function); }

/// No function means nc::CompStart::Extended: that is a rule of controls.
nc::CompStart comp_start_of(Function function) {
    if (function == Function::CompStartAround) return nc::CompStart::Around;
    if (function == Function::CompStartTangent) return nc::CompStart::Tangent;
    return function == Function::CompStartSmooth ? nc::CompStart::Smooth : nc::CompStart::Normal;
}

nc::CompCorner comp_corner_of(Function function) {
    return mode_of<nc::CompCorner>(kCompCorners, function);
}

ProgrammedUnits units_of(Function function) {
    if (function == Function::Inch) return ProgrammedUnits::Inch;
    return function == Function::Metric ? ProgrammedUnits::Metric : ProgrammedUnits::Unsaid;
}

}  // namespace kadr::interp
