// Where a control program goes on: jumps, sections that are repeated, structures.
#include "macro/program_jumps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/diagnostics/control.h"
#include "macro/fixed_targets.h"
#include "macro/program_base.h"

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
Result<LineTarget, Outcome> Jumps::resolve(CompiledLine& line, const JumpTarget& target) {
    LineTarget out{target.label, target.number};
    if (target.kind == JumpTarget::Kind::Number) out.label.clear();
    if (target.kind != JumpTarget::Kind::Computed) return out;
    ControlValue value;
    const Outcome done = run_.evaluate(line, target.value, value);
    if (!goes_on(done)) return done;
    if (value.is_text())
        return target_named(nc::ControlWords(run_.tables, line.text), run_.evaluator.text(value));
    if (const auto block = block_numbered(run_.tables, value.number)) return *block;
    return run_.fail(line, diag::JumpTargetInvalid, target.span, {run_.evaluator.written(value)});
}

/// Where a jump goes to. An alarm where there is no such target, but for a jump that may have none:
/// nothing is found then.
Outcome Jumps::find_target(CompiledLine& line, const ControlStatement& statement,
                           LineTarget& target, std::optional<ProgramLine>& found) {
    const auto wanted = resolve(line, statement.target);
    if (!wanted) return wanted.error();
    target = *wanted;
    const Direction direction = direction_of(statement.kind);
    ProgramLine program_line;
    const ProgramMap::Fault fault =
        run_.map().find(target, direction, line.program_line, program_line);
    if (fault == ProgramMap::Fault::None) found = program_line;
    if (found || (fault == ProgramMap::Fault::Missing && statement.kind == Statement::JumpIfThere))
        return Outcome::Nothing;
    const std::string what =
        target.label.empty() ? "N" + std::to_string(target.number) : target.label;
    const char* const where = direction == Direction::Forward    ? " behind this block"
                              : direction == Direction::Backward ? " in front of this block"
                                                                 : "";
    return run_.fail(line, fault, diag::JumpTargetMissing, statement.target.span,
                     '`' + what + '`' + where);
}

Outcome Jumps::jump(CompiledLine& line, const ControlStatement& statement) {
    LineTarget target;
    std::optional<ProgramLine> found;
    const Outcome done = find_target(line, statement, target, found);
    if (!goes_on(done) || !found) return done;
    warn_of_twin(line, statement.target.span, target, *found);
    run_.show_way(WayTaken::Kind::Jump, line.program_line.line, *run_.frame->unit, found->line);
    return go(line, *found, statement.span);
}

/// Whether a target is the same wherever its line is reached from.
static bool is_fixed(const nc::ControlLine& code, const JumpTarget& target) {
    if (target.kind != JumpTarget::Kind::Computed) return true;
    return target.value.count == 1 &&
           code.code[target.value.first].kind == nc::ControlInstruction::Kind::Number;
}

/// Of lines that are only read: whether the targets stand in the program. Which of them is computed
/// is not known here.
void Jumps::check(CompiledLine& line, const std::vector<ControlStatement>& statements) {
    for (const ControlStatement& statement : statements) {
        check(line, statement.inner);
        const bool is_jump = statement.kind == Statement::Jump ||
                             statement.kind == Statement::JumpForward ||
                             statement.kind == Statement::JumpBackward;
        if (run_.lines.faults().failed() || !is_jump || !is_fixed(line.line, statement.target))
            continue;
        LineTarget target;
        std::optional<ProgramLine> found;
        find_target(line, statement, target, found);
    }
}

/// A target that stands twice is found as the control looks for it, which need not be the one that
/// was meant. Reported once a target.
void Jumps::warn_of_twin(const CompiledLine& line, const Span& span, const LineTarget& target,
                         const ProgramLine& found) {
    const auto twice = run_.map().twice(target);
    if (!twice || !reported_twins_.emplace(run_.frame->unit, target).second) return;
    const std::string what =
        target.label.empty() ? "N" + std::to_string(target.number) : target.label;
    run_.sink
        .report(diag::JumpTargetTwice,
                run_.lines.location(line.text, line.program_line.line.line, span))
        .arg(what)
        .arg(static_cast<std::size_t>(twice->first))
        .arg(static_cast<std::size_t>(twice->second))
        .arg(static_cast<std::size_t>(found.line.line));
}

Outcome Jumps::go(CompiledLine& line, const ProgramLine& target, const Span& span) {
    const std::uint64_t to = target.line.offset;
    leave_open(target.line);
    run_.frame->goes_on = target.line;
    if (to <= line.program_line.line.offset && !run_.count_turn())
        return run_.fail(line, diag::EndlessLoop, span, {std::to_string(run_.options.max_turns)});
    return Outcome::Nothing;
}

