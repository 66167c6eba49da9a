#include "expand/modal_positions.h"

#include "expand/plane.h"
#include "nc/parameters.h"

namespace kadr::expand {

using nc::Function;
using nc::Group;
using nc::parameter_of;

namespace {

bool is_turned_system(const ModalState& state) {
    return state.frame.now().angle_deg != 0 || state.tilt.acts();
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

}  // namespace

void name_position(ModalState& state, const nc::FrameChange& change) {
    for (std::size_t i = 0; i < 3; ++i)
        if (change.given[i]) state.position.set(i, change.values[i]);
}

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

void lose_system(ModalState& state) { lose_axes(state, kAllAxes); }

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

}  // namespace kadr::expand
