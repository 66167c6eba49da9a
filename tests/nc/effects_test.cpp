// What each function does to the state of a control (effects.txt), under the rules of the language
// and where those of a dialect make it another thing: so that a change is seen. KADR_UPDATE=1
// writes what is so today, to be reviewed.
#include "nc/effects.h"

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "nc_testing.h"

namespace kadr::nc::effects_test {
namespace {

Block block_with(Function function) {
    Block block{};
    block.add(function);
    return block;
}

std::string effects_in_words(const Rules& rules, const Block& block, Changer changer) {
    std::string words;
    for (const Effect& effect : effects_of(rules, block, changer)) {
        words.append(" ").append(effect_name(effect.kind));
        if (effect.when == When::ToolChange) words += "(with the tool)";
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
        const std::string language =
            effects_in_words(Rules::of_language(), block, Changer::Magazine);
        today.append(each.name).append(":").append(language).append("\n");
        for (const auto& [name, rules] : dialects) {
            const Changer changer = name.ends_with("lathe") ? Changer::Turret : Changer::Magazine;
            const std::string here = effects_in_words(rules, block, changer);
            if (here != language) today.append("  ").append(name).append(":").append(here) += '\n';
        }
    }
    const std::string file = KADR_ROOT "/tests/nc/effects.txt";
    if (std::getenv("KADR_UPDATE") != nullptr) write_file_whole(file, today);
    EXPECT_EQ(read_file(file).value_or(""), today);
}

/// What a fact says of a function and what an effect does of it agree.
TEST(Effects, AgreeWithTheFacts) {
    for (const FunctionInfo& each : all_functions()) {
        SCOPED_TRACE(each.name);
        const Block block = block_with(each.function);
        bool ends_program = false, tilts = false, changes_frame = false;
        for (const Effect& effect : effects_of(Rules::of_language(), block, Changer::Magazine)) {
            ends_program |= effect.kind == EffectKind::EndsProgram;
            tilts |= effect.kind == EffectKind::Tilts;
            changes_frame |=
                effect.kind >= EffectKind::Shift && effect.kind <= EffectKind::MirrorOff;
        }
        EXPECT_EQ(ends_program, has_fact(each.function, Fact::EndsProgram));
        EXPECT_EQ(tilts, has_fact(each.function, Fact::TiltsPlane));
        EXPECT_EQ(changes_frame, has_fact(each.function, Fact::ChangesFrame));
    }
}

/// The tool is in the spindle before the spindle turns, whichever word stands first.
TEST(Effects, ChangeTheToolBeforeTheSpindleTurns) {
    Block block = block_with(Function::SpindleCw);
    block.add(Function::ToolChange);
    const Effects effects = effects_of(Rules::of_language(), block, Changer::Magazine);
    ASSERT_EQ(effects.end() - effects.begin(), 2);
    EXPECT_GT(effects.begin()->when, (effects.begin() + 1)->when);
}

/// A rotation turns in the plane of its block, wherever that stands.
TEST(Effects, BeginWithThePlaneOfARotation) {
    Block block = block_with(Function::Rotate);
    block.add(Function::PlaneZx);
    const Effects effects = effects_of(Rules::of_language(), block, Changer::Magazine);
    ASSERT_EQ(effects.end() - effects.begin(), 2);
    EXPECT_EQ(effects.begin()->function, Function::PlaneZx);
}

}  // namespace
}  // namespace kadr::nc::effects_test
