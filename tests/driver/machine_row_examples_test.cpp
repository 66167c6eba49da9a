// What `kadr explain` shows for the rows about machines and their motion (K6): the wrong example
// gives the row's message, the right one neither that nor any error.
//
// An example is a piece of a machine file, a command line, a line of an operator's file, a table of
// corrections, or blocks. `...` in a piece stands for what the element needs besides; around a
// piece stands a machine. Blocks are read by the common core behind a tool, a spindle and a feed,
// unless the row is about one of those; a remark in brackets says which machine is meant.
#include <filesystem>
#include <map>
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
#include "tests/driver/scratch.h"

namespace machine_row_examples_test {

namespace {

namespace fs = std::filesystem;
using kadr::DiagnosticRow;
using kadr::testing::Message;

/// Rows about what is missing at the start of a program.
const std::set<std::string_view> kAtTheHead = {"K6103", "K6104"};

/// Rows about blocks for a scanner.
const std::set<std::string_view> kOfScanner = {"K6227", "K6228", "K6229", "K6230"};

/// Rows about calls of curves; the program that has the kind `clothoid` reads them.
const std::set<std::string_view> kOfCurves = {"K6240", "K6241"};

/// What the interpreter says first where the blocks are a text. The planner holds commands from
/// elsewhere to the same; tests/motion shows its own messages.
const std::map<std::string_view, std::string_view> kSaidBefore = {{"K6101", "K5231"},
                                                                  {"K6102", "K5230"},
                                                                  {"K6103", "K5210"},
                                                                  {"K6104", "K5214"},
                                                                  {"K6105", "K5218"}};

std::string replaced(const std::string& text, const char* pattern, const std::string& by) {
    return std::regex_replace(text, std::regex(pattern), by);
}

/// An axis with the attributes that it must have, as far as it has not got them.
std::string whole_axis(std::string axis) {
    const std::size_t dots = axis.find(" ...");
    if (dots == std::string::npos) return axis;
    std::string missing;
    const bool is_rotary = std::regex_search(axis, std::regex("name=\"[ABC]\""));
    const auto need = [&](const std::string& name, const char* linear, const char* rotary) {
        if (axis.find(name + '=') != std::string::npos) return;
        missing += ' ' + name + "=\"" + (is_rotary ? rotary : linear) + '"';
    };
    need("limits", "-300..300 mm", "-360..360 deg");
    need("velocity", "30 m/min", "30 rpm");
    need("acceleration", "5 m/s2", "1000 deg/s2");
    return axis.replace(dots, 4, missing);
}

/// A scanner with the attributes that it must have.
std::string whole_scanner(const std::string& scanner) {
    std::string missing;
    for (const char* attribute :
         {"on=\"66\"", "off=\"67\"", "field=\"100 mm\"", "jump_speed=\"8 m/s\""}) {
        const std::string name(attribute, std::string_view(attribute).find('=') + 1);
        if (scanner.find(' ' + name) == std::string::npos) missing += std::string(" ") + attribute;
    }
    return replaced(scanner, " \\.\\.\\./>", missing + "/>");
}

/// The piece of a machine file that an example is, as a file.
std::string machine_of(const std::string& example) {
    if (example.find("<pipeline") != std::string::npos)
        return "<machine name=\"m\">" + whole_axis("<axis name=\"X\" .../>") +
               whole_scanner(example) + "</machine>";
    if (example.find("<kinematics") != std::string::npos) {
        // A piece without axes stands in a machine with all that a chain may name.
        std::string axes = example;
        if (example.find("<axis") == std::string::npos) {
            for (const char* name : {"C", "B", "A", "Z", "Y", "X"})
                axes = "<axis name=\"" + std::string(name) + "\" .../>" + axes;
        }
        const std::regex open_axis("<axis name=\"([A-Z])\" [.]{3}/>");
        std::string text;
        for (std::smatch axis; std::regex_search(axes, axis, open_axis); axes = axis.suffix())
            text += axis.prefix().str() + whole_axis(axis.str());
        return "<machine name=\"m\">" + text + axes + "</machine>";
    }
    if (example.starts_with("<scanner"))
        return "<machine name=\"m\">" + whole_axis("<axis name=\"X\" .../>") +
               whole_scanner(example) + "</machine>";
    std::string text;
    const std::regex axis("<axis [^>]*/>");
    std::size_t done = 0;
    for (std::sregex_iterator it(example.begin(), example.end(), axis), end; it != end; ++it) {
        text += example.substr(done, static_cast<std::size_t>(it->position()) - done);
        text += whole_axis(it->str());
        done = static_cast<std::size_t>(it->position() + it->length());
    }
    text += example.substr(done);
    const bool is_whole =
        text.starts_with("<machine") && (text.ends_with("</machine>") || text.ends_with("\"/>"));
    const bool is_open = text.find("<machine") != std::string::npos;
    const bool ends = text.find("</machine>") != std::string::npos ||
                      std::regex_search(text, std::regex("^<machine [^>]*/>"));
    if (is_whole && ends) return text;
    if (text.find("<axis") == std::string::npos) text += whole_axis("<axis name=\"X\" .../>");
    if (text.find("name=") > text.find('>'))
        text = replaced(text, "<machine ", "<machine name=\"m\" ");
    return (is_open ? text : "<machine name=\"m\">" + text) + "</machine>";
}

/// An example of blocks and the remark behind it, and the machine that the remark speaks of.
struct Blocks {
    std::string text, machine;
};

Blocks blocks_of(const DiagnosticRow& row, const std::string& example) {
    const std::size_t remark_at = example.find("   (");
    const std::string remark = remark_at == std::string::npos ? "" : example.substr(remark_at);
    if (kOfScanner.contains(row.code)) {
        const std::string machine =
            kadr::read_file(KADR_ROOT "/runtime/machines/scanner.xml").value_or("");
        return {"T1\nS1000 M3\n" + example.substr(0, remark_at) + "\nM30\n",
                replaced(machine, "field=\"[^\"]*\"", "field=\"100 mm\"")};
    }
    const auto says = [&](const char* words) { return remark.find(words) != std::string::npos; };
    const bool is_lathe = says("lathe") || says("spindle drive") || says("on one with");
    std::string machine = kadr::read_file(KADR_ROOT "/runtime/machines/" +
                                          std::string(is_lathe ? "lathe.xml" : "mill.xml"))
                              .value_or("");
    std::smatch said;
    if (std::regex_search(remark, said, std::regex("ends at ([0-9]+)")))
        machine = replaced(machine, "-1000\\.\\.1000", "-300.." + said[1].str());
    if (std::regex_search(remark, said, std::regex("max_current=\"[^\"]*\"")))
        machine = replaced(machine, "max_current=\"[^\"]*\"", said[0]);
    if (std::regex_search(remark, said, std::regex("spindle for ([0-9]+) rpm")))
        machine =
            replaced(machine, "max_speed=\"[^\"]*\"", "max_speed=\"" + said[1].str() + " rpm\"");
    const std::string head = kAtTheHead.contains(row.code) ? "" : "T1\nS1000 M3\nF200\n";
    // A cut, for what only shows when the tool is at work.
    const std::string tail =
        is_lathe ? "G18 G95 F0.2\nG0 X100 Z0\nG1 X90\nM30\n" : "G1 Z-1 F200\nM30\n";
    return {head + example.substr(0, remark_at) + '\n' + tail, machine};
}

/// A dialect with this declaration of a call, or with that of examples/curves.
std::string dialect_of(const std::string& example) {
    const std::string cycle = example.starts_with("<cycle")
                                  ? example.substr(0, example.find(" .../>"))
                                  : "<cycle name=\"clothoid\" curve=\"clothoid\"";
    return "<dialect name=\"c\" extends=\"sinumerik\" title=\"c\" suffix=\"mpf\">" + cycle +
           " parameters=\"direction:angle from:number to:number length:length\"><form use=\"read\">"
           "CLOTHOID({direction},{from},{to},{length})</form></cycle></dialect>";
}

/// More than ten seconds, with a block that has a number.
const char* const kLongText = "T1 D1\nS1000 M3\nG0 X0 Y0 Z5\nN120 G1 X200 F1000\nM30\n";
const std::string kTableHead = "x [mm],y [mm],dx [mm],dy [mm]\n";

class MachineRowExamples : public kadr::test::ScratchFolder {
  protected:
    std::vector<Message> programmed_in(std::vector<std::string> arguments) {
        for (const char* word : {"--diagnostics", "json"}) arguments.emplace_back(word);
        const ProcessResult result = kadr(arguments);
        EXPECT_LT(result.status, 4) << result.err;
        return kadr::testing::messages_of(result.err);
    }

