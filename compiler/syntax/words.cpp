#include "syntax/words.h"

#include <charconv>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>

#include "base/diagnostics/syntax.h"
#include "base/text.h"
#include "syntax/parse.h"

namespace kadr::syntax {

namespace {

struct UnitRow {
    std::string_view name;
    std::string_view per;
    Unit unit;
};

constexpr UnitRow kUnits[] = {
    {"mm", "", Unit::Mm},
    {"cm", "", Unit::Cm},
    {"m", "", Unit::M},
    {"um", "", Unit::Um},
    {"µm", "", Unit::Um},
    {"μm", "", Unit::Um},
    {"in", "", Unit::Inch},
    {"deg", "", Unit::Deg},
    {"rad", "", Unit::Rad},
    {"s", "", Unit::S},
    {"ms", "", Unit::Ms},
    {"min", "", Unit::Min},
    {"rpm", "", Unit::Rpm},
    {"mm", "min", Unit::MmPerMin},
    {"m", "min", Unit::MPerMin},
    {"in", "min", Unit::InchPerMin},
    {"mm", "s", Unit::MmPerS},
    {"mm", "rev", Unit::MmPerRev},
    {"in", "rev", Unit::InchPerRev},
};

bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// An identifier as address, digits and the rest: `X`, `10`, `mm`.
struct WordSpelling {
    std::string_view address;
    std::string_view digits;
    std::string_view rest;
};

WordSpelling take_apart(std::string_view identifier) {
    std::size_t i = 0;
    while (i < identifier.size() && is_upper(identifier[i])) ++i;
    std::size_t j = i;
    while (j < identifier.size() && is_digit(identifier[j])) ++j;
    return {identifier.substr(0, i), identifier.substr(i, j - i), identifier.substr(j)};
}

/// `G0` for `GO`: the letters that look like digits are digits behind the address. Empty: there are
/// none, or no address stands before them.
template <typename IsAddress>
std::string with_digits(std::string_view name, const IsAddress& is_address) {
    constexpr std::string_view kLetters = "OolI";
    std::size_t begin = name.size();
    while (begin > 0 &&
           (is_digit(name[begin - 1]) || kLetters.find(name[begin - 1]) != std::string_view::npos))
        --begin;
    if (begin == 0 || !is_address(name.substr(0, begin))) return "";
    std::string word(name);
    for (std::size_t i = begin; i < word.size(); ++i) {
        if (word[i] == 'O' || word[i] == 'o') word[i] = '0';
        if (word[i] == 'l' || word[i] == 'I') word[i] = '1';
    }
    return word == name ? "" : word;
}

/// Whether what stands here was of the kind that was tried, and is in the output.
enum class WordMatch : std::uint8_t { None, Taken };

class Merging {
  public:
    Merging(const SourceFile& file, const std::vector<Lexeme>& in, const WordKindOf& kind_of)
        : file_(file), in_(in), kind_of_(kind_of) {}

    std::vector<Lexeme> run();

  private:
    void number();
    void identifier();
    WordMatch take_comma_word();
    WordMatch take_compact_words(std::string_view identifier);
    void word(Lexeme word, std::string_view number, std::string_view rest);
    WordMatch take_lookalike(const Lexeme& identifier);
    WordMatch take_letter_for_digit(const Lexeme& identifier);
    WordMatch take_lowercase_word(const Lexeme& identifier);
    bool is_lowercase_word(std::size_t i);
    bool is_lowercase_address(std::size_t i);
    std::pair<SourceRange, std::string> upper_block(std::size_t first);
    void finish_word(Lexeme made, const WordSpelling& spelling);
    bool take_unit(Lexeme& number, std::string_view name, std::uint32_t end);
    void report_unknown_unit(std::string_view unit, std::uint32_t end) const;
    bool take_sign_and_number(Lexeme& word, std::string& number);
    void take_fraction(Lexeme& word, std::string& number);
    double value_of(std::string_view spelled, const SourceRange& range);
    nc::WordKind kind_of(std::string_view name);
    bool is_word(std::string_view identifier);
    void bracket(const Lexeme& lexeme);
    void leave_out(std::uint32_t index, bool is_first);

