#include "expand/modal.h"

#include "expand/modal_frames.h"
#include "expand/modal_positions.h"
#include "nc/parameters.h"

namespace kadr::expand {

using nc::Function;
using nc::Group;
using nc::parameter_of;
using nc::parameter_of_all;

namespace {

constexpr nc::Rules kLanguage = nc::Rules::of_language();

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
        case Kind::Rotate: rotate_frame(state, change(), source, target); break;
        case Kind::Scale: scale_frame(state, change(), source); break;
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

ModalState ModalState::at_start(const sema::FunctionCode& entry, Function diameter) {
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
    state.is_diameter = entry.has_diameters || diameter == Function::DiameterOn;
    if (entry.has_diameters) {
        set(Group::Diameter, Function::DiameterOn);
        state.owed.owe_diameter(Function::DiameterOn);
    }
    // Path mode and work offset are whatever the control has, and so is whether X is a diameter: a
    // program that needs one of them programs it.
    return state;
}

void ModalState::take_diameter_of_caller(bool needs_diameter) {
    assume(Group::Diameter, Function::None);
    is_diameter = false;
    owed.owe_diameter(needs_diameter ? Function::DiameterOn : Function::None);
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
