// What the documentation says is so: its programs are checked, the newcomer's path is walked.
#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/common/process.h"

namespace docs_test {

namespace {

namespace fs = std::filesystem;

/// A piece between ``` and ```, with what stands behind the first ```.
struct Fence {
    std::string info;
    std::string text;
    int line = 0;
};

std::vector<Fence> fences(const std::string& file) {
    std::istringstream in(kadr::read_file(std::string(KADR_ROOT "/") + file).value_or(""));
    std::vector<Fence> found;
    bool is_inside = false;
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (line.starts_with("```")) {
            is_inside = !is_inside;
            if (is_inside) found.push_back({line.substr(3), "", number});
        } else if (is_inside) {
            found.back().text += line + '\n';
        }
    }
    return found;
}

class Docs : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("kadr-docs-" + std::to_string(::getpid()));
        fs::create_directories(folder_);
        before_ = fs::current_path();
        fs::current_path(folder_);
    }
    void TearDown() override {
        fs::current_path(before_);
        fs::remove_all(folder_);
    }

    static ProcessResult check(const std::string& program) {
        EXPECT_TRUE(kadr::write_file_whole("part.kadr", program));
        return run_process({KADR_BINARY, "check", "part.kadr"});
    }

    fs::path folder_;
    fs::path before_;
};

TEST_F(Docs, ProgramsOfTheReferenceHaveNoMistake) {
    int programs = 0;
    for (const Fence& fence : fences("docs/language.md")) {
        if (fence.info.starts_with("csv ") || fence.info.starts_with("pgm ")) {
            ASSERT_TRUE(kadr::write_file_whole(fence.info.substr(4), fence.text));
        }
        if (fence.info != "c") continue;
        ++programs;
        const ProcessResult result = check(fence.text);
        EXPECT_EQ(result.status, 0) << "docs/language.md:" << fence.line << '\n' << result.err;
    }
    EXPECT_GT(programs, 10);
}

/// Pieces of programs stand where a program would have them.
TEST_F(Docs, PiecesOfTheLibrarysManualHaveNoMistake) {
    std::string imports;
    for (const auto& entry : fs::recursive_directory_iterator(KADR_ROOT "/stdlib")) {
        if (entry.path().extension() != ".kadr" || entry.path().stem() == "prelude") continue;
        std::string module = fs::relative(entry.path(), KADR_ROOT "/stdlib").replace_extension();
        for (char& c : module) c = c == '/' ? '.' : c;
        imports += "import " + module + ";\n";
    }
    for (const char* manual : {"docs/stdlib.md", "README.md"}) {
        for (const Fence& fence : fences(manual)) {
            if (fence.info != "c") continue;
            ProcessResult result = check(imports + fence.text);
            if (result.status != 0) {
                result = check(imports + "program part() {\nF100; S1000 M3; G0 X0 Y0 Z50;\n" +
                               fence.text + "}\n");
            }
            EXPECT_EQ(result.status, 0) << manual << ':' << fence.line << '\n' << result.err;
        }
    }
}

/// Every program of the library's texts has its picture in the manual, and it is today's.
TEST_F(Docs, PicturesAreWhatIsDrawnToday) {
    const std::string manual = kadr::read_file(KADR_ROOT "/docs/stdlib.md").value_or("");
    int pictures = 0;
    for (const auto& entry : fs::directory_iterator(KADR_ROOT "/tests/golden/cycles")) {
        if (entry.path().extension() != ".kadr") continue;
        ++pictures;
        const std::string name = entry.path().stem();
        const std::string program = kadr::read_file(entry.path()).value_or("");
        const bool is_lathe = program.find("-m lathe") != std::string::npos;
        const ProcessResult result =
            run_process({KADR_BINARY, "run", entry.path(), "-d", "sinumerik", "-m",
                         is_lathe ? "lathe" : "mill", "--cycles", "moves", "--plot", "now.svg"});
        EXPECT_EQ(result.status, 0) << name << '\n' << result.err;
        EXPECT_TRUE(kadr::read_file("now.svg") ==
                    kadr::read_file(KADR_ROOT "/docs/pictures/" + name + ".svg"))
            << name << ": run scripts/pictures and look at it";
        EXPECT_NE(manual.find("(pictures/" + name + ".svg)"), std::string::npos) << name;
    }
    EXPECT_GT(pictures, 30);
}

