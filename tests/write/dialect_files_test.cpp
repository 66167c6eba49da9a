// Every shipped dialect loads, every example beside an entry is true in both directions, and every
// alarm names a diagnostic.
#include <algorithm>

#include <gtest/gtest.h>

#include "tests/nc/nc_testing.h"
#include "write/check.h"

namespace kadr::write::dialect_files_test {

using namespace nc;
namespace testing = nc::testing;

namespace {

constexpr std::array<const char*, 7> kShipped = {
    "iso", "sinumerik", "fanuc", "fanuc-lathe", "fanuc-lathe-b", "fanuc-lathe-c", "axioma"};

TEST(DialectFiles, Load) {
    for (const char* name : kShipped) {
        const Dialect& dialect = testing::shipped(name);
        EXPECT_EQ(dialect.name(), name);
        EXPECT_FALSE(dialect.title().empty());
        // Its own cycles, each with its file, stand behind those of the common core.
        const auto shared = std::ranges::count_if(
            dialect.cycles(), [](const CycleInfo& cycle) { return cycle.file.empty(); });
        EXPECT_EQ(static_cast<std::size_t>(shared), testing::shipped("iso").cycles().size());
        EXPECT_EQ(dialect.power_on(Group::Distance), Function::Absolute);
    }
}

std::string messages_of(const DiagnosticList& list) {
    std::string all;
    for (const Diagnostic& one : list.all()) all += one.message() + '\n';
    return all;
}

TEST(DialectFiles, FramesReadBack) {
    for (const char* name : kShipped) {
        DiagnosticList wrong;
        check_frame(testing::shipped(name), wrong);
        EXPECT_EQ(messages_of(wrong), "") << name;
    }
}

TEST(DialectFiles, ExamplesAreTrue) {
    for (const char* name : kShipped) {
        const Dialect& dialect = testing::shipped(name);
        EXPECT_FALSE(dialect.examples().empty());
        for (const Example& example : dialect.examples()) {
            if (!example.gives.empty()) continue;  // a program, which the interpreter runs
            SCOPED_TRACE(std::string(name) + ": " + example.source + example.text);
            std::vector<Block> blocks;
            if (!example.source.empty())
                blocks = {testing::source_block(testing::shipped("iso"), example.source)};
            DiagnosticList wrong;
            check_example(dialect, example, blocks, wrong);
            EXPECT_EQ(messages_of(wrong), "");
        }
    }
}

}  // namespace
}  // namespace kadr::write::dialect_files_test
