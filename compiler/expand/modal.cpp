#include "expand/modal.h"

#include <algorithm>

#include "expand/plane.h"
#include "nc/parameters.h"

namespace kadr::expand {

using nc::Function;
using nc::Group;
using nc::parameter_of;
using nc::parameter_of_all;

namespace {

constexpr nc::Rules kLanguage = nc::Rules::of_language();

// ---------------------------------------------------------------- frames

void note_drift(ModalState& state, std::size_t axis, bool is_known, double by) {
    // Frames move X by its radius.
    if (!is_known || (axis == 0 && state.is_diameter))
        state.drifts.lose(static_cast<AxisMask>(1u << axis));
    state.drifts.add(axis, by);
}

/// Another frame acts: the tool stays where it is, its position is another one.
void set_frame(ModalState& state, const control::ProgramFrame& next, SourceId source) {
    const control::ProgramFrame& frame = state.frame.now();
    control::KnownPoint point;
    for (std::size_t i = 0; i < 3; ++i) {
        point.value[i] = state.position[i];
        point.is_known[i] = state.position.knows(i);
    }
    if (state.is_diameter) point.value[0] /= 2;  // frames have radii
    control::KnownPoint moved = change_frame(point, frame, next);
    if (state.is_diameter) moved.value[0] *= 2;
    for (std::size_t i = 0; i < 3; ++i) {
        if (next.differs(frame, i)) {
            note_drift(state, i, point.is_known[i] && moved.is_known[i],
                       moved.value[i] - state.position[i]);
        }
        state.position.restate(i, moved.value[i], moved.is_known[i]);
    }
    if (state.lost.has(sema::kFrameBit)) state.position.lose(kLinearXYZ);
    // Where a program turns and does not tell whether its X is a diameter, the control knows alone
    // what a frame makes of it.
    const bool may_be_diameter =
        state[Group::Diameter] == Function::None && state[Group::Plane] == Function::PlaneZx;
    if (may_be_diameter && next.differs(frame, 0)) state.position.lose(bit(Axis::X));
    state.owed.owe_position();
    // A control that has its rotation innermost writes it again behind every other change.
    const bool turns = next.angle_deg != 0 || frame.angle_deg != 0;
    if (turns && next != frame)
        state.drifts.turn((next.angle_deg != 0 ? next : frame).plane_mask());
    state.frame.set(next, source);
}

/// The frame becomes what its steps make.
void take_steps(ModalState& state, SourceId source) {
    const control::ProgramFrame next = state.frame.made();
    if (state.frame.has_fault()) state.position.lose(kLinearXYZ);
    set_frame(state, next, source);
}

/// One more step, in the frames that blocks have programmed and in those of their text alike.
template <typename Change>
void change_steps(ModalState& state, SourceId source, Change change) {
    state.frame.change(change);
    take_steps(state, source);
}

/// A factor that is none is the control's alarm, or a mirror.
void scale(ModalState& state, const nc::FrameChange& change, SourceId source) {
    if (std::ranges::any_of(change.factors, [](double factor) { return !(factor > 0); })) {
        state.position.lose(kLinearXYZ);
        return;
    }
    change_steps(state, source, [&](auto& all) { all.scale(change.factors, change.values); });
}

void rotate(ModalState& state, const nc::FrameChange& change, SourceId source,
            const nc::Rules& target) {
    state.frame.rotate(change.angle_deg, state[Group::Plane], change.values,
                       target.rotate_outside_scale);
    take_steps(state, source);
}

// ---------------------------------------------------------------- positions

void name_position(ModalState& state, const nc::FrameChange& change) {
    for (std::size_t i = 0; i < 3; ++i)
        if (change.given[i]) state.position.set(i, change.values[i]);
}

/// The tool stays where it is; its X is another number then.
void set_diameter(ModalState& state, bool is_on, bool was_known) {
    constexpr std::size_t kX = index(Axis::X);
    if (!was_known) state.position.lose(bit(Axis::X));
    else if (is_on != state.is_diameter)
        state.position.restate(kX, state.position[kX] * (is_on ? 2 : 0.5),
                               state.position.knows(kX));
    state.is_diameter = is_on;
    state.owed.owe_diameter(Function::None);
    state.drifts.lose_some(bit(Axis::X));
}

bool is_turned_system(const ModalState& state) {
    return state.frame.now().angle_deg != 0 || state.tilt.acts();
}

/// The zero point moves along one axis (1 is X), in a frame that turns along some.
void lose_corrected(ModalState& state, double axis) {
    const bool is_one =
        state.frame.now().is_shift() && !state.tilt.acts() && axis >= 1 && axis <= 3;
    state.position.lose(is_one ? static_cast<AxisMask>(1u << (static_cast<unsigned>(axis) - 1u))
                               : kLinearXYZ);
}

void lose_axes(ModalState& state, AxisMask axes) {
    state.position.lose(axes);
    state.drifts.lose(axes);
}

/// Another system, and the control alone knows where the tool stands in it.
void lose_system(ModalState& state) { lose_axes(state, kAllAxes); }

/// Data of the zero point that acts move it along the axes that they name: in a rotated or
/// tilted system along all of X, Y, Z.
void write_offset(ModalState& state, const nc::Block& block, const nc::Effect& effect) {
    const nc::Invocation& invocation = effect.invocation_in(block);
    const double number =
        block.argument(invocation, parameter_of<Function::WorkOffsetData>("number"));
    const bool is_other = state[Group::WorkOffsets] == Function::WorkOffset && number != 0 &&
                          number != state.work_offset;
    if (is_other) return;
    auto axes = static_cast<AxisMask>(
        invocation.given >> parameter_of<Function::WorkOffsetData>("x") & kAllAxes);
    if (is_turned_system(state) && (axes & kLinearXYZ) != 0) axes |= kLinearXYZ;
    lose_axes(state, axes);
}

void select_work_offset(ModalState& state, double number) {
    if (state[Group::WorkOffsets] != Function::WorkOffset || state.work_offset != number)
        lose_system(state);
    state.work_offset = number;
    state.owed.owe_work_offset(0);
}

/// Where the words of the block have brought its axes, only the control knows.
void lose_words(ModalState& state, const nc::Block& block, const nc::Effect& effect) {
    auto axes = static_cast<AxisMask>(block.given & nc::kTargetSlots);
    // In machine coordinates one axis moves: along a rotated system several coordinates change.
    const bool is_machine = effect.function == Function::MachineCoordinates;
    if (is_machine && is_turned_system(state) && (axes & kLinearXYZ) != 0) axes |= kLinearXYZ;
    state.position.lose(axes);
    // The control may count an increment from the number that was programmed there.
    if (is_machine) state.drifts.lose(axes);
}

void go_to_point(ModalState& state, const nc::Block& block, const nc::Effect& effect) {
    state.position.lose_all();
    if (block.has(nc::Slot::Z)) state.length.go_away();
    if (effect.function != Function::ReferencePoint) return;
    constexpr std::size_t kFirstAxis = parameter_of<Function::ReferencePoint>("x");
    const auto named =
        static_cast<AxisMask>(effect.invocation_in(block).given >> kFirstAxis & kLinearXYZ);
    if ((named & bit(Axis::Z)) != 0) state.length.go_away();
    state.drifts.forget(named);
}

/// Rotary axes that a block names, all of them at 0, stand there; which others the machine has
/// nobody knows here.
void note_rotary(ModalState& state, const nc::Block& block) {
    const bool is_incremental = state[Group::Distance] == Function::Incremental;
    bool is_turned = false;
    for (const Axis axis : {Axis::A, Axis::B, Axis::C}) {
        const nc::Slot slot = nc::slot_of(axis);
        if (!block.has(slot)) continue;
        const bool is_distance = (block.incremental & nc::bit(slot)) != 0 ||
                                 (is_incremental && (block.absolute & nc::bit(slot)) == 0);
        is_turned = is_turned || is_distance || block.at(slot) != 0;
    }
    state.position.turn(is_turned);
}

/// Where the words of a block lead.
void take_targets(ModalState& state, const nc::Block& block) {
    nc::SlotMask targets = block.given & nc::kTargetSlots;
    if ((targets & (bit(Axis::A) | bit(Axis::B) | bit(Axis::C))) != 0) note_rotary(state, block);
    if (block.has(nc::Slot::Z)) state.length.come_back();
    // The operator may leave the block out: then they have gone nowhere.
    state.drifts.take_named(static_cast<AxisMask>(targets), block.skip_level >= 0);
    const PlaneIndices axes = indices_of(plane_of(state[Group::Plane]));
    if (((targets >> axes.first | targets >> axes.second) & 1u) != 0) {
        const bool is_doubtful = block.skip_level >= 0 && state.is_compensation_due();
        state.compensation.move_under(is_doubtful ? Function::None : state[Group::RadiusComp]);
    }
    const bool modal_incremental = state[Group::Distance] == Function::Incremental;
    for (std::size_t i = 0; targets != 0; ++i, targets >>= 1) {
        if ((targets & 1u) == 0) continue;
        const nc::SlotMask bit = nc::SlotMask{1} << i;
        const bool is_incremental =
            (block.incremental & bit) != 0 || (modal_incremental && (block.absolute & bit) == 0);
        if (is_incremental) state.position.move(i, block.values[i]);
        else state.position.set(i, block.values[i]);
    }
}

// ---------------------------------------------------------------- spindle, tool, length

void lose_spindle(ModalState& state, SourceId source) {
    state.groups.assume(Group::Spindle, Function::None);
    state.lost.lose(sema::group_bit(Group::Spindle), source, Loss::Control);
}

/// By their numbers; how a new master turns, its control knows.
void turn_spindle(ModalState& state, const nc::Block& block, const nc::Effect& effect) {
    const nc::Invocation& invocation = effect.invocation_in(block);
    const double master = state.speed.master();
    if (effect.function == Function::SpindleTurn) {
        constexpr std::size_t kSpindle = parameter_of<Function::SpindleTurn>("spindle");
        constexpr std::size_t kSense = parameter_of<Function::SpindleTurn>("sense");
        if (master == 0) return lose_spindle(state, block.source);
        if (block.argument(invocation, kSpindle) != master) return;
        state.set_spindle(block.argument(invocation, kSense), block.source);
        state.lost.regain(sema::group_bit(Group::Spindle));
        state.speed.doubt_turning(false);
        return;
    }
    state.speed.make_master(
        block.argument(invocation, parameter_of<Function::MasterSpindle>("spindle"), 1));
    if (state.speed.master() != master) lose_spindle(state, block.source);
}

void take_speed(ModalState& state, double value, const nc::Block& block) {
    state.speed.take(value, state[Group::SpeedMode] == Function::CuttingSpeedOn, block.source);
    state.lost.regain(sema::kSpeedBit);
    if (block.skip_level < 0) state.lost.settle(sema::kSpeedBit);
}

/// `S1=1000`: of the master spindle it is what `S1000` is.
void take_numbered_speed(ModalState& state, const nc::Block& block, const nc::Effect& effect) {
    const nc::Invocation& invocation = effect.invocation_in(block);
    const double spindle =
        block.argument(invocation, parameter_of<Function::SpindleSpeed>("spindle"));
    const double master = state.speed.master();
    if (master != 0 && spindle != master) return;
    take_speed(state, block.argument(invocation, parameter_of<Function::SpindleSpeed>("speed")),
               block);
    // Which one is the master nobody knows, and so not whose speed it is either.
    if (master == 0) state.speed.forget();
}

/// A number that was programmed stays, whichever way the length counts.
void take_length_offset(ModalState& state, const nc::Block& block, const nc::Effect& effect) {
    if (effect.function == Function::LengthCompOff) return;
    constexpr std::size_t kOffset =
        parameter_of_all<"offset", Function::LengthCompOn, Function::LengthCompMinus>();
    const nc::Invocation& invocation = effect.invocation_in(block);
    if (invocation.has(kOffset)) state.length.take_offset(block.argument(invocation, kOffset));
}

/// The changer stands somewhere else and takes the spindle over.
void change_tool(ModalState& state, const nc::Block& block, const nc::Rules& target) {
    state.tool.change();
    state.length.change_tool();
    state.position.lose_all();
    state.drifts.lose_all();
    if (nc::stops_at_tool_change(target, state.changer()))
        state.switch_spindle(Function::SpindleStop, block.source);
}

// ---------------------------------------------------------------- the fold

/// A modal group has another member.
void set_member(ModalState& state, const nc::Block& block, const nc::Effect& effect) {
    const Group group = effect.group();
    const Function before = state[group];
    const bool is_other = before != effect.function;
    state.assume(group, effect.function, block.source);
    switch (group) {
        case Group::Motion: state.owed.owe_motion(false); break;
        case Group::Diameter:
            if (effect.function != Function::DiameterAbsolute)
                set_diameter(state, effect.function == Function::DiameterOn,
                             before != Function::None);
            break;
        case Group::Spindle:
            state.speed.doubt_turning(false);
            state.reported.renew_spindle();
            break;
        case Group::RadiusComp:
            state.compensation.choose(effect.function, block.skip_level, block.source);
            break;
        case Group::FeedMode:
            if (is_other) state.feed.change_mode();
            break;
        case Group::SpeedMode:
            if (is_other) state.speed.forget();
            break;
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

void take(ModalState& state, const nc::Block& block, const nc::Effect& effect,
          const nc::Rules& target) {
    using Kind = nc::EffectKind;
    const SourceId source = block.source;
    const auto change = [&] { return frame_change(block, effect); };
    const auto number = [&](std::size_t parameter) {
        return block.argument(effect.invocation_in(block), parameter);
    };
    switch (effect.kind) {
        case Kind::Sets: set_member(state, block, effect); break;
        case Kind::Shift:
            change_steps(state, source,
                         [said = change()](auto& all) { all.shift(said.values, said.given); });
            state.lost.regain(sema::kFrameBit);  // it replaces all frames
            break;
        case Kind::ShiftAdd:
            change_steps(state, source,
                         [said = change()](auto& all) { all.shift_add(said.values, said.given); });
            break;
        case Kind::Rotate: rotate(state, change(), source, target); break;
        case Kind::Scale: scale(state, change(), source); break;
        case Kind::Mirror:
            change_steps(state, source, [said = change(), &target](auto& all) {
                all.mirror(said.given, target.mirror_replaces);
            });
            break;
        case Kind::RotateOff:
            change_steps(state, source, [](auto& all) { all.rotate_off(); });
            break;
        case Kind::ScaleOff: change_steps(state, source, [](auto& all) { all.scale_off(); }); break;
        case Kind::MirrorOff:
            change_steps(state, source, [axes = effect.invocation_in(block).given](auto& all) {
                all.mirror_off(axes);
            });
            break;
        case Kind::SetPosition: name_position(state, change()); break;
        case Kind::WorkOffset:
            select_work_offset(state, number(parameter_of<Function::WorkOffset>("number")));
            break;
        case Kind::WritesWorkOffset: write_offset(state, block, effect); break;
        case Kind::CorrectsWorkOffset:
            lose_corrected(
                state,
                number(
                    parameter_of_all<"axis", Function::OffsetToEdge, Function::OffsetToMiddle>()));
            break;
        case Kind::TurnsSpindle: turn_spindle(state, block, effect); break;
        case Kind::Tilts:
        case Kind::EndsTiltedPlane:
            state.tilt.choose(effect.kind == Kind::EndsTiltedPlane ? PlaneTilt::None
                              : effect.function == Function::Tilt  ? PlaneTilt::Own
                                                                   : PlaneTilt::Closed);
            lose_system(state);
            state.position.turn(true);  // as the plane before had left the axes
            break;
        case Kind::SwitchesTcp:
            // As a kind of tool length, orienting.cpp handles it.
            if (effect.function == Function::TcpOn) state.tcp.begin();
            if (effect.function == Function::TcpOff) state.tcp.end();
            lose_axes(state, kLinearXYZ);
            break;
        case Kind::TurnsAxes:
            state.position.lose_all_but(kLinearXYZ);
            state.position.turn(true);
            break;
        case Kind::TurnsSystem: lose_system(state); break;
        case Kind::SelectsTool:
            state.tool.call(
                number(parameter_of_all<"tool", Function::ToolSelect, Function::Tool>()));
            break;
        case Kind::ChangesTool: change_tool(state, block, target); break;
        case Kind::ChangesLength: take_length_offset(state, block, effect); break;
        case Kind::LeavesWords: lose_words(state, block, effect); break;
        case Kind::GoesToPoint: go_to_point(state, block, effect); break;
        case Kind::EndsProgram:
            state.has_ended = block.skip_level < 0;
            state.ended_by = source;
            state.reported.renew(ProgramNotice::AfterEnd);
            break;
        case Kind::SelectsLength:
            state.length.take_offset(number(parameter_of<Function::LengthOffset>("offset")));
            break;
        case Kind::SelectsEdge:
        case Kind::WritesLength:
        case Kind::SelectsRadius: break;  // what lengths and radii are, the control knows
        case Kind::RunsCycle: break;      // native_cycles.cpp
        case Kind::Own:
            if (effect.function == Function::SpindleSpeed)
                take_numbered_speed(state, block, effect);
            break;
    }
}

void take_at(ModalState& state, nc::When when, const nc::Block& block, const nc::Rules& target,
             const nc::Effects& effects) {
    if (!effects.has(when)) return;
    for (const nc::Effect& effect : effects)
        if (effect.when == when) take(state, block, effect, target);
}

}  // namespace

ModalState ModalState::at_start(const sema::FunctionCode& entry) {
    ModalState state;
    const auto set = [&](Group group, Function function) { state.assume(group, function); };
    set(Group::Motion, entry.motion);
    state.owed.owe_motion(entry.motion != Function::Rapid);
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
        state.owed.owe_diameter(Function::DiameterOn);
    }
    // Path mode and work offset are whatever the control has, and so is whether X is a diameter: a
    // program that needs one of them programs it.
    return state;
}

bool ModalState::take_functions(const nc::Block& block, const nc::Rules& target) {
    if (block.function_count == 0) {  // nearly all blocks
        if (block.motion != Function::None)
            take(*this, block, nc::Effect::of_motion(block.motion), target);
        return false;
    }
    const nc::Effects effects = effects_of(kLanguage, block, nc::Changer::Magazine);
    const AxisMask before = position.known();
    for (const nc::When when : {nc::When::AtOnce, nc::When::ToolChange, nc::When::BeforeMotion})
        take_at(*this, when, block, target, effects);
    position.note_loss(before, block.source, Loss::Control);
    return effects.has(nc::When::Behind);
}

void ModalState::take_behind(const nc::Block& block, const nc::Rules& target) {
    const AxisMask before = position.known();
    take_at(*this, nc::When::Behind, block, target,
            effects_of(kLanguage, block, nc::Changer::Magazine));
    position.note_loss(before, block.source, Loss::Control);
}

void ModalState::take_block(const nc::Block& block, const nc::Rules& target) {
    const bool owes_behind = take_functions(block, target);
    take_words(block);
    if (owes_behind) take_behind(block, target);
}

void ModalState::take_words(const nc::Block& block) {
    if (block.has(nc::Slot::Feed)) {
        feed.take(block.at(nc::Slot::Feed), block.source);
        lost.regain(sema::kFeedBit);
        if (block.skip_level < 0) lost.settle(sema::kFeedBit);
    }
    if (block.has(nc::Slot::Speed)) take_speed(*this, block.at(nc::Slot::Speed), block);
    if ((block.given & nc::kTargetSlots) != 0) take_targets(*this, block);
}

/// What turns in G18, or has diameters, is the part.
nc::Changer ModalState::changer() const {
    const bool turns = is_diameter || groups[Group::Plane] == Function::PlaneZx;
    return turns ? nc::Changer::Turret : nc::Changer::Magazine;
}

void ModalState::switch_spindle(Function member, SourceId source) {
    groups.set(Group::Spindle, member, source);
    reported.renew_spindle();
}

void ModalState::set_spindle(double code, SourceId source) {
    const Function member = nc::spindle_of_code(code);
    if (member != groups[Group::Spindle]) switch_spindle(member, source);
}

void ModalState::put_frame(const control::ProgramFrame& next, SourceId source) {
    const AxisMask before = position.known();
    frame.write(next);
    set_frame(*this, next, source);
    position.note_loss(before, source, Loss::Control);
}

sema::ModalMask difference(const ModalState& a, const ModalState& b, sema::ModalMask mask) {
    sema::ModalMask result = 0;
    for (std::size_t i = 0; i < nc::kGroups; ++i) {
        const sema::ModalMask bit = sema::ModalMask{1} << i;
        if ((mask & bit) == 0) continue;
        const Function member = a[static_cast<Group>(i)];
        bool differs = member != b[static_cast<Group>(i)];
        if (member == Function::WorkOffset) differs = differs || a.work_offset != b.work_offset;
        if (member == Function::LengthCompOn)
            differs = differs || a.length.offset() != b.length.offset();
        if (differs) result |= bit;
    }
    if ((mask & sema::kFrameBit) != 0 && !(a.frame.now() == b.frame.now()))
        result |= sema::kFrameBit;
    if ((mask & sema::kFeedBit) != 0 && !(a.feed == b.feed)) result |= sema::kFeedBit;
    if ((mask & sema::kSpeedBit) != 0 && !(a.speed == b.speed)) result |= sema::kSpeedBit;
    return result;
}

}  // namespace kadr::expand
