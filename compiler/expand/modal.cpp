#include "expand/modal.h"

#include <algorithm>
#include <cmath>

#include "expand/plane.h"
#include "nc/parameters.h"

namespace kadr::expand {

using nc::Function;
using nc::Group;
using nc::parameter_of;
using nc::parameter_of_all;

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
    // program that needs one of them says so.
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
    // Where a program turns and does not say whether its X is a diameter, the control knows alone
    // what a frame makes of it.
    const bool may_be_diameter =
        (*this)[Group::Diameter] == Function::None && (*this)[Group::Plane] == Function::PlaneZx;
    if (may_be_diameter && next.differs(frame, 0)) known &= static_cast<AxisMask>(~bit(Axis::X));
    is_place_due = true;
    // A control that has its rotation innermost says it again behind every other change.
    const bool turns = next.angle_deg != 0 || frame.angle_deg != 0;
    if (turns && next != frame) unplaced |= (next.angle_deg != 0 ? next : frame).plane_mask();
    frame = next;
    is_stretched = next.scale[0] != next.scale[1] || next.scale[1] != next.scale[2];
    frame_by = source;
}

void ModalState::note_drift(std::size_t axis, bool is_known, double by) {
    constexpr double kRounding = 1e-9;  // mm: what a frame and its end leave of a coordinate
    const auto bit = static_cast<AxisMask>(1u << axis);
    // Frames move X by its radius.
    if (!is_known || (axis == 0 && is_diameter)) lost_drift |= bit;
    drift[axis] += by;
    if (std::fabs(drift[axis]) < kRounding) drift[axis] = 0;
    has_drift = static_cast<AxisMask>(drift[axis] != 0 ? has_drift | bit : has_drift & ~bit);
}

void ModalState::forget_drift(AxisMask axes) {
    for (std::size_t i = 0; i < kAxes; ++i) {
        if ((axes >> i & 1u) != 0) drift[i] = 0;
    }
    has_drift &= static_cast<AxisMask>(~axes);
    lost_drift &= static_cast<AxisMask>(~axes);
    unplaced &= static_cast<AxisMask>(~axes);
}

void ModalState::set_position(const nc::Block& block, const nc::Invocation& invocation) {
    constexpr std::size_t kX = parameter_of<Function::SetPosition>("x");
    for (std::size_t i = 0; i < 3; ++i) {
        if (!invocation.has(kX + i)) continue;
        position[i] = block.argument(invocation, kX + i);
        known = static_cast<AxisMask>(known | 1u << i);
    }
}

/// The tool stays where it is; its X is another number then.
void ModalState::set_diameter(bool is_on) {
    if ((*this)[Group::Diameter] == Function::None) known &= static_cast<AxisMask>(~1u);
    else if (is_on != is_diameter) position[0] *= is_on ? 2 : 0.5;
    is_diameter = is_on;
    diameter_due = Function::None;
    lost_drift |= has_drift & 1u;
}

/// The zero point moves along one axis (1 is X), in a frame that turns along some.
void ModalState::lose_corrected(double axis) {
    const bool is_one = frame.is_shift() && axis >= 1 && axis <= 3;
    known &= is_one ? static_cast<AxisMask>(~(1u << (static_cast<unsigned>(axis) - 1u)))
                    : static_cast<AxisMask>(~kLinearXYZ);
}

void ModalState::say_frame(const control::ProgramFrame& next, SourceId source) {
    steps.say(next);
    said_steps = steps;
    set_frame(next, source);
}

namespace {

constexpr std::size_t kX =
    parameter_of_all<"x", Function::Shift, Function::ShiftAdd, Function::Mirror>();
constexpr std::size_t kAngle = parameter_of<Function::Rotate>("angle");
constexpr std::size_t kCenter = parameter_of_all<"x", Function::Rotate, Function::Scale>();
constexpr std::size_t kOfAll = parameter_of<Function::Scale>("factor");
constexpr std::size_t kOfX = parameter_of<Function::Scale>("fx");

/// Three arguments from one on.
std::array<double, 3> three_of(const nc::Block& block, const nc::Invocation& invocation,
                               std::size_t first, double fallback = 0) {
    return {block.argument(invocation, first, fallback),
            block.argument(invocation, first + 1, fallback),
            block.argument(invocation, first + 2, fallback)};
}

std::array<double, 3> factors_of(const nc::Block& block, const nc::Invocation& scale) {
    return three_of(block, scale, kOfX, block.argument(scale, kOfAll, 1));
}

/// What a function that stands in the text does to a frame; false: nothing. Factors that are none
/// leave it to the control's alarm.
bool add_step(control::FrameSteps& steps, const nc::Block& block, const nc::Invocation& invocation,
              Function plane) {
    const std::array<double, 3> values = three_of(block, invocation, kX);
    const std::array<bool, 3> given{invocation.has(kX), invocation.has(kX + 1),
                                    invocation.has(kX + 2)};
    switch (invocation.function) {
        case Function::Shift: steps.shift(values, given); return true;
        case Function::ShiftAdd: steps.shift_add(values, given); return true;
        case Function::Rotate:
            steps.rotate(block.argument(invocation, kAngle), plane,
                         three_of(block, invocation, kCenter));
            return true;
        case Function::Scale:
            steps.scale(factors_of(block, invocation), three_of(block, invocation, kCenter));
            return true;
        case Function::Mirror: steps.mirror(given); return true;
        case Function::RotateOff: steps.rotate_off(); return true;
        case Function::ScaleOff: steps.scale_off(); return true;
        case Function::MirrorOff: steps.mirror_off(invocation.given); return true;
        default: return false;
    }
}

/// A factor that is none is the control's alarm, or a mirror.
bool has_wrong_factor(const nc::Block& block, const nc::Invocation& invocation) {
    return invocation.function == Function::Scale &&
           std::ranges::any_of(factors_of(block, invocation),
                               [](double factor) { return !(factor > 0); });
}

}  // namespace

