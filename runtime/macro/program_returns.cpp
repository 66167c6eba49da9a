// program_returns.cpp — returns: to the caller, to the next pass, to the main program's
// head.
#include "macro/program_returns.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/diagnostics/control.h"
#include "base/diagnostics/doubtful.h"
#include "macro/program_run.h"
#include "nc/quoted.h"

namespace kadr::macro {

using nc::Block;
using nc::ControlStatement;
using nc::Function;
using nc::quoted;

Outcome Returns::leave(CompiledLine& line, const ControlStatement& statement, Block& out) {
    const nc::Call* const words =
        line.line.calls.empty() ? nullptr : &line.line.calls[statement.call];
    std::optional<LineTarget> target;
    if (statement.target.kind != nc::JumpTarget::Kind::None) {
        const auto wanted = run_.jumps.resolve(line, statement.target);
        if (!wanted) return wanted.error();
        if (!wanted->label.empty() || wanted->number >= 0) target = *wanted;
    }
    std::optional<double> number;
    Outcome done = Outcome::Nothing;
    if (words != nullptr) done = run_.call_preparation.number_of(line, words->target, number);
    if (!goes_on(done)) return done;
    if (number) target = LineTarget{{}, static_cast<std::int64_t>(*number)};
    if (!target && cancel_repeat()) return Outcome::Nothing;
    if (run_.frames.size() == 1) return return_in_main(line, statement, target, out);
    if (run_.frame->call.is_modal && !line.line.words.words.empty()) {
        return run_.fail(
            line, diag::ReturnWithWords, statement.span,
            {line.text.substr(statement.span.begin, statement.span.end - statement.span.begin)});
    }
    // How many levels, and which block of the program that goes on.
    ControlValue behind;
    ControlValue levels = ControlValue::real(1);
    if (statement.value.is_given()) done = run_.evaluate(line, statement.value, behind);
    if (!goes_on(done)) return done;
    if (statement.count.is_given()) done = run_.evaluate(line, statement.count, levels);
    if (!goes_on(done)) return done;
    const auto most = static_cast<double>(run_.frames.size() - 1);
    run_.frame->levels = static_cast<int>(std::clamp(std::round(levels.number), 1.0, most));
    if (target) {
        RunningProgram& next =
            *run_.frames[run_.frames.size() - 1 - static_cast<std::size_t>(run_.frame->levels)];
        ProgramLine found;
        const auto fault = next.unit->map.find(*target, Direction::Forward,
                                               {next.unit->begin, next.unit->begin}, found);
        const std::string what =
            target->label.empty() ? "N" + std::to_string(target->number) : target->label;
        if (fault != ProgramMap::Fault::None)
            return run_.fail(line, fault, diag::JumpTargetMissing, statement.span, quoted(what));
        run_.show_way(WayTaken::Kind::Jump, line.program_line.line, *next.unit, found.line);
        if (behind.number > 0) found.line = found.next;
        run_.frame->returns_to = found;
    }
    std::optional<double> left;
    if (words != nullptr) done = run_.call_preparation.number_of(line, words->repeats, left);
    if (!goes_on(done)) return done;
    // The pass that ends is counted off.
    if (left) run_.frame->left = static_cast<std::int64_t>(std::clamp(*left, 0.0, 1e9)) + 1;
    run_.frame->is_returning = true;
    return Outcome::Nothing;
}

namespace {

/// Whether a line, read by itself, ends the program.
bool ends_program(const nc::Dialect& dialect, std::string_view line) {
    struct OneLine final : nc::TextSource {
        explicit OneLine(std::string_view all) : rest(all) {}
        std::string_view next() override { return std::exchange(rest, {}); }
        std::string_view rest;
    } text(line);
    DiagnosticList ignored;
    nc::Reader reader(dialect, text, "", ignored);
    std::array<Block, 1> block;
    return reader.pull(block) > 0 && (block[0].find(Function::End) != nullptr ||
                                      block[0].find(Function::EndRewind) != nullptr);
}

/// Whether a jump may end the program in front of the position: a block with a number stands in the
/// program from there on, and the program's end behind it. Exits to an alarm alone are none.
bool has_exit_behind(const nc::Dialect& dialect, nc::LineSource& source, const LinePosition& from) {
    const nc::DialectTables& tables = dialect.tables();
    if (!source.seek(from.offset)) return false;
    std::string_view line;
    bool is_too_long = false;
    bool has_number = false;
    while (source.next(line, is_too_long)) {
        if (std::ranges::find(tables.program.end, line) != tables.program.end.end()) return false;
        if (nc::program_of_header(tables.language.calls, line, tables.notation.ignores_case))
            return false;
        has_number = has_number || nc::front_of(tables, line).number >= 0;
        if (has_number && ends_program(dialect, line)) return true;
    }
    return false;
}

}  // namespace

/// The main program is begun again, or ends: one whose last block begins it again never ends by
/// itself, so it is executed as often as was asked for, which is once.
///
/// source  F 6.8
Outcome Returns::return_in_main(CompiledLine& line, const ControlStatement& statement,
                                const std::optional<LineTarget>& target, Block& out) {
    if (!run_.language.rules.return_restarts_main || run_.frame->is_called) {
        out.add(Function::End);
        return Outcome::Block;
    }
    ProgramLine found{run_.frame->unit->begin, run_.frame->unit->begin};
    if (target) {
        const auto fault = run_.map().find(*target, Direction::Forward, found, found);
        if (fault != ProgramMap::Fault::None) {
            return run_.fail(line, fault, diag::JumpTargetMissing, statement.span,
                             quoted("N" + std::to_string(target->number)));
        }
    }
    // A return to a block in front begins it again, too; one to a block behind is a jump. Where
    // a block with a number and the end stand behind, a jump may lead there and end the loop: it is
    // one of the program's.
    const bool is_jump = target && found.line.offset > run_.frame->here.offset;
    const bool is_optionally_skipped = line.line.words.skip_level >= 0;
    const auto is_own_loop = [&] {
        return !run_.options.passes && !is_optionally_skipped &&
               has_exit_behind(run_.dialect, run_.source(), line.program_line.next);
    };
    const std::uint64_t passes = run_.options.passes.value_or(1);
    if (is_jump || is_own_loop() || ++passes_done_ < passes) {
        if (!target) run_.frame->text.has_content = false;
        if (target)
            run_.show_way(WayTaken::Kind::Jump, line.program_line.line, *run_.frame->unit,
                          found.line);
        return run_.jumps.go(line, found, statement.span);
    }
    if (!run_.options.passes) {
        const nc::Span& span = statement.span;
        run_.sink
            .report(diag::MainBeginsAgain,
                    run_.lines.location(line.text, run_.frame->here.line, span))
            .arg(line.text.substr(span.begin, span.end - span.begin));
    }
    out.add(Function::End);
    return Outcome::Block;
}

/// A return inside of a section that is repeated ends only that: on behind the repetition.
bool Returns::cancel_repeat() {
    if (run_.frame->repeats.empty()) return false;
    run_.frame->here = run_.frame->goes_on = run_.frame->repeats.back().behind;
    run_.frame->next_line = nullptr;
    run_.frame->repeats.pop_back();
    run_.jumps.leave_open(run_.frame->here);
    return true;
}

/// The program that runs is through: once more, or back to where it was called.
Outcome Returns::finish(Block& out) {
    if (run_.frame->saves && run_.counts.given > 0) return Outcome::Wait;
    const bool is_jump = run_.frame->returns_to.has_value() || run_.frame->levels > 1;
    if (!is_jump && --run_.frame->left > 0) {
        if (!run_.count_turn()) {
            run_.end();
            CompiledLine nowhere;
            return run_.fail(nowhere, diag::EndlessLoop, {},
                             {std::to_string(run_.options.max_turns)});
        }
        restart(*run_.frame);
        return Outcome::Nothing;
    }
    const std::optional<ProgramLine> target = run_.frame->returns_to;
    const LinePosition from = run_.frame->here;
    ProgramText& left_text = run_.text();
    Outcome done = Outcome::Nothing;
    for (int levels = run_.frame->levels; levels > 0 && run_.frames.size() > 1; --levels) {
        const std::unique_ptr<RunningProgram> left = run_.take_frame();
        run_.resume_frame(*run_.frames.back());
        // The variables that take the contour are gone.
        if (run_.contours.is_left_open(run_.frames.size())) {
            CompiledLine nowhere;
            run_.end();
            return run_.fail(nowhere, diag::ContourUnfinished, {});
        }
        run_.modal_calls.leave_pattern_positions(*left);
        run_.call_parameters.note_returned(*left);
        if (left->is_definition) run_.definitions.leave(*left);
        if (left->inputs != nullptr && run_.frames.back()->inputs == nullptr)
            run_.machine_inputs.leave();
        if (left->saves) run_.interpreter->restore_frames(true);
        if (left->call.is_shape) out.add(Function::CycleCall);
        if (left->saves || left->call.is_shape) run_.lines.modes().restore(left->modal_before, out);
    }
    if (out.function_count > 0 || out.motion != Function::None) {
        out.line = run_.units.line_id(left_text, std::max<std::uint64_t>(from.line, 2) - 1);
        run_.kept.add(out.line, std::max<std::uint64_t>(from.line, 2) - 1, "", &left_text.name,
                      nullptr);
        done = Outcome::Block;
    }
    if (target) {
        run_.note_turn();
        run_.modal_calls.leave_pattern_positions(*run_.frame);
        run_.jumps.leave_open(target->line);
        run_.frame->here = target->line;
        run_.frame->next_line = nullptr;
    }
    return done;
}

/// One more pass of the program that runs.
void Returns::restart(RunningProgram& again) {
    again.is_returning = false;
    again.text.has_content = again.text.has_ended = false;
    again.structures.clear();
    again.repeats.clear();
    again.resume = 0;
    again.has_executed = again.has_given_words = false;
    again.next_line = nullptr;
    again.here = again.unit->begin;
    if (again.call.start >= 0) {
        ProgramLine found;
        const auto fault = again.unit->map.find({{}, again.call.start}, Direction::Forward,
                                                {again.unit->begin, again.unit->begin}, found);
        if (fault == ProgramMap::Fault::None) again.here = found.line;
    }
    if (!again.own_level || again.call.is_macro()) return;
    again.own_level = run_.variables.new_level();
    again.level = again.own_level.get();
    run_.resume_frame(again);
    CompiledLine nowhere;
    run_.call_parameters.bind(nowhere, again.call, again);
}

}  // namespace kadr::macro