/// A jump leaves structures and sections that the target does not stand in.
void Jumps::leave_open(const LinePosition& target) {
    const std::uint64_t to = target.offset;
    while (!run_.frame->structures.empty() &&
           (to <= run_.frame->structures.back().head.line.offset ||
            to > run_.frame->structures.back().end.line.offset))
        run_.frame->structures.pop_back();
    // A section that is repeated is left for good by a jump out of it.
    while (!run_.frame->repeats.empty() && (to < run_.frame->repeats.back().begin.offset ||
                                            to >= run_.frame->repeats.back().end.offset))
        run_.frame->repeats.pop_back();
}

Outcome Jumps::choose_case(CompiledLine& line, const ControlStatement& statement) {
    ControlValue value;
    Outcome done = run_.evaluate(line, statement.value, value);
    if (!goes_on(done)) return done;
    for (std::size_t i = 0; i < statement.inner.size(); ++i) {
        if (i < statement.list.size()) {
            ControlValue wanted;
            done = run_.evaluate(line, statement.list[i], wanted);
            if (!goes_on(done)) return done;
            const std::optional<bool> is_same = run_.evaluator.is_same(value, wanted);
            if (!is_same) return run_.fail(line, run_.evaluator.fault());
            if (!*is_same) continue;
        }
        return jump(line, statement.inner[i]);
    }
    return Outcome::Nothing;
}

// ------------------------------------------------------------------------------ structures

Outcome Jumps::enter(CompiledLine& line, const ControlStatement& statement) {
    const bool is_known = !run_.frame->structures.empty() &&
                          run_.frame->structures.back().head.line == line.program_line.line &&
                          statement.kind == Statement::While;
    bool is_true = true;
    std::optional<std::int64_t> passes;
    if (statement.kind == Statement::Loop && statement.count.is_given()) {
        const auto counted = count_of(line, statement);
        if (!counted) return counted.error();
        passes = *counted;
        is_true = *passes > 0;
    }
    if (statement.kind == Statement::If || statement.kind == Statement::While) {
        const Outcome done = run_.truth(line, statement.value, is_true);
        if (!goes_on(done)) return done;
    }
    if (!is_known) {
        nc::LineFront front;
        front.statement = statement.kind;
        front.loop = statement.loop;
        const StructureParts* found = nullptr;
        ProgramMap::Crossing crossing;
        const auto fault = run_.map().find_end(line.program_line, front, found, crossing);
        if (fault != ProgramMap::Fault::None) return fail_at_end(line, statement, fault, crossing);
        if (static_cast<int>(run_.frame->structures.size()) >= run_.language.rules.most_levels) {
            return run_.fail(line, diag::StructuresTooDeep, statement.span,
                             {std::to_string(run_.language.rules.most_levels)});
        }
        run_.frame->structures.push_back({statement.kind, statement.loop, line.program_line,
                                          found->end, found->otherwise, 0, nullptr, passes});
        if (statement.kind == Statement::For)
            run_.frame->structures.back().counts = std::make_unique<nc::ControlLine>(line.line);
    }
    OpenStructure& open = run_.frame->structures.back();
    if (statement.kind == Statement::For) {
        ControlValue first;
        ControlValue last;
        Outcome done = run_.evaluate(line, statement.value, first);
        if (goes_on(done)) done = run_.evaluate(line, statement.second, last);
        if (goes_on(done)) {
            first.number = std::round(first.number);
            done = run_.store(line, statement.variable, first);
        }
        if (done == Outcome::Wait) run_.frame->structures.pop_back();
        if (!goes_on(done)) return done;
        open.last = last.number;
        is_true = first.number <= last.number;
    }
    if (is_true) return Outcome::Nothing;
    if (statement.kind == Statement::If && open.otherwise) {
        run_.frame->goes_on = open.otherwise->next;
        return Outcome::Nothing;
    }
    run_.frame->goes_on = open.end.next;
    run_.frame->structures.pop_back();
    return Outcome::Nothing;
}

