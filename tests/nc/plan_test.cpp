// Words of source blocks, in the input dialect iso.
#include <gtest/gtest.h>

#include "tests/nc/nc_testing.h"

namespace kadr::nc::plan_test {
namespace {

using testing::source_block;
using testing::source_word;

TEST(Plan, WordsBecomeBlocks) {
    struct Row {
        const char* words;
        const char* block;
    };
    for (const Row& row : {
             Row{"G1 X10 Y-5 F200", "line X10 Y-5 F200"},
             {"X10", "X10"},
             {"G2 X0 Y20 I=AC(0) J=AC(0)", "arc_cw X0 Y20 I=AC(0) J=AC(0)"},
             {"X=IC(5) Y=AC(3)", "X=IC(5) Y=AC(3)"},
             {"G3 X0 Y20 CR=-20 TURN=2", "arc_ccw X0 Y20 R-20 TURN=2"},
             {"G4 P0.5", "dwell(time=0.5)"},
             {"G4 S3", "dwell(revolutions=3)"},
             {"G43 H3 Z50", "Z50 | length_comp_on(offset=3)"},
             {"G43", "length_comp_on"},
             {"G54", "work_offset(number=1)"},
             {"G54.1 P2", "work_offset(number=8)"},
             {"T3 M6", "tool_select(tool=3) | tool_change"},
             {"TRANS X60 Y40", "shift(x=60, y=40)"},
             {"TRANS", "shift"},
             {"ROT RPL=30", "rotate(angle=30)"},
             {"MIRROR X0", "mirror(x=0)"},
             {"G92 S3000", "speed_limit(limit=3000)"},
             {"G92 X0 Z5", "set_position(x=0, z=5)"},
             {"LIMS=3000", "speed_limit(limit=3000)"},
             {"S2400 M3", "S2400 | spindle_cw"},
             {"N10 G1 X1", "N10 line X1"},
             {"G17 G21 G40 G90 G94",
              "plane_xy | metric | radius_comp_off | absolute | feed_per_minute"},
         }) {
        EXPECT_EQ(describe(source_block(testing::shipped("iso"), row.words)), row.block)
            << row.words;
    }
}

TEST(Plan, MistakesAreReportedAtTheWord) {
    struct Row {
        const char* words;
        const char* codes;
        std::size_t word;
    };
    for (const Row& row : {
             Row{"G1 Q10", "K4101", 1},
             {"G101 X10", "K4102", 0},
             {"G1 X Y5", "K4103", 1},
             {"G1 X10 X20", "K4105", 2},
             {"G0 G1 X10", "K4106", 1},
             {"G4", "K4107", 0},
             {"G1 X10 P3", "K4108", 2},
             {"G4 P1 S3", "K4109", 2},
             {"G1 F=IC(100)", "K4110", 1},
             {"G54.1 P600", "K4111", 1},
             {"G4 P1 X10", "K4112", 0},
             {"MIRROR X5", "K4111", 1},
         }) {
        SCOPED_TRACE(row.words);
        std::vector<SourceWord> words;
        std::string_view rest = row.words;
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find(' '), rest.size());
            words.push_back(source_word(rest.substr(0, end)));
            const auto index = static_cast<std::uint32_t>(words.size() - 1);
            words.back().range = {FileId{0}, index, index + 1};
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        DiagnosticList sink;
        EXPECT_FALSE(plan_block(testing::shipped("iso"), words, sink).has_value());
        ASSERT_EQ(testing::codes(sink), row.codes);
        EXPECT_EQ(sink.all()[0].range.begin, row.word);
    }
}

TEST(Plan, ComputedValuesLeaveHoles) {
    SourceWord x = source_word("X");
    x.value = SourceWord::Value::Computed;
    SourceWord g = source_word("G1");
    SourceWord offset = source_word("G54.1");
    SourceWord p = x;
    p.address = "P";
    DiagnosticList sink;
    const std::vector<SourceWord> line = {g, x};
    const auto plan = plan_block(testing::shipped("iso"), line, sink);
    ASSERT_TRUE(plan);
    ASSERT_EQ(plan->holes.size(), 1u);
    EXPECT_EQ(plan->holes[0].word, 1);
    EXPECT_FALSE(plan->holes[0].is_argument);
    EXPECT_EQ(plan->holes[0].dimension, Dimension::Length);

    const std::vector<SourceWord> select = {offset, p};
    const auto offsets = plan_block(testing::shipped("iso"), select, sink);
    ASSERT_TRUE(offsets);
    ASSERT_EQ(offsets->holes.size(), 1u);
    EXPECT_TRUE(offsets->holes[0].is_argument);
    EXPECT_EQ(offsets->holes[0].offset, 6);

    SourceWord computed_code = g;
    computed_code.value = SourceWord::Value::Computed;
    const std::vector<SourceWord> wrong = {computed_code};
    EXPECT_FALSE(plan_block(testing::shipped("iso"), wrong, sink));
    EXPECT_EQ(testing::codes(sink), "K4104");
}

TEST(Plan, BlocksHaveALimitOfWords) {
    std::vector<SourceWord> words(70, source_word("M8"));
    DiagnosticList sink;
    EXPECT_FALSE(plan_block(testing::shipped("iso"), words, sink));
    EXPECT_EQ(testing::codes(sink), "K4113");
}

// What a call of the control says, and where its arguments belong.
TEST(Plan, CallsOfTheControl) {
    using Kind = SourceArgument::Kind;
    const Dialect& sinumerik = testing::shipped("sinumerik");
    DiagnosticList sink;
    const SourceArgument nothing;
    const SourceArgument computed{Kind::Computed, 0, {}};
    const auto number = [](double value) { return SourceArgument{Kind::Number, value, {}}; };

    const std::vector<SourceArgument> drill = {number(50), number(1), computed, number(-10)};
    const auto plan = plan_call(sinumerik, "CYCLE81", {}, drill, sink);
    ASSERT_TRUE(plan);
    EXPECT_EQ(sinumerik.cycles()[plan->block.cycle].name, "drill");
    ASSERT_EQ(plan->holes.size(), 4u);
    EXPECT_EQ(plan->holes[1].parameter, plan->holes[2].parameter);  // RFP and SDIS: both retract
    EXPECT_FALSE(plan->holes[1].adds);
    EXPECT_TRUE(plan->holes[2].adds);

    // The sign of the pitch is the hand; the cycle of the call takes it as it is, computed, too.
    std::vector<SourceArgument> tap = {number(50),    number(2), nothing,    number(-10),
                                       nothing,       number(0), number(5),  nothing,
                                       number(-1.25), number(0), number(500)};
    const auto left = plan_call(sinumerik, "CYCLE84", {}, tap, sink);
    ASSERT_TRUE(left);
    EXPECT_EQ(left->holes.back().factor, 1);
    EXPECT_TRUE(sink.all().empty());
    tap[8] = computed;
    EXPECT_TRUE(plan_call(sinumerik, "CYCLE84", {}, tap, sink));
    EXPECT_TRUE(sink.all().empty());
    const std::vector<SourceArgument> unheard(40, number(1));
    EXPECT_FALSE(plan_call(sinumerik, "CYCLE84", {}, unheard, sink));
    EXPECT_EQ(testing::codes(sink), "K4111");

    DiagnosticList too_many;
    const std::vector<SourceArgument> endless(80, number(0));
    EXPECT_FALSE(plan_call(sinumerik, "CYCLE81", {}, endless, too_many));
    EXPECT_EQ(testing::codes(too_many), "K4113");
}

/// Safety lines end polar coordinates, which no source has.
TEST(Plan, PolarOffIsWithoutEffect) {
    EXPECT_EQ(describe(source_block(testing::shipped("fanuc"), "G15 G80")), "cycle_off");
}

TEST(Plan, CyclesOfWords) {
    const Dialect& fanuc = testing::shipped("fanuc");
    ASSERT_TRUE(cycle_of(fanuc, "G", 83));
    EXPECT_EQ(fanuc.cycles()[*cycle_of(fanuc, "G", 83)].name, "drill_peck");
    EXPECT_TRUE(can_be_source(fanuc, *cycle_of(fanuc, "G", 83)));
    EXPECT_FALSE(can_be_source(fanuc, *cycle_of(fanuc, "G", 76)));  // where it lifts is not said
    for (const double number : {1.0, 80.0, 777.0}) EXPECT_FALSE(cycle_of(fanuc, "G", number));
    EXPECT_FALSE(cycle_of(fanuc, "X", 83));
}

TEST(Plan, WordKinds) {
    const Dialect& iso = testing::shipped("iso");
    for (const char* name : {"X", "G", "M", "CR", "TURN", "LIMS", "N"})
        EXPECT_EQ(word_kind(iso, name), WordKind::Address) << name;
    for (const char* name : {"TRANS", "ATRANS", "ROT", "MIRROR"})
        EXPECT_EQ(word_kind(iso, name), WordKind::Word) << name;
    for (const char* name : {"x", "Q", "MCALL", "width", "cr"})
        EXPECT_EQ(word_kind(iso, name), WordKind::None) << name;
    EXPECT_EQ(word_kind(iso, "MSG"), WordKind::Call);
    EXPECT_EQ(word_kind(testing::shipped("sinumerik"), "CYCLE83"), WordKind::Call);
    EXPECT_EQ(word_kind(testing::shipped("sinumerik"), "MCALL"), WordKind::Word);
}

}  // namespace
}  // namespace kadr::nc::plan_test
