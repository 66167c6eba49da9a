// Programs in the controls' own parametric languages, one rule of the manual each: where they
// stand, and how their comments say what must come of them, is in README.md. What is not told must
// not happen: a program without `alarm` ends without one.
#include "base/diagnostics/control.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/numbers.h"
#include "driver/cycles.h"
#include "driver/program_files.h"
#include "driver/session.h"
#include "macro/program.h"
#include "nc/dialect_on_machine.h"
#include "nc/mode_words.h"
#include "nc/scope_words.h"
#include "nc/tables.h"
#include "tests/common/inputs.h"
#include "tests/control/control_machines.h"
#include "tests/control/control_programs.h"
#include "tests/control/taken_ways.h"

namespace kadr::interp::control_test {

using macro::ControlVariable;
using macro::NcProgram;
using macro::PrintTarget;
using macro::ProgramFiles;
using macro::ProgramOptions;
using macro::VariableChange;
namespace {

namespace fs = std::filesystem;

/// A text in pieces of odd sizes that cannot be read again, or in one that can.
class PiecedText final : public nc::TextSource {
  public:
    PiecedText(std::string text, bool can_seek) : text_(std::move(text)), can_seek_(can_seek) {}
    std::string_view next() override {
        const std::size_t from = at_;
        at_ = std::min(text_.size(), at_ + (can_seek_ ? 1000 : 37));
        return std::string_view(text_).substr(from, at_ - from);
    }
    bool seek(std::uint64_t offset) override {
        if (!can_seek_) return false;
        at_ = static_cast<std::size_t>(offset);
        return true;
    }

  private:
    std::string text_;
    bool can_seek_;
    std::size_t at_ = 0;
};

struct Expected {
    std::map<std::string, std::string> variables;  // empty: unset
    std::vector<std::string> way;
    std::string path;
    std::vector<std::string> shown;     // messages and stops
    std::vector<std::string> dwells;    // s; if any is told
    std::vector<std::string> printed;   // lines
    std::vector<std::string> warnings;  // if any is told
    std::string alarm;
    std::string called;
    std::string fix;
    std::uint16_t skip_levels = 0;
    std::optional<std::uint64_t> passes;
    std::string machine;
    bool has_rule = false;
};

std::string content_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

Expected parse(const std::string& text) {
    Expected expected;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const auto value_of = [&](const std::string& key) -> std::string {
            const std::size_t at = line.find(key);
            if (at == std::string::npos) return "";
            std::string value = line.substr(at + key.size());
            while (!value.empty() && (value.back() == '\r' || value.back() == ' '))
                value.pop_back();
            if (line.starts_with('(') && value.ends_with(')')) value.pop_back();
            return value;
        };
        expected.has_rule |= !value_of("rule: ").empty();
        if (const std::string level = value_of("skip: "); !level.empty())
            expected.skip_levels = static_cast<std::uint16_t>(1u << std::stoi(level));
        if (const std::string passes = value_of("passes: "); !passes.empty())
            expected.passes = std::stoull(passes);
        if (const std::string name = value_of("machine: "); !name.empty()) expected.machine = name;
        const std::string value = value_of("expect: ");
        if (value.empty()) continue;
        if (value.starts_with("to ")) {
            expected.way.push_back(value.substr(3));
        } else if (value.starts_with("path ")) {
            expected.path += (expected.path.empty() ? "" : " ") + value.substr(5);
        } else if (value.starts_with("alarm ")) {
            expected.alarm = value.substr(6);
        } else if (value.starts_with("fix ")) {
            expected.fix = value.substr(4);
        } else if (value.starts_with("called ")) {
            if (!expected.called.empty()) expected.called += ' ';
            expected.called += value.substr(7);
        } else if (value.starts_with("dwell ")) {
            expected.dwells.push_back(value.substr(6));
        } else if (value.starts_with("print [")) {
            expected.printed.push_back(value.substr(7, value.size() - 8));
        } else if (value.starts_with("warning ")) {
            expected.warnings.push_back(value.substr(8));
        } else if (value.starts_with("message") || value == "stop") {
            expected.shown.push_back(value);
        } else if (const std::size_t blank = value.rfind(' ');
                   value.ends_with(" vacant") || value.ends_with(" unset")) {
            expected.variables[value.substr(0, blank)] = "";
        } else {
            const std::size_t sign = value.find('=');
            EXPECT_NE(sign, std::string::npos) << value;
            expected.variables[value.substr(0, sign)] = value.substr(sign + 1);
        }
    }
    return expected;
}

std::string shown(const ControlVariable& variable) {
    switch (variable.kind) {
        case ControlVariable::Kind::Text: return '"' + variable.text + '"';
        case ControlVariable::Kind::Bool: return variable.number != 0 ? "TRUE" : "FALSE";
        default: return format_shortest(round_to(variable.number, 9));
    }
}

std::string kind_of(const path::Command& command) {
    if (command.op() == path::Op::Rapid) return "rapid";
    if (command.op() == path::Op::Line) return "line";
    if (command.op() == path::Op::Spline) return "spline";
    if (command.op() == path::Op::Involute) return "involute";
    const bool is_arc = command.op() == path::Op::Arc;
    return is_arc && command.motion().arc().is_clockwise ? "cw" : "ccw";
}

/// How the tool turns in a motion under a transformation.
std::string turning_of(const path::Command& command) {
    switch (command.motion().orient_kind) {
        case path::OrientKind::None: return "";
        case path::OrientKind::Straight: return "ptp";
        case path::OrientKind::Joints:
        case path::OrientKind::Axes: return "axes";
        case path::OrientKind::Cone: return "cone";
        case path::OrientKind::Surface: return "surface";
        case path::OrientKind::Point: return "point";
    }
    return "";
}

/// "0.6,0,0.8": a direction, to six digits.
bool is_direction(const path::Vec3& direction, const std::string& told) {
    std::istringstream parts(told);
    path::Vec3 wanted = path::Vec3::Zero();
    char comma = ',';
    parts >> wanted[0] >> comma >> wanted[1] >> comma >> wanted[2];
    EXPECT_FALSE(parts.fail()) << told;
    return (direction - wanted).norm() < 2e-6;
}

/// "X10 Y5 ccw I0 J5 F200": what is told.
bool is_at(const path::Command& command, const std::string& text) {
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (std::islower(static_cast<unsigned char>(word[0])) != 0) {
            if (word != kind_of(command) && word != turning_of(command)) return false;
            continue;
        }
        if (word[0] == 'O') {
            if (!is_direction(command.motion().direction, word.substr(1))) return false;
            continue;
        }
        if (const std::size_t center = std::string_view("IJK").find(word[0]);
            center != std::string_view::npos) {
            const path::Motion& motion = command.motion();
            const path::Vec3& about =
                command.op() == path::Op::Involute ? motion.involute().center : motion.arc().center;
            const double at = about[static_cast<Eigen::Index>(center)];
            if (std::abs(at - std::stod(word.substr(1))) > 1e-4) return false;
            continue;
        }
        if (word[0] == 'F') {
            if (std::abs(command.motion().feed - std::stod(word.substr(1))) > 1e-6) return false;
            continue;
        }
        const auto axis = std::ranges::find(kAxisNames, word.substr(0, 1));
        const double wanted = std::stod(word.substr(1));
        const auto i = static_cast<std::size_t>(axis - kAxisNames.begin());
        if (std::abs(command.motion().to[i] - wanted) > 5e-5) return false;
    }
    return true;
}

