// The rows of the digests of the controls' manuals, and what tests each: the list of a control is
// tests/control/coverage/rows-NAME.txt, whose head says how it is written. Held here: that
// each chapter has as many rows as its head says, that each row names tests or a reason, that what
// it names is there and says what the row needs, and that no alarm of the dialect is without a row.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "macro/program.h"
#include "nc/tables.h"
#include "tests/common/held_texts.h"
#include "tests/control/control_programs.h"
#include "tests/interp/bench.h"

namespace kadr::interp::rows_test {
namespace {

namespace fs = std::filesystem;

const fs::path kTests = fs::path(KADR_ROOT) / "tests";

std::string content_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

struct Row {
    std::string chapter;
    std::string name;
    std::vector<std::string> tests;
    std::string reason;
};

struct Chapter {
    std::string name;
    std::size_t rows = 0;  // as its head says
};

struct RowList {
    std::vector<Chapter> chapters;
    std::vector<Row> rows;
};

RowList read_list(const std::string& control) {
    RowList list;
    std::istringstream lines(
        content_of(kTests / "control/coverage" / ("rows-" + control + ".txt")));
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line[0] == '#') continue;
        if (line.starts_with("== ")) {
            const std::size_t colon = line.rfind(':');
            list.chapters.push_back(
                {line.substr(3, colon - 3), std::stoul(line.substr(colon + 1))});
            continue;
        }
        const std::size_t bar = line.find(" | ");
        if (bar == std::string::npos) {
            ADD_FAILURE() << line << ": a row is `name | tests` or `name | - reason`";
            continue;
        }
        Row row{list.chapters.back().name, line.substr(0, bar), {}, {}};
        const std::string behind = line.substr(bar + 3);
        if (behind.starts_with("- ")) {
            row.reason = behind.substr(2);
        } else {
            std::istringstream words(behind);
            row.tests.assign(std::istream_iterator<std::string>(words), {});
        }
        list.rows.push_back(std::move(row));
    }
    return list;
}

/// `14040`: numbers of alarms among the words of a row's name.
std::vector<std::string> alarms_in(const std::string& name) {
    std::vector<std::string> out;
    std::istringstream words(name);
    for (std::string word; words >> word;) {
        if (word.size() >= 4 &&
            std::ranges::all_of(word, [](unsigned char c) { return std::isdigit(c); }))
            out.push_back(word);
    }
    return out;
}

class Evidence {
  public:
    explicit Evidence(std::string control)
        : control_(std::move(control)),
          words_(content_of(kTests / "control/words" / (control_ + ".txt"))),
          variables_(variables_of(control_)) {
        for (const nc::Example& example : dialect().examples()) words_ += example.text + '\n';
    }

    const nc::Dialect& dialect() const { return dialect_named(control_); }

    /// What a test of a row says; empty: there is none.
    std::string text_of(const std::string& test) const {
        const auto behind = [&](std::string_view head) { return test.substr(head.size()); };
        if (test.starts_with("bad/")) {
            return content_of(kTests / "bad/cases" / control_ / (behind("bad/") + ".mpf"));
        }
        if (test.starts_with("missing:"))
            return dialect().tables().unsupported_words(behind("missing:"));
        if (test.starts_with("word:")) return holds_word(words_, behind("word:")) ? test : "";
        if (test.starts_with("variables:"))
            return holds_word(variables_, behind("variables:")) ? test : "";
        if (test == "variables") return variables_;
        if (test.starts_with("../")) return text_of_room(behind("../"));
        // The programs of SINUMERIK run on both controls.
        const std::string own = program_text(control_, test);
        return own.empty() ? program_text("sinumerik", test) : own;
    }

  private:
    /// The lists of the control and of those that it extends.
    static std::string variables_of(const std::string& control) {
        std::string text;
        for (std::string name = control; !name.empty(); name = golden::base_of(name))
            text += content_of(kTests / "control/variables" / (name + ".txt"));
        return text;
    }
    /// `interp/orienting_test.cpp:NAME`: the file, if it says the name.
    static std::string text_of_room(const std::string& test) {
        const std::size_t colon = test.find(':');
        if (colon == std::string::npos) return "";
        const std::string text = content_of(kTests / test.substr(0, colon));
        return text.find(test.substr(colon + 1)) == std::string::npos ? "" : text;
    }
    static bool holds_word(const std::string& text, const std::string& word) {
        const auto is_part = [](char c) {
            return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$';
        };
        for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; ++at) {
            const std::size_t end = at + word.size();
            const bool begins = at == 0 || !is_part(text[at - 1]);
            if (begins && (end == text.size() || !is_part(text[end]))) return true;
        }
        return false;
    }
    static const nc::Dialect& dialect_named(const std::string& name) {
        static std::map<std::string, nc::Dialect> loaded;
        if (const auto known = loaded.find(name); known != loaded.end()) return known->second;
        Sources sources;
        DiagnosticList messages;
        auto dialect = nc::load_dialect(name, {KADR_ROOT "/dialects"}, sources, messages);
        return loaded.emplace(name, std::move(*dialect)).first->second;
    }

    std::string control_;
    std::string words_;
    std::string variables_;
};

