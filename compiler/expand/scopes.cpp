// scopes.cpp — what `with` sets back, what a cycle needs and preserves, and its cutter.

#include "expand/scopes.h"

#include <cmath>
#include <string>

#include "base/diagnostics/expand.h"
#include "expand/blocks.h"
#include "expand/cutters.h"
#include "expand/faults.h"
#include "expand/frame_blocks.h"
#include "expand/input_tools.h"
#include "expand/native_cycles.h"
#include "expand/orienting.h"
#include "expand/running.h"
#include "expand/unknown.h"
#include "nc/program_head.h"
#include "nc/tables.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using nc::Group;

Done leave_with(Running& run, SourceId source, std::uint32_t at, unsigned depth) {
    return set_back(run, run.scopes.end_with(), source, at, depth);
}

void take_offset_of_head(const Running& run, ModalState& state) {
    const bool is_lost = state.lost.has(Group::WorkOffsets);
    if (is_lost || state[Group::WorkOffsets] != Function::None || state.owed.work_offset() != 0)
        return;
    const std::optional<int> offset = nc::offset_of_head(run.target);
    if (!offset) return;
    state.assume(Group::WorkOffsets, Function::WorkOffset);
    state.work_offset = *offset;
}

Done set_back(Running& run, const OpenWith& scope, SourceId source, std::uint32_t at,
              unsigned depth) {
    ModalState before = scope.before;
    take_offset_of_head(run, before);
    const sema::ModalMask transformation = sema::group_bit(Group::Transformation);
    if ((scope.mask & transformation) != 0 && !set_back_tcp(run, before, source, at, depth))
        return kFailed;
    if ((scope.mask & sema::kFrameBit) != 0) {
        if (run.modal.tcp.is_length() && !(before.frame.now() == run.modal.frame.now()))
            return refuse_under_tcp(run, "the end of a frame", at);
        write_frame(run, before.frame.now(), source, at, depth);
        if (run.status.has_failed()) return kFailed;
        run.modal.frame.name_steps(before.frame.steps());
    }
    // Another feed mode forgets F, so F goes back with it.
    sema::ModalMask mask = scope.mask & ~transformation;
    if ((mask & sema::group_bit(Group::FeedMode)) != 0) mask |= sema::kFeedBit;
    if ((mask & sema::group_bit(Group::SpeedMode)) != 0) mask |= sema::kSpeedBit;
    const sema::ModalMask changed = difference(before, run.modal, mask) & ~sema::kFrameBit;
    if (changed == 0) return kDone;
    for (std::size_t i = 0; i < nc::kGroups; ++i) {
        if ((changed >> i & 1u) == 0 || before[static_cast<Group>(i)] != Function::None) continue;
        fault(run, diag::StateUnknown, at).arg(nc::group_name(static_cast<Group>(i)));
        return kFailed;
    }
    // Behind a `with` that set the first F there is none, and none there is behind this one.
    const sema::ModalMask no_value = before.lost.how() == Loss::EndOfWith ? sema::kFeedBit : 0;
    const sema::ModalMask values =
        changed & before.lost.what() & ~no_value & (sema::kFeedBit | sema::kSpeedBit);
    if (values != 0) {
        fault(run, diag::StateUnknown, at).arg((values & sema::kFeedBit) != 0 ? "F" : "S");
        return kFailed;
    }
    if ((changed & sema::kFeedBit) != 0 && !before.feed.is_known()) run.modal.forget_feed(source);
    // The same number means something else in another mode, so it goes back with the mode.
    const sema::ModalMask of_feed = sema::kFeedBit | sema::group_bit(Group::FeedMode);
    const sema::ModalMask of_speed = sema::kSpeedBit | sema::group_bit(Group::SpeedMode);
    const bool feed = (changed & of_feed) != 0 && before.feed.is_known();
    const bool speed = (changed & of_speed) != 0 && before.speed.is_known();
    const bool groups = (changed & ~(sema::kFeedBit | sema::kSpeedBit)) != 0;
    if (!groups && !feed && !speed) return kDone;
    if (!require_room(run, at)) return kFailed;
    Block& block = next_block(run, source);
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
        if (member == Function::LengthCompOn && before.length.offset()) {
            block.set_argument(*invocation, nc::parameter_of<Function::LengthCompOn>("offset"),
                               *before.length.offset());
        }
    }
    if (feed) block.set(nc::Slot::Feed, before.feed.value());
    if (speed) block.set(nc::Slot::Speed, before.speed.value());
    if ((changed & sema::group_bit(Group::LengthComp)) != 0 && !take_core_offsets(run, block, at))
        return kFailed;
    run.modal.take_block(block, run.target.rules());
    if (run.options.trace) keep_trace(run, at, depth, source);
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

