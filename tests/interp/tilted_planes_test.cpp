// Tilted planes: whatever the machine, the tip goes to the programmed place of the plane on the
// turned workpiece, and the tool is along its Z. F 4.8, S 6.4, 6.5.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>

#include "base/units.h"
#include "machine/kinematics.h"
#include "machine/orientation.h"
#include "tests/interp/text_bench.h"

namespace kadr::interp::tilted_planes_test {
namespace {

using machine::Mat3;
using path::Frame;
using path::Vec3;

/// A stock machine whose linear axes reach everywhere, with a zero point of its part.
machine::Machine stock(const std::string& name) {
    Sources sources;
    DiagnosticList messages;
    auto machine = machine::load_machine(name, {KADR_ROOT "/runtime/machines"}, sources, messages);
    EXPECT_TRUE(machine.has_value()) << name;
    if (!machine) return mill();
    for (machine::MachineAxis& axis : machine->axes) {
        if (axis.is_rotary) continue;
        axis.lower = -1e5;
        axis.upper = 1e5;
    }
    machine->work_offsets = {{}, {12, -7, 31}};
    return *machine;
}

constexpr const char* kFiveAxes[] = {"trunnion-ac", "trunnion-bc", "head-cb", "head-ab",
                                     "mixed-cb",    "nutating",    "six-axis"};

/// Tip and tool on the workpiece behind every motion, by the commands and the kinematics alone.
struct Stand {
    Vec3 tip;
    Vec3 tool;
    std::uint32_t line;
};

std::vector<Stand> stands(const machine::Machine& machine, const Ran& ran, double length) {
    const machine::Chain& chain = machine.kinematics->chain;
    std::vector<Stand> found;
    Vec3 carried = Vec3::Zero();  // from the tip to the linear axes
    for (const path::Command& command : ran.commands) {
        if (command.op() == path::Op::ToolLength) {
            const path::PlaneAxes axes = path::axes_of(command.tool_length().plane);
            carried = command.tool_length().length * path::unit(axes.normal) +
                      command.tool_length().aside;
        }
        if (!command.is_motion()) continue;
        Vec3 joints = Vec3::Zero();
        for (std::size_t k = 0; k < machine::kJoints; ++k) {
            if (chain.has(k))
                joints[static_cast<Eigen::Index>(k)] =
                    rad_from_deg(command.motion().to[index(chain.joints[k].axis)]);
        }
        const Vec3 to(command.motion().to[0], command.motion().to[1], command.motion().to[2]);
        if (command.motion().orient_kind != path::OrientKind::None) {
            found.push_back({to, machine::tool_vector(chain, joints), command.line});
            continue;
        }
        const machine::ChainPosition position{
            command.motion().machine_coordinates ? to : Vec3(to + carried), Vec3::Zero(), joints};
        const machine::Pose pose =
            machine::forward(chain, position, machine::tip_of_length(chain, length));
        found.push_back({pose.tip, machine::tool_vector(chain, joints), command.line});
    }
    return found;
}

std::string words(const char* letters, const Vec3& values, const char* suffix = "") {
    std::string text;
    for (int i = 0; i < 3; ++i) {
        char word[64];
        std::snprintf(word, sizeof word, "%c%s%.3f ", letters[i], suffix, values[i]);
        text += word;
    }
    return text;
}

/// Numbers as the texts say them.
double said(double value) { return std::round(value * 1e3) / 1e3; }

/// A plane of the text, the same as a frame of the work coordinate system, and points in it.
struct Case {
    Vec3 origin;
    Vec3 angles_deg;
    std::vector<Vec3> points;
};

Case random_case(std::mt19937& random, double most_tilt_deg) {
    std::uniform_real_distribution<double> place(-60, 60);
    std::uniform_real_distribution<double> turn(-180, 180);
    std::uniform_real_distribution<double> tilt(-most_tilt_deg, most_tilt_deg);
    const auto point = [&] {
        return Vec3(said(place(random)), said(place(random)), said(place(random)));
    };
    Case result{point(), {said(turn(random)), said(tilt(random)), said(turn(random))}, {}};
    for (int i = 0; i < 3; ++i) result.points.push_back(point());
    return result;
}

/// Behind line `first` every motion ends at a point of the plane.
void expect_in_plane(const std::vector<Stand>& all, std::uint32_t first, const Frame& plane,
                     const std::vector<Vec3>& points) {
    std::size_t next = 0;
    for (const Stand& stand : all) {
        if (stand.line < first) continue;
        ASSERT_LT(next, points.size());
        EXPECT_LT((stand.tip - plane(points[next])).norm(), 1e-8);
        EXPECT_LT((stand.tool - plane.linear.col(2)).norm(), 1e-9);
        ++next;
    }
    EXPECT_EQ(next, points.size());
}

const Vec3 kPartZero(12, -7, 31);

class OnStockMachines : public ::testing::TestWithParam<const char*> {};

TEST_P(OnStockMachines, G682AndG531BringTheTipToThePlane) {
    const machine::Machine machine = stock(GetParam());
    std::mt19937 random(7);
    for (int round = 0; round < 40; ++round) {
        const Case plane = random_case(random, 28);
        std::string text = "T1 M6\nS1000 M3\nG54\nG68.2 " + words("XYZ", plane.origin) +
                           words("IJK", plane.angles_deg) + "\nG53.1\nG43 H1 " +
                           words("XYZ", plane.points[0]) + "\nG01 " +
                           words("XYZ", plane.points[1]) + "F500.\n" +
                           words("XYZ", plane.points[2]) + "\nM30";
        SCOPED_TRACE(text);
        const Ran ran = read("fanuc", text, machine);
        ASSERT_EQ(alarms(ran), "");
        const Frame frame =
            path::translation(kPartZero + plane.origin) *
            Frame{machine::euler_zxz(plane.angles_deg * rad_from_deg(1)), Vec3::Zero()};
        expect_in_plane(stands(machine, ran, machine.find_tool(1)->length), 6, frame, plane.points);
    }
}

TEST_P(OnStockMachines, Cycle800BringsTheTipToThePlane) {
    const machine::Machine machine = stock(GetParam());
    std::mt19937 random(11);
    for (int round = 0; round < 40; ++round) {
        const Case plane = random_case(random, 20);
        const Vec3 shift(1, -2, said(0.5 * round));
        const int direction = round % 2 == 0 ? -1 : 1;
        // Axis by axis: about Z by anything, about the new Y and X by little.
        const Vec3 angles(plane.angles_deg[0], plane.angles_deg[1], plane.angles_deg[1] / 2);
        std::string call = "CYCLE800(0,\"\",0,27";
        for (const Vec3& three : {plane.origin, angles, shift})
            for (int i = 0; i < 3; ++i) call += "," + std::to_string(three[i]);
        const bool has_length_before = round % 3 == 0;
        std::string text = "T1 D1 M6\nS1000 M3\nG54\n" +
                           std::string(has_length_before ? "G0 X0 Y0 Z100\n" : "G0\n") + call +
                           "," + std::to_string(direction) + ")\nG0 " +
                           words("XYZ", plane.points[0]) + "\nG1 " + words("XYZ", plane.points[1]) +
                           "F500\n" + words("XYZ", plane.points[2]) + "\nM30";
        SCOPED_TRACE(text);
        const Ran ran = read("sinumerik", text, machine);
        if (alarms(ran) == "61185")
            continue;  // _DIR wants a place that limits forbid on both sides
        ASSERT_EQ(alarms(ran), "");
        const auto printed = [](double value) { return std::stod(std::to_string(value)); };
        const Vec3 rad =
            Vec3(printed(angles[0]), printed(angles[1]), printed(angles[2])) * rad_from_deg(1);
        const Mat3 rotation = machine::rotation_about(Vec3::UnitZ(), rad[0]) *
                              machine::rotation_about(Vec3::UnitY(), rad[1]) *
                              machine::rotation_about(Vec3::UnitX(), rad[2]);
        const Frame frame = path::translation(kPartZero + plane.origin) *
                            Frame{rotation, Vec3::Zero()} * path::translation(shift);
        expect_in_plane(stands(machine, ran, machine.find_tool(1)->length), 6, frame, plane.points);
    }
}

TEST_P(OnStockMachines, TheTipStandsOnTheWorkpieceWhereItIsAskedTo) {
    const machine::Machine machine = stock(GetParam());
    const double length = machine.find_tool(1)->length;
    for (const bool is_fanuc : {true, false}) {
        const Ran ran =
            is_fanuc ? read("fanuc",
                            "T1 M6\nG54\nG43 H1 X10. Y20. Z30.\nG68.2 X0 Y0 Z0 I10. J20. K0\n"
                            "G53.6\nG01 X1. F500.\nM30",
                            machine)
                     : read("sinumerik",
                            "T1 D1 M6\nG54\nG0 X10 Y20 Z30\n"
                            "CYCLE800(0,\"\",10,39,0,0,0,10,20,0,0,0,0,-1)\nM30",
                            machine);
        const std::vector<Stand> all = stands(machine, ran, length);
        ASSERT_GE(all.size(), 2u) << is_fanuc << alarms(ran);
        const Vec3 point = kPartZero + Vec3(10, 20, 30);
        EXPECT_LT((all[0].tip - point).norm(), 1e-9);
        EXPECT_LT((all[1].tip - point).norm(), 1e-9) << is_fanuc;
        EXPECT_GT((all[1].tool - Vec3::UnitZ()).norm(), 0.3);
        if (!is_fanuc) continue;
        // X of the plane is a way in the plane.
        const Vec3 in_plane = machine::euler_zxz(Vec3(10, 20, 0) * rad_from_deg(1)).transpose() *
                              (all[2].tip - kPartZero);
        const Vec3 before =
            machine::euler_zxz(Vec3(10, 20, 0) * rad_from_deg(1)).transpose() * (point - kPartZero);
        EXPECT_LT((in_plane - Vec3(1, before[1], before[2])).norm(), 1e-8);
    }
}

TEST_P(OnStockMachines, AlongTheToolIsAlongTheTool) {
    // G68.3 at turned rotary axes; TOROT, then a way along the new Z.
    const machine::Machine machine = stock(GetParam());
    const machine::Chain& chain = machine.kinematics->chain;
    const double length = machine.find_tool(1)->length;
    std::string turn;
    for (const std::size_t k : {machine::kR1, machine::kR2}) {
        if (chain.has(k))
            turn += std::string(kAxisNames[index(chain.joints[k].axis)]) +
                    (k == machine::kR1 ? "25. " : "20. ");
    }
    const Ran fanuc = read("fanuc",
                           "T1 M6\nG54\nG00 " + turn +
                               "\nG68.3 R30.\nG43 H1 X0 Y0 Z0\nG00 Z10.\n"
                               "X5.\nM30",
                           machine);
    ASSERT_EQ(alarms(fanuc), "");
    const std::vector<Stand> all = stands(machine, fanuc, length);
    ASSERT_EQ(all.size(), 4u);
    EXPECT_LT((all[2].tip - all[1].tip - 10 * all[1].tool).norm(), 1e-8);
    EXPECT_NEAR((all[3].tip - all[2].tip).norm(), 5, 1e-8);
    EXPECT_NEAR((all[3].tip - all[2].tip).dot(all[1].tool), 0, 1e-8);
}

INSTANTIATE_TEST_SUITE_P(, OnStockMachines, ::testing::ValuesIn(kFiveAxes), [](const auto& test) {
    std::string name = test.param;
    std::erase(name, '-');
    return name;
});

// ------------------------------------------------------------------------------ FANUC

std::vector<Vec3> fanuc_tips(const std::string& plane, const std::string& moves) {
    const machine::Machine machine = stock("trunnion-ac");
    const Ran ran = read(
        "fanuc", "T1 M6\nS1000 M3\nG54\nG43 H1 Z100.\n" + plane + "\n" + moves + "\nM30", machine);
    EXPECT_EQ(alarms(ran), "") << plane;
    std::vector<Vec3> tips;
    for (const Stand& stand : stands(machine, ran, machine.find_tool(1)->length))
        tips.push_back(stand.tip - kPartZero);
    return tips;
}

void expect_last(const std::string& plane, const std::string& moves, const Vec3& tip) {
    const std::vector<Vec3> tips = fanuc_tips(plane, moves);
    ASSERT_FALSE(tips.empty());
    EXPECT_LT((tips.back() - tip).norm(), 1e-8) << plane << " gives " << tips.back().transpose();
}

TEST(TiltingFanuc, EveryFormOfG682SaysThePlaneOfTheOthers) {
    // About X by 30 degrees from (1, 2, 3): Z is (0, -0.5, 0.866), Y (0, 0.866, 0.5).
    const double c = std::sqrt(0.75);
    const Vec3 tip = Vec3(1, 2, 3) + Vec3(10, 0, 0) + 20 * Vec3(0, c, 0.5) + 5 * Vec3(0, -0.5, c);
    const std::string moves = "G53.1\nG00 X10. Y20. Z5.";
    for (const char* plane :
         {"G68.2 X1. Y2. Z3. I0 J30. K0", "G68.2 P0 X1. Y2. Z3. I0. J30.",
          "G68.2 P1 X1. Y2. Z3. I30. J0 K0", "G68.2 P1 Q321 X1. Y2. Z3. I30.",
          "G68.2 P4 X1. Y2. Z3. I0 J30. K0",
          "G68.2 P2 Q1 X1. Y2. Z3.\nG68.2 P2 Q2 X11. Y2. Z3.\nG68.2 P2 Q3 X1. Y10.660254 Z8.",
          "G68.2 P3 Q1 X1. Y2. Z3. I4. J0 K0\nG68.2 P3 Q2 I0 J-1. K1.7320508",
          "G68.2 X1. Y2. Z3. I0 J10. K0\nG68.4 I0 J20. K0", "G52 X1. Y2. Z3.\nG68.2 I0 J30. K0"}) {
        const bool is_rounded = std::string(plane).find("P2") != std::string::npos ||
                                std::string(plane).find("P3") != std::string::npos;
        const std::vector<Vec3> tips = fanuc_tips(plane, moves);
        ASSERT_FALSE(tips.empty());
        EXPECT_LT((tips.back() - tip).norm(), is_rounded ? 1e-3 : 1e-8)
            << plane << " gives " << tips.back().transpose();
    }
    // Q0 shifts in the plane and turns about its Z.
    expect_last(
        "G68.2 P2 Q0 X1. Y0 Z2. R90.\nG68.2 P2 Q1 X0 Y0 Z0\nG68.2 P2 Q2 X1. Y0 Z0\n"
        "G68.2 P2 Q3 X0 Y1. Z0",
        "G53.1\nG00 X10. Y0 Z0", {1, 10, 2});
}

TEST(TiltingFanuc, G69GivesTheSystemOfBeforeBack) {
    const machine::Machine machine = stock("head-cb");
    const Ran ran = read("fanuc",
                         "T1 M6\nG54\nG68.2 X5. Y0 Z0 I0 J20. K0\nG53.1\nG43 H1 X0 Y0 Z10.\nG49\n"
                         "G69\nG00 B0 C0\nG43 H1 X1. Y2. Z3.\nM30",
                         machine);
    ASSERT_EQ(alarms(ran), "");
    const std::vector<Stand> all = stands(machine, ran, machine.find_tool(1)->length);
    EXPECT_LT((all.back().tip - kPartZero - Vec3(1, 2, 3)).norm(), 1e-9);
}

TEST(TiltingFanuc, TheMachineStaysWhereItIsWhenAPlaneBeginsAndEnds) {
    for (const char* name : kFiveAxes) {
        const machine::Machine machine = stock(name);
        // The last way is 0 long: the axes of the machine stand as behind G53.1.
        const Ran ran = read("fanuc",
                             "T1 M6\nG54\nG43 H1 X10. Y20. Z30.\nG68.2 X5. Y0 Z0 I15. J20. K0\n"
                             "G53.1\nG91 G00 X0\nG69\nX0\nM30",
                             machine);
        ASSERT_EQ(alarms(ran), "") << name;
        const std::vector<Stand> all = stands(machine, ran, machine.find_tool(1)->length);
        ASSERT_EQ(all.size(), 4u) << name;
        EXPECT_LT((all[3].tip - all[2].tip).norm(), 1e-9) << name;
        EXPECT_LT((all[2].tip - all[1].tip).norm(), 1e-9) << name;
    }
}

TEST(TiltingFanuc, CyclesWorkInThePlane) {
    const std::vector<Vec3> tips =
        fanuc_tips("G68.2 X0 Y0 Z0 I0 J90. K0", "G53.1\nG00 X0 Y0 Z50.\nG01 X5. Y6. Z2. F100.");
    // About X by 90: Y is Z of the part, Z is -Y.
    EXPECT_LT((tips.back() - Vec3(5, -2, 6)).norm(), 1e-8);
}

TEST(TiltingFanuc, P1AndP2OfG531ChooseTheSignOfTheTiltingAxis) {
    machine::Machine machine = stock("trunnion-bc");
    for (machine::MachineAxis& axis : machine.axes)
        if (axis.is_rotary) axis.lower = -7, axis.upper = 7;
    for (const auto& [word, sign] : {std::pair{"G53.1 P1", 1.0}, std::pair{"G53.1 P2", -1.0}}) {
        const Ran ran = read(
            "fanuc", "G54\nG68.2 X0 Y0 Z0 I0 J20. K0\n" + std::string(word) + "\nM30", machine);
        ASSERT_EQ(alarms(ran), "");
        EXPECT_NEAR(ran.commands.at(0).motion().to[index(Axis::B)], sign * 20, 1e-9) << word;
    }
}

struct Refused {
    std::string control;
    std::string machine;
    std::string text;
    std::string alarm;
    std::string code;
};
class TiltingRefuses : public ::testing::TestWithParam<Refused> {};

TEST_P(TiltingRefuses, WithItsAlarm) {
    const Refused& wrong = GetParam();
    const machine::Machine machine = wrong.machine == "mill" ? mill() : stock(wrong.machine);
    const Ran ran = read(wrong.control, wrong.text, machine);
    EXPECT_TRUE(ran.alarmed);
    ASSERT_FALSE(ran.messages.empty()) << wrong.text;
    EXPECT_EQ(alarms(ran), wrong.alarm) << wrong.text;
    EXPECT_EQ(ran.messages.back().row->code, wrong.code) << wrong.text;
}

constexpr const char* kPlane = "G68.2 X0 Y0 Z0 I0 J30. K0\n";

INSTANTIATE_TEST_SUITE_P(
    , TiltingRefuses,
    ::testing::Values(
        Refused{"fanuc", "trunnion-ac", std::string(kPlane) + kPlane, "PS5456", "K5651"},
        Refused{"fanuc", "trunnion-ac", "G53.1", "PS5458", "K5653"},
        Refused{"fanuc", "mill", std::string(kPlane) + "G53.1", "PS5459", "K5650"},
        Refused{"fanuc", "rotary-a", "G68.2 X0 Y0 Z0 I90. J30. K0\nG53.1", "PS5459", "K5654"},
        Refused{"fanuc", "trunnion-ac", "G68.2 X0 I0 J30. K0", "PS5457", "K5652"},
        Refused{"fanuc", "trunnion-ac", "G68.2 P1 Q122 I0 J30. K0", "PS5457", "K5652"},
        Refused{"fanuc", "trunnion-ac", "G68.2 P2 Q2 X0 Y0 Z0", "PS5457", "K5652"},
        Refused{"fanuc", "trunnion-ac", "G68.2 P2 Q1 X0 Y0 Z0\nG00 X5.", "PS5457", "K5652"},
        Refused{"fanuc", "trunnion-ac",
                "G68.2 P2 Q1 X0 Y0 Z0\nG68.2 P2 Q2 X1. Y1. Z1.\nG68.2 P2 Q3 X2. Y2. Z2.", "PS5457",
                "K5652"},
        Refused{"fanuc", "trunnion-ac", "G68.2 P3 Q1 I1. J0 K0\nG68.2 P3 Q2 I1. J0 K1.", "PS5457",
                "K5652"},
        Refused{"fanuc", "trunnion-ac", "G68.2 P4 I90. J90. K0", "PS5457", "K5652"},
        Refused{"sinumerik", "mill", "CYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,-1)", "61191",
                "K5650"},
        Refused{"sinumerik", "nutating", "CYCLE800(0,\"\",0,57,0,0,0,120,0,0,0,0,0,-1)", "61184",
                "K5654"},
        Refused{"sinumerik", "trunnion-ac", "CYCLE800(0,\"\",0,57,0,0,0,0,170,0,0,0,0,-1)", "61185",
                "K5655"},
        Refused{"sinumerik", "trunnion-ac", "CYCLE800(0,\"\",0,21,0,0,0,30,0,0,0,0,0,-1)", "K5657",
                "K5657"},
        Refused{"sinumerik", "trunnion-ac", "CYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,5)", "K5657",
                "K5657"},
        Refused{"sinumerik", "trunnion-ac", "CYCLE800(3,\"\",0,57,0,0,0,30,0,0,0,0,0,-1)", "K5657",
                "K5657"},
        Refused{"sinumerik", "trunnion-ac", "CYCLE800(5,\"\",0,57,0,0,0,30,0,0,0,0,0,-1,500000)",
                "61190", "K5658"},
        Refused{"sinumerik", "trunnion-ac", "G18\nCYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,-1)",
                "K5657", "K5657"},
        Refused{"sinumerik", "trunnion-ac",
                "T1 D1 M6\nS1000 M3\nG1 G41 X10 F100\nX20\n"
                "CYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,-1)",
                "K5659", "K5659"}));

// ------------------------------------------------------------------------------ SINUMERIK

/// Where the axes stand is where they stood under the transformation.
TEST(TiltingSinumerik, TheCycleSwitchesATransformationOffAsItsWordDoes) {
    const auto swivelled = [](const std::string& word, const std::string& cycle) {
        const Ran ran = read("sinumerik",
                             "G500\nT1 D1 M6\nTRAORI\nG0 X10 Y-20 Z30 A3=0.2 B3=-0.5 C3=1\n" +
                                 word + cycle + "\nG0 X5 Y6 Z7\nM30",
                             stock("trunnion-ac"));
        EXPECT_EQ(alarms(ran), "") << cycle;
        return ran.commands;
    };
    for (const std::string tens : {"0", "10"}) {
        const std::string cycle = "CYCLE800(1,\"\"," + tens + ",57,1,2,3,-30,0,0,0,0,0,-1)";
        const auto wanted = swivelled("TRAFOOF\n", cycle);
        const auto found = swivelled("", cycle);
        ASSERT_EQ(found.size(), wanted.size()) << tens;
        for (std::size_t i = 0; i < found.size(); ++i) {
            ASSERT_EQ(found[i].op(), wanted[i].op()) << i;
            if (!found[i].is_motion()) continue;
            EXPECT_EQ(found[i].motion().to, wanted[i].motion().to) << i;
            EXPECT_EQ(found[i].motion().orient_kind, wanted[i].motion().orient_kind) << i;
        }
        const auto last =
            std::ranges::find_if(found.rbegin(), found.rend(), &path::Command::is_motion);
        ASSERT_NE(last, found.rend()) << tens;
        EXPECT_EQ(last->motion().orient_kind, path::OrientKind::None) << tens;
    }
}

TEST(TiltingSinumerik, ModesOfTheCycleAreItsAngles) {
    const machine::Machine machine = stock("trunnion-ac");
    struct Mode {
        std::string mode;
        std::string angles;
        Mat3 rotation;
    };
    const auto about = [](const Vec3& axis, double deg) {
        return machine::rotation_about(axis, rad_from_deg(deg));
    };
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
    const Mat3 a = about(x, 10), b = about(y, 20), c = about(z, 30);
    for (const Mode& mode : {Mode{"57", "10,20,30", a * b * c}, Mode{"54", "20,10,30", b * a * c},
                             Mode{"39", "30,10,20", c * a * b}, Mode{"45", "10,30,20", a * c * b},
                             Mode{"30", "20,30,10", b * c * a}, Mode{"27", "30,20,10", c * b * a},
                             Mode{"64", "30,20,0", c * b}}) {
        const Ran ran = read("sinumerik",
                             "T1 D1 M6\nG54\nCYCLE800(0,\"\",0," + mode.mode + ",1,2,3," +
                                 mode.angles + ",4,5,6,-1)\nG0 X7 Y8 Z9\nM30",
                             machine);
        ASSERT_EQ(alarms(ran), "") << mode.mode;
        const Stand last = stands(machine, ran, machine.find_tool(1)->length).back();
        const Vec3 wanted = kPartZero + Vec3(1, 2, 3) + mode.rotation * Vec3(11, 13, 15);
        EXPECT_LT((last.tip - wanted).norm(), 1e-8) << mode.mode;
        EXPECT_LT((last.tool - mode.rotation.col(2)).norm(), 1e-9) << mode.mode;
    }
}

TEST(TiltingSinumerik, DirectModeTakesTheAxesInTheirOrder) {
    // Of a table, axis 1 carries axis 2: A and C; of a table and a head, axis 1 is the head's.
    for (const auto& [name, first, second] :
         {std::tuple{"trunnion-ac", Axis::A, Axis::C}, std::tuple{"head-cb", Axis::C, Axis::B},
          std::tuple{"mixed-cb", Axis::B, Axis::C}}) {
        const machine::Machine machine = stock(name);
        const Ran ran = read("sinumerik",
                             "T1 D1 M6\nG54\nCYCLE800(0,\"\",0,192,0,0,0,15,40,0,0,0,0,-1)\n"
                             "G0 X0 Y0 Z0\nG0 Z10\nM30",
                             machine);
        ASSERT_EQ(alarms(ran), "") << name;
        const std::vector<Stand> all = stands(machine, ran, machine.find_tool(1)->length);
        ASSERT_EQ(all.size(), 3u);
        EXPECT_NEAR(ran.commands[1].motion().to[index(first)], 15, 1e-9) << name;
        EXPECT_NEAR(ran.commands[1].motion().to[index(second)], 40, 1e-9) << name;
        EXPECT_LT((all[1].tip - kPartZero).norm(), 1e-9) << name;
        EXPECT_LT((all[2].tip - kPartZero - 10 * all[2].tool).norm(), 1e-8) << name;
    }
}

TEST(TiltingSinumerik, PlanesAreAddedWithWhatTheProgramHasDoneInThem) {
    const machine::Machine machine = stock("trunnion-ac");
    const Ran ran = read("sinumerik",
                         "T1 D1 M6\nG54\nTRANS X100\nCYCLE800(0,\"\",0,57,0,0,0,10,0,0,0,0,0,-1)\n"
                         "TRANS X5\nAROT Z90\n"
                         "CYCLE800(0,\"\",1,57,0,0,0,0,20,0,0,0,0,-1)\nG0 X1 Y2 Z3\n"
                         "CYCLE800()\nG0 X0 Y0 Z0 A0 C0\nM30",
                         machine);
    ASSERT_EQ(alarms(ran), "");
    const std::vector<Stand> all = stands(machine, ran, machine.find_tool(1)->length);
    const Mat3 first = machine::rotation_about(Vec3::UnitX(), rad_from_deg(10));
    const Mat3 second = machine::rotation_about(Vec3::UnitZ(), rad_from_deg(90)) *
                        machine::rotation_about(Vec3::UnitY(), rad_from_deg(20));
    const Vec3 wanted = kPartZero + first * (Vec3(5, 0, 0) + second * Vec3(1, 2, 3));
    ASSERT_GE(all.size(), 2u);
    EXPECT_LT((all[all.size() - 2].tip - wanted).norm(), 1e-8);
    EXPECT_LT((all.back().tip - kPartZero).norm(), 1e-9);  // without plane, without TRANS
}

TEST(TiltingSinumerik, TheToolIsDrawnBackBeforeTheAxesTurn) {
    machine::Machine machine = stock("trunnion-ac");
    const auto run = [&](const std::string& retract, const std::string& by) {
        const Ran ran = read("sinumerik",
                             "T1 D1 M6\nG54\nG0 X10 Y20 Z30\nCYCLE800(" + retract +
                                 ",\"\",0,57,0,0,0,10,0,0,0,0,0,-1," + by + ")\nM30",
                             machine);
        EXPECT_EQ(alarms(ran), "") << retract;
        return ran;
    };
    const double length = machine.find_tool(1)->length;
    EXPECT_EQ(stands(machine, run("0", ""), length).size(), 2u);
    const Ran to_z = run("1", "");
    ASSERT_EQ(stands(machine, to_z, length).size(), 3u);
    EXPECT_NEAR(stands(machine, to_z, length)[1].tip[2], 400 - length, 1e-9);
    EXPECT_EQ(stands(machine, run("2", ""), length).size(), 4u);
    const Ran by_ten = run("5", "10");
    EXPECT_NEAR(stands(machine, by_ten, length)[1].tip[2], kPartZero[2] + 40, 1e-9);
    machine.axes[2].upper = 350;
    const Ran as_far = run("4", "");
    EXPECT_NEAR(stands(machine, as_far, length)[1].tip[2], 350 - length, 1e-9);
}

TEST(TiltingSinumerik, TorotAndToframeLayAnAxisAlongTheTool) {
    const machine::Machine machine = stock("head-cb");
    const double length = machine.find_tool(1)->length;
    const auto run = [&](const std::string& frame, const std::string& moves) {
        const Ran ran = read("sinumerik",
                             "T1 D1 M6\nTRAORI\nG54\nG0 X10 Y20 Z30 A3=1 B3=0.5 C3=2\n" + frame +
                                 "\n" + moves + "\nM30",
                             machine);
        EXPECT_EQ(alarms(ran), "") << frame;
        return stands(machine, ran, length);
    };
    const Vec3 tool = Vec3(1, 0.5, 2).normalized();
    const Vec3 point = kPartZero + Vec3(10, 20, 30);
    // The origin stays: a distance is a distance.
    for (const char* word : {"TOROT", "TOROTZ"}) {
        const auto all = run(word, "G0 Z=IC(100)\nTOROTOF\nG0 X10 Y20 Z30");
        ASSERT_EQ(all.size(), 3u);
        EXPECT_LT((all[1].tip - point - 100 * tool).norm(), 1e-9) << word;
        EXPECT_LT((all[2].tip - point).norm(), 1e-9) << word;
    }
    EXPECT_LT((run("TOROTX", "G0 X=IC(100)")[1].tip - point - 100 * tool).norm(), 1e-9);
    EXPECT_LT((run("TOROTY", "G0 Y=IC(100)")[1].tip - point - 100 * tool).norm(), 1e-9);
    EXPECT_LT((run("TOFRAME", "G0 X0 Y0 Z100")[1].tip - point - 100 * tool).norm(), 1e-9);
    EXPECT_LT((run("TOFRAMEX", "G0 X100 Y0 Z0")[1].tip - point - 100 * tool).norm(), 1e-9);
    EXPECT_LT((run("TRANS X3\nAROT Z20\nTOROT", "G0 Z=IC(100)")[1].tip - point - 100 * tool).norm(),
              1e-9);
}

TEST(TiltingSinumerik, ParotLaysFramesOnTheTurnedTable) {
    const machine::Machine machine = stock("trunnion-ac");
    const Ran ran = read("sinumerik",
                         "T1 D1 M6\nG54\nG0 X0 Y0 Z50 A0 C40\nPAROT\nG0 X10 Y0 Z0\nPAROTOF\n"
                         "G0 X10 Y0 Z0\nM30",
                         machine);
    ASSERT_EQ(alarms(ran), "");
    const std::vector<Stand> all = stands(machine, ran, machine.find_tool(1)->length);
    ASSERT_EQ(all.size(), 3u);
    EXPECT_LT((all[1].tip - kPartZero - Vec3(10, 0, 0)).norm(), 1e-9);
    EXPECT_GT((all[2].tip - all[1].tip).norm(), 1);
}

TEST(TiltingSinumerik, FourAxesReachThePlanesOfTheirCone) {
    const machine::Machine machine = stock("borer");
    for (const double angle : {35.0, 125.0, -60.0, 180.0}) {
        const Ran ran = read("sinumerik",
                             "T1 D1 M6\nG54\nCYCLE800(0,\"\",0,54,0,0,0," + std::to_string(angle) +
                                 ",0,0,0,0,0,-1)\nG0 X1 Y2 Z3\nM30",
                             machine);
        ASSERT_EQ(alarms(ran), "") << angle;
        const Stand last = stands(machine, ran, machine.find_tool(1)->length).back();
        const Mat3 rotation = machine::rotation_about(Vec3::UnitY(), rad_from_deg(angle));
        EXPECT_LT((last.tip - kPartZero - rotation * Vec3(1, 2, 3)).norm(), 1e-8) << angle;
    }
}

TEST(Tilting, ARotaryAxisThatIsMovedInAPlaneIsWarnedOf) {
    const machine::Machine machine = stock("trunnion-ac");
    const Ran ran =
        read("fanuc", "G54\nG68.2 X0 Y0 Z0 I0 J30. K0\nG53.1\nG00 A30. C0\nX10. A10.\nC5.\nM30",
             machine);
    EXPECT_EQ(alarms(ran), "K5656");
}

}  // namespace
}  // namespace kadr::interp::tilted_planes_test
