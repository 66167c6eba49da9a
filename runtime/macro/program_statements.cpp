// Statements of a control's own language: values, messages, what is reported and goes on.
#include <utility>

#include "base/diagnostics/control.h"
#include "macro/program_run.h"
#include "nc/control_words.h"

namespace kadr::macro {

using nc::Block;
using nc::ControlStatement;
using nc::Function;
using nc::Span;
using nc::Statement;

Outcome ProgramRun::execute(CompiledLine& line, const ControlStatement& statement, Block& out) {
    if (!definitions.require_definition(line, statement)) return Outcome::Failed;
    switch (statement.kind) {
        case Statement::None:
        case Statement::JumpToStart:
        case Statement::EndIf:
            if (statement.kind == Statement::EndIf) return jumps.leave(line, statement);
            return Outcome::Nothing;
        case Statement::Assign: return value_statements.assign(line, statement, out);
        case Statement::Jump:
        case Statement::JumpForward:
        case Statement::JumpBackward:
        case Statement::JumpIfThere: return jumps.jump(line, statement);
        case Statement::IfDo: return choose(line, statement, out);
        case Statement::Case: return jumps.choose_case(line, statement);
        case Statement::If:
        case Statement::While:
        case Statement::Loop:
        case Statement::For:
        case Statement::Repeat: return jumps.enter(line, statement);
        case Statement::Else: return jumps.otherwise(line, statement);
        case Statement::EndLoop:
        case Statement::Until: return jumps.leave(line, statement);
        case Statement::Break:
        case Statement::Continue: return jumps.end_pass(line, statement);
        case Statement::RepeatSection:
        case Statement::RepeatBlock: return jumps.repeat_section(line, statement);
        case Statement::Label: return Outcome::Nothing;
        case Statement::CallSection: return calls.call_section(line, statement);
        case Statement::EndSection: {
            if (frames.size() == 1) return Outcome::Nothing;
            ControlStatement end;
            end.kind = Statement::Return;
            end.span = statement.span;
            return calls.execute(line, end, out);
        }
        case Statement::Declare: return value_statements.declare(line, statement);
        case Statement::DefineMacro: return line_texts.define_macro(line, statement);
        case Statement::Synchronous: return pass_synchronous(line, statement);
        case Statement::RunText: return run_text(line, statement, out);
        case Statement::NameVariables: return line_texts.name_variables(line, statement);
        case Statement::Print:
        case Statement::PrintBytes:
        case Statement::PrintOpen:
        case Statement::PrintClose: return printing.execute(line, statement);
        case Statement::ContourBegin:
        case Statement::ContourCode:
        case Statement::ContourEnd:
        case Statement::ContourRow: return contours.execute(line, statement, out);
        case Statement::WriteFile:
        case Statement::ReadFile:
        case Statement::DeleteFile: return file_statements.execute(line, statement);
        case Statement::Call:
        case Statement::CallModal:
        case Statement::CallByText:
        case Statement::EndModal:
        case Statement::Return:
        case Statement::Procedure:
        case Statement::External: return calls.execute(line, statement, out);
        case Statement::Alarm: {
            ControlValue number;
            ControlValue text;
            Outcome done = evaluate(line, statement.value, number);
            if (!goes_on(done)) return done;
            if (statement.second.is_given()) done = evaluate(line, statement.second, text);
            if (!goes_on(done)) return done;
            return value_statements.raise(line, statement.span, number.number,
                                          std::string(evaluator.text(text)));
        }
    }
    return Outcome::Nothing;
}

/// A text as a block of its own. What of it was executed before it had to wait for other blocks is
/// not executed again.
Outcome ProgramRun::run_text(CompiledLine& line, const ControlStatement& statement, Block& out) {
    if (!running_text_) {
        ControlValue text;
        const Outcome done = evaluate(line, statement.second, text);
        if (!goes_on(done)) return done;
        if (!text.is_text()) {
            return fail(line, diag::TypesDiffer, statement.span,
                        {"a block", std::string(kind_name(text))});
        }
        auto block = std::make_unique<CompiledLine>();
        block->text = evaluator.text(text);
        block->program_line = line.program_line;
        const nc::LineFront front = nc::front_of(tables, block->text);
        const bool is_head = front.statement == Statement::Declare ||
                             front.statement == Statement::Procedure ||
                             front.statement == Statement::RunText;
        if (is_head || !front.label.empty())
            return fail(line, diag::TextNoBlock, statement.span, {block->text});
        running_text_ = RunningText{std::move(block), 0};
    }
    const std::size_t outer = std::exchange(frame->resume, running_text_->resume);
    CompiledLine& block = *running_text_->line;
    const Outcome done = run(block, out);
    running_text_->resume = std::exchange(frame->resume, outer);
    if (done == Outcome::Wait) return done;
    running_text_.reset();
    return done;
}

/// What happens beside the motion is not executed; each such action is reported once.
Outcome ProgramRun::pass_synchronous(CompiledLine& line, const ControlStatement& statement) {
    if (!reported_synchronous_.insert({frame->unit, line.program_line.line.offset}).second)
        return Outcome::Nothing;
    const nc::ControlWords words(tables, line.text);
    std::size_t end = statement.span.begin;
    while (end < line.text.size() && !words.is_comment(end)) ++end;
    const Span whole{statement.span.begin,
                     static_cast<std::uint32_t>(words.trim(statement.span.begin, end))};
    DiagnosticBuilder message = sink.report(
        diag::SynchronousPassed, lines.location(line.text, line.program_line.line.line, whole));
    message.arg(line.text.substr(whole.begin, whole.end - whole.begin));
    lines.faults().write_notes(message);
    return Outcome::Nothing;
}

Outcome ProgramRun::choose(CompiledLine& line, const ControlStatement& statement, Block& out) {
    bool is_true = false;
    const Outcome done = truth(line, statement.value, is_true);
    if (!goes_on(done) || !is_true) return done;
    return execute(line, statement.inner[0], out);
}

}  // namespace kadr::macro
