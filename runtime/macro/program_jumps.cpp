// Where a control program goes on: jumps, sections that are repeated, structures.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/diagnostics/control.h"
#include "macro/program_state.h"
#include "nc/control_words.h"

namespace kadr::macro {

using nc::Block;
using nc::ControlStatement;
using nc::JumpTarget;
using nc::Span;
using nc::Statement;

namespace {

constexpr double kMostPasses = 9999;  // of a section that is repeated; S 8.7

}  // namespace

/// Which line a target means, or what this line comes to where that is not known.
Result<LineTarget, Program::State::Outcome> Program::State::resolve(CompiledLine& line,
                                                                    const JumpTarget& target) {
    LineTarget out{target.label, target.number};
    if (target.kind == JumpTarget::Kind::Number) out.label.clear();
    if (target.kind != JumpTarget::Kind::Computed) return out;
    Value value;
    const Outcome done = evaluate(line, target.value, value);
    if (!goes_on(done)) return done;
    if (value.is_text()) {
        const nc::ControlWords words(tables, line.text);
        out.label = words.normal(evaluator.text(value));
        out.number = words.block_number(out.label);
        if (out.number >= 0) out.label.clear();
        return out;
    }
    const double number = value.number;
    if (number != std::floor(number) || number < 1 ||
        number > static_cast<double>(tables.block_numbers.most))
        return fail(line, diag::JumpTargetInvalid, target.span, {evaluator.written(value)});
    out.label.clear();
    out.number = static_cast<std::int64_t>(number);
    return out;
}

/// Where a jump goes to. An alarm where there is no such place, but for a jump that may have none:
/// nothing is found then.
Program::State::Outcome Program::State::find_target(CompiledLine& line,
                                                    const ControlStatement& statement,
                                                    LineTarget& target,
                                                    std::optional<Place>& found) {
    const auto wanted = resolve(line, statement.target);
    if (!wanted) return wanted.error();
    target = *wanted;
    const Direction direction = statement.kind == Statement::JumpForward    ? Direction::Forward
                                : statement.kind == Statement::JumpBackward ? Direction::Backward
                                                                            : Direction::Both;
    Place place;
    const ProgramMap::Fault fault = map().find(target, direction, line.place, place);
    if (fault == ProgramMap::Fault::None) found = place;
    if (found || (fault == ProgramMap::Fault::Missing && statement.kind == Statement::JumpIfThere))
        return Outcome::Nothing;
    const std::string what =
        target.label.empty() ? "N" + std::to_string(target.number) : target.label;
    const char* const where = direction == Direction::Forward    ? " behind this block"
                              : direction == Direction::Backward ? " in front of this block"
                                                                 : "";
    return fail(line, fault, diag::JumpTargetMissing, statement.target.span,
                '`' + what + '`' + where);
}

Program::State::Outcome Program::State::jump(CompiledLine& line,
                                             const ControlStatement& statement) {
    LineTarget target;
    std::optional<Place> found;
    const Outcome done = find_target(line, statement, target, found);
    if (!goes_on(done) || !found) return done;
    warn_of_twin(line, statement.target.span, target, *found);
    return go(line, *found, statement.span);
}

/// Whether a target is the same wherever its line is reached from.
static bool is_fixed(const nc::ControlLine& code, const JumpTarget& target) {
    if (target.kind != JumpTarget::Kind::Computed) return true;
    return target.value.count == 1 &&
           code.code[target.value.first].kind == nc::Instruction::Kind::Number;
}

/// Of lines that are only read: whether the targets stand in the program. Which of them is computed
/// is not known here.
void Program::State::check_jumps(CompiledLine& line,
                                 const std::vector<ControlStatement>& statements) {
    for (const ControlStatement& statement : statements) {
        check_jumps(line, statement.inner);
        const bool is_jump = statement.kind == Statement::Jump ||
                             statement.kind == Statement::JumpForward ||
                             statement.kind == Statement::JumpBackward;
        if (lines.failed() || !is_jump || !is_fixed(line.line, statement.target)) continue;
        LineTarget target;
        std::optional<Place> found;
        find_target(line, statement, target, found);
    }
}

/// A target that stands twice is found as the control looks for it, which need not be the one that
/// was meant. Said once a target.
void Program::State::warn_of_twin(const CompiledLine& line, const Span& span,
                                  const LineTarget& target, const Place& found) {
    const auto twice = map().twice(target);
    if (!twice || !said_twice.emplace(frame->unit, target).second) return;
    const std::string what =
        target.label.empty() ? "N" + std::to_string(target.number) : target.label;
    sink.report(diag::JumpTargetTwice, lines.place(line.text, line.place.line.line, span))
        .arg(what)
        .arg(static_cast<std::size_t>(twice->first))
        .arg(static_cast<std::size_t>(twice->second))
        .arg(static_cast<std::size_t>(found.line.line));
}

Program::State::Outcome Program::State::go(CompiledLine& line, const Place& target,
                                           const Span& span) {
    const std::uint64_t to = target.line.offset;
    leave_open(target.line);
    frame->goes_on = target.line;
    if (to <= line.place.line.offset && ++turns > options.max_turns)
        return fail(line, diag::EndlessLoop, span, {std::to_string(options.max_turns)});
    return Outcome::Nothing;
}

/// A jump leaves structures and sections that the target does not stand in.
void Program::State::leave_open(const LinePosition& target) {
    const std::uint64_t to = target.offset;
    while (!frame->structures.empty() && (to <= frame->structures.back().head.line.offset ||
                                          to > frame->structures.back().end.line.offset))
        frame->structures.pop_back();
    // A section that is repeated is left for good by a jump out of it.
    while (!frame->repeats.empty() &&
           (to < frame->repeats.back().begin.offset || to >= frame->repeats.back().end.offset))
        frame->repeats.pop_back();
}

Program::State::Outcome Program::State::choose(CompiledLine& line,
                                               const ControlStatement& statement, Block& out) {
    bool is_true = false;
    const Outcome done = truth(line, statement.value, is_true);
    if (!goes_on(done) || !is_true) return done;
    return execute(line, statement.inner[0], out);
}

Program::State::Outcome Program::State::choose_case(CompiledLine& line,
                                                    const ControlStatement& statement) {
    Value value;
    Outcome done = evaluate(line, statement.value, value);
    if (!goes_on(done)) return done;
    for (std::size_t i = 0; i < statement.inner.size(); ++i) {
        if (i < statement.list.size()) {
            Value wanted;
            done = evaluate(line, statement.list[i], wanted);
            if (!goes_on(done)) return done;
            const std::optional<bool> is_same = evaluator.is_same(value, wanted);
            if (!is_same) return fail(line, evaluator.fault());
            if (!*is_same) continue;
        }
        return jump(line, statement.inner[i]);
    }
    return Outcome::Nothing;
}

// ------------------------------------------------------------------------------ structures

Program::State::Outcome Program::State::enter(CompiledLine& line,
                                              const ControlStatement& statement) {
    const bool is_known = !frame->structures.empty() &&
                          frame->structures.back().head.line == line.place.line &&
                          statement.kind == Statement::While;
    bool is_true = true;
    if (statement.kind == Statement::If || statement.kind == Statement::While) {
        const Outcome done = truth(line, statement.value, is_true);
        if (!goes_on(done)) return done;
    }
    if (!is_known) {
        nc::LineFront front;
        front.statement = statement.kind;
        front.loop = statement.loop;
        const Structure* found = nullptr;
        ProgramMap::Crossing crossing;
        const auto fault = map().find_end(line.place, front, found, crossing);
        if (fault != ProgramMap::Fault::None) return fail(line, statement, fault, crossing);
        if (static_cast<int>(frame->structures.size()) >= language.rules.most_levels) {
            return fail(line, diag::StructuresTooDeep, statement.span,
                        {std::to_string(language.rules.most_levels)});
        }
        frame->structures.push_back(
            {statement.kind, statement.loop, line.place, found->end, found->otherwise, 0, nullptr});
        if (statement.kind == Statement::For)
            frame->structures.back().counts = std::make_unique<nc::ControlLine>(line.line);
    }
    OpenStructure& open = frame->structures.back();
    if (statement.kind == Statement::For) {
        Value first;
        Value last;
        Outcome done = evaluate(line, statement.value, first);
        if (goes_on(done)) done = evaluate(line, statement.second, last);
        if (goes_on(done)) {
            first.number = std::round(first.number);
            done = store(line, statement.variable, first);
        }
        if (done == Outcome::Wait) frame->structures.pop_back();
        if (!goes_on(done)) return done;
        open.last = last.number;
        is_true = first.number <= last.number;
    }
    if (is_true) return Outcome::Nothing;
    if (statement.kind == Statement::If && open.otherwise) {
        frame->goes_on = open.otherwise->next;
        return Outcome::Nothing;
    }
    frame->goes_on = open.end.next;
    frame->structures.pop_back();
    return Outcome::Nothing;
}

/// The end of a structure cannot be found: what is in the way is told with it.
Program::State::Outcome Program::State::fail(CompiledLine& line, const ControlStatement& statement,
                                             ProgramMap::Fault fault,
                                             const ProgramMap::Crossing& crossing) {
    const auto end = static_cast<std::uint32_t>(crossing.text.size());
    if (fault == ProgramMap::Fault::LoopNumber) {
        // Wrong is the loop inside.
        lines.begin(crossing.line);
        const std::string number = std::to_string(statement.loop);
        lines.report_event(crossing.text, {&diag::LoopNumber, {0, end}, {number}})
            .note(lines.place(line.text, line.place.line.line, statement.span),
                  "it lies in this loop, which has it");
        lines.begin(line.place.line.line);
        return Outcome::Failed;
    }
    if (crossing.line == 0 || fault != ProgramMap::Fault::Missing)
        return fail(line, fault, diag::StructureEndMissing, statement.span, "");
    std::string why = "a condition has one `ELSE`, and this is the second";
    if (!crossing.is_second_else)
        why = crossing.inside == 0 ? "this comes first, and belongs to another structure"
                                   : "this comes while the structure of line " +
                                         std::to_string(crossing.inside) + " is open";
    lines.report_event(line.text, {&diag::StructureEndMissing, statement.span, {}})
        .note(lines.place(crossing.text, crossing.line, {0, end}), std::move(why));
    return Outcome::Failed;
}

/// `ENDIF` that ends no condition, as behind `IF … GOTOF …`, or behind a jump into one: there is
/// nothing to do. Said once for each.
Program::State::Outcome Program::State::pass_end(const CompiledLine& line,
                                                 const ControlStatement& statement) {
    if (!said_ends.emplace(frame->unit, line.place.line.offset).second) return Outcome::Nothing;
    DiagnosticBuilder message = sink.report(
        diag::EndOfNothing, lines.place(line.text, line.place.line.line, statement.span));
    message.arg(line.text.substr(statement.span.begin, statement.span.end - statement.span.begin));
    lines.write_notes(message);
    return Outcome::Nothing;
}

/// The end of a structure, or of one pass.
Program::State::Outcome Program::State::leave(CompiledLine& line,
                                              const ControlStatement& statement) {
    const auto is_own = [&](const OpenStructure& open) { return open.end.line == line.place.line; };
    const bool is_of_none = std::ranges::none_of(frame->structures, is_own);
    if (is_of_none && statement.kind == Statement::EndIf) return pass_end(line, statement);
    while (!frame->structures.empty() && !is_own(frame->structures.back()))
        frame->structures.pop_back();
    if (frame->structures.empty()) return fail(line, diag::StructureBeginMissing, statement.span);
    OpenStructure& open = frame->structures.back();
    bool once_more = false;
    switch (open.kind) {
        case Statement::While: frame->goes_on = open.head.line; break;
        case Statement::Loop: frame->goes_on = open.head.next; break;
        case Statement::For: {
            const Outcome done = count_on(line, open, once_more);
            if (!goes_on(done)) return done;
            break;
        }
        case Statement::Repeat: {
            const Outcome done = truth(line, statement.value, once_more);
            if (!goes_on(done)) return done;
            once_more = !once_more;
            break;
        }
        default: frame->structures.pop_back(); return Outcome::Nothing;
    }
    if (open.kind == Statement::For || open.kind == Statement::Repeat) {
        if (!once_more) {
            frame->structures.pop_back();
            return Outcome::Nothing;
        }
        frame->goes_on = open.head.next;
    }
    if (++turns > options.max_turns)
        return fail(line, diag::EndlessLoop, statement.span, {std::to_string(options.max_turns)});
    return Outcome::Nothing;
}

/// The counter of a For takes its next value.
Program::State::Outcome Program::State::count_on(CompiledLine& line, OpenStructure& loop,
                                                 bool& goes_on_looping) {
    const nc::ControlLine& code = *loop.counts;
    const nc::Reference& counter = code.statements[0].variable;
    std::array<std::int64_t, 4> indices{};
    if (counter.indices.is_given() &&
        evaluator.indices(code, counter, indices) != Evaluator::Outcome::Done)
        return fail(line, evaluator.fault());
    Value value;
    if (!variables.load(counter.load, indices, value))
        return fail(line, diag::VariableNumber, counter.span, {"of the counter"});
    value = Value::of(std::round(value.number) + 1, counter.load.type);
    goes_on_looping = value.number <= loop.last;
    const auto fault = variables.store(counter.load, indices, value, {});
    if (fault.row != nullptr) return fail(line, *fault.row, counter.span, fault.arguments);
    return Outcome::Nothing;
}

Program::State::Outcome Program::State::otherwise(CompiledLine& line,
                                                  const ControlStatement& statement) {
    const auto is_own = [&](const OpenStructure& open) {
        return open.otherwise && open.otherwise->line == line.place.line;
    };
    while (!frame->structures.empty() && !is_own(frame->structures.back()))
        frame->structures.pop_back();
    if (frame->structures.empty()) return fail(line, diag::StructureBeginMissing, statement.span);
    frame->goes_on = frame->structures.back().end.next;
    frame->structures.pop_back();
    return Outcome::Nothing;
}

Program::State::Outcome Program::State::repeat_section(CompiledLine& line,
                                                       const ControlStatement& statement) {
    std::int64_t passes = 1;
    if (statement.count.is_given()) {
        Value count;
        const Outcome done = evaluate(line, statement.count, count);
        if (!goes_on(done)) return done;
        const double wanted = std::round(count.number);
        if (!(wanted >= 0 && wanted <= kMostPasses))
            return fail(line, diag::RepeatCount, statement.count.span, {evaluator.written(count)});
        passes = static_cast<std::int64_t>(wanted);
    }
    const auto target = resolve(line, statement.from);
    if (!target) return target.error();
    const auto missing = [&](ProgramMap::Fault fault, const JumpTarget& which) {
        return fail(line, fault, diag::RepeatLabelMissing, which.span, '`' + which.label + '`');
    };
    Place begin;
    // Toward the head first, then forward.
    ProgramMap::Fault fault = map().find(*target, Direction::Backward, line.place, begin);
    if (fault == ProgramMap::Fault::Missing)
        fault = map().find(*target, Direction::Forward, line.place, begin);
    if (fault != ProgramMap::Fault::None) return missing(fault, statement.from);
    OpenRepeat repeat{begin.line, line.place.line, line.place.next, passes, false};
    const bool is_behind = begin.line.offset > line.place.line.offset;
    if (statement.kind == Statement::RepeatBlock) {
        repeat.end = begin.next;
    } else if (statement.to.kind != JumpTarget::Kind::None) {
        const auto last = resolve(line, statement.to);
        if (!last) return last.error();
        Place end;
        fault = map().find(*last, Direction::Forward, begin, end);
        const bool is_before_end = fault == ProgramMap::Fault::None &&
                                   (is_behind || end.line.offset < line.place.line.offset);
        if (is_before_end) repeat.end = end.next;
        if (fault != ProgramMap::Fault::None) return missing(fault, statement.to);
    } else if (!language.end_label.empty()) {
        Place end;
        const LinePosition limit = is_behind ? LinePosition{~std::uint64_t{0}, 0} : line.place.line;
        fault = map().find_label_between(language.end_label, begin.line, limit, end);
        if (fault == ProgramMap::Fault::None) repeat.end = end.next;
        if (fault != ProgramMap::Fault::None && is_behind) return missing(fault, statement.from);
    }
    if (passes == 0) return Outcome::Nothing;
    // Behind the frontier nothing was executed yet: those lines run for the first time here, and
    // once more later.
    if (++turns > options.max_turns)
        return fail(line, diag::EndlessLoop, statement.span, {std::to_string(options.max_turns)});
    frame->repeats.push_back(repeat);
    frame->goes_on = begin.line;
    return Outcome::Nothing;
}

}  // namespace kadr::macro
