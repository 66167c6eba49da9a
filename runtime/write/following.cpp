// What the functions of a block leave behind: the modal state of the text, frames, positions and
// words that wait for their axis.
#include <algorithm>

#include "base/numbers.h"
#include "write/text_state.h"

namespace kadr::write {

void TextState::follow(const Block& block) {
    for (const Effect& effect : effects_of(rules_, block, changer_)) follow_effect(block, effect);
}

/// Whether the tool length acts behind a reference return differs between series of a control: the
/// one that the program has is written again with its axis.
void TextState::defer_length(const Block& block, const Invocation& invocation) {
    constexpr std::size_t kFirstAxis = parameter_of<Function::ReferencePoint>("x");
    for (const Deferred& deferred : tables_.deferred) {
        if (deferred.axis < 0 || !modal_.tool.is_known || modal_.edge.length == 0) continue;
        const auto axis = static_cast<std::size_t>(deferred.axis);
        const bool is_named = invocation.function == Function::ReferencePoint
                                  ? invocation.has(kFirstAxis + axis)
                                  : block.has(static_cast<Slot>(axis));
        if (!is_named) continue;
        std::erase_if(pending_, [&](const Pending& p) { return p.deferred == &deferred; });
        pending_.push_back({&deferred, modal_.edge.length});
    }
}

/// The number of the length behind the words of the block; 0: none.
static double length_behind(const Block& block, const Effect& effect, double before) {
    constexpr std::size_t kOffset = parameter_of<Function::LengthCompOn>("offset");
    static_assert(kOffset == parameter_of<Function::LengthOffset>("offset"));
    if (effect.function == Function::LengthCompOff) return 0;
    const bool is_number =
        effect.function == Function::LengthCompOn || effect.kind == EffectKind::SelectsLength;
    if (!is_number) return before;
    return block.argument(effect.invocation_in(block), kOffset, before);
}

/// What an effect means for positions, frames and held-back words. Groups were followed before the
/// words of the block were made.
void TextState::follow_effect(const Block& block, const Effect& effect) {
    switch (effect.kind) {
        case EffectKind::Sets:
            if (effect.function == Function::CycleOff) forget_motion();
            break;
        case EffectKind::Shift: follow_shift(frame_change(block, effect)); break;
        case EffectKind::ShiftAdd: follow_shift_add(frame_change(block, effect)); break;
        case EffectKind::Rotate:
            modal_.frame.rotation = Activity::Yes;
            turn_axes(view_.plane_axes()[0]);
            turn_axes(view_.plane_axes()[1]);
            break;
        case EffectKind::RotateOff:
            modal_.frame.rotation = Activity::No;
            modal_.frame.turn = {};
            modal_.position.known &= ~modal_.frame.turned;
            break;
        case EffectKind::Scale:
            modal_.frame.scale = Activity::Yes;
            follow_scale(frame_change(block, effect));
            modal_.frame.turned = kTargetSlots;
            modal_.position.forget();
            break;
        case EffectKind::ScaleOff:
            modal_.frame.scale = Activity::No;
            modal_.frame.factors = {1, 1, 1};
            modal_.position.forget();
            break;
        case EffectKind::Mirror: {
            modal_.frame.mirror = Activity::Yes;
            const FrameChange change = frame_change(block, effect);
            for (std::size_t axis = 0; axis < 3; ++axis)
                if (change.given[axis]) turn_axes(axis);
            break;
        }
        case EffectKind::MirrorOff:
            modal_.frame.mirror = Activity::No;
            modal_.position.known &= ~modal_.frame.turned;
            break;
        case EffectKind::SetPosition: name_position(frame_change(block, effect)); break;
        case EffectKind::TurnsSpindle:
            modal_.text[index_of(Group::Spindle)] = Function::None;
            break;
        case EffectKind::Tilts: modal_.frame.tilted = Activity::Yes; [[fallthrough]];
        case EffectKind::TurnsSystem: forget_unsaid(block); break;
        case EffectKind::WorkOffset: {
            constexpr std::size_t kNumber = parameter_of<Function::WorkOffset>("number");
            forget_unsaid(block);
            modal_.work_offset = {true, block.argument(effect.invocation_in(block), kNumber)};
            modal_.text.work_offset = modal_.work_offset.value;
            break;
        }
        case EffectKind::EndsTiltedPlane: end_tilted_plane(block, effect); break;
        case EffectKind::WritesWorkOffset:
        case EffectKind::CorrectsWorkOffset: modal_.position.forget(); break;
        case EffectKind::SwitchesTcp:
            if (effect.group() == Group::LengthComp) drop_pending_length();
            modal_.position.forget();
            break;
        case EffectKind::TurnsAxes:
            modal_.position.known &= bit(Slot::X) | bit(Slot::Y) | bit(Slot::Z);
            break;
        case EffectKind::SelectsTool:
            // The word of a turret may have an offset, too: lengths in the plane.
            if (effect.function == Function::ToolSelect) modal_.position.forget();
            break;
        case EffectKind::ChangesTool: call_tool(block, effect); break;
        case EffectKind::SelectsEdge: call_edge(block, effect); break;
        case EffectKind::ChangesLength: drop_pending_length(); [[fallthrough]];
        case EffectKind::SelectsLength:
            modal_.edge.length = length_behind(block, effect, modal_.edge.length);
            [[fallthrough]];
        case EffectKind::WritesLength: change_length(block); break;
        case EffectKind::SelectsRadius:
            std::erase_if(pending_, [](const Pending& p) { return p.deferred->axis < 0; });
            break;
        case EffectKind::LeavesWords: forget_words(block, effect); break;
        case EffectKind::GoesToPoint:
            defer_length(block, effect.invocation_in(block));
            modal_.position.forget();
            break;
        case EffectKind::RunsCycle: forget_motion(); break;
        case EffectKind::EndsProgram: has_ended_ = true; break;
        case EffectKind::Own:
            // Whose speed it is, the master at that time decides.
            if (effect.function == Function::SpindleSpeed) modal_.speed.is_known = false;
            break;
    }
}

void TextState::drop_pending_length() {
    modal_.edge.is_end_due = false;
    std::erase_if(pending_, [](const Pending& p) { return p.deferred->axis >= 0; });
}

void TextState::follow_shift_add(const FrameChange& change) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (change.values[axis] == 0) continue;
        modal_.frame.origin[axis].is_known = false;
        modal_.position.known &= ~bit(static_cast<Slot>(axis));
    }
}

