// tests.cpp — tests while they run: calls handed to the bench, figures, expectations; and a call as
// a program of its own.
#include "expand/tests.h"

#include <algorithm>
#include <cmath>

#include "base/assert.h"
#include "base/diagnostics/expand.h"
#include "base/diagnostics/test.h"
#include "expand/blocks.h"
#include "expand/numbers.h"
#include "expand/running.h"
#include "expand/start.h"
#include "expand/values.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using sema::FunctionCode;
using sema::FunctionKind;
using sema::SlotKind;
using sema::TestCall;

namespace {

bool stops_at_failure(Running& run);

// Where a cycle under test begins if the test does not set it: well above a part whose top is Z0,
// with a feed and a speed that no limit cuts.
constexpr double kStartHeight = 50;   // mm
constexpr double kStartFeed = 100;    // mm/min
constexpr double kStartSpeed = 1000;  // rpm

constexpr std::size_t kShownText = 4000;  // characters of a text in a message

std::string shortened(const std::string& text) {
    if (text.size() <= kShownText) return text;
    std::size_t cut = kShownText;
    while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0u) == 0x80u) --cut;
    return text.substr(0, cut) + "…";
}

}  // namespace

// ---------------------------------------------------------------- a test

void start_test(Running& run, std::uint32_t index, std::span<const Slot> values, TestBench& asked) {
    const FunctionCode& function = run.code.functions[index];
    prepare(run, function);
    run.test.bench = &asked;
    for (std::size_t i = 0; i < values.size(); ++i) argument_register(run, i) = values[i];
    enter(run, function, run.vm.all_given[index]);
}

std::optional<std::vector<Slot>> read_values(Running& run, std::uint32_t index,
                                             const std::vector<sema::Define>& defines) {
    const FunctionCode& function = run.code.functions[index];
    std::vector<Slot> values;
    bool is_good = true;
    for (const sema::ParameterInfo& parameter : function.parameters) {
        const auto found =
            std::find_if(defines.begin(), defines.end(),
                         [&](const sema::Define& define) { return define.name == parameter.name; });
        values.emplace_back();
        if (found == defines.end()) {
            run.sink.report(diag::DefineMissing, parameter.range)
                .arg(function.name)
                .arg(parameter.name)
                .fix("give it on the command line: `-D " + parameter.name + "=…`");
            is_good = false;
        } else if (!set_parameter(run, function, parameter, found->value, values.back())) {
            is_good = false;
        }
    }
    return is_good ? std::optional(values) : std::nullopt;
}

Done test_call(Running& run, const Instruction& instruction, Slot* registers, std::uint32_t at) {
    KADR_ASSERT(run.test.bench != nullptr, "a test runs without a bench");
    const TestCall& entry =
        run.code.test_calls[static_cast<std::size_t>(instruction.immediate.pair.second)];
    Slot* first = registers + instruction.a;
    CallUnderTest call;
    call.call = &entry;
    call.at = at;
    call.options = first;
    call.arguments = first + sema::kTestOptions;
    call.heap = &run.vm.heap;
    call.range = run.code.locations[at];
    const Slot text = first[sema::kTestOptions - 1];
    if (text.integer != sema::kNotGivenInteger) call.text = run.vm.heap.text(text.integer);
    const auto give_up = [&] {
        run.status.fail();
        return kFailed;
    };
    switch (entry.purpose) {
        case TestCall::Purpose::Execute:
        case TestCall::Purpose::Attempt: {
            const std::optional<std::int64_t> execution = run.test.bench->execute(call);
            if (!execution) return give_up();
            first->integer = *execution;
            return kDone;
        }
        case TestCall::Purpose::Text: {
            std::optional<std::string> written = run.test.bench->write(call);
            if (!written) return give_up();
            if (run.vm.heap.is_full()) collect_garbage(run, registers);
            first->integer = run.vm.heap.new_text(std::move(*written));
            return kDone;
        }
        case TestCall::Purpose::ExpectError:
            if (run.test.bench->require_error(call)) return kDone;
            run.status.note_failure();
            return Done(!stops_at_failure(run));
    }
    return kDone;
}

namespace {

bool stops_at_failure(Running& run) {
    // A property has its counterexample; a test may have more to report.
    if (run.vm.calls[0].function->kind == FunctionKind::Property) run.status.finish();
    return !run.status.is_running();
}

}  // namespace

void reject_values(Running& run) {
    run.test.is_rejected = true;
    run.status.finish();
}

void ask_figure(Running& run, const Instruction& instruction, Slot* registers) {
    KADR_ASSERT(run.test.bench != nullptr, "a test runs without a bench");
    const auto figure = static_cast<sema::Figure>(instruction.c);
    const sema::FigureInfo& info = sema::all_figures()[instruction.c];
    Slot* first = registers + instruction.a;
    constexpr std::size_t kMostArguments = 8;  // figures.def: two points and two lengths
    const FigureAnswer answer = run.test.bench->ask(registers[instruction.b].integer, figure,
                                                    std::span<const Slot>(first, kMostArguments));
    if (!info.parameters.empty()) {
        run.test.reason = answer.reason;
        run.test.reason_at = answer.reason_at;
    }
    switch (info.result) {
        case sema::FigureResult::Count:
        case sema::FigureResult::Truth: first->integer = answer.count; return;
        case sema::FigureResult::Length:
        case sema::FigureResult::Time: first->number = answer.numbers[0]; return;
        case sema::FigureResult::Point:
            for (std::size_t i = 0; i < 3; ++i) first[i].number = answer.numbers[i];
            return;
        case sema::FigureResult::Text:
            if (run.vm.heap.is_full()) collect_garbage(run, registers);
            first->integer = run.vm.heap.new_text(answer.text);
            return;
        case sema::FigureResult::Counts:
        case sema::FigureResult::Lengths: break;
    }
    if (run.vm.heap.is_full()) collect_garbage(run, registers);
    first->integer =
        run.vm.heap.new_array(static_cast<std::uint32_t>(instruction.immediate.pair.first));
    for (const double number : answer.list) {
        Slot slot{};
        if (info.result == sema::FigureResult::Counts) {
            slot.integer = static_cast<std::int64_t>(std::llround(number));
        } else {
            slot.number = number;
        }
        run.vm.heap.append(first->integer, &slot);
    }
}