std::string place_of(const path::Command& command) {
    std::string out;
    for (std::size_t i = 0; i < kAxes; ++i) {
        if (i > 2 && command.motion().to[i] == 0) continue;
        out +=
            std::string(kAxisNames[i]) + format_shortest(round_to(command.motion().to[i], 6)) + ' ';
    }
    out += kind_of(command);
    if (command.motion().orient_kind != path::OrientKind::None) {
        out += ' ' + turning_of(command) + " O";
        for (std::size_t i = 0; i < 3; ++i) {
            const double part = command.motion().direction[static_cast<Eigen::Index>(i)];
            out += (i == 0 ? "" : ",") + format_shortest(round_to(part, 6));
        }
    }
    if (command.op() == path::Op::Arc) {
        for (std::size_t i = 0; i < 3; ++i) {
            const double at = command.motion().arc().center[static_cast<Eigen::Index>(i)];
            out += std::string(" ") + "IJK"[i] + format_shortest(round_to(at, 6));
        }
    }
    return out + " F" + format_shortest(command.motion().feed);
}

/// `t1.5:`, or `t1.5@90:` where the thread begins at an angle of the spindle.
std::string thread_kind(const path::Command& command) {
    std::string out = 't' + format_shortest(round_to(command.motion().feed, 4));
    if (command.motion().thread().start_deg != 0)
        out += '@' + format_shortest(round_to(command.motion().thread().start_deg, 3));
    return out + ':';
}

