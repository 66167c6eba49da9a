// `kadr expand --parameters`: what of a program can be set, and within which range.
#include "driver/parameters.h"

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "base/disk_files.h"
#include "tests/common/process.h"

namespace kadr::driver::parameters_test {

namespace {

namespace fs = std::filesystem;

class Parameters : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("kadr-parameters-" + std::to_string(::getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    /// What `kadr expand --parameters…` answers for this text.
    ProcessResult list(const std::string& text,
                       std::vector<std::string> options = {"--parameters"}) {
        const std::string file = (folder_ / "part.kadr").string();
        EXPECT_TRUE(write_file_whole(file, text));
        std::vector<std::string> arguments = {KADR_BINARY, "expand", file};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return run_process(arguments, "");
    }
    fs::path folder_;
};

constexpr const char* kPlates =
    "enum side { left, right }\n"
    "const length most = 50mm;\n"
    "/// A plate with a corner cut.\n"
    "/// w, h  size of the plate,\n"
    "///       outside\n"
    "program plate(length w = 2*(10mm + 5mm), length h, side from = side.left,\n"
    "              bool mirrored = false, length? deep, string text = \"a)b\", int n = 3) {\n"
    "    require(w > 0mm && w <= most && (w - h)/2 <= 10mm, \"size\");\n"
    "    require(n >= 1);\n"
    "    h = h + 1mm;\n"
    "    require(h < 3mm, \"of the changed one\");\n"
    "    int holes = n*2;\n"
    "    require(holes < 8, \"of the body\");\n"
    "    G0 X=w Y=h Z=deep ?? 1mm;\n"
    "    if (mirrored && from == side.left) note(text);\n"
    "    M30;\n"
    "}\n"
    "program other() { M30; }\n";

TEST_F(Parameters, AreListedWithUnitsDefaultsAndRanges) {
    const ProcessResult listed = list(kPlates);
    EXPECT_EQ(listed.status, 0) << listed.err;
    EXPECT_EQ(
        listed.out,
        "program plate\n"
        "  A plate with a corner cut.\n"
        "  parameter  type     unit  default         range           meaning\n"
        "  w          length   mm    2*(10mm + 5mm)  > 0mm, <= most  size of the plate, outside\n"
        "  h          length   mm    needed                          size of the plate, outside\n"
        "  from       side           side.left       left, right\n"
        "  mirrored   bool           false           true, false\n"
        "  deep       length?  mm    none\n"
        "  text       string         \"a)b\"\n"
        "  n          int            3               >= 1\n"
        "  and (w - h)/2 <= 10mm\n"
        "\n"
        "program other\n"
        "  no parameters\n");
}

TEST_F(Parameters, OfAnInchFileAreInInches) {
    const ProcessResult listed =
        list("units inch;\nprogram p(length w = 1, feed f = 10) { G1 X=w F=f; M30; }\n");
    EXPECT_TRUE(listed.out.find("  w          length  in      1\n") != std::string::npos)
        << listed.out;
    EXPECT_TRUE(listed.out.find("  f          feed    in/min  10\n") != std::string::npos)
        << listed.out;
}

TEST_F(Parameters, AreOneJsonObject) {
    const ProcessResult listed = list(kPlates, {"--parameters=json", "--program", "plate"});
    EXPECT_EQ(listed.status, 0) << listed.err;
    const auto json = nlohmann::json::parse(listed.out);
    ASSERT_EQ(json["programs"].size(), 1u);
    const auto& parameters = json["programs"][0]["parameters"];
    ASSERT_EQ(parameters.size(), 7u);
    EXPECT_EQ(
        parameters[0]["bounds"],
        nlohmann::json::parse(R"([{"is": ">", "value": "0mm"}, {"is": "<=", "value": "most"}])"));
    EXPECT_EQ(parameters[1]["required"], true);
    EXPECT_TRUE(parameters[1]["default"].is_null());
    EXPECT_EQ(parameters[2]["values"], nlohmann::json::parse(R"(["left", "right"])"));
    EXPECT_EQ(parameters[4]["required"], false);
    EXPECT_EQ(json["programs"][0]["conditions"], nlohmann::json::parse(R"(["(w - h)/2 <= 10mm"])"));
}

TEST_F(Parameters, WhatCannotBeListedIsSaid) {
    const ProcessResult none = list("cycle c() { G0 X1; }\n");
    EXPECT_EQ(none.status, 1);
    EXPECT_TRUE(none.err.find("[K3001]") != std::string::npos) << none.err;
    const ProcessResult unknown = list(kPlates, {"--parameters", "--program", "third"});
    EXPECT_EQ(unknown.status, 1);
    EXPECT_TRUE(unknown.err.find("the file has: plate, other") != std::string::npos) << unknown.err;
    const ProcessResult wrong = list("program p(length w = nothing) { G0 X=w; M30; }\n");
    EXPECT_EQ(wrong.status, 1);
    EXPECT_EQ(wrong.out, "");
    EXPECT_EQ(list(kPlates, {"--parameters", "-D", "w=3mm"}).status, 2);
    EXPECT_EQ(list(kPlates, {"--parameters=xml"}).status, 2);
}

/// The programs of a file are its own: what it imports is not for the command line.
TEST_F(Parameters, OfImportsAreNotListed) {
    EXPECT_TRUE(write_file_whole((folder_ / "shared.kadr").string(),
                                 "program inner(int k = 1) { G0 X=k; M30; }\n"
                                 "enum kind { flat, round }\n"));
    const ProcessResult listed = list(
        "import \"shared.kadr\";\nprogram p(kind k = kind.flat) {\n"
        "    if (k == kind.round) G0 X1;\n    M30;\n}\n");
    EXPECT_EQ(listed.out,
              "program p\n  parameter  type  default    range\n"
              "  k          kind  kind.flat  flat, round\n")
        << listed.err;
}

}  // namespace

}  // namespace kadr::driver::parameters_test
