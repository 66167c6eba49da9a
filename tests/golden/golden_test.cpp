// Whole parts, one text a control, reviewed by a person. KADR_UPDATE=1 rewrites them for review.
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/common/process.h"
#include "tests/golden/parts.h"

namespace golden_test {

namespace {

using golden::Part;
namespace fs = std::filesystem;

class Golden : public ::testing::TestWithParam<Part> {};

TEST_P(Golden, TextPerControl) {
    for (const std::string& dialect : GetParam().dialects()) {
        SCOPED_TRACE(dialect);
        const ProcessResult result =
            run_process({KADR_BINARY, "expand", GetParam().source.string(), "-d", dialect});
        EXPECT_EQ(result.status, 0) << result.err;
        const auto file_of = golden::files_of(GetParam().name());
        if (std::getenv("KADR_UPDATE") != nullptr) {
            ASSERT_TRUE(golden::keep_text(dialect, result.out, file_of));
        }
        const fs::path file = golden::held_file(dialect, file_of);
        EXPECT_EQ(kadr::read_file(file.string()).value_or("(no golden text)"), result.out)
            << "the text for " << dialect << " changed; review it and run with KADR_UPDATE=1";
        EXPECT_FALSE(golden::stands_twice(dialect, file_of))
            << file << " is the text of the control that " << dialect << " extends: remove it";
    }
}

INSTANTIATE_TEST_SUITE_P(Parts, Golden, ::testing::ValuesIn(golden::all_parts()),
                         [](const auto& part) { return golden::name_of(part); });

}  // namespace

}  // namespace golden_test
