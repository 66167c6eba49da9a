// Whole parts, one text a control, reviewed by a person. KADR_UPDATE=1 rewrites them for review.
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

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
        const fs::path file = fs::path(KADR_ROOT) / "tests/golden/texts" /
                              (GetParam().name() + "." + dialect + ".txt");
        if (std::getenv("KADR_UPDATE") != nullptr) {
            fs::create_directories(file.parent_path());
            ASSERT_TRUE(kadr::write_file_whole(file.string(), result.out));
        }
        EXPECT_EQ(kadr::read_file(file.string()).value_or("(no golden text)"), result.out)
            << "the text for " << dialect << " changed; review it and run with KADR_UPDATE=1";
    }
}

INSTANTIATE_TEST_SUITE_P(Parts, Golden, ::testing::ValuesIn(golden::all_parts()),
                         [](const auto& part) { return golden::name_of(part); });

}  // namespace

}  // namespace golden_test
