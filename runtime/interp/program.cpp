#include "interp/program.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "base/units.h"
#include "interp/code_list.h"
#include "interp/control_variables.h"
#include "interp/evaluator.h"
#include "interp/program_map.h"
#include "nc/control_words.h"
#include "nc/kept_lines.h"
#include "nc/line_reader.h"

namespace kadr::interp {

using nc::Block;
using nc::ControlStatement;
using nc::Function;
using nc::JumpTarget;
using nc::LineFault;
using nc::Span;
using nc::Statement;

namespace {

/// Lines that are kept compiled; a longer loop is read again each time.
constexpr std::size_t kMostCompiled = 20'000;
constexpr double kMostPasses = 9999;  // of a section that is repeated; S 8.7

}  // namespace

/// A line that runs more than once.
struct CompiledLine {
    std::string text;
    Place place;
    enum class Kind : std::uint8_t {
        New,       // nobody has looked at it
        Plain,     // words and numbers: the reader's way
        Known,     // the dialect knows it by its letters
        Compiled,  // `line` holds
        Nothing,   // nothing stands there
    };
    Kind kind = Kind::New;
    nc::ControlLine line;
    nc::MatchedLine matched;
    CompiledLine* next = nullptr;  // the line behind it, if that one is kept as well
};

/// A structure that was entered and not left yet.
struct OpenStructure {
    Statement kind = Statement::None;
    int loop = 0;
    Place head;
    Place end;
    std::optional<Place> otherwise;
    double last = 0;                          // For
    std::unique_ptr<nc::ControlLine> counts;  // … its head
};

/// A section that is being repeated.
struct OpenRepeat {
    Position begin;
    Position end;     // reached: the section is through
    Position behind;  // where the program goes on in the end
    std::int64_t left = 0;
};

struct Program::State {
    State(const nc::Dialect& dialect_, nc::TextSource& text, std::string name,
          const ProgramOptions& options_, DiagnosticSink& sink_)
        : dialect(dialect_),
          tables(dialect_.tables()),
          language(tables.language),
          options(options_),
          sink(sink_),
          kept_text(text, options.kept_text),
          // A text that can be sought is read again where it is.
          source(text.seek(0) ? text : static_cast<nc::TextSource&>(kept_text),
                 tables.rules.max_line),
          lines(dialect_, std::move(name), sink_),
          kept(lines),
          map(tables, source),
          variables(dialect_, lines),
          evaluator(language.rules, variables.globals(), variables.level(), variables),
          codes(variables, lines) {}

    enum class Done : std::uint8_t {
        Block,    // `out` holds one
        Nothing,  // go on
        Wait,     // the line is run again when the blocks before are executed
    };

    const nc::Dialect& dialect;
    const nc::DialectTables& tables;
    const nc::Language& language;
    ProgramOptions options;
    DiagnosticSink& sink;
    nc::KeptText kept_text;
    nc::LineSource source;
    nc::LineReader lines;
    nc::KeptLines kept;
    ProgramMap map;
    ControlVariables variables;
    Evaluator evaluator;
    CodeList codes;
    LineWatch* watch = nullptr;

    Position here;                      // of the line that is next
    Position frontier;                  // of the first line that was never executed
    Position goes_on;                   // behind the line that is executed
    CompiledLine* next_line = nullptr;  // if the next line is kept
    CompiledLine scratch;
    std::unordered_map<std::uint64_t, std::unique_ptr<CompiledLine>> compiled;
    std::vector<OpenStructure> structures;
    std::vector<OpenRepeat> repeats;
    std::vector<nc::WordValue> values;
    std::size_t resume = 0;      // statements of the line that are executed already
    std::size_t given = 0;       // blocks of this batch
    std::uint64_t turns = 0;     // jumps back since the last block
    std::uint64_t repeated = 0;  // blocks of lines that ran again
    std::uint64_t most_line = 0;
    bool is_waiting = false;        // the line in `scratch` is to be run again
    bool has_executed = false;      // something besides declarations
    bool is_only_checking = false;  // the program has ended; lines behind are read for mistakes
    bool has_ended = false;
    bool has_visible_fault = false;  // that blocks of this batch stand behind
    bool was_stopped = false;        // by who looks on, or because its time is over
    std::uint32_t steps = 0;
    std::uint64_t executed = 0;  // statements

    // lines
    std::size_t pull(std::span<Block> out);
    Done step(Block& out);
    bool may_go_on();
    bool shows(std::string_view text);
    Done first_time(Block& out);
    Done finish_first(Done done, std::string_view text, const Place& place, Block& out);
    Done run(CompiledLine& line, Block& out);
    CompiledLine* line_at(const Position& position);
    void compile(CompiledLine& line, Block& out);
    void deliver(Block& block, std::string_view text, std::uint64_t number, bool again);
    void advance();
    Done read_words(CompiledLine& line, Block& out);

