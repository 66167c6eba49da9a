// Every row of the table of syntax messages: its wrong example causes it, its right one is right.
#include <set>

#include "parsing.h"

namespace kadr::syntax::table_test {
namespace {

/// Rows whose examples are no Kadr text: files in other formats, commands, XML.
const std::set<std::string_view> kNoPrograms = {"K1001", "K1002", "K1003", "K1004", "K1005"};

bool says(const std::string& text, std::string_view code) {
    const Parsed result(text);
    for (const Diagnostic& diagnostic : result.list.all()) {
        if (diagnostic.row->code == code) return true;
    }
    return false;
}

TEST(Table, ExamplesOfTheMessages) {
    for (const DiagnosticRow* row : all_diagnostics()) {
        const std::string_view code = row->code;
        if (!code.starts_with("K1") || code >= "K1300" || kNoPrograms.count(code) > 0) continue;
        const std::string wrong(row->wrong);
        const std::string right(row->right);
        // An example is a whole file or the inside of a cycle.
        const auto inside = [](const std::string& text) {
            return "cycle test() {\n" + text + "\n}";
        };
        EXPECT_TRUE(says(wrong, code) || says(inside(wrong), code)) << code << ": " << wrong;
        EXPECT_TRUE(Parsed(right).messages().empty() || Parsed(inside(right)).messages().empty())
            << code << ": " << right << '\n'
            << Parsed(inside(right)).messages();
    }
}

}  // namespace
}  // namespace kadr::syntax::table_test
