// `kadr run` on a machine with a scanner: lists, setpoints, summary, and what it refuses.
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/driver/scratch.h"

namespace scanner_test {

namespace {

using kadr::read_file;
using kadr::test::Row;
using kadr::test::rows_of;

using Scanner = kadr::test::ScratchFolder;

const std::string kFields = std::string(KADR_ROOT) + "/examples/fields.kadr";

/// A line of a list as words.
std::vector<std::string> words_of(const std::string& line) {
    std::istringstream in(line);
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    return words;
}

/// Plays the lists as a controller does and holds them against their own times.
struct Player {
    int lists = 0;
    int marks = 0;
    double time_us = 0;  // of all lists
    int vectors = 0;     // whose times are rounded to a nanosecond
    double rounding() const { return 1e-3 + 0.0005 * vectors; }

    void play(const std::string& text) {
        std::istringstream lines(text);
        double jump = 0, mark = 0, polygon = 0;
        double list = 0;
        double x = 0, y = 0;
        double dx = 0, dy = 0;  // of the last mark; 0: there was none just now
        std::string before;
        const auto close = [&] {
            if (before == "jump_abs") list += jump;
            if (before == "mark_abs") list += mark;
            before.clear();
        };
        for (std::string line; std::getline(lines, line);) {
            const std::vector<std::string> words = words_of(line);
            if (words.empty() || words[0] == "#") continue;
            const auto number = [&](std::size_t i) { return std::stod(words.at(i)); };
            if (words[0] == "set_delays") {
                jump = number(1);
                mark = number(2);
                polygon = number(3);
                ASSERT_EQ(words.at(4), "turning");
            } else if (words[0] == "list_begin") {
                EXPECT_EQ(number(1), ++lists);
                list = 0;
                before.clear();
                // Every list of the example begins and ends in the middle of the field.
                x = y = 0;
            } else if (words[0] == "jump_abs") {
                close();
                list += number(3);
                // 8 m/s, in whole steps of 10 us
                const double distance = std::hypot(number(1) - x, number(2) - y);
                EXPECT_NEAR(number(3), std::ceil(distance / 8 * 100 - 1e-3) * 10, 1e-6) << line;
                before = words[0];
            } else if (words[0] == "mark_abs" || words[0] == "micro_abs") {
                const double to_x = number(1) - x, to_y = number(2) - y;
                const double distance = std::hypot(to_x, to_y);
                if (before == "mark_abs") {
                    const double cosine = (dx * to_x + dy * to_y) / distance;
                    list += std::ceil((1 - cosine) / 2 * polygon / 10 - 1e-6) * 10;
                } else if (before != "micro_abs") {
                    close();
                }
                list += number(3);
                dx = to_x / distance;
                dy = to_y / distance;
                ++vectors;
                marks += words[0] == "mark_abs" ? 1 : 0;
                before = words[0];
            } else if (words[0] == "list_end") {
                close();
                EXPECT_NEAR(number(1), list, rounding()) << "list " << lists;
                EXPECT_NEAR(std::hypot(x, y), 0, 1e-6);
                time_us += list;
            }
            if (words[0].ends_with("_abs")) {
                x = number(1);
                y = number(2);
                EXPECT_LE(std::max(std::abs(x), std::abs(y)), 55);
            }
        }
    }
};

/// The example for two controls: the same lists, whose times are those of their commands.
TEST_F(Scanner, FieldsAreMarkedOneAfterTheOther) {
    std::vector<std::string> texts;
    for (const char* dialect : {"sinumerik", "fanuc"}) {
        const ProcessResult result =
            kadr({"run", kFields, "-d", dialect, "-m", "scanner", "--summary", "json", "--scanner",
                  file("lists.txt"), "--setpoints", file("fields.csv")});
        ASSERT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.err, "");
        const nlohmann::json summary = nlohmann::json::parse(result.out);
        const nlohmann::json& scanner = summary["scanner"];
        texts.push_back(read_file(file("lists.txt")).value());
        Player player;
        player.play(texts.back());
        EXPECT_EQ(texts.back().find("e+"), std::string::npos) << "numbers are decimal";
        // 6 fields of two rings, a cross and 12 ticks, and a triangle.
        EXPECT_EQ(player.lists, 7);
        EXPECT_EQ(player.marks, 6 * 16 + 3);
        EXPECT_EQ(scanner["lists"], 7);
        EXPECT_EQ(scanner["marks"], 6 * 16 + 3);
        EXPECT_NEAR(scanner["time_s"].get<double>() * 1e6, player.time_us, player.rounding());

        // What tools have is what the axes have; all of them have all of the time.
        std::map<std::string, double> of_tools;
        for (const nlohmann::json& tool : summary["tools"]) {
            for (const char* figure : {"time_s", "cutting_s", "length_mm"})
                of_tools[figure] += tool[figure].get<double>();
        }
        for (const auto& [figure, sum] : of_tools)
            EXPECT_NEAR(sum, summary[figure].get<double>(), 1e-3) << figure;

        double pulses = 0;
        std::vector<Row> rows = rows_of(read_file(file("fields.csv")).value());
        std::size_t marking = 0;
        for (std::size_t i = 1; i < rows.size(); ++i) {
            pulses += rows[i]["pulse"];
            const double tip = std::hypot(rows[i]["tip_x"] - rows[i - 1]["tip_x"],
                                          rows[i]["tip_y"] - rows[i - 1]["tip_y"]);
            const double axes =
                std::hypot(rows[i]["X"] - rows[i - 1]["X"], rows[i]["Y"] - rows[i - 1]["Y"]);
            // Pulses are the scanner's: no axis moves while it marks.
            if (rows[i]["pulse"] > 1 && rows[i - 1]["pulse"] > 1) {
                EXPECT_EQ(axes, 0);
                marking += tip > 0 ? 1 : 0;
            }
        }
        EXPECT_EQ(pulses, scanner["pulses"].get<double>());
        EXPECT_GT(marking, 500u);
        EXPECT_NEAR(summary["time_s"].get<double>(),
                    summary["rapid_s"].get<double>() + scanner["time_s"].get<double>(), 1e-6);
    }
    EXPECT_EQ(texts[0], texts[1]);
}

TEST_F(Scanner, TheSummaryTellsOfMarks) {
    const ProcessResult text = kadr({"run", kFields, "-d", "sinumerik", "-m", "scanner"});
    ASSERT_EQ(text.status, 0) << text.err;
    EXPECT_NE(text.out.find("\n    scanner "), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("\n  marks         99, "), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("\n  lists         7, "), std::string::npos) << text.out;
}

/// Out of the field: an alarm at the word's line; what came before is in the list.
TEST_F(Scanner, OutOfTheFieldIsAnAlarm) {
    save("far.nc", "G21 G90 G17\nG0 X0 Y0\nM66\nG0 X50.\nG1 X56. F60000\nG0 X0\nM67\nM30\n");
    const ProcessResult result = kadr({"run", file("far.nc"), "-d", "fanuc", "-m", "scanner",
                                       "--scanner", file("far.txt"), "--commands", file("far.j")});
    EXPECT_EQ(result.status, 3);
    EXPECT_NE(result.err.find("far.nc:5:"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("K6227"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("X56 Y0 is 1 mm outside"), std::string::npos) << result.err;
    const std::string list = read_file(file("far.txt")).value();
    EXPECT_NE(list.find("\njump_abs 50 0 6250\nlist_end 6550\n# not complete, ended by "),
              std::string::npos)
        << list;
    const std::string commands = read_file(file("far.j")).value();
    EXPECT_NE(commands.find("\"op\":\"scanner_on\""), std::string::npos) << commands;
    EXPECT_EQ(commands.find("\"X\":56"), std::string::npos) << "the refused one is not executed";
}

/// Without the functions of a builder there is no scanner; without one in the machine no lists.
TEST_F(Scanner, WhatHasNoScanner) {
    save("high.kadr",
         "import scanner;\nprogram p() {\n    G0 X0 Y0;\n    scanner_on(code: 70);\n}\n");
    const ProcessResult taken = kadr({"expand", file("high.kadr"), "-d", "sinumerik"});
    EXPECT_EQ(taken.status, 1) << "M70 is an axis of the spindle there: " << taken.out;
    EXPECT_NE(taken.err.find("high.kadr:4:5"), std::string::npos) << taken.err;
    const ProcessResult mill =
        kadr({"run", kFields, "-d", "fanuc", "-m", "mill", "--scanner", file("none.txt")});
    EXPECT_EQ(mill.status, 2);
    EXPECT_NE(mill.err.find("K6226"), std::string::npos) << mill.err;
    EXPECT_FALSE(read_file(file("none.txt")));
}

/// A correction table beside the machine file, and its mistakes with their places.
TEST_F(Scanner, TheTableOfAMachine) {
    const std::string stock =
        read_file(std::string(KADR_ROOT) + "/runtime/machines/scanner.xml").value();
    std::string text = stock;
    text.replace(text.find("<scanner "), 9, "<scanner correction=\"lens.csv\" ");
    save("own.xml", text);
    save("mark.nc", "G71 G90 G17\nG0 X0 Y0\nM66\nG0 X50 Y50\nG0 X0 Y0\nM67\nM30\n");
    const std::string header = "x [mm],y [mm],dx [mm],dy [mm]\n";
    save("lens.csv",
         "# of the lens\n" + header + "-55,-55,0,0\n55,-55,0,0\n-55,55,0,0\n55,55,-0.55,0.11\n");
    const std::vector<std::string> run = {"run", file("mark.nc"), "-d",        "sinumerik",
                                          "-m",  file("own.xml"), "--scanner", file("out.txt")};
    const ProcessResult good = kadr(run);
    ASSERT_EQ(good.status, 0) << good.err;
    // At 50, 50 of ±55: (105/110)² of the corner's correction.
    const double share = 105.0 / 110 * 105 / 110;
    const std::string list = read_file(file("out.txt")).value();
    const std::size_t at = list.find("jump_abs ");
    ASSERT_NE(at, std::string::npos);
    const std::vector<std::string> words = words_of(list.substr(at, list.find('\n', at) - at));
    EXPECT_NEAR(std::stod(words.at(1)), 50 - 0.55 * share, 1e-6);
    EXPECT_NEAR(std::stod(words.at(2)), 50 + 0.11 * share, 1e-6);

    const struct {
        const char* table;
        const char* place;
        const char* code;
    } rows[] = {{"x,y,dx,dy\n", "lens.csv:1:1", "K6222"},
                {"-55,-55,0,0\n55,-55,0,zero\n", "lens.csv:3:1", "K6222"},
                {"-55,-55,0,0\n55,-55,0,0\n-55,55,0,0\n", "lens.csv:1:1", "K6223"},
                {"-55,-55,0,0\n-55,-55,0,0\n", "lens.csv:3:1", "K6014"},
                {"-50,-50,0,0\n50,-50,0,0\n-50,50,0,0\n50,50,0,0\n", "own.xml:", "K6224"}};
    for (const auto& row : rows) {
        SCOPED_TRACE(row.table);
        const std::string start = std::string(row.table).starts_with("x,") ? "" : header;
        save("lens.csv", start + row.table);
        const ProcessResult bad = kadr(run);
        EXPECT_NE(bad.status, 0);
        EXPECT_NE(bad.err.find(row.place), std::string::npos) << bad.err;
        EXPECT_NE(bad.err.find(row.code), std::string::npos) << bad.err;
    }
}

}  // namespace

}  // namespace scanner_test
