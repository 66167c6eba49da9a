// Every row of the diagnostics K2xxx and K3xxx explains itself by a wrong and a right example: the
// wrong one must cause it, the right one must cause nothing. Rows whose examples are no programs
// are shown by tests of their own; tests/house/table_test.cpp sees to it.
#include "tests/common/examples.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "base/diagnostics/expand.h"
#include "base/diagnostics/sema.h"
#include "tests/sema/running.h"

namespace kadr::testing::examples_test {
namespace {

RunOptions small_limits() {
    RunOptions options;
    options.with_stdlib = true;
    options.file = KADR_ROOT "/tests/sema/tables/test.kadr";
    options.expand.limits.loop_turns = 100000;
    options.expand.limits.blocks = 1000;
    options.expand.limits.array_elements = 10000;
    options.expand.limits.heap_bytes = std::uint64_t{1} << 19;
    return options;
}

/// Examples are as short as they can be: that a variable is not read matters to one of them only.
Outcome without_unused(Outcome outcome, const DiagnosticRow& row) {
    if (&row == &diag::UnusedVariable) return outcome;
    for (std::size_t i = outcome.messages.size(); i-- > 0;) {
        if (!outcome.messages[i].ends_with(diag::UnusedVariable.code)) continue;
        outcome.messages.erase(outcome.messages.begin() + static_cast<std::ptrdiff_t>(i));
        outcome.texts.erase(outcome.texts.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return outcome;
}

/// `dialect fanuc;` in front.
std::string dialect_of(std::string_view example) {
    const std::string_view head = "dialect ";
    if (!example.starts_with(head)) return "iso";
    return std::string(example.substr(head.size(), example.find(';') - head.size()));
}

bool has_code(const Outcome& outcome, std::string_view code) {
    return std::any_of(outcome.messages.begin(), outcome.messages.end(),
                       [&](const std::string& message) { return message.ends_with(code); });
}

TEST(Examples, WrongOnesCauseTheMessageAndRightOnesNone) {
    for (const DiagnosticRow* row : all_diagnostics()) {
        const bool is_ours = row->code.starts_with("K2") || row->code.starts_with("K3");
        if (!is_ours || !is_program(row->wrong)) continue;
        SCOPED_TRACE(std::string(row->code) + ' ' + std::string(row->name));
        RunOptions options = small_limits();
        options.expand.warns_of_cuts =
            row == &diag::FeedNeverSet || row == &diag::FeedNotSet || row == &diag::DiameterNotSaid;
        if (row == &diag::FeedNotSet || row == &diag::CuttingSpeedNotSet)
            options.target = "sinumerik";
        if (row == &diag::TapByMoves) options.target = "fanuc-lathe";
        if (row == &diag::CurveIncrement) options.target = "fanuc";
        options.source = dialect_of(row->right);
        const Outcome wrong = without_unused(run(text_of(row->wrong), options), *row);
        EXPECT_TRUE(has_code(wrong, row->code))
            << row->wrong << "\ngives: " << wrong.all_messages();
        // One mistake, one message.
        EXPECT_EQ(wrong.messages.size(), 1u) << row->wrong << "\ngives: " << wrong.all_messages();
        if (!is_program(row->right)) continue;
        const Outcome right = without_unused(run(text_of(row->right), options), *row);
        EXPECT_EQ(right.all_messages(), "") << row->right;
    }
}

}  // namespace
}  // namespace kadr::testing::examples_test
