// Every program in docs/stdlib.md runs on every control.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/common/process.h"

namespace examples_test {

namespace {

namespace fs = std::filesystem;

TEST(Examples, OfTheLibrarysDocumentationRun) {
    const std::string text = kadr::read_file(fs::path(KADR_ROOT) / "docs/stdlib.md").value_or("");
    const fs::path file =
        fs::temp_directory_path() / ("kadr-docs-" + std::to_string(::getpid()) + ".kadr");
    int programs = 0;
    const std::string open = "```c\n";
    for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
        at += open.size();
        const std::size_t end = text.find("```", at);
        ASSERT_NE(end, std::string::npos);
        const std::string code = text.substr(at, end - at);
        at = end + 3;
        if (code.find("program ") == std::string::npos) continue;  // a few lines of one
        ++programs;
        ASSERT_TRUE(kadr::write_file_whole(file.string(), code));
        // A FANUC machining centre leaves it to the machine whether X is a diameter.
        const bool is_lathe = code.find("DIAMON") != std::string::npos;
        for (const char* dialect : {"sinumerik", is_lathe ? "fanuc-lathe" : "fanuc", "axioma"}) {
            const ProcessResult result =
                run_process({KADR_BINARY, "run", file.string(), "-d", dialect, "-m",
                             is_lathe ? "lathe" : "mill", "--summary", "json"});
            EXPECT_EQ(result.status, 0) << dialect << "\n" << code << result.err;
            EXPECT_EQ(result.err, "") << dialect << "\n" << code;
        }
    }
    EXPECT_GE(programs, 6);
    std::error_code ignored;
    fs::remove(file, ignored);
}

}  // namespace

}  // namespace examples_test
