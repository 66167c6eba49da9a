#include "expand/modal.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "expand/plane.h"
#include "nc/parameters.h"

namespace kadr::expand {

using nc::Function;
using nc::Group;
using nc::parameter_of;
using nc::parameter_of_all;

namespace {

constexpr nc::Rules kLanguage = nc::Rules::of_language();
constexpr auto kAllAxes = static_cast<AxisMask>((1u << kAxes) - 1u);

}  // namespace

ModalState ModalState::at_start(const sema::FunctionCode& entry) {
    ModalState state;
    const auto set = [&](Group group, Function function) {
        state.active[static_cast<std::size_t>(group)] = function;
    };
    set(Group::Motion, entry.motion);
    state.restate_motion = entry.motion != Function::Rapid;
    set(Group::Plane, Function::PlaneXy);
    set(Group::Units, entry.units == sema::Units::Inch ? Function::Inch : Function::Metric);
    set(Group::Distance, Function::Absolute);
    set(Group::FeedMode, Function::FeedPerMinute);
    set(Group::SpeedMode, Function::CuttingSpeedOff);
    set(Group::RadiusComp, Function::RadiusCompOff);
    set(Group::LengthComp, Function::LengthCompOff);
    set(Group::Spindle, Function::SpindleStop);
    set(Group::Coolant, Function::CoolantOff);
    set(Group::CycleMode, Function::CycleOff);
    set(Group::CycleReturn, Function::CycleReturnInitial);
    set(Group::Transformation, Function::TcpOff);
    if (entry.has_diameters) {
        set(Group::Diameter, Function::DiameterOn);
        state.is_diameter = true;
        state.diameter_due = Function::DiameterOn;
    }
    // Path mode and work offset are whatever the control has, and so is whether X is a diameter: a
    // program that needs one of them programs it.
    return state;
}

void ModalState::set_frame(const control::ProgramFrame& next, SourceId source) {
    control::KnownPoint point;
    for (std::size_t i = 0; i < 3; ++i) {
        point.value[i] = position[i];
        point.is_known[i] = (known >> i & 1u) != 0;
    }
    if (is_diameter) point.value[0] /= 2;  // frames have radii
    control::KnownPoint moved = change_frame(point, frame, next);
    if (is_diameter) moved.value[0] *= 2;
    for (std::size_t i = 0; i < 3; ++i) {
        if (next.differs(frame, i))
            note_drift(i, point.is_known[i] && moved.is_known[i], moved.value[i] - position[i]);
        position[i] = moved.value[i];
        const auto bit = static_cast<AxisMask>(1u << i);
        known = static_cast<AxisMask>(moved.is_known[i] ? known | bit : known & ~bit);
    }
    if ((lost & sema::kFrameBit) != 0) known &= static_cast<AxisMask>(~kLinearXYZ);
    // Where a program turns and does not tell whether its X is a diameter, the control knows alone
    // what a frame makes of it.
    const bool may_be_diameter =
        (*this)[Group::Diameter] == Function::None && (*this)[Group::Plane] == Function::PlaneZx;
    if (may_be_diameter && next.differs(frame, 0)) known &= static_cast<AxisMask>(~bit(Axis::X));
    is_position_due = true;
    // A control that has its rotation innermost writes it again behind every other change.
    const bool turns = next.angle_deg != 0 || frame.angle_deg != 0;
    if (turns && next != frame) unplaced |= (next.angle_deg != 0 ? next : frame).plane_mask();
    frame = next;
    is_stretched = next.scale[0] != next.scale[1] || next.scale[1] != next.scale[2];
    frame_by = source;
}

void Drift::add(std::size_t axis, double distance) {
    constexpr double kRounding = 1e-9;  // mm: what a frame and its end leave of a coordinate
    const auto bit = static_cast<AxisMask>(1u << axis);
    by[axis] += distance;
    if (std::fabs(by[axis]) < kRounding) by[axis] = 0;
    has = static_cast<AxisMask>(by[axis] != 0 ? has | bit : has & ~bit);
}

void Drift::forget(AxisMask axes) {
    for (std::size_t i = 0; i < kAxes; ++i) {
        if ((axes >> i & 1u) != 0) by[i] = 0;
    }
    has &= static_cast<AxisMask>(~axes);
    lost &= static_cast<AxisMask>(~axes);
}

void ModalState::note_drift(std::size_t axis, bool is_known, double by) {
    // Frames move X by its radius.
    if (!is_known || (axis == 0 && is_diameter)) lose_drift(static_cast<AxisMask>(1u << axis));
    drift.add(axis, by);
    text_drift.add(axis, by);
}

void ModalState::forget_drift(AxisMask axes) {
    drift.forget(axes);
    text_drift.forget(axes);
    unplaced &= static_cast<AxisMask>(~axes);
}

void ModalState::lose_drift(AxisMask axes) {
    drift.lose(axes);
    text_drift.lose(axes);
}

void ModalState::lose_all_drift() {
    drift.lose_all();
    text_drift.lose_all();
}

void ModalState::name_position(const nc::FrameChange& change) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (!change.given[i]) continue;
        position[i] = change.values[i];
        known = static_cast<AxisMask>(known | 1u << i);
    }
}

