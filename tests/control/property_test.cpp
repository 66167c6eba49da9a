// Random programs do the same in every language that they can be written in, and what is written
// from their blocks does it again.
//
// What the languages do differently is left out, and shown by programs of this folder instead:
//   FANUC counts ATAN from 0 to 360 degrees, knows only whole numbers for MOD, has no NOT, and
//   rounds in a word to the increment where it says ROUND
//   SINUMERIK takes numbers for equal that differ by a 2·10^12th, and so may compare otherwise
//   whole numbers that come out of fractions (`ROUND`, `TRUNC` at an edge) hang on the last bit
//   FANUC and the writer round each word to the increment, SINUMERIK takes it as computed
#include <cmath>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "driver/generated_text.h"
#include "driver/program.h"
#include "driver/session.h"
#include "macro/program.h"
#include "nc/tables.h"
#include "tests/common/inputs.h"
#include "tests/control/property_bench.h"
#include "tests/control/random_program.h"
#include "write/writer.h"

namespace kadr::control_testing::property_test {
namespace {

using nc::Block;
using nc::Function;
using nc::Slot;
using nc::testing::shipped;
using path::Command;
using path::Op;

/// The same cases in every run; RC_PARAMS in the environment asks for others.
const bool kIsSeeded = setenv("RC_PARAMS", "seed=20240229 max_success=150", 0) == 0;

constexpr double kShortMove = 0.01;  // mm: shorter ones need not come out in all languages

/// How far what is read may be from what was meant, in mm.
struct Tolerance {
    double to;
    double center;  // what the ends of an arc are off moves its centre by more
};
constexpr Tolerance kRounded{0.0005 + 1e-6, 0.005};
constexpr Tolerance kTwiceRounded{0.001 + 1e-6, 0.01};
constexpr Tolerance kComputed{1e-6, 1e-4};

/// A Kadr program as the text of a control.
std::string expanded(const std::string& target, const std::string& program) {
    RC_LOG() << "---- kadr\n" << program;
    static Sources sources = test::inputs().new_sources();
    std::string words;
    driver::Messages messages(sources, {}, [&](std::string_view text) { words += text; });
    driver::Options options;
    options.dialect = target;
    driver::Session session(options, test::inputs(), sources, messages);
    const nc::Dialect* dialect = session.chosen_dialect(target);
    const auto checked = driver::load_program(session, sources.add("random.kadr", program));
    std::string out;
    if (checked && dialect != nullptr) {
        driver::GeneratedText text(session, *checked, *dialect);
        (void)text.start();  // what is wrong is in `messages`
        for (std::string_view piece = text.next(); !piece.empty(); piece = text.next())
            out += piece;
    }
    if (messages.errors() > 0) RC_FAIL(words);
    return out;
}

// ---------------------------------------------------------------- comparing

/// The motions that go anywhere.
std::vector<Command> motions(const std::vector<Command>& commands) {
    std::vector<Command> out;
    AxisValues at{};
    for (const Command& command : commands) {
        if (!command.is_motion()) continue;
        if (command.op() == Op::Arc || way(at, command.motion().to) > kShortMove)
            out.push_back(command);
        at = command.motion().to;
    }
    return out;
}

std::string shown(const Step& step) {
    std::string out = step.kind == Step::Kind::Rapid ? "rapid" : "line";
    if (step.kind == Step::Kind::Arc)
        out = "arc about " + format_shortest(step.center[0]) + ' ' +
              format_shortest(step.center[1]) + (step.is_clockwise ? " clockwise" : "") + " by " +
              format_shortest(step.sweep);
    out += " to";
    for (const double value : step.to) out += ' ' + format_shortest(value);
    return out + " feed " + format_shortest(step.feed);
}

Step step_of(const Command& command) {
    Step step;
    if (command.op() == Op::Line) step.kind = Step::Kind::Line;
    if (command.op() == Op::Arc) {
        step.kind = Step::Kind::Arc;
        step.center[0] = command.motion().arc().center.x();
        step.center[1] = command.motion().arc().center.y();
        step.sweep = command.motion().arc().sweep;
        step.is_clockwise = command.motion().arc().is_clockwise;
    }
    std::copy_n(command.motion().to.begin(), 3, step.to);
    if (command.op() != Op::Rapid) step.feed = command.motion().feed;
    return step;
}

bool are_alike(const Step& a, const Step& b, const Tolerance& tolerance) {
    bool is_alike = a.kind == b.kind && a.is_clockwise == b.is_clockwise;
    for (std::size_t i = 0; i < 3; ++i) is_alike &= std::abs(a.to[i] - b.to[i]) <= tolerance.to;
    for (std::size_t i = 0; i < 2; ++i)
        is_alike &= std::abs(a.center[i] - b.center[i]) <= tolerance.center;
    // The radius is 1 mm or more.
    return is_alike && std::abs(a.sweep - b.sweep) <= 4 * tolerance.center &&
           std::abs(a.feed - b.feed) <= tolerance.to;
}

void assert_steps(const std::vector<Step>& meant, const std::vector<Command>& commands,
                  const Tolerance& tolerance) {
    const std::vector<Command> found = motions(commands);
    for (std::size_t i = 0; i < meant.size() && i < found.size(); ++i) {
        const Step step = step_of(found[i]);
        if (are_alike(meant[i], step, tolerance)) continue;
        RC_FAIL("motion " + std::to_string(i + 1) + ": " + shown(step) + ", not " +
                shown(meant[i]));
    }
    RC_ASSERT(found.size() == meant.size());
}

void assert_variables(const Outcome& meant, const std::vector<macro::ControlVariable>& found) {
    std::size_t seen = 0;
    for (const macro::ControlVariable& variable : found) {
        const std::size_t number = std::stoul(variable.name.substr(1));
        RC_ASSERT(number < kVariables);
        ++seen;
        if (std::abs(variable.number - meant.variables[number]) > 1e-6)
            RC_FAIL(variable.name + " is " + format_shortest(variable.number) + ", not " +
                    format_shortest(meant.variables[number]));
    }
    RC_ASSERT(seen == kVariables - 1);
}

void check_language(const char* dialect, Language language, const Tolerance& tolerance) {
    const RandomProgram program = any_program();
    const Outcome meant = outcome_of(program);
    const Ran ran = run_text(shipped(dialect), text_of(program, language));
    assert_steps(meant.steps, ran.commands, tolerance);
    assert_variables(meant, ran.variables);
    const Ran again = run_text(shipped(dialect), written(shipped(dialect), ran.blocks));
    assert_steps(meant.steps, again.commands, kTwiceRounded);
}

RC_GTEST_PROP(RandomProgram, OfFanucDoesWhatIsMeant, ()) {
    check_language("fanuc", Language::Fanuc, kRounded);
}
RC_GTEST_PROP(RandomProgram, OfSinumerikDoesWhatIsMeant, ()) {
    check_language("sinumerik", Language::Sinumerik, kComputed);
}
RC_GTEST_PROP(RandomProgram, OfAxiomaDoesWhatIsMeant, ()) {
    check_language("axioma", Language::Sinumerik, kComputed);
}

void check_kadr(const char* target) {
    const RandomProgram program = any_program();
    const std::string text = expanded(target, text_of(program, Language::Kadr));
    assert_steps(outcome_of(program).steps, run_text(shipped(target), text).commands, kRounded);
}

RC_GTEST_PROP(RandomProgram, OfKadrDoesWhatIsMeantOnFanuc, ()) { check_kadr("fanuc"); }
RC_GTEST_PROP(RandomProgram, OfKadrDoesWhatIsMeantOnSinumerik, ()) { check_kadr("sinumerik"); }

// ---------------------------------------------------------------- flat programs

double any_length() { return whole(-200'000, 200'000) / 1000.0; }

Block any_flat_move(Function plane) {
    Block block;
    block.motion = maybe() ? Function::Line : Function::Rapid;
    const int axes = whole(1, 7);
    for (std::size_t i = 0; i < 3; ++i) {
        if ((axes >> i & 1) != 0) block.set(static_cast<Slot>(i), any_length());
    }
    if (maybe()) block.set(Slot::Feed, whole(1, 99'999) / 100.0);
    if (maybe()) add(block, maybe() ? Function::Absolute : Function::Incremental);
    if (whole(0, 2) != 0) return block;
    // A whole circle in the plane: both of its axes are behind its centre.
    block.given &= bit(Slot::Feed);
    block.function_count = 0;
    block.motion = maybe() ? Function::ArcCw : Function::ArcCcw;
    const Slot first = plane == Function::PlaneYz ? Slot::CenterY : Slot::CenterX;
    const Slot second = plane == Function::PlaneXy ? Slot::CenterY : Slot::CenterZ;
    block.set(first, whole(1000, 90'000) / 1000.0);
    block.set(second, any_length());
    return block;
}

Block any_flat_function() {
    using F = Function;
    Block block;
    switch (whole(0, 8)) {
        case 0: add(block, F::Dwell, {whole(1, 9000) / 1000.0}); break;
        case 1: add(block, maybe() ? F::CoolantFlood : F::CoolantOff); break;
        case 2: add(block, maybe() ? F::SpindleCw : F::SpindleCcw); break;
        case 3: block.set(Slot::Speed, whole(1, 20'000)); break;
        case 4: add(block, maybe() ? F::Stop : F::OptionalStop); break;
        case 5: add(block, F::Shift, {any_length(), any_length(), any_length()}); break;
        case 6: add(block, maybe() ? F::ExactStop : F::ContinuousPath); break;
        case 7:
            add(block, F::FeedPerRevolution);
            block.set(Slot::Feed, whole(1, 2000) / 1000.0);
            break;
        default:
            add(block, F::FeedPerMinute);
            block.set(Slot::Feed, whole(1, 99'999) / 100.0);
            break;
    }
    return block;
}

std::vector<Block> any_flat_program(const nc::DialectTables& tables) {
    std::vector<Block> blocks(1);
    add(blocks[0], Function::SpindleCw);
    blocks[0].set(Slot::Speed, 1000);
    blocks[0].motion = Function::Line;
    for (const Slot slot : {Slot::X, Slot::Y, Slot::Z}) blocks[0].set(slot, 10);
    blocks[0].set(Slot::Feed, 100);
    Function plane = Function::PlaneXy;
    for (int i = whole(1, 15); i > 0; --i) {
        const int choice = whole(0, 6);
        Block block;
        if (choice == 0) {
            plane = *rc::gen::element(Function::PlaneXy, Function::PlaneZx, Function::PlaneYz);
            add(block, plane);
        } else {
            block = choice < 4 ? any_flat_move(plane) : any_flat_function();
        }
        bool can_say = true;
        for (std::size_t f = 0; f < block.function_count; ++f)
            can_say &=
                !tables.forms_of[static_cast<std::size_t>(block.functions[f].function)].empty();
        if (can_say) blocks.push_back(block);
    }
    blocks.emplace_back();
    add(blocks.back(), Function::EndRewind);
    return blocks;
}

void check_flat(const char* name) {
    const nc::Dialect& dialect = shipped(name);
    std::vector<Block> blocks = any_flat_program(dialect.tables());
    const std::string text = written(dialect, blocks);
    std::vector<Block> all = head_of(dialect);
    all.insert(all.end(), blocks.begin(), blocks.end());
    const std::string again = listed(run_text(dialect, text).commands);
    RC_ASSERT(again == listed(run_blocks(dialect, all)));
}

RC_GTEST_PROP(FlatProgram, OfIsoExecutesAlikeWhenRead, ()) { check_flat("iso"); }
RC_GTEST_PROP(FlatProgram, OfSinumerikExecutesAlikeWhenRead, ()) { check_flat("sinumerik"); }
RC_GTEST_PROP(FlatProgram, OfFanucExecutesAlikeWhenRead, ()) { check_flat("fanuc"); }
RC_GTEST_PROP(FlatProgram, OfAxiomaExecutesAlikeWhenRead, ()) { check_flat("axioma"); }

}  // namespace
}  // namespace kadr::control_testing::property_test
