#include "tests/stdlib/cycle_run.h"

#include <cmath>
#include <filesystem>
#include <sstream>

#include <gtest/gtest.h>
#include <unistd.h>

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

}  // namespace stdlib_test
