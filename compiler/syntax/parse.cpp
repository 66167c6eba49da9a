#include "syntax/parse.h"

#include "base/diagnostics/syntax.h"
#include "syntax/brackets.h"
#include "syntax/lex.h"
#include "syntax/prepare.h"
#include "syntax/tree.h"

namespace kadr::syntax {

namespace {

/// SLL prediction first: it is the fast one and almost always enough. Only a file with an error is
/// parsed again with full prediction, to be sure that the error is one, and to report it.
void build_tree(const SourceFile& file, const Prepared& prepared, const nc::Dialect& dialect,
                const LimitedSink& limit, Ast& ast) {
    LexemeStream stream(prepared.lexemes, &limit);
    KadrParser parser(&stream);
    parser.removeErrorListeners();
    auto* interpreter = parser.getInterpreter<antlr4::atn::ParserATNSimulator>();
    interpreter->setPredictionMode(antlr4::atn::PredictionMode::SLL);
    parser.setErrorHandler(std::make_shared<antlr4::BailErrorStrategy>());
    KadrParser::FileContext* tree = nullptr;
    try {
        tree = parser.file();
    } catch (const antlr4::ParseCancellationException&) {
        stream.seek(0);
        parser.reset();
        interpreter->setPredictionMode(antlr4::atn::PredictionMode::LL);
        parser.setErrorHandler(std::make_shared<Complaints>(
            file, stream, limit, dialect, prepared.has_broken_blocks, ast.lost_names));
        try {
            tree = parser.file();
        } catch (const antlr4::ParseCancellationException&) {
            return;  // too many errors, and they are reported
        }
    }
    TreeBuilder(file, ast).build(*tree);
}

/// The steps from text to tree; each may end the work if there is nothing sensible to go on with.
void parse_into(Ast& ast, std::string_view source, const KeywordTable& keywords,
                const nc::Dialect& dialect, LimitedSink& limit) {
    if (source.size() > kMaxBytes) {
        limit.report(diag::FileTooLong, {ast.file, 0, 1});
        return;
    }
    const std::optional<std::string> clean = clean_text(ast.file, source, limit);
    if (!clean) return;
    Interner texts(ast.texts);
    const LineStarts lines(*clean);
    const SourceFile file{ast.file, *clean, limit, texts, lines};
    const auto prepared = prepare(file, keywords, dialect, limit, ast.comments);
    if (prepared && !limit.is_full()) build_tree(file, *prepared, dialect, limit, ast);
}

}  // namespace

Ast parse(const Sources& sources, FileId file, const KeywordTable& keywords,
          const nc::Dialect& dialect, DiagnosticSink& sink, const std::function<bool()>& is_over) {
    Ast ast;
    ast.file = file;
    ast.language = keywords.name;
    for (const auto& [lexeme, name] : keywords.canonical) {
        if (lexeme != name) ast.keyword_words.emplace(name, lexeme);
    }
    LimitedSink limit(is_over);
    parse_into(ast, sources.text(file), keywords, dialect, limit);
    ast.has_errors = limit.has_errors() || limit.is_late();
    limit.deliver(sink);
    return ast;
}

}  // namespace kadr::syntax
