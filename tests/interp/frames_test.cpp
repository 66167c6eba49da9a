// Work offsets, programmable frames, machine coordinates, set position.
#include "bench.h"

namespace kadr::interp::frames_test {
namespace {

using path::Command;
using path::Op;

constexpr std::string_view kTraversed = "<rule name=\"incremental_frame\" value=\"traversed\"/>";
constexpr std::string_view kPerAxis = "<rule name=\"shift_keeps_unnamed\" value=\"yes\"/>";

Block shift(double x, double y) { return fn(Function::Shift, {{0, x}, {1, y}}); }
Block shift_x(double x) { return fn(Function::Shift, {{0, x}}); }
Block shift_off() { return fn(Function::Shift); }
Block shift_add(double x, double y) { return fn(Function::ShiftAdd, {{0, x}, {1, y}}); }
Block rotate(double angle) { return fn(Function::Rotate, {{0, angle}}); }
Block mirror_x(double at = 0) { return fn(Function::Mirror, {{0, at}}); }
Block work_offset(double number) { return fn(Function::WorkOffset, {{0, number}}); }
Block incremental() { return fn(Function::Incremental); }

TEST(Frames, PointsInTheBaseSystem) {
    struct Row {
        const char* name;
        std::string_view rules;
        std::vector<Block> blocks;
        const char* end;
    };
    for (const Row& row : std::initializer_list<Row>{
             // SINUMERIK 15.4
             {"TRANS X40 Y25, AROT RPL=30: 10·cos 30 + 40",
              {},
              {shift(40, 25), rotate(30), rapid().x(10).y(0)},
              "48.6603 30.0000 0.0000"},
             {"MIRROR X0", {}, {mirror_x(), rapid().x(5).y(3)}, "-5.0000 3.0000 0.0000"},
             {"TRANS X10, AROT 90, ATRANS X5",
              {},
              {shift_x(10), rotate(90), shift_add(5, 0), rapid().x(1).y(0)},
              "10.0000 6.0000 0.0000"},
             {"a shift replaces the rotation",
              {},
              {rotate(90), shift_x(10), rapid().x(5).y(0)},
              "15.0000 0.0000 0.0000"},
             {"… and the other axes",
              {},
              {shift(1, 2), shift_x(10), rapid().x(0).y(0)},
              "10.0000 0.0000 0.0000"},
             {"… or not",
              kPerAxis,
              {shift(1, 2), shift_x(10), rapid().x(0).y(0)},
              "10.0000 2.0000 0.0000"},
             {"a shift by axis keeps the rotation",
              kPerAxis,
              {rotate(90), shift_x(10), rapid().x(5).y(0)},
              "10.0000 5.0000 0.0000"},
             {"shift without words deletes all",
              {},
              {shift(1, 2), rotate(90), shift_off(), rapid().x(5).y(0)},
              "5.0000 0.0000 0.0000"},
             {"rotation off",
              {},
              {shift(1, 2), rotate(90), fn(Function::RotateOff), rapid().x(5).y(0)},
              "6.0000 2.0000 0.0000"},
             {"mirror off",
              {},
              {mirror_x(), rotate(90), fn(Function::MirrorOff), rapid().x(5).y(0)},
              "0.0000 5.0000 0.0000"},
             // FANUC 3.7: G51.1 X10. mirrors about X 10; a second one takes its place
             {"mirror about a coordinate",
              {},
              {mirror_x(10), rapid().x(4).y(3)},
              "16.0000 3.0000 0.0000"},
             {"mirrors add",
              {},
              {mirror_x(10), mirror_x(15), rapid().x(4).y(3)},
              "-6.0000 3.0000 0.0000"},
             {"a mirror replaces that of its axis",
              "<rule name=\"mirror_replaces\" value=\"yes\"/>",
              {mirror_x(10), fn(Function::Mirror, {{1, 1}}), mirror_x(15), rapid().x(4).y(3)},
              "26.0000 -1.0000 0.0000"},
             {"… and its end the place too",
              {},
              {mirror_x(10), fn(Function::MirrorOff, {{0, 0}}), rapid().x(4).y(3)},
              "4.0000 3.0000 0.0000"},
             {"rotations add",
              {},
              {rotate(60), rotate(30), rapid().x(5).y(0)},
              "0.0000 5.0000 0.0000"},
             {"a rotation replaces",
              "<rule name=\"rotate_replaces\" value=\"yes\"/>",
              {rotate(60), rotate(90), rapid().x(5).y(0)},
              "0.0000 5.0000 0.0000"},
             // FANUC 12: one plane axis mirrored turns the rotation round
             {"G51.1, then G68 R90: (10,0) → (-10,0) → by -90",
              {},
              {mirror_x(), rotate(90), rapid().x(10).y(0)},
              "0.0000 10.0000 0.0000"},
             // Only programmed axes go to the new frame.
             {"TRANS Z is not travelled",
              {},
              {rapid().x(1).y(1).z(1), fn(Function::Shift, {{2, 10}}), rapid().x(2)},
              "2.0000 1.0000 1.0000"},
             {"work offset",
              {},
              {work_offset(1), rapid().x(1).y(1).z(1)},
              "-299.0000 21.0000 6.0000"},
             {"work offset and shift",
              {},
              {work_offset(1), shift(5, 5), rapid().x(1).y(1)},
              "-294.0000 26.0000 0.0000"},
             {"no work offset",
              {},
              {work_offset(1), work_offset(0), rapid().x(1).y(1)},
              "1.0000 1.0000 0.0000"},
             {"one that the machine does not name",
              {},
              {work_offset(1), work_offset(9), rapid().x(1).y(1)},
              "1.0000 1.0000 0.0000"},
             {"at power-on",
              "<rule name=\"default_work_offset\" value=\"1\"/>",
              {rapid().x(0)},
              "-300.0000 0.0000 0.0000"}}) {
        SCOPED_TRACE(row.name);
        const Ran ran = run(row.blocks, {.rules = row.rules});
        EXPECT_EQ(ran.codes(), "");
        EXPECT_EQ(end_of(ran), row.end);
    }
}

TEST(Frames, ARotationIsInnermost) {
    // FANUC 3.7: mirror, scaling, rotation, cancelled the other way round; inside a rotation
    // neither G52 to G59, G92 nor another plane.
    constexpr std::string_view kInnermost = "<rule name=\"rotation_is_innermost\" value=\"yes\"/>";
    const std::vector<Block> forbidden = {mirror_x(),
                                          fn(Function::MirrorOff),
                                          work_offset(2),
                                          shift_x(5),
                                          shift_add(1, 1),
                                          fn(Function::PlaneZx),
                                          fn(Function::SetPosition, {{0, 5}})};
    for (const Block& block : forbidden) {
        SCOPED_TRACE(describe(block));
        const Ran inside = run({rotate(30), block}, {.rules = kInnermost});
        EXPECT_EQ(inside.codes(), "K5234");
        EXPECT_TRUE(inside.alarmed);
        EXPECT_EQ(run({rotate(30), fn(Function::RotateOff), block}, {.rules = kInnermost}).codes(),
                  "");
        EXPECT_EQ(run({rotate(30), block}).codes(), "");
    }
    EXPECT_EQ(run({mirror_x(), rotate(30), fn(Function::PlaneXy)}, {.rules = kInnermost}).codes(),
              "");
}

TEST(Frames, IncrementsAfterAChange) {
    struct Row {
        const char* name;
        std::string_view rules;
        std::vector<Block> blocks;
        const char* end;
    };
    for (const Row& row : std::initializer_list<Row>{
             // SINUMERIK 3.1: X1, TRANS X100, X=IC(1) → 102
             {"traversed",
              kTraversed,
              {rapid().x(1), shift_x(100), Words().ic(Slot::X, 1)},
              "102.0000 0.0000 0.0000"},
             {"distance",
              {},
              {rapid().x(1), shift_x(100), Words().ic(Slot::X, 1)},
              "2.0000 0.0000 0.0000"},
             {"traversed once",
              kTraversed,
              {rapid().x(1), shift_x(100), incremental(), Words().x(1), Words().x(1)},
              "103.0000 0.0000 0.0000"},
             // FANUC 12: an increment after G68 turns about the tool, not about the centre
             {"turned distance",
              {},
              {shift(10, 0), rotate(90), incremental(), rapid().x(20).y(0)},
              "0.0000 20.0000 0.0000"}}) {
        SCOPED_TRACE(row.name);
        EXPECT_EQ(end_of(run(row.blocks, {.rules = row.rules})), row.end);
    }
}

TEST(Frames, MirrorTurnsArcsRound) {
    // FANUC 12: `G51.1X0` + `G02` in XY executes as a counter-clockwise arc.
    const Ran ran = run({mirror_x(), rapid().x(10).y(0), cw().x(0).y(-10).i(-10).f(100)});
    const Command& arc = ran.commands.at(1);
    EXPECT_EQ(arc.op(), Op::Arc);
    EXPECT_FALSE(arc.motion().arc().is_clockwise);
    EXPECT_NEAR(arc.motion().arc().sweep, 1.5707963267948966, 1e-12);
    EXPECT_LT((arc.motion().arc().normal - path::Vec3(0, 0, 1)).norm(), 1e-12);
    EXPECT_LT(arc.motion().arc().center.norm(), 1e-12);
    EXPECT_EQ(end_of(ran), "0.0000 -10.0000 0.0000");
}

TEST(Frames, RotatedArcKeepsItsShape) {
    const Ran ran =
        run({shift(10, 20), rotate(90), rapid().x(5).y(0), ccw().x(0).y(5).i(-5).j(0).f(100)});
    const Command& arc = ran.commands.at(1);
    EXPECT_LT((arc.motion().arc().center - path::Vec3(10, 20, 0)).norm(), 1e-12);
    EXPECT_FALSE(arc.motion().arc().is_clockwise);
    EXPECT_EQ(end_of(ran), "5.0000 20.0000 0.0000");
}

TEST(Frames, SetPosition) {
    // FANUC 12: `G92X0` at work X=25, then `G55X0`: G55 is shifted too. G54 of this machine is at
    // -300, G55 at 10; the shift is 25.
    const Block here_is_zero = fn(Function::SetPosition, {{0, 0}});
    const Ran ran = run(
        {work_offset(1), rapid().x(25), here_is_zero, rapid().x(0), work_offset(2), rapid().x(0)});
    EXPECT_EQ(ran.commands.at(1).motion().to[0], -275);
    EXPECT_EQ(ran.commands.at(2).motion().to[0], 35);
    // Unnamed axes keep their coordinates.
    EXPECT_EQ(end_of(run({rapid().x(3).y(4), here_is_zero, rapid().x(1).y(1)})),
              "4.0000 1.0000 0.0000");
    // It ends the local shift of the axis.
    EXPECT_EQ(
        end_of(run({shift(7, 7), rapid().x(3).y(3), here_is_zero, shift_x(0), rapid().x(1).y(1)},
                   {.rules = kPerAxis})),
        "11.0000 8.0000 0.0000");
    // An increment behind it counts from the new coordinate.
    EXPECT_EQ(end_of(run({rapid().x(3), here_is_zero, incremental(), rapid().x(1)},
                         {.rules = kTraversed})),
              "4.0000 0.0000 0.0000");
}

TEST(Frames, DiametersInFrames) {
    machine::Machine lathe = mill();
    lathe.is_lathe = true;
    const std::vector<Block> blocks = {shift_x(10), rapid().x(20)};
    EXPECT_EQ(end_of(run(blocks, {.machine = lathe})), "20.0000 0.0000 0.0000");
    EXPECT_EQ(end_of(run(blocks, {.rules = "<rule name=\"shift_in_diameter\" value=\"yes\"/>",
                                  .machine = lathe})),
              "15.0000 0.0000 0.0000");
}

TEST(Frames, WorkOffsetUnknown) {
    const Ran ran = run({work_offset(400)});
    EXPECT_EQ(ran.codes(), "K5232");
    EXPECT_TRUE(ran.alarmed);
    EXPECT_EQ(
        run({work_offset(60)}, {.rules = "<rule name=\"work_offsets\" value=\"54\"/>"}).codes(),
        "K5232");
}

TEST(Frames, MachineCoordinates) {
    const Block g53 = rapid().fn(Function::MachineCoordinates).z(0);
    const Block g53_line = line().fn(Function::MachineCoordinates).z(0).f(100);
    const Block length_on = fn(Function::ToolEdge, {{0, 1}});
    const std::vector<Block> blocks = {fn(Function::Tool, {{0, 1}}), length_on, work_offset(1),
                                       rapid().x(0).z(50),           g53,       Words().x(1)};
    {
        SCOPED_TRACE("without the tool length: Z0 is the spindle nose, 100 above the tip");
        const Ran ran = run(blocks, {.spindle_runs = false});
        const Command& command = ran.commands.at(3);
        EXPECT_TRUE(command.motion().machine_coordinates);
        EXPECT_EQ(command.motion().to[2], 0);
        EXPECT_EQ(command.motion().to[0], -300);
        EXPECT_EQ(ran.commands.at(4).motion().to[2], -100);
        EXPECT_FALSE(ran.commands.at(4).motion().machine_coordinates);
        EXPECT_EQ(ran.commands.at(4).motion().to[0], -299) << "the frame is back";
    }
    {
        SCOPED_TRACE("with the tool length");
        const Ran ran =
            run(blocks, {.rules = "<rule name=\"machine_coordinates_keep_length\" value=\"yes\"/>",
                         .spindle_runs = false});
        EXPECT_FALSE(ran.commands.at(3).motion().machine_coordinates);
        EXPECT_EQ(ran.commands.at(3).motion().to[2], 0);
        EXPECT_EQ(ran.commands.at(4).motion().to[2], 0);
    }
    const std::string_view kRapid = "<rule name=\"machine_coordinates_rapid\" value=\"yes\"/>";
    const std::string_view kAbsolute =
        "<rule name=\"machine_coordinates_need_absolute\" value=\"yes\"/>";
    EXPECT_EQ(run({g53_line}).commands.at(0).op(), Op::Line);
    EXPECT_EQ(run({g53_line}, {.rules = kRapid}).commands.at(0).op(), Op::Rapid);
    EXPECT_EQ(end_of(run({rapid().z(30), incremental(), g53})), "0.0000 0.0000 30.0000");
    const Ran ignored = run({rapid().z(30), incremental(), g53}, {.rules = kAbsolute});
    EXPECT_EQ(ignored.codes(), "K5233");
    EXPECT_EQ(ignored.commands.size(), 1u);
    EXPECT_EQ(run({Words().fn(Function::MachineCoordinates).x(2000)}).codes(), "K5231");
}

}  // namespace
}  // namespace kadr::interp::frames_test
