// The <pipeline> of a machine file: sizes of stages change nothing, its output and modules are
// used.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/driver/scratch.h"

namespace pipeline_test {

namespace {

namespace fs = std::filesystem;

class PipelineRun : public kadr::test::ScratchFolder {
  protected:
    /// The stock mill with this element.
    std::string machine(const std::string& pipeline) {
        std::string text = kadr::read_file(KADR_ROOT "/runtime/machines/mill.xml").value_or("");
        text.insert(text.rfind("</machine>"), pipeline);
        save("m.xml", text);
        return file("m.xml");
    }
    std::string setpoints(const std::string& pipeline, const std::string& threads) {
        const std::string out = file("out.csv");
        const ProcessResult result =
            kadr({"run", KADR_ROOT "/examples/bracket.kadr", "-d", "fanuc", "-m", machine(pipeline),
                  "--threads", threads, "--setpoints", out});
        EXPECT_EQ(result.status, 0) << result.err;
        std::string text = kadr::read_file(out).value_or("none");
        fs::remove(out);
        return text;
    }
};

TEST_F(PipelineRun, StagesAndQueuesChangeNoSetpoint) {
    const std::string plain = setpoints("", "off");
    ASSERT_GT(plain.size(), 100000u);
    for (const char* pipeline :
         {"<pipeline><translate batch=\"1\" queue=\"1\"/><interpolate period=\"1 ms\" queue=\"1\"/>"
          "<output period=\"1 ms\"/></pipeline>",
          "<pipeline><translate period=\"3 ms\" batch=\"500\" queue=\"100\"/><interpolate "
          "period=\"7 ms\" queue=\"3\"/><output period=\"1 s\"/></pipeline>",
          "<pipeline><translate period=\"10 s\"/><output period=\"123 ms\"/></pipeline>"}) {
        for (const char* threads : {"off", "on"}) {
            EXPECT_TRUE(setpoints(pipeline, threads) == plain) << pipeline << ' ' << threads;
        }
    }
}

TEST_F(PipelineRun, WritesItsOwnOutput) {
    save("part.mpf", "G17 G90 G71 F3000\nT1 D1\nS5000 M3\nG1 X10\nM30\n");
    const fs::path before = fs::current_path();
    fs::current_path(fs::path(file("part.mpf")).parent_path());
    const std::string name = machine(
        "<pipeline><output file=\"log-{program}.csv\" columns=\"iso t X tip\"/></pipeline>");
    const ProcessResult result =
        kadr({"run", "part.mpf", "-d", "sinumerik", "-m", name, "--summary", "json"});
    EXPECT_EQ(result.status, 0) << result.err;
    const std::string text = kadr::read_file("log-part.csv").value_or("");
    EXPECT_TRUE(text.starts_with("iso,t,X,tip_x,tip_y,tip_z\n")) << text.substr(0, 80);
    EXPECT_GT(nlohmann::json::parse(result.out)["setpoints"], 10);
    fs::remove("log-part.csv");
    // The command line has the last word on where, the file on which columns.
    kadr({"run", "part.mpf", "-d", "sinumerik", "-m", name, "--setpoints", "mine.csv"});
    EXPECT_FALSE(fs::exists("log-part.csv"));
    EXPECT_TRUE(kadr::read_file("mine.csv").value_or("").starts_with("iso,t,X,tip_x"));
    // It must not be the source.
    save("log.csv", "G17 G90 G71 F3000\nT1 D1\nS5000 M3\nG1 X10\nM30\n");
    const ProcessResult clash =
        kadr({"run", "log.csv", "-d", "sinumerik", "-m",
              machine("<pipeline><output file=\"{program}.csv\"/></pipeline>")});
    EXPECT_EQ(clash.status, 2) << clash.err;
    fs::current_path(before);
}

TEST_F(PipelineRun, ServesCommandsByNone) {
    save("part.mpf", "G17 G90 G71 F3000\nT1 D1\nS5000 M3\nG1 X10\nG4 F7\nX20\nM30\n");
    const auto time = [&](const std::string& pipeline) {
        const ProcessResult result = kadr({"run", file("part.mpf"), "-d", "sinumerik", "-m",
                                           machine(pipeline), "--summary", "json"});
        EXPECT_EQ(result.status, 0) << result.err;
        return nlohmann::json::parse(result.out)["time_s"].get<double>();
    };
    EXPECT_NEAR(time("") - time("<pipeline><serve command=\"dwell\" by=\"none\"/></pipeline>"), 7,
                0.1);
}

TEST_F(PipelineRun, ModulesThatNobodyHasAreSaid) {
    const std::string name =
        machine("<pipeline><serve command=\"dwell\" by=\"press\"/></pipeline>");
    for (const ProcessResult& result :
         {kadr({"machine", "check", name}),
          kadr({"run", KADR_ROOT "/examples/bracket.kadr", "-m", name})}) {
        EXPECT_EQ(result.status, 2);
        EXPECT_NE(result.err.find("K6243"), std::string::npos) << result.err;
        EXPECT_NE(result.err.find("`none`, `scanner`"), std::string::npos) << result.err;
    }
}

}  // namespace

}  // namespace pipeline_test