/// The tool stays where it is, and its coordinates have other numbers.
void TextState::name_position(const FrameChange& change) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!change.given[axis]) continue;
        const auto slot = static_cast<Slot>(axis);
        const double scale = view_.to_text(slot, 1);
        modal_.position.meant[axis] = change.values[axis];
        modal_.position.text[axis] =
            round_to(change.values[axis] * scale, view_.decimals(slot)) / scale;
        modal_.position.known |= bit(slot);
    }
}

/// What ends a rotation ends a tilted plane on some controls: where none acts, nothing else is new.
void TextState::end_tilted_plane(const Block& block, const Effect& effect) {
    if (effect.function != Function::RotateOff || modal_.frame.tilted != Activity::No) {
        modal_.frame.tilt = {};
        forget_unsaid(block);
    }
    modal_.frame.tilted = Activity::No;
}

/// An operator may start again here: numbers that act are written again by whoever needs them.
static void begin_section(WriterModal& modal, Function speed_mode_at_power_on, bool is_shifted) {
    modal.speed.is_known = modal.feed.is_known = false;
    modal.feed_is_other = modal.has_meant_feed;
    Function& mode = modal.text[index_of(Group::SpeedMode)];
    modal.has_cutting_speed |= mode != speed_mode_at_power_on && mode != Function::None;
    if (modal.has_cutting_speed) mode = Function::None;
    if (!is_shifted) return;
    for (NumberInForce& shift : modal.frame.shift) shift.is_known = false;
}

/// Another tool comes into the spindle. A turret only turns: no modal code is in doubt behind it.
void TextState::call_tool(const Block& block, const Effect& effect) {
    if (effect.function == Function::ToolSelect) return;
    forget_motion();
    modal_.tool.is_known = effect.function == Function::Tool;
    if (modal_.tool.is_known) {
        modal_.tool.value =
            block.argument(effect.invocation_in(block), parameter_of<Function::Tool>("tool"));
        for (const Deferred& deferred : tables_.deferred) {
            std::erase_if(pending_, [&](const Pending& p) { return p.deferred == &deferred; });
            pending_.push_back({&deferred, modal_.tool.value});
        }
        modal_.edge.length = modal_.tool.value;
    }
    if (!tables_.program.section.empty())
        begin_section(modal_, tables_.power_on[index_of(Group::SpeedMode)],
                      view_.is_shifted() == Activity::Yes);
    modal_.edge.number = {true, 1};
    modal_.edge.is_lost = false;
    modal_.edge.is_end_due = false;
    // Behind a move without length the new one is not travelled yet, either.
    modal_.edge.is_length_due = modal_.edge.is_length_due || modal_.edge.waiting != 0;
    modal_.edge.waiting = 0;
    leave_changer();
}

