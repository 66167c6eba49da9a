#include "tests/stdlib/cycle_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <sstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/common/process.h"

namespace stdlib_test {

using nlohmann::json;

double Dice::length(double low, double high) {
    return std::round(std::uniform_real_distribution<>(low, high)(engine_) * 10) / 10;
}

std::string mm(double value) { return json(std::round(value * 1000) / 1000).dump() + "mm"; }

CycleRun run_text(const std::string& text, const std::string& dialect, const std::string& machine) {
    namespace fs = std::filesystem;
    const fs::path file =
        fs::temp_directory_path() / ("kadr-stdlib-" + std::to_string(::getpid()) + ".kadr");
    EXPECT_TRUE(kadr::write_file_whole(file.string(), text));
    const ProcessResult result = run_process(
        {KADR_BINARY, "run", file.string(), "-d", dialect, "-m", machine, "--commands", "-"});
    CycleRun run;
    run.status = result.status;
    run.error = result.err;
    std::istringstream lines(result.out);
    for (std::string line; std::getline(lines, line);) {
        json command = json::parse(line, nullptr, false);
        if (command.is_object()) run.commands.push_back(std::move(command));
    }
    std::error_code ignored;
    fs::remove(file, ignored);
    return run;
}

CycleRun run_cycle(const std::string& module, const std::string& call, const std::string& dialect) {
    return run_text("import " + module + ";\nprogram test() {\n    S5000 M3;\n    F600;\n" +
                        "    G0 X0 Y0 Z40;\n    " + call + ";\n    M30;\n}\n",
                    dialect, "mill");
}

namespace {

/// Whether an arc goes on where another one about the same centre ends: a control may take an arc
/// in two parts, so that its centre stays where it is meant.
bool goes_on(const json& arc, const json& before) {
    if (arc.value("op", "") != "arc" || before.value("op", "") != "arc") return false;
    if (arc.value("dir", "") != before.value("dir", "")) return false;
    constexpr double kRounding = 0.003;
    for (std::size_t i = 0; i < 2; ++i) {
        const double apart = arc["center"][i].get<double>() - before["center"][i].get<double>();
        if (std::fabs(apart) > kRounding) return false;
    }
    return true;
}

std::vector<json> places_of(const std::vector<json>& commands) {
    std::vector<json> result;
    const json* before = nullptr;
    for (const json& command : commands) {
        if (!command.contains("to")) continue;
        const bool is_part = before != nullptr && goes_on(command, *before);
        before = &command;
        if (is_part) result.pop_back();
        if (result.empty() || result.back() != command["to"]) result.push_back(command["to"]);
    }
    return result;
}

}  // namespace

/// Without the places in the middle of arcs that a control has in two parts, because their words
/// cannot say the centre finely enough.
static std::vector<json> without_halves(std::vector<json> got, const std::vector<json>& wanted) {
    const auto is_at = [](const json& a, const json& b) {
        return std::ranges::all_of(std::array{"X", "Y", "Z"}, [&](const char* axis) {
            if (!a.contains(axis) || !b.contains(axis)) return true;
            return std::fabs(a[axis].get<double>() - b[axis].get<double>()) <= 0.0011;
        });
    };
    for (std::size_t i = 0; i + 1 < got.size() && i < wanted.size(); ++i) {
        if (is_at(got[i], wanted[i]) || !is_at(got[i + 1], wanted[i])) continue;
        got.erase(got.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return got;
}

std::string motion_difference(const std::vector<json>& commands, const std::string& module,
                              const std::string& call, const std::string& dialect) {
    const CycleRun run = run_cycle(module, call, dialect);
    if (run.status != 0) return run.error;
    const std::vector<json> wanted = places_of(commands);
    const std::vector<json> got = without_halves(places_of(run.commands), wanted);
    if (got.size() != wanted.size()) {
        return dialect + ": " + std::to_string(got.size()) + " moves, not " +
               std::to_string(wanted.size());
    }
    for (std::size_t i = 0; i < got.size(); ++i) {
        for (const char* axis : {"X", "Y", "Z"}) {
            if (!wanted[i].contains(axis) || !got[i].contains(axis)) continue;
            const double apart = got[i][axis].get<double>() - wanted[i][axis].get<double>();
            if (std::fabs(apart) > 0.0011)
                return dialect + ": " + got[i].dump() + ", not " + wanted[i].dump();
        }
    }
    return "";
}

std::vector<json> commands_of(const std::string& module, const std::string& call) {
    CycleRun run = run_cycle(module, call);
    EXPECT_EQ(run.status, 0) << call << run.error;
    return std::move(run.commands);
}

}  // namespace stdlib_test