/// All motions in short; X of a lathe is a diameter.
std::string path_of(const std::vector<path::Command>& motions, bool is_lathe) {
    std::string out;
    AxisValues here{};
    double feed = 0;
    for (const path::Command& command : motions) {
        std::string word;
        const bool is_rapid = command.op() == path::Op::Rapid;
        for (std::size_t i = 0; i < kAxes; ++i) {
            if (std::abs(command.motion().to[i] - here[i]) < 1e-6) continue;
            const char name = kAxisNames[i][0];
            const double value = command.motion().to[i] * (is_lathe && i == 0 ? 2 : 1);
            word += is_rapid ? name : static_cast<char>(name - 'A' + 'a');
            word += format_shortest(round_to(value, 3));
        }
        here = command.motion().to;
        const std::string kind = command.op() == path::Op::Thread      ? thread_kind(command)
                                 : command.op() != path::Op::Arc       ? ""
                                 : command.motion().arc().is_clockwise ? "cw:"
                                                                       : "ccw:";
        if (!is_rapid && command.op() != path::Op::Thread && command.motion().feed != feed) {
            feed = command.motion().feed;
            word += 'f' + format_shortest(round_to(feed, 4));
        }
        if (!word.empty()) out += (out.empty() ? "" : " ") + kind + word;
    }
    return out;
}

const nc::Dialect& dialect_named(const std::string& name,
                                 nc::MachineKind kind = nc::MachineKind::Mill) {
    static std::map<std::pair<std::string, nc::MachineKind>, nc::Dialect> loaded;
    const auto key = std::pair(name, kind);
    if (const auto known = loaded.find(key); known != loaded.end()) return known->second;
    Sources sources;
    DiagnosticList messages;
    auto dialect = nc::load_dialect_for(kind, name,
                                        {KADR_ROOT "/tests/control/dialects", KADR_ROOT "/dialects",
                                         KADR_ROOT "/examples/dialects"},
                                        sources, messages);
    EXPECT_TRUE(dialect.has_value());
    return loaded.emplace(key, std::move(*dialect)).first->second;
}

struct Outcome {
    std::vector<ControlVariable> variables;
    std::vector<path::Command> motions;
    std::vector<std::string> shown;
    std::vector<std::string> dwells;
    std::vector<std::string> printed;
    std::vector<Diagnostic> messages;
    std::vector<KeptWay> ways;  // if somebody looks on
};

/// Keeps what a program prints.
class KeptLines final : public PrintTarget {
  public:
    explicit KeptLines(std::vector<std::string>& lines) : lines_(lines) {}
    void line(std::string_view text) override { lines_.emplace_back(text); }

  private:
    std::vector<std::string>& lines_;
};

bool is_of_lathe(const nc::Dialect& dialect) {
    return dialect.name().find("lathe") != std::string_view::npos;
}

/// Runs the library's cycles for the cycles of a control.
CycleExpander* cycles_of(const nc::Dialect& dialect) {
    static std::map<const nc::Dialect*, std::unique_ptr<driver::LibraryCycles>> all;
    std::unique_ptr<driver::LibraryCycles>& cycles = all[&dialect];
    if (!cycles) cycles = std::make_unique<driver::LibraryCycles>(test::quiet_session(), dialect);
    return cycles.get();
}

/// called    where the programs stand that it calls
/// can_seek  the text can be read again. One that cannot is watched line by line, and each change
///           of a variable is noted: who looks on changes nothing.
Outcome run_program(const nc::Dialect& dialect, const std::string& text, const Expected& expected,
                    const fs::path& called, bool can_seek) {
    const machine::Machine machine = machine_named(expected.machine, is_of_lathe(dialect));
    DiagnosticList messages;
    PiecedText source(text, can_seek);
    ProgramOptions options;
    options.skip_levels = expected.skip_levels;
    options.passes = expected.passes;
    options.max_turns = 20'000;
    options.max_repeated = 5'000;
    driver::ProgramFolders files({called.string()}, test::quiet_session(called.string()));
    options.files = &files;
    Outcome outcome;
    KeptLines printer(outcome.printed);
    options.printer = &printer;
    NcProgram program(dialect, source, "test", options, messages);
    InterpreterOptions interpreting;
    interpreting.date = 20261122;
    interpreting.time_of_day = 13 * 3600 + 5 * 60 + 9;
    interpreting.skip_levels = expected.skip_levels;
    Interpreter interpreter(dialect, machine, program, &program, cycles_of(dialect), interpreting,
                            messages);
    program.follow(interpreter);
    WatchedWays watch;
    std::vector<VariableChange> changes;
    if (!can_seek) program.show_to(&watch, &changes);
    std::vector<path::Command> batch(5);
    while (const std::size_t count = interpreter.pull(batch)) {
        for (const path::Command& command : std::span(batch).first(count)) {
            if (command.op() == path::Op::Rapid || command.op() == path::Op::Line ||
                command.op() == path::Op::Arc || command.op() == path::Op::Spline ||
                command.op() == path::Op::Thread || command.op() == path::Op::Involute)
                outcome.motions.push_back(command);
            if (command.op() == path::Op::Message) {
                outcome.shown.push_back(command.message().text.empty()
                                            ? "message"
                                            : "message " + command.message().text);
            }
            if (command.op() == path::Op::Dwell)
                outcome.dwells.push_back(format_shortest(round_to(command.dwell().time, 6)));
            if (command.op() == path::Op::Stop) outcome.shown.emplace_back("stop");
        }
    }
    outcome.variables = program.variables();
    outcome.messages = messages.all();
    outcome.ways = watch.ways();
    return outcome;
}

