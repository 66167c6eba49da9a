// What the interpreter's sources keep to, beyond what the compiler sees.
#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "base/text.h"

namespace {

namespace fs = std::filesystem;

const fs::path kInterp = fs::path(KADR_ROOT) / "runtime/interp";

/// What has a few meanings is an enum (modes.h), not one function of the whole vocabulary. What
/// stays is the modal motion: blocks are read, compared and written with it.
TEST(Interp, NoStateIsAnyFunction) {
    const std::set<std::string> motions = {"state.h: motion", "through_run.h: function"};
    static const std::regex member(R"(\n +(?:nc::)?Function (\w+)(?:\s*=\s*[^;]+|\{[^;]*\})?;)");
    std::set<std::string> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(kInterp)) {
        if (entry.path().extension() != ".h") continue;
        const std::string text = kadr::read_file(entry.path()).value_or("");
        for (std::sregex_iterator at(text.begin(), text.end(), member), end; at != end; ++at)
            found.insert(entry.path().filename().string() + ": " + (*at)[1].str());
    }
    EXPECT_EQ(found, motions);
}

}  // namespace
