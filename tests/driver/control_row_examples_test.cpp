// What `kadr explain` shows for the rows about the controls' own texts (K5): the wrong example
// gives the row's message, the right one neither that nor any error.
//
// An example stands behind a tool, a spindle, a feed and a place, unless the row is about one of
// those (kAtTheHead), and the cutter of tool 1 has a radius of 5 mm. A remark behind a block, `; on
// a FANUC lathe`, says which control is meant; else its words do. A tool in a remark stands in the
// machine.
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/diagnostic.h"
#include "base/disk_files.h"
#include "base/text.h"
#include "tests/common/messages.h"
#include "tests/common/process.h"
#include "tests/common/scratch.h"

namespace control_row_examples_test {

namespace {

namespace fs = std::filesystem;
using kadr::DiagnosticRow;
using kadr::testing::Message;

/// What nothing may stand in front of; nor in front of declarations.
const std::set<std::string_view> kAtTheHead = {"K5024", "K5210", "K5213", "K5214", "K5217",
                                               "K5228", "K5243", "K5265", "K5270", "K5453",
                                               "K5774", "K5903", "K5923", "K5924"};

/// What cannot be run as it stands; tests of their own cause these messages.
const std::set<std::string_view> kNotRun = {
    "K5016", "K5017", "K5436",  // described: lines too long to show
    "K5201", "K5202",           // XML of a dialect
    "K5251", "K5252",           // without the library; Kadr's own language
    "K5443", "K5262", "K5263",  // command lines
    "K5439", "K5440", "K5441",  // what takes long
    "K5549",                    // every stock machine has Z
    "K5907", "K5921",           // a run without -m, `kadr check`
    "K5952", "K5953", "K5954",  // events of a run, machines with a probe
};
/// Rows whose right example is another command, an alarm on purpose, calls a program that is not
/// shown, or is for another machine.
const std::set<std::string_view> kOnlyWrong = {"K5451", "K5460", "K5476", "K5540",
                                               "K5541", "K5776", "K5950", "K5951"};
/// Rows about the end of the text.
const std::set<std::string_view> kOwnEnd = {"K5260", "K5261"};

struct Control {
    std::string dialect, suffix, machine, head;
    bool has_c = false;             // the machine has an axis C
    bool has_two_spindles = false;  // … a second spindle
};

Control control_of(const std::string& example) {
    const std::string mill = "mill.xml";
    const auto has = [&](const char* word) { return example.find(word) != std::string::npos; };
    const auto matches = [&](const char* pattern) {
        return std::regex_search(example, std::regex(pattern, std::regex::multiline));
    };
    if (has("common core")) return {"iso", ".ngc", mill, "T1 M6\nS1000 M3\nG0 X0 Y0 Z50 F200\n"};
    if (has("HEIDENHAIN"))
        return {KADR_ROOT "/examples/dialects/heidenhain-iso.xml", ".i", mill, ""};
    const std::string driven = "lathe-c.xml";
    if (matches("^G(12|07)\\.1"))
        return {"fanuc-lathe", ".nc", driven, "T0101\nG97 S1000 M3\nG98 F200\nG0 X100. Z50. C0\n"};
    if (matches("^(TRANSMIT|TRACYL)") && !has("without"))
        return {"sinumerik", ".mpf", driven, "T1 D1 M6\nS1000 M3\nG0 X100 Z50 C0 F200\n"};
    if (has("FANUC lathe with a C axis"))
        return {"fanuc-lathe", ".nc", driven, "T0101\nG97 S1000 M3\nG99 F0.2\nG0 X100. Z50. C0\n"};
    if (has("FANUC lathe") || matches("G7[0-6] [PUWR]"))
        return {"fanuc-lathe", ".nc", "lathe.xml",
                "T0101\nG97 S1000 M3\nG99 F0.2\nG0 X100. Z50.\n"};
    const bool is_fanuc =
        has("FANUC") ||
        matches("#[0-9]|G6[567]|M98|M198|^O[0-9]|[A-Z]-?[0-9]*\\.(\\s|$)|IF\\[|WHILE\\[|DPRNT");
    const bool has_centre = has("G43.4") || has("G43.5") || has("G41.2");
    const std::string machine =
        has("nutating")            ? "nutating.xml"
        : has("three rotary axes") ? "six-axis.xml"
        : has("mixed")             ? "mixed-cb.xml"
        : has("TRAORI\n") || has("\nTRAORI") || has("TRAORI(") || has("trunnion") || has_centre
            ? "trunnion-ac.xml"
            : mill;
    if (is_fanuc && !has("SINUMERIK"))
        return {"fanuc", ".nc", machine, "T1 M6\nS1000 M3\nG0 X0 Y0 Z50. F200.\n"};
    return {"sinumerik",
            ".mpf",
            machine,
            "T1 D1 M6\nS1000 M3\nG0 X0 Y0 Z50 F200\n",
            has("machine with C"),
            has("two spindles")};
}

/// The blocks without the remarks behind them.
std::string blocks_of(const std::string& example) {
    return std::regex_replace(example, std::regex("[ ]+; [^\n]*"), "");
}

std::string text_of(const DiagnosticRow& row, const std::string& example, const Control& control) {
    const std::string blocks = blocks_of(example);
    const bool is_fanuc = control.suffix == ".nc";
    if (kOwnEnd.contains(row.code)) return (is_fanuc ? "%\nO0001\n" : "") + blocks + '\n';
    const bool is_first = kAtTheHead.contains(row.code) || blocks.starts_with("DEF ") ||
                          blocks.starts_with("EXTERN ");
    const std::string head = is_first ? "" : control.head;
    std::smatch program;
    const bool is_program =
        is_fanuc && std::regex_search(blocks, program, std::regex("^O([0-9]+)\n"));
    if (is_program) {
        const std::string body = std::regex_replace(blocks, std::regex("\n%"), "");
        return "%\nO0001\n" + head + "M98 P" + program[1].str() + "\nM30\n" + body + "\n%\n";
    }
    const bool has_end = std::regex_search(blocks, std::regex("M30|M99|M17"));
    const std::string body = head + blocks + (has_end ? "\n" : "\nM30\n");
    if (!is_fanuc || blocks.find('%') != std::string::npos) return body;
    return (blocks.starts_with('O') ? "%\n" : "%\nO0001\n") + body + "%\n";
}

class ControlRowExamples : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = kadr::testing::scratch("control-rows");
        fs::create_directories(folder_);
        // Programs that examples call.
        for (const char* number : {"1000", "2000", "9100"})
            save("O" + std::string(number), "%\nO" + std::string(number) + "\nM99\n%\n");
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string save(const std::string& name, const std::string& text) {
        const std::string path = (folder_ / name).string();
        EXPECT_TRUE(kadr::write_file_whole(path, text));
        return path;
    }

