// Random programs of five axes: what the writer makes of their blocks does the same when it is
// read, up to the alarm, if there is one.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/control/property_bench.h"
#include "tests/interp/five_axis_bench.h"

namespace kadr::control_testing::oriented_property_test {
namespace {

using nc::Slot;
using nc::testing::shipped;

/// The tilting table of the tests, which reaches far.
const machine::Machine& wide_trunnion() {
    static const machine::Machine kMachine = [] {
        machine::Machine machine = interp::trunnion();
        for (machine::MachineAxis& axis : machine.axes) {
            if (axis.is_rotary) continue;
            axis.lower = -1e6;
            axis.upper = 1e6;
        }
        machine.work_offsets = {{}, {}};
        for (machine::ToolData& tool : machine.tools) tool.length = 0;
        return machine;
    }();
    return kMachine;
}

// ---------------------------------------------------------------- executing

struct Done {
    std::vector<Command> motions;
    std::string alarms;  // codes
};

Done done_by(interp::Interpreter& interpreter, const DiagnosticList& messages) {
    Done done;
    for (const Command& command : commands_of(interpreter))
        if (command.is_motion()) done.motions.push_back(command);
    for (const Diagnostic& message : messages.all())
        if (message.severity == Severity::Alarm) done.alarms += std::string(message.row->code);
    return done;
}

Done run(const nc::Dialect& dialect, const std::vector<Block>& blocks) {
    DiagnosticList messages;
    interp::BlockList source(blocks);
    interp::Interpreter interpreter(dialect, wide_trunnion(), source, nullptr, nullptr, {},
                                    messages);
    return done_by(interpreter, messages);
}

Done run(const nc::Dialect& dialect, const std::string& text) {
    DiagnosticList messages;
    nc::testing::OneText source(text);
    macro::NcProgram program(dialect, source, "test", {}, messages);
    interp::Interpreter interpreter(dialect, wide_trunnion(), program, &program, nullptr, {},
                                    messages);
    program.follow(interpreter);
    return done_by(interpreter, messages);
}

void assert_alike(const Done& meant, const Done& found) {
    RC_ASSERT(found.alarms == meant.alarms);
    RC_ASSERT(found.motions.size() == meant.motions.size());
    for (std::size_t i = 0; i < meant.motions.size(); ++i) {
        const Command& a = meant.motions[i];
        const Command& b = found.motions[i];
        RC_ASSERT(a.op() == b.op() && a.motion().orient_kind == b.motion().orient_kind);
        RC_ASSERT((a.motion().direction - b.motion().direction).norm() < 1e-5);
        RC_ASSERT((a.motion().orientation().axis * a.motion().orientation().angle -
                   b.motion().orientation().axis * b.motion().orientation().angle)
                      .norm() < 1e-4);
        for (std::size_t k = 0; k < kAxes; ++k)
            RC_ASSERT(std::abs(a.motion().to[k] - b.motion().to[k]) < 2e-3);
        RC_ASSERT(std::abs(a.motion().feed - b.motion().feed) < 1e-4);
    }
}

void check(const char* name, std::vector<Block> blocks) {
    const nc::Dialect& dialect = shipped(name);
    blocks.emplace_back();
    add(blocks.back(), Function::EndRewind);
    const std::string text = written(dialect, blocks);
    RC_LOG() << text;
    std::vector<Block> all = head_of(dialect);
    all.insert(all.end(), blocks.begin(), blocks.end());
    const Done meant = run(dialect, all);
    RC_CLASSIFY(meant.alarms.empty(), "runs to its end");
    RC_CLASSIFY(meant.motions.size() > 5, "more than five motions");
    assert_alike(meant, run(dialect, text));
}

// ---------------------------------------------------------------- drawing

double any_length() { return whole(-100'000, 100'000) / 1000.0; }
double any_angle(int most_deg) { return whole(-1000 * most_deg, 1000 * most_deg) / 1000.0; }

Block of(Function function, std::initializer_list<double> arguments = {}) {
    Block block;
    add(block, function, arguments);
    return block;
}

Block first_move() {
    Block block = of(Function::SpindleCw);
    block.set(Slot::Speed, 1000);
    block.motion = Function::Line;
    for (const Slot slot : {Slot::X, Slot::Y, Slot::Z}) block.set(slot, 10);
    block.set(Slot::Feed, 100);
    return block;
}

Block any_move() {
    Block block;
    block.motion = whole(0, 3) == 0 ? Function::Rapid : Function::Line;
    const int axes = whole(1, 7);
    for (std::size_t i = 0; i < 3; ++i)
        if ((axes >> i & 1) != 0) block.set(static_cast<Slot>(i), any_length());
    if (whole(0, 3) == 0) block.set(Slot::Feed, whole(100, 99'999) / 100.0);
    return block;
}

/// Components of a vector that is not nothing; `function` has a component and a value.
void add_vector(Block& block, Function function) {
    for (int i = 0; i < 2; ++i)
        if (maybe()) add(block, function, {static_cast<double>(i), whole(-900, 900) / 1000.0});
    add(block, function, {2, whole(200, 1000) / 1000.0});
}

Block any_mode(bool is_axioma) {
    using F = Function;
    switch (whole(0, 9)) {
        case 0: return of(F::OrientAxes);
        case 1: return of(F::OrientSurface);
        case 2: return of(maybe() ? F::OrientConeCw : F::OrientConeCcw);
        case 3: return of(is_axioma ? F::AnglesZyz : F::AnglesEuler);
        case 4: return of(maybe() ? F::AnglesRpy : F::AnglesXyz);
        case 5: return of(maybe() ? F::OrientInBase : F::OrientInWork);
        case 6: return of(F::OrientReset, {any_angle(60), any_angle(180)});
        default: return of(F::OrientGreatCircle);
    }
}

/// What stands beside a motion depends on the mode that acts.
Block any_turn(Function turning) {
    Block block = any_move();
    if (turning == Function::OrientSurface) {
        if (maybe()) add(block, Function::SurfaceLead, {any_angle(25)});
        if (maybe()) add(block, Function::SurfaceTilt, {any_angle(25)});
        return block;
    }
    const bool is_cone = turning == Function::OrientConeCw || turning == Function::OrientConeCcw;
    const int choice = is_cone ? 0 : whole(0, 3);
    if (choice < 2) {
        add_vector(block, Function::ToolVector);
        if (is_cone) add(block, Function::ConeOpening, {any_angle(170)});
    } else if (choice == 2) {
        for (int i = 0; i < 3; ++i)
            add(block, Function::ToolAngle, {static_cast<double>(i), any_angle(50)});
    } else {
        block.set(nc::slot_of(Axis::A), any_angle(60));
        block.set(nc::slot_of(Axis::C), any_angle(170));
    }
    return block;
}

std::vector<Block> any_oriented(bool is_axioma) {
    std::vector<Block> blocks = {first_move(), of(Function::TcpOn)};
    Function turning = Function::OrientGreatCircle;
    for (int i = whole(1, 15); i > 0; --i) {
        const int choice = whole(0, 9);
        if (choice < 3) {
            blocks.push_back(any_mode(is_axioma));
            const Function function = blocks.back().functions[0].function;
            if (nc::info(function).group == nc::Group::OrientInterpolation) turning = function;
        } else if (choice == 3) {
            blocks.push_back(of(Function::TcpOff));
            blocks.push_back(any_move());
            blocks.push_back(of(Function::TcpOn));
        } else if (choice == 4) {
            blocks.push_back(of(Function::Shift, {any_length(), any_length(), any_length()}));
        } else {
            blocks.push_back(choice < 7 ? any_move() : any_turn(turning));
        }
    }
    return blocks;
}

std::vector<Block> any_tilted() {
    std::vector<Block> blocks = {first_move()};
    for (int i = whole(1, 5); i > 0; --i) {
        blocks.push_back(
            of(Function::TiltedPlaneEuler, {any_length(), any_length(), any_length(),
                                            any_angle(180), any_angle(40), any_angle(180)}));
        if (whole(0, 3) != 0) blocks.push_back(of(Function::AlignTool, {0}));
        for (int k = whole(1, 4); k > 0; --k) {
            blocks.push_back(any_move());
            // The first place in another system names all of its axes.
            for (const Slot slot : {Slot::X, Slot::Y, Slot::Z})
                if (!blocks.back().has(slot)) blocks.back().set(slot, any_length());
        }
        blocks.push_back(of(Function::TiltedPlaneOff));
        blocks.push_back(first_move());
    }
    return blocks;
}

RC_GTEST_PROP(OrientedProgram, OfSinumerikExecutesAlikeWhenRead, ()) {
    check("sinumerik", any_oriented(false));
}
RC_GTEST_PROP(OrientedProgram, OfAxiomaExecutesAlikeWhenRead, ()) {
    check("axioma", any_oriented(true));
}
RC_GTEST_PROP(TiltedProgram, OfFanucExecutesAlikeWhenRead, ()) { check("fanuc", any_tilted()); }

}  // namespace
}  // namespace kadr::control_testing::oriented_property_test
