// cuts.cpp — what a block that cuts needs: feed, speed, a spindle that turns, one tool.
#include <cmath>
#include <string>

#include "base/diagnostics/dialect.h"
#include "base/diagnostics/expand.h"
#include "base/diagnostics/iso.h"
#include "base/units.h"
#include "expand/feed_words.h"
#include "expand/numbers.h"
#include "expand/state.h"
#include "nc/tables.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using nc::Group;

/// A constant cutting speed that is none, and a limit that lets no spindle turn.
Done Expander::State::check_cutting_speed(const Block& block, std::uint32_t at) {
    constexpr std::size_t kLimit = nc::parameter_of<Function::SpeedLimit>("limit");
    const nc::Invocation* limit = block.find(Function::SpeedLimit);
    if (limit != nullptr && !(block.argument(*limit, kLimit) > 0)) {
        fault(diag::SpeedLimitZero, at).arg(neat(block.argument(*limit, kLimit)));
        return kFailed;
    }
    const bool begins = block.find(Function::CuttingSpeedOn) != nullptr;
    if (!begins || block.has(nc::Slot::Speed) || modal.has_speed || modal.had_cutting_speed ||
        modal.lost != 0)
        return kDone;
    const auto alarm = target.alarm(diag::CuttingSpeedMissing);
    if (!alarm) return kDone;
    fault(diag::CuttingSpeedNotSet, at)
        .arg(target.name())
        .arg(alarm->number.empty() ? alarm->text : alarm->number)
        .fix("say the cutting speed in the block: `G96 S180`");
    return kFailed;
}

/// Each of the compensated blocks was worked out for the radius of one tool.
Done Expander::State::check_tool_change(const Block& block, std::uint32_t at) {
    if (block.function_count == 0 || !nc::has_fact(modal[Group::RadiusComp], nc::Fact::CompSide) ||
        !changes_tool(block))
        return kDone;
    auto builder = fault(diag::ToolUnderCompensation, at);
    const SourceId by = modal.changed_by[static_cast<std::size_t>(Group::RadiusComp)];
    if (by.is_valid() && by.index < code.statements.size())
        builder.note(code.statements[by.index], "the compensation began here");
    builder.fix("end it before: `G40` with a move");
    return kFailed;
}

/// Controls go to a compensated contour, and leave it, on straight lines only.
///
/// source       F PS0034, S 10753
Done Expander::State::check_pitch(const Block& block, std::uint32_t at) {
    const bool is_arc = nc::is_arc(modal[Group::Motion]) &&
                        (block.given & (nc::kTargetSlots | nc::kCenterSlots)) != 0;
    if (!is_arc || !recordings.empty()) return kDone;
    const bool begins = nc::has_fact(modal[Group::RadiusComp], nc::Fact::CompSide);
    auto builder = fault(diag::CompensationOnArc, at);
    builder.arg(begins ? "begins" : "ends");
    const SourceId by = modal.changed_by[static_cast<std::size_t>(Group::RadiusComp)];
    const bool is_here = by.is_valid() && by.index == block.source.index;
    if (!is_here && by.is_valid() && by.index < code.statements.size())
        builder.note(code.statements[by.index],
                     begins ? "it was asked for here" : "it was ended here");
    builder.fix(begins ? "lead in with a line: `G41 G1 X… Y…`, and then the arc"
                       : "lead out with a line behind the arc: `G40 G1 X… Y…`");
    return kFailed;
}

/// A further mirror of an axis, where source and target do not take it alike: it goes on mirroring,
/// or undoes the one that acts.
Done Expander::State::check_mirror(const Block& block, const sema::Plan& plan, std::uint32_t at) {
    const nc::Invocation* mirror = block.find(Function::Mirror);
    const bool replaces = (plan.customs & sema::custom::kMirrorReplaces) != 0;
    if (mirror == nullptr || replaces == target.rules().mirror_replaces) return kDone;
    constexpr std::size_t kX = nc::parameter_of<Function::Mirror>("x");
    for (std::size_t i = 0; i < 3; ++i) {
        if (!mirror->has(kX + i) || !modal.frame.is_mirrored[i]) continue;
        fault(diag::MirrorAgain, at)
            .arg(replaces ? "the control of this source" : target.name())
            .arg(kAxisNames[i])
            .fix(replaces ? "leave it out" : "use `with mirror(…) { … }`");
        return kFailed;
    }
    return kDone;
}

/// The tool's length goes over to another axis of a mill with the plane.
void Expander::State::warn_of_plane(const Block& block, std::uint32_t at) {
    const bool is_zx = block.find(Function::PlaneZx) != nullptr;
    if (!is_zx && block.find(Function::PlaneYz) == nullptr) return;
    const bool is_turned = modal[Group::Diameter] != Function::None;
    const bool is_mill = modal[Group::Plane] == Function::PlaneXy && !is_turned;
    if (!is_mill || !modal.has_tool_in || reported.has_reported(ProgramNotice::Plane) ||
        target.rules().length_axis == nc::LengthAxis::Z)
        return;
    if (!is_allowed(diag::LengthTurns, at)) reported.count_as_reported(ProgramNotice::Plane);
    fault(diag::LengthTurns, at)
        .arg(target.name())
        .arg(is_zx ? "G18" : "G19")
        .arg(is_zx ? "Y" : "X");
}

Done Expander::State::check_cut(const Block& block, std::uint32_t at) {
    const Function motion = modal[Group::Motion];
    const bool is_cut = nc::has_fact(motion, nc::Fact::Cut);
    const bool moves = (block.given & (nc::kTargetSlots | nc::kCenterSlots)) != 0 ||
                       (block.function_count != 0 && block.find(Function::ToolVector) != nullptr);
    if (!is_cut || !moves || block.find(Function::ReferenceReturn) != nullptr) return kDone;
    if (modal.is_feed_lost) return refuse_lost_feed(at, frames.size());
    if (options.warns_of_cuts) warn_of_cut(at);
    return Done(!has_failed);
}

