// Positions, lines, arcs and limits.
#include <numbers>

#include "base/diagnostics/iso.h"
#include "bench.h"
#include "path/arc.h"

namespace kadr::interp::motion_test {
namespace {

using path::Command;
using path::Op;

/// Near enough: what four decimals cannot show.
constexpr double kSame = 1e-9;

TEST(Motion, PositionWords) {
    // SINUMERIK, reference 15.1
    const Ran ran = run({line().x(10).y(10).f(500), Words().ic(Slot::X, 5),
                         fn(Function::Incremental).x(5).ac(Slot::Y, 0), Words().x(-2.5),
                         fn(Function::Absolute).x(6).y(5)});
    ASSERT_EQ(ran.commands.size(), 5u);
    const double expected[][2] = {{10, 10}, {15, 10}, {20, 0}, {17.5, 0}, {6, 5}};
    for (std::size_t i = 0; i < 5; ++i) {
        SCOPED_TRACE(i);
        EXPECT_EQ(ran.commands[i].op(), Op::Line);
        EXPECT_EQ(ran.commands[i].motion().feed, 500);
        EXPECT_EQ(ran.commands[i].motion().to[0], expected[i][0]);
        EXPECT_EQ(ran.commands[i].motion().to[1], expected[i][1]);
        EXPECT_EQ(ran.commands[i].line, i + 1);
    }
    EXPECT_EQ(ran.commands[1].motion().moved, bit(Axis::X));
    EXPECT_EQ(ran.codes(), "");
    EXPECT_EQ(ran.blocks, 7u);
}

TEST(Motion, PowerOnMotionIsTheDialects) {
    EXPECT_EQ(run({Words().x(10)}).commands.at(0).op(), Op::Rapid);
}

TEST(Motion, RapidNeedsNoFeed) {
    EXPECT_EQ(run({rapid().x(10)}).listing(),
              "{\"op\":\"rapid\",\"to\":{\"X\":10,\"Y\":0,\"Z\":0,\"C\":0},\"exact_stop\":true}\n");
}

TEST(Motion, Arcs) {
    // SINUMERIK 15.2: start 20,0; centre, end, sweep. FANUC 12: the rows from 0,0.
    struct Row {
        const char* name;
        Block start, arc;
        double center[3];
        double sweep_deg;
        bool is_clockwise;
    };
    const Block at20 = rapid().x(20).y(0);
    const Block at0 = rapid().x(0).y(0);
    for (const Row& row : std::initializer_list<Row>{
             {"G3 X0 Y20 I-20 J0", at20, ccw().x(0).y(20).i(-20).j(0), {0, 0, 0}, 90, false},
             {"G3 X0 Y20 CR=20", at20, ccw().x(0).y(20).r(20), {0, 0, 0}, 90, false},
             {"G3 X0 Y20 CR=-20", at20, ccw().x(0).y(20).r(-20), {20, 20, 0}, 270, false},
             {"G2 X0 Y20 CR=20", at20, cw().x(0).y(20).r(20), {20, 20, 0}, 90, true},
             {"G3 X0 Y20 I=AC(0) J=AC(0)",
              at20,
              ccw().x(0).y(20).ac(Slot::CenterX, 0).ac(Slot::CenterY, 0),
              {0, 0, 0},
              90,
              false},
             {"G3 I-20", at20, ccw().i(-20), {0, 0, 0}, 360, false},
             {"TURN=2", at20, ccw().x(0).y(20).i(-20).j(0).z(-9).turns(2), {0, 0, 0}, 810, false},
             {"G17G02X20.Y0R10.", at0, cw().x(20).y(0).r(10), {10, 0, 0}, 180, true},
             {"G17G03X20.Y0I10.J0", at0, ccw().x(20).y(0).i(10).j(0), {10, 0, 0}, 180, false},
             {"G17G03X0Y0I10.", at0, ccw().x(0).y(0).i(10), {10, 0, 0}, 360, false},
             {"G18G03X0Z20.I0K10.",
              at0,
              ccw().fn(Function::PlaneZx).x(0).z(20).i(0).k(10),
              {0, 0, 10},
              180,
              false}}) {
        SCOPED_TRACE(row.name);
        Block arc = row.arc;
        arc.set(Slot::Feed, 200);
        const Ran ran = run({row.start, arc});
        ASSERT_EQ(ran.codes(), "");
        ASSERT_EQ(ran.commands.size(), 2u);
        const Command& command = ran.commands[1];
        EXPECT_EQ(command.op(), Op::Arc);
        EXPECT_NEAR(command.motion().arc().center.x(), row.center[0], kSame);
        EXPECT_NEAR(command.motion().arc().center.y(), row.center[1], kSame);
        EXPECT_NEAR(command.motion().arc().center.z(), row.center[2], kSame);
        EXPECT_NEAR(command.motion().arc().sweep * 180 / std::numbers::pi, row.sweep_deg, 1e-9);
        EXPECT_EQ(command.motion().arc().is_clockwise, row.is_clockwise);
    }
}

TEST(Motion, ArcInTheZxPlanePassesMinusX) {
    // `G18G03X0Z20.I0K10.` from X0Z0: counter-clockwise in (Z, X), through X-10.
    const Ran ran =
        run({rapid().x(0).z(0), ccw().fn(Function::PlaneZx).x(0).z(20).i(0).k(10).f(200)});
    const Command& command = ran.commands.at(1);
    const path::Arc arc{{0, 0, 0},
                        {0, 0, 20},
                        command.motion().arc().center,
                        command.motion().arc().normal,
                        command.motion().arc().sweep};
    EXPECT_LT(
        (path::point_at(arc, command.motion().arc().sweep / 2).position - path::Vec3(-10, 0, 10))
            .norm(),
        kSame);
}

TEST(Motion, ArcErrors) {
    const std::string_view kFanuc =
        "<rule name=\"arc_radius_without_chord\" value=\"no_motion\"/>"
        "<rule name=\"arc_without_center\" value=\"line\"/>"
        "<rule name=\"arc_radius_wins\" value=\"yes\"/>";
    const std::string_view kSinumerik =
        "<rule name=\"arc_tolerance_factor\" value=\"0.001\"/>"
        "<rule name=\"arc_error\" value=\"shift_center\"/>";
    const Words quarter = ccw().x(0).y(20).f(200);
    struct Row {
        const char* name;
        std::string_view rules;
        Block arc;
        const char* codes;
    };
    for (const Row& row : std::initializer_list<Row>{
             {"off the circle", {}, ccw().x(0).y(20.05).i(-20).f(200), "K5220"},
             {"off the circle, with factor", kSinumerik, ccw().x(0).y(20.05).i(-20).f(200),
              "K5220"},
             {"within the factor", kSinumerik, ccw().x(0).y(20.015).i(-20).f(200), ""},
             {"beyond the constant", "<rule name=\"arc_tolerance_factor\" value=\"0\"/>",
              ccw().x(0).y(20.015).i(-20).f(200), "K5220"},
             {"radius too small", {}, ccw().x(0).y(20).r(14).f(200), "K5221"},
             {"radius, no chord", {}, ccw().x(20).y(0).r(14).f(200), "K5222"},
             {"radius, no chord, no motion", kFanuc, ccw().x(20).y(0).r(14).f(200), ""},
             {"no centre", {}, quarter, "K5223"},
             {"no centre: a line", kFanuc, quarter, "K5909"},
             {"centre at the start", {}, ccw().x(0).y(20).i(0).j(0).f(200), "K5220"},
             {"full circle about its start", {}, ccw().i(0).j(0).f(200), "K5223"},
             {"negative turns", {}, ccw().i(-20).turns(-1).f(200), "K5224"},
             {"half a turn", {}, ccw().i(-20).turns(0.5).f(200), "K5224"},
             {"centre and radius", {}, ccw().x(0).y(20).r(20).i(-20).f(200), "K5225"},
             {"centre across the plane", {}, ccw().x(0).y(20).i(-20).k(5).f(200), "K5228"},
             {"radius wins", kFanuc, ccw().x(0).y(20).r(20).i(-7).f(200), ""},
             {"centre in a line", {}, line().x(0).y(20).i(-20).f(200), "K5226"},
             {"turns alone", {}, line().turns(2), "K5226"},
             {"machine coordinates",
              {},
              ccw().fn(Function::MachineCoordinates).x(0).i(9).f(200),
              "K5227"}}) {
        SCOPED_TRACE(row.name);
        EXPECT_EQ(run({rapid().x(20).y(0), row.arc}, {.rules = row.rules}).codes(), row.codes);
    }
}

TEST(Motion, ShiftedCentreKeepsTheStartRadius) {
    // SINUMERIK 15.2: `G3 X0 Y20.01 I-20 J0` from 20,0; centre about 0,0.01
    const Ran ran = run({rapid().x(20).y(0), ccw().x(0).y(20.01).i(-20).j(0).f(200)},
                        {.rules = "<rule name=\"arc_error\" value=\"shift_center\"/>"});
    ASSERT_EQ(ran.codes(), "");
    EXPECT_NEAR(ran.commands[1].motion().arc().center.y(), 0.01, 1e-4);
    EXPECT_NEAR((ran.commands[1].motion().arc().center - path::Vec3(20, 0, 0)).norm(), 20, kSame);
}

TEST(Motion, DiametersOfALathe) {
    machine::Machine lathe = mill();
    lathe.is_lathe = true;
    // X58 is a radius of 29; I stays a radius.
    const Ran ran = run({rapid().x(58).z(2), line().ic(Slot::X, 4).f(100),
                         cw().fn(Function::PlaneZx).x(82).i(5).k(0).f(100)},
                        {.machine = lathe});
    ASSERT_EQ(ran.codes(), "");
    EXPECT_EQ(ran.commands[0].motion().to[0], 29);
    EXPECT_EQ(ran.commands[1].motion().to[0], 31);
    EXPECT_EQ(ran.commands[2].motion().to[0], 41);
    EXPECT_NEAR(ran.commands[2].motion().arc().center.x(), 36, kSame);
}

TEST(Motion, Feed) {
    const std::string_view kForgets = "<rule name=\"feed_deleted_on_mode_change\" value=\"yes\"/>";
    const std::string_view kEvery =
        "<rule name=\"inverse_time_feed_in_every_block\" value=\"yes\"/>";
    const Block per_revolution = fn(Function::FeedPerRevolution);
    const Block inverse = fn(Function::FeedInverseTime);
    struct Row {
        const char* name;
        std::string_view rules;
        std::vector<Block> blocks;
        const char* codes;
    };
    for (const Row& row : std::initializer_list<Row>{
             {"missing", {}, {line().x(1)}, "K5210"},
             {"missing in an arc", {}, {ccw().i(1)}, "K5210"},
             {"alone, before", {}, {Words().f(100), line().x(1)}, ""},
             {"zero", {}, {line().x(1).f(0)}, "K5211"},
             {"zero before", {}, {Words().f(0), line().x(1)}, "K5211"},
             {"kept", {}, {line().x(1).f(100), per_revolution, line().x(2)}, "K5970"},
             {"forgotten", kForgets, {line().x(1).f(100), per_revolution, line().x(2)}, "K5210"},
             {"same kind again",
              kForgets,
              {line().x(1).f(100), fn(Function::FeedPerMinute), line().x(2)},
              ""},
             {"said with the change",
              kForgets,
              {line().x(1).f(100), line().fn(Function::FeedPerRevolution).x(2).f(0.1)},
              ""},
             {"inverse time", {}, {inverse, line().x(1).f(2), Words().x(2)}, ""},
             {"inverse time in every block",
              kEvery,
              {inverse, line().x(1).f(2), Words().x(2)},
              "K5212"},
             {"per revolution, stopped",
              {},
              {fn(Function::SpindleStop), per_revolution, line().x(1).f(0.1)},
              "K5214"},
             {"stopped, said once",
              {},
              {fn(Function::SpindleStop), line().x(1).f(100), Words().x(2)},
              "K5213"}}) {
        SCOPED_TRACE(row.name);
        const Ran ran = run(row.blocks, {.rules = row.rules});
        EXPECT_EQ(ran.codes(), row.codes);
        const bool is_alarm = *row.codes != 0 && std::string_view(row.codes) != "K5213" &&
                              std::string_view(row.codes) != "K5970";
        EXPECT_EQ(ran.alarmed, is_alarm);
    }
}

TEST(Motion, InverseTimeOfAnArcByRadius) {
    // F = feed/radius: a quarter turn takes (π/2)/F minutes, so as 1/time it is F/(π/2).
    const Ran ran =
        run({rapid().x(20).y(0), fn(Function::FeedInverseTime), ccw().x(0).y(20).i(-20).f(3)},
            {.rules = "<rule name=\"inverse_time_arc_by_radius\" value=\"yes\"/>"});
    EXPECT_NEAR(ran.commands.at(1).motion().feed, 3 / (std::numbers::pi / 2), kSame);
}

TEST(Motion, LimitsOfTheMachine) {
    struct Row {
        const char* name;
        std::vector<Block> blocks;
        const char* message;
    };
    const Block offset = fn(Function::WorkOffset, {{0, 1}});
    for (const Row& row : std::initializer_list<Row>{
             {"end point", {rapid().x(1001)}, "axis X would go to 1001, its limit is 1000"},
             {"lower", {rapid().y(-1000.5)}, "axis Y would go to -1000.5, its limit is -1000"},
             {"offset counts",
              {offset, rapid().x(-701)},
              "axis X would go to -1001, its limit is -1000"},
             {"rotary",
              {rapid().set(Slot::C, 500)},
              "axis C would go to 500, its limit is 401.070457"},
             {"top of an arc",
              {rapid().x(990).y(0), cw().x(990).y(-40).i(0).j(-20).f(100)},
              "axis X would go to 1010, its limit is 1000"},
             {"the arc turns away",
              {rapid().x(990).y(0), ccw().x(990).y(-40).i(0).j(-20).f(100)},
              nullptr},
             {"missing axis", {rapid().set(Slot::A, 10)}, "the machine has no axis A"}}) {
        SCOPED_TRACE(row.name);
        const Ran ran = run(row.blocks);
        ASSERT_EQ(ran.messages.size(), row.message == nullptr ? 0u : 1u);
        if (row.message == nullptr) continue;
        EXPECT_EQ(ran.messages[0].message(), row.message);
        EXPECT_TRUE(ran.messages[0].row == &diag::AxisLimit ||
                    ran.messages[0].row == &diag::AxisMissing);
        EXPECT_TRUE(ran.alarmed);
    }
}

TEST(Motion, ExactStop) {
    const Ran ran = run({fn(Function::ContinuousPath), line().x(1).f(100),
                         Words().fn(Function::ExactStopOnce).x(2), Words().x(3),
                         fn(Function::ExactStop), Words().x(4)});
    const bool expected[] = {false, true, false, true};
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(ran.commands.at(i).motion().exact_stop, expected[i]) << i;
}

}  // namespace
}  // namespace kadr::interp::motion_test
