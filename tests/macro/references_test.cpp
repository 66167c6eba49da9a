// What reading alone finds in texts of the controls: references/DIALECT/*, each with its questions
// in comments below the lines that they are about (references/README.md).
#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "driver/program_files.h"
#include "macro/reference_queries.h"
#include "macro/target_index.h"
#include "nc/held_text.h"
#include "tests/common/inputs.h"

namespace kadr::macro::references_test {
namespace {

namespace fs = std::filesystem;
using nc::HeldText;

const fs::path kFolder = fs::path(KADR_ROOT) / "tests/macro/references";

const nc::Dialect& dialect_named(const std::string& name) {
    static std::map<std::string, nc::Dialect> loaded;
    if (const auto known = loaded.find(name); known != loaded.end()) return known->second;
    Sources sources;
    DiagnosticList messages;
    auto dialect = nc::load_dialect(name, {KADR_ROOT "/dialects", KADR_ROOT "/examples/dialects"},
                                    sources, messages);
    EXPECT_TRUE(dialect.has_value());
    return loaded.emplace(name, std::move(*dialect)).first->second;
}

struct Question {
    std::uint64_t byte = 0;  // that the caret points to
    std::uint64_t line = 0;  // where that line begins
    std::string what;
    std::string answer;
};

std::vector<Question> questions_of(std::string_view text) {
    std::vector<Question> all;
    std::size_t code = 0;  // where the line begins that is asked about
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string_view line = text.substr(at, end - at);
        const std::size_t caret = line.find('^');
        const std::size_t colon = line.find(": ", caret);
        const bool is_comment = line.starts_with(';') || line.starts_with('(');
        if (!is_comment || caret == std::string_view::npos) {
            code = at;
        } else if (colon != std::string_view::npos) {
            if (line.starts_with('(')) line.remove_suffix(1);
            all.push_back({code + caret, code,
                           std::string(line.substr(caret + 2, colon - caret - 2)),
                           std::string(line.substr(colon + 2))});
        }
        at = end + 1;
    }
    return all;
}

struct Subject {
    const nc::Dialect& dialect;
    HeldText& text;
    const References& references;
    ProgramFiles& files;
    const Question& question;
};

std::string place_in(const std::string& text, const TextRange& range) {
    const std::size_t line =
        range.begin == 0 ? std::string::npos : text.rfind('\n', range.begin - 1);
    const std::size_t begin = line == std::string::npos ? 0 : line + 1;
    return std::to_string(range.line) + ':' + std::to_string(range.begin - begin + 1);
}

std::string shown(const Subject& subject, const NamedPlace& place) {
    if (place.file == subject.references.file) return place_in(subject.text.all(), place.range);
    return fs::path(place.file).filename().string() + ':' +
           place_in(read_file(place.file).value_or(""), place.range);
}

const TextUse* use(const Subject& subject) {
    return use_at(subject.references, subject.question.byte);
}

std::string leads(const Subject& subject) {
    const TextUse* const found = use(subject);
    if (found == nullptr) return "";
    if (const auto target = target_of(subject.references, *found)) return shown(subject, *target);
    switch (found->outcome) {
        case TextUse::Outcome::Computed: return "computed";
        case TextUse::Outcome::Missing: return "missing";
        case TextUse::Outcome::Ambiguous: return "ambiguous";
        case TextUse::Outcome::OfCaller: return "of caller";
        default: return "nowhere";
    }
}

std::string kind_of(TextDeclaration::Kind kind) {
    switch (kind) {
        case TextDeclaration::Kind::Program: return "program";
        case TextDeclaration::Kind::Label: return "label";
        case TextDeclaration::Kind::Block: return "block";
        case TextDeclaration::Kind::Variable: return "variable";
        case TextDeclaration::Kind::Parameter: return "parameter";
        case TextDeclaration::Kind::Macro: return "macro";
    }
    return "";
}

std::string description(const Subject& subject) {
    const auto place = declaration_at(subject.references, subject.question.byte);
    return place ? kind_of(place->kind) + ' ' + place->name : "";
}

std::string manner(const Subject& subject) {
    const TextUse* const found = use(subject);
    if (found == nullptr) return "";
    switch (found->kind) {
        case TextUse::Kind::Call: return "call";
        case TextUse::Kind::Jump: return "jump";
        case TextUse::Kind::Repeat: return "repeat";
        case TextUse::Kind::Read: return "read";
        case TextUse::Kind::Write: return "write";
        case TextUse::Kind::Mention: return "mention";
    }
    return "";
}

std::string uses(const Subject& subject) {
    const auto place = declaration_at(subject.references, subject.question.byte);
    if (!place) return "";
    std::string all;
    for (const NameOccurrence& each : occurrences_of({&subject.references, 1}, *place)) {
        const std::string at = place_in(subject.text.all(), each.range);
        all += (all.empty() ? "" : " ") + (each.is_declaration ? '[' + at + ']' : at);
    }
    return all;
}

std::string proposals(const Subject& subject) {
    const std::string& text = subject.text.all();
    const std::uint64_t begin = subject.question.line;
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    LineCursor cursor;
    cursor.line = std::string_view(text).substr(begin, end - begin);
    cursor.begin = begin;
    cursor.column = static_cast<std::uint32_t>(subject.question.byte - begin);
    std::string all;
    for (const std::string& name :
         names_at(subject.dialect, subject.text, subject.references, cursor, &subject.files))
        all += (all.empty() ? "" : " ") + name;
    return all;
}

std::string outline(const Subject& subject) {
    std::string all;
    for (const OutlineRow& row : outline_of(subject.references)) {
        const std::string kind = row.kind == OutlineRow::Kind::Program ? "program "
                                 : row.kind == OutlineRow::Kind::Label ? "label "
                                                                       : "call ";
        all += (all.empty() ? "" : ", ") + kind + row.name + ' ' + std::to_string(row.range.line);
    }
    return all;
}

std::string answer(const Subject& subject) {
    static const std::map<std::string, std::function<std::string(const Subject&)>> kAnswers = {
        {"leads", leads}, {"is", description},     {"uses", uses},
        {"as", manner},   {"proposes", proposals}, {"outline", outline},
    };
    const auto found = kAnswers.find(subject.question.what);
    return found == kAnswers.end() ? "no such question" : found->second(subject);
}

class TextReferences : public ::testing::TestWithParam<fs::path> {};

TEST_P(TextReferences, Answer) {
    const fs::path file = kFolder / GetParam();
    const nc::Dialect& dialect = dialect_named(GetParam().parent_path().string());
    const std::vector<Question> questions = questions_of(read_file(file.string()).value());
    EXPECT_FALSE(questions.empty());
    // Pieces end anywhere, and lines go over from one to the next.
    for (const std::size_t piece : {~std::size_t{0}, std::size_t{37}}) {
        HeldText text(read_file(file.string()).value(), piece);
        const std::string called = (file.parent_path() / "called").string();
        driver::ProgramFolders files({called}, test::quiet_session(called));
        ReferenceOptions options;
        options.files = &files;
        const References references = find_references(dialect, text, file.string(), options);
        for (const Question& question : questions) {
            const Subject subject{dialect, text, references, files, question};
            const auto line = std::count(
                text.all().begin(), text.all().begin() + static_cast<long>(question.line), '\n');
            EXPECT_EQ(answer(subject), question.answer)
                << line + 1 << ':' << question.byte - question.line + 1 << ' ' << question.what;
        }
    }
}

/// Of a long text little is kept: what it names, and the blocks at which that aims.
TEST(LongText, KeepsWhatIsNamed) {
    constexpr int kBlocks = 20'000;
    std::string all = "O0001\nGOTO 19990\n";
    for (int i = 1; i <= kBlocks; ++i)
        all += 'N' + std::to_string(i) + " G01 X" + std::to_string(i % 100) + ". F100.\n";
    all += "GOTO 7\nM98 P1 Q5\nM30\n";
    HeldText text(all, 5000);
    const References references = find_references(dialect_named("fanuc"), text, "O0001");
    EXPECT_EQ(references.declarations.size(), 4u);  // the program, N19990, N7, N5
    ASSERT_EQ(references.uses.size(), 4u);
    const std::vector<std::uint64_t> lines = {19992, 9, 1, 7};  // the first block stands in line 3
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto target = target_of(references, references.uses[i]);
        ASSERT_TRUE(target.has_value()) << references.uses[i].name;
        EXPECT_EQ(target->range.line, lines[i]) << references.uses[i].name;
    }
    const auto blocks = blocks_of(dialect_named("fanuc"), text, references, 0, 3);
    ASSERT_EQ(blocks.size(), 3u);
    EXPECT_EQ(blocks[2].name, "3");
    EXPECT_EQ(blocks[2].range.line, 5u);
}

