// What a line is, for someone who looks for a target or for the end of a structure.
#include <algorithm>

#include "nc/control_line.h"
#include "nc/control_words.h"
#include "nc/letters.h"
#include "nc/loop_front.h"
#include "nc/without_blanks.h"

namespace kadr::nc {

namespace {

class Front {
  public:
    Front(const DialectTables& tables, std::string_view line)
        : tables_(tables), language_(tables.language), words_(tables, line), line_(line) {}

    LineFront look() {
        std::size_t at = words_.skip_blanks(0);
        if (at < line_.size() && line_[at] == '/') {
            ++at;
            while (at < line_.size() && is_digit(line_[at])) ++at;
            at = words_.skip_blanks(at);
        }
        at = take_front_signs(at);
        at = take_number(at);
        at = take_label(at);
        if (!language_.label_quote.empty()) at = take_number(take_front_signs(at));
        front_.is_empty = says_nothing_from(at);
        if (!front_.is_empty) find_statement(words_.skip_comments(at));
        return front_;
    }

  private:
    /// `N120`, `:10`
    std::size_t take_number(std::size_t at) {
        if (at >= line_.size()) return at;
        const std::string letter = words_.normal(line_.substr(at, 1));
        const AddressId address = tables_.find_address(letter);
        const bool is_number =
            (address != kNoAddress && tables_.addresses[address].is_block_number) ||
            (!language_.label_sign.empty() && letter == language_.label_sign);
        if (!is_number) return at;
        std::size_t end = at + 1;
        if (words_.is_blank_insensitive()) end = words_.skip_blanks(end);
        std::int64_t number = 0;
        const std::size_t first = end;
        for (; end < line_.size() && is_digit(line_[end]) && number < 1'000'000'000; ++end)
            number = number * 10 + (line_[end] - '0');
        if (end == first) return at;
        front_.number = number;
        front_.number_span = {static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(end)};
        return words_.skip_blanks(end);
    }

    /// `#G0 X5`: signs that mean nothing here.
    std::size_t take_front_signs(std::size_t at) const {
        const std::string& signs = tables_.notation.front_signs;
        while (at < line_.size() && signs.find(line_[at]) != std::string::npos)
            at = words_.skip_blanks(at + 1);
        return at;
    }

    /// `"LAB"`
    std::size_t take_quoted_label(std::size_t at) {
        const std::string& quote = language_.label_quote;
        if (!line_.substr(std::min(at, line_.size())).starts_with(quote)) return at;
        const std::size_t first = at + quote.size();
        const std::size_t end = line_.find(quote, first);
        if (end == std::string_view::npos || end == first) return at;
        front_.label = line_.substr(first, end - first);
        return words_.skip_blanks(end + quote.size());
    }

    std::size_t take_label(std::size_t at) {
        if (!language_.label_quote.empty()) return take_quoted_label(at);
        if (language_.label_sign.empty()) return at;
        const LetterRun word = words_.word_at(at);
        if (word.text.size() < 2) return at;
        const std::size_t end = words_.skip_blanks(at + word.text.size());
        if (!line_.substr(std::min(end, line_.size())).starts_with(language_.label_sign)) return at;
        front_.label = word.text;
        return words_.skip_blanks(end + language_.label_sign.size());
    }

    void find_statement(std::size_t at) {
        const StatementForm* found = nullptr;
        for (const StatementForm& form : language_.statements) {
            const LetterRun word = word_behind(form, at);
            if (begins_with_loop(form)) {
                const std::optional<int> loop = loop_in_front(words_, line_, form, at);
                if (!loop) continue;
                front_.statement = form.statement;
                front_.closes = form.closes;
                front_.loop = *loop;
                return;
            }
            if (word.text.size() < 2 && !language_.has_label_numbers) continue;
            if (!words_.matches_with_digits(word, form.tokens[0].text)) continue;
            if (form.statement == Statement::Label && take_label_of(form, at)) return;
            const std::size_t behind = word.begin + word.text.size();
            if (found == nullptr || !is_likely(*found, behind)) found = &form;
        }
        if (found == nullptr) return;
        front_.statement = found->statement;
        front_.closes = found->closes;
        const bool has_loop = std::ranges::any_of(found->tokens, [](const StatementToken& token) {
            return token.kind == StatementToken::Kind::Hole &&
                   token.hole == StatementToken::Hole::Loop;
        });
        if (has_loop) front_.loop = number_at_end(at);
    }

    /// The first keyword of a statement, behind the signs in front of it.
    LetterRun word_behind(const StatementForm& form, std::size_t at) const {
        if (form.front.empty()) return words_.word_at(at);
        const auto behind = behind_front(words_, line_, form, at);
        return behind ? words_.word_at(*behind) : LetterRun{at, {}};
    }

    /// `G98 L{from}`, `O{from} SUB`: the words of the pattern and the label among them. A statement
    /// that begins with the same word is told from the label by a word behind it, `O{from} CALL`,
    /// or by more behind it than a label has, `SUB {from},{count}`.
    bool take_label_of(const StatementForm& form, std::size_t at) {
        std::string_view label;
        for (const StatementToken& token : form.tokens) {
            at = words_.skip_blanks(at);
            if (token.kind == StatementToken::Kind::Hole) {
                label = label_at(line_, at);
                if (label.empty()) return false;
                at = behind_label(label);
                continue;
            }
            const LetterRun word = words_.word_at(at);
            if (!words_.matches_with_digits(word, token.text)) return false;
            at += words_.length_of(word, token.text);
        }
        if (label.empty() || (has_rival(form) && !says_nothing_from(at))) return false;
        front_.label = label;
        front_.statement = Statement::Label;
        return true;
    }

    std::size_t behind_label(std::string_view label) const {
        const auto end = static_cast<std::size_t>(label.data() - line_.data()) + label.size();
        const bool is_quoted = end < line_.size() && line_[end] == '"';
        return end + (is_quoted ? 1 : 0);
    }

    bool has_rival(const StatementForm& label) const {
        return std::ranges::any_of(language_.statements, [&](const StatementForm& other) {
            return other.statement != Statement::Label &&
                   other.tokens[0].text == label.tokens[0].text;
        });
    }

    /// Whether comments and the sign of the block's end are all that follows.
    bool says_nothing_from(std::size_t at) const {
        at = words_.skip_comments(at);
        if (at < line_.size() && line_[at] == tables_.notation.end_sign)
            at = words_.skip_comments(at + 1);
        return at >= line_.size() || words_.is_comment(at);
    }

    /// Of several statements with one keyword: a form is what stands there if its further keywords
    /// stand in the line, and if something follows where it wants something.
    bool is_likely(const StatementForm& form, std::size_t at) const {
        if (form.tokens.size() == 1) return is_empty_from(at);
        if (is_empty_from(at)) return false;
        return std::ranges::all_of(
            std::span(form.tokens).subspan(1), [&](const StatementToken& token) {
                if (token.is_optional) return true;
                if (token.kind == StatementToken::Kind::Word) return has_keyword(at, token.text);
                return token.kind != StatementToken::Kind::Hole ||
                       token.hole != StatementToken::Hole::Jump || has_jump(at);
            });
    }
    bool is_empty_from(std::size_t at) const { return words_.is_end(words_.skip_blanks(at)); }
    bool has_jump(std::size_t at) const {
        return std::ranges::any_of(language_.statements, [&](const StatementForm& form) {
            return form.statement >= Statement::Jump && form.statement <= Statement::JumpToStart &&
                   has_keyword(at, form.tokens[0].text);
        });
    }
    /// Whether the keyword stands somewhere behind, outside of texts and comments.
    bool has_keyword(std::size_t at, std::string_view keyword) const {
        while (at < line_.size() && !words_.is_comment(at)) {
            if (line_[at] == '"') {
                at = std::min(line_.find('"', at + 1), line_.size() - 1) + 1;
                continue;
            }
            const LetterRun word = words_.word_at(at);
            if (words_.matches(word, keyword)) return true;
            // Where blanks do not count the keyword may stand inside of letters: `#1THEN`.
            at += words_.is_blank_insensitive() ? 1 : std::max<std::size_t>(1, word.text.size());
        }
        return false;
    }

    /// The number of the loop stands last in the statement, which begins at `first`.
    int number_at_end(std::size_t first) const {
        std::size_t end = first;
        while (!words_.is_end(end)) ++end;
        end = words_.trim(first, end);
        std::size_t begin = end;
        while (begin > first && is_digit(line_[begin - 1])) --begin;
        int number = 0;
        for (; begin < end && number < 100000; ++begin) number = number * 10 + (line_[begin] - '0');
        return number;
    }

    const DialectTables& tables_;
    const Language& language_;
    ControlWords words_;
    std::string_view line_;
    LineFront front_;
};

}  // namespace

std::string_view label_at(std::string_view line, std::size_t at) {
    if (at >= line.size()) return {};
    const bool is_text = line[at] == '"';
    const std::size_t begin = is_text ? at + 1 : at;
    const std::size_t end =
        is_text ? line.find('"', begin)
                : std::min(line.find_first_not_of("0123456789", begin), line.size());
    if (end == std::string_view::npos) return {};
    return line.substr(begin, end - begin);
}

LineFront front_of(const DialectTables& tables, std::string_view line) {
    if (!has_split_words(tables, line)) return Front(tables, line).look();
    const LineWithoutBlanks whole = without_blanks(tables, line);
    LineFront front = Front(tables, whole.text).look();
    if (front.number >= 0) whole.put_back(front.number_span);
    if (!front.label.empty()) {
        // It stays when the text is gone.
        const auto at = static_cast<std::uint32_t>(front.label.data() - whole.text.data());
        Span span{at, at + static_cast<std::uint32_t>(front.label.size())};
        whole.put_back(span);
        front.label = line.substr(span.begin, span.end - span.begin);
    }
    return front;
}

}  // namespace kadr::nc