/// The end of a structure cannot be found: what is in the way is reported with it.
Outcome Jumps::fail_at_end(CompiledLine& line, const ControlStatement& statement,
                           ProgramMap::Fault fault, const ProgramMap::Crossing& crossing) {
    const auto end = static_cast<std::uint32_t>(crossing.text.size());
    if (fault == ProgramMap::Fault::LoopNumber) {
        // Wrong is the loop inside.
        run_.lines.begin(crossing.line);
        const std::string number = std::to_string(statement.loop);
        run_.lines.report_event(crossing.text, {&diag::LoopNumber, {0, end}, {number}})
            .note(run_.lines.location(line.text, line.program_line.line.line, statement.span),
                  "it lies in this loop, which has it");
        run_.lines.begin(line.program_line.line.line);
        return Outcome::Failed;
    }
    if (crossing.line == 0 || fault != ProgramMap::Fault::Missing)
        return run_.fail(line, fault, diag::StructureEndMissing, statement.span, "");
    std::string why = "a condition has one `ELSE`, and this is the second";
    if (!crossing.is_second_else)
        why = crossing.inside == 0 ? "this comes first, and belongs to another structure"
                                   : "this comes while the structure of line " +
                                         std::to_string(crossing.inside) + " is open";
    run_.lines.report_event(line.text, {&diag::StructureEndMissing, statement.span, {}})
        .note(run_.lines.location(crossing.text, crossing.line, {0, end}), std::move(why));
    return Outcome::Failed;
}

/// `ENDIF` that ends no condition, as behind `IF … GOTOF …`, or behind a jump into one: there is
/// nothing to do. Reported once for each.
Outcome Jumps::pass_end(const CompiledLine& line, const ControlStatement& statement) {
    if (!reported_ends_.emplace(run_.frame->unit, line.program_line.line.offset).second)
        return Outcome::Nothing;
    DiagnosticBuilder message = run_.sink.report(
        diag::EndOfNothing,
        run_.lines.location(line.text, line.program_line.line.line, statement.span));
    message.arg(line.text.substr(statement.span.begin, statement.span.end - statement.span.begin));
    run_.lines.faults().write_notes(message);
    return Outcome::Nothing;
}

/// The end of a structure, or of one pass.
Outcome Jumps::leave(CompiledLine& line, const ControlStatement& statement) {
    const auto is_own = [&](const OpenStructure& open) {
        return open.end.line == line.program_line.line;
    };
    const bool is_of_none = std::ranges::none_of(run_.frame->structures, is_own);
    if (is_of_none && statement.kind == Statement::EndIf) return pass_end(line, statement);
    while (!run_.frame->structures.empty() && !is_own(run_.frame->structures.back()))
        run_.frame->structures.pop_back();
    if (run_.frame->structures.empty())
        return run_.fail(line, diag::StructureBeginMissing, statement.span);
    OpenStructure& open = run_.frame->structures.back();
    bool once_more = false;
    switch (open.kind) {
        case Statement::While: run_.frame->goes_on = open.head.line; break;
        case Statement::Loop:
            if (open.left && --*open.left <= 0) {
                run_.frame->structures.pop_back();
                return Outcome::Nothing;
            }
            run_.frame->goes_on = open.head.next;
            break;
        case Statement::For: {
            const Outcome done = count_on(line, open, once_more);
            if (!goes_on(done)) return done;
            break;
        }
        case Statement::Repeat: {
            const Outcome done = run_.truth(line, statement.value, once_more);
            if (!goes_on(done)) return done;
            once_more = !once_more;
            break;
        }
        default: run_.frame->structures.pop_back(); return Outcome::Nothing;
    }
    if (open.kind == Statement::For || open.kind == Statement::Repeat) {
        if (!once_more) {
            run_.frame->structures.pop_back();
            return Outcome::Nothing;
        }
        run_.frame->goes_on = open.head.next;
    }
    if (!run_.count_turn())
        return run_.fail(line, diag::EndlessLoop, statement.span,
                         {std::to_string(run_.options.max_turns)});
    return Outcome::Nothing;
}

/// A loop is left, or the rest of its pass is.
Outcome Jumps::end_pass(CompiledLine& line, const ControlStatement& statement) {
    auto& open = run_.frame->structures;
    const auto is_meant = [&](const OpenStructure& each) {
        return each.kind != Statement::If && (statement.loop == 0 || each.loop == statement.loop);
    };
    if (std::ranges::none_of(open, is_meant))
        return run_.fail(line, diag::StructureBeginMissing, statement.span);
    while (!is_meant(open.back())) open.pop_back();
    const ProgramLine end = open.back().end;
    if (statement.kind == Statement::Continue) {
        run_.frame->goes_on = end.line;
        return Outcome::Nothing;
    }
    open.pop_back();
    run_.frame->goes_on = end.next;
    return Outcome::Nothing;
}

/// How often the blocks of a section or of a loop are wanted.
Result<std::int64_t, Outcome> Jumps::count_of(CompiledLine& line,
                                              const ControlStatement& statement) {
    ControlValue count;
    const Outcome done = run_.evaluate(line, statement.count, count);
    if (!goes_on(done)) return done;
    const double wanted = std::round(count.number);
    if (!(wanted >= 0 && wanted <= kMostPasses))
        return run_.fail(line, diag::RepeatCount, statement.count.span,
                         {run_.evaluator.written(count)});
    return static_cast<std::int64_t>(wanted);
}