References references_of(const std::string& dialect, const fs::path& file) {
    HeldText text(read_file(file.string()).value());
    const std::string called = (kFolder / dialect / "called").string();
    driver::ProgramFolders files({called}, test::quiet_session(called));
    ReferenceOptions options;
    options.files = &files;
    return find_references(dialect_named(dialect), text, file.string(), options);
}

std::vector<std::string> shown(const std::vector<NameOccurrence>& occurrences) {
    std::vector<std::string> all;
    for (const NameOccurrence& each : occurrences)
        all.push_back(std::to_string(each.text) + ':' + std::to_string(each.range.line) +
                      (each.is_declaration ? " declared" : ""));
    return all;
}

/// A caller and the file that it calls mean the same name by the same place.
TEST(SeveralTexts, ShareNames) {
    struct Row {
        const char* dialect;
        const char* caller;
        const char* called;
        std::vector<std::string> places;
    };
    for (const Row& row :
         {Row{"sinumerik", "repeats.mpf", "POCK.SPF", {"1:1 declared"}},
          Row{"sinumerik", "shapes.mpf", "POCK.SPF", {"0:2", "0:9", "1:1 declared"}},
          Row{"fanuc", "calls.nc", "PART_17", {"0:23", "1:2 declared"}},
          Row{"fanuc-lathe", "calls.nc", "O9100.NC", {"0:3", "1:1 declared"}}}) {
        SCOPED_TRACE(row.called);
        const fs::path folder = kFolder / row.dialect;
        const std::vector<References> texts = {
            references_of(row.dialect, folder / row.caller),
            references_of(row.dialect, folder / "called" / row.called)};
        const TextDeclaration& program = texts[1].declarations[0];
        const auto place = declaration_at(texts[1], program.range.begin);
        ASSERT_TRUE(place.has_value());
        EXPECT_EQ(place->kind, TextDeclaration::Kind::Program);
        EXPECT_EQ(shown(occurrences_of(texts, *place)), row.places);
    }
}

