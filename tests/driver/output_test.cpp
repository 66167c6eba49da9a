// Results are written whole or not at all.
#include "driver/output.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/diagnostics/driver.h"
#include "base/disk_files.h"
#include "base/text.h"
#include "driver/output_names.h"

namespace output_test {

namespace {

namespace fs = std::filesystem;
using namespace kadr;
using driver::Output;

class Outputs : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("kadr-output-" + std::to_string(::getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string file(const std::string& name) const { return (folder_ / name).string(); }
    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

    fs::path folder_;
    DiagnosticList sink_;
};

TEST_F(Outputs, AppearWhenCommitted) {
    const auto output = Output::open(disk(), file("a.nc"), sink_);
    ASSERT_TRUE(output);
    output->write("G0 X1\n");
    EXPECT_FALSE(fs::exists(file("a.nc")));
    EXPECT_TRUE(output->commit(sink_));
    EXPECT_EQ(read_file(file("a.nc")), "G0 X1\n");
    EXPECT_EQ(files(), 1u);
}

TEST_F(Outputs, LeaveNoTraceWhenDropped) {
    ASSERT_TRUE(write_file_whole(file("a.nc"), "old"));
    {
        const auto output = Output::open(disk(), file("a.nc"), sink_);
        ASSERT_TRUE(output);
        output->write(std::string(1 << 20, 'x'));  // more than any buffer holds
    }
    EXPECT_EQ(read_file(file("a.nc")), "old");
    EXPECT_EQ(files(), 1u);
}

TEST_F(Outputs, KeepPermissionsAndLinks) {
    ASSERT_TRUE(write_file_whole(file("real.nc"), "old"));
    fs::permissions(file("real.nc"), fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("real.nc", file("link.nc"));
    const auto output = Output::open(disk(), file("link.nc"), sink_);
    ASSERT_TRUE(output);
    output->write("new");
    EXPECT_TRUE(output->commit(sink_));
    EXPECT_TRUE(fs::is_symlink(file("link.nc")));
    EXPECT_EQ(read_file(file("real.nc")), "new");
    EXPECT_EQ(fs::status(file("real.nc")).permissions(),
              fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(Outputs, UnwritablePlacesAreReportedBeforeWork) {
    fs::create_directories(file("folder"));
    for (const std::string& text : {file("missing/a.nc"), file("folder")}) {
        SCOPED_TRACE(text);
        DiagnosticList sink;
        EXPECT_EQ(Output::open(disk(), text, sink), nullptr);
        ASSERT_EQ(sink.all().size(), 1u);
        EXPECT_EQ(sink.all()[0].row, &diag::FileUnwritable);
    }
}

TEST_F(Outputs, FullDiskIsReported) {
    if (!fs::exists("/dev/full")) GTEST_SKIP();
    const auto output = Output::open(disk(), "/dev/full", sink_);
    ASSERT_TRUE(output);
    output->write("G0 X1\n");
    EXPECT_FALSE(output->commit(sink_));
    EXPECT_EQ(sink_.errors(), 1u);
}

TEST_F(Outputs, AreHeldApart) {
    ASSERT_TRUE(write_file_whole(file("part.kadr"), ""));
    const std::string source = file("part.kadr");
    struct Row {
        const char* name;
        std::vector<std::string> outputs;
        const DiagnosticRow* expected;
    };
    for (const Row& row : {Row{"different", {file("a"), file("b"), ""}, nullptr},
                           Row{"the source",
                               {file("../" + folder_.filename().string() + "/part.kadr")},
                               &diag::OutputIsSource},
                           Row{"twice", {file("a"), "", file("./a")}, &diag::OutputTwice},
                           Row{"standard output twice", {"-", "-"}, &diag::OutputTwice},
                           Row{"nowhere twice", {"/dev/null", "/dev/null"}, nullptr}}) {
        SCOPED_TRACE(row.name);
        DiagnosticList sink;
        EXPECT_EQ(
            static_cast<bool>(driver::require_outputs_apart(disk(), source, row.outputs, sink)),
            row.expected == nullptr);
        const bool is_refused = row.expected != nullptr;
        ASSERT_EQ(sink.all().size(), is_refused ? 1u : 0u);
        if (is_refused) {
            EXPECT_EQ(sink.all()[0].row, row.expected);
        }
    }
}

}  // namespace

}  // namespace output_test
