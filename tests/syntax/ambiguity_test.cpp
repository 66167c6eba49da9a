// The grammar is not ambiguous: full prediction with exact detection finds nothing in any program
// of the tree, except the `else` of C.
#include <filesystem>

#include "base/disk_files.h"
#include "base/text.h"
#include "parsing.h"
#include "syntax/complain.h"
#include "syntax/lex.h"
#include "syntax/retype.h"
#include "syntax/words.h"

namespace kadr::syntax::ambiguity_test {
namespace {

class AmbiguityCounter final : public antlr4::BaseErrorListener {
  public:
    void reportAmbiguity(antlr4::Parser*, const antlr4::dfa::DFA&, std::size_t, std::size_t, bool,
                         const antlrcpp::BitSet&, antlr4::atn::ATNConfigSet*) override {
        ++count;
    }
    int count = 0;
};

/// Ambiguities of a text without mistakes; -1 if it has mistakes.
int ambiguities(const std::string& text) {
    LimitedSink limit;
    std::vector<std::string> texts{""};
    std::vector<Comment> comments;
    Interner interner(texts);
    const LineStarts lines(text);
    const SourceFile file{FileId{0}, text, limit, interner, lines};
    const SourceHeader header = scan_header(text);
    const KeywordTable& table = keywords(header.language.empty() ? "en" : header.language);
    const nc::Dialect& words = dialect(header.dialect.empty() ? "iso" : header.dialect);
    const auto raw = lex(file, table, limit, comments);
    if (!raw) return -1;
    const WordKindOf kind_of = [&](std::string_view name) { return nc::word_kind(words, name); };
    const auto prepared = retype(file, merge_words(file, *raw, kind_of), table);
    if (!prepared) return -1;
    LexemeStream stream(prepared->lexemes);
    KadrParser parser(&stream);
    AmbiguityCounter counter;
    parser.removeErrorListeners();
    parser.addErrorListener(&counter);
    parser.getInterpreter<antlr4::atn::ParserATNSimulator>()->setPredictionMode(
        antlr4::atn::PredictionMode::LL_EXACT_AMBIG_DETECTION);
    parser.setErrorHandler(std::make_shared<antlr4::BailErrorStrategy>());
    try {
        parser.file();
    } catch (const antlr4::ParseCancellationException&) {
        return -1;
    }
    return counter.count;
}

TEST(Ambiguity, OnlyTheElseOfC) {
    EXPECT_EQ(ambiguities("cycle a() { if (a) M8; else if (b) M9; else M3; }"), 0);
    EXPECT_EQ(ambiguities("cycle a() { if (a) if (b) M8; else M9; }"), 1);
    EXPECT_EQ(ambiguities("enum e { a, b, } cycle a() { point p = {1, 2,}; G1 {1, 2,} X5; }"), 0);
    EXPECT_EQ(ambiguities("cycle a() { for (int i = 0;;) ; for (int i : l) ; for (i = 0;;) ;"
                          " for (auto i : {1, 2}) ; for (;;) ; for (f(1);;) ; }"),
              0);
    EXPECT_EQ(
        ambiguities("cycle a() { with G91 G17, shift(x: a) F=f { G1 X=a p.q(1)[2] + b Y5; } }"), 0);
}

TEST(Ambiguity, NoneInThePrograms) {
    for (const char* folder : {"stdlib", "examples", "tests/programs"}) {
        const std::filesystem::path root = std::filesystem::path(KADR_ROOT) / folder;
        if (!std::filesystem::exists(root)) continue;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
            if (entry.path().extension() != ".kadr") continue;
            EXPECT_LE(ambiguities(*read_file(entry.path().string())), 0) << entry.path();
        }
    }
}

}  // namespace
}  // namespace kadr::syntax::ambiguity_test