/// "5:3" in the program itself, "O9100.NC:2:1" in another file.
std::string place_name(const TextLocation& location) {
    const std::string file =
        location.file == "test" ? "" : fs::path(location.file).filename().string() + ':';
    return file + std::to_string(location.line) + ':' + std::to_string(location.column);
}

void check_alarm(const Expected& expected, const Outcome& outcome) {
    std::string found;
    for (const Diagnostic& message : outcome.messages) {
        if (message.severity != Severity::Alarm || !found.empty()) continue;
        found = message.alarm_number + ' ' + std::string(message.row->code);
        if (message.line) {
            found += " at " + place_name(*message.line);
            std::string called;
            for (const Diagnostic::Note& note : message.notes)
                if (note.line) called += (called.empty() ? "" : " ") + place_name(*note.line);
            EXPECT_EQ(called, expected.called);
        }
        if (expected.alarm.empty()) found += " (" + message.message() + ')';
    }
    EXPECT_EQ(found, expected.alarm);
}

void check(const Expected& expected, const Outcome& outcome, bool is_lathe) {
    check_alarm(expected, outcome);
    for (const auto& [name, value] : expected.variables) {
        std::string found;
        for (const ControlVariable& variable : outcome.variables) {
            if (variable.name == name) found = shown(variable);
        }
        EXPECT_EQ(found, value) << name;
    }
    EXPECT_EQ(outcome.shown, expected.shown);
    if (!expected.dwells.empty()) {
        EXPECT_EQ(outcome.dwells, expected.dwells);
    }
    EXPECT_EQ(outcome.printed, expected.printed);
    std::vector<std::string> warnings;
    for (const Diagnostic& message : outcome.messages) {
        if (message.severity == Severity::Warning && message.line)
            warnings.push_back(std::string(message.row->code) + " at " + place_name(*message.line));
    }
    if (!expected.warnings.empty()) {
        EXPECT_EQ(warnings, expected.warnings);
    }
    if (!expected.fix.empty()) {
        const auto has_fix = [](const Diagnostic& message) { return !message.fixes.empty(); };
        const auto fixed = std::ranges::find_if(outcome.messages, has_fix);
        EXPECT_EQ(fixed == outcome.messages.end() ? "none" : fixed->fixes[0].text, expected.fix);
    }
    if (!expected.path.empty()) {
        EXPECT_EQ(path_of(outcome.motions, is_lathe), expected.path);
    }
    if (expected.way.empty()) return;
    EXPECT_EQ(outcome.motions.size(), expected.way.size());
    for (std::size_t i = 0; i < outcome.motions.size() && i < expected.way.size(); ++i) {
        EXPECT_TRUE(is_at(outcome.motions[i], expected.way[i]))
            << "motion " << i + 1 << ": " << place_of(outcome.motions[i]) << ", not "
            << expected.way[i];
    }
}

/// Of a text that cannot be read again the last part is kept, and a jump to what is gone says so.
TEST(ControlText, JumpsBackAsFarAsTextIsKept) {
    const std::string text = "N10 #1=#1+1\n" + std::string(200, '\n') + "IF[#1LT3]GOTO10\nM30\n";
    for (const std::size_t kept : {std::size_t{100}, std::size_t{1000}}) {
        DiagnosticList messages;
        PiecedText source(text, false);
        ProgramOptions options;
        options.kept_text = kept;
        NcProgram program(dialect_named("fanuc"), source, "test", options, messages);
        std::vector<nc::Block> blocks(8);
        while (program.pull(blocks) > 0) continue;
        if (kept > text.size()) {
            EXPECT_TRUE(messages.all().empty());
            EXPECT_EQ(shown(program.variables().at(0)), "3");
        } else {
            ASSERT_EQ(messages.all().size(), 1u);
            EXPECT_EQ(messages.all()[0].row, &diag::TextGone);
        }
    }
}

/// One program in a file; counts how often it is opened and read.
class CountedFile final : public ProgramFiles {
  public:
    std::optional<File> open(const nc::Dialect& dialect, const std::string& program,
                             const std::string& kind) override {
        static_cast<void>(dialect);
        static_cast<void>(kind);
        ++opened;
        if (program != "2") return std::nullopt;
        return File{"O2", std::make_unique<Text>(*this)};
    }
    int opened = 0;
    int read = 0;

