// A program means the same in each working plane when its axes are renamed in turn: G17 with X, Y,
// Z is G18 with Z, X, Y and G19 with Y, Z, X. Tool lengths, frames, arcs, compensation, polar words
// and cycles all depend on the plane; none of them may prefer one.
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "driver/cycles.h"
#include "driver/session.h"
#include "macro/program.h"
#include "tests/common/inputs.h"
#include "tests/common/whole_text.h"
#include "tests/interp/bench.h"

namespace kadr::interp::planes_test {

using macro::NcProgram;
namespace {

/// `x y z` are the axes of the plane and its normal, `i j k` their centre words, `p` the plane.
std::string in_plane(std::string_view program, int turns) {
    static constexpr std::string_view kAxes = "XYZ";
    static constexpr std::string_view kCenters = "IJK";
    // Turned once: x is Z, y is X, z is Y.
    const auto turned = [&](std::string_view names, std::size_t index) {
        return names[(index + 3 - static_cast<std::size_t>(turns)) % 3];
    };
    std::string out;
    for (const char c : program) {
        if (c == 'p') out += "G1" + std::to_string(7 + turns);
        else if (c >= 'x' && c <= 'z') out += turned(kAxes, static_cast<std::size_t>(c - 'x'));
        else if (c >= 'i' && c <= 'k') out += turned(kCenters, static_cast<std::size_t>(c - 'i'));
        else out += c;
    }
    return out;
}

struct Planes : ::testing::Test {
    Sources sources = test::inputs().new_sources();
    DiagnosticList messages;
    std::optional<nc::Dialect> dialect =
        nc::load_dialect("sinumerik", {KADR_ROOT "/dialects"}, sources, messages);
    driver::Messages said{sources, {}, [](std::string_view) {}};
    driver::Session session{{}, test::inputs(), sources, said};

    std::vector<path::Command> run(const std::string& text) {
        driver::LibraryCycles cycles(session, *dialect);
        machine::Machine machine = mill();
        machine.work_offsets.clear();
        WholeText source(text);
        DiagnosticList heard;
        NcProgram program(*dialect, source, "test", {}, heard);
        Interpreter interpreter(*dialect, machine, program, &program, &cycles, {}, heard);
        program.follow(interpreter);
        std::vector<path::Command> all;
        std::vector<path::Command> batch(8);
        while (const std::size_t count = interpreter.pull(batch))
            all.insert(all.end(), batch.begin(),
                       batch.begin() + static_cast<std::ptrdiff_t>(count));
        for (const Diagnostic& message : heard.all())
            EXPECT_NE(message.severity, Severity::Alarm) << message.message() << '\n' << text;
        return all;
    }
};

constexpr std::string_view kHead = R"(p G90 G54 G94
T1 D1 M6
$TC_DP1[1,1]=120 $TC_DP3[1,1]=50 $TC_DP4[1,1]=3 $TC_DP6[1,1]=4
D1
S1000 M3 F500
G0 x0 y0 z50
)";

constexpr std::array<std::string_view, 7> kPrograms = {
    // a contour beside which the cutter goes, corners cut
    "G0 x-40 y-40 z0\nG41 G1 x0 y0 KONT\ny30 RND=3\nG2 x20 y50 i20 j0\nG1 x60 CHR=2\nG3 x70 y40 "
    "CR=10\n"
    "G1 y0 G451\nx0\nG40 x-40 y-40\n",
    // frames
    "TRANS x5 y6 z7\nAROT RPL=33\nG1 x10 z5\nASCALE x2 y2\nG1 x10 y0\nG3 x5 y5 i-5 j0\nAMIRROR "
    "x0\nG2 x0 y0 "
    "AR=90\n"
    "TRANS\nROT z20\nG1 x10 y-3\n",
    // polar words, arcs by other words
    "G111 x3 y-4\nG1 AP=10 RP=20\nG2 AP=100 RP=20\nG110 x3 y4\nG1 AP=30 RP=5 z3\nCT x5 y5\n"
    "G1 x20 ANG=30\nANG=10\nx50 y60 ANG=80\nG3 x0 y0 z-10 CR=50 TURN=1\n",
    // holes
    "MCALL CYCLE83(20,0,2,-25,,-8,,3,0,0,0.7,1)\nx10 "
    "y5\nHOLES1(5,6,20,10,12,4)\nHOLES2(0,0,30,10,0,5)\n"
    "MCALL\nCYCLE86(20,0,2,-10,,0,3,-0.5,0.2,1,45)\nM3\nCYCLE84(20,0,2,-10,,0,3,,1,0,200,0)\n",
    // pockets, a slot, a face, spigots
    "POCKET3(50,0,1,-4,40,30,6,10,5,20,2,0.2,0.1,400,100,0,21,5,0,0,0,2,1)\n"
    "POCKET4(50,0,1,-4,20,10,5,2,0.3,0.1,400,100,1,11,3)\n"
    "SLOT1(50,0,1,-3,,3,20,10,0,10,15,10,100,150,400,1.5,2,0.1,0)\n",
    "CYCLE71(50,3,2,0,0,0,40,30,15,1.5,5,2,0,400,31,2)\nCYCLE76(50,0,2,-4,,30,20,4,5,6,15,2,0.3,0."
    "2,400,100,0,1,50,40)\n"
    "CYCLE90(50,0,2,-10,,30,27,2,400,3,0,5,5)\n",
    // a pause of the compensation, lengths of the program's own, the working area
    "TOFFL=1.5 TOFFL[2]=0.5\nG26 x100\nG0 x-20 y-20 z0\nG1 G41 x0 y0\ny30\nCUTCONON\nx20 "
    "y50\nCUTCONOF\nx60\nG40 "
    "y80\n",
};

TEST_F(Planes, ArePreferredByNothing) {
    ASSERT_TRUE(dialect.has_value());
    for (const std::string_view program : kPrograms) {
        SCOPED_TRACE(program);
        const std::string text = std::string(kHead) + std::string(program) + "G0 z60\nM30\n";
        const std::vector<path::Command> first = run(in_plane(text, 0));
        EXPECT_GT(first.size(), 10u);
        for (int turns = 1; turns < 3; ++turns) {
            SCOPED_TRACE("G1" + std::to_string(7 + turns));
            const std::vector<path::Command> other = run(in_plane(text, turns));
            ASSERT_EQ(first.size(), other.size());
            for (std::size_t n = 0; n < first.size(); ++n) {
                const path::Command& a = first[n];
                const path::Command& b = other[n];
                ASSERT_EQ(a.op(), b.op()) << n;
                if (!a.is_motion()) continue;
                EXPECT_NEAR(a.motion().feed, b.motion().feed, 1e-6) << n;
                for (std::size_t i = 0; i < 3; ++i) {
                    const std::size_t axis = (i + 3 - static_cast<std::size_t>(turns)) % 3;
                    EXPECT_NEAR(a.motion().to[i], b.motion().to[axis], 1e-6) << n << " axis " << i;
                    if (a.op() != path::Op::Arc) continue;
                    const auto from = static_cast<Eigen::Index>(i);
                    const auto to = static_cast<Eigen::Index>(axis);
                    EXPECT_NEAR(a.motion().arc().center[from], b.motion().arc().center[to], 1e-6)
                        << n << " centre " << i;
                    EXPECT_NEAR(a.motion().arc().normal[from], b.motion().arc().normal[to], 1e-9)
                        << n << " normal " << i;
                }
            }
        }
    }
}

}  // namespace
}  // namespace kadr::interp::planes_test
