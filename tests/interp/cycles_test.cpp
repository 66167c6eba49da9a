// Machining cycles: calls, modal repetition, levels, and what is restored behind them.
#include "bench.h"

namespace kadr::interp {
namespace {

using path::Op;

// As in dialects/iso.xml: drill(to, retract?, initial?, dwell?).
constexpr nc::CycleId kDrill = 0;
enum : std::size_t { kTo, kRetract, kInitial, kDwell, kParameters };

constexpr std::string_view kModal =
    "<rule name=\"modal_cycles\" value=\"yes\"/><rule name=\"cycle_levels_incremental\" "
    "value=\"yes\"/>";

/// Drills in one stroke, as the stdlib does; keeps what it was asked.
class Drill final : public CycleExpander {
  public:
    std::unique_ptr<Stream<Block>> expand(const CycleCall& call) override {
        calls.push_back(call);
        names.emplace_back(call.name);
        if (fails) return nullptr;
        std::vector<Block> blocks = extra;
        const auto level = [&](std::size_t parameter, double fallback) {
            return (call.given >> parameter & 1u) != 0 ? call.arguments[parameter] : fallback;
        };
        const double initial = level(kInitial, call.position[2]);
        blocks.push_back(rapid().z(level(kRetract, 2)));
        blocks.push_back(line().z(call.arguments[kTo]));
        blocks.push_back(rapid().z(initial));
        return std::make_unique<BlockList>(blocks);
    }