/// The counter of a For takes its next value.
Outcome Jumps::count_on(CompiledLine& line, OpenStructure& loop, bool& goes_on_looping) {
    const nc::ControlLine& code = *loop.counts;
    const nc::Reference& counter = code.statements[0].variable;
    std::array<std::int64_t, 4> indices{};
    if (counter.indices.is_given() &&
        run_.evaluator.indices(code, counter, indices) != Evaluator::Outcome::Done)
        return run_.fail(line, run_.evaluator.fault());
    ControlValue value;
    if (!run_.variables.load(counter.load, indices, value))
        return run_.fail(line, diag::VariableNumber, counter.span, {"of the counter"});
    value = ControlValue::of(std::round(value.number) + 1, counter.load.type);
    goes_on_looping = value.number <= loop.last;
    const auto fault = run_.variables.store(counter.load, indices, value, {});
    if (fault.row != nullptr) return run_.fail(line, *fault.row, counter.span, fault.arguments);
    return Outcome::Nothing;
}

Outcome Jumps::otherwise(CompiledLine& line, const ControlStatement& statement) {
    const auto is_own = [&](const OpenStructure& open) {
        return open.otherwise && open.otherwise->line == line.program_line.line;
    };
    while (!run_.frame->structures.empty() && !is_own(run_.frame->structures.back()))
        run_.frame->structures.pop_back();
    if (run_.frame->structures.empty())
        return run_.fail(line, diag::StructureBeginMissing, statement.span);
    run_.frame->goes_on = run_.frame->structures.back().end.next;
    run_.frame->structures.pop_back();
    return Outcome::Nothing;
}

Outcome Jumps::repeat_section(CompiledLine& line, const ControlStatement& statement) {
    std::int64_t passes = 1;
    if (statement.count.is_given()) {
        const auto counted = count_of(line, statement);
        if (!counted) return counted.error();
        passes = *counted;
    }
    const auto target = resolve(line, statement.from);
    if (!target) return target.error();
    const auto missing = [&](ProgramMap::Fault fault, const JumpTarget& which) {
        return run_.fail(line, fault, diag::RepeatLabelMissing, which.span,
                         '`' + which.label + '`');
    };
    ProgramLine begin;
    // Toward the head first, then forward.
    ProgramMap::Fault fault =
        run_.map().find(*target, Direction::Backward, line.program_line, begin);
    if (fault == ProgramMap::Fault::Missing)
        fault = run_.map().find(*target, Direction::Forward, line.program_line, begin);
    if (fault != ProgramMap::Fault::None) return missing(fault, statement.from);
    OpenRepeat repeat{begin.line, line.program_line.line, line.program_line.next, passes, false};
    const bool is_behind = begin.line.offset > line.program_line.line.offset;
    if (statement.kind == Statement::RepeatBlock) {
        repeat.end = begin.next;
    } else if (statement.to.kind != JumpTarget::Kind::None) {
        const auto last = resolve(line, statement.to);
        if (!last) return last.error();
        ProgramLine end;
        fault = run_.map().find(*last, Direction::Forward, begin, end);
        const bool is_before_end = fault == ProgramMap::Fault::None &&
                                   (is_behind || end.line.offset < line.program_line.line.offset);
        if (is_before_end) repeat.end = end.next;
        if (fault != ProgramMap::Fault::None) return missing(fault, statement.to);
    } else if (!run_.language.end_label.empty()) {
        ProgramLine end;
        const LinePosition limit =
            is_behind ? LinePosition{~std::uint64_t{0}, 0} : line.program_line.line;
        fault = run_.map().find_label_between(run_.language.end_label, begin.line, limit, end);
        if (fault == ProgramMap::Fault::None) repeat.end = end.next;
        if (fault != ProgramMap::Fault::None && is_behind) return missing(fault, statement.from);
    }
    if (passes == 0) return Outcome::Nothing;
    // Behind the frontier nothing was executed yet: those lines run for the first time here, and
    // once more later.
    if (!run_.count_turn())
        return run_.fail(line, diag::EndlessLoop, statement.span,
                         {std::to_string(run_.options.max_turns)});
    run_.show_way(WayTaken::Kind::Repeat, line.program_line.line, *run_.frame->unit, begin.line);
    run_.frame->repeats.push_back(repeat);
    run_.frame->goes_on = begin.line;
    return Outcome::Nothing;
}

}  // namespace kadr::macro