  private:
    class Text final : public nc::TextSource {
      public:
        explicit Text(CountedFile& file) : file_(file) {}
        std::string_view next() override {
            const std::string_view rest = std::string_view("O2\n#100=#100+#1\nM99\n").substr(at_);
            at_ += rest.size();
            if (!rest.empty()) ++file_.read;
            return rest;
        }
        bool seek(std::uint64_t offset) override {
            at_ = static_cast<std::size_t>(offset);
            return true;
        }

      private:
        CountedFile& file_;
        std::size_t at_ = 0;
    };
};

TEST(ControlText, AProgramThatIsCalledOftenIsReadOnce) {
    const std::string text = "WHILE[#1LT500]DO1\n#1=#1+1\nG65P2A2.\nEND1\nM30\n";
    DiagnosticList messages;
    PiecedText source(text, true);
    CountedFile file;
    ProgramOptions options;
    options.files = &file;
    NcProgram program(dialect_named("fanuc"), source, "test", options, messages);
    std::vector<nc::Block> blocks(8);
    while (program.pull(blocks) > 0) continue;
    EXPECT_TRUE(messages.all().empty());
    EXPECT_EQ(shown(program.variables().at(1)), "1000");
    EXPECT_EQ(file.opened, 1);
    // To look for its head, for the first pass, and to keep its lines.
    EXPECT_LE(file.read, 6);
}

TEST(ControlText, WordsOfTheLanguageAreExplained) {
    const auto first = [](const char* dialect, const char* word) {
        const std::vector<std::string> lines = nc::explain(dialect_named(dialect), word);
        return lines.empty() ? std::string() : lines[0];
    };
    EXPECT_EQ(first("fanuc", "#5002"),
              "`#{n}` from 5001 to 5020 is end_position: axis: last programmed end point in the "
              "programmed system; end of the last block");
    EXPECT_EQ(first("fanuc", "#1000"),
              "`#{n}` from 1000 to 1031 is a value of the machine; without one 0 and a warning "
              "(docs/inputs.md); input of the machine");
    EXPECT_EQ(first("fanuc", "GOTO"),
              "`GOTO{target}` is jump: on at a block number or label, looked for to the end of the "
              "program and then from its head; forward to the end of the program, then from its "
              "head");
    EXPECT_EQ(first("sinumerik", "MOD"),
              "`MOD` between values is remainder: what the cut quotient leaves; sign of the "
              "dividend; level 2 of 11, where 1 binds strongest");
    EXPECT_EQ(first("sinumerik", "R7"),
              "`R{n}` from 0 to 999 is a variable of the whole run; R parameter");
    EXPECT_EQ(first("sinumerik", "SQRT"),
              "`SQRT({a})` is square_root: of a number that is not negative");
    EXPECT_EQ(
        first("fanuc", "M98"),
        "`M98` calls a subprogram, behind the words of its block; P is the program; L is how "
        "often; Q is the block where it begins; M98 P30012 is 3 times O0012; with Q from that "
        "block on");
    EXPECT_EQ(first("sinumerik", "RET"),
              "`RET` is return: ends the program; the one that has called it goes on, at a target "
              "if one is given");
    EXPECT_EQ(first("sinumerik", "$P_F"),
              "`$P_F` is feed: programmed feed in the unit of its mode; 0 none; programmed feed");
}

/// Every word that a dialect has for something: all that it reads is told.
std::vector<std::string> words_of(const nc::Dialect& dialect) {
    const nc::DialectTables& tables = dialect.tables();
    const nc::Language& language = tables.language;
    std::vector<std::string> words;
    for (const nc::Address& address : tables.addresses) words.push_back(address.name);
    for (const auto& [word, passed] : tables.passed) words.push_back(word);
    for (const auto& [word, meaning] : tables.unsupported) words.push_back(word);
    for (const nc::OperatorForm& form : language.operators) words.push_back(form.text);
    for (const nc::FunctionForm& form : language.functions) words.push_back(form.name);
    for (const nc::TypeName& type : language.types) words.push_back(type.name);
    for (const nc::FramePartName& part : language.frame_parts) words.push_back(part.word);
    for (const nc::StatementForm& form : language.statements) {
        for (const nc::StatementToken& token : form.tokens)
            if (token.kind == nc::StatementToken::Kind::Word) words.push_back(token.text);
    }
    const nc::CallLanguage& calls = language.calls;
    words.insert(words.end(), calls.options.begin(), calls.options.end());
    for (const std::string& scope : calls.scope_words) words.emplace_back(nc::scope_word(scope));
    for (const std::string& word : language.lone_axis_words) words.push_back(word);
    for (const std::string& word :
         {calls.save_word, calls.reference_word, language.axis_word, language.end_label})
        if (!word.empty()) words.push_back(word);
    if (tables.notation.has_modes && tables.notation.has_assignment) {
        for (const nc::ModeWord& mode : nc::kModeWords) words.emplace_back(mode.name);
    }
    return words;
}

