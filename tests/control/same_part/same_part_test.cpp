// The same parts written by hand in the language of each control and in Kadr: the commands are the
// same. The programs beside, in the folder `programs`, are found by --search.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/common/process.h"

namespace same_part_test {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string kFolder = KADR_ROOT "/tests/control/same_part/";

/// What is executed, without the place in the text.
std::vector<json> commands_of(const std::string& program, const std::string& dialect) {
    const fs::path out = fs::temp_directory_path() / ("same_part_" + dialect + ".jsonl");
    std::vector<std::string> words = {KADR_BINARY, "run",      kFolder + program,    "-d",
                                      dialect,     "--search", kFolder + "programs", "--commands",
                                      out.string()};
    const ProcessResult result = run_process(words);
    EXPECT_EQ(result.status, 0) << program << '\n' << result.err;
    std::vector<json> commands;
    std::ifstream in(out);
    for (std::string line; std::getline(in, line);) {
        json command = json::parse(line);
        for (const char* key : {"iso", "src"}) command.erase(key);
        commands.push_back(std::move(command));
    }
    fs::remove(out);
    return commands;
}

/// The same but for what one increment of the controls, a thousandth, rounds away.
bool is_same(const json& a, const json& b) {
    constexpr double kRounding = 0.0006;
    if (a.is_number() && b.is_number())
        return std::abs(a.get<double>() - b.get<double>()) <= kRounding;
    if (a.size() != b.size() || a.type() != b.type()) return false;
    if (!a.is_structured()) return a == b;
    for (const auto& [key, value] : a.items()) {
        if (a.is_object() && !b.contains(key)) return false;
        if (!is_same(value, a.is_object() ? b[key] : b[std::stoul(key)])) return false;
    }
    return true;
}

TEST(SamePart, FlangeInThreeLanguages) {
    const std::vector<json> kadr = commands_of("flange.kadr", "iso");
    EXPECT_GT(kadr.size(), 60u);
    for (const auto& [program, dialect] :
         {std::pair{"flange.mpf", "sinumerik"}, std::pair{"flange.nc", "fanuc"}}) {
        SCOPED_TRACE(program);
        const std::vector<json> hand = commands_of(program, dialect);
        ASSERT_EQ(hand.size(), kadr.size());
        for (std::size_t i = 0; i < kadr.size(); ++i) {
            EXPECT_TRUE(is_same(hand[i], kadr[i])) << i << ' ' << hand[i] << ' ' << kadr[i];
        }
    }
}

}  // namespace

}  // namespace same_part_test
