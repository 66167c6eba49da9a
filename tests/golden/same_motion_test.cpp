// One source, every control, the same motion: what differs is only what the number formats round.
// Native cycles, modal and call by call, and cycles written out as moves give the same motion too.
#include <algorithm>
#include <cmath>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/common/process.h"
#include "tests/golden/parts.h"

namespace same_motion_test {

namespace {

using golden::Part;
using nlohmann::json;

// Half an increment of each of two texts with three decimals, and the correction of arc centres.
constexpr double kRounding = 0.0021;

/// A rapid or a line to where the tool is: a control may name the place once more.
bool stands_still(const json& command, const std::vector<json>& before) {
    if (command["op"] != "rapid" && command["op"] != "line") return false;
    const auto last = std::find_if(before.rbegin(), before.rend(),
                                   [](const json& earlier) { return earlier.contains("to"); });
    return last != before.rend() && (*last)["to"] == command["to"];
}

/// Behind the end of tool centre point control the same place has other numbers; a control to which
/// that is a kind of tool length says it by a rapid along which no axis moves. With a table that
/// has turned only A, C and the height can be held against each other.
bool ends_tool_centre(const json& command, const std::vector<json>& before) {
    if (command["op"] != "rapid" || command.contains("tool") || before.empty()) return false;
    const json& last = before.back();
    if (!last.contains("tool") || !last.contains("to")) return false;
    const auto stays = [&](const char* axis) {
        return std::fabs(command["to"].value(axis, 0.0) - last["to"].value(axis, 0.0)) < kRounding;
    };
    const auto radius = [](const json& to) {
        return std::hypot(to.value("X", 0.0), to.value("Y", 0.0));
    };
    return stays("A") && stays("C") && stays("Z") &&
           std::fabs(radius(command["to"]) - radius(last["to"])) < kRounding;
}

/// What the spindle does while the tool moves at rapid is the control's: only the last word before
/// a cut counts. Behind rigid tapping one control stops it, another lets it turn with the tap's
/// speed.
void join_spindle_words(std::vector<json>& commands) {
    for (std::size_t i = commands.size(); i-- > 0;) {
        if (commands[i]["op"] != "spindle") continue;
        std::size_t next = i + 1;
        while (next < commands.size() && commands[next]["op"] == "rapid") ++next;
        if (next == commands.size() || commands[next]["op"] != "spindle") continue;
        commands[i] = commands[next];
        commands.erase(commands.begin() + static_cast<std::ptrdiff_t>(next));
    }
}

std::vector<json> commands_of(const Part& part, const std::string& dialect,
                              const std::string& cycles) {
    const ProcessResult result =
        run_process({KADR_BINARY, "run", part.source.string(), "-d", dialect, "-m", part.machine,
                     "--cycles", cycles, "--commands", "-"});
    EXPECT_EQ(result.status, 0) << dialect << "\n" << result.err;
    std::vector<json> commands;
    bool has_length = false;
    std::istringstream lines(result.out);
    for (std::string line; std::getline(lines, line);) {
        json command = json::parse(line, nullptr, false);
        if (!command.is_object()) continue;
        command.erase("iso");   // another text has other line numbers
        command.erase("text");  // a control may know capital letters only
        command.erase("src");   // of a cycle: its call, or its own statements
        // Without a tool's length a place of the machine is one of the base system.
        has_length = has_length || command["op"] == "tool_length";
        if (!has_length) command.erase("machine_coordinates");
        if (stands_still(command, commands) || ends_tool_centre(command, commands)) continue;
        commands.push_back(std::move(command));
    }
    join_spindle_words(commands);
    return commands;
}

/// Whether two arcs have the same radius about their centres. A control that moves the centre onto
/// the bisector of rounded ends moves that of a short arc along it, by many times what it moves the
/// path (S 4.2).
bool are_equal_arcs(const json& a, const json& b) {
    if (!a.contains("center") || !b.contains("center")) return false;
    const auto radius = [](const json& arc) {
        double square = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::string axis(1, "XYZ"[i]);
            if (arc.value("plane", "XYZ").find(axis) == std::string::npos) continue;
            const double arm = arc["to"].value(axis, 0.0) - arc["center"][i].get<double>();
            square += arm * arm;
        }
        return std::sqrt(square);
    };
    double apart = 0;
    for (std::size_t i = 0; i < 3; ++i)
        apart =
            std::max(apart, std::fabs(a["center"][i].get<double>() - b["center"][i].get<double>()));
    // The rounding of the ends turns the chord, and the centre with it, the more the shorter it is.
    double chord = 0;
    for (const char* axis : {"X", "Y", "Z"}) {
        const double distance = a["to"].value(axis, 0.0) - a["from"].value(axis, 0.0);
        chord = std::hypot(chord, distance);
    }
    const double turned = std::max(10.0, 4 * radius(a) / chord);
    return apart <= turned * kRounding && std::fabs(radius(a) - radius(b)) <= kRounding;
}

/// Equal but for rounding; tells the first difference.
std::string difference(const json& a, const json& b, const std::string& where = "") {
    if (a.is_number() && b.is_number()) {
        const double x = a.get<double>(), y = b.get<double>();
        if (std::fabs(x - y) <= kRounding) return "";
        return where + ": " + a.dump() + " and " + b.dump();
    }
    if (a.type() != b.type()) return where + ": " + a.dump() + " and " + b.dump();
    if (a.is_object()) {
        if (a.size() != b.size()) return where + ": " + a.dump() + " and " + b.dump();
        for (const auto& [key, value] : a.items()) {
            if (key == "center" && are_equal_arcs(a, b)) continue;
            if (!b.contains(key)) return where + ": " + key + " is missing in " + b.dump();
            if (std::string d = difference(value, b.at(key), where + "/" + key); !d.empty())
                return d;
        }
        return "";
    }
    if (a.is_array()) {
        if (a.size() != b.size()) return where + ": " + a.dump() + " and " + b.dump();
        for (std::size_t i = 0; i < a.size(); ++i) {
            if (std::string d = difference(a[i], b[i], where); !d.empty()) return d;
        }
        return "";
    }
    return a == b ? "" : where + ": " + a.dump() + " and " + b.dump();
}

void expect_same(const std::vector<json>& a, const std::vector<json>& b, const std::string& what) {
    // An arc with where it begins: the end of the motion before.
    const auto with_start = [](const std::vector<json>& all, std::size_t i) {
        json command = all[i];
        command["from"] = json::object();
        for (std::size_t before = i; command["op"] == "arc" && before > 0; --before) {
            if (!all[before - 1].contains("to")) continue;
            command["from"] = all[before - 1]["to"];
            break;
        }
        return command;
    };
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        const std::string d = difference(with_start(a, i), with_start(b, i));
        ASSERT_EQ(d, "") << what << ", command " << i << "\n" << a[i] << "\n" << b[i];
    }
    ASSERT_EQ(a.size(), b.size()) << what;
}