/// Words of a command line up to a comment; what stands between '' is of one word.
std::vector<std::string> words_of(const std::string& line) {
    std::vector<std::string> words;
    bool is_inside = false;
    bool is_quoted = false;
    for (const char c : line) {
        const bool is_blank = c == ' ' || c == '\t' || c == '\r' || c == '\n';
        if (c == '#' && !is_quoted) break;
        if (is_blank && !is_quoted) {
            is_inside = false;
            continue;
        }
        if (!is_inside) words.emplace_back();
        is_inside = true;
        if (c == '\'') is_quoted = !is_quoted;
        else words.back() += c;
    }
    return words;
}

TEST_F(Docs, TheNewcomersPathCanBeWalked) {
    int commands = 0;
    for (const Fence& fence : fences("docs/first-program.md")) {
        if (fence.info == "c") {
            ASSERT_TRUE(kadr::write_file_whole("plate.kadr", fence.text));
            continue;
        }
        std::istringstream in(fence.text);
        for (std::string line; std::getline(in, line);) {
            std::vector<std::string> words = words_of(line);
            if (words.empty() || words[0] != "kadr") continue;  // setting up is what CI begins with
            ++commands;
            words[0] = KADR_BINARY;
            std::string input;
            if (words.size() > 1 && words[1] == "repl") input = "G0 X10 Y20\n:undo\n";
            const ProcessResult result = run_process(words, input);
            const bool is_refused = line.find("# refused") != std::string::npos;
            EXPECT_EQ(result.status, is_refused ? 1 : 0) << line << '\n' << result.err;
        }
    }
    EXPECT_GT(commands, 10);
    EXPECT_TRUE(fs::exists("plate.svg"));
    EXPECT_TRUE(fs::exists("plate.jsonl"));
}

/// The command lines of the README, by a shell and in a tree with the examples. `part.mpf` is what
/// the second of them writes.
TEST_F(Docs, TheCommandsOfTheReadmeWork) {
    fs::create_directories("build/release");
    fs::create_symlink(KADR_BINARY, "build/release/kadr");
    fs::create_symlink(KADR_ROOT "/examples", "examples");
    int commands = 0;
    for (const Fence& fence : fences("README.md")) {
        std::istringstream in(fence.info == "sh" ? fence.text : "");
        for (std::string line; std::getline(in, line);) {
            if (!line.starts_with("build/release/kadr ")) continue;  // the scripts run these tests
            ++commands;
            // A hundred sets of values of a property are none of this test's matter.
            if (line.find("kadr test ") != std::string::npos)
                line = line.substr(0, line.find('#')) + "--runs 3";
            const ProcessResult result = run_process({"/bin/sh", "-c", line});
            EXPECT_EQ(result.status, 0) << line << '\n' << result.err;
            EXPECT_EQ(result.err.find("error["), std::string::npos) << line << '\n' << result.err;
            if (line.find("-d sinumerik -D") != std::string::npos) {
                ASSERT_TRUE(kadr::write_file_whole("part.mpf", result.out));
            }
        }
    }
    EXPECT_GE(commands, 9);
    EXPECT_TRUE(fs::exists("bracket.svg"));
    EXPECT_TRUE(fs::exists("part.jsonl"));
}

/// Commands inside of the newcomer's text, not in lines of their own.
TEST_F(Docs, CommandsNamedInTheNewcomersTextWork) {
    const std::string page = kadr::read_file(KADR_ROOT "/docs/first-program.md").value_or("");
    std::string plate;
    for (const Fence& fence : fences("docs/first-program.md")) {
        if (fence.info == "c") plate = fence.text;
    }
    ASSERT_TRUE(kadr::write_file_whole("plate.kadr", plate));
    const ProcessResult text =
        run_process({KADR_BINARY, "expand", "plate.kadr", "-d", "sinumerik"});
    ASSERT_TRUE(kadr::write_file_whole("old.mpf", text.out));
    const std::regex command("`(kadr [a-z]+ [^`]+)`");
    int commands = 0;
    for (std::sregex_iterator at(page.begin(), page.end(), command), end; at != end; ++at) {
        ++commands;
        std::vector<std::string> words = words_of((*at)[1]);
        words[0] = KADR_BINARY;
        const ProcessResult result = run_process(words);
        EXPECT_EQ(result.status, 0) << (*at)[1] << '\n' << result.err;
    }
    EXPECT_GE(commands, 1);
}