/// False: the function is none of frames.
bool ModalState::take_frame(const nc::Block& block, const nc::Invocation& invocation) {
    if (has_wrong_factor(block, invocation)) {
        known &= static_cast<AxisMask>(~kLinearXYZ);
        return true;
    }
    if (!add_step(steps, block, invocation, (*this)[Group::Plane])) return false;
    if (rotates_outside_scale && invocation.function == Function::Rotate) {
        said_steps.rotate_scaled(block.argument(invocation, kAngle), (*this)[Group::Plane],
                                 three_of(block, invocation, kCenter));
    } else {
        add_step(said_steps, block, invocation, (*this)[Group::Plane]);
    }
    const auto [next, fault] = steps.frame();
    if (fault != control::FrameFault::None) known &= static_cast<AxisMask>(~kLinearXYZ);
    set_frame(next, block.source);
    if (invocation.function == Function::Shift) lost &= ~sema::kFrameBit;  // it replaces all frames
    return true;
}

void ModalState::take(const nc::Block& block, const nc::Invocation& invocation) {
    if (take_frame(block, invocation)) return;
    switch (invocation.function) {
        case Function::ReferencePoint:
            forget_drift(static_cast<AxisMask>(
                invocation.given >> parameter_of<Function::ReferencePoint>("x") & kLinearXYZ));
            known = 0;
            return;
        case Function::ReferenceReturn: known = 0; return;
        case Function::Tilt:
        case Function::TiltEuler:
        case Function::TiltAlign:
        case Function::TiltOff:  // another system, and the control alone knows where its axes go
            known = 0;
            lost_drift = static_cast<AxisMask>((1u << kAxes) - 1u);
            is_turned = true;
            return;
        case Function::TcpOn:
        case Function::TcpBased:
        case Function::TcpOff:
        case Function::TcpLength:
        case Function::TcpVector:  // the tip in the workpiece has other coordinates than the axes
            known &= static_cast<AxisMask>(~kLinearXYZ);
            lost_drift |= kLinearXYZ;
            break;
        case Function::OffsetToEdge:
        case Function::OffsetToMiddle: {
            constexpr std::size_t kAxis =
                parameter_of_all<"axis", Function::OffsetToEdge, Function::OffsetToMiddle>();
            lose_corrected(block.argument(invocation, kAxis));
            return;
        }
        case Function::SetPosition: set_position(block, invocation); return;
        case Function::DiameterOn:
        case Function::DiameterOff:
            set_diameter(invocation.function == Function::DiameterOn);
            break;
        case Function::WorkOffset: {
            const double number =
                block.argument(invocation, parameter_of<Function::WorkOffset>("number"));
            if ((*this)[Group::WorkOffsets] != Function::WorkOffset || work_offset != number) {
                known = 0;
                lost_drift = static_cast<AxisMask>((1u << kAxes) - 1u);
            }
            work_offset = number;
            due_offset = 0;
            break;
        }
        case Function::LengthCompOn: {
            constexpr std::size_t kOffset = parameter_of<Function::LengthCompOn>("offset");
            has_length_offset = invocation.has(kOffset);
            length_offset = block.argument(invocation, kOffset);
            break;
        }
        case Function::Tool:
            has_tool = has_tool_in = true;
            lacks_tool = false;
            tool = tool_in = block.argument(invocation, parameter_of<Function::Tool>("tool"));
            known = 0;  // the changer stands somewhere else
            change_tool(block.source);
            lost_drift |= has_drift;
            return;
        case Function::ToolSelect:
            has_tool = true;
            tool = block.argument(invocation, parameter_of<Function::ToolSelect>("tool"));
            return;
        case Function::ToolChange: {
            lacks_tool = false;
            const nc::Invocation* select = block.find(Function::ToolSelect);
            has_tool_in = has_tool || select != nullptr;
            tool_in = select != nullptr
                          ? block.argument(*select, parameter_of<Function::ToolSelect>("tool"))
                          : tool;
            known = 0;
            lost_drift |= has_drift;
            change_tool(block.source);
            return;
        }
        case Function::End:
        case Function::EndRewind:
            has_ended = block.skip < 0;
            ended_by = block.source;
            return;
        default: break;
    }
    const Group group = nc::info(invocation.function).group;
    if (group == Group::Once) return;
    Function& member = active[static_cast<std::size_t>(group)];
    lost &= ~sema::group_bit(group);
    if (group == Group::Spindle) spindle_in_doubt = false;
    if (group == Group::RadiusComp)
        choose_compensation(invocation.function, block.skip, block.source);
    if (group == Group::FeedMode && member != invocation.function) {
        is_feed_lost |= has_feed;
        has_feed = false;
    }
    if (group == Group::SpeedMode && member != invocation.function) has_speed = false;
    member = invocation.function;
    changed_by[static_cast<std::size_t>(group)] = block.source;
    if (group == Group::Spindle) warned_of_spindle = warned_of_rapid = false;
}

