// Machining cycles: calls, modal repetition, levels, and what is restored behind them.
#include "bench.h"

namespace kadr::interp::cycles_test {
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
    std::optional<std::string> refusal() const override { return refused; }

    std::unique_ptr<Stream<Block>> expand(const CycleCall& call) override {
        calls.push_back(call);
        std::array<double, kParameters + 1>& own = arguments.emplace_back();
        std::copy_n(call.arguments.begin(), std::min(own.size(), call.arguments.size()),
                    own.begin());
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
    std::optional<std::string> refused;
    std::vector<Block> extra;
    std::vector<CycleCall> calls;
    std::vector<std::array<double, kParameters + 1>> arguments;  // of the calls
    std::vector<std::string> names;
};

Words drill(std::initializer_list<std::pair<std::size_t, double>> arguments) {
    return Words().cycle(kDrill, kParameters, arguments);
}

/// Op and end of every motion: `rapid 10 5 20, line 10 5 -12`.
std::string path_of(const Ran& ran) {
    std::string out;
    for (const path::Command& command : ran.commands) {
        if (command.op() != Op::Rapid && command.op() != Op::Line) continue;
        if (!out.empty()) out += ", ";
        out += command.op() == Op::Rapid ? "rapid" : "line";
        for (std::size_t i = 0; i < 3; ++i)
            out += ' ' + format_shortest(round_to(command.motion().to[i], 6));
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
    EXPECT_EQ(ran.commands.at(4).op(), Op::Stop) << "behind the cycle";
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

/// Depths of the calls, one hole each.
std::string holes(const Drill& cycles) {
    std::string out;
    for (std::size_t i = 0; i < cycles.calls.size(); ++i) {
        if (!out.empty()) out += ", ";
        out += format_shortest(cycles.calls[i].position[0]) + ": " +
               format_shortest(cycles.arguments[i][kRetract]) + " to " +
               format_shortest(cycles.arguments[i][kTo]);
    }
    return out;
}

TEST(Cycles, ABlockRepeatsTheCycleOrOnlyKeepsItsWords) {
    // fanuc.md 5.1: K counts, K0 stores; under G91 every repetition moves on.
    Drill cycles;
    const auto times = [](double count) { return fn(Function::CycleWords, {{2, count}}); };
    const Ran ran = run(
        {rapid().z(20), fn(Function::Incremental), drill({{kTo, -5}, {kRetract, -18}}).x(10).f(100),
         times(3).x(10), times(0).x(50).z(-7), Words().x(1)},
        {.rules = kModal, .cycles = &cycles});
    EXPECT_EQ(ran.codes(), "");
    EXPECT_EQ(holes(cycles), "10: 2 to -3, 20: 2 to -3, 30: 2 to -3, 40: 2 to -3, 41: 2 to -5");
}

TEST(Cycles, DistancesStayDistancesBehindG90) {
    Drill cycles;
    const Ran ran = run(
        {rapid().z(20), fn(Function::Incremental), drill({{kTo, -5}, {kRetract, -18}}).x(10).f(100),
         fn(Function::Absolute).x(5), Words().x(6).r(3), Words().x(7).z(-1)},
        {.rules = kModal, .cycles = &cycles});
    EXPECT_EQ(ran.codes(), "");
    EXPECT_EQ(holes(cycles), "10: 2 to -3, 5: 2 to -3, 6: 3 to -2, 7: 3 to -1");
}

TEST(Cycles, GoesStraightToTheRetractLevelAndDownToALowerStart) {
    // fanuc.md 5.1: rapid to R from the present level, at the end to the initial level.
    Drill cycles;
    const Ran ran =
        run({rapid().z(1), drill({{kTo, -12}, {kRetract, 2}}).x(10).f(100), Words().x(20)},
            {.rules = kModal, .cycles = &cycles});
    EXPECT_EQ(path_of(ran),
              "rapid 0 0 1, rapid 10 0 1, rapid 10 0 2, line 10 0 -12, rapid 10 0 2, rapid 10 0 1, "
              "rapid 20 0 1, rapid 20 0 2, line 20 0 -12, rapid 20 0 2, rapid 20 0 1");
}

TEST(Cycles, LevelsThatNobodySaidAreZero) {
    Drill cycles;
    const Ran ran = run({rapid().z(20), drill({{kTo, -12}}).x(1).f(100), fn(Function::CycleOff),
                         drill({{kRetract, 5}}).x(2)},
                        {.rules = kModal, .cycles = &cycles});
    EXPECT_EQ(ran.codes(), "K5255 K5255");
    EXPECT_EQ(ran.messages[0].arguments[0], "retract level");
    EXPECT_EQ(ran.messages[1].arguments[0], "depth");
    EXPECT_EQ(holes(cycles), "1: 0 to -12, 2: 5 to 0");
}

TEST(Cycles, WordsAreModalAmongCycles) {
    // drill_peck(to, peck, …, dwell): its stroke is said by another cycle's block, without a sign.
    constexpr nc::CycleId kPeck = 1;
    Drill cycles;
    const auto peck = [] { return Words().cycle(kPeck, 5, {}); };
    const Ran ran = run({rapid().z(20), drill({{kTo, -12}, {kRetract, 2}}).x(1).f(100), peck().x(2),
                         fn(Function::CycleWords, {{0, -3}, {1, 0.5}}), Words().x(3),
                         fn(Function::CycleWords, {{0, -3}, {1, 0.5}}).x(4), drill({}).x(5)},
                        {.rules = kModal, .cycles = &cycles});
    EXPECT_EQ(ran.codes(), "");
    ASSERT_EQ(cycles.calls.size(), 5u);
    EXPECT_EQ(cycles.names[1], "drill_peck");
    EXPECT_EQ(cycles.arguments[1][1], 14) << "no stroke was said: the whole way";
    EXPECT_EQ(cycles.arguments[2][1], 14) << "a block that does not drill keeps nothing";
    EXPECT_EQ(cycles.arguments[3][1], 3);
    EXPECT_EQ(cycles.arguments[3][4], 0.5);
    EXPECT_EQ(cycles.arguments[4][kDwell], 0.5);
    EXPECT_EQ(cycles.arguments[4][kTo], -12);
}

TEST(Cycles, WhatTheCodeSaysByItselfIsNotForOthers) {
    Drill cycles;
    Block without_dwell = drill({{kTo, -12}, {kRetract, 2}, {kDwell, 0}}).x(1).f(100);
    without_dwell.cycle_by_form = 1u << kDwell;  // G81
    const Ran ran = run(
        {rapid().z(20), without_dwell, fn(Function::CycleWords, {{1, 0.25}}).x(2), drill({}).x(3)},
        {.rules = kModal, .cycles = &cycles});
    ASSERT_EQ(cycles.calls.size(), 3u);
    EXPECT_EQ(cycles.arguments[1][kDwell], 0);
    EXPECT_EQ(cycles.arguments[2][kDwell], 0.25);
}

TEST(Cycles, AMotionCodeInTheSameBlock) {
    // fanuc.md 5.1: the code that stands last.
    Drill cycles;
    Block drills = drill({{kTo, -12}, {kRetract, 2}}).x(1).f(100);
    drills.motion = Function::Rapid;
    const Block moves = Words(drill({{kTo, -12}, {kRetract, 2}}).x(2)).fn(Function::CycleOff);
    Block only_moves = moves;
    only_moves.motion = Function::Rapid;
    const Ran ran = run({rapid().z(20), drills, only_moves, Words().x(3)},
                        {.rules = kModal, .cycles = &cycles});
    EXPECT_EQ(ran.codes(), "K5254 K5254");
    EXPECT_EQ(cycles.calls.size(), 1u);
    EXPECT_EQ(end_of(ran), "3.0000 0.0000 -12.0000");
}

TEST(Cycles, ADefinitionThatRefusesItsParametersIsAnAlarm) {
    Drill cycles;
    cycles.refused = "the first stroke is too deep";
    const std::string rules =
        std::string("<alarm for=\"CycleRefused\" about=\"first stroke\" number=\"61107\"/>") +
        "<alarm for=\"CycleRefused\" number=\"61000\"/>";
    const Ran ran = run({rapid().z(20), drill({{kTo, -12}}).f(100), Words().x(1)},
                        {.rules = rules, .cycles = &cycles});
    EXPECT_EQ(ran.codes(), "K5253");
    EXPECT_TRUE(ran.alarmed);
    EXPECT_EQ(ran.messages[0].alarm_number, "61107");
    EXPECT_EQ(ran.messages[0].message(), "the first stroke is too deep");
    EXPECT_EQ(ran.messages[0].line->line, 2u);
    cycles.refused = "another";
    EXPECT_EQ(run({drill({{kTo, -12}}).f(100)}, {.rules = rules, .cycles = &cycles})
                  .messages.at(0)
                  .alarm_number,
              "61000");
    cycles.fails = true;
    EXPECT_EQ(run({drill({{kTo, -12}}).f(100)}, {.cycles = &cycles}).codes(), "K5253");
}

TEST(Cycles, ADwellBelowZeroCountsTurns) {
    const std::string_view rules = "<rule name=\"negative_dwell_turns\" value=\"yes\"/>";
    Drill cycles;
    const Ran ran =
        run({drill({{kTo, -12}, {kDwell, -5}}).f(100)}, {.rules = rules, .cycles = &cycles});
    EXPECT_EQ(ran.codes(), "");
    EXPECT_NEAR(cycles.arguments.at(0)[kDwell], 0.3, 1e-12) << "5 turns at 1000 rpm";
    const Ran stands = run({drill({{kTo, -12}, {kDwell, -5}}).f(100)},
                           {.rules = rules, .cycles = &cycles, .spindle_runs = false});
    EXPECT_EQ(stands.codes(), "K5218");
}

TEST(Cycles, NothingMovesBetweenTheRigidCodeAndTheTap) {
    Drill cycles;
    EXPECT_EQ(run({fn(Function::TapRigid), Words().x(5)}, {.cycles = &cycles}).codes(), "K5246");
    EXPECT_EQ(run({fn(Function::TapRigid), rapid().x(5)}, {.cycles = &cycles}).codes(), "K5246");
    EXPECT_EQ(run({fn(Function::TapRigid), drill({{kTo, -1}, {kRetract, 2}}).x(5).f(1),
                   Words().x(6), rapid().x(7)},
                  {.rules = kModal, .cycles = &cycles})
                  .codes(),
              "");
}

TEST(Cycles, NoPositionIsSetWhileOneIsActive) {
    Drill cycles;
    const Block set = fn(Function::SetPosition, {{0, 1}});
    EXPECT_EQ(
        run({drill({{kTo, -1}, {kRetract, 2}}).f(1), set}, {.rules = kModal, .cycles = &cycles})
            .codes(),
        "K5238");
    EXPECT_EQ(run({drill({{kTo, -1}, {kRetract, 2}}).f(1), fn(Function::CycleOff), set},
                  {.rules = kModal, .cycles = &cycles})
                  .codes(),
              "");
}

TEST(Cycles, ACycleBehindEveryMotion) {
    // sinumerik.md 14.15: MCALL after each block with path motion.
    Drill cycles;
    const Block modal =
        Words(drill({{kTo, -12}, {kRetract, 2}, {kInitial, 20}})).fn(Function::CycleModal);
    const Ran ran = run({rapid().z(20), modal, Words().x(10).f(100), fn(Function::CoolantFlood),
                         Words().x(20), fn(Function::CycleModal), Words().x(30)},
                        {.cycles = &cycles});
    EXPECT_EQ(ran.codes(), "");
    EXPECT_EQ(holes(cycles), "10: 2 to -12, 20: 2 to -12");
    EXPECT_EQ(end_of(ran), "30.0000 0.0000 20.0000");
    EXPECT_EQ(ran.commands.at(2).line, 3u) << "the place is the motion's";
}

}  // namespace
}  // namespace kadr::interp::cycles_test
