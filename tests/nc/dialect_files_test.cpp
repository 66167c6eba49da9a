// Every shipped dialect loads, every example beside an entry is true in both directions, and every
// alarm names a diagnostic.
#include <gtest/gtest.h>

#include "nc/reader.h"
#include "nc/tables.h"
#include "nc/writer.h"
#include "tests/nc/nc_testing.h"

namespace kadr::nc {
namespace {

constexpr std::array<const char*, 4> kShipped = {"iso", "sinumerik", "fanuc", "axioma"};

TEST(DialectFiles, Load) {
    for (const char* name : kShipped) {
        const Dialect& dialect = testing::shipped(name);
        EXPECT_EQ(dialect.name(), name);
        EXPECT_FALSE(dialect.title().empty());
        EXPECT_EQ(dialect.cycles().size(), testing::shipped("iso").cycles().size());
        EXPECT_EQ(dialect.power_on(Group::Distance), Function::Absolute);
    }
}

/// What a block is written as under a known start, without the lines of the frame.
std::string written(const Dialect& dialect, const Block& block) {
    DiagnosticList sink;
    Writer writer(dialect, {.number_blocks = false}, sink);
    std::string text;
    writer.begin({"test", 1, "", false}, text);
    // Another motion before, so that the example's own is written.
    Block before;
    before.motion = block.motion == Function::Rapid ? Function::Line : Function::Rapid;
    writer.write(before, text);
    text.clear();
    writer.write(block, text);
    for (const Diagnostic& one : sink.all()) text += one.message() + '\n';
    return text.empty() ? text : text.substr(0, text.size() - 1);
}

std::string described(const Dialect& dialect, const std::string& text) {
    std::string all;
    for (const Block& block : testing::read_blocks(dialect, text).blocks) {
        if (!all.empty()) all += '\n';
        all += describe(block);
    }
    return all;
}

TEST(DialectFiles, ExamplesAreTrue) {
    for (const char* name : kShipped) {
        const Dialect& dialect = testing::shipped(name);
        EXPECT_FALSE(dialect.tables().examples.empty());
        for (const Example& example : dialect.tables().examples) {
            SCOPED_TRACE(std::string(name) + ": " + example.source);
            const Block block = testing::source_block(testing::shipped("iso"), example.source);
            EXPECT_EQ(written(dialect, block), example.text);
            EXPECT_EQ(described(dialect, example.text),
                      example.block.empty() ? describe(block) : example.block);
        }
    }
}

}  // namespace
}  // namespace kadr::nc
