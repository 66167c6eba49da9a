// scopes.cpp — what `with` sets back, what a cycle needs and preserves, and its cutter.

#include <cmath>
#include <string>

#include "base/diagnostics/expand.h"
#include "expand/cutters.h"
#include "expand/state.h"
#include "nc/program_head.h"
#include "nc/tables.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using nc::Group;

Done Expander::State::leave_with(SourceId source, std::uint32_t at, unsigned depth) {
    const OpenWith scope = withs.back();
    withs.pop_back();
    return set_back(scope, source, at, depth);
}

/// Where no work offset is programmed, that of the text's head acts.
void Expander::State::take_offset_of_head(ModalState& state) const {
    const bool is_lost = (state.lost & sema::group_bit(Group::WorkOffsets)) != 0;
    if (is_lost || state[Group::WorkOffsets] != Function::None || state.due_offset != 0) return;
    const std::optional<int> offset = nc::offset_of_head(target);
    if (!offset) return;
    state.assume(Group::WorkOffsets, Function::WorkOffset);
    state.work_offset = *offset;
}

Done Expander::State::set_back(const OpenWith& scope, SourceId source, std::uint32_t at,
                               unsigned depth) {
    ModalState before = scope.before;
    take_offset_of_head(before);
    const sema::ModalMask transformation = sema::group_bit(Group::Transformation);
    if ((scope.mask & transformation) != 0 && !set_back_tcp(before, source, at, depth))
        return kFailed;
    if ((scope.mask & sema::kFrameBit) != 0) {
        if (modal.tcp == ModalState::Tcp::Length && !(before.frame == modal.frame))
            return refuse_under_tcp("the end of a frame", at);
        write_frame(before.frame, source, at, depth);
        if (has_failed) return kFailed;
        modal.steps = before.steps;
    }
    // Another feed mode forgets F, so F goes back with it.
    sema::ModalMask mask = scope.mask & ~transformation;
    if ((mask & sema::group_bit(Group::FeedMode)) != 0) mask |= sema::kFeedBit;
    if ((mask & sema::group_bit(Group::SpeedMode)) != 0) mask |= sema::kSpeedBit;
    const sema::ModalMask changed = difference(before, modal, mask) & ~sema::kFrameBit;
    if (changed == 0) return kDone;
    for (std::size_t i = 0; i < nc::kGroups; ++i) {
        if ((changed >> i & 1u) == 0 || before[static_cast<Group>(i)] != Function::None) continue;
        fault(diag::StateUnknown, at).arg(nc::group_name(static_cast<Group>(i)));
        return kFailed;
    }
    // Behind a `with` that set the first F there is none, and none there is behind this one.
    const sema::ModalMask no_value = before.lost_in == Loss::EndOfWith ? sema::kFeedBit : 0;
    const sema::ModalMask values =
        changed & before.lost & ~no_value & (sema::kFeedBit | sema::kSpeedBit);
    if (values != 0) {
        fault(diag::StateUnknown, at).arg((values & sema::kFeedBit) != 0 ? "F" : "S");
        return kFailed;
    }
    if ((changed & sema::kFeedBit) != 0 && !before.has_feed) modal.forget_feed(source);
    // The same number means something else in another mode, so it goes back with the mode.
    const sema::ModalMask of_feed = sema::kFeedBit | sema::group_bit(Group::FeedMode);
    const sema::ModalMask of_speed = sema::kSpeedBit | sema::group_bit(Group::SpeedMode);
    const bool feed = (changed & of_feed) != 0 && before.has_feed;
    const bool speed = (changed & of_speed) != 0 && before.has_speed;
    const bool groups = (changed & ~(sema::kFeedBit | sema::kSpeedBit)) != 0;
    if (!groups && !feed && !speed) return kDone;
    if (!require_room(at)) return kFailed;
    Block& block = next_block(source);
    block.length_waits = true;
    for (std::size_t i = 0; i < nc::kGroups; ++i) {
        if ((changed >> i & 1u) == 0) continue;
        const Function member = before[static_cast<Group>(i)];
        if (static_cast<Group>(i) == Group::Motion) {
            block.motion = member;
            continue;
        }
        const std::size_t parameters = nc::info(member).parameters.size();
        nc::Invocation* invocation = block.add(member, parameters);
        if (member == Function::WorkOffset) {
            block.set_argument(*invocation, nc::parameter_of<Function::WorkOffset>("number"),
                               before.work_offset);
        }
        if (member == Function::LengthCompOn && before.length.offset) {
            block.set_argument(*invocation, nc::parameter_of<Function::LengthCompOn>("offset"),
                               *before.length.offset);
        }
    }
    if (feed) block.set(nc::Slot::Feed, before.feed);
    if (speed) block.set(nc::Slot::Speed, before.speed);
    if ((changed & sema::group_bit(Group::LengthComp)) != 0 && !take_core_offsets(block, at))
        return kFailed;
    modal.take_block(block, target.rules());
    if (options.trace) keep_trace(at, depth, source);
    return kDone;
}