/// What a called text calls may stand in the text that was begun with.
TEST(SeveralTexts, LookIntoTheOneThatWasBegunWith) {
    HeldText main("O0001\nM98 P2\nM30\nO0003\nM99\n");
    HeldText called("O0002\nM98 P3\nM98 P4\nM99\n");
    ReferenceOptions options;
    options.main = &main;
    options.main_name = "main";
    const References references =
        find_references(dialect_named("fanuc"), called, "called", options);
    ASSERT_EQ(references.uses.size(), 2u);
    const auto target = target_of(references, references.uses[0]);
    ASSERT_TRUE(target.has_value());
    EXPECT_EQ(target->file, "main");
    EXPECT_EQ(target->range, (TextRange{18, 22, 4}));
    EXPECT_EQ(references.uses[1].outcome, TextUse::Outcome::Missing);
}

TEST(Twins, AreMarked) {
    HeldText text("AA: X1\nAA: X2\nBB: X3\nGOTOB AA\n%_N_SUB_SPF\nAA: X4\n");
    const References references = find_references(dialect_named("sinumerik"), text, "MAIN.MPF");
    std::string twins;
    for (const TextDeclaration& each : references.declarations)
        if (each.is_twin) twins += each.name + ' ' + std::to_string(each.range.line) + ' ';
    EXPECT_EQ(twins, "AA 2 ");
}

