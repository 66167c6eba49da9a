// modal_loss.cpp — how modal state becomes unknown: behind raw text, behind a block that the
// operator may leave out.
#include "expand/modal.h"

namespace kadr::expand {

using nc::Function;
using nc::Group;
using sema::group_bit;

namespace {

void lose_to_choice(ModalState& state, sema::ModalMask what, SourceId block) {
    state.lost.lose(what, block, Loss::SkippedBlock);
}

/// A group whose member is the operator's choice.
void join_group(ModalState& state, Group group, SourceId block) {
    switch (group) {
        case Group::FeedMode:
            state.lost.write_again(group_bit(group));
            if (!state.feed.is_known()) lose_to_choice(state, sema::kFeedBit, block);
            break;
        case Group::SpeedMode:
            state.lost.write_again(group_bit(group));
            if (!state.speed.is_known()) lose_to_choice(state, sema::kSpeedBit, block);
            break;
        case Group::Spindle:
        case Group::Coolant:
            // To write it again would take the choice away.
            state.groups.assume(group, Function::None);
            lose_to_choice(state, group_bit(group), block);
            if (group != Group::Spindle) break;
            state.speed.doubt_turning(true);
            state.reported.renew(ProgramNotice::SpindleInDoubt);
            break;
        case Group::Diameter: state.owed.owe_diameter(state[group]); break;
        default: break;  // written again by the writer
    }
}

}  // namespace

void ModalState::forget(SourceId source) {
    const AxisMask before = position.known();
    position.lose_all();
    position.note_loss(before, source, Loss::RawText);
    // What X of the program is does not change by that: the text writes it again.
    const Function diameter = groups[Group::Diameter];
    groups.forget_all();
    feed.forget_all();
    speed.forget_all();
    tool.forget_all();
    length.forget();
    drifts.lose_all();
    owed.owe_motion(false);
    compensation.forget_choice();
    has_ended = false;
    sema::ModalMask all = sema::kFrameBit | sema::kFeedBit | sema::kSpeedBit;
    for (std::size_t i = 0; i < nc::kGroups; ++i) all |= group_bit(static_cast<Group>(i));
    lost.settle(lost.restate());
    lost.lose(all, source, Loss::RawText);
    if (diameter == Function::None) return;
    groups.assume(Group::Diameter, diameter);
    owed.owe_diameter(diameter);
    lost.regain(group_bit(Group::Diameter));
}

void ModalState::forget_feed(SourceId source) {
    feed.forget();
    lost.lose(sema::kFeedBit, source, Loss::EndOfWith);
}

void ModalState::join(const ModalState& without, SourceId block) {
    // The tool may stand as it did; what was unknown of the drift stays so (take_words).
    position.join(without.position);
    position.note_loss(without.position.known(), block, Loss::SkippedBlock);
    tcp.join(without.tcp);
    tool.join(without.tool);
    length.join(without.length);
    if (speed.master() != without.speed.master()) speed.make_master(0);
    if (!(feed == without.feed)) lost.write_again(sema::kFeedBit);
    if (!(speed == without.speed)) lost.write_again(sema::kSpeedBit);
    for (std::size_t i = 0; i < nc::kGroups; ++i) {
        const auto group = static_cast<Group>(i);
        if (groups[group] != without.groups[group]) join_group(*this, group, block);
    }
}

}  // namespace kadr::expand
