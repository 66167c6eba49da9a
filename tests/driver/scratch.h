// scratch.h — a folder of its own for every test that runs the program, and the rows of a CSV.
#pragma once

#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/text.h"
#include "tests/common/process.h"

namespace kadr::test {

class ScratchFolder : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ =
            std::filesystem::temp_directory_path() / ("kadr-run-" + std::to_string(::getpid()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string file(const std::string& name) const { return (folder_ / name).string(); }
    void save(const std::string& name, const std::string& text) const {
        ASSERT_TRUE(write_file_whole(file(name), text));
    }
    static ProcessResult kadr(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), KADR_BINARY);
        return run_process(arguments);
    }

  private:
    std::filesystem::path folder_;
};

/// Rows of a CSV by the names of their columns; lines that begin with # are left out.
using Row = std::map<std::string, double>;

inline std::vector<Row> rows_of(const std::string& text) {
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    std::vector<std::string> names;
    std::istringstream header(line);
    for (std::string name; std::getline(header, name, ',');) names.push_back(name);
    std::vector<Row> rows;
    while (std::getline(lines, line)) {
        if (line.starts_with('#')) continue;
        std::istringstream fields(line);
        Row row;
        std::size_t i = 0;
        for (std::string field; std::getline(fields, field, ',') && i < names.size(); ++i) {
            row[names[i]] = std::stod(field);
        }
        EXPECT_EQ(i, names.size()) << line;
        rows.push_back(row);
    }
    return rows;
}

}  // namespace kadr::test