    bool fails = false;
    std::vector<Block> extra;
    std::vector<CycleCall> calls;
    std::vector<std::string> names;
};

Words drill(std::initializer_list<std::pair<std::size_t, double>> arguments) {
    return Words().cycle(kDrill, kParameters, arguments);
}

/// Op and end of every motion: `rapid 10 5 20, line 10 5 -12`.
std::string path_of(const Ran& ran) {
    std::string out;
    for (const path::Command& command : ran.commands) {
        if (command.op != Op::Rapid && command.op != Op::Line) continue;
        if (!out.empty()) out += ", ";
        out += command.op == Op::Rapid ? "rapid" : "line";
        for (std::size_t i = 0; i < 3; ++i)
            out += ' ' + format_shortest(round_to(command.to[i], 6));
    }
    return out;
}

TEST(Cycles, ACallIsExecutedByItsBlocks) {
    Drill cycles;
    const Ran ran =
        run({line().x(10).y(5).z(20).f(100), fn(Function::Incremental),
             drill({{kTo, -12}, {kRetract, 2}, {kInitial, 20}}).fn(Function::Stop), Words().x(1)},
            {.cycles = &cycles});
    EXPECT_EQ(ran.codes(), "");
    EXPECT_EQ(path_of(ran),
              "line 10 5 20, rapid 10 5 2, line 10 5 -12, rapid 10 5 20, line 11 5 20")
        << "motion and dimensions are the caller's again";
    ASSERT_EQ(cycles.calls.size(), 1u);
    EXPECT_EQ(cycles.names[0], "drill");
    EXPECT_EQ(cycles.calls[0].feed, 100);
    EXPECT_EQ(cycles.calls[0].speed, 1000);
    EXPECT_EQ(cycles.calls[0].position[0], 10);
    // Blocks of the cycle have no place of their own: they bear the call's.
    EXPECT_EQ(ran.commands.at(2).line, 3u);
    EXPECT_EQ(ran.commands.at(4).op, Op::Stop) << "behind the cycle";
}

TEST(Cycles, ModalCycleDrillsInEveryBlockWithAnAxis) {
    Drill cycles;
    const Ran ran =
        run({rapid().z(20),
             fn(Function::CycleReturnRetract)
                 .x(10)
                 .y(0)
                 .f(100)
                 .cycle(kDrill, kParameters, {{kTo, -12}, {kRetract, 2}}),
             Words().x(20), fn(Function::CoolantFlood),
             fn(Function::CycleReturnInitial).x(30).z(-5), fn(Function::CycleOff), Words().x(40)},
            {.rules = kModal, .cycles = &cycles});
    EXPECT_EQ(ran.codes(), "");
    EXPECT_EQ(path_of(ran),
              "rapid 0 0 20, "
              "rapid 10 0 20, rapid 10 0 2, line 10 0 -12, rapid 10 0 2, "
              "rapid 20 0 2, rapid 20 0 2, line 20 0 -12, rapid 20 0 2, "
              "rapid 30 0 2, rapid 30 0 2, line 30 0 -5, rapid 30 0 20, "
              "rapid 40 0 20");
}

TEST(Cycles, AMotionCodeEndsTheMode) {
    Drill cycles;
    const Ran ran =
        run({rapid().z(20), drill({{kTo, -1}, {kRetract, 2}}).x(1).f(100), rapid().x(5)},
            {.rules = kModal, .cycles = &cycles});
    EXPECT_EQ(cycles.calls.size(), 1u);
    EXPECT_EQ(end_of(ran), "5.0000 0.0000 20.0000");
}

TEST(Cycles, LevelsUnderIncrementalDimensions) {
    // R from the initial level: 20 − 18 = 2; Z from R: 2 − 14 = −12.
    Drill cycles;
    const Ran ran = run({rapid().z(20), fn(Function::Incremental),
                         drill({{kTo, -14}, {kRetract, -18}}).x(10).f(100), Words().x(10)},
                        {.rules = kModal, .cycles = &cycles});
    EXPECT_EQ(path_of(ran),
              "rapid 0 0 20, rapid 10 0 20, rapid 10 0 2, line 10 0 -12, rapid 10 0 20, "
              "rapid 20 0 20, rapid 20 0 2, line 20 0 -12, rapid 20 0 20");
}

TEST(Cycles, OtherPlanesAndFrames) {
    Drill cycles;
    const Ran ran =
        run({fn(Function::PlaneYz), rapid().x(20).y(3).z(4), fn(Function::Shift, {{0, 100}}),
             line().x(20).f(100), drill({{kTo, -12}, {kRetract, 2}, {kInitial, 20}})},
            {.cycles = &cycles});
    EXPECT_EQ(path_of(ran),
              "rapid 20 3 4, line 120 3 4, rapid 102 3 4, line 88 3 4, rapid 120 3 4");
    EXPECT_EQ(cycles.calls.at(0).position[0], 3);
    EXPECT_EQ(cycles.calls.at(0).position[1], 4);
    EXPECT_EQ(cycles.calls.at(0).position[2], 20);
}

TEST(Cycles, WhatCannotBeExecuted) {
    const std::vector<Block> blocks = {drill({{kTo, -12}}).f(100)};
    EXPECT_EQ(run(blocks).codes(), "K5251") << "no expander";

    Drill fails;
    fails.fails = true;
    const Ran failed = run(blocks, {.cycles = &fails});
    EXPECT_EQ(failed.codes(), "") << "the expander has said why";
    EXPECT_TRUE(failed.alarmed);

    Drill nested;
    nested.extra = {drill({{kTo, -12}})};
    const Ran ran = run(blocks, {.cycles = &nested});
    EXPECT_EQ(ran.codes(), "K5251");
    ASSERT_EQ(ran.messages[0].notes.size(), 1u);
    EXPECT_EQ(ran.messages[0].notes[0].text, "inside the cycle `drill`");

    Drill raw;
    raw.extra = {Words().kind(Block::Kind::Raw).text("M88")};
    EXPECT_EQ(run(blocks, {.cycles = &raw}).codes(), "K5252");

    Drill comments;
    comments.extra = {Words().kind(Block::Kind::Comment)};
    EXPECT_EQ(run(blocks, {.cycles = &comments}).codes(), "");
}

TEST(Cycles, AlarmsInsideNameTheCycle) {
    Drill cycles;
    const Ran ran = run({rapid().x(1), drill({{kTo, -12}})}, {.cycles = &cycles});
    EXPECT_EQ(ran.codes(), "K5210");
    EXPECT_EQ(ran.messages[0].line->line, 2u) << "the place is that of the call";
    EXPECT_EQ(ran.messages[0].notes.at(0).text, "inside the cycle `drill`");
}

}  // namespace
}  // namespace kadr::interp
