// Wrong input of every kind: the right message at the right place, the exit status that DESIGN
// promises, and an existing output file left as it was.
//
// A case is a file below cases/. Its comments say what is expected, in the order of the messages:
//   expect: 4:7 K2003 unknown name        line:column, code (or the control's alarm), words
//   exit: 3                                exit status; 1 if it is not given
//   args: run -d fanuc {file} -o {out}     what to run; the folder gives the default
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "tests/common/process.h"
#include "tests/common/scratch.h"

namespace bad_test {

namespace {

namespace fs = std::filesystem;

const fs::path kCases = fs::path(KADR_ROOT) / "tests/bad/cases";

std::string content_of(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// What the folders run, unless a case says otherwise.
const std::map<std::string, std::string> kDefaultArguments = {
    {"source", "expand {file} -d sinumerik -o {out}"},
    {"sinumerik", "run {file} -d sinumerik --commands {out}"},
    {"fanuc", "run {file} -d fanuc --commands {out}"},
    {"iso", "run {file} -d iso --commands {out}"},
    {"dialects", "dialect check {file}"},
    {"machines", "machine check {file}"},
    {"languages", "check {school}"},
};

struct Expectation {
    std::string place, code, words;
};

struct Case {
    std::vector<Expectation> expected;
    std::string arguments;
    int status = 1;
};

std::string trimmed(std::string text) {
    for (const char* end : {"-->", ")", "*/"}) {
        const std::string tail = end;
        if (text.ends_with(tail)) text.erase(text.size() - tail.size());
    }
    text.erase(text.find_last_not_of(" \t\r") + 1);
    text.erase(0, text.find_first_not_of(" \t"));
    return text;
}

Case parse_case(const fs::path& file) {
    Case result;
    result.arguments = kDefaultArguments.at(file.parent_path().filename());
    std::istringstream text(content_of(file));
    for (std::string line; std::getline(text, line);) {
        const auto value_of = [&line](const std::string& key) -> std::string {
            const std::size_t at = line.find(key);
            return at == std::string::npos ? "" : trimmed(line.substr(at + key.size()));
        };
        if (const std::string value = value_of("expect: "); !value.empty()) {
            Expectation expectation;
            std::istringstream parts(value);
            parts >> expectation.place >> expectation.code;
            std::getline(parts, expectation.words);
            expectation.words = trimmed(expectation.words);
            result.expected.push_back(expectation);
        } else if (const std::string status = value_of("exit: "); !status.empty()) {
            result.status = std::stoi(status);
        } else if (const std::string arguments = value_of("args: "); !arguments.empty()) {
            result.arguments = arguments;
        }
    }
    return result;
}

/// Kadr finds keyword languages by their names, so a case is installed as the language `school`:
/// a tree of shared files that is the real one in everything else, and a program in this language.
class School {
  public:
    explicit School(const fs::path& language)
        : root_(kadr::testing::scratch("school-" + language.stem().string())) {
        const fs::path real = KADR_ROOT;
        fs::remove_all(root_);
        fs::create_directories(root_ / "dialects/languages");
        for (const char* name : {"iso", "sinumerik", "fanuc", "axioma"}) {
            const std::string file = std::string("dialects/") + name + ".xml";
            fs::create_symlink(real / file, root_ / file);
        }
        fs::create_symlink(real / "stdlib", root_ / "stdlib");
        fs::create_symlink(real / "runtime/machines", root_ / "machines");
        fs::create_symlink(language, root_ / "dialects/languages/school.xml");
        std::ofstream(program(), std::ios::binary) << "language school;\nprogram p() { }\n";
    }
    ~School() { fs::remove_all(root_); }
    School(const School&) = delete;
    School& operator=(const School&) = delete;
    fs::path program() const { return root_ / "lesson.kadr"; }
    std::string variable() const { return "KADR_SHARE=" + root_.string(); }

  private:
    fs::path root_;
};

std::vector<std::string> command_line(const std::string& arguments, const fs::path& file,
                                      const fs::path& out, const School* school = nullptr) {
    std::vector<std::string> words = {KADR_BINARY};
    if (school != nullptr) words = {"/usr/bin/env", school->variable(), KADR_BINARY};
    std::istringstream text(arguments);
    for (std::string word; text >> word;) {
        const auto replace = [&word](const std::string& from, const std::string& to) {
            const std::size_t at = word.find(from);
            if (at != std::string::npos) word.replace(at, from.size(), to);
        };
        replace("{file}", file.string());
        replace("{out}", out.string());
        replace("{dir}", file.parent_path().string());
        if (school != nullptr) replace("{school}", school->program().string());
        words.push_back(word);
    }
    words.insert(words.end(), {"--diagnostics", "json"});
    return words;
}

/// The messages of a run that are not warnings, as "line:column code message".
std::vector<Expectation> messages_of(const std::string& err) {
    std::vector<Expectation> messages;
    std::istringstream lines(err);
    for (std::string line; std::getline(lines, line);) {
        const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
        if (!json.is_object() || json.value("severity", "") == "warning") continue;
        std::string text = json.value("message", "");
        if (json.contains("alarm_text")) text = json.value("alarm_text", "") + ": " + text;
        messages.push_back(
            {std::to_string(json.value("line", 0)) + ":" + std::to_string(json.value("column", 0)),
             json.value("alarm", json.value("code", "")), text});
    }
    return messages;
}

class BadInput : public ::testing::TestWithParam<fs::path> {};

TEST_P(BadInput, GivesTheRightMessage) {
    const fs::path file = GetParam();
    const Case wanted = parse_case(file);
    ASSERT_FALSE(wanted.expected.empty()) << file << " says no `expect:`";
    const fs::path out = kadr::testing::scratch(file.stem().string() + ".out");
    const std::string before = "an existing file\n";
    std::ofstream(out, std::ios::binary) << before;

    std::optional<School> school;
    if (file.parent_path().filename() == "languages") school.emplace(file);
    const ProcessResult result =
        run_process(command_line(wanted.arguments, file, out, school ? &*school : nullptr));
    EXPECT_EQ(result.status, wanted.status) << result.err;
    const std::vector<Expectation> messages = messages_of(result.err);
    ASSERT_EQ(messages.size(), wanted.expected.size()) << result.err;
    for (std::size_t i = 0; i < messages.size(); ++i) {
        const Expectation& expected = wanted.expected[i];
        EXPECT_EQ(messages[i].place, expected.place) << result.err;
        EXPECT_EQ(messages[i].code, expected.code) << result.err;
        EXPECT_NE(messages[i].words.find(expected.words), std::string::npos) << result.err;
    }
    // An alarm stops a run, and what was executed before it is delivered; an error delivers
    // nothing.
    if (wanted.status != 3) {
        EXPECT_EQ(content_of(out), before);
    }
    fs::remove(out);
}

/// A message that has a place shows the line there, and marks it; but for an end that is missing,
/// where nothing stands.
TEST_P(BadInput, ShowsTheLineWithACaret) {
    const fs::path file = GetParam();
    const Case wanted = parse_case(file);
    std::optional<School> school;
    if (file.parent_path().filename() == "languages") school.emplace(file);
    const fs::path out = kadr::testing::scratch(file.stem().string() + ".out");
    std::vector<std::string> words =
        command_line(wanted.arguments, file, out, school ? &*school : nullptr);
    words.resize(words.size() - 2);  // as text
    std::istringstream lines(run_process(words).err);
    fs::remove(out);
    static const std::regex kPlace(":[0-9]+:[0-9]+: (error|alarm|warning)\\[");
    static const std::regex kShown("^ *[0-9]+ \\| .*");
    std::string line;
    while (std::getline(lines, line)) {
        const bool is_missing_end = line.find("alarm[PS5010]") != std::string::npos;
        // Of a file that is no text of its kind nothing is shown.
        const bool is_other_file = line.find("XML: there is no element") != std::string::npos;
        if (is_missing_end || is_other_file || !std::regex_search(line, kPlace)) continue;
        std::string shown;
        std::string mark;
        std::getline(lines, shown);
        std::getline(lines, mark);
        EXPECT_TRUE(std::regex_match(shown, kShown)) << line << '\n' << shown;
        EXPECT_NE(mark.find('^'), std::string::npos) << line << '\n' << shown << '\n' << mark;
    }
}

std::vector<fs::path> all_cases() {
    std::vector<fs::path> cases;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kCases)) {
        if (!entry.is_regular_file()) continue;
        const std::string text = content_of(entry.path());
        if (text.find("expect: ") != std::string::npos) cases.push_back(entry.path());
    }
    std::sort(cases.begin(), cases.end());
    return cases;
}

std::string name_of(const ::testing::TestParamInfo<fs::path>& info) {
    std::string name =
        info.param.parent_path().filename().string() + "_" + info.param.stem().string();
    std::replace_if(
        name.begin(), name.end(),
        [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Files, BadInput, ::testing::ValuesIn(all_cases()), name_of);

// ------------------------------------------------------------------ input that is made here

struct Rubbish {
    const char* name;
    const char* arguments;
    const char* suffix;
    std::string text;
    int status;
};

std::string repeated(const std::string& text, std::size_t count) {
    std::string all;
    all.reserve(text.size() * count);
    for (std::size_t i = 0; i < count; ++i) all += text;
    return all;
}

std::string noise(std::size_t size) {
    std::string text(size, '\0');
    std::uint32_t state = 12345;
    for (char& c : text) {
        state = state * 1664525u + 1013904223u;
        c = static_cast<char>(state >> 24);
    }
    return text;
}

std::vector<Rubbish> rubbish() {
    const std::size_t mega = 1000000;
    return {
        {"BinaryAsSource", "expand {file}", ".kadr", noise(200000), 1},
        {"BinaryAsIso", "run {file} -d sinumerik", ".mpf", noise(200000), 3},
        {"BinaryAsFanuc", "run {file} -d fanuc", ".nc", noise(200000), 3},
        {"BinaryAsDialect", "dialect check {file}", ".xml", noise(200000), 1},
        {"BinaryAsMachine", "machine check {file}", ".xml", noise(200000), 1},
        {"HundredMegabyteSourceLine", "expand {file}", ".kadr",
         "program p() { G1 X" + repeated("1", 100 * mega), 1},
        {"HundredMegabyteIsoLine", "run {file} -d sinumerik", ".mpf",
         "N10 G1 X" + repeated("1", 100 * mega), 3},
        {"HundredMegabyteFanucLine", "run {file} -d fanuc", ".nc",
         "%\nO0001\nX" + repeated("1", 100 * mega), 3},
        {"DeepBrackets", "expand {file}", ".kadr",
         "program p() { G1 X=" + repeated("(", 100000) + "1", 1},
        {"DeepBraces", "expand {file}", ".kadr", "program p() " + repeated("{", 100000), 1},
        {"DeepUnary", "expand {file}", ".kadr",
         "program p() { real a = " + repeated("- ", 100000) + "1; }", 1},
        {"DeepIfs", "expand {file}", ".kadr",
         "program p() { " + repeated("if (true) ", 100000) + "; }", 1},
        {"LongSum", "expand {file}", ".kadr",
         "program p() { real a = 1" + repeated(" + 1", 600000) + "; }", 1},
        {"DeepXml", "dialect check {file}", ".xml", repeated("<dialect>", 100000), 1},
        {"EmptySource", "expand {file}", ".kadr", "", 1},
        {"EmptyXml", "machine check {file}", ".xml", "", 1},
        {"NulInText", "run -d fanuc {file}", ".nc",
         std::string("%\nO1\nG0 X1.\0 Y2.\nM30\n%\n", 24), 3},
        {"NulInSource", "expand {file}", ".kadr", std::string("program p() { G0\0 X1; }", 23), 1},
    };
}

class MadeInput : public ::testing::TestWithParam<Rubbish> {};

TEST_P(MadeInput, EndsWithAMessage) {
    const Rubbish& wrong = GetParam();
    const fs::path file = kadr::testing::scratch(std::string(wrong.name) + wrong.suffix);
    std::ofstream(file, std::ios::binary) << wrong.text;
    const ProcessResult result = run_process(command_line(wrong.arguments, file, {}));
    EXPECT_EQ(result.status, wrong.status) << result.err.substr(0, 2000);
    EXPECT_FALSE(messages_of(result.err).empty()) << result.err.substr(0, 2000);
    EXPECT_LT(result.err.size(), 200000u) << "a flood of messages";
    fs::remove(file);
}

INSTANTIATE_TEST_SUITE_P(Rubbish, MadeInput, ::testing::ValuesIn(rubbish()),
                         [](const auto& made) { return std::string(made.param.name); });

struct Call {
    const char* name;
    std::vector<std::string> arguments;
    int status;
    const char* words;
};

class WrongCall : public ::testing::TestWithParam<Call> {};

TEST_P(WrongCall, SaysSo) {
    std::vector<std::string> words = {KADR_BINARY};
    words.insert(words.end(), GetParam().arguments.begin(), GetParam().arguments.end());
    const ProcessResult result = run_process(words);
    EXPECT_EQ(result.status, GetParam().status) << result.err;
    EXPECT_NE(result.err.find(GetParam().words), std::string::npos) << result.err;
}

const std::string kExample = std::string(KADR_ROOT) + "/examples/bracket.kadr";

const std::string kText = std::string(KADR_ROOT) + "/tests/bad/cases/sinumerik/no_feed.mpf";

const std::string kPrinting = std::string(KADR_ROOT) + "/tests/control/fanuc/messages/print.nc";

INSTANTIATE_TEST_SUITE_P(
    Calls, WrongCall,
    ::testing::Values(
        Call{"NothingToDo", {}, 2, "expand"}, Call{"UnknownCommand", {"explode"}, 2, "explode"},
        Call{"UnknownOption", {"expand", kExample, "--fast"}, 2, "--fast"},
        Call{"NoSource", {"expand"}, 2, "SRC"},
        Call{"MissingFile", {"expand", "no-such-file.kadr"}, 2, "K9001"},
        Call{"FolderAsFile", {"run", KADR_ROOT}, 2, "K9001"},
        Call{"UnknownDialect", {"expand", kExample, "-d", "heidenhain"}, 2, "heidenhain"},
        Call{"MissingDialectFile", {"expand", kExample, "-d", "./none.xml"}, 2, "none.xml"},
        Call{"UnknownMachine", {"run", kExample, "-m", "robot"}, 2, "robot"},
        Call{"UnwritableOutput", {"expand", kExample, "-o", "/no/such/folder/a.nc"}, 2, "K9002"},
        Call{"UnwritablePlot", {"run", kExample, "--plot", "/no/such/folder/a.svg"}, 2, "K9002"},
        Call{"UnknownParameter", {"expand", kExample, "-D", "widht=1mm"}, 1, "width"},
        Call{"WrongUnit", {"expand", kExample, "-D", "width=10deg"}, 1, "width"},
        Call{"NotANumber", {"expand", kExample, "-D", "width=wide"}, 1, "width"},
        Call{"DefineWithoutValue", {"expand", kExample, "-D", "width"}, 2, "width"},
        Call{"BadTick", {"run", kExample, "--tick", "0s"}, 2, "--tick"},
        Call{"UnknownCode", {"explain", "K0000"}, 2, "[K9010]: there is no message `K0000`"},
        Call{"UnknownWord", {"dialect", "explain", "fanuc", "G999"}, 1, "[K9012]"},
        Call{"ExpandOfText", {"expand", kText}, 2, "[K9006]"},
        Call{"TestsOfText", {"test", kText}, 2, "[K9058]"},
        Call{"PrintWithoutFile", {"run", kPrinting, "-d", "fanuc"}, 0, "[K9028]"},
        Call{"SourceMapOfText", {"run", kText, "--map", "-"}, 2, "[K9011]"}),
    [](const auto& made) { return std::string(made.param.name); });

}  // namespace

}  // namespace bad_test
