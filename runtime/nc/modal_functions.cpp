#include "nc/modal_functions.h"

#include "nc/effects.h"

namespace kadr::nc {

namespace {

Function& member_of(ModalFunctions& modal, Group group) {
    return modal[static_cast<std::size_t>(group)];
}

void follow_effect(const Block& block, const Effect& effect, ModalFunctions& modal) {
    switch (effect.kind) {
        case EffectKind::Sets: member_of(modal, effect.group()) = effect.function; break;
        case EffectKind::RunsCycle:
            member_of(modal, Group::CycleMode) = Function::Cycle;
            modal.cycle = block.cycle;
            break;
        case EffectKind::WorkOffset: {
            const Invocation* const said = block.find(Function::WorkOffset);
            constexpr std::size_t kNumber = parameter_of<Function::WorkOffset>("number");
            modal.work_offset = said == nullptr ? -1 : block.argument(*said, kNumber, -1);
            break;
        }
        case EffectKind::Shift:
        case EffectKind::ShiftAdd:
        case EffectKind::Rotate:
        case EffectKind::Scale:
        case EffectKind::Mirror:
        case EffectKind::RotateOff:
        case EffectKind::ScaleOff:
        case EffectKind::MirrorOff:
        case EffectKind::SetPosition:
        case EffectKind::WritesWorkOffset:
        case EffectKind::CorrectsWorkOffset:
        case EffectKind::WritesLength:
        case EffectKind::TurnsSpindle:
        case EffectKind::Tilts:
        case EffectKind::EndsTiltedPlane:
        case EffectKind::SwitchesTcp:
        case EffectKind::TurnsAxes:
        case EffectKind::TurnsSystem:
        case EffectKind::SelectsTool:
        case EffectKind::ChangesTool:
        case EffectKind::SelectsEdge:
        case EffectKind::ChangesLength:
        case EffectKind::SelectsLength:
        case EffectKind::SelectsRadius:
        case EffectKind::LeavesWords:
        case EffectKind::GoesToPoint:
        case EffectKind::EndsProgram:
        case EffectKind::Own: break;  // where the tool is no line depends on
    }
}

}  // namespace

void follow_modal(const Rules& rules, const Block& block, ModalFunctions& modal) {
    if (ends_modal_cycle(block)) member_of(modal, Group::CycleMode) = Function::CycleOff;
    if (block.function_count == 0) {  // nearly all blocks
        if (block.motion != Function::None)
            follow_effect(block, Effect::of_motion(block.motion), modal);
        return;
    }
    // Where the tools stand is no matter of a group.
    for (const Effect& effect : effects_of(rules, block, Changer::Magazine))
        follow_effect(block, effect, modal);
}

}  // namespace kadr::nc
