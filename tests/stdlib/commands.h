// commands.h — a library's call in a program of its own, and the commands that it became.
#pragma once

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/common/process.h"

namespace stdlib_test {

/// What `kadr run` made of a program: commands, exit status, messages.
struct Outcome {
    std::vector<nlohmann::json> commands;
    int status = 0;
    std::string messages;
};

inline Outcome outcome_of(const std::string& program, const std::string& dialect,
                          const std::string& machine, const std::string& cycles = "moves") {
    const std::filesystem::path file = std::filesystem::temp_directory_path() /
                                       ("kadr-library-" + std::to_string(::getpid()) + ".kadr");
    EXPECT_TRUE(kadr::write_file_whole(file.string(), program));
    const ProcessResult result =
        run_process({KADR_BINARY, "run", file.string(), "-d", dialect, "-m", machine, "--cycles",
                     cycles, "--commands", "-"});
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    Outcome outcome{{}, result.status, result.err};
    std::istringstream lines(result.out);
    for (std::string line; std::getline(lines, line);) {
        nlohmann::json command = nlohmann::json::parse(line, nullptr, false);
        if (command.is_object()) outcome.commands.push_back(std::move(command));
    }
    return outcome;
}

}  // namespace stdlib_test
