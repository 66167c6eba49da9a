// Runs tests/driver/debug: programs with conversations at their break points (see the README
// there), and asks the engine as a protocol would, without a word of text.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "driver/debug/engine.h"
#include "driver/debug/stepping.h"
#include "driver/run.h"
#include "driver/session.h"
#include "tests/common/inputs.h"

namespace kadr::debug_test {
namespace {

namespace fs = std::filesystem;
using namespace kadr::driver;

const fs::path kFolder = fs::path(KADR_ROOT) / "tests/driver/debug";

/// A folder with the program, and links to what lies beside it.
class ScratchFolder {
  public:
    ScratchFolder()
        : path_(fs::temp_directory_path() / ("kadr-debug-" + std::to_string(::getpid()))) {
        fs::create_directories(path_);
    }
    ~ScratchFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    std::string file(const std::string& name) const { return (path_ / name).string(); }
    std::string with_names(std::string text) const {
        const std::string prefix = path_.string() + '/';
        for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix))
            text.erase(at, prefix.size());
        return text;
    }

  private:
    fs::path path_;
};

/// What somebody sees who has these places and gives these answers.
struct Talk {
    std::string program;  // its file
    std::string dialect = "sinumerik";
    std::vector<std::string> breaks;
    std::vector<std::string> until;
    std::vector<std::string> answers;
    bool reads_json = false;  // and nobody answers

    std::string perform() const {
        std::string words;
        Sources sources = test::inputs().new_sources();
        Messages messages(sources, {}, [&words](std::string_view text) { words += text; });
        Options options;
        options.dialect = dialect;
        options.allow_read = {kFolder.string()};
        Session session(options, test::inputs(), sources, messages);
        RunJob job;
        job.source = program;
        job.breaks = breaks;
        job.until = until;

        job.outputs["--commands"] = "/dev/null";
        job.outputs.erase("--summary");
        job.onlooker.say = [&words](std::string_view text) { words += text; };
        std::size_t next = 0;
        job.onlooker.reads_json = reads_json;
        const auto ask = [&]() -> std::optional<std::string> {
            if (next == answers.size()) return std::nullopt;
            words += "> " + answers[next] + '\n';
            return answers[next++];
        };
        if (!reads_json) job.onlooker.ask = ask;
        const Status status = run(session, job);
        messages.finish();
        return words + "exit status " + std::to_string(static_cast<int>(status)) + '\n';
    }
};

/// A file of the folder: the program, what is asked, what is said.
struct Script {
    std::string program;
    std::string questions;  // as they stand there
    std::string said;
    std::string mark;  // of a comment
    Talk talk;
};

Script read_script(const std::string& name, const std::string& text) {
    Script script;
    script.mark = name.ends_with(".kadr") ? "//" : ";";
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(script.mark + "> ") || line == script.mark + '>') {
            script.said += line + '\n';
        } else if (line.starts_with(script.mark + "?")) {
            script.questions += line + '\n';
            const std::string asked = line.substr(std::min(line.size(), script.mark.size() + 2));
            if (asked.starts_with("break ")) script.talk.breaks.push_back(asked.substr(6));
            else if (asked.starts_with("until ")) script.talk.until.push_back(asked.substr(6));
            else script.talk.answers.push_back(asked);
        } else {
            script.program += line + '\n';
            constexpr std::string_view kDialect = "dialect: ";
            const std::size_t at = line.find(kDialect);
            if (at == std::string::npos) continue;
            std::string dialect = line.substr(at + kDialect.size());
            script.talk.dialect = dialect.substr(0, dialect.find_first_of(" )"));
        }
    }
    return script;
}

std::string as_comments(const std::string& mark, const std::string& said) {
    std::string out;
    std::istringstream lines(said);
    for (std::string line; std::getline(lines, line);)
        out += mark + (line.empty() ? ">" : "> " + line) + '\n';
    return out;
}

class Conversations : public ::testing::TestWithParam<std::string> {};

TEST_P(Conversations, AreAsTheyStandThere) {
    const fs::path file = kFolder / GetParam();
    const std::string text = read_file(file.string()).value_or("");
    Script script = read_script(GetParam(), text);
    ASSERT_FALSE(script.questions.empty());
    const ScratchFolder scratch;
    for (const fs::directory_entry& other : fs::directory_iterator(kFolder)) {
        if (other.path().filename().string().starts_with('_'))
            fs::copy(other.path(), scratch.file(other.path().filename().string()));
    }
    script.talk.program = scratch.file(GetParam());
    ASSERT_TRUE(write_file_whole(script.talk.program, script.program));
    const std::string said = scratch.with_names(script.talk.perform());
    const std::string actual = script.program + script.questions + as_comments(script.mark, said);
    if (std::getenv("KADR_UPDATE") != nullptr) {
        ASSERT_TRUE(actual == text || write_file_whole(file.string(), actual));
        return;
    }
    EXPECT_EQ(text, actual);
}

