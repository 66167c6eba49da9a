// cuts.cpp — what a block that cuts needs: feed, speed, a spindle that turns, one tool.
#include "expand/cuts.h"

#include <cmath>
#include <string>

#include "base/diagnostics/dialect.h"
#include "base/diagnostics/expand.h"
#include "base/diagnostics/iso.h"
#include "base/units.h"
#include "expand/faults.h"
#include "expand/feed_words.h"
#include "expand/numbers.h"
#include "expand/running.h"
#include "nc/tables.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using nc::Group;

namespace {

/// Whether a comment in the source silences the warning there: it is not reported then.
bool is_allowed(const Running& run, const DiagnosticRow& row, std::uint32_t at) {
    return run.options.is_allowed && run.options.is_allowed(row, run.code.locations[at]);
}

void warn_of_spindle(Running& run, std::uint32_t at);

}  // namespace

Done check_cutting_speed(Running& run, const Block& block, std::uint32_t at) {
    constexpr std::size_t kLimit = nc::parameter_of<Function::SpeedLimit>("limit");
    const nc::Invocation* limit = block.find(Function::SpeedLimit);
    if (limit != nullptr && !(block.argument(*limit, kLimit) > 0)) {
        fault(run, diag::SpeedLimitZero, at).arg(neat(block.argument(*limit, kLimit)));
        return kFailed;
    }
    const bool begins = block.find(Function::CuttingSpeedOn) != nullptr;
    if (!begins || block.has(nc::Slot::Speed) || run.modal.speed.is_known() ||
        run.modal.speed.was_of_cutting() || run.modal.lost.what() != 0)
        return kDone;
    const auto alarm = run.target.alarm(diag::CuttingSpeedMissing);
    if (!alarm) return kDone;
    fault(run, diag::CuttingSpeedNotSet, at)
        .arg(run.target.name())
        .arg(alarm->number.empty() ? alarm->text : alarm->number)
        .fix("say the cutting speed in the block: `G96 S180`");
    return kFailed;
}

Done check_tool_change(Running& run, const Block& block, std::uint32_t at) {
    if (block.function_count == 0 ||
        !nc::has_fact(run.modal[Group::RadiusComp], nc::Fact::CompSide) ||
        !changes_tool(run, block))
        return kDone;
    auto builder = fault(run, diag::ToolUnderCompensation, at);
    note_statement(run, builder, run.modal.by(Group::RadiusComp), "the compensation began here");
    builder.fix("end it before: `G40` with a move");
    return kFailed;
}

Done check_pitch(Running& run, const Block& block, std::uint32_t at) {
    const bool is_arc = nc::is_arc(run.modal[Group::Motion]) &&
                        (block.given & (nc::kTargetSlots | nc::kCenterSlots)) != 0;
    if (!is_arc || run.recordings.is_open()) return kDone;
    const bool begins = nc::has_fact(run.modal[Group::RadiusComp], nc::Fact::CompSide);
    auto builder = fault(run, diag::CompensationOnArc, at);
    builder.arg(begins ? "begins" : "ends");
    const SourceId by = run.modal.by(Group::RadiusComp);
    const bool is_here = by.is_valid() && by.index == block.source.index;
    if (!is_here)
        note_statement(run, builder, by, begins ? "it was asked for here" : "it was ended here");
    builder.fix(begins ? "lead in with a line: `G41 G1 X… Y…`, and then the arc"
                       : "lead out with a line behind the arc: `G40 G1 X… Y…`");
    return kFailed;
}

Done check_mirror(Running& run, const Block& block, const sema::Plan& plan, std::uint32_t at) {
    const nc::Invocation* mirror = block.find(Function::Mirror);
    const bool replaces = (plan.customs & sema::custom::kMirrorReplaces) != 0;
    if (mirror == nullptr || replaces == run.target.rules().mirror_replaces) return kDone;
    constexpr std::size_t kX = nc::parameter_of<Function::Mirror>("x");
    for (std::size_t i = 0; i < 3; ++i) {
        if (!mirror->has(kX + i) || !run.modal.frame.now().is_mirrored[i]) continue;
        fault(run, diag::MirrorAgain, at)
            .arg(replaces ? "the control of this source" : run.target.name())
            .arg(kAxisNames[i])
            .fix(replaces ? "leave it out" : "use `with mirror(…) { … }`");
        return kFailed;
    }
    return kDone;
}

void warn_of_plane(Running& run, const Block& block, std::uint32_t at) {
    const bool is_zx = block.find(Function::PlaneZx) != nullptr;
    if (!is_zx && block.find(Function::PlaneYz) == nullptr) return;
    const bool is_turned = run.modal[Group::Diameter] != Function::None;
    const bool is_mill = run.modal[Group::Plane] == Function::PlaneXy && !is_turned;
    if (!is_mill || !run.modal.tool.in() || run.reported.has_reported(ProgramNotice::Plane) ||
        run.target.rules().length_axis == nc::LengthAxis::Z)
        return;
    if (!is_allowed(run, diag::LengthTurns, at))
        run.reported.count_as_reported(ProgramNotice::Plane);
    fault(run, diag::LengthTurns, at)
        .arg(run.target.name())
        .arg(is_zx ? "G18" : "G19")
        .arg(is_zx ? "Y" : "X");
}

