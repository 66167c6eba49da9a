#include "macro/program.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/diagnostics/control.h"
#include "base/diagnostics/danger.h"
#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "macro/program_state.h"
#include "nc/control_words.h"

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

/// Whether a call of the block has no parameter that names an axis.
bool takes_no_axis(const Block& block) {
    const auto names_axis = [](const nc::Parameter& parameter) {
        return parameter.name.starts_with("axis");
    };
    for (const nc::Invocation& invocation :
         std::span(block.functions).first(block.function_count)) {
        const auto parameters = nc::info(invocation.function).parameters;
        if (invocation.function == Function::Cycle) return true;
        if (!parameters.empty() && std::ranges::none_of(parameters, names_axis)) return true;
    }
    return false;
}

}  // namespace

Program::State::State(const nc::Dialect& dialect_, nc::TextSource& text, std::string name,
                      const ProgramOptions& options_, DiagnosticSink& sink_)
    : dialect(dialect_),
      tables(dialect_.tables()),
      language(tables.language),
      options(options_),
      ear(sink_),
      sink(ear),
      lines(dialect_, name, ear),
      kept(lines),
      units(dialect_, text, name, options.kept_text, options.files),
      variables(dialect_, lines),
      evaluator(language.rules, variables.globals(), variables.level(), variables),
      codes(variables, lines) {
    kept.keep_earlier(options.kept_lines);
    auto main = std::make_unique<Frame>();
    main->unit = &units.main();
    main->text.name = std::move(name);
    main->level = &variables.main_level();
    frames.push_back(std::move(main));
    resume_frame(*frames[0]);
    variables.ask_modal_call([this] { return modal_call_code(); });
    variables.ask_programs([this](std::int64_t level) { return name_at(level); },
                           [this](std::string_view asked) { return find_program(asked); });
    variables.ask_missing([this](const std::string& missing, const std::string& meaning) {
        missing_inputs.push_back({missing, meaning, evaluator.place()});
    });
    for (const InputEvent& event : options.events) {
        const bool is_at_block = event.line != 0 || event.number >= 0;
        pending_events.push_back({&event, is_at_block ? std::nullopt : std::optional(0.0)});
        waits_for_block |= is_at_block;
    }
    lines.add_notes([this](DiagnosticBuilder& message) {
        for (LinePlace& call : nc::places_of(frame->site.get()))
            message.note(std::move(call), "called here");
    });
}

// ------------------------------------------------------------------------------ the batch

std::size_t Program::State::pull(std::span<Block> out) {
    if (!has_begun) begin_main();
    kept.clear();
    given = 0;
    has_visible_fault = lines.failed();
    variables.begin_batch();
    while (given < out.size() && !has_ended && take_step()) {
        Block& block = out[given];
        block.reset();
        const bool had_fault = lines.failed();
        const bool is_program = frame->inputs == nullptr && !frame->is_definition;
        if (options.call && is_program && !frames[0]->is_called) [[unlikely]] {
            if (given > 0 || begin_with_arguments() == Outcome::Wait) return given;
            if (has_ended) {
                is_only_checking = has_visible_fault = true;
                return given;
            }
        }
        if (waits_for_block && is_program && comes_to_event()) {
            if (given > 0) return given;
            begin_event_block();
        }
        const Outcome done = frame->is_definition       ? step_in_definition(block)
                             : frame->inputs != nullptr ? step_in_input(block)
                                                        : step(block);
        if (done == Outcome::Block) ++given;
        // The interpreter goes to a place before the program does there what it does.
        if (frame->at_places && given > 0) return given;
        variables.set_in_step(given == 0);
        if (done == Outcome::Wait) return given;
        if (lines.failed() && !had_fault) {
            is_only_checking = true;
            if (given > 0) return given;
            has_visible_fault = true;
        }
        if (done == Outcome::Block && runs_flat()) take_flat(out);
        if (is_only_checking && done == Outcome::Block && !has_visible_fault) return given;
    }
    return given;
}

/// The text is looked at when somebody wants it, and not before.
void Program::State::begin_main() {
    has_begun = true;
    units.settle_main();
    frames[0]->unit = &units.main();
    frames[0]->here = units.main().begin;
    begin_inputs();
    begin_definitions();
}

/// Whether nothing but the next line of the text decides what comes.
bool Program::State::runs_flat() {
    if (frame->here.offset != frontier().offset || source().offset() != frame->here.offset)
        return false;
    const bool is_called = due || modal_shape || frame->call.to || frame->is_returning ||
                           !modal_calls.empty() || !frame->macros.is_empty();
    const bool is_at_end = is_only_checking || has_ended || lines.has_ended();
    const bool is_told = frame->inputs != nullptr || waits_for_block;
    return !is_called && !is_at_end && !is_waiting && !is_told && watch == nullptr &&
           frame->repeats.empty();
}