/// Case 20: types, keywords inside of statements, words around values as well.
TEST(ControlText, EverythingThatIsReadIsExplained) {
    for (const char* name : {"sinumerik", "axioma", "fanuc", "fanuc-lathe", "fanuc-lathe-b",
                             "fanuc-lathe-c", "iso", "haas", "heidenhain-iso"}) {
        const nc::Dialect& dialect = dialect_named(name);
        for (const std::string& word : words_of(dialect))
            EXPECT_TRUE(word.empty() || !nc::explain(dialect, word).empty()) << name << ' ' << word;
    }
    const auto first = [](const char* word) {
        const std::vector<std::string> lines = nc::explain(dialect_named("sinumerik"), word);
        return lines.empty() ? std::string() : lines[0];
    };
    EXPECT_EQ(first("IC"),
              "`IC` around the value of a word, `X=IC(10)`: a distance from where the axis is, "
              "whatever acts");
    EXPECT_EQ(first("REAL"), "`REAL` is a type of variables, of numbers");
    EXPECT_EQ(first("SAVE"),
              "`SAVE` in the head of a program: what its caller had set acts again behind it");
    EXPECT_EQ(first("ULI"),
              "`ULI` behind the type of a variable says the greatest value that it holds");
    EXPECT_EQ(first("TO"),
              "`FOR {variable}={first} TO {last}` is for: blocks up to the end, for each whole "
              "number from the first to the last; the step is 1");
}

// ---------------------------------------------------------------- roughing along any shape

/// A shape that rises from its beginning to its end. It is told for G71: x is the height on the
/// radius, z the way of the cuts. For G72 the two are exchanged, and moved.
struct RandomShape {
    struct Point {
        double x = 0;
        double z = 0;
    };
    bool facing = false;
    std::string text;           // its blocks, N10 to N20
    std::vector<Point> points;  // along it, close together
    Point start;                // of the cycle
    double step = 0;
    double left_x = 0;  // on the radius
    double left_z = 0;

    Point seen(const AxisValues& to) const {
        return facing ? Point{to[2] + 60, to[0] - 100} : Point{to[0], to[2]};
    }
};

/// A number with its decimal point.
std::string word_of(char address, double value) {
    std::string out = format_shortest(round_to(value, 3));
    return address + (out.find('.') == std::string::npos ? out + '.' : out);
}

std::string height_word(bool facing, double x) {
    return facing ? word_of('Z', x - 60) : word_of('X', 2 * x);
}

std::string way_word(bool facing, double z) {
    return facing ? word_of('X', 2 * (z + 100)) : word_of('Z', z);
}

class ShapeMaker {
  public:
    ShapeMaker(unsigned seed, bool facing, bool inside)
        : random_(seed), facing_(facing), side_(inside ? -1 : 1) {}

    RandomShape make() {
        RandomShape shape;
        const int count = static_cast<int>(number(2, 6));
        RandomShape::Point at{inside() ? 60.0 : 10.0, 2};
        const RandomShape::Point first = at;
        std::string blocks;
        std::vector<RandomShape::Point> points{at};
        for (int i = 0; i < count; ++i) {
            const bool is_last = i + 1 == count;
            const int kind = i == 0 ? 0 : static_cast<int>(number(0, 5));
            const double width = 0.5 * number(1, 12);
            const double rise = 0.5 * number(1, 8);
            RandomShape::Point to = at;
            if (kind == 0 && !is_last) to.z -= width;
            if (kind == 1 || is_last) to.x += side_ * rise;
            if (!is_last && kind >= 2) {
                to.z -= width;
                to.x += side_ * (kind == 2 ? rise : width);
            }
            const std::string end = height_word(facing_, to.x) + way_word(facing_, to.z);
            if (kind >= 3 && !is_last) {
                const bool clockwise = kind == 3;
                blocks += (clockwise != facing_ ? "G02" : "G03") + end + word_of('R', width) + '\n';
                add_quarter(points, at, to, clockwise);
            } else {
                blocks += (is_last ? "N20G01" : "G01") + end + '\n';
            }
            points.push_back(to);
            at = to;
        }
        shape.start = {at.x + side_ * 0.5 * number(0, 6), 2};
        shape.step = 0.25 * number(2, 12);
        shape.left_x = side_ * 0.1 * number(0, 4);
        shape.left_z = 0.1 * number(0, 4);
        shape.facing = facing_;
        shape.text = "N10G00" + height_word(facing_, first.x) + '\n' + blocks;
        shape.points = std::move(points);
        return shape;
    }