Done check_needs(Running& run, std::uint32_t at) {
    const CallFrame& frame = run.vm.calls.back();
    for (const Function needed : frame.function->needs) {
        const Function active = run.modal[nc::info(needed).group];
        const bool is_lost = run.modal.lost.has(sema::group_bit(nc::info(needed).group));
        // Where the control knows it by itself, X is a diameter without a word.
        const bool is_other = needed == Function::DiameterOff && run.modal.is_diameter;
        if (active == needed || (active == Function::None && !is_lost && !is_other)) continue;
        if (needed == Function::RadiusCompOff && !is_lost) {
            compensated_cycle(run, *frame.function);
            return kFailed;
        }
        const bool is_called = run.vm.calls.size() > 1 && frame.return_to > 0;
        if (is_lost) {
            const std::string words = lost_needs(*frame.function, run.modal.lost.what());
            report_loss(run,
                        is_called ? fault_in(run, diag::StateLost, frame.return_to - 1,
                                             run.vm.calls.size() - 1)
                                  : fault(run, diag::StateLost, at),
                        "whether `" + words + "` acts, as `" + frame.function->name + "` needs,",
                        "say `" + words + "` before it");
            return kFailed;
        }
        DiagnosticBuilder builder =
            is_called
                ? fault_in(run, diag::StateNeeded, frame.return_to - 1, run.vm.calls.size() - 1)
                : fault(run, diag::StateNeeded, at);
        builder.arg(frame.function->name)
            .arg(word_of_need(needed))
            .arg(word_of_need(active == Function::None ? Function::DiameterOn : active));
        note_statement(run, builder, run.modal.by(nc::info(needed).group),
                       "it was changed here last");
        return kFailed;
    }
    // The cutter that the call names is the one that the machine has; where only the text is made,
    // another one is a warning.
    if (!run.modal.tool.in() || run.vm.calls.size() < 2 || frame.return_to == 0 ||
        !run.options.machine || !run.options.checks_cutters || !has_cutter(*frame.function))
        return kDone;
    const machine::Machine* machine = run.options.machine();
    if (machine == nullptr) return kDone;
    const auto tool = static_cast<std::int64_t>(std::llround(run.modal.tool.in().value_or(0)));
    const auto other =
        cutter_mismatch(*frame.function, run.vm.stack.data() + frame.base, *machine, tool);
    if (!other) return kDone;
    const bool is_warning = run.options.warns_of_cuts;
    fault_in(run, is_warning ? diag::CutterDiffers : diag::CutterContradicts, frame.return_to - 1,
             run.vm.calls.size() - 1)
        .arg(other->parameter)
        .arg(other->said)
        .arg(tool)
        .arg(other->own);
    return Done(is_warning);
}

Done check_preserves(Running& run, std::uint32_t at) {
    const OpenWith& promise = run.scopes.last_promise();
    if (run.modal.lost.what() != 0 && !keep_promise(run, promise, at)) return kFailed;
    const sema::ModalMask broken = difference(promise.before, run.modal, promise.mask);
    if (broken == 0) return kDone;
    const auto report = [&](std::string_view what, SourceId by) {
        DiagnosticBuilder builder = fault(run, diag::PromiseBroken, at);
        builder.arg(run.vm.calls.back().function->name).arg(what);
        note_statement(run, builder, by, "it was changed here last");
    };
    for (std::size_t i = 0; i < nc::kGroups; ++i) {
        if ((broken >> i & 1u) == 0) continue;
        report(nc::group_name(static_cast<Group>(i)), run.modal.by(static_cast<Group>(i)));
        return kFailed;
    }
    if ((broken & sema::kFrameBit) != 0) report("the frames", run.modal.frame.by());
    else if ((broken & sema::kFeedBit) != 0) report("F", run.modal.feed.by());
    else report("S", run.modal.speed.by());
    return kFailed;
}

}  // namespace kadr::expand
