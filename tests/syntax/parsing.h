// parsing.h — a text parsed with the shipped dialects and keyword languages, for the tests.
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/render.h"
#include "syntax/parse.h"
#include "syntax/print.h"

namespace kadr::syntax {

inline const std::vector<std::string> kLanguages = {KADR_ROOT "/dialects/languages"};

/// A dialect file is loaded once for all tests.
inline const nc::Dialect& dialect(const std::string& name) {
    static std::map<std::string, nc::Dialect> loaded;
    const auto found = loaded.find(name);
    if (found != loaded.end()) return found->second;
    Sources sources;
    DiagnosticList list;
    auto made = nc::load_dialect(name, {KADR_ROOT "/dialects"}, sources, list);
    for (const Diagnostic& diagnostic : list.all())
        ADD_FAILURE() << render_text(diagnostic, sources);
    return loaded.emplace(name, std::move(*made)).first->second;
}

inline const KeywordTable& keywords(const std::string& name) {
    static std::map<std::string, KeywordTable> loaded;
    const auto found = loaded.find(name);
    if (found != loaded.end()) return found->second;
    Sources sources;
    DiagnosticList list;
    auto made = load_keywords(name, kLanguages, sources, list);
    for (const Diagnostic& diagnostic : list.all())
        ADD_FAILURE() << render_text(diagnostic, sources);
    return loaded.emplace(name, std::move(*made)).first->second;
}

struct Parsed {
    Sources sources;
    DiagnosticList list;
    Ast ast;

    explicit Parsed(std::string text) {
        const FileId file = sources.add("part.kadr", std::move(text));
        const SourceHeader header = scan_header(sources.text(file));
        ast = parse(sources, file, keywords(header.language.empty() ? "en" : header.language),
                    dialect(header.dialect.empty() ? "iso" : header.dialect), list);
    }

    /// Every message as `line:column code text`, one a line.
    std::string messages() const {
        std::string out;
        for (const Diagnostic& diagnostic : list.all()) {
            const LineColumn place = sources.locate(diagnostic.range.file, diagnostic.range.begin);
            if (!out.empty()) out += '\n';
            out += std::to_string(place.line) + ':' + std::to_string(place.column) + ' ' +
                   std::string(diagnostic.row->code) + ' ' + diagnostic.message();
        }
        return out;
    }
};

/// The dump of a text that has no mistake.
inline std::string parsed(const std::string& text) {
    const Parsed result(text);
    EXPECT_EQ(result.messages(), "") << text;
    return dump(result.ast);
}

/// The dump of statements, as if they stood in a cycle; one a line.
inline std::string statements(const std::string& text) {
    constexpr std::string_view kHead = "(cycle test\n";
    std::string whole = parsed("cycle test() {\n" + text + "\n}");
    if (!whole.starts_with(kHead)) return whole;
    whole = whole.substr(kHead.size(), whole.size() - kHead.size() - 1);
    // Two blanks of indentation less in every line.
    std::string out;
    for (std::size_t begin = 0; begin < whole.size();) {
        const std::size_t end = std::min(whole.find('\n', begin), whole.size());
        out += whole.substr(begin + 2, end - begin - 2);
        if (end < whole.size()) out += '\n';
        begin = end + 1;
    }
    return out;
}

/// The dump of one expression.
inline std::string expression(const std::string& text) {
    const std::string statement = statements("v = " + text + ";");
    constexpr std::string_view kHead = "(do (= v ";
    if (!statement.starts_with(kHead)) return statement;
    return statement.substr(kHead.size(), statement.size() - kHead.size() - 2);
}

/// A row of a table: what is written and what it is read as.
struct Row {
    const char* text;
    const char* expected;
};

/// Every text of the table has exactly the messages beside it.
inline void expect_messages(const std::vector<Row>& rows) {
    for (const Row& row : rows) EXPECT_EQ(Parsed(row.text).messages(), row.expected) << row.text;
}

}  // namespace kadr::syntax
