// What the checker keeps of a program: tests/sema/checked/*.kadr, each with its questions and
// answers in comments below the lines that they are about (see the README of tests/).
#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "sema/queries.h"
#include "tests/sema/running.h"

namespace kadr::testing::checked_test {
namespace {

namespace fs = std::filesystem;
using sema::Occurrence;

constexpr std::string_view kFolder = KADR_ROOT "/tests/sema/checked";

/// `//      ^ type: length` below a line: what is asked there, and the answer.
struct Question {
    std::uint32_t byte = 0;  // that the caret points to
    std::string what;        // "type"
    std::string answer;
};

struct Subject {
    FileId file{0};
    const Checked& program;
    std::uint32_t byte = 0;
};

std::vector<Question> questions_of(std::string_view text) {
    std::vector<Question> all;
    std::size_t code = 0;  // where the line begins that is asked about
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view line = text.substr(at, end - at);
        const std::size_t caret = line.find('^');
        const std::size_t colon = line.find(": ", caret);
        if (!line.starts_with("//") || caret == std::string_view::npos) {
            code = at;
        } else if (colon != std::string_view::npos) {
            const std::string_view what = line.substr(caret + 2, colon - caret - 2);
            all.push_back({static_cast<std::uint32_t>(code + caret), std::string(what),
                           std::string(line.substr(colon + 2))});
        }
        at = end + 1;
    }
    return all;
}

std::string shown(const Checked& program, const SourceRange& range) {
    const LineColumn at = program.sources->locate(range.file, range.begin);
    const std::string place = std::to_string(at.line) + ':' + std::to_string(at.column);
    const std::string name = fs::path(program.sources->name(range.file)).filename().string();
    return range.file == FileId{0} ? place : name + ':' + place;
}

std::optional<Occurrence> symbol(const Subject& subject) {
    return sema::symbol_at(subject.program.facts, *subject.program.sources, subject.file,
                           subject.byte);
}

std::string type(const Subject& subject) {
    return sema::type_at(subject.program.facts, *subject.program.sources, subject.file,
                         subject.byte);
}

std::string description(const Subject& subject) {
    const auto found = symbol(subject);
    return found ? sema::describe(subject.program.facts, found->symbol) : "";
}

std::string declaration(const Subject& subject) {
    const auto found = symbol(subject);
    if (!found) return "";
    return shown(subject.program, subject.program.facts[found->symbol].range);
}

/// All places of the name; that of the declaration in brackets.
std::string uses(const Subject& subject) {
    const auto found = symbol(subject);
    if (!found) return "";
    std::string all;
    for (const Occurrence& occurrence :
         sema::occurrences_of(subject.program.facts, *subject.program.sources, found->symbol)) {
        const std::string place = shown(subject.program, occurrence.range);
        all += (all.empty() ? "" : " ") + (occurrence.is_declaration ? '[' + place + ']' : place);
    }
    return all;
}

const sema::ExpressionFacts* facts(const Subject& subject) {
    const sema::CheckedFile& file = subject.program.facts.files[0];
    const syntax::ExprId id = sema::expression_at(*file.ast, subject.byte);
    return id.is_valid() ? &file.expressions[id.index] : nullptr;
}

std::string givenness(const Subject& subject) {
    const sema::ExpressionFacts* found = facts(subject);
    if (found == nullptr) return "";
    switch (found->givenness) {
        case sema::Givenness::Given: return "yes";
        case sema::Givenness::Perhaps: return "perhaps";
        case sema::Givenness::NotGiven: return "no";
    }
    return "";
}

std::string constant(const Subject& subject) {
    const sema::ExpressionFacts* found = facts(subject);
    if (found == nullptr || found->constant == sema::ExpressionFacts::kNoConstant) return "";
    const sema::ConstantValue& value = subject.program.facts.constants[found->constant];
    const sema::TypeKind kind = subject.program.facts.types[value.type].kind;
    if (kind == sema::TypeKind::String) return '"' + value.text + '"';
    if (kind != sema::TypeKind::Real) return std::to_string(value.slot.integer);
    std::string number = std::to_string(value.slot.number);
    number.erase(number.find_last_not_of('0') + 1);
    return number;
}

/// The plan of the block at the caret: its motion and the slots that have values.
std::string plan(const Subject& subject) {
    const sema::CheckedFile& file = subject.program.facts.files[0];
    for (std::size_t i = 0; i < file.statements.size(); ++i) {
        const SourceRange& range = file.ast->statements[i].range;
        const std::uint32_t index = file.statements[i].plan;
        const bool is_here = range.begin <= subject.byte && subject.byte < range.end;
        if (!is_here || index == sema::StatementFacts::kNoPlan) continue;
        const sema::Plan& plan = subject.program.facts.plans[index];
        return std::string(nc::info(plan.motion).name) + ", values " +
               std::to_string(plan.fillings.size());
    }
    return "";
}

std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        if (end > at) words.emplace_back(text.substr(at, end - at));
        at = end + 1;
    }
    return words;
}

