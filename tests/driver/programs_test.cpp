// Runs tests/programs: Kadr programs with the expectation beside the line (see the README there).
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "base/diagnostics/driver.h"
#include "base/diagnostics/iso.h"
#include "base/disk_files.h"
#include "base/text.h"
#include "driver/expand.h"
#include "driver/run.h"
#include "tests/common/inputs.h"

namespace programs_test {

namespace {

namespace fs = std::filesystem;
using namespace kadr;
using nlohmann::json;

const fs::path kPrograms = fs::path(KADR_ROOT) / "tests/programs";

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

bool is_expectation(const std::string& line) {
    return line.starts_with("//>") || line.starts_with("//!");
}

/// A program as it stands in its file, without its expectations.
struct TestProgram {
    std::vector<std::string> lines;                            // code only
    std::map<std::size_t, std::vector<std::string>> expected;  // by number of the line, from 1
    driver::Options options;
    bool executes = true;
    bool is_body = false;  // `program` is put around it

    std::string code() const {
        std::string text = is_body ? "program test() {\n" : "";
        for (const std::string& line : lines) text += line + '\n';
        return is_body ? text + "}\n" : text;
    }
    /// Number of a line of `code()` in `lines`.
    std::size_t own_line(std::size_t line) const { return is_body ? line - 1 : line; }
};

TestProgram read_program(const std::string& text) {
    TestProgram program;
    program.is_body = true;
    for (const std::string& line : lines_of(text)) {
        if (is_expectation(line)) {
            program.expected[program.lines.size()].push_back(line);
            continue;
        }
        program.lines.push_back(line);
        const auto header = [&line](const std::string& name) {
            const std::string start = "// " + name + ": ";
            return line.starts_with(start) ? line.substr(start.size()) : std::string();
        };
        if (const std::string name = header("dialect"); !name.empty())
            program.options.dialect = name;
        if (const std::string cycles = header("cycles"); !cycles.empty()) {
            program.options.native_cycles = cycles == "native";
        }
        if (const std::string define = header("define"); !define.empty()) {
            const std::size_t equals = define.find('=');
            program.options.defines.push_back(
                {define.substr(0, equals), define.substr(equals + 1)});
        }
        if (const std::string name = header("machine"); !name.empty())
            program.options.machine = name;
        if (header("execute") == "no") program.executes = false;
        if (line.starts_with("program ") || line.starts_with("language ")) program.is_body = false;
    }
    return program;
}

/// What a program did: expectations as they should stand, by number of the line.
class Observation {
  public:
    explicit Observation(const TestProgram& program, const fs::path& file)
        : program_(program), file_(file) {}

    std::map<std::size_t, std::vector<std::string>> observe();

  private:
    driver::Status work(bool executes, const fs::path& text, const fs::path& map);
    void add_text(const std::string& text, const std::string& map);
    void add_message(const json& message);
    std::size_t line_of(const json& entry) const;

