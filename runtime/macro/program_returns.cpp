// program_returns.cpp — returns: to the caller, to the next pass, to the main program's
// head.
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/diagnostics/control.h"
#include "base/diagnostics/doubtful.h"
#include "macro/program_state.h"
#include "nc/quoted.h"

namespace kadr::macro {

using nc::Block;
using nc::ControlStatement;
using nc::Function;
using nc::quoted;

Program::State::Outcome Program::State::leave_program(CompiledLine& line,
                                                      const ControlStatement& statement,
                                                      Block& out) {
    const nc::Call* const words =
        line.line.calls.empty() ? nullptr : &line.line.calls[statement.call];
    std::optional<LineTarget> target;
    if (statement.target.kind != nc::JumpTarget::Kind::None) {
        const auto wanted = resolve(line, statement.target);
        if (!wanted) return wanted.error();
        if (!wanted->label.empty() || wanted->number >= 0) target = *wanted;
    }
    std::optional<double> number;
    Outcome done = Outcome::Nothing;
    if (words != nullptr) done = number_of(line, words->target, number);
    if (!goes_on(done)) return done;
    if (number) target = LineTarget{{}, static_cast<std::int64_t>(*number)};
    if (!target && cancel_repeat()) return Outcome::Nothing;
    if (frames.size() == 1) return return_in_main(line, statement, target, out);
    if (frame->call.is_modal && !line.line.words.words.empty()) {
        return fail(
            line, diag::ReturnWithWords, statement.span,
            {line.text.substr(statement.span.begin, statement.span.end - statement.span.begin)});
    }
    // How many levels, and which block of the program that goes on.
    Value behind;
    Value levels = Value::real(1);
    if (statement.value.is_given()) done = evaluate(line, statement.value, behind);
    if (!goes_on(done)) return done;
    if (statement.count.is_given()) done = evaluate(line, statement.count, levels);
    if (!goes_on(done)) return done;
    const auto most = static_cast<double>(frames.size() - 1);
    frame->levels = static_cast<int>(std::clamp(std::round(levels.number), 1.0, most));
    if (target) {
        Frame& next = *frames[frames.size() - 1 - static_cast<std::size_t>(frame->levels)];
        Place found;
        const auto fault = next.unit->map.find(*target, Direction::Forward,
                                               {next.unit->begin, next.unit->begin}, found);
        const std::string what =
            target->label.empty() ? "N" + std::to_string(target->number) : target->label;
        if (fault != ProgramMap::Fault::None)
            return fail(line, fault, diag::JumpTargetMissing, statement.span, quoted(what));
        if (behind.number > 0) found.line = found.next;
        frame->returns_to = found;
    }
    std::optional<double> left;
    if (words != nullptr) done = number_of(line, words->repeats, left);
    if (!goes_on(done)) return done;
    // The pass that ends is counted off.
    if (left) frame->left = static_cast<std::int64_t>(std::clamp(*left, 0.0, 1e9)) + 1;
    frame->is_returning = true;
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

/// Whether a jump may end the program in front of the place: a block with a number stands in the
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
Program::State::Outcome Program::State::return_in_main(CompiledLine& line,
                                                       const ControlStatement& statement,
                                                       const std::optional<LineTarget>& target,
                                                       Block& out) {
    if (!language.rules.return_restarts_main || frame->is_called) {
        out.add(Function::End);
        return Outcome::Block;
    }
    Place found{frame->unit->begin, frame->unit->begin};
    if (target) {
        const auto fault = map().find(*target, Direction::Forward, found, found);
        if (fault != ProgramMap::Fault::None) {
            return fail(line, fault, diag::JumpTargetMissing, statement.span,
                        quoted("N" + std::to_string(target->number)));
        }
    }
    // A return to a block in front begins it again, too; one to a block behind is a jump. Where
    // a block with a number and the end stand behind, a jump may lead there and end the loop: it is
    // one of the program's.
    const bool is_jump = target && found.line.offset > frame->here.offset;
    const bool is_skipped_at_will = line.line.words.skip >= 0;
    const auto is_own_loop = [&] {
        return !options.passes && !is_skipped_at_will &&
               has_exit_behind(dialect, source(), line.place.next);
    };
    const std::uint64_t passes = options.passes.value_or(1);
    if (is_jump || is_own_loop() || ++passes_done < passes) {
        if (!target) frame->text.has_content = false;
        return go(line, found, statement.span);
    }
    if (!options.passes) {
        const nc::Span& span = statement.span;
        sink.report(diag::MainBeginsAgain, lines.place(line.text, frame->here.line, span))
            .arg(line.text.substr(span.begin, span.end - span.begin));
    }
    out.add(Function::End);
    return Outcome::Block;
}

/// A return inside of a section that is repeated ends only that: on behind the repetition.
bool Program::State::cancel_repeat() {
    if (frame->repeats.empty()) return false;
    frame->here = frame->goes_on = frame->repeats.back().behind;
    frame->next_line = nullptr;
    frame->repeats.pop_back();
    leave_open(frame->here);
    return true;
}

/// The program that runs is through: once more, or back to where it was called.
Program::State::Outcome Program::State::finish_return(Block& out) {
    if (frame->saves && given > 0) return Outcome::Wait;
    const bool is_jump = frame->returns_to.has_value() || frame->levels > 1;
    if (!is_jump && --frame->left > 0) {
        if (++turns > options.max_turns) {
            has_ended = true;
            CompiledLine nowhere;
            return fail(nowhere, diag::EndlessLoop, {}, {std::to_string(options.max_turns)});
        }
        restart(*frame);
        return Outcome::Nothing;
    }
    const std::optional<Place> target = frame->returns_to;
    const LinePosition from = frame->here;
    ProgramText& left_text = text();
    Outcome done = Outcome::Nothing;
    for (int levels = frame->levels; levels > 0 && frames.size() > 1; --levels) {
        const std::unique_ptr<Frame> left = std::move(frames.back());
        frames.pop_back();
        resume_frame(*frames.back());
        // The variables that take the contour are gone.
        if (open_contour && frames.size() < open_contour->depth) {
            CompiledLine nowhere;
            has_ended = true;
            return fail(nowhere, diag::ContourUnfinished, {});
        }
        leave_places(*left);
        note_returned(*left);
        if (left->is_definition) leave_definition(*left);
        if (left->inputs != nullptr && frames.back()->inputs == nullptr) leave_inputs();
        if (left->saves) interpreter->restore_frames(true);
        if (left->call.is_shape) out.add(Function::CycleCall);
        if (left->saves || left->call.is_shape) lines.restore(left->modal_before, out);
    }
    if (out.function_count > 0 || out.motion != Function::None) {
        out.line = units.line_id(left_text, std::max<std::uint64_t>(from.line, 2) - 1);
        kept.add(out.line, std::max<std::uint64_t>(from.line, 2) - 1, "", &left_text.name, nullptr);
        done = Outcome::Block;
    }
    if (target) {
        ++turns;
        leave_places(*frame);
        leave_open(target->line);
        frame->here = target->line;
        frame->next_line = nullptr;
    }
    return done;
}

/// One more pass of the program that runs.
void Program::State::restart(Frame& again) {
    again.is_returning = false;
    again.text.has_content = again.text.has_ended = false;
    again.structures.clear();
    again.repeats.clear();
    again.resume = 0;
    again.has_executed = again.has_given_words = false;
    again.next_line = nullptr;
    again.here = again.unit->begin;
    if (again.call.start >= 0) {
        Place found;
        const auto fault = again.unit->map.find({{}, again.call.start}, Direction::Forward,
                                                {again.unit->begin, again.unit->begin}, found);
        if (fault == ProgramMap::Fault::None) again.here = found.line;
    }
    if (!again.own_level || again.call.is_macro()) return;
    again.own_level = variables.new_level();
    again.level = again.own_level.get();
    resume_frame(again);
    CompiledLine nowhere;
    bind_parameters(nowhere, again.call, again);
}

}  // namespace kadr::macro