/// Those of the words that are proposed at the caret, in the order of the question.
std::string proposed(const Subject& subject, std::string_view asked) {
    std::string all;
    const auto proposals = sema::proposals_at(subject.program.facts, *subject.program.sources,
                                              &keywords(), subject.file, subject.byte);
    for (const std::string& word : words_of(asked)) {
        if (std::ranges::find(proposals, word, &sema::Proposal::text) == proposals.end()) continue;
        all += (all.empty() ? "" : " ") + word;
    }
    return all;
}

std::string all_proposed(const Subject& subject) {
    std::string all;
    for (const sema::Proposal& proposal :
         sema::proposals_at(subject.program.facts, *subject.program.sources, &keywords(),
                            subject.file, subject.byte))
        all += (all.empty() ? "" : " ") + proposal.text;
    return all;
}

std::string answer(const Question& question, const Subject& subject) {
    static const std::map<std::string, std::function<std::string(const Subject&)>> kAnswers = {
        {"type", type},
        {"is", description},
        {"declared", declaration},
        {"uses", uses},
        {"given", givenness},
        {"constant", constant},
        {"plan", plan},
        {"proposes only", all_proposed},
    };
    if (question.what == "proposes") return proposed(subject, question.answer);
    if (question.what == "proposes none of")
        return proposed(subject, question.answer).empty() ? question.answer : "some";
    const auto found = kAnswers.find(question.what);
    return found == kAnswers.end() ? "no such question" : found->second(subject);
}

/// `// messages: 3:5 K2001` at the head; `none` is none.
std::string expected_messages(std::string_view text) {
    constexpr std::string_view kHead = "// messages: ";
    const std::size_t at = text.find(kHead);
    if (at == std::string_view::npos) return "none";
    const std::size_t end = text.find('\n', at);
    return std::string(text.substr(at + kHead.size(), end - at - kHead.size()));
}

/// `// dialect: fanuc` at the head: the input dialect.
std::string dialect_of(std::string_view text) {
    constexpr std::string_view kHead = "dialect ";
    const std::size_t at = text.find("\ndialect ");
    if (at == std::string_view::npos) return "iso";
    const std::size_t begin = at + 1 + kHead.size();
    return std::string(text.substr(begin, text.find(';', begin) - begin));
}

std::string messages_of(const Checked& program) {
    std::string all;
    for (const Diagnostic& message : program.messages->all()) {
        all += (all.empty() ? "" : ", ") + shown(program, message.range) + ' ' +
               std::string(message.row->code);
    }
    return all.empty() ? "none" : all;
}

class CheckedFacts : public ::testing::TestWithParam<std::string> {};

TEST_P(CheckedFacts, Answer) {
    const std::string text =
        read_file((fs::path(kFolder) / (GetParam() + ".kadr")).string()).value();
    RunOptions options;
    options.with_stdlib = true;
    options.with_broken_text = true;
    options.source = dialect_of(text);
    const Checked program = check_program(text, options);
    EXPECT_EQ(messages_of(program), expected_messages(text));
    const std::vector<Question> questions = questions_of(text);
    EXPECT_FALSE(questions.empty());
    for (const Question& question : questions) {
        const Subject subject{FileId{0}, program, question.byte};
        const LineColumn at = program.sources->locate(FileId{0}, question.byte);
        EXPECT_EQ(answer(question, subject), question.answer)
            << at.line << ':' << at.column << ' ' << question.what;
    }
}

std::vector<std::string> all_files() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(kFolder)) names.push_back(entry.path().stem());
    std::ranges::sort(names);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Files, CheckedFacts, ::testing::ValuesIn(all_files()),
                         [](const auto& file) { return file.param; });

}  // namespace
}  // namespace kadr::testing::checked_test