    const TestProgram& program_;
    fs::path file_;
    std::string messages_;
    std::map<std::size_t, std::vector<std::string>> seen_;
};

driver::Status Observation::work(bool executes, const fs::path& text, const fs::path& map) {
    messages_.clear();
    Sources sources = test::inputs().new_sources();
    driver::Messages messages(sources, {driver::MessageFormat::Json, false, 20},
                              [this](std::string_view line) { messages_ += line; });
    driver::Session session(program_.options, test::inputs(), sources, messages);
    if (executes) {
        driver::RunJob job;
        job.source = file_.string();
        job.outputs["--commands"] = text.string();
        return driver::run(session, job);
    }
    return driver::expand(session, {file_.string(), text.string(), map.string()});
}

/// The line of this file behind an entry of the source map: of the statement, or of the innermost
/// call that stands here. 0: none.
std::size_t Observation::line_of(const json& entry) const {
    const auto own = [this](const json& place) {
        return place.contains("file") && place["file"] == file_.string();
    };
    if (own(entry)) return program_.own_line(entry["end_line"]);
    for (auto call = entry["calls"].rbegin(); call != entry["calls"].rend(); ++call) {
        if (own(*call)) return program_.own_line((*call)["line"]);
    }
    return 0;
}

void Observation::add_text(const std::string& text, const std::string& map) {
    const std::vector<std::string> lines = lines_of(text);
    for (const std::string& entry_text : lines_of(map)) {
        const json entry = json::parse(entry_text);
        const std::size_t line = line_of(entry);
        const std::size_t first = entry["iso"];
        for (std::size_t i = first; i < first + entry["lines"].get<std::size_t>(); ++i) {
            if (i > lines.size()) ADD_FAILURE() << "the source map names line " << i;
            else if (line > 0) seen_[line].push_back("//> " + lines[i - 1]);
        }
    }
}

void Observation::add_message(const json& message) {
    // These are pieces of programs: that they call no tool matters only where a machine is named.
    if (program_.options.machine.empty() && message["code"] == diag::ToolNeverCalled.code) return;
    if (message["code"] == kadr::diag::EndedByAlarm.code) return;  // says where the outputs are
    const auto is_own = [this](const json& place) {
        return place.contains("line") && place["file"] == file_.string();
    };
    json place = message;
    for (const json& note : message["notes"]) {
        if (!is_own(place) && is_own(note)) place = note;
    }
    const std::string name = message.contains("alarm") ? message["alarm"] : message["code"];
    std::string line = "//!";
    std::size_t number = program_.lines.size();
    if (is_own(place)) {
        const std::size_t column = place["column"];
        // Of a place of several lines the first is marked.
        const std::string& shown = program_.lines.at(program_.own_line(place["line"]) - 1);
        const std::size_t end = place["end_line"] == place["line"]
                                    ? place["end_column"].get<std::size_t>()
                                    : kadr::count_code_points(shown) + 1;
        if (column > 3)
            line += std::string(column - 4, ' ') + '^' + std::string(end - column - 1, '~');
        number = program_.own_line(place["line"]);
    }
    seen_[number].push_back(line + ' ' + name + ' ' + message["message"].get<std::string>());
}

std::map<std::size_t, std::vector<std::string>> Observation::observe() {
    const std::string stem = file_.string() + ".out";
    const driver::Status status = work(false, stem + ".nc", stem + ".map");
    if (status == driver::Status::Done) {
        add_text(read_file(stem + ".nc").value_or(""), read_file(stem + ".map").value_or(""));
        if (program_.executes) work(true, stem + ".jsonl", {});
    }
    for (const std::string& line : lines_of(messages_)) add_message(json::parse(line));
    return seen_;
}

std::string with_expectations(const TestProgram& program,
                              const std::map<std::size_t, std::vector<std::string>>& expected) {
    std::string text;
    for (std::size_t i = 0; i <= program.lines.size(); ++i) {
        if (i > 0) text += program.lines[i - 1] + '\n';
        const auto found = expected.find(i);
        if (found == expected.end()) continue;
        for (const std::string& line : found->second) text += line + '\n';
    }
    return text;
}

/// A folder of its own for one test, beside nothing that matters.
class ScratchFolder {
  public:
    ScratchFolder() {
        path_ = fs::temp_directory_path() / ("kadr-programs-" + std::to_string(::getpid()));
        fs::create_directories(path_);
    }
    ~ScratchFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    const fs::path& path() const { return path_; }
    /// Imports and tables are looked for beside a program.
    void link_neighbours(const fs::path& file) const {
        for (const fs::directory_entry& entry : fs::directory_iterator(file.parent_path())) {
            if (entry.path() != file)
                fs::create_symlink(entry.path(), path_ / entry.path().filename());
        }
    }

  private:
    fs::path path_;
};

class Programs : public ::testing::TestWithParam<std::string> {};

TEST_P(Programs, DoWhatTheirCommentsSay) {
    const fs::path file = kPrograms / GetParam();
    const std::string text = read_file(file.string()).value_or("");
    TestProgram program = read_program(text);
    // The links beside the copy lead there.
    program.options.allow_read.push_back(file.parent_path().string());
    const ScratchFolder scratch;
    scratch.link_neighbours(file);
    const fs::path copy = scratch.path() / file.filename();
    ASSERT_TRUE(write_file_whole(copy.string(), program.code()));
    const auto seen = Observation(program, copy).observe();
    const std::string actual = with_expectations(program, seen);
    if (std::getenv("KADR_UPDATE") != nullptr) {
        ASSERT_TRUE(actual == text || write_file_whole(file.string(), actual));
        return;
    }
    EXPECT_EQ(text, actual);
}

std::vector<std::string> all_programs() {
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kPrograms)) {
        // What begins with an underscore is imported by others.
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() == ".kadr" && !name.starts_with('_')) {
            names.insert(fs::relative(entry.path(), kPrograms).string());
        }
    }
    return {names.begin(), names.end()};
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
    std::string name = info.param.substr(0, info.param.rfind('.'));
    std::replace_if(
        name.begin(), name.end(),
        [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, Programs, ::testing::ValuesIn(all_programs()), test_name);

}  // namespace

}  // namespace programs_test