    // statements
    Done execute(CompiledLine& line, const ControlStatement& statement, Block& out);
    Done assign(CompiledLine& line, const ControlStatement& statement, Block& out);
    Done assign_list(CompiledLine& line, const ControlStatement& statement);
    Done declare(CompiledLine& line, const ControlStatement& statement);
    Done jump(CompiledLine& line, const ControlStatement& statement);
    Done choose(CompiledLine& line, const ControlStatement& statement, Block& out);
    Done choose_case(CompiledLine& line, const ControlStatement& statement);
    Done enter(CompiledLine& line, const ControlStatement& statement);
    Done leave(CompiledLine& line, const ControlStatement& statement);
    Done otherwise(CompiledLine& line, const ControlStatement& statement);
    Done repeat_section(CompiledLine& line, const ControlStatement& statement);
    Done raise(CompiledLine& line, const Span& span, double number, const std::string& text);
    Done stop_with_message(std::string_view text, Block& out);

    // parts
    Done evaluate(CompiledLine& line, const nc::Expression& expression, Value& out,
                  int decimals = -1);
    Done truth(CompiledLine& line, const nc::Expression& expression, bool& out);
    Done store(CompiledLine& line, const nc::Reference& reference, const Value& value);
    Done count_on(CompiledLine& line, OpenStructure& loop, bool& goes_on_looping);
    bool resolve(CompiledLine& line, const JumpTarget& target, Target& out, Done& done);
    Done go(CompiledLine& line, const Place& target, const Span& span);
    Done fail(CompiledLine& line, const LineFault& fault);
    Done fail(CompiledLine& line, const DiagnosticRow& row, const Span& span,
              std::vector<std::string> arguments = {}) {
        return fail(line, LineFault{&row, span, std::move(arguments)});
    }
    Done fail(CompiledLine& line, ProgramMap::Fault fault, const DiagnosticRow& missing,
              const Span& span, const std::string& what);
    void end_after(const Block& block);
    bool is_left_out(const Block& block) const;
    void follow_shape(const Block& block, std::string_view text, const Place& place);
};

// ------------------------------------------------------------------------------ the batch

std::size_t Program::State::pull(std::span<Block> out) {
    kept.clear();
    given = 0;
    has_visible_fault = lines.failed();
    variables.begin_batch();
    while (given < out.size() && !has_ended && may_go_on()) {
        Block& block = out[given];
        block.reset();
        const bool had_fault = lines.failed();
        const Done done = step(block);
        if (done == Done::Block) ++given;
        variables.set_in_step(given == 0);
        if (done == Done::Wait) return given;
        if (lines.failed() && !had_fault) {
            is_only_checking = true;
            if (given > 0) return given;
            has_visible_fault = true;
        }
        if (is_only_checking && done == Done::Block && !has_visible_fault) return given;
    }
    return given;
}

/// Loops without a block give nobody else the occasion to look at the clock.
bool Program::State::may_go_on() {
    constexpr std::uint32_t kStepsBetween = 1u << 14;
    if (++steps % kStepsBetween != 0 || !options.is_over || !options.is_over()) return true;
    was_stopped = has_ended = true;
    return false;
}

/// Shows the line to who looks on. False: the program ends in front of it.
bool Program::State::shows(std::string_view text) {
    if (is_only_checking) return true;
    const nc::LineFront front = nc::front_of(tables, text);
    WatchedLine line;
    line.text = text;
    line.line = here.line;
    line.number = front.number;
    line.label = front.label;
    if (watch->comes_to(line)) return true;
    was_stopped = has_ended = true;
    return false;
}

Program::State::Done Program::State::step(Block& out) {
    goes_on = here;
    if (here.offset >= frontier.offset) return first_time(out);
    CompiledLine* const line = next_line != nullptr ? next_line : line_at(here);
    if (line == nullptr) {  // said; there is no way on
        has_ended = true;
        return Done::Nothing;
    }
    if (watch != nullptr && !shows(line->text)) return Done::Nothing;
    lines.begin(here.line);
    goes_on = line->place.next;
    const Done done = run(*line, out);
    if (done == Done::Wait) return done;
    resume = 0;
    const bool is_straight = goes_on == line->place.next;
    here = goes_on;
    if (is_straight && line != &scratch && here.offset < frontier.offset) {
        if (line->next == nullptr) line->next = line_at(here);
        next_line = line->next == &scratch ? nullptr : line->next;
    } else {
        next_line = nullptr;
    }
    if (!repeats.empty()) advance();
    if (done == Done::Block) {
        deliver(out, line->text, line->place.line.line, true);
        follow_shape(out, line->text, Place(line->place));
    }
    return done;
}

/// The line that nobody has executed yet: most are plain words, and go straight out.
Program::State::Done Program::State::first_time(Block& out) {
    if (is_waiting) {
        goes_on = scratch.place.next;
        lines.begin(here.line);
        return finish_first(run(scratch, out), scratch.text, scratch.place, out);
    }
    if (source.offset() != here.offset && !source.seek(here.offset)) {
        lines.begin(here.line);
        scratch.text.clear();
        scratch.place = {here, here};
        has_ended = true;
        if (lines.failed()) return Done::Nothing;  // said at the jump
        return fail(scratch, diag::TextGone, {}, {"line " + std::to_string(here.line)});
    }
    std::string_view text;
    bool is_too_long = false;
    if (lines.has_ended() || !source.next(text, is_too_long)) {
        has_ended = true;
        return Done::Nothing;
    }
    if (watch != nullptr && !shows(text)) return Done::Nothing;
    const Place place{here, {source.offset(), here.line + 1}};
    goes_on = place.next;
    most_line = std::max(most_line, here.line);
    if (is_too_long) {
        lines.report_too_long(text, here.line);
        here = frontier = place.next;
        return Done::Nothing;
    }
    lines.begin(here.line);
    if (lines.read_plain(text, out)) return finish_first(Done::Block, text, place, out);
    scratch.text = text;
    scratch.place = place;
    compile(scratch, out);
    const bool is_readable = scratch.kind != CompiledLine::Kind::New;
    const Done done = is_readable ? run(scratch, out) : Done::Nothing;
    return finish_first(done, scratch.text, place, out);
}

Program::State::Done Program::State::finish_first(Done done, std::string_view text,
                                                  const Place& place, Block& out) {
    is_waiting = done == Done::Wait;
    if (is_waiting) return done;
    resume = 0;
    frontier = place.next;
    here = goes_on;
    if (!repeats.empty()) advance();
    if (done == Done::Block) {
        deliver(out, text, place.line.line, false);
        follow_shape(out, text, Place(place));
    }
    return done;
}

void Program::State::deliver(Block& block, std::string_view text, std::uint64_t number,
                             bool again) {
    block.line = static_cast<std::uint32_t>(number);
    kept.add(block.line, text);
    has_executed = true;
    turns = 0;
    if (block.number >= 0) variables.set_block_number(block.number);
    if (again && ++repeated > options.max_repeated) {
        lines.report_fault(
            text, LineFault{&diag::RepeatedBlocks, {0, 1}, {std::to_string(options.max_repeated)}});
        has_ended = true;
    }
    if (block.function_count != 0) end_after(block);
}

/// What stands behind the end of a program is read for its mistakes only.
void Program::State::end_after(const Block& block) {
    if (block.find(Function::End) == nullptr && block.find(Function::EndRewind) == nullptr) return;
    if (!is_left_out(block)) is_only_checking = true;
}

bool Program::State::is_left_out(const Block& block) const {
    return block.skip >= 0 && ((1u << block.skip | block.skip_also) & options.skip_levels) != 0;
}

/// A cycle that works along a shape is followed by the blocks of the shape, wherever they stand;
/// then the program goes on with the block behind the cycle. Where that is the shape itself, and
/// the cycle works something out of it, it goes on behind the shape.
void Program::State::follow_shape(const Block& block, std::string_view text, const Place& place) {
    if (block.function_count == 0 || is_only_checking || has_ended) return;
    const nc::Invocation* const call = block.find(Function::Cycle);
    if (call == nullptr || is_left_out(block)) return;
    const nc::CycleInfo& cycle = dialect.cycles()[block.cycle];
    const auto number_of = [&](int parameter) -> std::int64_t {
        return std::llround(block.argument(*call, static_cast<std::size_t>(parameter), -1));
    };
    if (!cycle.takes_shape()) return;
    const std::int64_t first = number_of(cycle.roles.first_block);
    const std::int64_t last = number_of(cycle.roles.last_block);
    if (first < 0 || last < 0) return;  // the interpreter says so
    Place begin;
    Place end;
    ProgramMap::Fault fault = map.find({"", first}, Direction::Both, place, begin);
    std::int64_t missing = first;
    if (fault == ProgramMap::Fault::None) {
        end = begin;
        missing = last;
        if (last != first) fault = map.find({"", last}, Direction::Forward, begin, end);
    }
    if (fault != ProgramMap::Fault::None) {
        lines.report_fault(text,
                           LineFault{&diag::ShapeBlockMissing, {0, 1}, {std::to_string(missing)}});
        has_ended = true;
        return;
    }
    const bool is_followed = cycle.parameters.size() == 2;
    const bool is_next =
        begin.line.offset >= here.offset && map.is_empty_between(here, begin.line) && !is_followed;
    repeats.push_back({begin.line, end.next, is_next ? end.next : here, 1});
    here = begin.line;
    next_line = nullptr;
}

/// A line that was executed before, kept compiled; nullptr: it cannot be read again.
CompiledLine* Program::State::line_at(const Position& position) {
    if (position.offset >= frontier.offset) return nullptr;
    if (const auto known = compiled.find(position.offset); known != compiled.end())
        return known->second.get();
    std::string_view text;
    bool is_too_long = false;
    const bool is_there = source.seek(position.offset) && source.next(text, is_too_long);
    CompiledLine* line = &scratch;
    if (compiled.size() < kMostCompiled && is_there) {
        line =
            compiled.emplace(position.offset, std::make_unique<CompiledLine>()).first->second.get();
    }
    line->text = text;
    line->place = {position, {source.offset(), position.line + 1}};
    line->kind = CompiledLine::Kind::New;
    line->next = nullptr;
    if (is_there) return line;
    lines.begin(position.line);
    fail(*line, diag::TextGone, {}, {"line " + std::to_string(position.line)});
    return nullptr;
}

/// Behind the end of a section that is repeated: once more, or on behind it.
void Program::State::advance() {
    while (!repeats.empty() && here == repeats.back().end) {
        OpenRepeat& repeat = repeats.back();
        next_line = nullptr;
        if (--repeat.left > 0) {
            here = repeat.begin;
            ++turns;
            return;
        }
        here = repeat.behind;
        repeats.pop_back();
    }
}

// ------------------------------------------------------------------------------ a line

Program::State::Done Program::State::run(CompiledLine& line, Block& out) {
    using Kind = CompiledLine::Kind;
    if (line.kind == Kind::New || line.kind == Kind::Plain) {
        if (lines.read_plain(line.text, out)) {
            line.kind = Kind::Plain;
            return Done::Block;
        }
        compile(line, out);
    }
    if (line.kind == Kind::Nothing || line.kind == Kind::New) return Done::Nothing;
    if (line.kind == Kind::Known)
        return lines.read_known(line.text, out) ? Done::Block : Done::Nothing;
    const nc::LexedLine& words = line.line.words;
    if (words.skip >= 0 && (options.skip_levels >> words.skip & 1u) != 0) return Done::Nothing;
    const std::vector<ControlStatement>& statements = line.line.statements;
    // Names are declared for the sake of the lines that are only checked.
    const bool is_declaration = !statements.empty() && statements[0].kind == Statement::Declare;
    if (!statements.empty() && (!is_only_checking || is_declaration)) {
        if (statements[0].kind != Statement::Declare) has_executed = true;
        while (resume < statements.size()) {
            evaluator.forget();
            ++executed;
            const Done done = execute(line, statements[resume], out);
            if (done != Done::Nothing || has_ended) return done;
            if (lines.failed() || goes_on != line.place.next) return Done::Nothing;
            ++resume;
        }
    }
    const bool has_nothing_else = words.words.empty() && words.comment_form == nc::kNoForm &&
                                  (!statements.empty() || words.number < 0);
    if (has_nothing_else) return Done::Nothing;
    return read_words(line, out);
}

/// What kind of line it is; one that cannot be read stays New.
void Program::State::compile(CompiledLine& line, Block& out) {
    line.kind = CompiledLine::Kind::Nothing;
    if (!lines.has_words(line.text)) return;
    line.kind = CompiledLine::Kind::Known;
    if (lines.knows(line.text, out)) return;
    line.kind = CompiledLine::Kind::New;
    const auto fault = compile_line(tables, variables.level().symbols, line.text, line.line);
    if (!fault) line.kind = CompiledLine::Kind::Compiled;
    if (fault) lines.report_fault(line.text, *fault);
}

Program::State::Done Program::State::read_words(CompiledLine& line, Block& out) {
    const nc::ControlLine& code = line.line;
    if (is_only_checking && !code.computed.empty()) return Done::Nothing;
    values.clear();
    evaluator.forget();
    for (std::size_t i = 0; i < code.computed.size(); ++i) {
        const bool is_fine_round = language.rules.round_in_word && code.computed[i].argument < 0;
        Value value;
        const Done done = evaluate(line, code.computed[i].value, value,
                                   is_fine_round ? lines.value_decimals(code, i) : -1);
        if (done == Done::Wait || lines.failed()) return done;
        nc::WordValue& word = values.emplace_back();
        word.kind = value.is_vacant() ? nc::WordValue::Kind::Vacant
                    : value.is_text() ? nc::WordValue::Kind::Text
                                      : nc::WordValue::Kind::Number;
        word.number = value.number;
        word.text = evaluator.text(value);
    }
    nc::MatchedLine* const known = &line == &scratch ? nullptr : &line.matched;
    return lines.read_words(line.text, line.line, values, out, known) ? Done::Block : Done::Nothing;
}

// ------------------------------------------------------------------------------ faults

Program::State::Done Program::State::fail(CompiledLine& line, const LineFault& fault) {
    lines.report_fault(line.text, fault);
    return Done::Nothing;
}

Program::State::Done Program::State::fail(CompiledLine& line, ProgramMap::Fault fault,
                                          const DiagnosticRow& missing, const Span& span,
                                          const std::string& what) {
    switch (fault) {
        case ProgramMap::Fault::None: return Done::Nothing;
        case ProgramMap::Fault::Missing: return fail(line, missing, span, {what});
        case ProgramMap::Fault::LoopNumber: return fail(line, diag::LoopNumber, span, {what});
        case ProgramMap::Fault::TextGone: break;
    }
    return fail(line, diag::TextGone, span, {"this line"});
}

Program::State::Done Program::State::evaluate(CompiledLine& line, const nc::Expression& expression,
                                              Value& out, int decimals) {
    switch (evaluator.run(line.line, expression, out, decimals)) {
        case Evaluator::Outcome::Done: return Done::Nothing;
        case Evaluator::Outcome::Later: return Done::Wait;
        case Evaluator::Outcome::Fault: return fail(line, evaluator.fault());
    }
    return Done::Nothing;
}

Program::State::Done Program::State::truth(CompiledLine& line, const nc::Expression& expression,
                                           bool& out) {
    Value value;
    const Done done = evaluate(line, expression, value);
    if (done == Done::Wait || lines.failed()) return done;
    if (value.is_text())
        return fail(line, diag::TypesDiffer, expression.span, {"a condition", "a text"});
    out = value.number != 0;
    return Done::Nothing;
}

// ------------------------------------------------------------------------------ statements

Program::State::Done Program::State::execute(CompiledLine& line, const ControlStatement& statement,
                                             Block& out) {
    switch (statement.kind) {
        case Statement::None:
        case Statement::JumpToStart:
        case Statement::EndIf:
            if (statement.kind == Statement::EndIf) return leave(line, statement);
            return Done::Nothing;
        case Statement::Assign: return assign(line, statement, out);
        case Statement::Jump:
        case Statement::JumpForward:
        case Statement::JumpBackward:
        case Statement::JumpIfThere: return jump(line, statement);
        case Statement::IfDo: return choose(line, statement, out);
        case Statement::Case: return choose_case(line, statement);
        case Statement::If:
        case Statement::While:
        case Statement::Loop:
        case Statement::For:
        case Statement::Repeat: return enter(line, statement);
        case Statement::Else: return otherwise(line, statement);
        case Statement::EndLoop:
        case Statement::Until: return leave(line, statement);
        case Statement::RepeatSection:
        case Statement::RepeatBlock: return repeat_section(line, statement);
        case Statement::Declare: return declare(line, statement);
        case Statement::Alarm: {
            Value number;
            Value text;
            Done done = evaluate(line, statement.value, number);
            if (done == Done::Wait || lines.failed()) return done;
            if (statement.second.is_given()) done = evaluate(line, statement.second, text);
            if (done == Done::Wait || lines.failed()) return done;
            return raise(line, statement.span, number.number, std::string(evaluator.text(text)));
        }
    }
    return Done::Nothing;
}

Program::State::Done Program::State::assign(CompiledLine& line, const ControlStatement& statement,
                                            Block& out) {
    if (!statement.list.empty()) return assign_list(line, statement);
    Value value;
    Done done = evaluate(line, statement.value, value);
    if (done == Done::Wait || lines.failed()) return done;
    // Writing some variables acts: an alarm, a stop.
    const nc::Instruction& load = statement.variable.load;
    nc::Quantity quantity = nc::Quantity::None;
    if (load.kind == nc::Instruction::Kind::System)
        quantity = static_cast<nc::Quantity>(load.index);
    if (load.kind == nc::Instruction::Kind::Family) {
        std::array<std::int64_t, 2> number{};
        if (evaluator.indices(line.line, statement.variable, number) == Evaluator::Outcome::Done)
            quantity = variables.quantity_of(load.index, number[0]);
        // The value of the assignment lives in the texts of the evaluator, not on its stack.
    }
    const std::string& comment = line.line.words.comment;
    if (quantity == nc::Quantity::Alarm) return raise(line, statement.span, value.number, comment);
    if (quantity == nc::Quantity::MessageStop) return stop_with_message(comment, out);
    return store(line, statement.variable, value);
}

Program::State::Done Program::State::store(CompiledLine& line, const nc::Reference& reference,
                                           const Value& value) {
    std::array<std::int64_t, 4> indices{};
    if (reference.indices.is_given()) {
        switch (evaluator.indices(line.line, reference, indices)) {
            case Evaluator::Outcome::Done: break;
            case Evaluator::Outcome::Later: return Done::Wait;
            case Evaluator::Outcome::Fault: return fail(line, evaluator.fault());
        }
    }
    if (variables.must_wait(reference.load, indices)) return Done::Wait;
    const ControlVariables::Fault fault =
        variables.store(reference.load, indices, value, evaluator.text(value));
    if (fault.row == nullptr) return Done::Nothing;
    return fail(line, *fault.row, reference.span, fault.arguments);
}

Program::State::Done Program::State::assign_list(CompiledLine& line,
                                                 const ControlStatement& statement) {
    const nc::Instruction& load = statement.variable.load;
    if (load.kind != nc::Instruction::Kind::Element)
        return fail(line, diag::IndexWrong, statement.variable.span, {"this variable"});
    std::array<std::int64_t, 4> indices{};
    switch (evaluator.indices(line.line, statement.variable, indices)) {
        case Evaluator::Outcome::Done: break;
        case Evaluator::Outcome::Later: return Done::Wait;
        case Evaluator::Outcome::Fault: return fail(line, evaluator.fault());
    }
    const nc::Symbol& symbol = variables.level().symbols.at(load.index);
    const auto first = Evaluator::element(symbol, indices);
    if (!first) return fail(line, diag::IndexWrong, statement.variable.span, {symbol.name});
    const std::uint32_t end = symbol.slot + symbol.count();
    if (!statement.fills && *first + statement.list.size() > end)
        return fail(line, diag::TooManyInitialValues, statement.span, {symbol.name});
    const std::size_t count = statement.fills ? end - *first : statement.list.size();
    for (std::size_t i = 0; i < count; ++i) {
        const nc::Expression& expression = statement.list[statement.fills ? 0 : i];
        if (!expression.is_given()) continue;
        Value value;
        const Done done = evaluate(line, expression, value);
        if (done == Done::Wait || lines.failed()) return done;
        const auto fault = variables.store_element(symbol, *first + static_cast<std::uint32_t>(i),
                                                   value, evaluator.text(value));
        if (fault.row != nullptr) return fail(line, *fault.row, expression.span, fault.arguments);
    }
    return Done::Nothing;
}

Program::State::Done Program::State::declare(CompiledLine& line,
                                             const ControlStatement& statement) {
    if (has_executed) return fail(line, diag::DeclarationMisplaced, statement.span);
    Value size;
    if (statement.type_size.is_given()) {
        const Done done = evaluate(line, statement.type_size, size);
        if (done == Done::Wait || lines.failed()) return done;
        if (size.number < 1 || size.number > language.rules.most_text)
            return fail(line, diag::SizeWrong, statement.type_size.span, {evaluator.written(size)});
    }
    for (const nc::Declaration& declaration : statement.declarations) {
        nc::Symbol symbol;
        symbol.name = declaration.name;
        symbol.type = statement.type;
        symbol.text_size = static_cast<std::uint32_t>(size.number);
        symbol.dimensions = declaration.dimensions;
        double count = 1;
        for (std::size_t i = 0; i < declaration.dimensions; ++i) {
            Value length;
            const Done done = evaluate(line, declaration.sizes[i], length);
            if (done == Done::Wait || lines.failed()) return done;
            count *= length.number;
            if (!(length.number >= 1) || count > 1e6) {
                return fail(line, diag::SizeWrong, declaration.sizes[i].span,
                            {evaluator.written(length)});
            }
            symbol.sizes[i] = static_cast<std::uint32_t>(length.number);
        }
        if (variables.level().symbols.find(symbol.name) != nullptr)
            return fail(line, diag::NameTwice, declaration.span, {symbol.name});
        const nc::Symbol& added = variables.declare(std::move(symbol));
        if (declaration.values.size() > added.count())
            return fail(line, diag::TooManyInitialValues, declaration.span, {added.name});
        const std::size_t filled = declaration.fills ? added.count() : declaration.values.size();
        for (std::size_t i = 0; i < filled; ++i) {
            const nc::Expression& expression = declaration.values[declaration.fills ? 0 : i];
            if (!expression.is_given()) continue;
            Value value;
            const Done done = evaluate(line, expression, value);
            if (done == Done::Wait || lines.failed()) return done;
            const auto fault = variables.store_element(
                added, added.slot + static_cast<std::uint32_t>(i), value, evaluator.text(value));
            if (fault.row != nullptr)
                return fail(line, *fault.row, expression.span, fault.arguments);
        }
    }
    return Done::Nothing;
}

/// The program's own alarm.
Program::State::Done Program::State::raise(CompiledLine& line, const Span& span, double number,
                                           const std::string& text) {
    const nc::LanguageRules& rules = language.rules;
    const double rounded = std::round(number);
    if (!(rounded >= rules.least_alarm && rounded <= rules.most_alarm))
        return fail(line, diag::AlarmNumber, span, {evaluator.written(Value::real(number))});
    if (given > 0) return Done::Wait;
    const std::string shown = std::to_string(std::llround(rounded) + rules.alarm_base);
    const LinePlace place = lines.place(line.text, line.place.line.line, span);
    const auto own = dialect.alarm(diag::ProgramAlarm);
    sink.report(diag::ProgramAlarm, place)
        .arg(text.empty() ? shown : text)
        .alarm((own ? own->number : std::string()) + shown, text);
    lines.note_fault();
    return Done::Nothing;
}

Program::State::Done Program::State::stop_with_message(std::string_view text, Block& out) {
    if (!text.empty()) out.add(Function::Message, 1);
    out.add(Function::Stop);
    out.text = text;
    return Done::Block;
}

// ------------------------------------------------------------------------------ jumps

/// False: `done` says why.
bool Program::State::resolve(CompiledLine& line, const JumpTarget& target, Target& out,
                             Done& done) {
    done = Done::Nothing;
    out = {target.label, target.number};
    if (target.kind == JumpTarget::Kind::Number) out.label.clear();
    if (target.kind != JumpTarget::Kind::Computed) return true;
    Value value;
    done = evaluate(line, target.value, value);
    if (done == Done::Wait || lines.failed()) return false;
    if (value.is_text()) {
        const nc::ControlWords words(tables, line.text);
        out.label = words.normal(evaluator.text(value));
        out.number = words.block_number(out.label);
        if (out.number >= 0) out.label.clear();
        return true;
    }
    const double number = value.number;
    if (number != std::floor(number) || number < 1 ||
        number > static_cast<double>(tables.block_numbers.most)) {
        done = fail(line, diag::JumpTargetInvalid, target.span, {evaluator.written(value)});
        return false;
    }
    out.label.clear();
    out.number = static_cast<std::int64_t>(number);
    return true;
}

Program::State::Done Program::State::jump(CompiledLine& line, const ControlStatement& statement) {
    Target target;
    Done done = Done::Nothing;
    if (!resolve(line, statement.target, target, done)) return done;
    const Direction direction = statement.kind == Statement::JumpForward    ? Direction::Forward
                                : statement.kind == Statement::JumpBackward ? Direction::Backward
                                                                            : Direction::Both;
    Place found;
    const ProgramMap::Fault fault = map.find(target, direction, line.place, found);
    if (fault == ProgramMap::Fault::Missing && statement.kind == Statement::JumpIfThere)
        return Done::Nothing;
    if (fault != ProgramMap::Fault::None) {
        const std::string what =
            target.label.empty() ? "N" + std::to_string(target.number) : target.label;
        return fail(line, fault, diag::JumpTargetMissing, statement.target.span, '`' + what + '`');
    }
    return go(line, found, statement.span);
}

Program::State::Done Program::State::go(CompiledLine& line, const Place& target, const Span& span) {
    const std::uint64_t to = target.line.offset;
    while (!structures.empty() &&
           (to <= structures.back().head.line.offset || to > structures.back().end.line.offset))
        structures.pop_back();
    goes_on = target.line;
    // A section that is repeated is left for good by a jump out of it.
    while (!repeats.empty() &&
           (to < repeats.back().begin.offset || to >= repeats.back().end.offset))
        repeats.pop_back();
    if (to <= line.place.line.offset && ++turns > options.max_turns)
        return fail(line, diag::EndlessLoop, span, {std::to_string(options.max_turns)});
    return Done::Nothing;
}

Program::State::Done Program::State::choose(CompiledLine& line, const ControlStatement& statement,
                                            Block& out) {
    bool is_true = false;
    const Done done = truth(line, statement.value, is_true);
    if (done == Done::Wait || lines.failed() || !is_true) return done;
    return execute(line, statement.inner[0], out);
}

Program::State::Done Program::State::choose_case(CompiledLine& line,
                                                 const ControlStatement& statement) {
    Value value;
    Done done = evaluate(line, statement.value, value);
    if (done == Done::Wait || lines.failed()) return done;
    for (std::size_t i = 0; i < statement.inner.size(); ++i) {
        if (i < statement.list.size()) {
            Value wanted;
            done = evaluate(line, statement.list[i], wanted);
            if (done == Done::Wait || lines.failed()) return done;
            if (wanted.number != value.number) continue;
        }
        return jump(line, statement.inner[i]);
    }
    return Done::Nothing;
}

// ------------------------------------------------------------------------------ structures

Program::State::Done Program::State::enter(CompiledLine& line, const ControlStatement& statement) {
    const bool is_known = !structures.empty() && structures.back().head.line == line.place.line &&
                          statement.kind == Statement::While;
    bool is_true = true;
    if (statement.kind == Statement::If || statement.kind == Statement::While) {
        const Done done = truth(line, statement.value, is_true);
        if (done == Done::Wait || lines.failed()) return done;
    }
    if (!is_known) {
        nc::LineFront front;
        front.statement = statement.kind;
        front.loop = statement.loop;
        const Structure* found = nullptr;
        const auto fault = map.find_end(line.place, front, found);
        if (fault != ProgramMap::Fault::None) {
            return fail(line, fault, diag::StructureEndMissing, statement.span,
                        std::to_string(statement.loop));
        }
        if (static_cast<int>(structures.size()) >= language.rules.most_levels) {
            return fail(line, diag::StructuresTooDeep, statement.span,
                        {std::to_string(language.rules.most_levels)});
        }
        structures.push_back(
            {statement.kind, statement.loop, line.place, found->end, found->otherwise, 0, nullptr});
        if (statement.kind == Statement::For)
            structures.back().counts = std::make_unique<nc::ControlLine>(line.line);
    }
    OpenStructure& open = structures.back();
    if (statement.kind == Statement::For) {
        Value first;
        Value last;
        Done done = evaluate(line, statement.value, first);
        if (done != Done::Wait && !lines.failed()) done = evaluate(line, statement.second, last);
        if (done != Done::Wait && !lines.failed()) {
            first.number = std::round(first.number);
            done = store(line, statement.variable, first);
        }
        if (done == Done::Wait) structures.pop_back();
        if (done == Done::Wait || lines.failed()) return done;
        open.last = last.number;
        is_true = first.number <= last.number;
    }
    if (is_true) return Done::Nothing;
    if (statement.kind == Statement::If && open.otherwise) {
        goes_on = open.otherwise->next;
        return Done::Nothing;
    }
    goes_on = open.end.next;
    structures.pop_back();
    return Done::Nothing;
}

/// The end of a structure, or of one pass.
Program::State::Done Program::State::leave(CompiledLine& line, const ControlStatement& statement) {
    const auto is_own = [&](const OpenStructure& open) { return open.end.line == line.place.line; };
    while (!structures.empty() && !is_own(structures.back())) structures.pop_back();
    if (structures.empty()) return fail(line, diag::StructureBeginMissing, statement.span);
    OpenStructure& open = structures.back();
    bool once_more = false;
    switch (open.kind) {
        case Statement::While: goes_on = open.head.line; break;
        case Statement::Loop: goes_on = open.head.next; break;
        case Statement::For: {
            const Done done = count_on(line, open, once_more);
            if (done == Done::Wait || lines.failed()) return done;
            break;
        }
        case Statement::Repeat: {
            const Done done = truth(line, statement.value, once_more);
            if (done == Done::Wait || lines.failed()) return done;
            once_more = !once_more;
            break;
        }
        default: structures.pop_back(); return Done::Nothing;
    }
    if (open.kind == Statement::For || open.kind == Statement::Repeat) {
        if (!once_more) {
            structures.pop_back();
            return Done::Nothing;
        }
        goes_on = open.head.next;
    }
    if (++turns > options.max_turns)
        return fail(line, diag::EndlessLoop, statement.span, {std::to_string(options.max_turns)});
    return Done::Nothing;
}

/// The counter of a For takes its next value.
Program::State::Done Program::State::count_on(CompiledLine& line, OpenStructure& loop,
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
    return Done::Nothing;
}

Program::State::Done Program::State::otherwise(CompiledLine& line,
                                               const ControlStatement& statement) {
    const auto is_own = [&](const OpenStructure& open) {
        return open.otherwise && open.otherwise->line == line.place.line;
    };
    while (!structures.empty() && !is_own(structures.back())) structures.pop_back();
    if (structures.empty()) return fail(line, diag::StructureBeginMissing, statement.span);
    goes_on = structures.back().end.next;
    structures.pop_back();
    return Done::Nothing;
}

Program::State::Done Program::State::repeat_section(CompiledLine& line,
                                                    const ControlStatement& statement) {
    std::int64_t passes = 1;
    if (statement.count.is_given()) {
        Value count;
        const Done done = evaluate(line, statement.count, count);
        if (done == Done::Wait || lines.failed()) return done;
        const double wanted = std::round(count.number);
        if (!(wanted >= 0 && wanted <= kMostPasses))
            return fail(line, diag::RepeatCount, statement.count.span, {evaluator.written(count)});
        passes = static_cast<std::int64_t>(wanted);
    }
    Target target;
    Done done = Done::Nothing;
    if (!resolve(line, statement.from, target, done)) return done;
    const auto missing = [&](ProgramMap::Fault fault, const JumpTarget& which) {
        return fail(line, fault, diag::RepeatLabelMissing, which.span, '`' + which.label + '`');
    };
    Place begin;
    // Toward the head first, then forward.
    ProgramMap::Fault fault = map.find(target, Direction::Backward, line.place, begin);
    if (fault == ProgramMap::Fault::Missing)
        fault = map.find(target, Direction::Forward, line.place, begin);
    if (fault != ProgramMap::Fault::None) return missing(fault, statement.from);
    OpenRepeat repeat{begin.line, line.place.line, line.place.next, passes};
    const bool is_behind = begin.line.offset > line.place.line.offset;
    if (statement.kind == Statement::RepeatBlock) {
        repeat.end = begin.next;
    } else if (statement.to.kind != JumpTarget::Kind::None) {
        Target last;
        if (!resolve(line, statement.to, last, done)) return done;
        Place end;
        fault = map.find(last, Direction::Forward, begin, end);
        const bool is_before_end = fault == ProgramMap::Fault::None &&
                                   (is_behind || end.line.offset < line.place.line.offset);
        if (is_before_end) repeat.end = end.next;
        if (fault != ProgramMap::Fault::None && is_behind) return missing(fault, statement.to);
    } else if (!language.end_label.empty()) {
        Place end;
        const Position limit = is_behind ? Position{~std::uint64_t{0}, 0} : line.place.line;
        fault = map.find_label_between(language.end_label, begin.line, limit, end);
        if (fault == ProgramMap::Fault::None) repeat.end = end.next;
        if (fault != ProgramMap::Fault::None && is_behind) return missing(fault, statement.from);
    }
    if (passes == 0) return Done::Nothing;
    // Behind the frontier nothing was executed yet: those lines run for the first time here, and
    // once more later.
    if (++turns > options.max_turns)
        return fail(line, diag::EndlessLoop, statement.span, {std::to_string(options.max_turns)});
    repeats.push_back(repeat);
    goes_on = begin.line;
    return Done::Nothing;
}

// ------------------------------------------------------------------------------ the program

Program::Program(const nc::Dialect& dialect, nc::TextSource& text, std::string name,
                 const ProgramOptions& options, DiagnosticSink& sink)
    : state_(std::make_unique<State>(dialect, text, std::move(name), options, sink)) {}
Program::~Program() = default;

void Program::check_only() { state_->is_only_checking = true; }
void Program::follow(ControlState& state) { state_->variables.follow(state); }
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
bool Program::failed() const { return state_->has_visible_fault; }
bool Program::stopped() const { return state_->was_stopped; }
bool Program::is_behind_fault(const Block& block) const {
    static_cast<void>(block);
    return state_->has_visible_fault;
}
std::uint64_t Program::lines() const { return state_->most_line; }
bool Program::has_fault() const { return state_->lines.failed(); }
std::vector<ControlVariable> Program::variables() const { return state_->variables.list(); }
const std::vector<ActiveCode>& Program::codes() { return state_->codes.now(); }
std::uint64_t Program::line() const { return state_->here.line; }
std::uint64_t Program::statements() const { return state_->executed; }

}  // namespace kadr::interp