    std::vector<Message> messages(const DiagnosticRow& row, const std::string& example) {
        if (kOfCurves.contains(row.code)) {
            const bool is_call = !example.starts_with("<");
            save("c.xml", dialect_of(example));
            save("part.mpf", "T1 D1\nS1000 M3\nG1 X5 F200\n" +
                                 (is_call ? example.substr(0, example.find("   ("))
                                          : std::string("CLOTHOID(0,0,0.05,20)")) +
                                 "\nM30\n");
            const ProcessResult result =
                run_process({KADR_CURVES_BINARY, "run", file("part.mpf"), "-d", file("c.xml"),
                             "--diagnostics", "json"});
            return kadr::testing::messages_of(result.err);
        }
        if (example.starts_with("number,")) {
            const std::size_t remark = example.find("   (");
            save("tools.csv", example.substr(0, remark) + '\n');
            save("example.nc", "M30\n");
            // A stock machine whose tool 1 has a radius of 10 mm.
            return programmed_in({"run", file("example.nc"), "-d", "iso", "-m", "rotary-a",
                                  "--tools", file("tools.csv")});
        }
        if (example.starts_with("<")) {
            save("to50.csv", kTableHead + "-50,-50,0,0\n50,-50,0,0\n-50,50,0,0\n50,50,0,0\n");
            save("machine.xml", machine_of(example));
            save("example.nc", "M30\n");
            return programmed_in(
                {"run", file("example.nc"), "-d", "iso", "-m", file("machine.xml")});
        }
        if (example.starts_with("kadr ") || example.starts_with("KADR_PAGE=")) {
            std::istringstream line(example);
            std::vector<std::string> words;
            const std::regex file_name("[a-z]+\\.[a-z]+");
            for (std::string word; line >> word;)
                words.push_back(std::regex_match(word, file_name) ? file(word) : word);
            const std::string setting = words.front() == "kadr" ? "" : words.front();
            words.erase(words.begin(), words.begin() + (setting.empty() ? 1 : 2));
            for (const char* name : {"part.kadr", "face.kadr"})
                save(name, "program part() { G18; S500 M3; G0 X50 Z2; G95 F0.2; G1 Z-5; M30; }");
            save("marks.kadr", "program marks() { tool(1); S500 M3 F200; G0 X0; G1 X5; M30; }");
            save("part.mpf", kLongText);
            if (setting.empty()) return programmed_in(words);
            // KADR_PAGE=name: a file of the test's folder, which may be missing.
            const std::size_t equals = setting.find('=') + 1;
            words.insert(words.begin(),
                         {"/usr/bin/env", setting.substr(0, equals) + file(setting.substr(equals)),
                          KADR_BINARY});
            for (const char* word : {"--diagnostics", "json"}) words.emplace_back(word);
            return kadr::testing::messages_of(run_process(words).err);
        }
        if (row.code == "K6211" || row.code == "K6215") {
            save("part.mpf", kLongText);
            save("events.txt", example + (row.code == "K6211" ? "\n7s cycle start\n" : "\n"));
            return programmed_in({"run", file("part.mpf"), "--events", file("events.txt")});
        }
        if (example.find(",dy") != std::string::npos || example.starts_with("-50,")) {
            // A table with the corners that an example leaves out.
            std::string table = example.starts_with("-") ? kTableHead + example : example;
            if (example.find(",dy") != std::string::npos)
                table += "\n50,-50,0,0\n-50,50,0,0\n50,50,0,0";
            save("table.csv", table + "\n");
            save("machine.xml", machine_of("<scanner correction=\"table.csv\" .../>"));
            save("example.nc", "M30\n");
            return programmed_in(
                {"run", file("example.nc"), "-d", "iso", "-m", file("machine.xml")});
        }
        const Blocks blocks = blocks_of(row, example);
        save("machine.xml", blocks.machine);
        save("example.nc", blocks.text);
        std::vector<std::string> words = {"run", file("example.nc"), "-d", "iso",
                                          "-m",  file("machine.xml")};
        if (blocks.machine.find("max_current") != std::string::npos)
            for (const std::string& word : {std::string("--drive"), file("drive.csv")})
                words.push_back(word);
        return programmed_in(words);
    }
};

TEST_F(MachineRowExamples, WrongOnesCauseTheirMessageAndRightOnesNone) {
    int count = 0;
    for (const DiagnosticRow* row : kadr::all_diagnostics()) {
        if (!row->code.starts_with("K6")) continue;
        // Of Kadr itself: no input causes it (path_check_test.cpp does, with a planner that errs).
        if (row->code == "K6320") continue;
        // Of AxiOMA's path choice 3 and a limit on the way (orient_interpolation_test.cpp has
        // both).
        if (row->code == "K6331") continue;
        ++count;
        SCOPED_TRACE(row->code);
        const auto before = kSaidBefore.find(row->code);
        const std::string_view code = before == kSaidBefore.end() ? row->code : before->second;
        const std::string wrong(row->wrong), right(row->right);
        std::string words;
        bool is_caused = false;
        for (const Message& message : messages(*row, wrong)) {
            is_caused |= message.code == code;
            words += message.code + ' ' + message.words + '\n';
        }
        EXPECT_TRUE(is_caused) << wrong << "\nsays\n" << words;
        for (const Message& message : messages(*row, right)) {
            EXPECT_TRUE(message.is_warning && message.code != row->code)
                << right << "\nsays " << message.code << ": " << message.words;
        }
    }
    EXPECT_GE(count, 42);
}

}  // namespace

}  // namespace machine_row_examples_test
