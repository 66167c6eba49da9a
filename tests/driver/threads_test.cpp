// `kadr run --threads`: the same outputs to the last byte, and an end of every thread.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/driver/scratch.h"

namespace threads_test {

namespace {

using kadr::read_file;

class Threads : public kadr::test::ScratchFolder {
  protected:
    struct Outcome {
        int status = 0;
        std::string out;
        std::string err;
        std::string setpoints;
        std::string curves;
    };

    /// The same run, whose outputs have the same names: they are told in messages.
    Outcome run(const std::string& threads, std::vector<std::string> arguments,
                const std::string& kind = "csv") {
        const std::string setpoints = file("setpoints." + kind);
        arguments.insert(arguments.begin(), "run");
        arguments.insert(arguments.end(), {"--threads", threads, "--setpoints", setpoints,
                                           "--curves", file("curves.svg"), "--summary", "json"});
        const ProcessResult result = kadr(arguments);
        Outcome outcome{result.status, result.out, result.err,
                        read_file(setpoints).value_or("none"),
                        read_file(file("curves.svg")).value_or("none")};
        std::filesystem::remove(setpoints);
        std::filesystem::remove(file("curves.svg"));
        return outcome;
    }

    void expect_same(const std::vector<std::string>& arguments, int status,
                     const std::string& kind = "csv") {
        const Outcome off = run("off", arguments, kind);
        const Outcome on = run("on", arguments, kind);
        EXPECT_EQ(off.status, status) << off.err;
        EXPECT_EQ(on.status, status) << on.err;
        EXPECT_EQ(on.out, off.out);
        EXPECT_EQ(on.err, off.err);
        EXPECT_TRUE(on.setpoints == off.setpoints);
        EXPECT_TRUE(on.curves == off.curves);
    }
};

std::string example(const std::string& name) {
    return std::string(KADR_ROOT) + "/examples/" + name + ".kadr";
}

TEST_F(Threads, TheOutputsAreTheSame) {
    expect_same({example("bracket"), "-d", "fanuc"}, 0);
    expect_same({example("pin"), "-d", "sinumerik", "-m", "lathe"}, 0, "npy");
    expect_same({example("dots"), "-d", "sinumerik", "-m", "laser"}, 0);
    expect_same({example("fields"), "-d", "fanuc", "-m", "scanner", "--tick", "0.2ms"}, 0);
}

/// Lines of called programs are those of their files, whichever thread asks.
TEST_F(Threads, LinesOfCalledPrograms) {
    save("O0001.NC", "G21 G90 G94\nM98 P2\nM98 P2\nM30\n");
    save("O0002.NC", "G91 G1 X1. F500\nY1.\nG90 M99\n");
    expect_same({file("O0001.NC"), "-d", "fanuc"}, 0);
    const Outcome on = run("on", {file("O0001.NC"), "-d", "fanuc"});
    EXPECT_NE(on.setpoints.find(",2\n"), std::string::npos) << "line 2 of O0002.NC";
    EXPECT_EQ(on.setpoints.find(",2147"), std::string::npos);
}

/// What came before an alarm is kept, an endless program ends in time, an error leaves no file.
TEST_F(Threads, EveryEndEndsThem) {
    std::string text = "G21 G90 G94 F5000\n";
    for (int i = 0; i < 2000; ++i) text += i % 2 == 0 ? "G1 X10.\n" : "G1 X0.\n";
    save("far.nc", text + "G1 X9999.\nM30\n");
    expect_same({file("far.nc"), "-d", "fanuc"}, 3);
    EXPECT_TRUE(run("on", {file("far.nc"), "-d", "fanuc"}).setpoints.ends_with("\n"));

    save("endless.nc", "G21 G90 G94 F5000\nN10 G1 X10.\nG1 X0.\nGOTO 10\nM30\n");
    // Stopped by time they are not at the same place: alarm, and files that say so.
    for (const char* threads : {"on", "off"}) {
        const Outcome endless =
            run(threads, {file("endless.nc"), "-d", "fanuc", "--max-time", "0.2s"});
        EXPECT_EQ(endless.status, 3);
        EXPECT_NE(endless.setpoints.find("\n# not complete, ended by "), std::string::npos);
    }
    expect_same({file("endless.nc"), "-d", "fanuc", "--max-blocks", "500"}, 3);

    // One block of 11 days has 10^9 setpoints.
    save("long.nc", "G21 G90 G94\nG4 X1000000.\nM30\n");
    for (const char* threads : {"on", "off"}) {
        const Outcome long_one =
            run(threads, {file("long.nc"), "-d", "fanuc", "--max-time", "0.2s"});
        EXPECT_EQ(long_one.status, 3);
        EXPECT_NE(long_one.setpoints.find("\n# not complete, ended by "), std::string::npos);
    }

    // An error leaves no file, and nobody waits for it.
    save("wrong.kadr", "program p() {\n    G1 X1 F100;\n    require(1 > 2, \"never\");\n}\n");
    expect_same({file("wrong.kadr"), "-d", "fanuc"}, 1);
    EXPECT_EQ(run("on", {file("wrong.kadr"), "-d", "fanuc"}).setpoints, "none");
}

/// Who looks on sees one thing after the other.
TEST_F(Threads, ABreakIsNotRunPast) {
    save("two.nc", "G21 G90 G94 F500\nG1 X1.\nN20 G1 X2.\nM30\n");
    expect_same({file("two.nc"), "-d", "fanuc", "--until", "N20"}, 0);
}

TEST_F(Threads, NothingElseThanOnOrOff) {
    EXPECT_EQ(kadr({"run", example("bracket"), "--threads", "two"}).status, 2);
}

}  // namespace

}  // namespace threads_test