/// The tool stays where it is; its X is another number then.
void ModalState::set_diameter(bool is_on, bool was_known) {
    if (!was_known) known &= static_cast<AxisMask>(~1u);
    else if (is_on != is_diameter) position[0] *= is_on ? 2 : 0.5;
    is_diameter = is_on;
    diameter_due = Function::None;
    drift.lose(drift.has & bit(Axis::X));
    text_drift.lose(text_drift.has & bit(Axis::X));
}

/// The zero point moves along one axis (1 is X), in a frame that turns along some.
void ModalState::lose_corrected(double axis) {
    const bool is_one = frame.is_shift() && tilt == PlaneTilt::None && axis >= 1 && axis <= 3;
    known &= is_one ? static_cast<AxisMask>(~(1u << (static_cast<unsigned>(axis) - 1u)))
                    : static_cast<AxisMask>(~kLinearXYZ);
}

void ModalState::put_frame(const control::ProgramFrame& next, SourceId source) {
    const AxisMask before = known;
    steps.say(next);
    written_steps = steps;
    frame_fault = control::FrameFormFault::None;
    set_frame(next, source);
    note_lost_positions(before, source, Loss::Control);
}

/// In the frames that blocks have programmed and in those of their text alike.
template <typename Change>
void ModalState::change_steps(SourceId source, Change change) {
    change(steps);
    change(written_steps);
    frame_from_steps(source);
}

void ModalState::frame_from_steps(SourceId source) {
    const auto [next, fault] = steps.frame();
    frame_fault = fault;
    if (fault != control::FrameFormFault::None) known &= static_cast<AxisMask>(~kLinearXYZ);
    set_frame(next, source);
}

/// A factor that is none is the control's alarm, or a mirror.
void ModalState::scale(const nc::FrameChange& change, SourceId source) {
    if (std::ranges::any_of(change.factors, [](double factor) { return !(factor > 0); })) {
        known &= static_cast<AxisMask>(~kLinearXYZ);
        return;
    }
    change_steps(source, [&](auto& all) { all.scale(change.factors, change.values); });
}

void ModalState::rotate(const nc::FrameChange& change, SourceId source, const nc::Rules& target) {
    const Function plane = (*this)[Group::Plane];
    steps.rotate(change.angle_deg, plane, change.values);
    if (target.rotate_outside_scale)
        written_steps.rotate_scaled(change.angle_deg, plane, change.values);
    else written_steps.rotate(change.angle_deg, plane, change.values);
    frame_from_steps(source);
}

void ModalState::lose_axes(AxisMask axes) {
    known &= static_cast<AxisMask>(~axes);
    lose_drift(axes);
}

/// Another system, and the control alone knows where the tool stands in it.
void ModalState::lose_system() { lose_axes(kAllAxes); }

/// Data of the zero point that acts move it along the axes that they name: in a rotated or
/// tilted system along all of X, Y, Z.
void ModalState::write_offset(const nc::Block& block, const nc::Effect& effect) {
    const nc::Invocation& invocation = effect.invocation_in(block);
    const double number =
        block.argument(invocation, parameter_of<Function::WorkOffsetData>("number"));
    const bool is_other =
        (*this)[Group::WorkOffsets] == Function::WorkOffset && number != 0 && number != work_offset;
    if (is_other) return;
    auto axes = static_cast<AxisMask>(
        invocation.given >> parameter_of<Function::WorkOffsetData>("x") & kAllAxes);
    const bool is_turned_system = frame.angle_deg != 0 || tilt != PlaneTilt::None;
    if (is_turned_system && (axes & kLinearXYZ) != 0) axes |= kLinearXYZ;
    lose_axes(axes);
}