/// A piece of the page with a file behind its kind, `xml zarya.xml`: the file; with `add` behind
/// it, a piece that is put in at the end of the dialect that the file has.
void write_piece(const Fence& fence) {
    const std::vector<std::string> words = words_of(fence.info);
    std::string text = fence.text;
    if (words.size() == 3 && words[2] == "add") {
        const std::string before = kadr::read_file(words[1]).value_or("");
        const std::size_t end = before.find("</dialect>");
        ASSERT_NE(end, std::string::npos) << words[1];
        text = before.substr(0, end) + fence.text + before.substr(end);
    }
    ASSERT_TRUE(kadr::write_file_whole(words[1], text));
}

/// The controls that the page describes are written, checked, used and read, word for word.
TEST_F(Docs, TheInventedControlsWork) {
    int commands = 0;
    int texts = 0;
    int alarms = 0;
    std::string text;
    for (const Fence& fence : fences("docs/dialects.md")) {
        if (fence.info.find(' ') != std::string::npos) {
            write_piece(fence);
        } else if (fence.info == "text") {
            ++texts;
            EXPECT_EQ(text, fence.text) << "docs/dialects.md:" << fence.line;
        }
        if (fence.info != "sh") continue;
        std::istringstream in(fence.text);
        for (std::string line; std::getline(in, line);) {
            std::vector<std::string> words = words_of(line);
            ++commands;
            words[0] = KADR_BINARY;
            const ProcessResult result = run_process(words);
            const bool is_refused = line.find("# refused") != std::string::npos;
            EXPECT_EQ(result.status, is_refused ? 1 : 0)
                << "docs/dialects.md:" << fence.line << ' ' << line << '\n'
                << result.err;
            alarms += result.err.find("alarm[E12]: BAD CODE") != std::string::npos ? 1 : 0;
            text = result.out;
        }
    }
    EXPECT_GE(commands, 25);
    EXPECT_EQ(texts, 3);
    EXPECT_EQ(alarms, 1);
}

TEST_F(Docs, ThePageOnDebuggingShowsWhatIsSaid) {
    int texts = 0;
    std::string text;
    for (const Fence& fence : fences("docs/debugging.md")) {
        if (const std::size_t name = fence.info.find(' '); name != std::string::npos) {
            ASSERT_TRUE(kadr::write_file_whole(fence.info.substr(name + 1), fence.text));
        } else if (fence.info == "sh") {
            std::vector<std::string> words = words_of(fence.text);
            words[0] = KADR_BINARY;
            const ProcessResult result = run_process(words, "");
            EXPECT_EQ(result.status, 0) << fence.text << result.err;
            text = result.out + result.err;
        } else {
            ++texts;
            EXPECT_EQ(text, fence.text) << "docs/debugging.md:" << fence.line;
        }
    }
    EXPECT_EQ(texts, 4);
    EXPECT_TRUE(fs::exists("slot.jsonl"));
}

/// Goes through a page: files that it shows are written, commands are run, and a text right behind
/// commands is what the last of them says. Returns how many texts there were.
int texts_of_page(const std::string& page) {
    std::error_code is_there_already;
    fs::create_symlink(KADR_ROOT "/examples", "examples", is_there_already);
    int texts = 0;
    bool was_command = false;
    std::string text;
    for (const Fence& fence : fences(page)) {
        const std::vector<std::string> info = words_of(fence.info);
        if (info.size() == 2) {
            EXPECT_TRUE(kadr::write_file_whole(info[1], fence.text));
        }
        if (was_command && fence.info == "text") {
            ++texts;
            EXPECT_EQ(text, fence.text) << page << ':' << fence.line;
        }
        was_command = fence.info == "sh";
        std::istringstream in(was_command ? fence.text : "");
        for (std::string line; std::getline(in, line);) {
            std::vector<std::string> words = words_of(line);
            words[0] = KADR_BINARY;
            const ProcessResult result = run_process(words);
            EXPECT_EQ(result.status, 0) << page << ": " << line << '\n' << result.err;
            EXPECT_EQ(result.err, "") << page << ": " << line;
            text = result.out;
        }
    }
    return texts;
}