// ---------------------------------------------------------------- the input dialect

/// A source written the way of one control, and the text that it stands for there.
struct Pair {
    std::filesystem::path source;
    std::filesystem::path text;
    std::string dialect;  // of both
};

std::vector<Pair> all_pairs() {
    std::vector<Pair> pairs;
    for (const Part& part : golden::parts_of(golden::fs::path(KADR_ROOT) / "tests/golden/input")) {
        const std::string code = kadr::read_file(part.source).value_or("");
        const std::size_t at = code.find("\ndialect ") + 9;
        Pair pair{part.source, part.source, code.substr(at, code.find(';', at) - at)};
        pair.text.replace_extension(".nc");
        pairs.push_back(pair);
    }
    return pairs;
}

/// Without what a control says of its own way to reach machine coordinates: the place is compared.
std::vector<json> places_of(const std::filesystem::path& file, const std::string& dialect,
                            const std::string& cycles) {
    std::vector<json> commands = commands_of({file, "mill"}, dialect, cycles);
    for (json& command : commands) command.erase("machine_coordinates");
    return commands;
}

class InputDialect : public ::testing::TestWithParam<Pair> {};

TEST_P(InputDialect, SourceMovesAsItsTextDoes) {
    const Pair& pair = GetParam();
    const std::vector<json> reference = places_of(pair.text, pair.dialect, "native");
    ASSERT_GT(reference.size(), 10u);
    for (const char* target : {"iso", "sinumerik", "fanuc", "axioma"}) {
        for (const char* cycles : {"native", "moves"}) {
            expect_same(reference, places_of(pair.source, target, cycles),
                        pair.dialect + " for " + target + ", cycles " + cycles);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Pairs, InputDialect, ::testing::ValuesIn(all_pairs()),
                         [](const auto& pair) { return pair.param.source.stem().string(); });

// ---------------------------------------------------------------- controls made by the document

/// The moves of a text, with their feeds.
std::vector<json> moves_of(const std::filesystem::path& text, const std::string& dialect) {
    std::vector<json> moves;
    for (const json& command : commands_of({text, "mill"}, dialect, "native")) {
        if (!command.contains("to")) continue;
        json move;
        for (const char* key : {"op", "to", "center", "sweep", "feed"}) {
            if (command.contains(key)) move[key] = command[key];
        }
        moves.push_back(std::move(move));
    }
    return moves;
}

TEST(MadeControls, HaveNoMistake) {
    for (const golden::MadeControl& control : golden::kMadeControls) {
        const std::string file =
            KADR_ROOT "/examples/dialects/" + std::string(control.name) + ".xml";
        const ProcessResult result = run_process({KADR_BINARY, "dialect", "check", file});
        EXPECT_EQ(result.status, 0) << result.out << result.err;
    }
}

/// Cycles that only such a control has, against their moves written one by one for another one.
TEST(MadeControls, CyclesOfTheirOwnMoveAsWrittenOut) {
    const std::filesystem::path folder = KADR_ROOT "/tests/golden/made";
    for (const auto& [stem, dialect] :
         {std::pair("tnc_cycles", "heidenhain-iso"), std::pair("haas_pockets", "haas")}) {
        SCOPED_TRACE(stem);
        const std::filesystem::path own = folder / (std::string(stem) + '.' + dialect + ".txt");
        const std::filesystem::path plain = folder / (std::string(stem) + ".fanuc.txt");
        const std::vector<json> reference = moves_of(plain, "fanuc");
        ASSERT_GT(reference.size(), 15u);
        expect_same(reference,
                    moves_of(own, KADR_ROOT "/examples/dialects/" + std::string(dialect) + ".xml"),
                    stem);
    }
}

// ---------------------------------------------------------------- tools that have lengths

/// The moves of a part by the axes of the machine: a command tells where the tip of the tool goes,
/// and behind a retract a length acts on one control that acts on another one with the next Z.
std::vector<json> axis_moves_of(const Part& part, const std::string& dialect,
                                const std::string& cycles) {
    const ProcessResult result =
        run_process({KADR_BINARY, "run", part.source.string(), "-d", dialect, "-m", part.machine,
                     "--cycles", cycles, "--commands", "-"});
    EXPECT_EQ(result.status, 0) << dialect << "\n" << result.err;
    std::vector<json> moves;
    std::istringstream lines(result.out);
    double length = 0;
    for (std::string line; std::getline(lines, line);) {
        const json command = json::parse(line, nullptr, false);
        if (!command.is_object()) continue;
        if (command["op"] == "tool_length") length = command["length"].get<double>();
        if (!command.contains("to")) continue;
        json move;
        for (const char* key : {"op", "to", "sweep", "feed"}) {
            if (command.contains(key)) move[key] = command[key];
        }
        if (!command.contains("machine_coordinates"))
            move["to"]["Z"] = move["to"]["Z"].get<double>() + length;
        if (!stands_still(move, moves)) moves.push_back(std::move(move));
    }
    return moves;
}

class SameAxes : public ::testing::TestWithParam<Part> {};

TEST_P(SameAxes, WithLengthsAndWorkOffsets) {
    const Part part{GetParam().source, GetParam().source.parent_path() / "mill.xml"};
    const std::vector<json> reference = axis_moves_of(part, "sinumerik", "moves");
    ASSERT_GT(reference.size(), 15u);
    // Lengths and offsets of the machine act: the first place is X, Y of the first work offset.
    EXPECT_LT(reference[0]["to"]["X"].get<double>(), -300);
    for (const std::string& dialect : part.dialects()) {
        for (const char* cycles : {"native", "calls", "moves"}) {
            expect_same(reference, axis_moves_of(part, dialect, cycles),
                        dialect + ", cycles " + cycles);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Parts, SameAxes,
                         ::testing::ValuesIn(golden::parts_of(golden::fs::path(KADR_ROOT) /
                                                              "tests/golden/lengths")),
                         [](const auto& part) { return golden::name_of(part); });

class SameMotion : public ::testing::TestWithParam<Part> {};

TEST_P(SameMotion, OnEveryControl) {
    const std::vector<json> reference = commands_of(GetParam(), "sinumerik", "moves");
    ASSERT_GT(reference.size(), 3u);
    for (const std::string& dialect : GetParam().dialects()) {
        const bool is_own = dialect == "fanuc-lathe" && GetParam().has_own_strokes;
        for (const char* cycles : {"native", "calls", "moves"}) {
            if (is_own && std::string_view(cycles) != "moves") continue;
            expect_same(reference, commands_of(GetParam(), dialect, cycles),
                        dialect + ", cycles " + cycles);
        }
    }
}

/// A part for a lathe on a machine whose X is a radius until the text says otherwise.
TEST_P(SameMotion, WhereXIsARadiusUntilDiamon) {
    if (GetParam().machine != "lathe") return;
    const auto ways = [&](const std::string& dialect, const std::string& machine) {
        std::vector<json> all;
        for (json& command : commands_of({GetParam().source, machine}, dialect, "moves")) {
            if (command.contains("to")) all.push_back(std::move(command));
        }
        return all;
    };
    const std::vector<json> reference = ways("sinumerik", "lathe");
    ASSERT_GT(reference.size(), 3u);
    for (const char* dialect : {"sinumerik", "axioma", "fanuc-lathe"})
        expect_same(reference, ways(dialect, "mill"), dialect);
}

/// What a control of examples/dialects can say of a part moves as it does elsewhere; it can say all
/// parts for a mill but those that are told here.
TEST_P(SameMotion, OnControlsMadeByTheDocument) {
    if (GetParam().machine == "lathe") return;
    const std::vector<json> reference = commands_of(GetParam(), "sinumerik", "moves");
    const bool has_spline =
        std::any_of(reference.begin(), reference.end(),
                    [](const json& command) { return command["op"] == "spline"; });
    for (const golden::MadeControl& control : golden::kMadeControls) {
        SCOPED_TRACE(control.name);
        const std::string file =
            KADR_ROOT "/examples/dialects/" + std::string(control.name) + ".xml";
        const ProcessResult result =
            run_process({KADR_BINARY, "expand", GetParam().source.string(), "-d", file});
        const auto& missing = control.cannot_say;
        const bool is_missing =
            std::find(missing.begin(), missing.end(), GetParam().name()) != missing.end();
        EXPECT_EQ(result.status != 0, is_missing) << result.err;
        if (result.status != 0) {
            const bool is_given = result.err.find("K4201") != std::string::npos ||
                                  result.err.find("K3271") != std::string::npos;
            EXPECT_TRUE(is_given) << result.err;
            continue;
        }
        if (has_spline) continue;
        expect_same(reference, commands_of(GetParam(), file, "native"), std::string(control.name));
    }
}

INSTANTIATE_TEST_SUITE_P(Parts, SameMotion, ::testing::ValuesIn(golden::all_parts()),
                         [](const auto& part) { return golden::name_of(part); });

}  // namespace

}  // namespace same_motion_test