void ModalState::select_work_offset(double number) {
    if ((*this)[Group::WorkOffsets] != Function::WorkOffset || work_offset != number) lose_system();
    work_offset = number;
    due_offset = 0;
}

/// Where the words of the block have brought its axes, only the control knows.
void ModalState::lose_words(const nc::Block& block, const nc::Effect& effect) {
    auto axes = static_cast<AxisMask>(block.given & nc::kTargetSlots);
    // In machine coordinates one axis moves: along a rotated system several coordinates change.
    const bool is_machine = effect.function == Function::MachineCoordinates;
    const bool turns_axes = frame.angle_deg != 0 || tilt != PlaneTilt::None;
    if (is_machine && turns_axes && (axes & kLinearXYZ) != 0) axes |= kLinearXYZ;
    known &= static_cast<AxisMask>(~axes);
    // The control may count an increment from the number that was programmed there.
    if (is_machine) lose_drift(axes);
}

void ModalState::go_to_point(const nc::Block& block, const nc::Effect& effect) {
    known = 0;
    length.is_away |= block.has(nc::Slot::Z);
    if (effect.function != Function::ReferencePoint) return;
    constexpr std::size_t kFirstAxis = parameter_of<Function::ReferencePoint>("x");
    const auto named =
        static_cast<AxisMask>(effect.invocation_in(block).given >> kFirstAxis & kLinearXYZ);
    length.is_away |= (named & bit(Axis::Z)) != 0;
    forget_drift(named);
}

/// Where the tools of a program are, as far as is known: what turns in G18, or has diameters, is
/// the part.
nc::Changer ModalState::changer() const {
    const bool turns = is_diameter || (*this)[Group::Plane] == Function::PlaneZx;
    return turns ? nc::Changer::Turret : nc::Changer::Magazine;
}

/// The changer stands somewhere else and takes the spindle over.
void ModalState::change_tool(const nc::Block& block, const nc::Rules& target) {
    lacks_tool = is_edge_off = length.has_ended = false;
    has_tool_in = has_tool;
    tool_in = tool;
    known = 0;
    lose_all_drift();
    if (nc::stops_at_tool_change(target, changer()))
        switch_spindle(Function::SpindleStop, block.source);
}

void ModalState::take(const nc::Block& block, const nc::Effect& effect, const nc::Rules& target) {
    using Kind = nc::EffectKind;
    const SourceId source = block.source;
    const auto change = [&] { return frame_change(block, effect); };
    const auto number = [&](std::size_t parameter) {
        return block.argument(effect.invocation_in(block), parameter);
    };
    switch (effect.kind) {
        case Kind::Sets: set_member(block, effect); break;
        case Kind::Shift:
            change_steps(source,
                         [said = change()](auto& all) { all.shift(said.values, said.given); });
            lost &= ~sema::kFrameBit;  // it replaces all frames
            break;
        case Kind::ShiftAdd:
            change_steps(source,
                         [said = change()](auto& all) { all.shift_add(said.values, said.given); });
            break;
        case Kind::Rotate: rotate(change(), source, target); break;
        case Kind::Scale: scale(change(), source); break;
        case Kind::Mirror:
            change_steps(source, [said = change(), &target](auto& all) {
                all.mirror(said.given, target.mirror_replaces);
            });
            break;
        case Kind::RotateOff: change_steps(source, [](auto& all) { all.rotate_off(); }); break;
        case Kind::ScaleOff: change_steps(source, [](auto& all) { all.scale_off(); }); break;
        case Kind::MirrorOff:
            change_steps(source, [axes = effect.invocation_in(block).given](auto& all) {
                all.mirror_off(axes);
            });
            break;
        case Kind::SetPosition: name_position(change()); break;
        case Kind::WorkOffset:
            select_work_offset(number(parameter_of<Function::WorkOffset>("number")));
            break;
        case Kind::WritesWorkOffset: write_offset(block, effect); break;
        case Kind::CorrectsWorkOffset:
            lose_corrected(number(
                parameter_of_all<"axis", Function::OffsetToEdge, Function::OffsetToMiddle>()));
            break;
        case Kind::TurnsSpindle: turn_spindle(block, effect); break;
        case Kind::Tilts:
        case Kind::EndsTiltedPlane:
            tilt = effect.kind == Kind::EndsTiltedPlane ? PlaneTilt::None
                   : effect.function == Function::Tilt  ? PlaneTilt::Own
                                                        : PlaneTilt::Closed;
            lose_system();
            is_turned = true;  // as the plane before had left the axes
            break;
        case Kind::SwitchesTcp:
            // As a kind of tool length, orienting.cpp handles it.
            if (effect.function == Function::TcpOn) tcp = Tcp::Own;
            if (effect.function == Function::TcpOff) tcp = Tcp::Off;
            lose_axes(kLinearXYZ);
            break;
        case Kind::TurnsAxes:
            known &= kLinearXYZ;
            is_turned = true;
            break;
        case Kind::TurnsSystem: lose_system(); break;
        case Kind::SelectsTool:
            has_tool = true;
            tool = number(parameter_of_all<"tool", Function::ToolSelect, Function::Tool>());
            break;
        case Kind::ChangesTool: change_tool(block, target); break;
        case Kind::ChangesLength: take_length_offset(block, effect); break;
        case Kind::LeavesWords: lose_words(block, effect); break;
        case Kind::GoesToPoint: go_to_point(block, effect); break;
        case Kind::EndsProgram:
            has_ended = block.skip_level < 0;
            ended_by = source;
            reported.renew(ProgramNotice::AfterEnd);
            break;
        case Kind::SelectsLength:
            length.offset = number(parameter_of<Function::LengthOffset>("offset"));
            break;
        case Kind::SelectsEdge:
        case Kind::WritesLength:
        case Kind::SelectsRadius: break;  // what lengths and radii are, the control knows
        case Kind::RunsCycle: break;      // native_cycles.cpp
        case Kind::Own:
            if (effect.function == Function::SpindleSpeed) take_numbered_speed(block, effect);
            break;
    }
}

