// Passing a corner is never slower than a stop there.
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/driver/scratch.h"

namespace stops_test {

namespace {

class Stops : public kadr::test::ScratchFolder {
  protected:
    /// Time of the motions, s, with these words at the head.
    double time_of(const std::string& head, const std::string& motions,
                   const std::string& machine) const {
        save("corner.mpf", head + "\nS6000 M3\n" + motions + "M30\n");
        const ProcessResult ran = kadr(
            {"run", "-d", "sinumerik", "-m", machine, file("corner.mpf"), "--summary", "json"});
        EXPECT_EQ(ran.status, 0) << ran.err;
        if (ran.status != 0) return 0;
        return nlohmann::json::parse(ran.out)["time_s"].get<double>();
    }
};

/// What bends freely has beside a rest what its axes leave at each speed, and must have it beside
/// a corner. The first one took 10 % longer than with a stop, the second one 17 %.
TEST_F(Stops, NoCornerBesideASplineIsSlower) {
    const std::vector<std::string> programs = {
        "G1 F20000\nBSPLINE X3 Y1\nX5 Y4\nX5 Y8\nG1 X-30 Y4\n",
        "G1 F20000 X8 Y4\nPOLY PO[X]=(-8.539,-2.6) PO[Y]=(5,9.2)\n",
        "G1 F20000\nPOLY PO[X]=(34,-3,-5) PO[Y]=(-7,-5)\nG1 X0 Y0\n",
        "G1 F500\nPOLY PO[X]=(9.9,-7) PO[Y]=(-1.4,-9,5.573)\nASPLINE X-1 Y8\nX-3.555 Y-6\n"
        "X-9.3 Y-3.98\nG1 X-6 Y8\nCSPLINE X5.146 Y-7.486\nX7 Y-4.5\n",
        "G1 F5000\nG2 X1.996 Y-3 CR=9.62\nG3 X1 Y-2 CR=9.84\nPOLY PO[X]=(-2.858,1) "
        "PO[Y]=(-2,-2.164)\n",
        "G1 F20000\nCSPLINE X2 Y-1.982\nBSPLINE X0.062 Y1\nX-2.6 Y-2.882\nX1 Y1.1\n"
        "POLY PO[X]=(1,0) PO[Y]=(-1,1.195)\nPOLY PO[X]=(0.069,-2.7,0.918) PO[Y]=(0.3,1)\n",
    };
    for (const std::string machine : {"mill", "mill-fast"}) {
        for (const std::string& program : programs) {
            const double stopped = time_of("G90 G60", program, machine);
            for (const std::string way : {"G64", "G641 ADIS=0.3", "G641 ADIS=1.5", "G642", "G645"})
                EXPECT_LE(time_of("G90 " + way, program, machine), 1.002 * stopped)
                    << machine << ", " << way << '\n'
                    << program;
        }
    }
}

}  // namespace

}  // namespace stops_test