    const Lexeme& at(std::size_t i) const { return in_[i < in_.size() ? i : in_.size() - 1]; }
    bool adjoins(std::size_t i, std::uint32_t end) const { return at(i).begin == end; }
    bool is_start() const {
        if (out_.empty()) return true;
        const Token token = out_.back().token;
        return token == Token::Semicolon || token == Token::OpenBrace || token == Token::CloseBrace;
    }
    /// `/2G1 X5;`: the level of a skipped block takes no unit.
    bool is_skip_level() const {
        if (out_.empty() || out_.back().token != Token::Slash) return false;
        if (out_.size() == 1) return true;
        const Token before = out_[out_.size() - 2].token;
        return before == Token::Semicolon || before == Token::OpenBrace ||
               before == Token::CloseBrace;
    }
    bool is_in_block() const {
        return !out_.empty() &&
               (out_.back().token == Token::LiteralWord || out_.back().token == Token::BareWord);
    }

    const SourceFile& file_;
    const std::vector<Lexeme>& in_;
    const WordKindOf& kind_of_;
    std::vector<Lexeme> out_;
    bool is_lowercase_block_ = false;
    int depth_ = 0;             // of brackets in the statement
    std::vector<int> calls_;    // depths inside the calls of the control that are open
    bool begins_call_ = false;  // the name of one stands in front
    std::size_t i_ = 0;         // the next lexeme to look at
    std::unordered_map<std::string, nc::WordKind> kinds_;
};

std::vector<Lexeme> Merging::run() {
    out_.reserve(in_.size());
    while (i_ < in_.size()) {
        const Lexeme& lexeme = in_[i_];
        if (lexeme.token == Token::Number) {
            number();
        } else if (lexeme.token == Token::Identifier) {
            identifier();
        } else if (lexeme.token == Token::Comma && take_comma_word() == WordMatch::Taken) {
            continue;
        } else {
            if (lexeme.token == Token::Semicolon) is_lowercase_block_ = false;
            bracket(lexeme);
            out_.push_back(lexeme);
            ++i_;
        }
    }
    return std::move(out_);
}

/// `CYCLE81(50,2,,-10)`: where a call of the control leaves an argument out, a token of no width
/// marks it. In the language's own calls that is a mistake.
void Merging::bracket(const Lexeme& lexeme) {
    const bool begins_call = std::exchange(begins_call_, false);
    const bool is_in_call = !calls_.empty() && calls_.back() == depth_;
    switch (lexeme.token) {
        case Token::OpenParen:
        case Token::OpenBracket:
        case Token::OpenBrace:
            ++depth_;
            if (begins_call) calls_.push_back(depth_);
            return;
        case Token::Comma:
            if (is_in_call) leave_out(lexeme.begin, out_.back().token == Token::OpenParen);
            return;
        case Token::CloseParen:
        case Token::CloseBracket:
        case Token::CloseBrace:
            if (is_in_call) {
                leave_out(lexeme.begin, false);
                calls_.pop_back();
            }
            --depth_;
            return;
        case Token::Semicolon:
            depth_ = 0;
            calls_.clear();
            return;
        default: return;
    }
}

void Merging::leave_out(std::uint32_t index, bool is_first) {
    if (!is_first && out_.back().token != Token::Comma) return;
    Lexeme left_out;
    left_out.token = Token::NoArgument;
    left_out.begin = left_out.end = index;
    out_.push_back(left_out);
}

double Merging::value_of(std::string_view spelled, const SourceRange& range) {
    if (!spelled.empty() && spelled.front() == '+') spelled.remove_prefix(1);
    double value = 0;
    std::int64_t whole = 0;
    const char* end = spelled.data() + spelled.size();
    const bool is_whole = spelled.find_first_of(".eE") == std::string_view::npos;
    const bool fits = std::from_chars(spelled.data(), end, value).ec == std::errc() &&
                      (!is_whole || std::from_chars(spelled.data(), end, whole).ec == std::errc());
    if (!fits) {
        file_.sink.report(diag::NumberRange, range).arg(spelled);
        return 0;
    }
    return value;
}

/// `10`, `10.`, `2.5in`, `200mm/min`, `50%`.
void Merging::number() {
    Lexeme lexeme = in_[i_++];
    if (is_skip_level()) {
        lexeme.number = value_of(file_.spelling(lexeme), file_.range(lexeme));
        out_.push_back(lexeme);
        return;
    }
    std::string spelled(file_.spelling(lexeme));
    if (spelled.find_first_of(".eE") == std::string::npos) take_fraction(lexeme, spelled);
    if (at(i_).token == Token::Number && adjoins(i_, lexeme.end)) {
        lexeme.end = at(i_++).end;
        lexeme.is_repair = true;
        file_.sink.report(diag::NumberShape, file_.range(lexeme)).arg(file_.spelling(lexeme));
    } else {
        lexeme.number = value_of(spelled, file_.range(lexeme));
    }
    const Lexeme& next = at(i_);
    if (next.token == Token::Identifier && adjoins(i_, lexeme.end)) {
        const std::string_view name = file_.spelling(next);
        ++i_;
        if (take_unit(lexeme, name, next.end)) {
        } else if (is_word(name)) {
            --i_;  // `X=5Y10`: the next word
        } else {
            lexeme.end = next.end;
            lexeme.is_repair = true;
            report_unknown_unit(name, next.end);
        }
    } else if (next.token == Token::Percent && adjoins(i_, lexeme.end)) {
        const Token after = at(i_ + 1).token;
        if (after == Token::CloseParen || after == Token::Comma || after == Token::Semicolon ||
            after == Token::CloseBracket || after == Token::CloseBrace ||
            after == Token::TextMiddle || after == Token::TextClose) {
            lexeme.unit = Unit::Percent;
            lexeme.end = next.end;
            ++i_;
        }
    }
    out_.push_back(lexeme);
}

/// A point behind a whole number, and digits behind it: `X10` `.5`, `10` `.`.
void Merging::take_fraction(Lexeme& lexeme, std::string& number) {
    const Lexeme& next = at(i_);
    if (!adjoins(i_, lexeme.end)) return;
    const bool is_fraction = next.token == Token::Number && file_.spelling(next).front() == '.';
    if (!is_fraction && next.token != Token::Dot) return;
    number += file_.spelling(next);
    lexeme.end = next.end;
    ++i_;
}

/// The unit `name`, with what stands behind a `/` right after it. True if it is one.
bool Merging::take_unit(Lexeme& number, std::string_view name, std::uint32_t end) {
    const bool has_per = at(i_).token == Token::Slash && adjoins(i_, end) &&
                         at(i_ + 1).token == Token::Identifier && adjoins(i_ + 1, end + 1) &&
                         at(i_ + 2).token != Token::OpenParen;
    if (has_per) {
        const Lexeme& per = at(i_ + 1);
        const Unit unit = find_unit(name, file_.spelling(per));
        if (unit != Unit::None) {
            number.unit = unit;
            number.end = per.end;
            i_ += 2;
            return true;
        }
    }
    const Unit unit = find_unit(name, "");
    if (unit == Unit::None) return false;
    number.unit = unit;
    number.end = end;
    return true;
}

/// `end`: of the unit, in the source.
void Merging::report_unknown_unit(std::string_view unit, std::uint32_t end) const {
    const SourceRange range = file_.range(end - static_cast<std::uint32_t>(unit.size()), end);
    auto message = file_.sink.report(diag::UnknownUnit, range);
    message.arg(unit);
    const std::string digits = with_digits('X' + std::string(unit), [](std::string_view before) {
        return before == "X";  // `1O`: nothing but letters that look like digits
    });
    if (!digits.empty()) message.fix(range, digits.substr(1), "write digits");
    else if (const std::string_view meant = unit_meant(unit); !meant.empty())
        message.fix(range, std::string(meant), "the unit is spelled so");
}

nc::WordKind Merging::kind_of(std::string_view name) {
    if (name.empty() || !is_upper(name.front())) return nc::WordKind::None;
    const auto found = kinds_.find(std::string(name));
    if (found != kinds_.end()) return found->second;
    const nc::WordKind kind = kind_of_(name);
    kinds_.emplace(name, kind);
    return kind;
}

bool Merging::is_word(std::string_view identifier) {
    const nc::WordKind kind = kind_of(identifier);
    if (kind == nc::WordKind::Address || kind == nc::WordKind::Word) return true;
    const WordSpelling s = take_apart(identifier);
    return !s.digits.empty() && kind_of(s.address) == nc::WordKind::Address &&
           (s.rest.empty() || is_upper(s.rest.front()) || find_unit(s.rest, "") != Unit::None);
}

void Merging::identifier() {
    const Lexeme lexeme = in_[i_++];
    const std::string_view name = file_.spelling(lexeme);
    const bool is_member = !out_.empty() && out_.back().token == Token::Dot;
    if (is_member) return out_.push_back(lexeme);
    for (const auto take : {&Merging::take_lookalike, &Merging::take_letter_for_digit,
                            &Merging::take_lowercase_word}) {
        if ((this->*take)(lexeme) == WordMatch::Taken) return;
    }
    const Token next = at(i_).token;
    const nc::WordKind kind = kind_of(name);
    Lexeme made = lexeme;
    if (kind == nc::WordKind::Call) {
        begins_call_ = next == Token::OpenParen;
        out_.push_back(lexeme);
        return;
    }
    if (kind == nc::WordKind::Word && next != Token::OpenParen) {
        made.token = Token::BareWord;
        out_.push_back(made);
        return;
    }
    const WordSpelling s = take_apart(name);
    // `X1=` of `G75` is an address of its own; `X1` by itself is X and a number.
    const bool is_numbered = !s.digits.empty() && s.rest.empty() && next != Token::Assign &&
                             kind_of(s.address) == nc::WordKind::Address;
    if (kind == nc::WordKind::Address && !is_numbered) {
        made.token = Token::Address;
        std::string number;
        if (take_sign_and_number(made, number)) return word(made, number, "");
        out_.push_back(made);
        return;
    }
    if (!s.digits.empty() && kind_of(s.address) == nc::WordKind::Address) {
        if (s.rest.empty() || find_unit(s.rest, "") != Unit::None) {
            made.text = file_.texts.intern(s.address);
            return word(made, s.digits, s.rest);
        }
        if (take_compact_words(name) == WordMatch::Taken) return;
    }
    // `G1 X5. E5.`: the point belongs to the number of a word that the dialect does not have.
    const bool is_foreign = !s.address.empty() && !s.digits.empty() && s.rest.empty();
    if (is_foreign && at(i_).token == Token::Dot && adjoins(i_, lexeme.end) &&
        at(i_ + 1).token != Token::Identifier) {
        made.end = at(i_++).end;
    }
    out_.push_back(made);
}

/// `,C2.` and `,R2.`: addresses that begin with a comma, behind other words.
WordMatch Merging::take_comma_word() {
    const Lexeme& comma = at(i_);
    const Lexeme& next = at(i_ + 1);
    if (depth_ > 0 || !is_in_block() || next.token != Token::Identifier || next.begin != comma.end)
        return WordMatch::None;
    const WordSpelling s = take_apart(file_.spelling(next));
    const std::string address = ',' + std::string(s.address);
    if (s.address.empty() || kind_of_(address) != nc::WordKind::Address) return WordMatch::None;
    Lexeme made = next;
    made.begin = comma.begin;
    made.text = file_.texts.intern(address);
    i_ += 2;
    std::string number(s.digits);
    if (s.digits.empty() && s.rest.empty() && !take_sign_and_number(made, number)) {
        made.token = Token::Address;
        out_.push_back(made);
    } else {
        word(made, number, s.rest);
    }
    return WordMatch::Taken;
}

/// `X` with a number behind it: `X-5.25`, `X+30`, `X.5`, `X -5`.
bool Merging::take_sign_and_number(Lexeme& word, std::string& number) {
    std::size_t i = i_;
    const bool has_sign = at(i).token == Token::Minus || at(i).token == Token::Plus;
    if (has_sign) ++i;
    if (at(i).token != Token::Number || file_.crosses_line(word.end, at(i).begin)) return false;
    if (has_sign && at(i).begin != at(i - 1).end) return false;
    number = has_sign ? std::string(file_.spelling(at(i - 1))) : "";
    number += file_.spelling(at(i));
    word.end = at(i).end;
    i_ = i + 1;
    return true;
}

/// Completes a literal word whose number begins with `number`; `rest` are letters behind it that
/// belong to the same identifier.
void Merging::word(Lexeme word, std::string_view number, std::string_view rest) {
    word.token = Token::LiteralWord;
    std::string spelled(number);
    std::string_view unit = rest;
    std::uint32_t end = word.end;
    if (unit.empty()) {
        if (spelled.find('.') == std::string::npos) take_fraction(word, spelled);
        if (at(i_).token == Token::Number && adjoins(i_, word.end)) {
            word.end = at(i_++).end;
            file_.sink.report(diag::NumberShape, file_.range(word)).arg(file_.spelling(word));
        }
        end = word.end;
        if (at(i_).token == Token::Identifier && adjoins(i_, end) &&
            !is_word(file_.spelling(at(i_)))) {
            unit = file_.spelling(at(i_));
            end = at(i_++).end;
        }
    }
    word.number = value_of(spelled, file_.range(word));
    if (!unit.empty() && !take_unit(word, unit, end)) {
        word.end = end;
        report_unknown_unit(unit, end);
    }
    out_.push_back(word);
}

/// `G0X10Y20`: one-letter addresses with their digits, without blanks. The last one may still wait
/// for its number: `G1X` `-5`.
WordMatch Merging::take_compact_words(std::string_view identifier) {
    std::vector<std::string_view> pieces;
    for (std::string_view left = identifier; !left.empty();) {
        const WordSpelling s = take_apart(left);
        const bool is_last = s.address.size() + s.digits.size() == left.size();
        if (s.address.size() != 1 || kind_of(s.address) != nc::WordKind::Address ||
            (s.digits.empty() && !is_last)) {
            return WordMatch::None;
        }
        pieces.push_back(left.substr(0, s.address.size() + s.digits.size()));
        left = s.rest;
    }
    const Lexeme whole = in_[i_ - 1];
    std::uint32_t begin = whole.begin;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        Lexeme made = whole;
        const std::string_view piece = pieces[i];
        made.begin = begin;
        made.end = begin + static_cast<std::uint32_t>(piece.size());
        begin = made.end;
        if (i + 1 < pieces.size()) {
            made.token = Token::LiteralWord;
            made.text = file_.texts.intern(piece.substr(0, 1));
            made.number = value_of(piece.substr(1), file_.range(made));
            out_.push_back(made);
        } else {
            finish_word(made, take_apart(piece));
        }
    }
    return WordMatch::Taken;
}

/// `М3` with a Cyrillic letter. Only where a word must stand: elsewhere it is a good name.
WordMatch Merging::take_lookalike(const Lexeme& identifier) {
    const std::string_view name = file_.spelling(identifier);
    const std::string latin = latin_skeleton(name);
    if (latin.size() == name.size()) return WordMatch::None;
    const WordSpelling s = take_apart(latin);
    if (kind_of(s.address) != nc::WordKind::Address || !s.rest.empty()) return WordMatch::None;
    const Token next = at(i_).token;
    const bool ends =
        next == Token::Semicolon || next == Token::Identifier || next == Token::Number;
    const bool fits = s.digits.empty()
                          ? is_in_block() && (next == Token::Assign || next == Token::Minus)
                          : ends && (is_start() || is_in_block());
    if (!fits) return WordMatch::None;
    file_.sink.report(diag::LookalikeLetter, file_.range(identifier))
        .arg(name)
        .arg(latin)
        .fix(file_.range(identifier), latin, "use Latin letters");
    finish_word(identifier, s);
    return WordMatch::Taken;
}

/// `GO X5;` with the letter O: no statement begins with a name in front of a word. Behind other
/// words it may be a point.
WordMatch Merging::take_letter_for_digit(const Lexeme& identifier) {
    const Lexeme& next = at(i_);
    const bool is_before_word = is_start() && next.token == Token::Identifier &&
                                is_word(file_.spelling(next)) &&
                                !file_.crosses_line(identifier.end, next.begin);
    if (!is_before_word) return WordMatch::None;
    const std::string_view name = file_.spelling(identifier);
    const std::string word = with_digits(
        name, [&](std::string_view address) { return kind_of(address) == nc::WordKind::Address; });
    if (word.empty()) return WordMatch::None;
    file_.sink.report(diag::LetterForDigit, file_.range(identifier))
        .arg(name)
        .arg(word)
        .fix(file_.range(identifier), word, "write digits");
    finish_word(identifier, take_apart(word));
    return WordMatch::Taken;
}

/// The word that an identifier would be if it were spelled as `spelling`.
void Merging::finish_word(Lexeme made, const WordSpelling& spelling) {
    made.text = file_.texts.intern(spelling.address);
    std::string number(spelling.digits);
    if (!number.empty() || take_sign_and_number(made, number)) return word(made, number, "");
    made.token = Token::Address;
    out_.push_back(made);
}

/// Whether an identifier is a letter and digits that would be a word in upper case.
bool Merging::is_lowercase_word(std::size_t i) {
    if (at(i).token != Token::Identifier) return false;
    const std::string_view name = file_.spelling(at(i));
    if (name.size() < 2 || name[0] < 'a' || name[0] > 'z') return false;
    const bool has_digits = name.find_first_not_of("0123456789", 1) == std::string_view::npos;
    return has_digits && kind_of(upper_ascii(name.substr(0, 1))) == nc::WordKind::Address;
}

/// Whether an identifier is a letter that would be an address in upper case: `z` of `z-1`, `z=d`.
bool Merging::is_lowercase_address(std::size_t i) {
    const std::string_view name = file_.spelling(at(i));
    if (at(i).token != Token::Identifier || name.size() != 1 || is_upper(name[0])) return false;
    const Token next = at(i + 1).token;
    const bool has_value = next == Token::Assign || next == Token::Minus || next == Token::Plus;
    return has_value && kind_of(upper_ascii(name)) == nc::WordKind::Address;
}

/// The words of the block that begins at `first`, up to the last one in lower case, in upper case.
std::pair<SourceRange, std::string> Merging::upper_block(std::size_t first) {
    std::string block;
    std::uint32_t end = at(first).begin;
    const auto append_from = [&](const Lexeme& word) {
        block += file_.text.substr(end, word.begin - end);
        block += upper_ascii(file_.spelling(word));
        end = word.end;
    };
    for (std::size_t i = first; i < in_.size() && at(i).token != Token::Semicolon; ++i) {
        if (file_.crosses_line(at(first).begin, at(i).begin)) break;
        // The value behind `=` has names of variables: `x=z-1`.
        const bool is_value = i > first && at(i - 1).token == Token::Assign;
        if (!is_value && (is_lowercase_word(i) || is_lowercase_address(i))) append_from(at(i));
    }
    return {file_.range(at(first).begin, end), block};
}

/// `g1 x10;` at the start of a statement: nobody means a variable `x10` of type `g1`.
WordMatch Merging::take_lowercase_word(const Lexeme& identifier) {
    const std::size_t own = i_ - 1;
    const std::string upper = upper_ascii(file_.spelling(identifier));
    if (!is_lowercase_block_) {
        // `g1 z=5;` declares a variable of a type `g1`; a sign alone makes it a word.
        const bool is_before_word =
            at(i_).token == Token::Identifier && is_word(file_.spelling(at(i_)));  // `g1 X5;`
        const bool fits =
            is_start() && is_lowercase_word(own) &&
            (at(i_).token == Token::Semicolon || is_lowercase_word(i_) || is_before_word ||
             (is_lowercase_address(i_) && at(i_ + 1).token != Token::Assign));
        if (!fits) return WordMatch::None;
        is_lowercase_block_ = true;
        const auto [range, block] = upper_block(own);
        file_.sink.report(diag::LowercaseWord, file_.range(identifier))
            .arg(upper)
            .fix(range, block, "write it in upper case");
    } else if (!is_lowercase_word(own) && !is_lowercase_address(own)) {
        return WordMatch::None;
    }
    finish_word(identifier, take_apart(upper));
    return WordMatch::Taken;
}

}  // namespace

