#include "syntax/prepare.h"

#include "syntax/foreign_statements.h"
#include "syntax/lex.h"
#include "syntax/words.h"

namespace kadr::syntax {

std::optional<Prepared> prepare(const SourceFile& file, const KeywordTable& keywords,
                                const nc::Dialect& dialect, const LimitedSink& limit,
                                std::vector<Comment>& comments) {
    const auto raw = lex(file, keywords, limit, comments);
    if (!raw) return std::nullopt;
    const WordKindOf kind_of = [&dialect](std::string_view identifier) {
        return nc::word_kind(dialect, identifier);
    };
    std::vector<Lexeme> words = merge_words(file, *raw, kind_of);
    return retype(file, mend_statements(file, std::move(words), keywords), keywords);
}

}  // namespace kadr::syntax