/// A modal group has another member.
void ModalState::set_member(const nc::Block& block, const nc::Effect& effect) {
    const Group group = effect.group();
    Function& member = active[static_cast<std::size_t>(group)];
    const Function before = member;
    const bool is_other = before != effect.function;
    lost &= ~sema::group_bit(group);
    member = effect.function;
    changed_by[static_cast<std::size_t>(group)] = block.source;
    switch (group) {
        case Group::Motion: restate_motion = false; break;
        case Group::Diameter:
            if (effect.function != Function::DiameterAbsolute)
                set_diameter(effect.function == Function::DiameterOn, before != Function::None);
            break;
        case Group::Spindle:
            spindle_in_doubt = false;
            reported.renew_spindle();
            break;
        case Group::RadiusComp:
            choose_compensation(effect.function, block.skip_level, block.source);
            break;
        case Group::FeedMode:
            is_feed_lost |= is_other && has_feed;
            has_feed &= !is_other;
            break;
        case Group::SpeedMode: has_speed &= !is_other; break;
        case Group::NonModal:
        case Group::Plane:
        case Group::Units:
        case Group::Distance:
        case Group::LengthComp:
        case Group::PathMode:
        case Group::WorkOffsets:
        case Group::Coolant:
        case Group::CycleMode:
        case Group::CycleReturn:
        case Group::CompStart:
        case Group::CompCorner:
        case Group::CompCheck:
        case Group::Compressor:
        case Group::Transformation:
        case Group::OrientInterpolation:
        case Group::OrientAngles:
        case Group::OrientSystem:
        case Group::Spinning:
        case Group::CompKind:
        case Group::CompOrientation:
        case Group::DataInput: break;  // what acts is all that is known of them
    }
}

/// Follows what acts if the operator leaves out the blocks that he may, beside what acts if not.
///
/// skip_level         level of the block that programs the compensation or its end; -1 none
void ModalState::choose_compensation(Function side, int skip_level, SourceId source) {
    if (skip_level < 0) {
        comp_without = side;
        comp_choice = kNoChoice;
        return;
    }
    if (comp_choice != kNoChoice && comp_choice != skip_level) comp_choice = kSeveralLevels;
    else comp_choice = side == comp_without ? kNoChoice : skip_level;
    comp_by = source;
}

void ModalState::switch_spindle(Function member, SourceId source) {
    active[static_cast<std::size_t>(Group::Spindle)] = member;
    changed_by[static_cast<std::size_t>(Group::Spindle)] = source;
    reported.renew_spindle();
}