void TextState::call_edge(const Block& block, const Effect& effect) {
    modal_.edge.number = {true, block.argument(effect.invocation_in(block),
                                               parameter_of<Function::ToolEdge>("edge"))};
    modal_.edge.is_lost = false;
    modal_.edge.waiting = 0;
    modal_.edge.is_length_due = false;
    change_length(block);
}

/// Where the block has brought its axes only the control knows.
void TextState::forget_words(const Block& block, const Effect& effect) {
    if (effect.function == Function::Probe) forget_motion();  // its code is a motion of its own
    modal_.position.known &= ~block.given;
    if (effect.function != Function::MachineCoordinates) return;
    // In machine coordinates one axis moves: along a rotated system several coordinates change.
    constexpr SlotMask kLinear = bit(Slot::X) | bit(Slot::Y) | bit(Slot::Z);
    const bool is_plane_tilted =
        modal_.frame.tilted != Activity::No && (block.given & kLinear) != 0;
    const bool is_turned = modal_.frame.rotation != Activity::No &&
                           (block.given & modal_.frame.turned & kTargetSlots) != 0;
    if (is_turned) modal_.position.known &= ~modal_.frame.turned;
    if (is_plane_tilted) modal_.position.known &= ~kLinear;
}

/// Another zero point: the axes that the block itself does not bring to a coordinate have others.
void TextState::forget_unsaid(const Block& block) {
    SlotMask programmed = block.given & kTargetSlots;
    for (std::size_t axis = 0; axis < kAxes; ++axis)
        if (view_.is_distance(block, axis))
            programmed &= static_cast<SlotMask>(~bit(static_cast<Slot>(axis)));
    const SlotMask known = modal_.position.known;
    modal_.position.forget();
    modal_.position.known = known & programmed;
}

/// Another length along the tool: its axis is elsewhere in the program's coordinates, if the block
/// does not give where it goes. The others stand where they stood, but are written again: some
/// tools have lengths along them, too.
void TextState::change_length(const Block& block) {
    if (modal_.meant_of(Group::Plane) != Function::PlaneXy) return modal_.position.forget();
    constexpr auto kTool = static_cast<std::size_t>(Slot::Z);
    const bool is_given = block.has(Slot::Z) && !view_.is_distance(block, kTool);
    if (!is_given) modal_.position.known &= ~bit(Slot::Z);
    modal_.position.written |= modal_.position.known & ~(is_given ? bit(Slot::Z) : 0);
}

/// Where a tool change leaves the tool: elsewhere along its axis, and in the plane where it stood,
/// if the builder of the changer does not choose otherwise. A turret's tools have lengths in the
/// plane.
void TextState::leave_changer() {
    WrittenPosition& position = modal_.position;
    if (rules_.tool_change_moves_plane || modal_.meant_of(Group::Plane) != Function::PlaneXy)
        return position.forget();
    position.known &= bit(Slot::X) | bit(Slot::Y);
    position.written = position.known;
}

/// Which motion is modal behind a cycle or a tool change is the control's or its builder's choice,
/// and an operator who starts there wants to read it: the next motion writes it again.
void TextState::come_back(const WrittenPosition& position) {
    modal_.position = position;
    forget_motion();
}

void TextState::forget_motion() { modal_.text[index_of(Group::Motion)] = Function::None; }

/// A rotation or mirroring acts on the axis; its coordinate is another one now.
void TextState::turn_axes(std::size_t axis) {
    const SlotMask mask = bit(static_cast<Slot>(axis));
    modal_.frame.turned |= mask;
    modal_.position.known &= ~mask;
}

/// Its factors are multiplied with those that act, where a second one does not replace the first.
void TextState::follow_scale(const FrameChange& change) {
    for (std::size_t axis = 0; axis < modal_.frame.factors.size(); ++axis) {
        const double factor = change.factors[axis];
        modal_.frame.factors[axis] =
            rules_.scale_replaces ? factor : modal_.frame.factors[axis] * factor;
    }
}

/// A shift replaces all of the programmable frame. Axes whose share in it does not change stay
/// where they are. Of the others the coordinate could be worked out, but an incremental word behind
/// it counts from the old one on some controls; and X may be a diameter.
void TextState::follow_shift(const FrameChange& change) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const SlotMask mask = bit(static_cast<Slot>(axis));
        const double shift = change.values[axis];
        NumberInForce& origin = modal_.frame.origin[axis];
        const bool stays =
            (modal_.frame.turned & mask) == 0 && origin.is_known && origin.value == shift;
        if (!stays) modal_.position.known &= ~mask;
        origin = {true, shift};
    }
    modal_.frame.rotation = modal_.frame.mirror = modal_.frame.scale = Activity::No;
    modal_.frame.is_refused = false;
    modal_.frame.factors = {1, 1, 1};
    modal_.frame.turned = 0;
}

}  // namespace kadr::write
