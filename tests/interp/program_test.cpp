// Spindle, tools, stops, skip levels, limits of a run, rules and alarms of a dialect.
#include "bench.h"
#include "nc/rules.h"

namespace kadr::interp::program_test {
namespace {

using path::Command;

constexpr std::string_view kAfter = "<rule name=\"stops_after_motion\" value=\"yes\"/>";
const Setup kQuiet{.spindle_runs = false};

/// The commands in short: `spindle rapid tool`.
std::string ops(const Ran& ran) {
    std::string out;
    for (const Command& command : ran.commands) {
        std::string line;
        Listing(mill()).append(command, {}, line);
        const std::string name = line.substr(7, line.find('"', 7) - 7);
        out += out.empty() ? name : " " + name;
    }
    return out;
}

TEST(Program, OrderInABlock) {
    const Block all = line()
                          .x(1)
                          .f(100)
                          .s(2000)
                          .fn(Function::SpindleCcw)
                          .fn(Function::ToolSelect, {{0, 2}})
                          .fn(Function::ToolChange)
                          .fn(Function::CoolantFlood)
                          .fn(Function::Stop);
    EXPECT_EQ(ops(run({all}, kQuiet)), "tool spindle coolant line stop");
    const Block stops = rapid().x(1).fn(Function::SpindleStop).fn(Function::CoolantOff);
    const Block mist = fn(Function::CoolantMist);
    EXPECT_EQ(ops(run({mist, stops})), "coolant spindle coolant rapid");
    EXPECT_EQ(ops(run({mist, stops}, {.rules = kAfter})), "coolant rapid spindle coolant");
}

TEST(Program, SpindleIsToldWhenItChanges) {
    const Ran ran =
        run({Words().s(500), fn(Function::SpindleCw), fn(Function::SpindleCw).s(500),
             Words().s(700), fn(Function::SpindleStop), fn(Function::SpindleStop),
             fn(Function::SpindleOrient, {{0, 90}}), fn(Function::SpindleOrient, {{1, -135}})},
            kQuiet);
    ASSERT_EQ(ran.listing(),
              "{\"op\":\"spindle\",\"mode\":\"cw\",\"speed\":500}\n"
              "{\"op\":\"spindle\",\"mode\":\"cw\",\"speed\":700}\n"
              "{\"op\":\"spindle\",\"mode\":\"stop\"}\n"
              "{\"op\":\"spindle\",\"mode\":\"orient\",\"angle\":90}\n"
              "{\"op\":\"spindle\",\"mode\":\"orient\",\"angle\":315}\n");
    EXPECT_EQ(run({fn(Function::SpindleCw)}, kQuiet).codes(), "K5217");
}

TEST(Program, CuttingSpeed) {
    const Block on = fn(Function::CuttingSpeedOn).s(180);
    EXPECT_EQ(run({rapid().x(20), fn(Function::SpeedLimit, {{0, 2500}}), on,
                   fn(Function::CuttingSpeedOff)})
                  .listing(),
              "{\"op\":\"rapid\",\"to\":{\"X\":20,\"Y\":0,\"Z\":0,\"C\":0},\"exact_stop\":true}\n"
              "{\"op\":\"speed_limit\",\"speed\":2500}\n"
              "{\"op\":\"spindle\",\"mode\":\"cw\",\"cutting_speed\":180}\n"
              // 1000·180/(π·40) = 1432.394487827 at the radius of 20
              "{\"op\":\"spindle\",\"mode\":\"cw\",\"speed\":1432.394487827}\n");
    EXPECT_EQ(run({fn(Function::CuttingSpeedOn)}).codes(), "K5215");
    EXPECT_EQ(run({fn(Function::SpeedLimit, {{0, 0}})}).codes(), "K5216");
    // In the centre the limit holds.
    EXPECT_EQ(run({fn(Function::SpeedLimit, {{0, 2500}}), on, fn(Function::CuttingSpeedOff)})
                  .commands.back()
                  .spindle()
                  .speed,
              2500);
}

TEST(Program, Dwell) {
    EXPECT_EQ(
        run({fn(Function::Dwell, {{0, 0.5}}), fn(Function::Dwell, {{1, 3}}), fn(Function::Dwell)})
            .listing(),
        "{\"op\":\"dwell\",\"time\":0.5}\n{\"op\":\"dwell\",\"revolutions\":3}\n");
    EXPECT_EQ(run({fn(Function::Dwell, {{0, -1}})}).codes(), "K5218");
    EXPECT_EQ(run({fn(Function::Dwell, {{1, 3}})}, kQuiet).codes(), "K5218");
}

TEST(Program, ToolChangeStopsTheSpindle) {
    const std::vector<Block> blocks = {fn(Function::Tool, {{0, 1}}), line().x(1).f(100)};
    const Ran ran = run(blocks);
    EXPECT_EQ(ops(ran), "tool spindle line");
    EXPECT_EQ(ran.codes(), "K5213") << "a cut with the spindle standing";
    const std::string_view kRunsOn = "<rule name=\"tool_change_stops_spindle\" value=\"no\"/>";
    EXPECT_EQ(ops(run(blocks, {.rules = kRunsOn})), "tool line");
    EXPECT_EQ(ops(run(blocks, kQuiet)), "tool line") << "it stood before";
}

TEST(Program, ToolLengthActsWithTheToolAxis) {
    const Block tool1 = fn(Function::Tool, {{0, 1}});
    const Block select2 = fn(Function::ToolSelect, {{0, 2}});
    const Block select3 = fn(Function::ToolSelect, {{0, 3}});
    const Block change = fn(Function::ToolChange);
    const Block edge = fn(Function::ToolEdge, {{0, 1}});
    const Block no_edge = fn(Function::ToolEdge, {{0, 0}});
    const Block g43 = rapid().fn(Function::LengthCompOn, {{0, 2}}).z(50);
    const Block g43_alone = fn(Function::LengthCompOn, {{0, 2}});
    const Block g49 = fn(Function::LengthCompOff);
    const std::string_view kAlone = "<rule name=\"length_moves_alone\" value=\"yes\"/>";
    const std::string_view kAuto = "<rule name=\"tool_change_activates_length\" value=\"yes\"/>";
    const std::string_view kSeparate = "<rule name=\"tool_change_activates_length\" value=\"no\"/>";
    const std::string_view kTurret = "<rule name=\"tool_select_changes\" value=\"yes\"/>";
    struct Row {
        const char* name;
        std::string_view rules;
        std::vector<Block> blocks;
        const char* ops;
    };
    for (const Row& row : std::initializer_list<Row>{
             {"with the first motion of Z",
              {},
              {tool1, rapid().x(1), rapid().z(1), rapid().z(2)},
              "tool rapid tool_length rapid rapid"},
             {"D before M6 is of the new tool",
              {},
              {select2, edge, change, rapid().z(1)},
              "tool tool_length rapid"},
             {"a change alone has no length",
              kSeparate,
              {select2, change, rapid().z(1)},
              "tool rapid"},
             {"… or it has", kAuto, {select2, change, rapid().z(1)}, "tool tool_length rapid"},
             {"the same tool again", {}, {select2, change, change, select2, change}, "tool"},
             {"equal lengths are no change",
              kAuto,
              {select2, change, rapid().z(1), select3, change, rapid().z(2)},
              "tool tool_length rapid tool rapid"},
             {"D0",
              {},
              {tool1, rapid().z(1), no_edge, rapid().z(2)},
              "tool tool_length rapid tool_length rapid"},
             {"G43 H2 Z50, G49 Z0",
              {},
              {g43, g49, rapid().z(0)},
              "tool_length rapid tool_length rapid"},
             {"G43 H2 alone waits for Z", {}, {g43_alone, rapid().z(1)}, "tool_length rapid"},
             {"… or moves at once",
              kAlone,
              {g43_alone, rapid().z(1), g49},
              "tool_length rapid rapid tool_length rapid"},
             {"another H while on",
              {},
              {g43, fn(Function::LengthOffset, {{0, 1}}), rapid().z(1)},
              "tool_length rapid tool_length rapid"},
             {"H while off", {}, {fn(Function::LengthOffset, {{0, 1}}), rapid().z(1)}, "rapid"},
             {"a turret", kTurret, {select2}, "tool"}}) {
        SCOPED_TRACE(row.name);
        EXPECT_EQ(ops(run(row.blocks, {.rules = row.rules, .spindle_runs = false})), row.ops);
    }
    const Ran ran = run({g43});
    EXPECT_EQ(ran.listing(),
              "{\"op\":\"tool_length\",\"tool\":2,\"length\":80}\n"
              "{\"op\":\"rapid\",\"to\":{\"X\":0,\"Y\":0,\"Z\":50,\"C\":0},\"exact_stop\":true}\n");
}

TEST(Program, ToolLengthFollowsThePlane) {
    // The length counts in limits along the axis where it acts: Y in the plane Z-X.
    const std::vector<Block> blocks = {fn(Function::PlaneZx), fn(Function::Tool, {{0, 1}}),
                                       rapid().y(950)};
    const Ran ran = run(blocks);
    EXPECT_EQ(ran.codes(), "K5231");
    EXPECT_EQ(ran.messages[0].message(), "axis Y would go to 1050, its limit is 1000");
    EXPECT_EQ(run(blocks, {.rules = "<rule name=\"length_axis\" value=\"z\"/>"}).codes(), "");
}

TEST(Program, ToolsOfTheTable) {
    const Ran unknown = run(
        {fn(Function::Tool, {{0, 99}}), rapid().z(1), fn(Function::Tool, {{0, 99}}), rapid().z(2)});
    EXPECT_EQ(unknown.codes(), "K5240") << "said once";
    machine::Machine bare = mill();
    bare.tools.clear();
    EXPECT_EQ(run({fn(Function::Tool, {{0, 99}}), rapid().z(1)}, {.machine = bare}).codes(), "");
    const Block named = Words().fn(Function::ToolSelect).fn(Function::ToolChange).text("DRILL_6");
    EXPECT_EQ(run({named}).commands.at(0).tool().number, 2);
    EXPECT_EQ(run({Words().fn(Function::ToolSelect).text("NO_SUCH")}).codes(), "K5240");
}

TEST(Program, Stops) {
    const std::vector<Block> blocks = {
        fn(Function::Stop), fn(Function::OptionalStop),
        Words().fn(Function::Message, {{0, 0}}).text("turn the part")};
    EXPECT_EQ(ops(run(blocks)), "stop message");
    EXPECT_EQ(ops(run(blocks, {.options = {.optional_stop = true}})), "stop optional_stop message");
    EXPECT_EQ(run(blocks).commands.at(1).message().text, "turn the part");
}

TEST(Program, NothingIsExecutedBehindTheEnd) {
    EXPECT_EQ(ops(run({rapid().x(1), fn(Function::End), rapid().x(2)}, {.ended = false})),
              "rapid end");
    const Ran open = run({rapid().x(1)}, {.ended = false});
    EXPECT_EQ(open.codes(), "K5260");
    EXPECT_FALSE(open.alarmed);
    const Ran alarm = run(
        {rapid().x(1)}, {.rules = "<rule name=\"missing_end\" value=\"alarm\"/>", .ended = false});
    EXPECT_EQ(alarm.codes(), "K5261");
    EXPECT_TRUE(alarm.alarmed);
}

TEST(Program, SkipLevels) {
    const std::vector<Block> blocks = {rapid().x(1).skip(0), rapid().x(2).skip(3), rapid().x(3)};
    EXPECT_EQ(run(blocks).commands.size(), 3u);
    EXPECT_EQ(run(blocks, {.options = {.skip_levels = 1u << 3}}).commands.size(), 2u);
}

TEST(Program, BlocksAreLimited) {
    const Ran ran = run({rapid().x(1), rapid().x(2), rapid().x(3)}, {.options = {.max_blocks = 3}});
    EXPECT_EQ(ran.codes(), "K5262");
    EXPECT_EQ(ran.blocks, 3u);
    EXPECT_EQ(ran.commands.size(), 2u) << "what came before is delivered";
}

TEST(Program, WhatIsNotExecutedYet) {
    EXPECT_EQ(run({fn(Function::RadiusCompOff)}).codes(), "");
    EXPECT_EQ(run({Words().kind(Block::Kind::Raw).text("M88")}).codes(), "K5252");
    EXPECT_EQ(run({Words().kind(Block::Kind::Comment), Words().kind(Block::Kind::Label)}).codes(),
              "");
}

TEST(Program, BatchesOfOneCommand) {
    const std::vector<Block> blocks = {line()
                                           .x(1)
                                           .f(100)
                                           .s(2000)
                                           .fn(Function::ToolSelect, {{0, 2}})
                                           .fn(Function::ToolChange)
                                           .fn(Function::Stop),
                                       rapid().x(2)};
    EXPECT_EQ(ops(run(blocks, {.batch = 1})), ops(run(blocks, {.batch = 100})));
}

TEST(Program, AlarmsHaveTheControlsNumber) {
    const Ran ran =
        run({line().x(1)},
            {.rules =
                 "<alarm for=\"FeedMissing\" number=\"10860\" text=\"feedrate not programmed\"/>"});
    ASSERT_EQ(ran.codes(), "K5210");
    EXPECT_EQ(ran.messages[0].alarm_number, "10860");
    EXPECT_EQ(ran.messages[0].alarm_text, "feedrate not programmed");
    ASSERT_TRUE(ran.messages[0].line);
    EXPECT_EQ(ran.messages[0].line->line, 1u);
}

TEST(Rules, EveryRuleCanBeSetAndRefusesNonsense) {
    nc::Rules rules;
    for (const nc::RuleInfo& info : nc::all_rules()) {
        SCOPED_TRACE(info.name);
        EXPECT_FALSE(info.meaning.empty());
        EXPECT_FALSE(info.source.empty());
        const std::string values(info.values);
        const std::size_t second = values.find(", ");
        const std::string value =
            second == values.npos
                ? "1"
                : values.substr(second + 2, values.find(',', second + 2) - second - 2);
        const std::optional<nc::Rule> rule = nc::rule_named(info.name);
        ASSERT_TRUE(rule.has_value());
        EXPECT_TRUE(set_rule(rules, *rule, value));
        EXPECT_FALSE(set_rule(rules, *rule, "nonsense"));
        EXPECT_FALSE(set_rule(rules, *rule, ""));
    }
    EXPECT_TRUE(set_rule(rules, nc::Rule::arc_error, "shift_center"));
    EXPECT_EQ(rules.arc_error, nc::ArcError::ShiftCenter);
    EXPECT_FALSE(set_rule(rules, nc::Rule::work_offsets, "1.5"));
    EXPECT_FALSE(nc::rule_named("no_such_rule").has_value());
}

}  // namespace
}  // namespace kadr::interp::program_test
