// The sink behind a session: renders, counts, and does not drown the reader.
#include "driver/messages.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/diagnostics/driver.h"
#include "base/diagnostics/sema.h"

namespace messages_test {

namespace {

using namespace kadr;
using driver::MessageFormat;
using driver::Messages;

class MessageSink : public ::testing::Test {
  protected:
    Messages make(MessageFormat format, std::size_t repeats = 20) {
        return {sources_, {format, false, repeats}, [this](std::string_view text) {
                    said_.emplace_back(text);
                }};
    }
    Sources sources_;
    std::vector<std::string> said_;
};

TEST_F(MessageSink, RendersAsTheyCome) {
    const FileId file = sources_.add("part.kadr", "import a.b;\n");
    Messages messages = make(MessageFormat::Text);
    messages.report(diag::ModuleMissing, {file, 7, 10}).arg("a.b");
    ASSERT_EQ(said_.size(), 1u);
    EXPECT_EQ(said_[0],
              "part.kadr:1:8: error[K9003]: no module `a.b` is found\n"
              "   1 | import a.b;\n"
              "     |        ^~~\n");
}

TEST_F(MessageSink, JsonIsOneObjectALine) {
    Messages messages = make(MessageFormat::Json);
    messages.report(diag::FileUnreadable).arg("a\"b\n.kadr");
    ASSERT_EQ(said_.size(), 1u);
    EXPECT_EQ(said_[0].find('\n'), said_[0].size() - 1);
    EXPECT_EQ(nlohmann::json::parse(said_[0])["message"], "cannot read `a\"b\n.kadr`");
}

TEST_F(MessageSink, SaysTheSameOnce) {
    Messages messages = make(MessageFormat::Text);
    for (int i = 0; i < 3; ++i) messages.report(diag::FileUnreadable).arg("a");
    EXPECT_EQ(said_.size(), 1u);
    EXPECT_EQ(messages.errors(), 1u);
}

TEST_F(MessageSink, CountsWhatItLeavesOut) {
    Messages messages = make(MessageFormat::Text, 2);
    for (int i = 0; i < 1000; ++i) messages.report(diag::EndedByAlarm).arg(i);
    messages.report(diag::FileUnreadable).arg("a");
    messages.finish();
    ASSERT_EQ(said_.size(), 4u);
    EXPECT_EQ(said_[3],
              "warning[K9008]: 998 more messages K9007 are not shown\n");  // diag::MessagesLeftOut
    EXPECT_EQ(messages.warnings(), 1000u);
    EXPECT_EQ(messages.errors(), 1u);
}

TEST_F(MessageSink, KeepsTheFirstAlarm) {
    Messages messages = make(MessageFormat::Text);
    EXPECT_EQ(messages.first_alarm(), "");
    messages.report(diag::FileUnreadable, TextLocation{"part.mpf", 12, 5, 1, "G1 X10"})
        .arg("a")
        .alarm("14040", "end point");
    messages.report(diag::FileUnreadable, TextLocation{"part.mpf", 13, 5, 1, "G1 X11"})
        .arg("a")
        .alarm("10", "other");
    EXPECT_EQ(messages.alarms(), 2u);
    EXPECT_EQ(messages.first_alarm(), "part.mpf:12:5: alarm[14040]: end point: cannot read `a`");
}

TEST_F(MessageSink, WarningsAreSilencedWhereTheyStand) {
    const FileId file = sources_.add("part.kadr",
                                     "length a;  // kadr: allow K2501 why\n"
                                     "length b;\n"
                                     "  // kadr: allow K2501, K2502\n"
                                     "length c;\n"
                                     "note \"// kadr: allow K2501\"; length d;\n");
    Messages messages = make(MessageFormat::Text);
    const std::string_view text = sources_.text(file);
    for (const char name : {'a', 'b', 'c', 'd'}) {
        const auto at = static_cast<std::uint32_t>(text.find(std::string("length ") + name));
        messages.report(diag::UnusedVariable, {file, at, at + 6}).arg(std::string(1, name));
    }
    EXPECT_EQ(messages.warnings(),
              2u);  // b: only a comment alone in its line reaches down; d: text
    // An error is never silenced.
    messages.report(diag::UnknownName, {file, 0, 6}).arg("a");
    EXPECT_EQ(messages.errors(), 1u);
    // A line that a statement wrote is silenced at the statement.
    TextLocation location{"part.nc", 7, 1, 1, "X5"};
    messages.report(diag::UnusedVariable, location).arg("e").note({file, 0, 6}, "written here");
    EXPECT_EQ(messages.warnings(), 2u);
    messages.report(diag::UnusedVariable, location).arg("e").note({file, 40, 41}, "written here");
    EXPECT_EQ(messages.warnings(), 3u);
}

}  // namespace

}  // namespace messages_test
