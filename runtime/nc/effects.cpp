#include "nc/effects.h"

#include "nc/parameters.h"

namespace kadr::nc {

namespace {

using Kind = EffectKind;

/// The effects of one function, one after the other.
class OfFunction {
  public:
    OfFunction(Effects& effects, Function function, std::uint8_t invocation)
        : effects_(effects), function_(function), invocation_(invocation) {}

    OfFunction& at_once(EffectKind kind) { return add(kind, When::AtOnce); }
    OfFunction& with_tool(EffectKind kind) { return add(kind, When::ToolChange); }
    OfFunction& before_motion(EffectKind kind) { return add(kind, When::BeforeMotion); }
    OfFunction& behind(EffectKind kind) { return add(kind, When::Behind); }
    void own() { add(EffectKind::Own, When::AtOnce); }
    /// The function is the member of its group from here on.
    void sets(When when) { add(EffectKind::Sets, when); }

  private:
    OfFunction& add(EffectKind kind, When when) {
        effects_.add({kind, when, function_, invocation_});
        return *this;
    }

    Effects& effects_;
    Function function_;
    std::uint8_t invocation_;
};

/// When the function becomes the member of its group: spindle and coolant wait for the tool that
/// the block may change.
When time_of_group(const Rules& rules, Function function) {
    const Group group = group_of(function);
    if (group != Group::Spindle && group != Group::Coolant) return When::AtOnce;
    return has_fact(function, Fact::StopsMachine) ? time_of_stop(rules) : When::BeforeMotion;
}

/// All but that on its group.
void add_own_effects(const Rules& rules, Function function, Changer changer, OfFunction& does) {
    switch (function) {
        case Function::None:
        case Function::Rapid:
        case Function::Line:
        case Function::ArcCw:
        case Function::ArcCcw:
        case Function::Spline:
        case Function::TapIn:
        case Function::TapOut:
        case Function::Thread:
        case Function::PlaneXy:
        case Function::PlaneZx:
        case Function::PlaneYz:
        case Function::Inch:
        case Function::Metric:
        case Function::Absolute:
        case Function::Incremental:
        case Function::FeedPerMinute:
        case Function::FeedPerRevolution:
        case Function::FeedInverseTime:
        case Function::CuttingSpeedOn:
        case Function::CuttingSpeedOff:
        case Function::RadiusCompOff:
        case Function::RadiusCompLeft:
        case Function::RadiusCompRight:
        case Function::PeripheralCompLeft:
        case Function::PeripheralCompRight:
        case Function::CompStartNormal:
        case Function::CompStartAround:
        case Function::CompStartTangent:
        case Function::CompStartSmooth:
        case Function::CompCornerArc:
        case Function::CompCornerIntersection:
        case Function::CompCheckOn:
        case Function::CompCheckOff:
        case Function::CompInPlane:
        case Function::CompInFrame:
        case Function::CompPeripheral:
        case Function::CompFaceMilling:
        case Function::CompFaceMillingInFrame:
        case Function::CompFaceMillingInPlane:
        case Function::CompOrientOnArc:
        case Function::CompOrientBefore:
        case Function::ExactStop:
        case Function::ContinuousPath:
        case Function::TappingMode:
        case Function::BlendDistance:
        case Function::BlendTolerance:
        case Function::BlendSmooth:
        case Function::CompressOn:
        case Function::CompressOff:
        case Function::DiameterOn:
        case Function::DiameterOff:
        case Function::OrientGreatCircle:
        case Function::OrientAxes:
        case Function::OrientSurface:
        case Function::OrientConeCw:
        case Function::OrientConeCcw:
        case Function::OrientConeThrough:
        case Function::OrientConeTangential:
        case Function::OrientSecondPoint:
        case Function::AnglesEuler:
        case Function::AnglesZyz:
        case Function::AnglesRpy:
        case Function::AnglesXyz:
        case Function::OrientInWork:
        case Function::OrientInBase:
        case Function::SpinFixed:
        case Function::SpinPlane:
        case Function::SpinTurn:
        case Function::SpinPath:
        case Function::SpindleCw:
        case Function::SpindleCcw:
        case Function::SpindleStop:
        case Function::CoolantFlood:
        case Function::CoolantMist:
        case Function::CoolantOff:
        case Function::CycleReturnInitial:
        case Function::CycleReturnRetract:
        case Function::ArcThrough:
        case Function::ArcTangent:
        case Function::DiameterAbsolute:
        case Function::AkimaSpline:
        case Function::CubicSpline:
        case Function::Polynomial:
        case Function::InvoluteCw:
        case Function::InvoluteCcw:
        case Function::ThreadIncreasing:
        case Function::ThreadDecreasing:
        case Function::ThreadArcCw:
        case Function::ThreadArcCcw:
        case Function::ParameterInput:
        case Function::LifeInput:
        case Function::DataInputOff: break;  // of a group: that tells it all
        case Function::Probe:
        case Function::MachineCoordinates:
        case Function::ToolOffsetIncrease: does.behind(Kind::LeavesWords).own(); break;
        case Function::OffsetToEdge:
        case Function::OffsetToMiddle: does.at_once(Kind::CorrectsWorkOffset); break;
        case Function::RadiusOffset: does.at_once(Kind::SelectsRadius); break;
        case Function::LengthCompOn:
        case Function::LengthCompOff:
        case Function::LengthCompMinus: does.at_once(Kind::ChangesLength); break;
        case Function::LengthOffset: does.at_once(Kind::SelectsLength); break;
        case Function::WorkOffset: does.at_once(Kind::WorkOffset); break;
        case Function::ReferencePoint:
        case Function::ReferenceReturn:
        case Function::MeasureLength: does.behind(Kind::GoesToPoint).own(); break;
        case Function::Shift: does.at_once(Kind::Shift); break;
        case Function::ShiftAdd: does.at_once(Kind::ShiftAdd); break;
        case Function::Rotate: does.at_once(Kind::Rotate); break;
        case Function::RotateOff:
            does.at_once(Kind::RotateOff);
            if (rules.rotation_off_ends_tilt) does.at_once(Kind::EndsTiltedPlane);
            break;
        case Function::Scale: does.at_once(Kind::Scale); break;
        case Function::ScaleOff: does.at_once(Kind::ScaleOff); break;
        case Function::Mirror: does.at_once(Kind::Mirror); break;
        case Function::MirrorOff: does.at_once(Kind::MirrorOff); break;
        case Function::SetPosition: does.at_once(Kind::SetPosition); break;
        case Function::WorkOffsetData: does.before_motion(Kind::WritesWorkOffset); break;
        case Function::ToolOffsetData:
        case Function::LatheOffsetData:
            if (rules.tool_offsets_act_at_once) does.before_motion(Kind::WritesLength);
            does.own();
            break;
        case Function::ToolSelect:
            does.at_once(Kind::SelectsTool);
            if (selects_at_once(rules, changer)) does.with_tool(Kind::ChangesTool);
            break;
        case Function::ToolChange: does.with_tool(Kind::ChangesTool); break;
        case Function::ToolEdge: does.at_once(Kind::SelectsEdge); break;
        case Function::Tool: does.at_once(Kind::SelectsTool).with_tool(Kind::ChangesTool); break;
        case Function::TcpLength:
        case Function::TcpVector:
        case Function::TcpOn:
        case Function::TcpBased:
        case Function::TcpOff:
        case Function::PolarInterpolationOn:
        case Function::CylindricalInterpolationOn:
        case Function::InclinedAxisOn: does.at_once(Kind::SwitchesTcp); break;
        case Function::MasterSpindle:
        case Function::SpindleTurn: does.before_motion(Kind::TurnsSpindle).own(); break;
        case Function::OrientReset: does.before_motion(Kind::TurnsAxes).own(); break;
        case Function::Tilt: does.at_once(Kind::Tilts).before_motion(Kind::TurnsAxes).own(); break;
        case Function::TiltedPlaneEuler:
        case Function::TiltedPlaneByAngles:
        case Function::TiltedPlaneByPoints:
        case Function::TiltedPlaneByVectors:
        case Function::TiltedPlaneAlongTool:
        case Function::Rotation3d: does.at_once(Kind::Tilts).own(); break;
        case Function::AlignTool:
        case Function::AlignToolAtTip:
        case Function::Swivel:
            does.before_motion(Kind::TurnsSystem).before_motion(Kind::TurnsAxes).own();
            break;
        case Function::TiltedPlaneOff: does.at_once(Kind::EndsTiltedPlane); break;
        case Function::End:
        case Function::EndRewind: does.behind(Kind::EndsProgram); break;
        case Function::Cycle: does.behind(Kind::RunsCycle).own(); break;
        case Function::PositionReset:
        case Function::RotateSpace:
        case Function::RotateSolid:
        case Function::ShiftCoarse:
        case Function::ShiftFine:
        case Function::ShiftAxes:
        case Function::ShiftAxesAdd:
        case Function::SetPositionAxes:
        case Function::ToolFrame:
        case Function::ToolFrameOff:
        case Function::TableFrame:
        case Function::TableFrameOff:
        case Function::ToolCarrier:
        case Function::CarrierByData:
        case Function::CarrierByFrame:
        case Function::Preset: does.at_once(Kind::TurnsSystem).own(); break;
        case Function::SplineDegree:
        case Function::SplineWeight:
        case Function::SplineInterval:
        case Function::SplineKnot:
        case Function::ThreadStart:
        case Function::TapFloating:
        case Function::TapRigid:
        case Function::ProbeCheck:
        case Function::ProbeClear:
        case Function::ProbeKeep:
        case Function::SpeedLimit:
        case Function::CompCornerPointed:
        case Function::CompOpenEnd:
        case Function::CompDepth:
        case Function::CompAllowance:
        case Function::ExactStopOnce:
        case Function::BlendFeedDistance:
        case Function::BlendRapidDistance:
        case Function::OrientTolerance:
        case Function::PathTolerance:
        case Function::HighSpeed:
        case Function::FeedOverride:
        case Function::RapidOverride:
        case Function::AxisVelocity:
        case Function::AxisAcceleration:
        case Function::AxisJerk:
        case Function::ToolVector:
        case Function::ToolAngle:
        case Function::ToolLead:
        case Function::SurfaceLead:
        case Function::SurfaceTilt:
        case Function::SurfaceNormal:
        case Function::ConeAxis:
        case Function::ConeOpening:
        case Function::ToolBetween:
        case Function::ToolPoint:
        case Function::ToolSpin:
        case Function::SpindleOrient:
        case Function::SpindleSpeed:
        case Function::SpindleStand:
        case Function::SpindleLimit:
        case Function::SpindleBound:
        case Function::SpindleDwell:
        case Function::Dwell:
        case Function::MachineFunction:
        case Function::Stop:
        case Function::OptionalStop:
        case Function::Message:
        case Function::CycleOff:
        case Function::CyclePreset:
        case Function::CycleWords:
        case Function::CycleCall:
        case Function::CycleModal:
        case Function::Pole:
        case Function::PolarPoint:
        case Function::PolarOn:
        case Function::PolarOff:
        case Function::CornerChamfer:
        case Function::CornerRound:
        case Function::CornerRoundModal:
        case Function::CornerFeed:
        case Function::CornerFeedModal:
        case Function::ContourAngle:
        case Function::CompKeepVector:
        case Function::CompCornerHere:
        case Function::SmoothApproach:
        case Function::SmoothRetract:
        case Function::ApproachRadius:
        case Function::ApproachClearance:
        case Function::ApproachFeed:
        case Function::ApproachSide:
        case Function::ApproachSteps:
        case Function::RapidOnce:
        case Function::ReferenceCheck:
        case Function::ReferenceLeave:
        case Function::FeedOnce:
        case Function::CompFeed:
        case Function::AreaLimit:
        case Function::AreaOn:
        case Function::AreaOff:
        case Function::SpeedBound:
        case Function::CompPause:
        case Function::CompResume:
        case Function::SplineStart:
        case Function::SplineEnd:
        case Function::PolynomialAxis:
        case Function::PolynomialWeight:
        case Function::PolynomialRange:
        case Function::ThreadChange:
        case Function::PathMoves:
        case Function::PointMoves:
        case Function::PointRapids:
        case Function::AxisConfiguration:
        case Function::AxisSigns:
        case Function::OrientSmooth:
        case Function::OrientSmoothOff:
        case Function::SumOffset:
        case Function::LengthSuspend:
        case Function::ToothFeed:
        case Function::ParameterData:
        case Function::LifeData:
        case Function::FeedAxes:
        case Function::FeedRadius:
        case Function::AxisSpeed:
        case Function::AxisFeed:
        case Function::AxisOverride:
        case Function::FeedCourse:
        case Function::FeedPolynomial: does.own(); break;
    }
}

void add_effects_at(const Rules& rules, const Block& block, std::size_t index, Changer changer,
                    Effects& effects) {
    const Function function = block.functions[index].function;
    OfFunction does(effects, function, static_cast<std::uint8_t>(index));
    add_own_effects(rules, function, changer, does);
    // At last: those above depend on the member that acted before.
    if (group_of(function) != Group::NonModal) does.sets(time_of_group(rules, function));
}

constexpr std::array kNames = {
#define KADR_EFFECT(kind, meaning) std::string_view(#kind),
#include "nc/effects.def"
#undef KADR_EFFECT
};

}  // namespace

bool selects_at_once(const Rules& rules, Changer changer) {
    return rules.tool_select_changes == ToolSelectChanges::Yes ||
           (rules.tool_select_changes == ToolSelectChanges::Lathe && changer == Changer::Turret);
}

When time_of_stop(const Rules& rules) {
    return rules.stops_after_motion ? When::Behind : When::BeforeMotion;
}

bool stops_at_tool_change(const Rules& rules, Changer changer) {
    return rules.tool_change_stops_spindle && changer == Changer::Magazine;
}

std::string_view effect_name(EffectKind kind) { return kNames[static_cast<std::size_t>(kind)]; }

Effects effects_of(const Rules& rules, const Block& block, Changer changer) {
    Effects effects;
    if (block.motion != Function::None) effects.add(Effect::of_motion(block.motion));
    // A rotation turns in the plane of its block, wherever that is programmed.
    const bool plane_first = block.function_count > 1 && block.find(Function::Rotate) != nullptr;
    const auto is_plane = [&](std::size_t index) {
        return group_of(block.functions[index].function) == Group::Plane;
    };
    for (std::size_t i = 0; plane_first && i < block.function_count; ++i)
        if (is_plane(i)) add_effects_at(rules, block, i, changer, effects);
    for (std::size_t i = 0; i < block.function_count; ++i)
        if (!plane_first || !is_plane(i)) add_effects_at(rules, block, i, changer, effects);
    return effects;
}

namespace {

/// Three arguments from one on.
std::array<double, 3> three_of(const Block& block, const Invocation& invocation, std::size_t first,
                               double fallback = 0) {
    return {block.argument(invocation, first, fallback),
            block.argument(invocation, first + 1, fallback),
            block.argument(invocation, first + 2, fallback)};
}

std::size_t first_value(Function function) {
    constexpr std::size_t kShift =
        parameter_of_all<"x", Function::Shift, Function::ShiftAdd, Function::Mirror,
                         Function::MirrorOff, Function::SetPosition>();
    constexpr std::size_t kCenter = parameter_of_all<"x", Function::Rotate, Function::Scale>();
    return function == Function::Rotate || function == Function::Scale ? kCenter : kShift;
}

}  // namespace

FrameChange frame_change(const Block& block, const Effect& effect) {
    const Invocation& invocation = effect.invocation_in(block);
    const std::size_t first = first_value(effect.function);
    FrameChange change;
    change.values = three_of(block, invocation, first);
    change.given = {invocation.has(first), invocation.has(first + 1), invocation.has(first + 2)};
    if (effect.kind == EffectKind::Rotate)
        change.angle_deg = block.argument(invocation, parameter_of<Function::Rotate>("angle"));
    if (effect.kind == EffectKind::Scale) {
        const double of_all =
            block.argument(invocation, parameter_of<Function::Scale>("factor"), 1);
        change.factors = three_of(block, invocation, parameter_of<Function::Scale>("fx"), of_all);
    }
    return change;
}

}  // namespace kadr::nc
