// lexeme.h — one token of a Kadr source as the parser will see it.
//
// Made by lex.h, merged by words.h, retyped by retype.h, balanced by balance.h; then the parser
// reads the list. For this room only.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/diagnostic.h"
#include "syntax/ast.h"
#include "syntax/token.h"

namespace kadr::syntax {

struct Lexeme {
    Token token = Token::EndOfFile;
    Unit unit = Unit::None;   // of a Number or a LiteralWord
    bool is_repair = false;   // put in, or beside what was left out, after a reported mistake
    std::uint32_t begin = 0;  // bytes in the source
    std::uint32_t end = 0;
    TextId text;        // Identifier and TypeName: the name; words: the address; texts: the
                        // content without quotes and escapes
    double number = 0;  // of a Number or a LiteralWord
};

/// Gives every text of a file one TextId.
class Interner {
  public:
    explicit Interner(std::vector<std::string>& texts) : texts_(texts) {}

    TextId intern(std::string_view text) {
        if (text.empty()) return {};
        const auto found = ids_.find(std::string(text));
        if (found != ids_.end()) return found->second;
        const TextId id{static_cast<std::uint32_t>(texts_.size())};
        texts_.emplace_back(text);
        ids_.emplace(texts_.back(), id);
        return id;
    }
    std::string_view text(TextId id) const { return texts_[id.index]; }

  private:
    std::vector<std::string>& texts_;
    std::unordered_map<std::string, TextId> ids_;
};

/// Where the lines of a text begin, and how far they are indented. Long lines make no difference.
class LineStarts {
  public:
    explicit LineStarts(std::string_view text);

    /// Bytes between the start of the line and the location.
    std::uint32_t indent(std::uint32_t index) const { return index - line(index).start; }
    /// Blanks at the start of the line that holds the location.
    std::uint32_t line_indent(std::uint32_t index) const { return line(index).blanks; }

  private:
    struct Line {
        std::uint32_t start;
        std::uint32_t blanks;
    };
    const Line& line(std::uint32_t index) const;

    std::vector<Line> lines_;
};

/// What the steps from text to tokens share.
struct SourceFile {
    FileId id;
    std::string_view text;  // clean UTF-8 of the same length as the file
    DiagnosticSink& sink;
    Interner& texts;
    const LineStarts& lines;

    SourceRange range(std::uint32_t begin, std::uint32_t end) const { return {id, begin, end}; }
    SourceRange range(const Lexeme& lexeme) const { return {id, lexeme.begin, lexeme.end}; }
    std::string_view spelling(const Lexeme& lexeme) const {
        return text.substr(lexeme.begin, lexeme.end - lexeme.begin);
    }
    /// Whether a line ends between the two locations.
    bool crosses_line(std::uint32_t from, std::uint32_t to) const {
        return to > from && text.substr(from, to - from).find('\n') != std::string_view::npos;
    }
};

}  // namespace kadr::syntax
