// The properties of the library's cycles that are written in Kadr, in the folder properties/: each
// is run for every control, over random parameters.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "tests/common/process.h"

namespace properties_test {

namespace {

namespace fs = std::filesystem;

TEST(Properties, OfTheLibraryHold) {
    int files = 0;
    for (const auto& entry :
         fs::directory_iterator(fs::path(KADR_ROOT) / "tests/stdlib/properties")) {
        if (entry.path().extension() != ".kadr") continue;
        ++files;
        const ProcessResult result =
            run_process({KADR_BINARY, "test", entry.path().string(), "--runs", "60"});
        EXPECT_EQ(result.status, 0) << result.out << result.err;
    }
    EXPECT_GE(files, 4);
}

}  // namespace

}  // namespace properties_test