namespace {

/// How a program names what a cycle preserves: `preserves G90, DIAMOF`.
std::string_view word_of_need(Function needed) {
    switch (needed) {
        case Function::Absolute: return "G90";
        case Function::Incremental: return "G91";
        case Function::PlaneXy: return "G17";
        case Function::PlaneZx: return "G18";
        case Function::PlaneYz: return "G19";
        case Function::RadiusCompOff: return "G40";
        case Function::FeedPerMinute: return "G94";
        case Function::FeedPerRevolution: return "G95";
        case Function::FeedInverseTime: return "G93";
        case Function::CuttingSpeedOn: return "G96";
        case Function::CuttingSpeedOff: return "G97";
        case Function::DiameterOn: return "DIAMON";
        case Function::DiameterOff: return "DIAMOF";
        default: return nc::info(needed).name;
    }
}

/// The words of all that the cycle needs and that is not known.
std::string lost_needs(const sema::FunctionCode& cycle, sema::ModalMask lost) {
    std::string words;
    for (const Function needed : cycle.needs) {
        if ((lost & sema::group_bit(nc::info(needed).group)) == 0) continue;
        if (!words.empty()) words += ' ';
        words += word_of_need(needed);
    }
    return words;
}

}  // namespace

/// What a cycle preserves it also relies on: `preserves G90` called under G91 would work with
/// distances where its author wrote coordinates.
Done Expander::State::check_needs(std::uint32_t at) {
    const CallFrame& frame = frames.back();
    for (const Function needed : frame.function->needs) {
        const Function active = modal[nc::info(needed).group];
        const bool is_lost = (modal.lost & sema::group_bit(nc::info(needed).group)) != 0;
        // Where the control knows it by itself, X is a diameter without a word.
        const bool is_other = needed == Function::DiameterOff && modal.is_diameter;
        if (active == needed || (active == Function::None && !is_lost && !is_other)) continue;
        if (needed == Function::RadiusCompOff && !is_lost) {
            compensated_cycle(*frame.function);
            return kFailed;
        }
        const bool is_called = frames.size() > 1 && frame.return_to > 0;
        if (is_lost) {
            const std::string words = lost_needs(*frame.function, modal.lost);
            report_loss(is_called
                            ? fault_in(diag::StateLost, frame.return_to - 1, frames.size() - 1)
                            : fault(diag::StateLost, at),
                        "whether `" + words + "` acts, as `" + frame.function->name + "` needs,",
                        "say `" + words + "` before it");
            return kFailed;
        }
        DiagnosticBuilder builder =
            is_called ? fault_in(diag::StateNeeded, frame.return_to - 1, frames.size() - 1)
                      : fault(diag::StateNeeded, at);
        builder.arg(frame.function->name)
            .arg(word_of_need(needed))
            .arg(word_of_need(active == Function::None ? Function::DiameterOn : active));
        const SourceId by = modal.changed_by[static_cast<std::size_t>(nc::info(needed).group)];
        if (by.is_valid() && by.index < code.statements.size()) {
            builder.note(code.statements[by.index], "it was changed here last");
        }
        return kFailed;
    }
    // The cutter that the call names is the one that the machine has; where only the text is made,
    // another one is a warning.
    if (!modal.has_tool_in || frames.size() < 2 || frame.return_to == 0 || !options.machine ||
        !options.checks_cutters || !has_cutter(*frame.function))
        return kDone;
    const machine::Machine* machine = options.machine();
    if (machine == nullptr) return kDone;
    const auto tool = static_cast<std::int64_t>(std::llround(modal.tool_in));
    const auto other = cutter_mismatch(*frame.function, stack.data() + frame.base, *machine, tool);
    if (!other) return kDone;
    const bool is_warning = options.warns_of_cuts;
    fault_in(is_warning ? diag::CutterDiffers : diag::CutterContradicts, frame.return_to - 1,
             frames.size() - 1)
        .arg(other->parameter)
        .arg(other->said)
        .arg(tool)
        .arg(other->own);
    return Done(is_warning);
}

Done Expander::State::check_preserves(std::uint32_t at) {
    const OpenWith& promise = promises.back();
    if (modal.lost != 0 && !keep_promise(promise, at)) return kFailed;
    const sema::ModalMask broken = difference(promise.before, modal, promise.mask);
    if (broken == 0) return kDone;
    const auto report = [&](std::string_view what, SourceId by) {
        DiagnosticBuilder builder = fault(diag::PromiseBroken, at);
        builder.arg(frames.back().function->name).arg(what);
        if (by.is_valid() && by.index < code.statements.size()) {
            builder.note(code.statements[by.index], "it was changed here last");
        }
    };
    for (std::size_t i = 0; i < nc::kGroups; ++i) {
        if ((broken >> i & 1u) == 0) continue;
        report(nc::group_name(static_cast<Group>(i)), modal.changed_by[i]);
        return kFailed;
    }
    if ((broken & sema::kFrameBit) != 0) report("the frames", modal.frame_by);
    else if ((broken & sema::kFeedBit) != 0) report("F", modal.feed_by);
    else report("S", modal.speed_by);
    return kFailed;
}

}  // namespace kadr::expand
