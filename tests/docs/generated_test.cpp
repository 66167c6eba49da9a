// What pages say of the program's tables is made from them: the parts between
//   <!-- generated: NAME -->  and  <!-- end of NAME -->
// of every page. KADR_UPDATE=1 writes them.
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "base/diagnostic.h"
#include "base/disk_files.h"
#include "base/text.h"
#include "tests/docs/schema_page.h"
#include "tests/docs/table_pages.h"

namespace generated_test {

namespace {

namespace fs = std::filesystem;

using Maker = std::function<std::string()>;

Maker diagnostics(const char* code) {
    return [code] { return docs::diagnostics_table(code); };
}

/// Every part that a page may have. The diagnostics by the room that reports them.
const std::map<std::string, Maker>& parts() {
    static const std::map<std::string, Maker> all = {
        {"elements", docs::elements_of_dialects},
        {"rules", docs::rules_table},
        {"rules of the language", docs::language_rules_table},
        {"operators and functions", docs::operations_table},
        {"components of frames", docs::frame_parts_table},
        {"statements", docs::statements_table},
        {"quantities", docs::quantities_table},
        {"commands", docs::commands_table},
        {"cycles", docs::cycles_table},
        {"figures of a test", docs::figures_table},
        {"thresholds of warnings", docs::danger_limits_table},
        {"diagnostics of dialect files", diagnostics("K40")},
        {"diagnostics of whole dialect files", diagnostics("K427")},
        {"diagnostics K1", diagnostics("K1")},
        {"diagnostics K2", diagnostics("K2")},
        {"diagnostics K3", diagnostics("K3")},
        {"diagnostics K4", diagnostics("K4")},
        {"diagnostics K5", diagnostics("K5")},
        {"diagnostics K6", diagnostics("K6")},
        {"diagnostics K7", diagnostics("K7")},
        {"diagnostics K90", diagnostics("K90")},
        {"diagnostics K91", diagnostics("K91")}};
    return all;
}

/// A page with its generated parts as they are today; notes the names of those that it has.
std::string made_anew(const fs::path& page, const std::string& text, std::set<std::string>& names) {
    static const std::string kBegin = "<!-- generated: ";
    static const std::string kClose = " -->\n";
    std::string out;
    std::size_t at = 0;
    for (std::size_t begin = 0; (begin = text.find(kBegin, at)) != std::string::npos;) {
        const std::size_t name_begin = begin + kBegin.size();
        const std::size_t name_end = text.find(kClose, name_begin);
        const std::string name = text.substr(name_begin, name_end - name_begin);
        const std::size_t end = text.find("<!-- end of " + name + kClose, name_begin);
        const auto maker = parts().find(name);
        if (end == std::string::npos || maker == parts().end()) {
            ADD_FAILURE() << page << ": there is no part or no end of " << name;
            return text;
        }
        names.insert(name);
        out += text.substr(at, name_end + kClose.size() - at) + '\n' + maker->second();
        if (!out.ends_with("\n\n")) out += '\n';
        at = end;
    }
    return out + text.substr(at);
}

/// The line in which two texts first differ, with what stands there.
std::string first_difference(const std::string& page, const std::string& now) {
    std::size_t at = 0;
    while (at < page.size() && at < now.size() && page[at] == now[at]) ++at;
    const std::size_t begin = at == 0 ? 0 : now.rfind('\n', at - 1) + 1;
    return now.substr(begin, now.find('\n', at) - begin);
}

TEST(Generated, PartsOfPagesAreToday) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(KADR_ROOT "/docs")) {
        if (entry.path().extension() != ".md") continue;
        const std::string text = kadr::read_file(entry.path().string()).value_or("");
        const std::string now = made_anew(entry.path(), text, names);
        if (std::getenv("KADR_UPDATE") != nullptr && now != text) {
            ASSERT_TRUE(kadr::write_file_whole(entry.path().string(), now));
        }
        EXPECT_TRUE(now == text) << entry.path() << " lags behind the tables; run with "
                                 << "KADR_UPDATE=1 and read the difference. The first line is\n"
                                 << first_difference(text, now);
    }
    for (const auto& [name, maker] : parts())
        EXPECT_TRUE(names.contains(name)) << "no page has the part " << name;
}

/// The words by which the page says what is warned of are its own; that each is there is not.
TEST(Generated, EveryDangerIsInThePageOnWarnings) {
    const std::string page = kadr::read_file(KADR_ROOT "/docs/warnings.md").value_or("");
    int rows = 0;
    for (const kadr::DiagnosticRow* row : kadr::all_diagnostics()) {
        if (row->code < "K5970" || row->code > "K5999") continue;
        ++rows;
        EXPECT_NE(page.find("| " + std::string(row->code) + " |"), std::string::npos) << row->code;
    }
    EXPECT_GT(rows, 10);
}

}  // namespace

}  // namespace generated_test