class Rows : public ::testing::TestWithParam<const char*> {};

TEST_P(Rows, ChaptersAreComplete) {
    const RowList list = read_list(GetParam());
    EXPECT_GT(list.chapters.size(), 5u);
    for (const Chapter& chapter : list.chapters) {
        const auto rows =
            static_cast<std::size_t>(std::ranges::count(list.rows, chapter.name, &Row::chapter));
        EXPECT_EQ(rows, chapter.rows) << chapter.name;
    }
}

TEST(RowsOfSinumerik, EveryChapterIsThere) {
    const RowList list = read_list("sinumerik");
    for (const char* number :
         {"1.1", "1.2",  "1.3", "1.4", "1.5", "1.6", "1.7", "2.1",  "2.2",  "2.3",  "3.1",  "3.2",
          "3.3", "3.4",  "3.5", "3.6", "4.1", "4.2", "4.3", "4.4",  "4.5",  "4.6",  "4.7",  "4.8",
          "4.9", "4.10", "5.1", "5.2", "6.1", "6.2", "6.3", "6.4",  "8.1",  "8.2",  "8.3",  "8.4",
          "8.5", "8.6",  "8.7", "8.8", "8.9", "9",   "10",  "10.1", "10.2", "10.3", "10.4", "11",
          "13",  "14",   "15",  "5.3", "6.5", "7.1", "7.2", "7.3",  "7.4",  "7.5",  "7.6"}) {
        const std::string head = std::string(number) + ' ';
        EXPECT_TRUE(std::ranges::any_of(list.chapters, [&](const Chapter& chapter) {
            return chapter.name.starts_with(head);
        })) << number;
    }
}

TEST_P(Rows, EachRowHasItsTests) {
    const Evidence evidence(GetParam());
    for (const Row& row : read_list(GetParam()).rows) {
        SCOPED_TRACE(row.chapter + ": " + row.name);
        EXPECT_NE(row.tests.empty(), row.reason.empty()) << "tests, or a reason why there is none";
        const std::vector<std::string> alarms = alarms_in(row.name);
        std::set<std::string> shown;
        for (const std::string& test : row.tests) {
            const std::string text = evidence.text_of(test);
            EXPECT_FALSE(text.empty()) << "there is no " << test;
            for (const std::string& number : alarms) {
                const bool is_case = test.starts_with("bad/");
                const std::string words =
                    is_case ? ' ' + number + ' ' : "expect: alarm " + number + ' ';
                if (text.find(words) != std::string::npos) shown.insert(number);
            }
        }
        if (!row.reason.empty()) continue;
        for (const std::string& number : alarms)
            EXPECT_TRUE(shown.contains(number)) << "no test of the row comes to alarm " << number;
    }
}

INSTANTIATE_TEST_SUITE_P(, Rows, ::testing::Values("sinumerik", "axioma"),
                         [](const auto& test) { return std::string(test.param); });

TEST(RowsOfSinumerik, NoAlarmOfTheDialectIsWithoutARow) {
    const RowList list = read_list("sinumerik");
    std::set<std::string> listed;
    for (const Row& row : list.rows)
        std::ranges::copy(alarms_in(row.name), std::inserter(listed, listed.end()));
    const nc::DialectTables& tables = Evidence("sinumerik").dialect().tables();
    for (const auto& [row, alarm] : tables.alarms)
        EXPECT_TRUE(listed.contains(alarm.number)) << alarm.number << " of " << row;
    for (const nc::AlarmAbout& about : tables.alarms_about)
        EXPECT_TRUE(listed.contains(about.alarm.number))
            << about.alarm.number << " of " << about.row;
}

}  // namespace
}  // namespace kadr::interp::rows_test
