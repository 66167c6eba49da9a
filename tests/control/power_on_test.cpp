// What a dialect file says to act at power-on acts: a program without a code on a control that
// begins with it does what the program with the code does on one that does not.
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "interp/interpreter.h"
#include "interp/listing.h"
#include "macro/program.h"
#include "tests/common/whole_text.h"
#include "tests/control/control_machines.h"

namespace kadr::interp::power_on_test {

using macro::NcProgram;
namespace {

/// SINUMERIK with another default of one group; nothing: as it is delivered.
nc::Dialect control(const std::string& group, const std::string& functions) {
    const std::filesystem::path folder =
        std::filesystem::path(::testing::TempDir()) / ("kadr_power_on_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "other.xml")
        << "<dialect name=\"other\" extends=\"sinumerik\" title=\"other\" suffix=\"mpf\">"
        << (group.empty() ? "" : "<group name=\"" + group + "\" default=\"" + functions + "\"/>")
        << "</dialect>";
    Sources sources;
    DiagnosticList messages;
    std::optional<nc::Dialect> dialect = nc::load_dialect(
        (folder / "other.xml").string(), {KADR_ROOT "/dialects"}, sources, messages);
    std::filesystem::remove_all(folder);
    EXPECT_TRUE(dialect.has_value()) << group << ' ' << functions;
    return std::move(*dialect);
}

/// The commands of a program, and what is said of it.
std::string commands_of(const nc::Dialect& dialect, const std::string& text) {
    machine::Machine machine = machine_named("five-axis", false);
    machine.tools[0].radius = 5;
    DiagnosticList messages;
    WholeText source(text);
    NcProgram program(dialect, source, "test", {}, messages);
    InterpreterOptions options;
    options.max_blocks = 1000;
    Interpreter interpreter(dialect, machine, program, &program, nullptr, options, messages);
    program.follow(interpreter);
    const Listing listing(machine);
    std::string out;
    std::vector<path::Command> batch(16);
    for (std::size_t count = 0; (count = interpreter.pull(batch)) > 0;)
        for (std::size_t i = 0; i < count; ++i) {
            batch[i].line = 0;  // which line says it does not matter
            listing.append(batch[i], "", out);
            if (!batch[i].is_motion()) continue;
            out +=
                "turning " + std::to_string(static_cast<int>(batch[i].motion().orient_kind)) + '\n';
        }
    for (const Diagnostic& message : messages.all()) out += std::string(message.row->code) + '\n';
    return out;
}

struct Row {
    const char* group;
    const char* functions;
    const char* code;  // that says the same
    const char* text;
};

const char* const kContour =
    "T1 D1 M6\nS1000 M3 F100\nG0 X-20 Y10\nG1 G42 X0 Y0\nX40\nY30\nX0\n"
    "G40 X-20\nM30\n";
const char* const kSpace =
    "T1 D1 M6\nS1000 M3 F100\nTRAORI\nG0 X-20 Y-20 A3=0 C3=1\n"
    "G1 G42 X0 Y0\nX40 B3=0.2 C3=1\nB3=0.5 C3=1\nY30\nG40 X-20\nM30\n";
const char* const kTurn =
    "S1000 M3\nROT Z90\nTRAORI\nG1 X10 A2=30 B2=45 C2=20 F1000\n"
    "X20 A2=-40 B2=20 C2=5\nM30\n";

class PowerOn : public ::testing::TestWithParam<Row> {};

TEST_P(PowerOn, ADefaultActsAsItsCode) {
    const Row& row = GetParam();
    const std::string with_code = std::string(row.code) + '\n' + row.text;
    const std::string without = std::string(";\n") + row.text;
    const nc::Dialect plain = control("", "");
    const std::string wanted = commands_of(plain, with_code);
    EXPECT_EQ(commands_of(control(row.group, row.functions), without), wanted);
    EXPECT_NE(commands_of(plain, without), wanted) << "the code has no effect there";
}

INSTANTIATE_TEST_SUITE_P(
    Groups, PowerOn,
    ::testing::Values(
        Row{"1", "rapid", "G0", "X10\nM30\n"},
        Row{"1", "polynomial", "POLY", "S1000 M3 F100\nPO[X]=(10,2)\nM30\n"},
        Row{"6", "plane_zx", "G18", "S1000 M3\nG3 X5 Z-5 I0 K-5 F100\nM30\n"},
        Row{"6", "plane_yz", "G19", "S1000 M3\nG3 Y5 Z-5 J0 K-5 F100\nM30\n"},
        Row{"10", "continuous_path", "G64", "S1000 M3\nG1 X10 F100\nY10\nM30\n"},
        Row{"10", "blend_smooth", "G645", "S1000 M3\nG1 X10 F100\nY10\nM30\n"},
        Row{"14", "incremental", "G91", "G0 X10\nX10\nM30\n"},
        Row{"15", "feed_inverse_time", "G93", "S1000 M3\nG1 X10 F2\nM30\n"},
        Row{"15", "feed_per_revolution cutting_speed_on", "G96 S100", "S100 M3\nG1 X10 F2\nM30\n"},
        Row{"17", "comp_start_around", "KONT", kContour},
        Row{"18", "comp_corner_intersection", "G451", kContour},
        Row{"22", "comp_by_side", "CUT3DC", kSpace},
        Row{"23", "comp_check_on", "CDON",
            "T1 D1 M6\nS1000 M3 F100\nG0 X0 Y0\nG1 G41 X10 Y0\nX40\nY2\nX70\nY40\nG40 X0\nM30\n"},
        Row{"25", "orient_in_base", "ORIMKS", kTurn},
        Row{"28", "area_off", "WALIMOF", "G26 X5\nG0 X10\nM30\n"},
        Row{"29", "diameter_on", "DIAMON", "G0 X10\nM30\n"},
        Row{"30", "compress_on", "COMPCAD", "S1000 M3\nG1 X10 F100\nM30\n"},
        Row{"50", "angles_rpy", "ORIRPY", kTurn}, Row{"50", "angles_xyz", "ORIRPY2", kTurn},
        Row{"51", "turn_axes", "ORIAXES", kTurn},
        Row{"51", "turn_surface", "ORIPATH", "S1000 M3\nTRAORI\nG1 LEAD=20 F1000\nX10\nY10\nM30\n"},
        Row{"coolant", "coolant_flood", "M8", "G0 X10\nM30\n"}));

}  // namespace
}  // namespace kadr::interp::power_on_test