/// Lines that nobody has executed yet, one behind the other, while they are plain words: in a flat
/// program all. What the usual way asks at each line was asked once, by `runs_flat`.
void Program::State::take_flat(std::span<Block> out) {
    nc::LineSource& from = source();
    nc::LineSource::Ahead ahead;
    while (given < out.size() && take_step() && from.look(ahead)) {
        Block& block = out[given];
        block.reset();
        const std::uint64_t number = frame->here.line;
        lines.begin(number);
        if (!lines.read_plain(ahead.line, block)) return;
        from.pass(ahead);
        ++given;
        variables.set_in_step(false);
        most_line = std::max(most_line, number);
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
bool Program::State::take_step() {
    constexpr std::uint32_t kStepsBetween = 1u << 14;
    if (++steps % kStepsBetween != 0 || !options.is_over || !options.is_over()) return true;
    was_stopped = has_ended = true;
    return false;
}

/// Shows the line to who looks on. False: the program ends in front of it.
bool Program::State::show(std::string_view text) {
    if (is_only_checking) return true;
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
    was_stopped = has_ended = true;
    return false;
}

Program::State::Outcome Program::State::step(Block& out) {
    if (!written_data.empty() && given == 0) tell_data();
    if (due) return begin_due();
    if (frame->at_places && !is_only_checking) return go_on_at_places(out);
    if (frame->call.to && frame->here == *frame->call.to) frame->is_returning = true;
    if (frame->is_returning) return finish_return(out);
    if (skipped_end && frame->here.offset >= *skipped_end) {
        has_ended = true;
        return Outcome::Nothing;
    }
    if (lines.has_ended()) return end_of_text();
    if (frame->here.offset >= frontier().offset) return first_time(out);
    CompiledLine* const line =
        frame->next_line != nullptr ? frame->next_line : line_at(frame->here);
    if (line == nullptr) {  // said; there is no way on
        has_ended = true;
        return Outcome::Nothing;
    }
    if (watch != nullptr && !show(line->as_written.empty() ? line->text : line->as_written))
        return Outcome::Nothing;
    lines.begin(frame->here.line);
    frame->goes_on = line->place.next;
    const Outcome done = run(*line, out);
    if (done == Outcome::Wait) return done;
    frame->resume = 0;
    const bool is_straight = frame->goes_on == line->place.next;
    frame->here = frame->goes_on;
    if (is_straight && line != &scratch && frame->here.offset < frontier().offset) {
        if (line->next == nullptr) line->next = line_at(frame->here);
        frame->next_line = line->next == &scratch ? nullptr : line->next;
    } else {
        frame->next_line = nullptr;
    }
    if (!frame->repeats.empty()) advance();
    if (done == Outcome::Block) {
        deliver(out, line->text, line->place.line.line, true);
        if (out.function_count != 0) follow_shape(out, line->text, Place(line->place));
        if (modal_shape) follow_modal_shape(out);
    }
    if (begins) perform_call();
    return done;
}

/// The line that nobody has executed yet: most are plain words, and go straight out.
Program::State::Outcome Program::State::first_time(Block& out) {
    if (is_waiting) {
        frame->goes_on = scratch.place.next;
        lines.begin(frame->here.line);
        return finish_first(run(scratch, out), scratch.text, scratch.place.next, out);
    }
    if (source().offset() != frame->here.offset && !source().seek(frame->here.offset)) {
        lines.begin(frame->here.line);
        scratch.text.clear();
        scratch.place = {frame->here, frame->here};
        has_ended = true;
        if (lines.failed()) return Outcome::Nothing;  // said at the jump
        return fail(scratch, diag::TextGone, {}, {"line " + std::to_string(frame->here.line)});
    }
    if (frame->here.offset != frontier().offset) note_skipped();
    std::string_view text;
    bool is_too_long = false;
    if (!source().next(text, is_too_long)) return end_of_text();
    if (watch != nullptr && !show(text)) return Outcome::Nothing;
    text = with_macros(text);
    const LinePosition next{source().offset(), frame->here.line + 1};
    frame->goes_on = next;
    most_line = std::max(most_line, frame->here.line);
    if (is_too_long) {
        lines.report_too_long(text, frame->here.line);
        frame->here = frontier() = next;
        return Outcome::Nothing;
    }
    lines.begin(frame->here.line);
    text = lines.without_head(text);
    const bool is_plain = modal_calls.empty() || !takes_blocks();
    if (is_plain && lines.read_plain(text, out))
        return finish_first(Outcome::Block, text, next, out);
    scratch.text = text;
    scratch.place = {frame->here, next};
    compile(scratch, out);
    const bool is_readable = scratch.kind != CompiledLine::Kind::New;
    const Outcome done = is_readable ? run(scratch, out) : Outcome::Nothing;
    return finish_first(done, scratch.text, next, out);
}

/// next  where the line behind it begins. By value: a place that was stored in parts a moment ago
///       would be waited for by a copy of the whole.
Program::State::Outcome Program::State::finish_first(Outcome done, std::string_view text,
                                                     LinePosition next, Block& out) {
    is_waiting = done == Outcome::Wait;
    if (is_waiting) return done;
    frame->resume = 0;
    const std::uint64_t offset = frame->here.offset;
    const std::uint64_t number = frame->here.line;
    frontier() = next;
    frame->here = next;
    if (frame->goes_on != next) frame->here = frame->goes_on;
    if (!frame->repeats.empty()) advance();
    if (done == Outcome::Block) {
        deliver(out, lines.shown(text, number), number, false);
        if (out.function_count != 0) follow_shape(out, text, {{offset, number}, next});
        if (modal_shape) follow_modal_shape(out);
    }
    if (begins) perform_call();
    return done;
}

/// Behind the last line of the program that runs.
Program::State::Outcome Program::State::end_of_text() {
    if (frames.size() > 1 && !is_only_checking) {
        if (language.rules.text_end_returns) {
            frame->is_returning = true;
            return Outcome::Nothing;
        }
        lines.begin(std::max<std::uint64_t>(frame->here.line, 2) - 1);
        scratch.text.clear();
        scratch.place = {frame->here, frame->here};
        has_ended = true;
        return fail(scratch, diag::ReturnMissing, {});
    }
    // Programs that stand behind are read for their mistakes.
    const bool is_at_head = lines.has_ended() && !language.calls.headers.empty();
    if (!is_only_checking || !is_at_head || !source().seek(frame->here.offset)) {
        has_ended = true;
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
    if (!is_more) has_ended = true;
    return Outcome::Nothing;
}

void Program::State::note_skipped() {
    const bool is_main = frame->unit == &units.main() && !is_only_checking;
    if (is_main) skipped.add(frontier(), frame->here.offset);
}

bool Program::State::check_skipped() {
    const std::optional<SkippedText::Part> part = skipped.take_first();
    if (!part || was_stopped) return false;
    if (!variables_at_end) variables_at_end = variables.list();
    frames.resize(1);
    if (!frames[0]->is_called) frames[0]->level = &variables.main_level();
    frames[0]->text.has_ended = false;
    resume_frame(*frames[0]);
    frame->here = part->begin;
    frame->next_line = nullptr;
    skipped_end = part->end;
    has_ended = false;
    return true;
}

/// Gives the block the number of the call that its program runs in.
void Program::State::name_call(Block& block) {
    if (recent_calls.find(frame->site_number) != frame->site.get())
        frame->site_number = recent_calls.add(frame->site);
    block.source = frame->site_number;
}

void Program::State::deliver(Block& block, std::string_view text_of_line, std::uint64_t number,
                             bool again) {
    ProgramText& in = text();
    block.line = units.line_id(in, number);
    kept.add(block.line, number, text_of_line, &in.name, frame->site);
    if (frame->site) name_call(block);
    frame->has_executed = true;
    turns = 0;
    if (block.kind == Block::Kind::Nc && !is_left_out(block)) ++blocks;
    if (block.number >= 0) variables.set_block_number(block.number);
    if (again && ++repeated > options.max_repeated) {
        lines.report_event(
            text_of_line,
            LineFault{&diag::RepeatedBlocks, {0, 1}, {std::to_string(options.max_repeated)}});
        has_ended = true;
    }
    if (variables.notes_changes() && block.function_count != 0) note_data(block);
    if (!modal_calls.empty()) call_behind(block, text_of_line, number);
    if (block.function_count != 0) end_after(block);
}

/// What stands behind the end of a program is read for its mistakes only; in a subprogram of some
/// controls it is a return.
void Program::State::end_after(Block& block) {
    const nc::Invocation* const found = block.find(nc::Fact::EndsProgram);
    if (found == nullptr) return;
    if (is_left_out(block)) return;
    const bool is_cancelled = !frame->repeats.empty() && !is_only_checking;
    if ((frames.size() > 1 || is_cancelled) && language.rules.program_end_returns &&
        !is_only_checking) {
        const auto place = found - block.functions.data();
        const auto begin = block.functions.begin();
        std::move(begin + place + 1, begin + block.function_count, begin + place);
        --block.function_count;
        // Nothing is left of a block that said only this.
        const bool is_empty =
            block.function_count == 0 && block.given == 0 && block.motion == Function::None;
        if (is_empty) block.kind = Block::Kind::Comment;
        if (!cancel_repeat()) frame->is_returning = true;
        return;
    }
    is_only_checking = true;
    lines.finish_points();
    due.reset();
    if (frames.size() == 1) return;
    // The main program knows what is defined, whatever is wrong beside it.
    if (frame->is_definition) variables.share_definitions(variables.main_level());
    // Behind the main program's part that was executed there may be more of it.
    frames.resize(1);
    resume_frame(*frames[0]);
    frame->here = frontier();
    frame->next_line = nullptr;
}

bool Program::State::is_left_out(const Block& block) const {
    return block.skip >= 0 && ((1u << block.skip | block.skip_also) & options.skip_levels) != 0;
}

/// A line that was executed before, kept compiled; nullptr: it cannot be read again.
CompiledLine* Program::State::line_at(const LinePosition& position) {
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
    line->text = with_macros(text);
    if (watch != nullptr && line->text != text) line->as_written = text;
    line->place = {position, {source().offset(), position.line + 1}};
    if (frame->unit == &units.main()) skipped.take_out(position, line->place.next);
    line->kind = CompiledLine::Kind::New;
    line->next = nullptr;
    if (is_there) return line;
    lines.begin(position.line);
    fail(*line, diag::TextGone, {}, {"line " + std::to_string(position.line)});
    return nullptr;
}

/// Behind the end of a section that is repeated: once more, or on behind it.
void Program::State::advance() {
    while (!frame->repeats.empty() && frame->here == frame->repeats.back().end) {
        OpenRepeat& repeat = frame->repeats.back();
        frame->next_line = nullptr;
        if (--repeat.left > 0) {
            frame->here = repeat.begin;
            ++turns;
            return;
        }
        frame->here = repeat.behind;
        frame->repeats.pop_back();
    }
}

// ------------------------------------------------------------------------------ a line

Program::State::Outcome Program::State::run(CompiledLine& line, Block& out) {
    using Kind = CompiledLine::Kind;
    if (line.kind != Kind::New && !(line.context == context())) line.kind = Kind::New;
    if (line.kind == Kind::New || line.kind == Kind::Plain) {
        const bool is_plain = modal_calls.empty() || !takes_blocks();
        if (is_plain && lines.read_plain(line.text, out)) {
            line.kind = Kind::Plain;
            line.context = context();
            return Outcome::Block;
        }
        compile(line, out);
    }
    if (line.kind == Kind::End) frame->text.has_ended = true;
    if (line.kind == Kind::Nothing || line.kind == Kind::New || line.kind == Kind::End)
        return Outcome::Nothing;
    if (line.kind == Kind::Known)
        return lines.read_known(line.text, out) ? Outcome::Block : Outcome::Nothing;
    // The time of an event is known behind what was executed.
    if (!pending_events.empty() && frame->resume == 0 && frame->inputs == nullptr) [[unlikely]] {
        if (given > 0) return Outcome::Wait;
        act_events();
        if (has_ended) return Outcome::Nothing;
    }
    const nc::LexedLine& words = line.line.words;
    if (words.skip >= 0 && (options.skip_levels >> words.skip & 1u) != 0) return Outcome::Nothing;
    if (!words.passed.empty()) {
        lines.note_content();
        lines.say_passed(words, line.text);
    }
    const std::vector<ControlStatement>& statements = line.line.statements;
    // A subprogram is called behind the words of its block.
    const bool is_call = !line.line.calls.empty();
    const bool is_in_shape = !frame->repeats.empty() && frame->repeats.back().is_shape;
    if (is_call && is_in_shape && !is_only_checking) {
        const nc::Span span = line.line.calls[0].span;
        return fail(line, diag::ShapeBlockWrong, span,
                    {line.text.substr(span.begin, span.end - span.begin)});
    }
    const bool has_words = !words.words.empty() || words.comment_form != nc::kNoForm;
    if (is_call && has_words && !frame->has_given_words) {
        const bool is_return = !statements.empty() && statements[0].kind == Statement::Return;
        if (!language.rules.calls_beside_words_in_cycle && !is_return && is_in_cycle_mode())
            return fail(line, diag::CallInCycleBlock, line.line.calls[0].span);
        const Outcome done = read_words(line, out);
        if (done != Outcome::Block || is_only_checking) return done;
        frame->has_given_words = true;
        frame->goes_on = line.place.line;
        return done;
    }
    // Names are declared for the sake of the lines that are only checked.
    const bool is_declaration =
        !statements.empty() &&
        (statements[0].kind == Statement::Declare || statements[0].kind == Statement::DefineMacro ||
         statements[0].kind == Statement::Procedure);
    if (!statements.empty()) lines.note_content();
    if (!statements.empty() && (!is_only_checking || is_declaration)) {
        const bool is_head = is_declaration || statements[0].kind == Statement::External;
        if (!is_head) frame->has_executed = true;
        while (frame->resume < statements.size()) {
            evaluator.forget();
            if (is_at_limit())
                return fail(line, diag::TooManyLines, statements[frame->resume].span,
                            {std::to_string(executed + blocks), std::to_string(executed)});
            ++executed;
            const Outcome done = execute(line, statements[frame->resume], out);
            if (done != Outcome::Nothing || has_ended) return done;
            if (lines.failed() || frame->goes_on != line.place.next) return Outcome::Nothing;
            ++frame->resume;
        }
    }
    if (is_only_checking) check_jumps(line, statements);
    if (is_call) {
        if (is_only_checking) check_call(line, statements[0]);
        frame->has_given_words = false;
        return Outcome::Nothing;
    }
    // A number, a label or a comment alone is no block: nothing is executed, and nothing counts it.
    if (!has_words) {
        if (words.number >= 0 && statements.empty()) variables.set_block_number(words.number);
        return Outcome::Nothing;
    }
    return read_words(line, out);
}

/// What kind of line it is; one that cannot be read stays New.
void Program::State::compile(CompiledLine& line, Block& out) {
    line.kind = CompiledLine::Kind::Nothing;
    line.context = context();
    if (lines.check_kind(line.text) != nc::LineReader::LineKind::Words) {
        if (lines.has_ended()) line.kind = CompiledLine::Kind::End;
        return;
    }
    // Of anybody else's line only what it says counts: `#100=#5061` is an assignment.
    line.kind = CompiledLine::Kind::Known;
    if (source().is_phrase(line.place.line.line) && lines.knows(line.text, out)) return;
    compile_language(line);
}

void Program::State::compile_language(CompiledLine& line) {
    line.kind = CompiledLine::Kind::New;
    const nc::SymbolTable& symbols = variables.level().symbols;
    nc::LineContext plain = line.context;
    plain.is_argument = false;
    auto fault = compile_line(tables, symbols, line.text, line.line, plain);
    // Under a modal call of blocks those that are no statements are its arguments.
    const bool is_argument =
        line.context.is_argument &&
        (fault ? line.line.statements.empty() && line.line.calls.empty()
               : line.line.statements.empty() && !line.line.words.words.empty());
    if (is_argument) fault = compile_line(tables, symbols, line.text, line.line, line.context);
    if (!fault) line.kind = CompiledLine::Kind::Compiled;
    if (!fault) return;
    note_lost_names(line);
    // A name that a line with a mistake should have declared is no second mistake.
    if (is_lost(line, *fault)) lines.note_fault();
    else lines.report_fault(line.text, *fault);
}

/// The names of a line that declares variables and could not be read.
void Program::State::note_lost_names(const CompiledLine& line) {
    const nc::ControlWords words(tables, line.text);
    bool is_declaration = false;
    for (std::size_t at = 0; !words.is_end(at);) {
        const nc::Word word = words.word_at(at);
        const auto declares = [&](const nc::StatementForm& form) {
            return form.statement == Statement::Declare && words.says(word, form.tokens[0].text);
        };
        if (is_declaration && !word.text.empty()) lost_names.insert(words.normal(word.text));
        is_declaration |= std::ranges::any_of(language.statements, declares);
        at += std::max<std::size_t>(1, word.text.size());
    }
}

bool Program::State::is_lost(const CompiledLine& line, const LineFault& fault) const {
    const bool is_of_name = fault.row == &diag::NameUnknown || fault.row == &diag::IsoUnknownWord;
    if (!is_of_name || lost_names.empty()) return false;
    const nc::ControlWords words(tables, line.text);
    return lost_names.contains(words.normal(words.word_at(fault.span.begin).text));
}

Program::State::Outcome Program::State::read_words(CompiledLine& line, Block& out) {
    const nc::ControlLine& code = line.line;
    const bool is_computed = !code.computed.empty() || !code.axes.empty() || !code.codes.empty();
    if (is_only_checking && is_computed) return Outcome::Nothing;
    values.clear();
    evaluator.forget();
    const nc::ComputedValue* axis_argument = nullptr;
    if (!code.axes.empty()) {
        const Outcome done = set_axes(line);
        if (!goes_on(done)) return done;
    }
    if (!code.codes.empty()) {
        const Outcome done = set_codes(line);
        if (!goes_on(done)) return done;
    }
    for (std::size_t i = 0; i < code.computed.size(); ++i) {
        const bool is_fine_round = language.rules.round_in_word && code.computed[i].argument < 0;
        Value value;
        const Outcome done = evaluate(line, code.computed[i].value, value,
                                      is_fine_round ? lines.value_decimals(code, i) : -1);
        if (!goes_on(done)) return done;
        // An axis among the arguments of a call is said by its number, X by -1.
        const bool is_axis_argument = value.axis() && code.computed[i].argument >= 0;
        if (is_axis_argument && axis_argument == nullptr) axis_argument = &code.computed[i];
        if (!value.is_number() && !value.is_text() && !is_axis_argument) {
            return fail(line, diag::TypesDiffer, code.computed[i].value.span,
                        {"a word", std::string(kind_name(value))});
        }
        nc::WordValue& word = values.emplace_back();
        word.kind = value.is_vacant() ? nc::WordValue::Kind::Vacant
                    : value.is_text() ? nc::WordValue::Kind::Text
                                      : nc::WordValue::Kind::Number;
        word.number = value.number;
        word.text = evaluator.text(value);
    }
    const bool is_kept = &line != &scratch && code.axes.empty() && code.codes.empty();
    nc::MatchedLine* const known = is_kept ? &line.matched : nullptr;
    if (!lines.read_words(line.text, line.line, values, out, known)) return Outcome::Failed;
    if (axis_argument != nullptr && takes_no_axis(out))
        return fail(line, diag::TypesDiffer, axis_argument->value.span,
                    {"an argument of this call", "an axis"});
    const bool has_lone = std::ranges::any_of(code.axes, &nc::ComputedAxis::is_alone);
    return has_lone ? let_axis_move_alone(line, out) : Outcome::Block;
}

/// An axis that moves by itself goes straight to its place and arrives before the next block. Of
/// several each goes as fast as it can, so they do not stay on a line; where they come to is the
/// same.
Program::State::Outcome Program::State::let_axis_move_alone(CompiledLine& line, Block& out) {
    const nc::SlotMask targets = out.given & nc::kTargetSlots;
    const auto count = static_cast<std::size_t>(std::popcount(targets));
    const auto alone = std::ranges::count_if(line.line.axes, &nc::ComputedAxis::is_alone);
    if (count != static_cast<std::size_t>(alone) || out.motion != Function::None) {
        return fail(line, diag::IsoNotSupported, line.line.axes[0].axis.span,
                    {"an axis that moves by itself beside others"});
    }
    if (count > 1 && !said_separate) {
        said_separate = true;
        sink.report(diag::AxesSeparate,
                    lines.place(line.text, line.place.line.line, line.line.axes[0].axis.span));
    }
    if (out.find(Function::RapidOnce) == nullptr) out.add(Function::RapidOnce, 0);
    moves_alone = true;
    return Outcome::Block;
}

/// The axis that a value is, or that it counts where no value is an axis; nothing: there is none.
static std::optional<Axis> axis_of(const ControlVariables& variables, const Value& value) {
    if (value.axis() || !value.is_number()) return value.axis();
    const auto has_number = [&](std::string_view name) {
        const auto axis =
            static_cast<Axis>(std::ranges::find(kAxisNames, name) - kAxisNames.begin());
        const auto number = variables.axis_number(axis);
        return number && static_cast<double>(*number) == value.number;
    };
    const auto found = std::ranges::find_if(kAxisNames, has_number);
    if (found == kAxisNames.end()) return std::nullopt;
    return static_cast<Axis>(found - kAxisNames.begin());
}

/// Words whose axis or spindle is a value get the address of that: `AX[AXA]=10` that of X,
/// `ACC[AXA]=50` that of `ACC[X]`, `S[R1]=500` that of `S2`, or S where it is the first spindle.
Program::State::Outcome Program::State::set_axes(CompiledLine& line) {
    for (const nc::ComputedAxis& computed : line.line.axes) {
        Value value;
        const Outcome done = evaluate(line, computed.axis, value);
        if (!goes_on(done)) return done;
        nc::GivenWord& word = line.line.words.words[computed.word];
        const std::size_t begin = line.line.words.spans[computed.word].begin;
        const nc::ControlWords words(tables, line.text);
        const std::string said = words.normal(words.word_at(begin).text);
        const bool is_axis_word = computed.is_alone || said == language.axis_word;
        word.names_first = false;
        const std::optional<Axis> axis = is_axis_word ? axis_of(variables, value) : value.axis();
        if (!axis && is_axis_word)
            return fail(line, diag::AxisNameUnknown, computed.axis.span,
                        {evaluator.written(value)});
        if (!axis) {
            const auto number = value.spindle().value_or(std::llround(value.number));
            word.names_first = number == 1;
            word.address = tables.find_address(number == 1 ? said : said + std::to_string(number));
            if (word.address == nc::kNoAddress)
                word.address = tables.find_address(said + '[' + std::to_string(number) + ']');
            if (word.address != nc::kNoAddress) continue;
            return fail(line, diag::SpindleMissing, computed.axis.span, {std::to_string(number)});
        }
        const std::string axis_name(kAxisNames[index(*axis)]);
        const std::string name = is_axis_word ? axis_name : said + '[' + axis_name + ']';
        word.address = tables.find_address(name);
        if (word.address == nc::kNoAddress)
            return fail(line, diag::IsoUnknownWord, computed.axis.span, {name});
    }
    return Outcome::Nothing;
}

/// Words that name a code by its group and its place there become that code.
Program::State::Outcome Program::State::set_codes(CompiledLine& line) {
    for (const nc::ComputedCode& computed : line.line.codes) {
        Value group;
        Value number;
        Outcome done = evaluate(line, computed.group, group);
        if (!goes_on(done)) return done;
        done = evaluate(line, computed.number, number);
        if (!goes_on(done)) return done;
        if (!group.is_number())
            return fail(line, diag::IndexType, computed.group.span,
                        {std::string(kind_name(group))});
        const std::string of = evaluator.written(group);
        const auto list =
            std::ranges::find_if(language.code_lists, [&](const auto& l) { return l.group == of; });
        const double place = number.is_number() ? number.number : 0;
        const bool is_there = list != language.code_lists.end() && place == std::floor(place) &&
                              place >= 1 && place <= static_cast<double>(list->codes.size());
        if (!is_there) {
            return fail(line, diag::GroupNumber, computed.number.span,
                        {of, evaluator.written(number)});
        }
        const std::string& code = list->codes[static_cast<std::size_t>(place) - 1];
        if (!set_code(line.line.words, computed.word, code)) {
            const std::string known = tables.unsupported_words(code);
            return fail(line, known.empty() ? diag::IsoUnknownWord : diag::IsoNotSupported,
                        computed.number.span, {known.empty() ? code : known});
        }
    }
    return Outcome::Nothing;
}

/// `G54` as its letter and number, `BRISK` as a word; false: the dialect has no such code.
bool Program::State::set_code(nc::LexedLine& words, std::size_t place,
                              const std::string& code) const {
    nc::GivenWord& word = words.words[place];
    words.decimals[place] = {};
    word.address = tables.find_address(code);
    word.has_value = word.is_known = false;
    if (word.address != nc::kNoAddress) return true;
    const Decimal number = parse_decimal(code.data() + 1, code.data() + code.size());
    word.address = tables.find_address(std::string_view(code).substr(0, 1));
    if (word.address == nc::kNoAddress || number.end != code.data() + code.size()) return false;
    word.has_value = word.is_known = true;
    word.number = number.value;
    words.decimals[place] = number;
    return tables.find_code(word.address, number.value) != nullptr;
}

// ------------------------------------------------------------------------------ faults

Program::State::Outcome Program::State::fail(CompiledLine& line, const LineFault& fault) {
    lines.report_event(line.text, fault);
    return Outcome::Failed;
}

Program::State::Outcome Program::State::fail(CompiledLine& line, ProgramMap::Fault fault,
                                             const DiagnosticRow& missing, const Span& span,
                                             const std::string& what) {
    switch (fault) {
        case ProgramMap::Fault::None: return Outcome::Nothing;
        case ProgramMap::Fault::Missing: return fail(line, missing, span, {what});
        case ProgramMap::Fault::LoopNumber: return fail(line, diag::LoopNumber, span, {what});
        case ProgramMap::Fault::TextGone: break;
    }
    return fail(line, diag::TextGone, span, {"this line"});
}

Program::State::Outcome Program::State::evaluate(CompiledLine& line,
                                                 const nc::Expression& expression, Value& out,
                                                 int decimals) {
    const Evaluator::Outcome outcome = evaluator.run(line.line, expression, out, decimals);
    if (!missing_inputs.empty()) tell_missing(line);
    switch (outcome) {
        case Evaluator::Outcome::Done:
            if (evaluator.has_radians()) [[unlikely]]
                warn_of_radians(line);
            return Outcome::Nothing;
        case Evaluator::Outcome::Later: return Outcome::Wait;
        case Evaluator::Outcome::Fault: return fail(line, evaluator.fault());
    }
    return Outcome::Nothing;
}

/// Said once a run: what thinks in radians does so everywhere.
void Program::State::warn_of_radians(const CompiledLine& line) {
    const auto found = evaluator.take_radians();
    if (!found || said_radians) return;
    said_radians = true;
    sink.report(diag::RadiansInText, lines.place(line.text, line.place.line.line, found->place))
        .arg(variables.word_of(found->operation))
        .arg(round_to(found->angle, 6));
}

Program::State::Outcome Program::State::truth(CompiledLine& line, const nc::Expression& expression,
                                              bool& out) {
    Value value;
    const Outcome done = evaluate(line, expression, value);
    if (!goes_on(done)) return done;
    if (!value.is_number()) {
        return fail(line, diag::TypesDiffer, expression.span,
                    {"a condition", std::string(kind_name(value))});
    }
    out = value.number != 0;
    return Outcome::Nothing;
}

// ------------------------------------------------------------------------------ the program

Program::Program(const nc::Dialect& dialect, nc::TextSource& text, std::string name,
                 const ProgramOptions& options, DiagnosticSink& sink)
    : state_(std::make_unique<State>(dialect, text, std::move(name), options, sink)) {}
Program::~Program() = default;

void Program::check_only() { state_->is_only_checking = true; }
bool Program::check_skipped() { return state_->check_skipped(); }
void Program::follow(ControlAccess& state) {
    state_->interpreter = &state;
    state_->variables.follow(state);
}
void Program::print_to(Printer& printer) { state_->options.printer = &printer; }
void Program::show_to(LineWatch* watch, std::vector<VariableChange>* changes) {
    state_->watch = watch;
    state_->variables.note_changes(changes);
}
std::size_t Program::pull(std::span<Block> out) { return state_->pull(out); }
LinePlace Program::place(const Block& block) const { return state_->kept.place(block); }
LinePlace Program::place(const Block& block, nc::Slot slot) const {
    return state_->kept.place(block, slot);
}
LinePlace Program::place(const Block& block, Function function) const {
    return state_->kept.place(block, function);
}
std::vector<LinePlace> Program::calls(const Block& block) const {
    return state_->kept.calls(block);
}
LinePlace Program::place(std::uint32_t line) const {
    const ProgramUnits::Line found = state_->units.line_of(line);
    LinePlace place;
    place.file = found.text->name;
    place.line = static_cast<std::uint32_t>(found.number);
    return place;
}
void Program::keep_lines(std::size_t lines) { state_->kept.keep_earlier(lines); }
LinePlace Program::shown_place(std::uint32_t line, std::optional<nc::Slot> slot) const {
    Block block{};
    block.line = line;
    LinePlace found = slot ? state_->kept.place(block, *slot) : state_->kept.place(block);
    return found.text.empty() ? place(line) : found;
}
std::vector<LinePlace> Program::calls(SourceId source) const {
    return nc::places_of(state_->recent_calls.find(source));
}
bool Program::failed() const { return state_->has_visible_fault; }
bool Program::stopped() const { return state_->was_stopped; }
bool Program::calls_at_places(const Block& block) const {
    const std::optional<CallsAtPlaces>& calls = state_->frame->at_places;
    return calls && calls->line == block.line;
}
bool Program::is_behind_fault(const Block& block) const {
    static_cast<void>(block);
    return state_->has_visible_fault;
}
std::uint64_t Program::lines() const { return state_->most_line; }
bool Program::has_fault() const { return state_->lines.failed(); }
std::vector<Program::EventAhead> Program::events_ahead() const {
    std::vector<EventAhead> ahead;
    for (const State::PendingEvent& each : state_->pending_events)
        ahead.push_back({each.event, each.begun.has_value()});
    return ahead;
}

std::vector<ControlVariable> Program::variables() const {
    return state_->variables_at_end ? *state_->variables_at_end : state_->variables.list();
}
const std::vector<ActiveCode>& Program::codes() { return state_->codes.now(); }
std::uint64_t Program::line() const { return state_->frame->here.line; }
std::uint64_t Program::statements() const { return state_->executed; }

}  // namespace kadr::macro