/// A number of millimetres per minute would cut as millimetres per revolution.
Done Expander::State::refuse_lost_feed(std::uint32_t at, std::size_t depth) {
    const Function mode = modal[Group::FeedMode];
    DiagnosticBuilder builder = fault_in(diag::FeedLost, at, depth);
    builder.arg(feed_word(mode));
    const SourceId by = modal.changed_by[static_cast<std::size_t>(Group::FeedMode)];
    if (by.is_valid() && by.index < code.statements.size())
        builder.note(code.statements[by.index], "the feed mode was set here");
    builder.fix(std::string("say F in ") + feed_unit(mode) + " behind `" + feed_code(mode) + '`');
    return kFailed;
}

nc::Changer Expander::State::changer() const {
    return target.is_of_lathe() ? nc::Changer::Turret : modal.changer();
}

/// Whether the block brings a tool in, be it by a T alone, as some controls do on lathes.
bool Expander::State::changes_tool(const Block& block) const {
    return std::ranges::any_of(
        effects_of(target.rules(), block, changer()),
        [](const nc::Effect& effect) { return effect.kind == nc::EffectKind::ChangesTool; });
}

/// A tool was selected, and nothing has changed it.
static void warn_of_selection(DiagnosticBuilder builder, double tool) {
    const std::string number = std::to_string(std::llround(tool));
    builder.note("T" + number + " is selected only, another tool may be in the spindle")
        .fix("change it: `M6`, or `tool(" + number + ")` for both");
}

/// What the interpreter finds when the text is run, reported where only the text is made.
void Expander::State::warn_of_cut(std::uint32_t at, bool needs_feed) {
    if (needs_feed && !modal.has_feed && reported.first_time(ProgramNotice::Feed)) {
        // Where the control alarms, no text is written that would; the common core has no alarms.
        if (const auto alarm = target.alarm(diag::FeedMissing)) {
            const std::string number = alarm->number.empty() ? alarm->text : alarm->number;
            fault(diag::FeedNotSet, at)
                .arg(target.name())
                .arg(number)
                .fix("give the block a feed: `F200`, or set one before it");
            return;
        }
        fault(diag::FeedNeverSet, at);
    }
    if (modal.is_spindle_turning() && misses_tool()) {
        modal.reported.count_as_reported(ProgramNotice::NoTool);
        if (!modal.has_tool) fault(diag::ToolNeverCalled, at);
        else if (!nc::selects_at_once(target.rules(), changer()))
            warn_of_selection(fault(diag::ToolNeverCalled, at), modal.tool);
    }
    if (!modal.is_spindle_turning() && !modal.reported.has_reported(ProgramNotice::SpindleStopped))
        warn_of_spindle(at);
}

void Expander::State::warn_of_spindle(std::uint32_t at) {
    const bool is_on = modal[Group::Spindle] == Function::SpindleCw ||
                       modal[Group::Spindle] == Function::SpindleCcw;
    const DiagnosticRow& row = is_on && modal.lacks_speed
                                   ? static_cast<const DiagnosticRow&>(diag::SpindleWithoutSpeed)
                                   : diag::FeedWithSpindleStopped;
    if (!is_allowed(row, at)) modal.reported.count_as_reported(ProgramNotice::SpindleStopped);
    DiagnosticBuilder builder = fault(row, at);
    const SourceId by = modal.changed_by[static_cast<std::size_t>(Group::Spindle)];
    if (modal[Group::Spindle] == Function::SpindleStop && by.is_valid() &&
        by.index < code.statements.size())
        builder.note(code.statements[by.index], "it stands from here on");
    if (is_on && modal.lacks_speed && by.is_valid() && by.index < code.statements.size())
        builder.note(code.statements[by.index], "it is started here, without S");
}

void Expander::State::check_rapid(const Block& block, std::uint32_t at) {
    constexpr std::size_t kZ = index(Axis::Z);
    if (!block.has(nc::Slot::Z) || modal[Group::Motion] != Function::Rapid) return;
    // On a lathe, and in another plane, Z is not the direction into the workpiece.
    const bool is_mill = modal[Group::Plane] == Function::PlaneXy && !modal.is_diameter;
    if (!is_mill || modal[Group::Spindle] != Function::SpindleStop || block.skip_level >= 0) return;
    if (block.find(nc::Fact::AtMachinePosition) != nullptr ||
        block.find(Function::Probe) != nullptr)
        return;
    const nc::SlotMask word = bit(nc::Slot::Z);
    const bool is_known = (modal.known >> kZ & 1u) != 0;
    const bool is_modal = modal[Group::Distance] == Function::Incremental;
    const bool is_distance =
        (block.incremental & word) != 0 || (is_modal && !(block.absolute & word));
    if (is_distance && !is_known) return;
    const double distance = block.at(nc::Slot::Z);
    const double target_z = is_distance ? modal.position[kZ] + distance : distance;
    if (!(target_z < 0) || (is_known && target_z >= modal.position[kZ])) return;
    if (!is_allowed(diag::RapidBelowPlane, at))
        modal.reported.count_as_reported(ProgramNotice::Rapid);
    // As a word of the program has it.
    const bool is_inch = modal[Group::Units] == Function::Inch;
    fault(diag::RapidBelowPlane, at).arg(is_inch ? target_z / kMmPerInch : target_z);
}

}  // namespace kadr::expand