void list_dialects(Running& run, const Instruction& instruction, Slot* registers) {
    KADR_ASSERT(run.test.bench != nullptr, "a test runs without a bench");
    if (run.vm.heap.is_full()) collect_garbage(run, registers);
    Slot& result = registers[instruction.a];
    if (instruction.c == 0) {
        result.integer = run.vm.heap.new_text(run.test.bench->dialect());
        return;
    }
    result.integer = run.vm.heap.new_array(instruction.b);
    for (const std::string& name : run.test.bench->dialects()) {
        Slot slot{};
        slot.integer = run.vm.heap.new_text(name);
        run.vm.heap.append(result.integer, &slot);
    }
}

void report_expectation(Running& run, const Instruction& instruction, const Slot* registers,
                        std::uint32_t at) {
    run.status.note_failure();
    if (stops_at_failure(run) || std::find(run.test.failed_at.begin(), run.test.failed_at.end(),
                                           at) == run.test.failed_at.end()) {
        // In a loop, the first pass speaks for all.
        run.test.failed_at.push_back(at);
        const std::string& what =
            run.code.texts[static_cast<std::size_t>(instruction.immediate.pair.first)];
        const auto why = static_cast<sema::Expectation>(instruction.c & (sema::kHasReason - 1));
        const bool is_compared = why == sema::Expectation::Compared;
        DiagnosticBuilder builder = run.sink.report(
            is_compared ? diag::ExpectFailed : diag::ExpectUntrue, run.code.locations[at]);
        builder.arg(what);
        if (is_compared) {
            std::string wanted =
                run.code.texts[static_cast<std::size_t>(instruction.immediate.pair.second)];
            wanted.replace(wanted.find("{}"), 2,
                           shortened(run.vm.heap.text(registers[instruction.b].integer)));
            builder.arg(shortened(run.vm.heap.text(registers[instruction.a].integer))).arg(wanted);
        }
        if (why == sema::Expectation::UntrueOfText) {
            builder.note("the text is:\n" +
                         shortened(run.vm.heap.text(registers[instruction.a].integer)));
        }
        if ((instruction.c & sema::kHasReason) != 0 && !run.test.reason.empty()) {
            if (run.test.reason_at.is_valid() &&
                run.test.reason_at.index < run.code.statements.size()) {
                builder.note(run.code.statements[run.test.reason_at.index], run.test.reason);
            } else {
                builder.note(run.test.reason);
            }
        }
    }
}

// ---------------------------------------------------------------- a call under test

namespace {

/// Blocks that a cycle may rely on: the spindle turns, a feed is set, the tool is somewhere.
void set_up(Running& run, const CallUnderTest& call) {
    const auto option = [&](std::size_t i, double otherwise) {
        const double value = call.options[i].number;
        return value == value ? value : otherwise;
    };
    const auto deliver = [&](const Block& block) {
        run.modal.take_block(block, run.target.rules());
        if (run.options.trace) run.batch.add_origin({});  // no statement of the source makes it
    };
    double feed = option(3, kStartFeed / 60);
    double speed = option(4, kStartSpeed / 60);
    const bool is_per_turn = sema::is_second_form(feed);
    const bool is_cutting = sema::is_second_form(speed);
    feed = is_per_turn ? feed / sema::kSecondForm : neat(feed * 60);
    speed = is_cutting ? neat(speed / sema::kSecondForm * 60 / 1000) : neat(speed * 60);
    {
        Block& block = next_block(run, {});
        if (is_cutting) block.add(Function::CuttingSpeedOn, 0);
        block.add(Function::SpindleCw, 0);
        block.set(nc::Slot::Speed, speed);
        deliver(block);
    }
    {
        Block& block = next_block(run, {});
        block.motion = Function::Rapid;
        if (is_per_turn) block.add(Function::FeedPerRevolution, 0);
        block.set(nc::Slot::X, option(0, 0));
        block.set(nc::Slot::Y, option(1, 0));
        block.set(nc::Slot::Feed, feed);
        deliver(block);
    }
    Block& block = next_block(run, {});
    block.motion = Function::Rapid;
    block.set(nc::Slot::Z, option(2, kStartHeight));
    deliver(block);
}

}  // namespace

void start_call(Running& run, const CallUnderTest& call) {
    const TestCall& entry = *call.call;
    const FunctionCode& function = run.code.functions[entry.function];
    prepare(run, function);
    if (function.kind != FunctionKind::Program) set_up(run, call);
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const sema::ParameterInfo& parameter = function.parameters[i];
        if ((entry.given >> i & 1u) == 0) continue;
        const std::vector<SlotKind>& kinds = run.code.layouts[entry.layouts[i]].slots;
        for (std::size_t s = 0; s < kinds.size(); ++s) {
            const std::size_t at = parameter.slot + s;
            argument_register(run, at) =
                run.vm.heap.adopt(*call.heap, call.arguments[at], kinds[s]);
        }
    }
    // Below the call stands what called it; the call returns to the Finish behind its instruction.
    CallFrame& bottom = run.vm.calls.push();
    bottom = {};
    bottom.function = &run.code.functions[0];
    bottom.base = run.code.globals;
    enter(run, function, entry.given, call.at + 1);
}

}  // namespace kadr::expand
