#include "syntax/pieces.h"

#include <algorithm>

namespace kadr::syntax {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f'; }

/// The text without carriage returns, and without blanks at the ends of its lines.
std::string trimmed_lines(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '\n') {
            while (!out.empty() && is_blank(out.back()) && out.back() != '\n') out.pop_back();
        }
        if (c != '\r') out += c;
    }
    while (!out.empty() && is_blank(out.back())) out.pop_back();
    return out;
}

class Gathering {
  public:
    Gathering(const SourceFile& file, const std::vector<Lexeme>& lexemes,
              const std::vector<Comment>& comments)
        : file_(file), lexemes_(lexemes), comments_(comments) {}

    std::vector<LayoutPiece> run();

  private:
    void add(Token token, std::uint32_t begin, std::uint32_t end);
    void add_comments(std::uint32_t before);
    std::string spelling(Token token, std::uint32_t begin, std::uint32_t end) const;

    const SourceFile& file_;
    const std::vector<Lexeme>& lexemes_;
    const std::vector<Comment>& comments_;
    std::vector<LayoutPiece> out_;
    std::uint32_t last_end_ = 0;
    std::size_t next_comment_ = 0;
};

std::vector<LayoutPiece> Gathering::run() {
    for (std::size_t i = 0; i < lexemes_.size(); ++i) {
        const Lexeme& first = lexemes_[i];
        add_comments(first.begin);
        std::uint32_t end = first.end;
        if (first.token == Token::TextOpen) {
            for (int depth = 1; depth > 0;) {  // a text may stand inside of a text
                const Lexeme& next = lexemes_[++i];
                if (next.token == Token::TextOpen) ++depth;
                if (next.token == Token::TextClose) --depth;
                end = next.end;
            }
        }
        // What stands inside of a piece goes with it.
        while (next_comment_ < comments_.size() && comments_[next_comment_].range.begin < end) {
            ++next_comment_;
        }
        add(first.token, first.begin, end);
    }
    return std::move(out_);
}

void Gathering::add_comments(std::uint32_t before) {
    for (; next_comment_ < comments_.size(); ++next_comment_) {
        const SourceRange& range = comments_[next_comment_].range;
        if (range.begin >= before) return;
        const bool is_line = file_.text.substr(range.begin, 2) == "//";
        add(is_line ? Token::LineComment : Token::BlockComment, range.begin, range.end);
    }
}

void Gathering::add(Token token, std::uint32_t begin, std::uint32_t end) {
    const std::string_view between = file_.text.substr(last_end_, begin - last_end_);
    const auto breaks = std::count(between.begin(), between.end(), '\n');
    LayoutPiece piece;
    piece.token = token;
    piece.text = spelling(token, begin, end);
    piece.starts_line = breaks > 0 || last_end_ == 0;
    piece.follows_blank = breaks > 1;
    out_.push_back(std::move(piece));
    last_end_ = end;
}

std::string Gathering::spelling(Token token, std::uint32_t begin, std::uint32_t end) const {
    const std::string_view text = file_.text.substr(begin, end - begin);
    switch (token) {
        case Token::LineComment:
        case Token::BlockComment: return trimmed_lines(text);
        case Token::Number:
        case Token::LiteralWord:
        case Token::BareWord:
        case Token::RawText: break;
        default: return std::string(text);
    }
    std::string out(text);
    if (token == Token::RawText) {
        std::erase(out, '\r');  // of the line ends, as everywhere
        return out;
    }
    if (out.find("/*") == std::string::npos && out.find("//") == std::string::npos) {
        std::erase_if(out, is_blank);
    }
    return out;
}

}  // namespace

std::vector<LayoutPiece> pieces_of(const SourceFile& file, const std::vector<Lexeme>& lexemes,
                                   const std::vector<Comment>& comments) {
    return Gathering(file, lexemes, comments).run();
}

}  // namespace kadr::syntax
