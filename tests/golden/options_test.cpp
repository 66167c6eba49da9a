// A control that was bought without an option gets no word of it: neither the function nor its
// reset.
#include <string>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "tests/common/process.h"
#include "tests/common/scratch.h"
#include "tests/golden/parts.h"

namespace golden::options_test {

namespace {

const std::string kWithout = KADR_ROOT "/tests/golden/fanuc-without-options.xml";

}  // namespace

TEST(ControlsWithoutOptions, LoadWhatDoesNotUseThem) {
    std::size_t loaded = 0;
    for (const Part& part : parts_of(fs::path(KADR_ROOT) / "examples")) {
        if (part.machine != "mill") continue;
        SCOPED_TRACE(part.name());
        const ProcessResult with =
            run_process({KADR_BINARY, "expand", part.source.string(), "-d", "fanuc"});
        if (with.status != 0) continue;  // not for a FANUC
        const ProcessResult made =
            run_process({KADR_BINARY, "expand", part.source.string(), "-d", kWithout});
        ASSERT_EQ(made.status, 0) << made.err;
        for (const char* code : {"G50", "G51", "G50.1", "G51.1", "G68", "G69"})
            EXPECT_EQ(made.out.find(code), std::string::npos) << code;
        const std::string file = kadr::testing::scratch("loaded.nc");
        EXPECT_TRUE(kadr::write_file_whole(file, made.out));
        const ProcessResult run = run_process({KADR_BINARY, "run", file, "-d", kWithout});
        EXPECT_EQ(run.status, 0) << run.err;
        ++loaded;
    }
    EXPECT_GE(loaded, 8u);
}

TEST(ControlsWithoutOptions, RefuseWhatUsesThem) {
    const std::string file = kadr::testing::scratch("turned.kadr");
    EXPECT_TRUE(kadr::write_file_whole(
        file, "program turned() { tool(1); with rotate(30deg) { G0 X10 Y0; } M30; }\n"));
    const ProcessResult with = run_process({KADR_BINARY, "expand", file, "-d", "fanuc"});
    EXPECT_EQ(with.status, 0) << with.err;
    EXPECT_NE(with.out.find("G69\nG00 G17"), std::string::npos) << with.out;
    const ProcessResult without = run_process({KADR_BINARY, "expand", file, "-d", kWithout});
    EXPECT_EQ(without.status, 1);
    EXPECT_NE(without.err.find("K4201"), std::string::npos) << without.err;
}

}  // namespace golden::options_test
