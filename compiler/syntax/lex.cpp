#include "syntax/lex.h"

#include <algorithm>
#include <utility>

#include "base/allow.h"
#include "base/diagnostics/syntax.h"
#include "base/done.h"
#include "base/text.h"
#include "base/unicode.h"
#include "syntax/antlr.h"
#include "syntax/quotes.h"
#include "syntax/strings.h"

namespace kadr::syntax {

namespace {

/// Length of the well-formed UTF-8 character at `at`, 0 if there is none.
std::size_t utf8_length(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
    };
    const auto is_tail = [&](std::size_t i) { return (byte(i) & 0xc0u) == 0x80u; };
    const unsigned first = byte(at);
    if (first < 0x80) return 1;
    if (first >= 0xc2 && first < 0xe0) return is_tail(at + 1) ? 2 : 0;
    if (first >= 0xe0 && first < 0xf0) {
        const bool is_overlong = first == 0xe0 && byte(at + 1) < 0xa0;
        const bool is_surrogate = first == 0xed && byte(at + 1) >= 0xa0;
        return is_tail(at + 1) && is_tail(at + 2) && !is_overlong && !is_surrogate ? 3 : 0;
    }
    if (first >= 0xf0 && first < 0xf5) {
        const bool is_outside =
            (first == 0xf0 && byte(at + 1) < 0x90) || (first == 0xf4 && byte(at + 1) >= 0x90);
        return is_tail(at + 1) && is_tail(at + 2) && is_tail(at + 3) && !is_outside ? 4 : 0;
    }
    return 0;
}

bool is_control(char c) {
    return (c >= 0 && c < 0x20 && c != '\t' && c != '\n' && c != '\r' && c != '\f') || c == 0x7f;
}

std::string hex_byte(char c) {
    constexpr char kDigits[] = "0123456789ABCDEF";
    const auto value = static_cast<unsigned char>(c);
    return {'0', 'x', kDigits[value >> 4], kDigits[value & 15]};
}

/// Byte offsets of code points; cheap when asked for in rising order.
class Cursor {
  public:
    Cursor(std::string_view text, std::uint32_t begin) : text_(text), byte_(begin) {}

    std::uint32_t byte_of(std::size_t point) {
        while (point_ < point && byte_ < text_.size()) {
            ++byte_;
            while (byte_ < text_.size() && (text_[byte_] & 0xc0) == 0x80) ++byte_;
            ++point_;
        }
        return byte_;
    }
    /// The code point that begins at this byte.
    std::size_t point_of(std::uint32_t byte) {
        while (byte_ < byte) byte_of(point_ + 1);
        for (; byte_ > byte; --byte_) {
            if ((text_[byte_ - 1] & 0xc0) != 0x80) --point_;
        }
        return point_;
    }

  private:
    std::string_view text_;
    std::uint32_t byte_;
    std::size_t point_ = 0;
};

class Lexing {
  public:
    Lexing(const SourceFile& file, const KeywordTable& keywords, const LimitedSink& limit,
           std::vector<Comment>& comments)
        : file_(file), keywords_(keywords), limit_(limit), comments_(comments) {}

    Done run(std::uint32_t begin, std::uint32_t end);
    std::vector<Lexeme> take() { return std::move(out_); }
    /// Whether something that is not closed swallowed the rest of the file.
    bool is_cut() const { return is_cut_; }

  private:
    struct Reading {
        KadrLexer& lexer;
        antlr4::ANTLRInputStream& input;
        Cursor& cursor;
        std::uint32_t end;