/// A random text of blocks, labels, heads and ends of programs.
std::string random_text(std::mt19937& random) {
    const std::vector<std::string> lines = {"N1 X1", "N2 X2",       "AA: X3",      "BB: X4",
                                            "X5",    "%_N_ONE_SPF", "%_N_TWO_MPF", "N1 AA: X6"};
    std::string text;
    const std::size_t count = random() % 14;
    for (std::size_t i = 0; i < count; ++i) text += lines[random() % lines.size()] + '\n';
    return text;
}

/// Every target, in every direction.
void expect_same(const TargetIndex& index, ProgramMap& map, const ProgramLine& from,
                 const LinePosition& begin) {
    for (const LineTarget& target :
         {LineTarget{"AA", -1}, LineTarget{"BB", -1}, LineTarget{{}, 1}}) {
        for (const Direction direction :
             {Direction::Both, Direction::Forward, Direction::Backward}) {
            ProgramLine found;
            const bool is_there =
                map.find(target, direction, from, found) == ProgramMap::Fault::None;
            const TargetIndex::Hit* const hit = index.find(target, direction, from, begin);
            ASSERT_EQ(hit != nullptr, is_there) << from.line.line << ' ' << target.label;
            if (hit == nullptr) continue;
            ASSERT_EQ(hit->line, found.line) << from.line.line << ' ' << target.label;
        }
    }
}

/// The index answers as a look through the lines does, from every line and in every direction.
TEST(TargetIndex, FindsWhatAMapFinds) {
    const nc::DialectTables& tables = dialect_named("sinumerik").tables();
    std::mt19937 random(7);
    for (int round = 0; round < 400; ++round) {
        HeldText text(random_text(random));
        SCOPED_TRACE(text.all());
        nc::LineSource source(text, 512);
        TargetIndex index;
        std::vector<ProgramLine> lines;
        std::vector<LinePosition> begins = {{}};
        std::string_view line;
        bool is_too_long = false;
        LinePosition here;
        while (source.next(line, is_too_long)) {
            const LinePosition at = std::exchange(here, {source.offset(), here.line + 1});
            lines.push_back({at, here});
            const nc::LineFront front = nc::front_of(tables, line);
            if (nc::header_of(tables.language.calls, line, true) != nullptr) {
                index.note_head(at);
                begins.push_back(at);
            }
            if (!front.label.empty()) index.add({std::string(front.label), -1}, {at, 0});
            if (front.number >= 0) index.add({{}, front.number}, {at, 0});
        }
        for (const LinePosition& begin : begins) {
            ProgramMap map(tables, source, begin);
            for (const ProgramLine& from : lines)
                if (from.line.offset >= begin.offset) expect_same(index, map, from, begin);
            // Of its own: a map remembers an answer by the line, and the first one is none here.
            ProgramMap from_head(tables, source, begin);
            expect_same(index, from_head, {begin, begin}, begin);
        }
    }
}

std::vector<fs::path> all_files() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(kFolder)) {
        const fs::path file = fs::relative(entry.path(), kFolder);
        const bool is_asked = entry.is_regular_file() && file.has_parent_path() &&
                              file.parent_path().filename() != "called";
        if (is_asked) files.push_back(file);
    }
    std::ranges::sort(files);
    return files;
}

std::string name_of(const ::testing::TestParamInfo<fs::path>& file) {
    std::string name = file.param.parent_path().string() + '_' + file.param.stem().string();
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Files, TextReferences, ::testing::ValuesIn(all_files()), name_of);

}  // namespace
}  // namespace kadr::macro::references_test
