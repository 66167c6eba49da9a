// What each function does to the state of a control (effects.txt), under the rules of the language
// and where those of a dialect make it another thing: so that a change is seen. KADR_UPDATE=1
// writes what is so today, to be reviewed.
#include "nc/effects.h"

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/text.h"
#include "nc_testing.h"

namespace kadr::nc {
namespace {

Block block_with(Function function) {
    Block block{};
    block.add(function);
    return block;
}

std::string effects_in_words(const Rules& rules, const Block& block, bool on_lathe) {
    std::string words;
    for (const Effect& effect : effects_of(rules, block, on_lathe)) {
        words.append(" ").append(effect_name(effect.kind));
        if (effect.when == When::BeforeMotion) words += "(before the motion)";
        if (effect.when == When::Behind) words += "(behind)";
    }
    return words;
}

TEST(Effects, AreThoseOfTheList) {
    std::vector<std::pair<std::string, Rules>> dialects;
    for (const char* name : {"sinumerik", "fanuc", "fanuc-lathe", "axioma"})
        dialects.emplace_back(name, testing::shipped(name).rules());
    std::string today;
    for (const FunctionInfo& each : all_functions()) {
        if (each.function == Function::None) continue;
        const Block block = block_with(each.function);
        const std::string language = effects_in_words(Rules::of_language(), block, false);
        today.append(each.name).append(":").append(language).append("\n");
        for (const auto& [name, rules] : dialects) {
            const std::string here = effects_in_words(rules, block, name.ends_with("lathe"));
            if (here != language) today.append("  ").append(name).append(":").append(here) += '\n';
        }
    }
    const std::string file = KADR_ROOT "/tests/nc/effects.txt";
    if (std::getenv("KADR_UPDATE") != nullptr) write_file_whole(file, today);
    EXPECT_EQ(read_file(file).value_or(""), today);
}

/// A rotation turns in the plane of its block, wherever that stands.
TEST(Effects, BeginWithThePlaneOfARotation) {
    Block block = block_with(Function::Rotate);
    block.add(Function::PlaneZx);
    const Effects effects = effects_of(Rules::of_language(), block, false);
    ASSERT_EQ(effects.end() - effects.begin(), 2);
    EXPECT_EQ(effects.begin()->function, Function::PlaneZx);
}

}  // namespace
}  // namespace kadr::nc
