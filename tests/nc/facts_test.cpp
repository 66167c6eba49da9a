// The columns of the vocabulary (facts.txt): which functions each fact holds of, so that a change
// of a column is seen. KADR_UPDATE=1 writes what the table says today, to be reviewed.
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "nc/vocabulary.h"

namespace kadr::nc::facts_test {
namespace {

TEST(Facts, AreThoseOfTheList) {
    std::string today;
    const auto facts = all_facts();
    for (std::size_t i = 0; i < facts.size(); ++i) {
        today.append(facts[i].name).append(": ").append(facts[i].meaning).append("\n");
        for (const FunctionInfo& each : all_functions()) {
            if (has_fact(each.function, static_cast<Fact>(i)))
                today.append("  ").append(each.name).append("\n");
        }
    }
    const std::string file = KADR_ROOT "/tests/nc/facts.txt";
    if (std::getenv("KADR_UPDATE") != nullptr) write_file_whole(file, today);
    EXPECT_EQ(read_file(file).value_or(""), today);
}

}  // namespace
}  // namespace kadr::nc::facts_test