std::vector<std::string> all_scripts() {
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(kFolder)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with('_') && name != "README.md") names.insert(name);
    }
    return {names.begin(), names.end()};
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::replace_if(
        name.begin(), name.end(),
        [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, Conversations, ::testing::ValuesIn(all_scripts()), test_name);

/// Nobody answers: what is reported, as one object; the line of the text where the statement makes
/// one, else the statement.
TEST(Reports, StopsOfAKadrProgramAsObjects) {
    const ScratchFolder scratch;
    const std::string program = scratch.file("report.kadr");
    ASSERT_TRUE(
        write_file_whole(program,
                         "void go(length x) {\n    length twice = 2*x;\n    G0 X=twice;\n}\n"
                         "program report() {\n    int n = 3;\n    go(2mm);\n}\n"));
    struct Row {
        const char* place;
        const char* file;
        int line;
        const char* text;
        const char* locals;
    };
    for (const Row& row :
         {Row{":6", "report.kadr", 6, "    int n = 3;", "{}"},
          Row{":2", "report.kadr", 2, "    length twice = 2*x;", R"({"x":"2 mm"})"},
          Row{":3", "report.mpf", 3, "N20 G0 X4", R"({"twice":"4 mm","x":"2 mm"})"},
          Row{":7", "report.mpf", 3, "N20 G0 X4", R"({"n":"3"})"},
          Row{"go", "report.mpf", 3, "N20 G0 X4", R"({"x":"2 mm"})"},
          Row{"report", "report.kadr", 6, "    int n = 3;", "{}"}}) {
        SCOPED_TRACE(row.place);
        Talk talk;
        talk.program = program;
        talk.breaks = {row.place};
        talk.reads_json = true;
        const std::string said = scratch.with_names(talk.perform());
        const nlohmann::json stop = nlohmann::json::parse(
            said.substr(said.find("{\"stopped\""), said.find("exit") - said.find("{\"stopped\"")));
        EXPECT_EQ(stop["stopped"], "stopped before `" + std::string(row.place) + '`');
        EXPECT_EQ(stop["file"], row.file);
        EXPECT_EQ(stop["line"], row.line);
        EXPECT_EQ(stop["text"], row.text);
        EXPECT_EQ(stop["locals"].dump(), row.locals);
    }
}

// ---------------------------------------------------------------- the engine as data

/// A run of a program with an engine that a test answers for.
class EngineTest : public ::testing::Test {
  protected:
    /// Runs to the end; `stand` is shown each stop.
    void run(const std::string& name, const std::string& text, DebugEngine::Stand stand) {
        const std::string file = scratch_.file(name);
        ASSERT_TRUE(write_file_whole(file, text));
        engine.stand_by(std::move(stand));
        Aside aside;
        engine.look_on(aside);
        auto source = open_source(session_, file);
        ASSERT_TRUE(source != nullptr);
        auto execution = Execution::open(session_, file, std::move(source), aside);
        ASSERT_TRUE(execution != nullptr) << said_;
        engine.follow(*execution);
        std::vector<path::Command> one(1);
        while (execution->pull(one) > 0) continue;
        engine.finish(messages_.first_alarm());
    }
    PlaceId stop_at(const std::string& place) {
        return engine.places().add(*BreakPoint::parse(place), WatchedPlace::Effect::Stops);
    }
    /// `name type value` of each, one a line.
    static std::string listed(const std::vector<Variable>& variables) {
        std::string out;
        for (const Variable& variable : variables)
            out += variable.name + " | " + variable.type + " | " + variable.value + '\n';
        return out;
    }
    VariablesRef scope(std::size_t frame, Scope::Kind kind) {
        for (const Scope& scope : engine.inspection().scopes(frame)) {
            if (scope.kind == kind) return scope.variables;
        }
        return {};
    }

  private:
    static Options options() {
        Options options;
        options.dialect = "sinumerik";
        return options;
    }

    ScratchFolder scratch_;
    Sources sources_ = test::inputs().new_sources();
    std::string said_;
    Messages messages_{sources_, {}, [this](std::string_view text) { said_ += text; }};
    Session session_{options(), test::inputs(), sources_, messages_};

  protected:
    DebugEngine engine{session_};
};

constexpr const char* kHoles =
    "struct hole { point at; length d; }\n"
    "real sum = 0;\n"
    "void bore(hole h, int depth) {\n"
    "    sum += depth;\n"
    "    G0 X=h.at.x Y=h.at.y;\n"
    "    if (depth > 0) bore(h, depth - 1);\n"
    "}\n"
    "program part() {\n"
    "    hole[] all;\n"
    "    for (int i : 1..250) all.append({{x: 10mm*i, y: 5mm}, 3mm});\n"
    "    bore(all[1], 1);\n"
    "}\n";

TEST_F(EngineTest, FramesScopesAndPartsOfValues) {
    const PlaceId place = stop_at(":5");
    std::vector<std::string> stacks;
    run("holes.kadr", kHoles, [&](const Stop& stop) {
        EXPECT_EQ(stop.reason, StopReason::Place);
        EXPECT_EQ(stop.place, place);
        EXPECT_TRUE(stop.is_at_statement());
        std::string stack;
        Inspection& seen = engine.inspection();
        for (const StackFrame& frame : seen.frames())
            stack += frame.name + ':' + std::to_string(frame.line) + ' ';
        stacks.push_back(stack);
        if (stacks.size() == 1) return Resume::Continue;
        EXPECT_EQ(listed(seen.variables(scope(0, Scope::Kind::Locals))),
                  "h | hole | {at: {x: 20mm, y: 5mm}, d: 3mm}\ndepth | int | 0\n");
        EXPECT_EQ(listed(seen.variables(scope(0, Scope::Kind::Globals))), "sum | real | 1\n");
        EXPECT_EQ(listed(seen.variables(scope(1, Scope::Kind::Locals))),
                  "h | hole | {at: {x: 20mm, y: 5mm}, d: 3mm}\ndepth | int | 1\n");
        const std::vector<Variable> own = seen.variables(scope(2, Scope::Kind::Locals));
        EXPECT_EQ(own.size(), 1u);
        EXPECT_EQ(own.at(0).part_count, 250);
        // Of a long list as much as was asked for.
        EXPECT_EQ(seen.variables(own.at(0).parts).size(), Inspection::kElementsAtOnce);
        const std::vector<Variable> last = seen.variables(own.at(0).parts, 249, 5);
        EXPECT_EQ(listed(last), "[249] | hole | {at: {x: 2500mm, y: 5mm}, d: 3mm}\n");
        const std::vector<Variable> members = seen.variables(last.at(0).parts);
        EXPECT_EQ(listed(members), "at | point | {x: 2500mm, y: 5mm}\nd | length | 3mm\n");
        EXPECT_EQ(listed(seen.variables(members.at(0).parts)),
                  "x | length? | 2500mm\ny | length? | 5mm\nz | length? | not given\n");
        return Resume::End;
    });
    EXPECT_EQ(stacks, (std::vector<std::string>{"bore:5 part:11 holes.mpf:3 ",
                                                "bore:5 bore:6 part:11 holes.mpf:4 "}));
    EXPECT_EQ(engine.ending(), StopReason::End);
}

TEST_F(EngineTest, StopsBelongTogetherWithTheirPosition) {
    engine.stop_at_entry();
    std::vector<std::string> stops;
    run("walk.kadr",
        "program walk() {\n    length x = 1mm;\n    G0 X=x;\n    x *= 3;\n    G0 X=x;\n}\n",
        [&](const Stop& stop) {
            EXPECT_EQ(stop.reason, stops.empty() ? StopReason::Entry : StopReason::Step);
            Inspection& seen = engine.inspection();
            const std::vector<Variable> locals = seen.variables(scope(0, Scope::Kind::Locals));
            stops.push_back(std::to_string(seen.frames()[0].line) + ": x " +
                            (locals.empty() ? "-" : locals[0].value) + ", X " +
                            seen.variables(scope(1, Scope::Kind::Position))[0].value + ", next " +
                            stop.line->text);
            return Resume::StepIn;
        });
    EXPECT_EQ(stops, (std::vector<std::string>{
                         "2: x -, X 0.000, next N20 G0 X1", "3: x 1 mm, X 0.000, next N20 G0 X1",
                         "4: x 1 mm, X 1.000, next N30 X3", "5: x 3 mm, X 1.000, next N30 X3"}));
    EXPECT_EQ(engine.ending(), StopReason::End);
}

TEST_F(EngineTest, ProgramsOfTheControlAreFrames) {
    stop_at("INNER");
    int stops = 0;
    run("outer.mpf",
        "DEF REAL AA=1\nR1=5\nOUTER(7)\nM30\n"
        "%_N_OUTER_SPF\nPROC OUTER(REAL BB)\nINNER\nRET\n"
        "%_N_INNER_SPF\nPROC INNER\nDEF INT CC=3\nG0 X1\nRET\n",
        [&](const Stop& stop) {
            ++stops;
            EXPECT_FALSE(stop.is_at_statement());
            Inspection& seen = engine.inspection();
            std::string stack;
            for (const StackFrame& frame : seen.frames())
                stack += frame.name.substr(frame.name.rfind('/') + 1) + ':' +
                         std::to_string(frame.line) + ' ';
            EXPECT_EQ(stack, "INNER:9 OUTER:7 outer.mpf:3 ");
            EXPECT_EQ(listed(seen.variables(scope(1, Scope::Kind::ProgramLocals))),
                      "BB | REAL | 7\n");
            EXPECT_EQ(listed(seen.variables(scope(2, Scope::Kind::ProgramLocals))),
                      "AA | REAL | 1\n");
            EXPECT_EQ(listed(seen.variables(scope(0, Scope::Kind::CommonVariables))),
                      "R1 | REAL | 5\n");
            EXPECT_FALSE(seen.variables(scope(0, Scope::Kind::Codes)).empty());
            EXPECT_EQ(seen.variables(scope(0, Scope::Kind::State)).at(0).name, "feed");
            return Resume::Continue;
        });
    EXPECT_EQ(stops, 1);
}

TEST_F(EngineTest, EndsHaveAReason) {
    engine.places().add(*BreakPoint::parse(":3"), WatchedPlace::Effect::Ends);
    run("until.kadr", "program p() {\n    int n = 1;\n    n += 1;\n    G0 X=n;\n}\n",
        [](const Stop&) { return Resume::Continue; });
    EXPECT_EQ(engine.ending(), StopReason::Until);
}

TEST_F(EngineTest, AnErrorStandsWhereItHappened) {
    stop_at("nowhere");
    std::string seen;
    run("fault.kadr", "program p() {\n    int n = 0;\n    G0 X1;\n    n = 7 % n;\n    G0 X2;\n}\n",
        [&](const Stop& stop) {
            EXPECT_EQ(stop.reason, StopReason::Alarm);
            seen = std::to_string(engine.inspection().frames()[0].line) + ' ' +
                   listed(engine.inspection().variables(scope(0, Scope::Kind::Locals)));
            return Resume::Continue;
        });
    EXPECT_EQ(seen, "4 n | int | 0\n");
    EXPECT_EQ(engine.ending(), StopReason::Alarm);
}

TEST_F(EngineTest, APlaceCanBeTakenBackAndAPauseComesAtOnce) {
    const PlaceId place = stop_at(":3");
    std::vector<StopReason> reasons;
    run("loop.kadr",
        "program p() {\n    for (int i = 0; i < 5; i++) {\n        G0 X=i;\n    }\n}\n",
        [&](const Stop& stop) {
            reasons.push_back(stop.reason);
            engine.places().remove(place);
            if (reasons.size() == 1) engine.pause();
            return Resume::Continue;
        });
    EXPECT_EQ(reasons, (std::vector<StopReason>{StopReason::Place, StopReason::Pause}));
}

TEST(Stepping, GoesAsFarAsItWasAsked) {
    struct Row {
        Resume how;
        Arrival at;
        bool ends;
    };
    const Arrival from{true, 2};
    for (const Row& row :
         {Row{Resume::StepIn, {true, 3}, true}, Row{Resume::StepIn, {true, 1}, true},
          Row{Resume::StepIn, {false, 0}, false}, Row{Resume::StepOver, {true, 3}, false},
          Row{Resume::StepOver, {true, 2}, true}, Row{Resume::StepOver, {true, 1}, true},
          Row{Resume::StepOut, {true, 2}, false}, Row{Resume::StepOut, {true, 1}, true},
          Row{Resume::Continue, {true, 1}, false}}) {
        SCOPED_TRACE(static_cast<int>(row.how) * 10 + static_cast<int>(row.at.depth));
        EXPECT_EQ((Advance{row.how, from, StopReason::Step}.ends_at(row.at)), row.ends);
    }
}

}  // namespace
}  // namespace kadr::debug_test