  private:
    bool inside() const { return side_ < 0; }
    double number(int least, int most) {
        return std::uniform_int_distribution<int>(least, most)(random_);
    }
    /// A quarter of a circle, every half degree.
    static void add_quarter(std::vector<RandomShape::Point>& points, RandomShape::Point from,
                            RandomShape::Point to, bool clockwise) {
        // Seen with Z to the right and X up.
        const bool center_beside_end = clockwise == (to.x > from.x);
        const RandomShape::Point center =
            center_beside_end ? RandomShape::Point{to.x, from.z} : RandomShape::Point{from.x, to.z};
        for (int i = 1; i < 180; ++i) {
            const double angle = i * 0.5 * std::numbers::pi / 180;
            const double a = std::cos(angle);
            const double b = std::sin(angle);
            points.push_back({center.x + (from.x - center.x) * a + (to.x - center.x) * b,
                              center.z + (from.z - center.z) * a + (to.z - center.z) * b});
        }
    }

    std::mt19937 random_;
    bool facing_;
    double side_;
};

/// How far the shape with its allowances stands out towards the tool at a place, on the radius.
double stands_at(const RandomShape& shape, double z, double side) {
    double most = -1e9;
    const auto& points = shape.points;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double z0 = points[i - 1].z + shape.left_z;
        const double z1 = points[i].z + shape.left_z;
        if (z > std::max(z0, z1) || z < std::min(z0, z1)) continue;
        const double part = z0 == z1 ? 1 : (z - z0) / (z1 - z0);
        const double x = points[i - 1].x + (points[i].x - points[i - 1].x) * part + shape.left_x;
        const double end = points[i].x + shape.left_x;
        most = std::max(most, side * (z0 == z1 ? end : x));
    }
    return most;
}

std::string roughing_of(const RandomShape& shape) {
    const double left_on_x = shape.facing ? shape.left_z : shape.left_x;
    const double left_on_z = shape.facing ? shape.left_x : shape.left_z;
    return "%\nO0001\nG99G97S500M03\nG00" + height_word(shape.facing, shape.start.x) +
           way_word(shape.facing, shape.start.z) + '\n' +
           (shape.facing ? "G72" + word_of('W', shape.step) : "G71" + word_of('U', shape.step)) +
           "R0.3\n" + (shape.facing ? "G72" : "G71") + "P10Q20" + word_of('U', 2 * left_on_x) +
           word_of('W', left_on_z) + "F0.2\n" + shape.text + "M30\n%\n";
}

/// Every motion keeps off the shape with its allowances, what the parallel cuts leave is less than
/// a depth of cut, and the tool comes back to where it was.
void check_roughing(const RandomShape& shape, double side) {
    const std::string text = roughing_of(shape);
    SCOPED_TRACE(text);
    const Outcome outcome = run_program(dialect_named("fanuc-lathe"), text, {}, {}, true);
    for (const Diagnostic& message : outcome.messages)
        ASSERT_NE(message.severity, Severity::Alarm) << message.message();
    ASSERT_GT(outcome.motions.size(), 3u);
    const RandomShape::Point last = shape.seen(outcome.motions.back().motion().to);
    EXPECT_NEAR(last.x, shape.start.x, 1e-9);
    EXPECT_NEAR(last.z, shape.start.z, 1e-9);

    const double begin = shape.points.front().x + shape.left_x;
    const double front = shape.start.z + shape.left_z;
    const double end = shape.points.back().z + shape.left_z;
    std::vector<RandomShape::Point> cuts;  // parallel ones: height and end
    RandomShape::Point here = shape.seen(outcome.motions.front().motion().to);
    for (std::size_t i = 1; i + 1 < outcome.motions.size(); ++i) {
        const path::Command& command = outcome.motions[i];
        const RandomShape::Point to = shape.seen(command.motion().to);
        for (int k = 0; k <= 40 && command.op() != path::Op::Arc; ++k) {
            const double x = here.x + (to.x - here.x) * k / 40;
            const double z = here.z + (to.z - here.z) * k / 40;
            if (z < end - 1e-6) continue;  // behind the shape the bar stays as it is
            // On a wall the tool touches what stands behind it.
            EXPECT_GE(side * x, stands_at(shape, z + 1e-5, side) - 2e-3) << x << ' ' << z;
        }
        const bool is_parallel = command.op() == path::Op::Line && std::abs(to.x - here.x) < 1e-9 &&
                                 side * (here.x - begin) > 1e-6 && std::abs(here.z - front) < 1e-9;
        if (is_parallel) cuts.push_back(to);
        here = to;
    }
    for (double z = end + 0.01; z < shape.start.z; z += 0.37) {
        double least = side * (shape.start.x + shape.left_x);
        for (const RandomShape::Point& cut : cuts) {
            if (cut.z <= z + 1e-9) least = std::min(least, side * cut.x);
        }
        // In front of the shape nothing is left.
        const double stands = std::max(stands_at(shape, z, side), side * begin);
        EXPECT_LT(least - stands, shape.step + 2e-3) << z;
    }
}

