#include "macro/program_run.h"

#include <algorithm>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"

namespace kadr::macro {

using nc::Block;
using nc::ControlStatement;
using nc::Function;
using nc::LineFault;
using nc::Span;
using nc::Statement;

namespace {

/// Lines that are kept compiled; a longer loop is read again each time.
constexpr std::size_t kMostCompiled = 20'000;

}  // namespace

ProgramRun::ProgramRun(const nc::Dialect& dialect_, nc::TextSource& main, std::string name,
                       const ProgramOptions& options_, DiagnosticSink& sink_)
    : ProgramBase(dialect_, main, std::move(name), options_, sink_) {
    variables.system_variables().ask_modal_call([this] { return modal_calls.code(); });
    variables.system_variables().ask_programs(
        [this](std::int64_t level) { return calls.name_at(level); },
        [this](std::string_view asked) { return calls.find_program(asked); });
    events.begin(options.events);
}

// ------------------------------------------------------------------------------ the batch

std::size_t ProgramRun::pull(std::span<Block> out) {
    if (!phase.has_begun) begin_main();
    kept.clear();
    counts.given = 0;
    phase.has_visible_fault = lines.faults().failed();
    variables.system_variables().set_in_step(true);
    while (counts.given < out.size() && !phase.has_ended && take_step()) {
        Block& block = out[counts.given];
        block.reset();
        const bool had_fault = lines.faults().failed();
        const bool is_program = frame->inputs == nullptr && !frame->is_definition;
        if (options.call && is_program && !frames[0]->is_called) [[unlikely]] {
            if (counts.given > 0 || begin_with_arguments(*this) == Outcome::Wait)
                return counts.given;
            if (phase.has_ended) {
                phase.is_only_checking = phase.has_visible_fault = true;
                return counts.given;
            }
        }
        if (events.waits_for_block() && is_program && events.comes_next()) {
            if (counts.given > 0) return counts.given;
            events.begin_block();
        }
        const Outcome done = frame->is_definition       ? definitions.step(block)
                             : frame->inputs != nullptr ? machine_inputs.step(block)
                                                        : step(block);
        if (done == Outcome::Block) ++counts.given;
        // The interpreter goes to a position before the program does there what it does.
        if (frame->at_positions && counts.given > 0) return counts.given;
        variables.system_variables().set_in_step(counts.given == 0);
        if (done == Outcome::Wait) return counts.given;
        if (lines.faults().failed() && !had_fault) {
            phase.is_only_checking = true;
            if (counts.given > 0) return counts.given;
            phase.has_visible_fault = true;
        }
        if (done == Outcome::Block && runs_flat()) take_flat(out);
        if (phase.is_only_checking && done == Outcome::Block && !phase.has_visible_fault)
            return counts.given;
    }
    return counts.given;
}

/// The text is looked at when somebody wants it, and not before.
void ProgramRun::begin_main() {
    phase.has_begun = true;
    units.settle_main();
    frames[0]->unit = &units.main();
    frames[0]->here = units.main().begin;
    machine_inputs.begin();
    definitions.begin();
}

/// Whether nothing but the next line of the text decides what comes.
bool ProgramRun::runs_flat() {
    if (frame->here.offset != frontier().offset || source().offset() != frame->here.offset)
        return false;
    const bool is_called = modal_calls.has_due() || shape_calls.has_modal() || frame->call.to ||
                           frame->is_returning || !modal_calls.is_empty() ||
                           !frame->macros.is_empty();
    const bool is_at_end = phase.is_only_checking || phase.has_ended || lines.bounds().has_ended();
    const bool is_reported = frame->inputs != nullptr || events.waits_for_block();
    return !is_called && !is_at_end && !phase.is_waiting && !is_reported && watch == nullptr &&
           frame->repeats.empty();
}

/// Lines that nobody has executed yet, one behind the other, while they are plain words: in a flat
/// program all. What the usual path asks at each line was asked once, by `runs_flat`.
void ProgramRun::take_flat(std::span<Block> out) {
    nc::LineSource& from = source();
    nc::LineSource::Ahead ahead;
    while (counts.given < out.size() && take_step() && from.look(ahead)) {
        Block& block = out[counts.given];
        block.reset();
        const std::uint64_t number = frame->here.line;
        lines.begin(number);
        if (!lines.read_plain(ahead.line, block)) return;
        from.pass(ahead);
        ++counts.given;
        variables.system_variables().set_in_step(false);
        counts.most_line = std::max(counts.most_line, number);
        const LinePosition next{from.offset(), number + 1};
        if (block.function_count != 0) {  // it may end the program, or call a cycle
            frame->goes_on = next;
            finish_first(Outcome::Block, ahead.line, next, block);
            return;
        }
        frontier() = next;
        frame->here = next;
        deliver(block, ahead.line, number, false);
    }
}

/// Loops without a block give nobody else the occasion to look at the clock. False: the time is
/// over, and the program ends.
bool ProgramRun::take_step() {
    constexpr std::uint32_t kStepsBetween = 1u << 14;
    if (++counts.steps % kStepsBetween != 0 || !options.is_over || !options.is_over()) return true;
    phase.was_stopped = phase.has_ended = true;
    return false;
}

/// Shows the line to who looks on. False: the program ends in front of it.
bool ProgramRun::show(std::string_view text) {
    if (phase.is_only_checking) return true;
    const nc::LineFront front = nc::front_of(tables, text);
    WatchedLine line;
    line.text = text;
    line.line = frame->here.line;
    line.number = front.number;
    line.label = front.label;
    if (frame->unit->text != units.main().text) line.file = frame->unit->text->name;
    if (frames.size() > 1) line.program = frame->unit->name;
    line.level = frames.size() - 1;
    if (watch->comes_to(line)) return true;
    phase.was_stopped = phase.has_ended = true;
    return false;
}

Outcome ProgramRun::step(Block& out) {
    if (writes.has_data() && counts.given == 0) writes.report_data();
    if (modal_calls.has_due()) return modal_calls.begin_due();
    if (frame->at_positions && !phase.is_only_checking) return modal_calls.go_on_at_positions(out);
    if (frame->call.to && frame->here == *frame->call.to) frame->is_returning = true;
    if (frame->is_returning) return returns.finish(out);
    if (skipped_end_ && frame->here.offset >= *skipped_end_) {
        end();
        return Outcome::Nothing;
    }
    if (lines.bounds().has_ended()) return end_of_text();
    if (frame->here.offset >= frontier().offset) return first_time(out);
    CompiledLine* const line =
        frame->next_line != nullptr ? frame->next_line : line_at(frame->here);
    if (line == nullptr) {  // reported; there is no way on
        end();
        return Outcome::Nothing;
    }
    if (watch != nullptr && !show(line->as_written.empty() ? line->text : line->as_written))
        return Outcome::Nothing;
    lines.begin(frame->here.line);
    frame->goes_on = line->program_line.next;
    const Outcome done = run(*line, out);
    if (done == Outcome::Wait) return done;
    frame->resume = 0;
    const bool is_straight = frame->goes_on == line->program_line.next;
    frame->here = frame->goes_on;
    if (is_straight && line != &scratch && frame->here.offset < frontier().offset) {
        if (line->next == nullptr) line->next = line_at(frame->here);
        frame->next_line = line->next == &scratch ? nullptr : line->next;
    } else {
        frame->next_line = nullptr;
    }
    if (!frame->repeats.empty()) advance();
    if (done == Outcome::Block) {
        deliver(out, line->text, line->program_line.line.line, true);
        if (out.function_count != 0)
            shape_calls.follow(out, line->text, ProgramLine(line->program_line));
        if (shape_calls.has_modal()) shape_calls.follow_modal(out);
    }
    calls.perform_begun();
    return done;
}

/// The line that nobody has executed yet: most are plain words, and go straight out.
Outcome ProgramRun::first_time(Block& out) {
    if (phase.is_waiting) {
        frame->goes_on = scratch.program_line.next;
        lines.begin(frame->here.line);
        return finish_first(run(scratch, out), scratch.text, scratch.program_line.next, out);
    }
    if (source().offset() != frame->here.offset && !source().seek(frame->here.offset)) {
        lines.begin(frame->here.line);
        scratch.text.clear();
        scratch.program_line = {frame->here, frame->here};
        end();
        if (lines.faults().failed()) return Outcome::Nothing;  // reported at the jump
        return fail(scratch, diag::TextGone, {}, {"line " + std::to_string(frame->here.line)});
    }
    if (frame->here.offset != frontier().offset) note_passed_text();
    std::string_view text;
    bool is_too_long = false;
    if (!source().next(text, is_too_long))
        return end_for_watch() ? Outcome::Nothing : end_of_text();
    if (watch != nullptr && !show(text)) return Outcome::Nothing;
    text = line_texts.with_macros(text);
    const LinePosition next{source().offset(), frame->here.line + 1};
    frame->goes_on = next;
    counts.most_line = std::max(counts.most_line, frame->here.line);
    if (is_too_long) {
        lines.report_too_long(text, frame->here.line);
        frame->here = frontier() = next;
        return Outcome::Nothing;
    }
    lines.begin(frame->here.line);
    text = lines.without_head(text);
    const bool is_plain = modal_calls.is_empty() || !modal_calls.takes_blocks();
    if (is_plain && lines.read_plain(text, out))
        return finish_first(Outcome::Block, text, next, out);
    scratch.text = text;
    scratch.program_line = {frame->here, next};
    line_compiler.compile(scratch, out);
    const bool is_readable = scratch.kind != CompiledLine::Kind::New;
    const Outcome done = is_readable ? run(scratch, out) : Outcome::Nothing;
    return finish_first(done, scratch.text, next, out);
}

/// next  where the line behind it begins. By value: a position that was stored in parts a moment
///       ago would be waited for by a copy of the whole.
Outcome ProgramRun::finish_first(Outcome done, std::string_view text, LinePosition next,
                                 Block& out) {
    phase.is_waiting = done == Outcome::Wait;
    if (phase.is_waiting) return done;
    frame->resume = 0;
    const std::uint64_t offset = frame->here.offset;
    const std::uint64_t number = frame->here.line;
    frontier() = next;
    frame->here = next;
    if (frame->goes_on != next) frame->here = frame->goes_on;
    if (!frame->repeats.empty()) advance();
    if (done == Outcome::Block) {
        deliver(out, lines.bounds().shown(text, number), number, false);
        if (out.function_count != 0) shape_calls.follow(out, text, {{offset, number}, next});
        if (shape_calls.has_modal()) shape_calls.follow_modal(out);
    }
    calls.perform_begun();
    return done;
}

/// Behind the last line of the program that runs.
Outcome ProgramRun::end_of_text() {
    if (frames.size() > 1 && !phase.is_only_checking) {
        if (language.rules.text_end_returns) {
            frame->is_returning = true;
            return Outcome::Nothing;
        }
        lines.begin(std::max<std::uint64_t>(frame->here.line, 2) - 1);
        scratch.text.clear();
        scratch.program_line = {frame->here, frame->here};
        end();
        return fail(scratch, diag::ReturnMissing, {});
    }
    // Programs that stand behind are read for their mistakes.
    const bool is_at_head = lines.bounds().has_ended() && !language.calls.headers.empty();
    if (!phase.is_only_checking || !is_at_head || !source().seek(frame->here.offset)) {
        end();
        return Outcome::Nothing;
    }
    // Where a sign ends the text its head follows; `%_N_SUB_SPF` is both.
    const bool is_head =
        nc::program_of_header(language.calls, scratch.text, tables.notation.ignores_case)
            .has_value();
    bool is_more = true;
    if (!is_head) {
        std::string_view line;
        bool is_too_long = false;
        is_more = source().next(line, is_too_long);
        frame->here = {source().offset(), frame->here.line + 1};
    }
    frame->text.has_content = frame->text.has_ended = false;
    frontier() = frame->here;
    if (!variables_at_end) variables_at_end = variables.list();
    frame->own_level = variables.new_level();
    frame->level = frame->own_level.get();
    frame->has_executed = false;
    resume_frame(*frame);
    if (!is_more) end();
    return Outcome::Nothing;
}

void ProgramRun::note_passed_text() {
    const bool is_main = frame->unit == &units.main() && !phase.is_only_checking;
    if (is_main) skipped_.add(frontier(), frame->here.offset);
}

bool ProgramRun::check_passed_text() {
    const std::optional<PassedText::Part> part = skipped_.take_first();
    if (!part || phase.was_stopped) return false;
    if (!variables_at_end) variables_at_end = variables.list();
    keep_main_frame();
    if (!frames[0]->is_called) frames[0]->level = &variables.main_level();
    frames[0]->text.has_ended = false;
    resume_frame(*frames[0]);
    frame->here = part->begin;
    frame->next_line = nullptr;
    skipped_end_ = part->end;
    phase.has_ended = false;
    return true;
}

/// Gives the block the number of the call that its program runs in.
void ProgramRun::name_call(Block& block) {
    if (recent_calls.find(frame->site_number) != frame->site.get())
        frame->site_number = recent_calls.add(frame->site);
    block.source = frame->site_number;
}

void ProgramRun::deliver(Block& block, std::string_view text_of_line, std::uint64_t number,
                         bool again) {
    ProgramText& in = text();
    block.line = units.line_id(in, number);
    kept.add(block.line, number, text_of_line, &in.name, frame->site);
    if (frame->site) name_call(block);
    frame->has_executed = true;
    counts.turns = 0;
    if (block.kind == Block::Kind::Nc && !is_left_out(block)) ++counts.blocks;
    if (block.number >= 0) variables.system_variables().set_block_number(block.number);
    if (again && ++counts.repeated > options.max_repeated) {
        lines.report_event(
            text_of_line,
            LineFault{&diag::RepeatedBlocks, {0, 1}, {std::to_string(options.max_repeated)}});
        end();
    }
    if (variables.notes_changes() && block.function_count != 0) writes.note_data(block);
    if (!modal_calls.is_empty()) modal_calls.call_behind(block, text_of_line, number);
    if (block.function_count != 0) end_after(block);
}

/// What stands behind the end of a program is read for its mistakes only; in a subprogram of some
/// controls it is a return.
void ProgramRun::end_after(Block& block) {
    const nc::Invocation* const found = block.find(nc::Fact::EndsProgram);
    if (found == nullptr) return;
    if (is_left_out(block)) return;
    const bool is_cancelled = !frame->repeats.empty() && !phase.is_only_checking;
    if ((frames.size() > 1 || is_cancelled) && language.rules.program_end_returns &&
        !phase.is_only_checking) {
        const auto index = found - block.functions.data();
        const auto begin = block.functions.begin();
        std::move(begin + index + 1, begin + block.function_count, begin + index);
        --block.function_count;
        // Nothing is left of a block that programmed only this.
        const bool is_empty =
            block.function_count == 0 && block.given == 0 && block.motion == Function::None;
        if (is_empty) block.kind = Block::Kind::Comment;
        if (!returns.cancel_repeat()) frame->is_returning = true;
        return;
    }
    phase.is_only_checking = true;
    lines.finish();
    modal_calls.drop_due();
    if (frames.size() == 1) return;
    // The main program knows what is defined, whatever is wrong beside it.
    if (frame->is_definition) variables.share_definitions(variables.main_level());
    // Behind the main program's part that was executed there may be more of it.
    keep_main_frame();
    resume_frame(*frames[0]);
    frame->here = frontier();
    frame->next_line = nullptr;
}

bool ProgramRun::is_left_out(const Block& block) const {
    return block.skip_level >= 0 &&
           ((1u << block.skip_level | block.further_skip_levels) & options.skip_levels) != 0;
}

/// A line that was executed before, kept compiled; nullptr: it cannot be read again.
CompiledLine* ProgramRun::line_at(const LinePosition& position) {
    if (position.offset >= frontier().offset) return nullptr;
    if (const auto known = frame->unit->compiled.find(position.offset);
        known != frame->unit->compiled.end())
        return known->second.get();
    std::string_view text;
    bool is_too_long = false;
    const bool is_there = source().seek(position.offset) && source().next(text, is_too_long);
    CompiledLine* line = &scratch;
    if (frame->unit->compiled.size() < kMostCompiled && is_there) {
        line = frame->unit->compiled.emplace(position.offset, std::make_unique<CompiledLine>())
                   .first->second.get();
    }
    line->text = line_texts.with_macros(text);
    if (watch != nullptr && line->text != text) line->as_written = text;
    line->program_line = {position, {source().offset(), position.line + 1}};
    if (frame->unit == &units.main()) skipped_.take_out(position, line->program_line.next);
    line->kind = CompiledLine::Kind::New;
    line->next = nullptr;
    if (is_there) return line;
    lines.begin(position.line);
    fail(*line, diag::TextGone, {}, {"line " + std::to_string(position.line)});
    return nullptr;
}

/// Behind the end of a section that is repeated: once more, or on behind it.
void ProgramRun::advance() {
    while (!frame->repeats.empty() && frame->here == frame->repeats.back().end) {
        OpenRepeat& repeat = frame->repeats.back();
        frame->next_line = nullptr;
        if (--repeat.left > 0) {
            frame->here = repeat.begin;
            ++counts.turns;
            return;
        }
        frame->here = repeat.behind;
        frame->repeats.pop_back();
    }
}

nc::LineContext ProgramRun::context() const {
    return {variables.names().numbers(),
            frame->is_in_code_call,
            !modal_calls.is_empty() && modal_calls.takes_blocks(),
            options.skip_levels,
            ear.is_listened_to(),
            options.axis_names.empty() ? nullptr : &options.axis_names};
}

// ------------------------------------------------------------------------------ a line

Outcome ProgramRun::run(CompiledLine& line, Block& out) {
    using Kind = CompiledLine::Kind;
    if (line.kind != Kind::New && !(line.context == context())) line.kind = Kind::New;
    if (line.kind == Kind::New || line.kind == Kind::Plain) {
        const bool is_plain = modal_calls.is_empty() || !modal_calls.takes_blocks();
        if (is_plain && lines.read_plain(line.text, out)) {
            line.kind = Kind::Plain;
            line.context = context();
            return Outcome::Block;
        }
        line_compiler.compile(line, out);
    }
    if (line.kind == Kind::End) frame->text.has_ended = true;
    if (line.kind == Kind::Nothing || line.kind == Kind::New || line.kind == Kind::End)
        return Outcome::Nothing;
    if (line.kind == Kind::Known)
        return lines.read_known(line.text, out) ? Outcome::Block : Outcome::Nothing;
    // The time of an event is known behind what was executed.
    if (events.is_pending() && frame->resume == 0 && frame->inputs == nullptr) [[unlikely]] {
        if (counts.given > 0) return Outcome::Wait;
        events.act();
        if (phase.has_ended) return Outcome::Nothing;
    }
    const nc::LexedLine& words = line.line.words;
    if (words.skip_level >= 0 && (options.skip_levels >> words.skip_level & 1u) != 0)
        return Outcome::Nothing;
    if (!words.passed.empty()) {
        lines.bounds().note_content();
        lines.report_passed(words, line.text);
    }
    const std::vector<ControlStatement>& statements = line.line.statements;
    // A subprogram is called behind the words of its block.
    const bool is_call = !line.line.calls.empty();
    const bool is_in_shape = !frame->repeats.empty() && frame->repeats.back().is_shape;
    if (is_call && is_in_shape && !phase.is_only_checking) {
        const nc::Span span = line.line.calls[0].span;
        return fail(line, diag::ShapeBlockWrong, span,
                    {line.text.substr(span.begin, span.end - span.begin)});
    }
    const bool has_words = !words.words.empty() || words.comment_form != nc::kNoForm;
    if (is_call && has_words && !frame->has_given_words) {
        const bool is_return = !statements.empty() && statements[0].kind == Statement::Return;
        if (!language.rules.calls_beside_words_in_cycle && !is_return && is_in_cycle_mode())
            return fail(line, diag::CallInCycleBlock, line.line.calls[0].span);
        const Outcome done = computed_words.read(line, out);
        if (done != Outcome::Block || phase.is_only_checking) return done;
        frame->has_given_words = true;
        frame->goes_on = line.program_line.line;
        return done;
    }
    // Names are declared for the sake of the lines that are only checked.
    const bool is_declaration =
        !statements.empty() &&
        (statements[0].kind == Statement::Declare || statements[0].kind == Statement::DefineMacro ||
         statements[0].kind == Statement::Procedure);
    if (!statements.empty()) lines.bounds().note_content();
    if (!statements.empty() && (!phase.is_only_checking || is_declaration)) {
        const bool is_head = is_declaration || statements[0].kind == Statement::External;
        if (!is_head) frame->has_executed = true;
        while (frame->resume < statements.size()) {
            evaluator.forget();
            if (is_at_limit())
                return fail(line, diag::TooManyLines, statements[frame->resume].span,
                            {std::to_string(counts.executed + counts.blocks),
                             std::to_string(counts.executed)});
            ++counts.executed;
            const Outcome done = execute(line, statements[frame->resume], out);
            if (done != Outcome::Nothing || phase.has_ended) return done;
            if (lines.faults().failed() || frame->goes_on != line.program_line.next)
                return Outcome::Nothing;
            ++frame->resume;
        }
    }
    if (phase.is_only_checking) jumps.check(line, statements);
    if (is_call) {
        if (phase.is_only_checking) call_preparation.check_call(line, statements[0]);
        frame->has_given_words = false;
        return Outcome::Nothing;
    }
    // A number, a label or a comment alone is no block: nothing is executed, and nothing counts it.
    if (!has_words) {
        if (words.number >= 0 && statements.empty())
            variables.system_variables().set_block_number(words.number);
        return Outcome::Nothing;
    }
    return computed_words.read(line, out);
}

}  // namespace kadr::macro
