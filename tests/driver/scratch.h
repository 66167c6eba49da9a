// scratch.h — a folder of its own for every test that runs the program, and the rows of a CSV.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/disk_files.h"
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

/// A row of a CSV; its numbers by the names of their columns, which all rows share.
class Row {
  public:
    using Names = std::map<std::string, std::size_t, std::less<>>;
    Row(std::shared_ptr<const Names> names, std::vector<double> numbers)
        : names_(std::move(names)), numbers_(std::move(numbers)) {}

    double at(std::string_view name) const {
        const auto found = names_->find(name);
        if (found == names_->end()) throw std::out_of_range(std::string(name));
        return numbers_.at(found->second);
    }
    double operator[](std::string_view name) const { return at(name); }
    bool contains(std::string_view name) const { return names_->contains(name); }
    bool operator==(const Row& other) const {
        return *names_ == *other.names_ && numbers_ == other.numbers_;
    }

  private:
    std::shared_ptr<const Names> names_;
    std::vector<double> numbers_;
};

/// The rows of a CSV; lines that begin with # are left out.
inline std::vector<Row> rows_of(const std::string& text) {
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    auto names = std::make_shared<Row::Names>();
    std::istringstream header(line);
    for (std::string name; std::getline(header, name, ',');) names->emplace(name, names->size());
    std::vector<Row> rows;
    while (std::getline(lines, line)) {
        if (line.starts_with('#')) continue;
        std::vector<double> numbers;
        numbers.reserve(names->size());
        const char* at = line.c_str();
        for (char* end = nullptr; *at != '\0'; at = *end == ',' ? end + 1 : end) {
            numbers.push_back(std::strtod(at, &end));
            if (end == at) break;
        }
        EXPECT_EQ(numbers.size(), names->size()) << line;
        if (numbers.size() == names->size()) rows.emplace_back(names, std::move(numbers));
    }
    return rows;
}

}  // namespace kadr::test