TEST(LatheCycles, RoughingKeepsOffTheShape) {
    for (unsigned seed = 0; seed < 240; ++seed) {
        SCOPED_TRACE(seed);
        const bool inside = seed % 2 != 0;
        check_roughing(ShapeMaker(seed, seed % 4 > 1, inside).make(), inside ? -1 : 1);
    }
}

/// A program, and the control that executes it.
struct Case {
    ControlProgram program;
    std::string dialect;
};

class Control : public testing::TestWithParam<Case> {
  public:
    /// Nobody compares nothing.
    static void TearDownTestSuite() {
        const auto& all = *testing::UnitTest::GetInstance();
        if (all.test_to_run_count() != all.total_test_count()) return;
        EXPECT_GT(compared_ways, 800u);
    }
    static inline std::size_t compared_ways = 0;
};

TEST_P(Control, DoesWhatTheManualSays) {
    const std::string text = content_of(GetParam().program.file);
    const Expected expected = parse(text);
    EXPECT_TRUE(expected.has_rule) << "the file names no rule";
    const bool is_on_lathe = machine_named(expected.machine, false).is_lathe;
    const nc::Dialect& dialect = dialect_named(
        GetParam().dialect, is_on_lathe ? nc::MachineKind::Lathe : nc::MachineKind::Mill);
    const fs::path called = GetParam().program.called();
    for (const bool can_seek : {true, false}) {
        SCOPED_TRACE(can_seek ? "from a file" : "through a pipe, with a trace");
        const Outcome outcome = run_program(dialect, text, expected, called, can_seek);
        check(expected, outcome, expected.machine == "lathe" || is_of_lathe(dialect));
        compared_ways += expect_references(dialect, text, called, outcome.ways, outcome.messages);
    }
}

/// Whether a program says that it shows its own control only, and why.
bool is_for_one_control(const ControlProgram& program) {
    const std::string text = content_of(program.file);
    return text.find("only: " + program.control + ' ') != std::string::npos;
}

/// Every program on the control of its folder; those of SINUMERIK on AxiOMA, too, but for the few
/// that show what is known to differ.
std::vector<Case> cases() {
    std::vector<Case> all;
    for (const ControlProgram& program : control_programs()) {
        all.push_back({program, program.control});
        if (program.control == "sinumerik" && !is_for_one_control(program))
            all.push_back({program, "axioma"});
    }
    return all;
}

/// The first words of the rows of a table: "| `text` | …" is `text`.
std::set<std::string> table_heads(const std::string& page) {
    std::set<std::string> heads;
    std::istringstream lines(page);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("| `")) heads.insert(line.substr(3, line.find('`', 3) - 3));
    }
    return heads;
}

/// A file that stands elsewhere would not be run, a chapter that the page does not have not be
/// found, and of two of one name a list could not say which is meant.
TEST(ControlPrograms, StandInChaptersOnce) {
    const fs::path root = fs::path(KADR_ROOT) / "tests/control";
    const std::set<std::string> chapters = table_heads(content_of(root / "README.md"));
    EXPECT_GT(chapters.size(), 20u);
    std::set<fs::path> known;
    std::set<std::string> used;
    std::set<std::pair<std::string, std::string>> names;
    for (const ControlProgram& program : control_programs()) {
        known.insert(program.file);
        used.insert(program.chapter);
        EXPECT_TRUE(chapters.contains(program.chapter)) << program.file;
        EXPECT_TRUE(names.emplace(program.control, program.name()).second)
            << program.file << ": another chapter of the control has this name";
    }
    for (const std::string& chapter : chapters)
        EXPECT_TRUE(used.contains(chapter)) << "no control has a chapter " << chapter;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
        const std::string path = entry.path().lexically_relative(root).string();
        const std::string suffix = entry.path().extension();
        if (suffix != ".nc" && suffix != ".mpf" && suffix != ".i") continue;
        if (path.starts_with("same_part/")) continue;
        EXPECT_TRUE(known.contains(entry.path())) << path << " stands in no chapter of a control";
    }
}

std::string test_name(const testing::TestParamInfo<Case>& test) {
    const ControlProgram& program = test.param.program;
    std::string name =
        test.param.dialect + '_' + program.control + '_' + program.chapter + '_' + program.name();
    std::ranges::replace_if(
        name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Programs, Control, testing::ValuesIn(cases()), test_name);

}  // namespace
}  // namespace kadr::interp::control_test