TEST_F(Docs, ThePagesOnMotionAndFiveAxesShowWhatIsSaid) {
    EXPECT_EQ(texts_of_page("docs/motion.md"), 2);
    EXPECT_EQ(texts_of_page("docs/five-axes.md"), 2);
}

TEST_F(Docs, ThePageOnInputsShowsWhatIsSaid) { EXPECT_EQ(texts_of_page("docs/inputs.md"), 1); }

/// mm/min at every tick at feed, of a program of the page on motion that `laser` runs.
std::vector<double> speeds_of(const std::string& name) {
    for (const Fence& fence : fences("docs/motion.md")) {
        if (fence.info != "iso " + name + ".mpf") continue;
        EXPECT_TRUE(kadr::write_file_whole(name + ".mpf", fence.text));
    }
    const ProcessResult result =
        run_process({KADR_BINARY, "run", name + ".mpf", "-d", "sinumerik", "-m", "laser",
                     "--setpoints", name + ".csv", "--curves", "motion_" + name + ".svg"});
    EXPECT_EQ(result.status, 0) << result.err;
    std::istringstream rows(kadr::read_file(name + ".csv").value_or(""));
    std::string row;
    std::getline(rows, row);
    const auto column = std::ranges::count(row.substr(0, row.find("feed")), ',');
    std::vector<double> speeds;
    while (std::getline(rows, row)) {
        std::size_t at = 0;
        for (std::ptrdiff_t i = 0; i < column; ++i) at = row.find(',', at) + 1;
        speeds.push_back(std::stod(row.substr(at)));
    }
    return speeds;
}

/// A chain without corners is passed at its feed, and blocks of some hundredths without a stop.
TEST_F(Docs, ChainsAndShortBlocksRunOn) {
    const std::vector<double> chain = speeds_of("chain");
    const auto is_full = [](double speed) { return speed > 1499.99; };
    const auto first = std::ranges::find_if(chain, is_full);
    const auto last = std::find_if(chain.rbegin(), chain.rend(), is_full).base();
    ASSERT_GT(last - first, 1700);
    EXPECT_GT(*std::min_element(first, last), 1499.9);
    EXPECT_LT(*std::max_element(first, last), 1500.01);

    const std::vector<double> blocks = speeds_of("short");
    ASSERT_GT(blocks.size(), 800u);
    // Between the ramps from rest and to rest.
    EXPECT_GT(*std::min_element(blocks.begin() + 5, blocks.end() - 5), 10);
    EXPECT_GT(*std::ranges::max_element(blocks), 400);
}

/// The curves of the page's steps with rounded corners, its chain and its short blocks, and the
/// drives of the facing pass.
TEST_F(Docs, PicturesOfMotionAreWhatIsDrawnToday) {
    std::string steps;
    for (const Fence& fence : fences("docs/motion.md")) {
        if (fence.info == "iso steps.mpf") steps = fence.text;
    }
    const std::size_t mode = steps.find("G64");
    ASSERT_NE(mode, std::string::npos);
    ASSERT_TRUE(kadr::write_file_whole("steps.mpf", steps.replace(mode, 3, "G642 CTOL=0.3")));
    const ProcessResult corner =
        run_process({KADR_BINARY, "run", "steps.mpf", "-d", "sinumerik", "--curves",
                     "motion_corner.svg", "--window", "4s..4.6s"});
    EXPECT_EQ(corner.status, 0) << corner.err;
    const ProcessResult face =
        run_process({KADR_BINARY, "run", KADR_ROOT "/examples/face.kadr", "-d", "sinumerik", "-m",
                     "lathe", "--drive", "motion_face.svg"});
    EXPECT_EQ(face.status, 0) << face.err;
    speeds_of("chain");
    speeds_of("short");
    for (const char* file :
         {"motion_corner.svg", "motion_face.svg", "motion_chain.svg", "motion_short.svg"}) {
        const std::string name = file;
        EXPECT_TRUE(kadr::read_file(name) == kadr::read_file(KADR_ROOT "/docs/pictures/" + name))
            << name << ": run scripts/pictures and look at it";
    }
}

}  // namespace

}  // namespace docs_test