        void go_on_at(std::uint32_t byte) {
            lexer.hitEOF = false;
            input.seek(cursor.point_of(byte));
        }
    };
    void take_token(Token token, std::uint32_t begin, std::uint32_t end, Reading& reading);
    void comment(std::uint32_t begin, std::uint32_t end);
    void include(std::uint32_t begin, std::uint32_t end, Reading& reading);
    Done require_no_inch_sign(std::uint32_t at);
    void text(Token token, std::uint32_t begin, std::uint32_t end, Reading& reading);
    void raw_text(std::uint32_t begin, Reading& reading);
    void unknown(std::uint32_t begin, std::uint32_t end, Reading& reading);
    Done require_no_control_variable(std::uint32_t begin, std::uint32_t end, Reading& reading);
    Done require_no_system_variable(std::uint32_t begin, std::uint32_t end, Reading& reading);
    Done require_no_directive(std::uint32_t begin, std::uint32_t end, Reading& reading);
    bool is_raw(const Lexeme& lexeme) const;
    void push(Token token, std::uint32_t begin, std::uint32_t end, TextId content = {});

    const SourceFile& file_;
    const KeywordTable& keywords_;
    const LimitedSink& limit_;
    std::vector<Comment>& comments_;
    std::vector<Lexeme> out_;
    bool is_cut_ = false;
    bool is_beside_unknown_ = false;
    std::uint32_t unknown_end_ = UINT32_MAX;  // of the last unknown character
};

Done Lexing::run(std::uint32_t begin, std::uint32_t end) {
    antlr4::ANTLRInputStream input(std::string(file_.text.substr(begin, end - begin)));
    KadrLexer lexer(&input);
    lexer.removeErrorListeners();
    Cursor cursor(file_.text, begin);
    Reading reading{lexer, input, cursor, end};
    while (true) {
        const std::unique_ptr<antlr4::Token> token = lexer.nextToken();
        if (token->getType() == antlr4::Token::EOF) return kDone;
        if (limit_.is_full()) return kFailed;
        if (out_.size() % kSlice == kSlice - 1 && limit_.is_late()) return kFailed;
        if (out_.size() >= kMaxLexemes) {
            const std::uint32_t index = cursor.byte_of(token->getStartIndex());
            file_.sink.report(diag::FileTooLong, file_.range(index, index + 1));
            return kFailed;
        }
        const std::uint32_t first = cursor.byte_of(token->getStartIndex());
        const std::uint32_t last = cursor.byte_of(token->getStopIndex() + 1);
        take_token(token_of(token->getType()), first, last, reading);
    }
}

void Lexing::take_token(Token token, std::uint32_t begin, std::uint32_t end, Reading& reading) {
    switch (token) {
        case Token::LineComment:
        case Token::BlockComment: return comment(begin, end);
        case Token::CommentUnclosed:
            file_.sink.report(diag::CommentNotClosed, file_.range(begin, end));
            comment(begin, reading.end);
            reading.input.seek(reading.input.size());
            is_cut_ = true;
            return;
        case Token::Text:
        case Token::TextUnclosed:
        case Token::TextWrongQuotes: return text(token, begin, end, reading);
        case Token::Unknown: return unknown(begin, end, reading);
        case Token::OpenBrace:
            if (!out_.empty() && is_raw(out_.back())) return raw_text(begin, reading);
            return push(token, begin, end);
        case Token::Include: return include(begin, end, reading);
        case Token::Identifier:
            return push(token, begin, end,
                        file_.texts.intern(composed(file_.text.substr(begin, end - begin))));
        default: return push(token, begin, end);
    }
}

void Lexing::comment(std::uint32_t begin, std::uint32_t end) {
    const std::string_view spelled = file_.text.substr(begin, end - begin);
    comments_.push_back({file_.range(begin, end), spelled.starts_with("///")});
    if (!spelled.starts_with("//")) return;
    const Allowance allowance = allowed_codes(spelled.substr(2));
    if (!allowance.is_one) return;
    if (!allowance.is_well_formed) {
        file_.sink.report(diag::AllowShape, file_.range(begin, end));
        return;
    }
    for (const std::string_view code : allowance.codes) {
        const DiagnosticRow* row = find_diagnostic(code);
        if (row != nullptr && row->severity == Severity::Warning) continue;
        const auto at = begin + static_cast<std::uint32_t>(code.data() - spelled.data());
        file_.sink.report(diag::AllowCode, file_.range(at, at + 5)).arg(code);
    }
}

/// `#include "holes.kadr"` or `<cycles/drilling.kadr>`; behind it the line goes on.
void Lexing::include(std::uint32_t begin, std::uint32_t end, Reading& reading) {
    const std::string_view line = file_.text.substr(begin, end - begin);
    const std::size_t word = line.find("include") + std::string_view("include").size();
    const std::size_t open = line.find_first_not_of(" \t", word);
    const bool is_quoted =
        open != std::string_view::npos && (line[open] == '"' || line[open] == '<');
    const std::size_t close =
        is_quoted ? line.find(line[open] == '"' ? '"' : '>', open + 1) : std::string_view::npos;
    if (close == std::string_view::npos) {
        file_.sink.report(diag::IncludeWord, file_.range(begin, end))
            .fix("the name of the file stands in quotes: `#include \"holes.kadr\"`");
        return;
    }
    const std::uint32_t past = begin + static_cast<std::uint32_t>(close) + 1;
    push(Token::Include, begin, past, file_.texts.intern(line.substr(open + 1, close - open - 1)));
    reading.go_on_at(past);
}

/// `5"`: the sign of inches right behind a number. What begins there is no text.
Done Lexing::require_no_inch_sign(std::uint32_t at) {
    if (out_.empty()) return kDone;
    Lexeme& number = out_.back();
    // `X5` is put together later.
    const bool is_word = number.token == Token::Identifier && file_.text[at - 1] >= '0' &&
                         file_.text[at - 1] <= '9' && file_.text[number.begin] >= 'A' &&
                         file_.text[number.begin] <= 'Z';
    const bool is_number = number.token == Token::Number && number.unit == Unit::None;
    if ((!is_number && !is_word) || number.end != at || file_.text[at] != '"') return kDone;
    std::uint32_t begin = number.begin;  // of `X5.5` it is that of `.5`
    if (out_.size() > 1 && out_[out_.size() - 2].end == begin && file_.text[begin] == '.')
        begin = out_[out_.size() - 2].begin;
    file_.sink.report(diag::Unexpected, file_.range(at, at + 1))
        .arg("`\"`")
        .arg('`' + std::string(file_.text.substr(begin, at - begin)) + '`')
        .fix(file_.range(at, at + 1), "in", "inches are `in`");
    if (is_number) number.unit = Unit::Inch;
    return kFailed;
}

void Lexing::text(Token token, std::uint32_t begin, std::uint32_t end, Reading& reading) {
    const auto lex_piece = [this](std::uint32_t from, std::uint32_t to) {
        (void)run(from, to);  // what was lexed until a limit is there
    };
    if (!require_no_inch_sign(begin)) return reading.go_on_at(begin + 1);
    if (token == Token::TextWrongQuotes) {
        // The quotes are one character each, of one to three bytes.
        std::uint32_t first = begin + 1;
        std::uint32_t last = end - 1;
        while ((file_.text[first] & 0xc0) == 0x80) ++first;
        while ((file_.text[last] & 0xc0) == 0x80) --last;
        const std::string_view content = file_.text.substr(first, last - first);
        file_.sink.report(diag::WrongQuotes, file_.range(begin, end))
            .fix(file_.range(begin, end), "\"" + std::string(content) + "\"",
                 "use straight double quotes");
        return push(Token::Text, begin, end, file_.texts.intern(content));
    }
    if (token == Token::TextUnclosed) {
        // What closes the statement was hardly meant as text.
        const std::string_view spelled = file_.text.substr(begin, end - begin);
        const std::size_t last = spelled.find_last_not_of(" \t;)}");
        end = begin + static_cast<std::uint32_t>(last) + 1;
        file_.sink.report(diag::TextNotClosed, file_.range(begin, end))
            .fix(file_.range(end, end), "\"", "close it");
        split_text(file_, begin, end, false, lex_piece, out_);
        reading.go_on_at(end);
        return;
    }
    // Quotes in the braces of a text do not end it. Only so far is looked: what does not close must
    // not cost the square of its length.
    constexpr std::uint32_t kLook = 2000;
    const std::uint32_t whole =
        end_of_text(file_.text, begin, begin + std::min(kLook, reading.end - begin));
    if (whole > end) {
        end = whole;
        reading.go_on_at(end);
    }
    split_text(file_, begin, end, true, lex_piece, out_);
}

void Lexing::raw_text(std::uint32_t begin, Reading& reading) {
    int depth = 0;
    std::uint32_t end = begin;
    do {
        if (file_.text[end] == '{') ++depth;
        if (file_.text[end] == '}') --depth;
        ++end;
    } while (depth > 0 && end < reading.end);
    if (depth > 0) {
        file_.sink.report(diag::RawNotClosed, file_.range(begin, begin + 1));
        reading.input.seek(reading.input.size());
        is_cut_ = true;
        return push(Token::RawText, begin, end);
    }
    push(Token::RawText, begin, end,
         file_.texts.intern(raw_lines(file_.text.substr(begin + 1, end - begin - 2))));
    reading.go_on_at(end);
}

/// The sign that a typeset one stands for; empty if there is none.
static const char* sign_of_keyboard(std::string_view typeset) {
    constexpr std::pair<std::string_view, const char*> kSigns[] = {
        {"−", "-"}, {"–", "-"},  {"—", "-"},  {"×", "*"},  {"·", "*"},   {"÷", "/"},
        {"∕", "/"}, {"≤", "<="}, {"≥", ">="}, {"≠", "!="}, {"°", "deg"},
    };
    for (const auto& [sign, key] : kSigns) {
        if (sign == typeset) return key;
    }
    return "";
}

/// `#define N 3` and its like: the line is left out.
Done Lexing::require_no_directive(std::uint32_t begin, std::uint32_t end, Reading& reading) {
    const std::size_t line_end = std::min(file_.text.find('\n', end), file_.text.size());
    const std::string_view line = file_.text.substr(end, line_end - end);
    constexpr std::string_view kWords[] = {"define", "undef", "ifdef", "ifndef", "if",     "elif",
                                           "else",   "endif", "error", "pragma", "warning"};
    const std::size_t size =
        std::min(line.find_first_not_of("abcdefghijklmnopqrstuvwxyz"), line.size());
    const std::string_view word = line.substr(0, size);
    if (std::ranges::find(kWords, word) == std::end(kWords)) return kDone;
    file_.sink.report(diag::HashSign, file_.range(begin, end + static_cast<std::uint32_t>(size)))
        .fix(word == "define"   ? "a constant is `const int n = 3;`, what has parameters a function"
             : word == "pragma" ? "leave it out: a file is imported once"
                                : "there is no preprocessor: `if` decides when the program runs");
    reading.go_on_at(static_cast<std::uint32_t>(line_end));
    return kFailed;
}

/// `#1`, a variable of a control: the number is part of it.
Done Lexing::require_no_control_variable(std::uint32_t begin, std::uint32_t end, Reading& reading) {
    std::uint32_t past = end;
    while (past < reading.end && file_.text[past] >= '0' && file_.text[past] <= '9') ++past;
    if (past == end) return kDone;
    const std::string number(file_.text.substr(end, past - end));
    file_.sink.report(diag::HashSign, file_.range(begin, past))
        .fix("a variable is declared with its type and a name in small letters: `real v" + number +
             " = 0;`, `length depth = 5mm;`");
    reading.go_on_at(past);
    unknown_end_ = past;
    return kFailed;
}

/// `$AA_IM[X]`, a variable of a control: its name and its index are part of it.
Done Lexing::require_no_system_variable(std::uint32_t begin, std::uint32_t end, Reading& reading) {
    constexpr std::string_view kName = "ABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789";
    std::size_t past = std::min(file_.text.find_first_not_of(kName, end), file_.text.size());
    if (past == end) return kDone;
    if (past < reading.end && file_.text[past] == '[') {
        const std::size_t close = file_.text.find_first_of("]\n", past);
        if (close < reading.end && file_.text[close] == ']') past = close + 1;
    }
    const auto last = static_cast<std::uint32_t>(past);
    file_.sink.report(diag::UnknownCharacter, file_.range(begin, last))
        .arg(file_.text.substr(begin, 1))
        .fix(
            "variables of a control are not read here: a program knows `position.x` and "
            "`state.tool`, and `raw` passes any text");
    reading.go_on_at(last);
    unknown_end_ = last;
    return kFailed;
}

void Lexing::unknown(std::uint32_t begin, std::uint32_t end, Reading& reading) {
    // A run of them is one mistake.
    const bool continues = begin == unknown_end_;
    unknown_end_ = end;
    is_beside_unknown_ = true;
    if (continues) return;
    const std::string_view spelled = file_.text.substr(begin, end - begin);
    if (spelled == "#") {
        if (!require_no_directive(begin, end, reading)) return;
        if (!require_no_control_variable(begin, end, reading)) return;
        file_.sink.report(diag::HashSign, file_.range(begin, end));
    } else {
        if (spelled == "$" && !require_no_system_variable(begin, end, reading)) return;
        auto report = file_.sink.report(diag::UnknownCharacter, file_.range(begin, end));
        report.arg(spelled);
        const char* meant = sign_of_keyboard(spelled);
        if (*meant != '\0')
            report.fix(file_.range(begin, end), meant,
                       spelled == "°" ? "an angle wears its unit" : "the sign of the keyboard");
    }
}

bool Lexing::is_raw(const Lexeme& lexeme) const {
    if (lexeme.token != Token::Identifier) return false;
    const auto found = keywords_.canonical.find(std::string(file_.texts.text(lexeme.text)));
    return found != keywords_.canonical.end() && found->second == "raw";
}

void Lexing::push(Token token, std::uint32_t begin, std::uint32_t end, TextId content) {
    Lexeme lexeme;
    lexeme.token = token;
    lexeme.begin = begin;
    lexeme.end = end;
    lexeme.text = content;
    lexeme.is_repair = std::exchange(is_beside_unknown_, false);
    out_.push_back(lexeme);
}

}  // namespace

