// The element <kinematics>: what it means. Its mistakes are shown by the examples of their rows
// (tests/driver/machine_row_examples_test.cpp).
#include <fstream>
#include <utility>

#include "machine/machine.h"
#include "tests/machine/support.h"

namespace kadr::machine::load_kinematics_test {
namespace {

struct Loaded {
    std::optional<Machine> machine;
    Sources sources;
    DiagnosticList diagnostics;
};

/// A machine with the axes of these letters around a chain.
void load(const std::string& kinematics, const std::string& axes, Loaded& loaded) {
    const std::string path = ::testing::TempDir() + "kadr-kinematics.xml";
    std::string text = "<machine name=\"m\">" + kinematics;
    for (const char name : axes) {
        const bool is_rotary = name >= 'A' && name <= 'C';
        text += std::string("<axis name=\"") + name +
                (is_rotary ? "\" velocity=\"30 rpm\" acceleration=\"500 deg/s2\"/>"
                           : "\" velocity=\"30 m/min\" acceleration=\"5 m/s2\"/>");
    }
    std::ofstream(path) << text << "</machine>";
    loaded.machine = load_machine(path, {}, loaded.sources, loaded.diagnostics);
}

std::optional<Machine> load(const std::string& kinematics) {
    Loaded loaded;
    load(kinematics, "XYZWABC", loaded);
    for (const Diagnostic& diagnostic : loaded.diagnostics.all())
        ADD_FAILURE() << diagnostic.message();
    return std::move(loaded.machine);
}

TEST(LoadKinematics, PointsAndSigns) {
    const auto machine = load(R"(
        <kinematics path_choice="fanuc" pole_tolerance="0.1 deg" uvw_compensation="yes">
          <rotary axis="C" on="table" direction="0 0 2" point="1 2 -3.5 in"/>
          <rotary axis="B" on="head" direction="0 1 1" point="0 0 0.2 m" sign="-"/>
          <tool_rotation axis="A"/>
        </kinematics>)");
    ASSERT_TRUE(machine && machine->kinematics);
    const Kinematics& kinematics = *machine->kinematics;
    EXPECT_EQ(kinematics.rule, PathRule::MasterFirst);
    EXPECT_DOUBLE_EQ(kinematics.pole_tolerance, rad_from_deg(0.1));
    const Chain& chain = kinematics.chain;
    EXPECT_TRUE(chain.compensates_parallel);
    EXPECT_EQ(chain.joints[kR1].axis, Axis::C);
    EXPECT_EQ(chain.joints[kR1].side, ChainSide::Table);
    EXPECT_EQ(chain.joints[kR1].sign, 1);
    EXPECT_LT((chain.joints[kR1].point - 25.4 * Vec3(1, 2, -3.5)).norm(), 1e-12);
    EXPECT_EQ(chain.joints[kR1].direction, Vec3::UnitZ());
    EXPECT_EQ(chain.joints[kR2].side, ChainSide::Head);
    EXPECT_EQ(chain.joints[kR2].sign, -1);
    EXPECT_LT((chain.joints[kR2].direction - Vec3(0, 1, 1).normalized()).norm(), 1e-15);
    EXPECT_LT((chain.joints[kR2].point - Vec3(0, 0, 200)).norm(), 1e-12);
    EXPECT_TRUE(chain.has(kPsi));
    EXPECT_EQ(chain.joints[kPsi].axis, Axis::A);
}

// c2 = start − L2, c1 = c2 − L1 (motion.md 5.1); on a head the start does not count.
TEST(LoadKinematics, VectorsBetweenTheAxes) {
    const auto machine = load(R"(
        <kinematics l1="30 0 -200 mm" l2="1 2 -160 mm" start="10 20 30 mm">
          <rotary axis="C" on="table" direction="0 0 1"/>
          <rotary axis="B" on="head" direction="0 1 0"/>
        </kinematics>)");
    ASSERT_TRUE(machine && machine->kinematics);
    const Chain& chain = machine->kinematics->chain;
    EXPECT_EQ(chain.joints[kR2].point, Vec3(-1, -2, 160));
    EXPECT_EQ(chain.joints[kR1].point, Vec3(10 - 1 - 30, 20 - 2, 30 + 160 + 200));
    EXPECT_EQ(machine->kinematics->rule, PathRule::LongInAxisMode);
}

TEST(LoadKinematics, OneAxisByItsVector) {
    const auto machine = load(R"(
        <kinematics l2="0 0 80 mm"><rotary axis="A" on="table" direction="1 0 0"/></kinematics>)");
    ASSERT_TRUE(machine && machine->kinematics);
    EXPECT_EQ(machine->kinematics->chain.joints[kR1].point, Vec3(0, 0, -80));
    EXPECT_FALSE(machine->kinematics->chain.orients());
}

struct Mistake {
    const char* code;
    const char* marked;
    const char* inside;  // of <kinematics>; its attributes stand before a `>`
    const char* axes = "XYZABC";
};

TEST(LoadKinematics, Mistakes) {
    const std::string c = R"(<rotary axis="C" on="table" direction="0 0 1" point="0 0 0 mm"/>)";
    const std::string a = R"(<rotary axis="A" on="head" direction="1 0 0" point="0 0 9 mm"/>)";
    for (
        const Mistake& mistake : {
            Mistake{"K6260", "X",
                    R"(><rotary axis="X" on="table" direction="0 0 1" point="0 0 0 mm"/>)"},
            {"K6260", "B", R"(><rotary axis="B" on="table" direction="0 0 1" point="0 0 0 mm"/>)",
             "XYZC"},
            {"K6261", "0 1", R"(><rotary axis="C" on="table" direction="0 1" point="0 0 0 mm"/>)"},
            {"K6261", "0 0 mm",
             R"(><rotary axis="C" on="table" direction="0 0 1" point="0 0 mm"/>)"},
            {"K6008", "0 0 0", R"(><rotary axis="C" on="table" direction="0 0 1" point="0 0 0"/>)"},
            {"K6009", "0 0 0 deg",
             R"(><rotary axis="C" on="table" direction="0 0 1" point="0 0 0 deg"/>)"},
            {"K6262", "0 0 0",
             R"(><rotary axis="C" on="table" direction="0 0 0" point="0 0 0 mm"/>)"},
            {"K6262", "0 0 0", R"( tool_direction="0 0 0">CC)"},
            {"K6263", "rotary",
             ">CCAA"
             R"(<rotary axis="B" on="head" direction="0 1 0" point="0 0 0 mm"/>)"},
            {"K6264", "table", ">AACC"},
            {"K6265", "0 0 -1",
             R"(>CC<rotary axis="A" on="head" direction="0 0 -1" point="0 0 9 mm"/>)"},
            {"K6266", "0 0 1",
             R"(>AA<rotary axis="B" on="head" direction="0 0 1" point="0 0 9 mm"/>)"},
            {"K6267", "0 0 0 mm", R"( l2="0 0 5 mm">CC)"},
            {"K6268", "rotary", R"(><rotary axis="C" on="table" direction="0 0 1"/>)"},
            {"K6269", "0 0 5 mm", R"( start="0 0 5 mm">CC)"},
            {"K6269", "0 0 5 mm",
             R"( l2="0 0 5 mm"><rotary axis="C" on="table" direction="0 0 1"/><rotary axis="A" on="table" direction="1 0 0"/>)"},
            {"K6270", "kinematics", ">"},
            {"K6271", "tool_rotation", R"(>CC<tool_rotation axis="B"/>)"},
            {"K6272", "kinematics", ">CC", "XZC"},
            {"K6272", "kinematics", ">CCAA", "XYAC"},
            {"K6273", "yes", R"( uvw_compensation="yes">CC)"},
            {"K6274", "20 deg", R"( pole_tolerance="20 deg">CC)"},
            {"K6280", "A", R"( swivel_reference="A">CC)"},
            {"K6280", "B", R"( swivel_reference="B">CCAA<tool_rotation axis="B"/>)"},
            {"K6014", "C", R"(>CC<rotary axis="C" on="head" direction="1 0 0" point="0 0 9 mm"/>)"},
            {"K6014", "tool_rotation",
             R"(>CCAA<tool_rotation axis="B"/><tool_rotation axis="B"/>)"},
            {"K6014", "kinematics", ">CC</kinematics><kinematics>"},
            {"K6017", "+-",
             R"(><rotary axis="C" on="table" direction="0 0 1" point="0 0 0 mm" sign="+-"/>)"},
            {"K6017", "4", R"( path_choice="4">CC)"},
            {"K9103", "joint", ">CC<joint/>"},
            {"K9105", "rotary", R"(><rotary axis="C" direction="0 0 1" point="0 0 0 mm"/>)"},
        }) {
        std::string text = std::string("<kinematics") + mistake.inside + "</kinematics>";
        for (const auto& [word, piece] : {std::pair("CC", c), std::pair("AA", a)}) {
            const std::size_t index = text.find(word);
            if (index != std::string::npos) text.replace(index, 2, piece);
        }
        SCOPED_TRACE(text);
        Loaded loaded;
        load(text, mistake.axes, loaded);
        EXPECT_FALSE(loaded.machine);
        ASSERT_EQ(loaded.diagnostics.all().size(), 1u) << "one mistake, one message";
        const Diagnostic& said = loaded.diagnostics.all()[0];
        EXPECT_EQ(said.row->code, mistake.code) << said.message();
        EXPECT_EQ(loaded.sources.text(said.range), mistake.marked);
    }
}

// A machine in a plane: the linear axis along the rotary one may be missing.
TEST(LoadKinematics, TwoLinearAxes) {
    Loaded loaded;
    load(
        R"(<kinematics><rotary axis="B" on="head" direction="0 1 0" point="0 0 9 mm"/></kinematics>)",
        "XZB", loaded);
    ASSERT_TRUE(loaded.machine);
    EXPECT_EQ(loaded.machine->kinematics->chain.linear, bit(Axis::X) | bit(Axis::Z));
}

}  // namespace
}  // namespace kadr::machine::load_kinematics_test
