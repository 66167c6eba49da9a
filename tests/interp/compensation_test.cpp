// Cutter radius compensation: texts of the controls, and where the cutter goes. Rules of the
// references: sinumerik.md 5.2 and 15.5, fanuc.md 4.3. Tool 1 has a radius of 5 mm, tool 2 of 3.
#include <cstdio>

#include "text_bench.h"

namespace kadr::interp::compensation_test {
namespace {

using nc::Function;
using path::Command;
using path::Op;

/// `L0,-5 A45,0` : lines, rapids, arcs (`A` clockwise, `C` counter-clockwise) with their ends in
/// the plane X-Y, a Z that changes as `/-2`, other commands by name.
std::string way_of(const Ran& ran) {
    std::string out;
    double height = 0;
    for (const Command& command : ran.commands) {
        const bool is_aside = command.op() == Op::Spindle || command.op() == Op::Tool ||
                              command.op() == Op::ToolLength || command.op() == Op::End;
        if (is_aside) continue;
        if (!out.empty()) out += ' ';
        if (!command.is_motion()) {
            out += command.op() == Op::Coolant ? "coolant" : "other";
            continue;
        }
        const bool is_arc = command.op() == Op::Arc;
        out += command.op() == Op::Rapid                       ? "R"
               : command.op() == Op::Line                      ? "L"
               : is_arc && command.motion().arc().is_clockwise ? "A"
                                                               : "C";
        char text[64];
        const auto rounded = [](double value) { return std::round(value * 1000) / 1000 + 0.0; };
        std::snprintf(text, sizeof text, "%g,%g", rounded(command.motion().to[0]),
                      rounded(command.motion().to[1]));
        out += text;
        if (command.motion().to[2] == height) continue;
        height = command.motion().to[2];
        std::snprintf(text, sizeof text, "/%g", height);
        out += text;
    }
    return out;
}

struct Row {
    const char* name;
    const char* text;
    const char* way;
    const char* alarms = "";
};

void check(std::string_view dialect, const std::string& start, const std::vector<Row>& rows) {
    for (const Row& row : rows) {
        SCOPED_TRACE(row.name);
        machine::Machine machine = mill();
        machine.work_offsets.clear();
        const Ran ran = read(dialect, start + row.text + "M30\n", machine);
        EXPECT_EQ(way_of(ran), row.way);
        EXPECT_EQ(alarms(ran), row.alarms);
    }
}

const std::string kSinumerik = "T1 D1 M6\nM3 S1000 F500\n";
const std::string kRectangle = "X40\nY30\nX0\nY0\nG40 X-20 Y-20\n";

TEST(Compensation, Sinumerik) {
    const std::string approach = "G0 X-20 Y-20\nG42 G1 X0 Y0\n";
    const std::string outside = approach + kRectangle;
    const std::string corners = "G0 X-20 Y-20\nG42 G1 G451 X0 Y0\n" + kRectangle;
    const std::string allowance = "OFFN=1\n" + outside;
    const std::string other_tool = "T2 D1 M6\nM3\n" + outside;
    const std::string inside = "G0 X20 Y15\nG41 G1 X0 Y0\n" + kRectangle;
    const std::string mirrored = "MIRROR X0\nG0 X-20 Y-20\nG42 G1 X0 Y0\nX10\nG40 X20 Y-9\n";
    check(
        "sinumerik", kSinumerik,
        {{"15.5 G42, G450", outside.c_str(),
          "R-20,-20 L0,-5 L40,-5 C45,0 L45,30 C40,35 L0,35 C-5,30 L-5,0 L-20,-20"},
         {"15.5 G451", corners.c_str(), "R-20,-20 L0,-5 L45,-5 L45,35 L-5,35 L-5,0 L-20,-20"},
         {"15.5 G41 inside", inside.c_str(), "R20,15 L0,5 L35,5 L35,25 L5,25 L5,0 L-20,-20"},
         {"15.5 OFFN", allowance.c_str(),
          "R-20,-20 L0,-6 L40,-6 C46,0 L46,30 C40,36 L0,36 C-6,30 L-6,0 L-20,-20"},
         {"another radius", other_tool.c_str(),
          "R-20,-20 L0,-3 L40,-3 C43,0 L43,30 C40,33 L0,33 C-3,30 L-3,0 L-20,-20"},
         {"a mirror changes the side", mirrored.c_str(), "R20,-20 L0,-5 L-10,-5 L-20,-9"},
         {"G451: sharper than 100 degrees an arc",
          "G0 X0 Y-20\nG42 G1 G451 X0 Y0\nX40\nX0 Y10\nG40 X-20\n",
          "R0,-20 L0,-5 L40,-5 C41.213,4.851 L1.213,14.851 L-20,10"},
         {"G451: no tangents of arcs are extended",
          "G0 X0 Y-20\nG42 G1 G451 X0 Y0\nX20\nG3 X20 Y20 CR=10\nG40 G1 X0\n",
          "R0,-20 L0,-5 L20,-5 C20,25 L0,20"},
         {"blocks without motion come before the corner",
          "G0 X-20 Y-20\nG42 G1 X0 Y0\nZ-2\nX40\nM8\nY30\nG40 X60\n",
          "R-20,-20 L0,-5 L0,-5/-2 L40,-5 coolant C45,0 L45,30 L60,30"},
         {"a depth at a corner that closes", "G0 X-20 Y0\nG41 G1 X0 Y0\nX40\nZ-2\nY30\nG40 X0\n",
          "R-20,0 L0,5 L35,5 L35,5/-2 L35,30 L0,30"},
         {"into an arc on a tangent",
          "G0 X-20 Y0\nG42 G1 X0 Y0\nX20\nG3 X30 Y10 CR=10\nG1 Y30\nG40 X60\n",
          "R-20,0 L0,-5 L20,-5 C35,10 L35,30 L60,30"},
         {"inside an arc", "G0 X0 Y5\nG41 G1 X0 Y0\nX20\nG3 X30 Y10 CR=10\nG1 Y30\nG40 X0\n",
          "R0,5 L20,5 C25,10 L25,30 L0,30"},
         {"KONT from behind", "G0 X10 Y20\nG42 G1 KONT X0 Y0\nX40\nG40 X60 Y-20\n",
          "R10,20 L-3.859,3.179 C0,-5 L40,-5 L60,-20"},
         {"KONT from before is NORM", "G0 X-20 Y-20\nG42 G1 KONT X0 Y0\nX40\nG40 X60 Y-20\n",
          "R-20,-20 L0,-5 L40,-5 L60,-20"},
         {"KONT to behind", "G0 X-20 Y-20\nG42 G1 KONT X0 Y0\nX40\nG40 X30 Y20\n",
          "R-20,-20 L0,-5 L40,-5 C43.859,3.179 L30,20"},
         {"from side to side", "G0 X-20 Y-20\nG42 G1 X0 Y0\nX40\nG41 X80\nX100\nG40 Y20\n",
          "R-20,-20 L0,-5 L40,-5 L80,5 L100,5 L100,20"},
         {"rapids have no arcs", "G0 X-20 Y-20\nG42 G0 X0 Y0\nX40\nY30\nG40 X60\n",
          "R-20,-20 R0,-5 R40,-5 R45,-5 R45,0 R45,30 R60,30"},
         {"SUPA between", "G0 X-20 Y-20\nG42 G1 X0 Y0\nX40\nSUPA Z300 D0\nX50 D1\nX80\nG40 Y-30\n",
          "R-20,-20 L0,-5 L40,-5 L40,-5/300 L50,-5 L80,-5 L80,-30"},
         {"CDON leaves an element out that the cutter cannot enter",
          "G0 X0 Y20\nCDON\nG41 G1 X0 Y0\nX20\nX21.5 Y1.5\nY30\nG40 X0\n",
          "R0,20 L0,5 L16.5,5 L16.5,30 L0,30"},
         {"the end of the program", "G0 X-20 Y-20\nG42 G1 X0 Y0\nX40\n", "R-20,-20 L0,-5 L40,-5"}});
}

TEST(Compensation, SinumerikAlarms) {
    check(
        "sinumerik", kSinumerik,
        {{"10750", "D0\nG41 G1 X10\n", "", "10750"},
         {"10751, an arc that is too small",
          "G0 X0 Y5\nG41 G1 X0 Y0\nX20\nG3 X24 Y4 CR=4\nG1 Y30\n", "R0,5", "10751"},
         {"10751, a step that is too small", "G0 X-20 Y-20\nG42 G1 X0 Y0\nX20\nY2\nX60\nG40 Y-20\n",
          "R-20,-20 L0,-5 L20,-5", "10751"},
         {"10751, the same without CDON", "G0 X0 Y20\nG41 G1 X0 Y0\nX20\nX21.5 Y1.5\nY30\n",
          "R0,20 L0,5 L17.929,5", "10751"},
         {"10751, a groove that is too narrow",
          "G0 X0 Y20\nCDON\nG41 G1 X0 Y0\nX20\nY-4\nX24\nY0\nX60\nG40 Y9\n", "R0,20 L0,5", "10751"},
         {"10753", "G41\nG2 X10 Y0 I5 J0\n", "", "10753"},
         {"10754", "G41 G1 X0 Y-5\nX10 Y0\nG40 G2 X20 Y0 I5 J0\n", "L-2.236,-0.528", "10754"},
         {"10755", "G0 X1 Y1\nG42 G1 KONT X0 Y0\nX40\n", "R1,1", "10755"},
         {"10757", "G41 G1 X10\nX20\nG18\n", "L10,5", "10757"},
         {"10762", "G42 G1 X0 Y10\nX40\nM8\nG4 F1\nM9\nG4 F1\nY30\n", "L0,5", "10762"},
         {"a thread", "G41 G1 X10\nG33 X20 I1\n", "", "K5280"}});
}

const std::string kFanuc = "G17 G21 G90 G94 G40 G49 G80\nT1 M6\nM3 S1000\n";

TEST(Compensation, Fanuc) {
    check("fanuc", kFanuc,
          {{"obtuse corners are extended to the intersection",
            "G0 X-20. Y-20.\nG42 D1 G1 X0. Y0. F500.\nX40.\nY30.\nX0.\nY0.\nG40 X-20. Y-20.\n",
            "R-20,-20 L0,-5 L45,-5 L45,35 L-5,35 L-5,0 L-20,-20"},
           {"acute ones by the radius",
            "G0 X0. Y-20.\nG42 D1 G1 X0. Y0. F500.\nX40.\nX0. Y10.\nG40 X-20.\n",
            "R0,-20 L0,-5 L45,-5 L46.063,3.638 L0.616,15 L-20,10"},
           {"tangents of arcs are extended",
            "G0 X0. Y-20.\nG42 D1 G1 X0. Y20. F500.\nX20. Y10.\nG3 X20. Y30. R10.\nG1 X0.\n"
            "G40 X-20.\n",
            "R0,-20 L-2.236,15.528 L18.82,5 L20,5 C20,35 L0,35 L-20,30"},
           {"a turn back is squared off",
            "G0 X0. Y-20.\nG42 D1 G1 X0. Y0. F500.\nX40.\nX0.\nG40 X-20.\n",
            "R0,-20 L0,-5 L45,-5 L45,5 L0,5 L-20,0"},
           {"D0 is no radius", "G42 D0 G1 X10. F500.\nX20.\nG40 Y20.\n", "L10,0 L20,0 L20,20"},
           {"another offset in the mode",
            "G0 X0. Y-20.\nG42 D1 G1 X0. Y0. F500.\nX40.\nD2 X80.\nX90.\nG40 Y20.\n",
            "R0,-20 L0,-5 L40,-5 L80,-3 L93,-3 L90,20", "K5977"},
           {"more empty blocks than can be read: to the normal",
            "G0 X-20. Y0.\nG41 D1 G1 X0. Y0. F500.\nX40.\nM8\nM9\nM8\nM9\nY30.\nG40 X0.\n",
            "R-20,0 L0,5 L40,5 coolant coolant coolant coolant L35,30 L0,30"},
           {"PS0034", "G41 D1\nG2 X10. Y0. I5. J0. F500.\n", "", "PS0034"},
           {"PS0037", "G41 D1 G1 X10. F500.\nX20.\nG18\n", "L10,5", "PS0037"},
           {"PS0041, an arc that is too small",
            "G0 X0. Y5.\nG41 D1 G1 X0. Y0. F500.\nX20.\nG3 X24. Y4. R4.\nG1 Y30.\n", "R0,5",
            "PS0041"},
           {"PS0041, a groove that is too narrow",
            "G0 X0. Y-20.\nG41 D1 G1 X0. Y0. F500.\nX20.\nY-10.\nX24.\nY0.\nX60.\nG40 Y9.\n",
            "R0,-20 L-5,5", "PS0041"}});
}

TEST(Compensation, FanucTypeB) {
    const std::string_view rules = R"(<rule name="comp_start" value="extended"/>
        <rule name="comp_corner" value="intersection"/>
        <rule name="comp_corner_limit" value="90"/>
        <rule name="comp_sharp_corner" value="square"/>)";
    const auto comp = [](Function side) {
        return line().fn(side).fn(Function::RadiusOffset, {{0, 1}});
    };
    const auto run_between = [&](double x, double y, double to_x, double to_y) {
        return way_of(run({rapid().x(x).y(y), comp(Function::RadiusCompRight).x(0).y(0).f(100),
                           line().x(40).y(0), line().fn(Function::RadiusCompOff).x(to_x).y(to_y)},
                          {.rules = rules}));
    };
    EXPECT_EQ(run_between(-20, 20, 40, 20), "R-20,20 L-2.071,-5 L45,-5 L40,20")
        << "obtuse: to the intersection with the way from the start";
    EXPECT_EQ(run_between(20, 20, 40, 20), "R20,20 L-7.071,0 L-5,-5 L45,-5 L40,20")
        << "acute: extended by the radius on both sides";
    EXPECT_EQ(run_between(-20, -20, 60, -20), "R-20,-20 L0,-5 L40,-5 L60,-20")
        << "a corner that closes: as type A";
}

const Command& spline_of(const Ran& ran) {
    static const Command kNone;
    for (const Command& command : ran.commands) {
        if (command.op() == Op::Spline) return command;
    }
    ADD_FAILURE() << "no spline";
    return kNone;
}

TEST(Compensation, PointedArcs) {
    // DISC=30 at a square corner: the middle of the arc is 5 + 0.3·(5√2 − 5) from the corner.
    const Ran ran = read("sinumerik", kSinumerik +
                                          "G0 X0 Y-20\nG42 G1 X0 Y0 DISC=30\nX40\nY30\n"
                                          "G40 X60\nM30\n");
    const Command& conic = spline_of(ran);
    const auto middle_at = [](const Command& command) {
        const path::CubicSpan span = path::make_spline(path::Vec3(40, -5, 0), path::Vec3(45, 0, 0),
                                                       command.motion().spline());
        return (path::point_at(span, 0.5).position - path::Vec3(40, 0, 0)).norm();
    };
    EXPECT_EQ(conic.motion().spline().degree, 2);
    EXPECT_NEAR(middle_at(conic), 5 + 0.3 * 5 * (std::sqrt(2.0) - 1), 1e-9);
    const Ran most = read("sinumerik", kSinumerik +
                                           "G0 X0 Y-20\nG42 G1 X0 Y0 DISC=90\nX40\nY30\n"
                                           "G40 X60\nM30\n");
    EXPECT_NEAR(middle_at(spline_of(most)), 5 + 0.5 * 5 * (std::sqrt(2.0) - 1), 1e-9) << "MD20220";
    // Beyond 100° G451 takes the arc as DISC has it.
    const Ran sharp = read("sinumerik", kSinumerik +
                                            "G0 X0 Y-20\nG42 G1 G451 X0 Y0 DISC=30\nX40\nX0 Y10\n"
                                            "G40 X-20\nM30\n");
    EXPECT_EQ(spline_of(sharp).motion().spline().degree, 2);
    check("sinumerik", kSinumerik,
          {{"rapids go along tangents", "G0 X-20 Y-20\nG42 G0 X0 Y0 DISC=50\nX40\nY30\nG40 X60\n",
            "R-20,-20 R0,-5 R40,-5 R43.536,-5 R45,-3.536 R45,0 R45,30 R60,30"}});
}

/// KONTT, KONTC: tangent to the cutter's way, and with its curvature.
TEST(Compensation, CurvesIn) {
    // From (−30, −20) to a circle of 20 about (0, 0) on its right side: the way has radius 25.
    for (const std::string word : {"KONTT", "KONTC"}) {
        SCOPED_TRACE(word);
        const Ran ran = read("sinumerik", kSinumerik + "G0 X30 Y-20 Z10\nG42 G1 " + word +
                                              " X20 Y0 Z-1\nG3 X0 Y20 CR=20\nG40 G1 X-20 Y40 Z9\n"
                                              "M30\n");
        EXPECT_EQ(alarms(ran), "");
        std::vector<path::CubicSpan> curves;
        path::Vec3 at(30, -20, 10);
        for (const Command& command : ran.commands) {
            if (!command.is_motion()) continue;
            const path::Vec3 to(command.motion().to[0], command.motion().to[1],
                                command.motion().to[2]);
            if (command.op() == Op::Spline)
                curves.push_back(path::make_spline(at, to, command.motion().spline()));
            at = to;
        }
        ASSERT_EQ(curves.size(), 2U);
        const path::CurvePoint in = path::curvature_at(curves[0], 1);
        const path::CurvePoint out = path::curvature_at(curves[1], 0);
        EXPECT_LT((path::point_at(curves[0], 1).position - path::Vec3(25, 0, -1)).norm(), 1e-9);
        EXPECT_LT((in.tangent - path::Vec3(0, 1, 0)).norm(), 1e-9);
        EXPECT_LT((out.tangent - path::Vec3(-1, 0, 0)).norm(), 1e-9);
        // In the plane: Z comes to rest.
        const path::Vec2 curvature = in.curvature.head<2>();
        // The parabola from (30, −20) to (25, 0) bends to the right by 2·5/(5² + 20²).
        const double bend = word == "KONTC" ? -1.0 / 25 : 10.0 / 425;
        EXPECT_LT((curvature - path::Vec2(bend, 0)).norm(), 1e-9);
        if (word == "KONTC") {
            EXPECT_LT((out.curvature - path::Vec3(0, bend, 0)).norm(), 1e-9);
        }
    }
    const Ran rapid = read("sinumerik", kSinumerik + "G0 X30 Y-20\nG42 G0 KONTT X20 Y0\nX0\nM30\n");
    EXPECT_EQ(alarms(rapid), "K5280") << "in a block with G1";
}

/// A cycle whose blocks are compensated: none of them is lost.
class Beside final : public CycleExpander {
  public:
    std::unique_ptr<Stream<Block>> expand(const CycleCall& /*call*/) override {
        const auto side = line().fn(Function::RadiusCompRight).fn(Function::RadiusOffset, {{0, 1}});
        std::vector<Block> blocks = {Words(side).x(0).y(0).f(100), line().x(40).y(0),
                                     line().x(40).y(30)};
        if (ends) blocks.push_back(line().fn(Function::RadiusCompOff).x(60).y(30));
        blocks.push_back(rapid().z(20));
        return std::make_unique<BlockList>(blocks);
    }
    bool ends = true;
};

TEST(Compensation, InsideACycle) {
    Beside cycle;
    const auto way = [&](std::vector<Block> blocks) {
        const Ran ran = run(std::move(blocks), {.cycles = &cycle});
        EXPECT_EQ(ran.codes(), "");
        return way_of(ran);
    };
    const Block call = Words().cycle(0, 4, {{0, -5}});
    EXPECT_EQ(way({rapid().x(0).y(-20), call, line().x(70).y(0).f(100)}),
              "R0,-20 L0,-5 L40,-5 C45,0 L45,30 L60,30 R60,30/20 L70,0");
    cycle.ends = false;
    EXPECT_EQ(way({rapid().x(0).y(-20), call, line().x(70).f(100)}),
              "R0,-20 L0,-5 L40,-5 C45,0 L45,30 R45,30/20 L70,30")
        << "behind it the compensation is over";
}

TEST(Compensation, FeedOnArcs) {
    const std::string blocks =
        "G0 X0 Y-20\nG42 G1 X0 Y0\nX20\nG3 X40 Y20 CR=20\nG1 Y40\nG40 X60\nM30\n";
    const auto feed_of_arc = [](const Ran& ran) {
        for (const Command& command : ran.commands) {
            if (command.op() == Op::Arc) return command.motion().feed;
        }
        return 0.0;
    };
    EXPECT_DOUBLE_EQ(feed_of_arc(read("sinumerik", kSinumerik + blocks)), 625)
        << "CFC: F is that of the contour, 500 · 25/20";
    const std::string fanuc =
        "G0 X0 Y-20.\nG42 D1 G1 X0 Y0 F500.\nX20.\nG3 X40. Y20. R20.\nG1 Y40.\nG40 X60.\nM30\n";
    EXPECT_DOUBLE_EQ(feed_of_arc(read("fanuc", kFanuc + fanuc)), 500) << "of the centre";
}

TEST(Compensation, WithoutARadius) {
    machine::Machine machine = mill();
    machine.tools.clear();
    const Ran ran = read("sinumerik", kSinumerik + "G42 G1 X10\nX20\nG40 Y20\nM30\n", machine);
    EXPECT_EQ(way_of(ran), "L10,0 L20,0 L20,20");
    EXPECT_EQ(ran.codes(), "K5271");
}

}  // namespace
}  // namespace kadr::interp::compensation_test