Done check_cut(Running& run, const Block& block, std::uint32_t at) {
    const Function motion = run.modal[Group::Motion];
    const bool is_cut = nc::has_fact(motion, nc::Fact::Cut);
    const bool moves = (block.given & (nc::kTargetSlots | nc::kCenterSlots)) != 0 ||
                       (block.function_count != 0 && block.find(Function::ToolVector) != nullptr);
    if (!is_cut || !moves || block.find(Function::ReferenceReturn) != nullptr) return kDone;
    if (run.modal.feed.is_lost()) return refuse_lost_feed(run, at, run.vm.calls.size());
    if (run.options.warns_of_cuts) warn_of_cut(run, at);
    return Done(!run.status.has_failed());
}

Done refuse_lost_feed(Running& run, std::uint32_t at, std::size_t depth) {
    const Function mode = run.modal[Group::FeedMode];
    DiagnosticBuilder builder = fault_in(run, diag::FeedLost, at, depth);
    builder.arg(feed_word(mode));
    note_statement(run, builder, run.modal.by(Group::FeedMode), "the feed mode was set here");
    builder.fix(std::string("say F in ") + feed_unit(mode) + " behind `" + feed_code(mode) + '`');
    return kFailed;
}

namespace {

nc::Changer changer(const Running& run) {
    return run.target.is_of_lathe() ? nc::Changer::Turret : run.modal.changer();
}

}  // namespace

bool changes_tool(const Running& run, const Block& block) {
    return std::ranges::any_of(
        effects_of(run.target.rules(), block, changer(run)),
        [](const nc::Effect& effect) { return effect.kind == nc::EffectKind::ChangesTool; });
}

/// A tool was selected, and nothing has changed it.
static void warn_of_selection(DiagnosticBuilder builder, double tool) {
    const std::string number = std::to_string(std::llround(tool));
    builder.note("T" + number + " is selected only, another tool may be in the spindle")
        .fix("change it: `M6`, or `tool(" + number + ")` for both");
}

void warn_of_cut(Running& run, std::uint32_t at, bool needs_feed) {
    if (needs_feed && !run.modal.feed.is_known() && run.reported.first_time(ProgramNotice::Feed)) {
        // Where the control alarms, no text is written that would; the common core has no alarms.
        if (const auto alarm = run.target.alarm(diag::FeedMissing)) {
            const std::string number = alarm->number.empty() ? alarm->text : alarm->number;
            fault(run, diag::FeedNotSet, at)
                .arg(run.target.name())
                .arg(number)
                .fix("give the block a feed: `F200`, or set one before it");
            return;
        }
        fault(run, diag::FeedNeverSet, at);
    }
    if (run.modal.is_spindle_turning() && misses_tool(run)) {
        run.modal.reported.count_as_reported(ProgramNotice::NoTool);
        if (!run.modal.tool.called()) fault(run, diag::ToolNeverCalled, at);
        else if (!nc::selects_at_once(run.target.rules(), changer(run)))
            warn_of_selection(fault(run, diag::ToolNeverCalled, at),
                              run.modal.tool.called().value_or(0));
    }
    if (!run.modal.is_spindle_turning() &&
        !run.modal.reported.has_reported(ProgramNotice::SpindleStopped))
        warn_of_spindle(run, at);
}

namespace {

void warn_of_spindle(Running& run, std::uint32_t at) {
    const bool is_on = run.modal[Group::Spindle] == Function::SpindleCw ||
                       run.modal[Group::Spindle] == Function::SpindleCcw;
    const DiagnosticRow& row = is_on && run.modal.speed.is_missing()
                                   ? static_cast<const DiagnosticRow&>(diag::SpindleWithoutSpeed)
                                   : diag::FeedWithSpindleStopped;
    if (!is_allowed(run, row, at))
        run.modal.reported.count_as_reported(ProgramNotice::SpindleStopped);
    DiagnosticBuilder builder = fault(run, row, at);
    const SourceId by = run.modal.by(Group::Spindle);
    if (run.modal[Group::Spindle] == Function::SpindleStop)
        note_statement(run, builder, by, "it stands from here on");
    if (is_on && run.modal.speed.is_missing())
        note_statement(run, builder, by, "it is started here, without S");
}

}  // namespace

void check_rapid(Running& run, const Block& block, std::uint32_t at) {
    constexpr std::size_t kZ = index(Axis::Z);
    if (!block.has(nc::Slot::Z) || run.modal[Group::Motion] != Function::Rapid) return;
    // On a lathe, and in another plane, Z is not the direction into the workpiece.
    const bool is_mill = run.modal[Group::Plane] == Function::PlaneXy && !run.modal.is_diameter;
    if (!is_mill || run.modal[Group::Spindle] != Function::SpindleStop || block.skip_level >= 0)
        return;
    if (block.find(nc::Fact::AtMachinePosition) != nullptr ||
        block.find(Function::Probe) != nullptr)
        return;
    const nc::SlotMask word = bit(nc::Slot::Z);
    const bool is_known = run.modal.position.knows(kZ);
    const bool is_modal = run.modal[Group::Distance] == Function::Incremental;
    const bool is_distance =
        (block.incremental & word) != 0 || (is_modal && !(block.absolute & word));
    if (is_distance && !is_known) return;
    const double distance = block.at(nc::Slot::Z);
    const double target_z = is_distance ? run.modal.position[kZ] + distance : distance;
    if (!(target_z < 0) || (is_known && target_z >= run.modal.position[kZ])) return;
    if (!is_allowed(run, diag::RapidBelowPlane, at))
        run.modal.reported.count_as_reported(ProgramNotice::Rapid);
    // As a word of the program has it.
    const bool is_inch = run.modal[Group::Units] == Function::Inch;
    fault(run, diag::RapidBelowPlane, at).arg(is_inch ? target_z / kMmPerInch : target_z);
}

}  // namespace kadr::expand