/// Follows what acts if the operator leaves out the blocks that he may, beside what acts if not.
///
/// skip         level of the block that says the compensation or its end; -1 none
void ModalState::choose_compensation(Function side, int skip, SourceId source) {
    if (skip < 0) {
        comp_without = side;
        comp_choice = kNoChoice;
        return;
    }
    if (comp_choice != kNoChoice && comp_choice != skip) comp_choice = kSeveralLevels;
    else comp_choice = side == comp_without ? kNoChoice : skip;
    comp_by = source;
}

void ModalState::switch_spindle(Function member, SourceId source) {
    active[static_cast<std::size_t>(Group::Spindle)] = member;
    changed_by[static_cast<std::size_t>(Group::Spindle)] = source;
    warned_of_spindle = warned_of_rapid = false;
}

void ModalState::set_spindle(double code, SourceId source) {
    const Function member = code == 3   ? Function::SpindleCw
                            : code == 4 ? Function::SpindleCcw
                                        : Function::SpindleStop;
    if (member != (*this)[Group::Spindle]) switch_spindle(member, source);
}

/// The changer takes the spindle over. A turret does not: what turns in G18 is the part.
void ModalState::change_tool(SourceId source) {
    if (!stops_at_tool_change || (*this)[Group::Plane] == Function::PlaneZx) return;
    switch_spindle(Function::SpindleStop, source);
}

void ModalState::take_functions(const nc::Block& block) {
    if (block.motion != Function::None) {
        active[static_cast<std::size_t>(Group::Motion)] = block.motion;
        changed_by[static_cast<std::size_t>(Group::Motion)] = block.source;
        restate_motion = false;
        lost &= ~sema::group_bit(Group::Motion);
    }
    for (std::size_t i = 0; i < block.function_count; ++i) take(block, block.functions[i]);
}

void ModalState::take_words(const nc::Block& block) {
    if (block.has(nc::Slot::Feed)) {
        feed = block.at(nc::Slot::Feed);
        has_feed = true;
        is_feed_lost = false;
        is_feed_deleted = false;
        feed_by = block.source;
        lost &= ~sema::kFeedBit;
        if (block.skip < 0) restate &= ~sema::kFeedBit;
    }
    if (block.has(nc::Slot::Speed)) {
        speed = block.at(nc::Slot::Speed);
        has_speed = true;
        lacks_speed = false;
        had_cutting_speed |= (*this)[Group::SpeedMode] == Function::CuttingSpeedOn;
        speed_by = block.source;
        lost &= ~sema::kSpeedBit;
        if (block.skip < 0) restate &= ~sema::kSpeedBit;
    }
    nc::SlotMask targets = block.given & nc::kTargetSlots;
    if (targets == 0) return;
    if ((targets & (bit(Axis::A) | bit(Axis::B) | bit(Axis::C))) != 0) note_rotary(block);
    // The operator may leave the block out: then they have gone nowhere.
    if (block.skip >= 0) lost_drift |= has_drift & static_cast<AxisMask>(targets);
    else if ((has_drift | lost_drift | unplaced) != 0) forget_drift(static_cast<AxisMask>(targets));
    const PlaneIndices axes = indices_of(plane_of((*this)[Group::Plane]));
    if (((targets >> axes.first | targets >> axes.second) & 1u) != 0) {
        const bool is_doubtful = block.skip >= 0 && is_compensation_due();
        moved_under = is_doubtful ? Function::None : (*this)[Group::RadiusComp];
    }
    const bool modal_incremental = (*this)[Group::Distance] == Function::Incremental;
    const bool says_machine =
        block.function_count > 0 && block.find(Function::MachineCoordinates) != nullptr;
    const bool is_machine = says_machine || (block.function_count > 0 &&
                                             block.find(Function::ReferenceReturn) != nullptr);
    // Where the probe triggers, only the control knows.
    const bool probes = block.function_count > 0 && block.find(Function::Probe) != nullptr;
    for (std::size_t i = 0; targets != 0; ++i, targets >>= 1) {
        if ((targets & 1u) == 0) continue;
        const nc::SlotMask bit = nc::SlotMask{1} << i;
        if (is_machine || probes) {
            // The control may count an increment from the number that was said there.
            if (says_machine) lost_drift = static_cast<AxisMask>(lost_drift | bit);
            known = static_cast<AxisMask>(known & ~bit);
            continue;
        }
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
            differs = differs || a.has_length_offset != b.has_length_offset ||
                      a.length_offset != b.length_offset;
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