std::optional<std::string> clean_text(FileId file, std::string_view text, DiagnosticSink& sink) {
    std::string clean(text);
    std::size_t bad_runs = 0;
    std::size_t bad_end = std::string_view::npos;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = utf8_length(text, i);
        if (length > 0 && !is_control(text[i])) {
            i += length;
            continue;
        }
        clean[i] = ' ';
        if (i != bad_end) {
            const SourceRange location{file, static_cast<std::uint32_t>(i),
                                       static_cast<std::uint32_t>(i + 1)};
            if (++bad_runs > kMaxBadBytes) {
                sink.report(diag::FileNotText, location);
                return std::nullopt;
            }
            sink.report(diag::ByteNotText, location).arg(hex_byte(text[i]));
        }
        bad_end = ++i;
    }
    return clean;
}

std::optional<std::vector<Lexeme>> lex(const SourceFile& file, const KeywordTable& keywords,
                                       const LimitedSink& limit, std::vector<Comment>& comments) {
    Lexing lexing(file, keywords, limit, comments);
    const auto size = static_cast<std::uint32_t>(file.text.size());
    if (!lexing.run(0, size)) return std::nullopt;
    std::vector<Lexeme> lexemes = lexing.take();
    Lexeme last;
    last.begin = last.end = size;
    last.is_repair = lexing.is_cut();  // what is missing at the end is reported already
    lexemes.push_back(last);
    return lexemes;
}

}  // namespace kadr::syntax