void ModalState::set_spindle(double code, SourceId source) {
    const Function member = nc::spindle_of_code(code);
    if (member != (*this)[Group::Spindle]) switch_spindle(member, source);
}

/// By their numbers; how a new master turns, its control knows.
void ModalState::turn_spindle(const nc::Block& block, const nc::Effect& effect) {
    const nc::Invocation& invocation = effect.invocation_in(block);
    if (effect.function == Function::SpindleTurn) {
        constexpr std::size_t kSpindle = parameter_of<Function::SpindleTurn>("spindle");
        constexpr std::size_t kSense = parameter_of<Function::SpindleTurn>("sense");
        if (master_spindle == 0) return lose_spindle(block.source);
        if (block.argument(invocation, kSpindle) != master_spindle) return;
        set_spindle(block.argument(invocation, kSense), block.source);
        lost &= ~sema::group_bit(Group::Spindle);
        spindle_in_doubt = false;
        return;
    }
    const double before = master_spindle;
    master_spindle =
        block.argument(invocation, parameter_of<Function::MasterSpindle>("spindle"), 1);
    if (master_spindle != before) lose_spindle(block.source);
}

/// `S1=1000`: of the master spindle it is what `S1000` is.
void ModalState::take_numbered_speed(const nc::Block& block, const nc::Effect& effect) {
    const nc::Invocation& invocation = effect.invocation_in(block);
    const double spindle =
        block.argument(invocation, parameter_of<Function::SpindleSpeed>("spindle"));
    if (master_spindle != 0 && spindle != master_spindle) return;
    take_speed(block.argument(invocation, parameter_of<Function::SpindleSpeed>("speed")), block);
    // Which one is the master nobody knows, and so not whose speed it is either.
    if (master_spindle == 0) has_speed = false;
}

void ModalState::take_speed(double value, const nc::Block& block) {
    speed = value;
    has_speed = true;
    lacks_speed = false;
    had_cutting_speed |= (*this)[Group::SpeedMode] == Function::CuttingSpeedOn;
    speed_by = block.source;
    lost &= ~sema::kSpeedBit;
    if (block.skip_level < 0) restate &= ~sema::kSpeedBit;
}

void ModalState::lose_spindle(SourceId source) {
    active[static_cast<std::size_t>(Group::Spindle)] = Function::None;
    lost |= sema::group_bit(Group::Spindle);
    lost_by = source;
    lost_in = Loss::Control;
}

/// A number that was programmed stays, whichever way the length counts.
void ModalState::take_length_offset(const nc::Block& block, const nc::Effect& effect) {
    if (effect.function == Function::LengthCompOff) return;
    constexpr std::size_t kOffset =
        parameter_of_all<"offset", Function::LengthCompOn, Function::LengthCompMinus>();
    const nc::Invocation& invocation = effect.invocation_in(block);
    if (invocation.has(kOffset)) length.offset = block.argument(invocation, kOffset);
}

void ModalState::note_lost_positions(AxisMask before, SourceId by, Loss how) {
    if ((before & ~known) == 0) return;
    for (std::size_t i = 0; i < kAxes; ++i)
        if (((before & ~known) >> i & 1u) != 0) position_lost_by[i] = {by, how};
}

bool ModalState::take_functions(const nc::Block& block, const nc::Rules& target) {
    if (block.function_count == 0) {  // nearly all blocks
        if (block.motion != Function::None)
            take(block, nc::Effect::of_motion(block.motion), target);
        return false;
    }
    const nc::Effects effects = effects_of(kLanguage, block, nc::Changer::Magazine);
    const AxisMask before = known;
    for (const nc::When when : {nc::When::AtOnce, nc::When::ToolChange, nc::When::BeforeMotion})
        take_at(when, block, target, effects);
    note_lost_positions(before, block.source, Loss::Control);
    return effects.has(nc::When::Behind);
}

void ModalState::take_behind(const nc::Block& block, const nc::Rules& target) {
    const AxisMask before = known;
    take_at(nc::When::Behind, block, target, effects_of(kLanguage, block, nc::Changer::Magazine));
    note_lost_positions(before, block.source, Loss::Control);
}

void ModalState::take_at(nc::When when, const nc::Block& block, const nc::Rules& target,
                         const nc::Effects& effects) {
    if (!effects.has(when)) return;
    for (const nc::Effect& effect : effects)
        if (effect.when == when) take(block, effect, target);
}