    /// A stock machine with the tool of the example, or with the usual one, as its tool 1.
    std::string machine_file(const std::string& example, const Control& control) {
        std::string text =
            kadr::read_file(KADR_ROOT "/runtime/machines/" + control.machine).value_or("");
        text = std::regex_replace(text, std::regex("<tool [^>]*number=\"1\"[^>]*/>"), "");
        std::smatch said;
        std::string tools;
        if (std::regex_search(example, said, std::regex("<tool [^>]*/>"))) tools = said[0];
        if (tools.find("number=\"1\"") == std::string::npos) {
            tools += control.machine == "lathe.xml"
                         ? "<tool number=\"1\" length=\"100 mm\" radius=\"0.8 mm\" tip=\"3\"/>"
                         : "<tool number=\"1\" length=\"100 mm\" radius=\"5 mm\"/>";
        }
        if (control.has_c)
            tools +=
                "<axis name=\"C\" limits=\"0..360 deg\" velocity=\"30 rpm\" "
                "acceleration=\"1000 deg/s2\"/>";
        if (control.has_two_spindles) tools += "<spindle number=\"2\"/>";
        return save("machine.xml", text.insert(text.rfind("</machine>"), tools));
    }

    std::vector<Message> messages(const DiagnosticRow& row, const std::string& example,
                                  const Control& control) {
        const std::string file = save("example" + control.suffix, text_of(row, example, control));
        const ProcessResult result = run_process(
            {KADR_BINARY, "run", file, "-d", control.dialect, "-m", machine_file(example, control),
             "--diagnostics", "json", "--max-time", "60s", "--max-blocks", "2000"});
        return kadr::testing::messages_of(result.err);
    }

    fs::path folder_;
};

std::string words_of(const std::vector<Message>& messages) {
    std::string all;
    for (const Message& message : messages) all += message.code + ' ' + message.words + '\n';
    return all;
}

TEST_F(ControlRowExamples, WrongOnesCauseTheirMessageAndRightOnesNone) {
    int count = 0;
    for (const DiagnosticRow* row : kadr::all_diagnostics()) {
        if (!row->code.starts_with("K5") || kNotRun.contains(row->code)) continue;
        ++count;
        const std::string wrong(row->wrong), right(row->right);
        const Control control = control_of(wrong);
        SCOPED_TRACE(std::string(row->code) + " for " + control.dialect);
        const std::vector<Message> said = messages(*row, wrong, control);
        EXPECT_TRUE(std::ranges::any_of(
            said, [&](const Message& message) { return message.code == row->code; }))
            << wrong << "\nsays\n"
            << words_of(said);
        if (kOnlyWrong.contains(row->code)) continue;
        for (const Message& message : messages(*row, right, control)) {
            EXPECT_TRUE(message.is_warning && message.code != row->code)
                << right << "\nsays " << message.code << ": " << message.words;
        }
    }
    EXPECT_GT(count, 190);
}

}  // namespace

}  // namespace control_row_examples_test