std::vector<Lexeme> merge_words(const SourceFile& file, const std::vector<Lexeme>& lexemes,
                                const WordKindOf& kind_of) {
    return Merging(file, lexemes, kind_of).run();
}

std::size_t glued_address(const nc::Dialect& dialect, std::string_view name) {
    const std::string_view address = take_apart(name).address;
    const bool goes_on =
        !address.empty() && address.size() < name.size() && !is_digit(name[address.size()]);
    if (!goes_on || nc::word_kind(dialect, address) != nc::WordKind::Address) return 0;
    return address.size();
}

std::string_view unit_meant(std::string_view name) {
    constexpr std::pair<std::string_view, std::string_view> kNames[] = {
        {"sec", "s"},    {"seconds", "s"},   {"minutes", "min"}, {"grd", "deg"},
        {"grad", "deg"}, {"degrees", "deg"}, {"inch", "in"},
    };
    if (find_unit(name, "") != Unit::None) return "";
    std::string lower(name);
    for (char& c : lower) {
        if (is_upper(c)) c = static_cast<char>(c + ('a' - 'A'));
    }
    for (const auto& [other, unit] : kNames) {
        if (other == lower) return unit;
    }
    // Capitals decide between `M` of a program and metres.
    for (const UnitRow& row : kUnits) {
        if (row.per.empty() && row.name.size() > 1 && row.name == lower) return row.name;
    }
    return "";
}

std::string word_with_digits(const nc::Dialect& dialect, std::string_view name) {
    return with_digits(name, [&](std::string_view address) {
        return nc::word_kind(dialect, address) == nc::WordKind::Address;
    });
}

Unit find_unit(std::string_view name, std::string_view per) {
    for (const UnitRow& row : kUnits) {
        if (row.name == name && row.per == per) return row.unit;
    }
    return Unit::None;
}

}  // namespace kadr::syntax
