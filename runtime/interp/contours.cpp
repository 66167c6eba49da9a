// contours.cpp — contours that the program wants as tables: their blocks give geometry and no
// motion. What the table is like is contour_table.h, and who asks for it contour_statements.cpp.
#include <algorithm>
#include <cmath>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "interp/answers.h"
#include "interp/block_functions.h"
#include "interp/channel.h"
#include "interp/contour_tables.h"
#include "interp/cornering.h"
#include "interp/executor.h"
#include "interp/splines.h"
#include "interp/transformation.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using path::Command;
using path::Op;
using path::Vec2;

namespace {

/// The digit of how the blocks join.
int path_mode_of(const Modal& modal) {
    if (modal.has_exact_stop) return 0;
    if (modal.blend == Blend::None) return 1;
    return modal.blend == Blend::Distance ? 2 : 3;
}

int feed_mode_of(const Modal& modal, const ProgrammedSpindle& spindle) {
    if (spindle.has_cutting_speed) return 3;
    switch (modal.feed_mode) {
        case path::FeedMode::InverseTime: return 0;
        case path::FeedMode::PerRevolution: return 2;
        default: return 1;
    }
}

}  // namespace

ContourTables::ContourTables(Channel& channel)
    : channel_(channel),
      reporter_(channel.state.reporter),
      modal_(channel.state.motion.modal),
      frames_(channel.state.frame.frames),
      spindle_(channel.state.spindle.spindle),
      corners_(channel.state.stage.corners),
      units_(channel.state.motion.units),
      modal_cycles_(channel.state.cycle.modal_cycles),
      shape_(channel.state.cycle.shape),
      contour_(channel.state.cycle.contour),
      patterns_(channel.state.cycle.patterns) {}

std::string_view ContourTables::begin_contour() {
    channel_.splines.finish_open_spline();
    if (channel_.answers.is_compensated()) return "cutter radius compensation";
    if (channel_.transformation.is_transformed()) return "a transformation";
    if (modal_cycles_.modal.is_active || modal_cycles_.behind_motions) return "a modal cycle";
    if (shape_ || !patterns_.empty()) return "a cycle";
    if (corners_.is_active()) channel_.cornering.leave_corners(diag::CornerWithoutMotion);
    contour_.emplace();
    contour_->before = channel_.state.keep();
    return {};
}

Done ContourTables::require_contour_block(const Block& block) {
    if (!channel_.executor.acts(block)) return kDone;
    const auto refuse = [&](const DiagnosticRow& row, Function function) {
        reporter_.report(row, block, function).arg(reporter_.word_of(block, function));
        return kFailed;
    };
    if (!nc::has_fact(block.motion, nc::Fact::ContourElement))
        return refuse(diag::ContourMotion, block.motion);
    for (std::size_t i = 0; i < block.function_count; ++i) {
        const Function function = block.functions[i].function;
        if (nc::has_fact(function, nc::Fact::EndsProgram)) {
            reporter_.report(diag::ContourUnfinished, block, function);
            return kFailed;
        }
        const bool changes_units =
            (function == Function::Inch && units_ != ProgrammedUnits::Inch) ||
            (function == Function::Metric && units_ == ProgrammedUnits::Inch);
        if (nc::has_fact(function, nc::Fact::EndsContour) || changes_units ||
            channel_.functions.is_other_plane(function))
            return refuse(diag::ContourBlockWrong, function);
    }
    return kDone;
}

void ContourTables::note_contour_block(const Block& block) {
    if (block.kind != Block::Kind::Nc) return;
    ContourRun::BlockModes modes;
    modes.line = block.line;
    modes.modes.is_incremental = modal_.is_incremental;
    modes.modes.feed_mode = feed_mode_of(modal_, spindle_);
    modes.modes.path_mode = path_mode_of(modal_);
    modes.modes.stops_once = block.find(Function::ExactStopOnce) != nullptr;
    modes.feed = modal_.has_feed ? modal_.feed : 0;
    contour_->modes.push_back(modes);
    std::vector<Command>& commands = contour_->commands;
    while (!commands.empty() && !commands.back().is_motion()) commands.pop_back();
    // No array of a program has so many rows, so that a loop without end is not read until the
    // memory is full.
    constexpr std::size_t kMostMotions = 200'000;
    if (commands.size() > kMostMotions || contour_->modes.size() > 10 * kMostMotions)
        reporter_.report(diag::ContourTableSmall, block).arg("every table").arg("fewer");
}

std::optional<ContourElements> ContourTables::end_contour() {
    channel_.cornering.leave_corners(diag::CornerWithoutMotion);
    if (reporter_.has_ended()) return std::nullopt;
    const ContourRun run = std::move(*contour_);
    contour_.reset();
    channel_.state.take_back(run.before);
    return contour_of(run);
}

/// The motions of a contour in the working plane; nothing: one was reported.
std::optional<ContourElements> ContourTables::contour_of(const ContourRun& run) {
    const path::PlaneAxes axes = path::axes_of(modal_.plane);
    const auto in_plane = [&](const AxisValues& base) -> Vec2 {
        const AxisValues here = frames_.from_base(base);
        return {here[index(axes.first)], here[index(axes.second)]};
    };
    const bool is_mirrored = frames_.is_mirrored(modal_.plane);
    ContourElements out;
    Vec2 from = in_plane(run.before.position.base());
    std::size_t at = 0;  // of what the blocks have programmed
    for (const Command& command : run.commands) {
        if (!command.is_motion()) continue;
        const auto of_line = std::find_if(
            run.modes.begin() + static_cast<std::ptrdiff_t>(at), run.modes.end(),
            [&](const ContourRun::BlockModes& modes) { return modes.line == command.line; });
        if (of_line != run.modes.end()) at = static_cast<std::size_t>(of_line - run.modes.begin());
        const path::Motion& motion = command.motion();
        const Vec2 to = in_plane(motion.to);
        const bool is_arc = command.op() == Op::Arc;
        // Blocks that lead nowhere are no elements; but the first one is the path to the contour,
        // also of a tool that stands there already (unsure).
        if (!is_arc && !out.empty() && (to - from).norm() <= path::kSamePoint) continue;
        ContourElement element;
        element.is_rapid = command.op() == Op::Rapid;
        element.shape = path::line_element(from, to);
        if (is_arc) {
            const path::ArcShape& arc = motion.arc();
            const path::Vec3 normal = path::unit(axes.normal);
            if (std::fabs(arc.normal.dot(normal)) < 1 - 1e-9) {
                Block block{};
                block.line = command.line;
                block.source = command.source;
                reporter_.report(diag::ContourMotion, block).arg("an arc out of the working plane");
                return std::nullopt;
            }
            const AxisValues center{arc.center.x(), arc.center.y(), arc.center.z()};
            element.shape =
                path::arc_element(from, to, in_plane(center), arc.is_clockwise != is_mirrored);
            // More than a revolution is no element, and ends where a full circle does.
            if (arc.turns > 0) element.shape.sweep = std::copysign(arc.sweep, element.shape.sweep);
        }
        if (at < run.modes.size()) {
            element.modes = run.modes[at].modes;
            element.feed = run.modes[at].feed;
        }
        out.push_back(element);
        from = to;
    }
    return out;
}

}  // namespace kadr::interp