void ModalState::take_block(const nc::Block& block, const nc::Rules& target) {
    const bool owes_behind = take_functions(block, target);
    take_words(block);
    if (owes_behind) take_behind(block, target);
}

void ModalState::take_words(const nc::Block& block) {
    if (block.has(nc::Slot::Feed)) {
        feed = block.at(nc::Slot::Feed);
        has_feed = true;
        is_feed_lost = false;
        is_feed_deleted = false;
        feed_by = block.source;
        lost &= ~sema::kFeedBit;
        if (block.skip_level < 0) restate &= ~sema::kFeedBit;
    }
    if (block.has(nc::Slot::Speed)) take_speed(block.at(nc::Slot::Speed), block);
    if ((block.given & nc::kTargetSlots) != 0) take_targets(block);
}

/// Where the words of a block lead.
void ModalState::take_targets(const nc::Block& block) {
    nc::SlotMask targets = block.given & nc::kTargetSlots;
    if ((targets & (bit(Axis::A) | bit(Axis::B) | bit(Axis::C))) != 0) note_rotary(block);
    if (block.has(nc::Slot::Z)) length.is_away = false;
    // The operator may leave the block out: then they have gone nowhere.
    const auto named = static_cast<AxisMask>(targets);
    const auto programmed =
        static_cast<AxisMask>(targets & ~std::exchange(named_by_text, AxisMask{0}));
    if (block.skip_level >= 0) {
        drift.lose(drift.has & programmed);
        text_drift.lose(text_drift.has & named);
    } else if (adapts() != 0) {
        drift.forget(programmed);
        text_drift.forget(named);
        unplaced &= static_cast<AxisMask>(~named);
    }
    const PlaneIndices axes = indices_of(plane_of((*this)[Group::Plane]));
    if (((targets >> axes.first | targets >> axes.second) & 1u) != 0) {
        const bool is_doubtful = block.skip_level >= 0 && is_compensation_due();
        moved_under = is_doubtful ? Function::None : (*this)[Group::RadiusComp];
    }
    const bool modal_incremental = (*this)[Group::Distance] == Function::Incremental;
    for (std::size_t i = 0; targets != 0; ++i, targets >>= 1) {
        if ((targets & 1u) == 0) continue;
        const nc::SlotMask bit = nc::SlotMask{1} << i;
        const bool is_incremental =
            (block.incremental & bit) != 0 || (modal_incremental && (block.absolute & bit) == 0);
        if (is_incremental) {
            position[i] += block.values[i];
        } else {
            position[i] = block.values[i];
            known = static_cast<AxisMask>(known | bit);
        }
    }
}

/// Rotary axes that a block names, all of them at 0, stand there; which others the machine has
/// nobody knows here.
void ModalState::note_rotary(const nc::Block& block) {
    const bool is_incremental = (*this)[nc::Group::Distance] == Function::Incremental;
    is_turned = false;
    for (const Axis axis : {Axis::A, Axis::B, Axis::C}) {
        const nc::Slot slot = nc::slot_of(axis);
        if (!block.has(slot)) continue;
        const bool is_distance = (block.incremental & nc::bit(slot)) != 0 ||
                                 (is_incremental && (block.absolute & nc::bit(slot)) == 0);
        is_turned = is_turned || is_distance || block.at(slot) != 0;
    }
}

sema::ModalMask difference(const ModalState& a, const ModalState& b, sema::ModalMask mask) {
    sema::ModalMask result = 0;
    for (std::size_t i = 0; i < nc::kGroups; ++i) {
        const sema::ModalMask bit = sema::ModalMask{1} << i;
        if ((mask & bit) == 0) continue;
        bool differs = a.active[i] != b.active[i];
        if (a.active[i] == Function::WorkOffset)
            differs = differs || a.work_offset != b.work_offset;
        if (a.active[i] == Function::LengthCompOn) {
            differs = differs || a.length.offset != b.length.offset;
        }
        if (differs) result |= bit;
    }
    if ((mask & sema::kFrameBit) != 0 && !(a.frame == b.frame)) result |= sema::kFrameBit;
    if ((mask & sema::kFeedBit) != 0 && (a.has_feed != b.has_feed || a.feed != b.feed))
        result |= sema::kFeedBit;
    if ((mask & sema::kSpeedBit) != 0 && (a.has_speed != b.has_speed || a.speed != b.speed))
        result |= sema::kSpeedBit;
    return result;
}

}  // namespace kadr::expand
