// control_words.h — names, keywords and blanks in a line of the control's own language.
#pragma once

#include <string>
#include <string_view>

#include "nc/tables.h"

namespace kadr::nc {

/// Letters that stand together.
struct LetterRun {
    std::size_t begin = 0;
    std::string_view text;
};

class ControlWords {
  public:
    ControlWords(const DialectTables& tables, std::string_view line);

    /// Blanks do not count, so that letters are told apart by what is known: `#1EQ#2`.
    bool is_blank_insensitive() const { return tables_.notation.blanks_inside_words; }
    /// Numbers may have exponents: `1.5EX-3`.
    bool has_exponents() const { return !is_blank_insensitive(); }

    std::size_t skip_blanks(std::size_t at) const;
    /// Behind blanks and comments that end in the line.
    std::size_t skip_comments(std::size_t at) const;
    /// The same where comments have several signs.
    std::size_t skip_all_comments(std::size_t at) const;
    /// The end of the text without the blanks before it.
    std::size_t trim(std::size_t begin, std::size_t end) const;
    char upper(char c) const;
    std::string normal(std::string_view text) const;
    bool is_comment(std::size_t at) const;
    /// Whether the sign that ends a block stands here, and not an operator that looks like it:
    /// nothing but a comment follows.
    bool is_block_end(std::size_t at) const;
    /// Whether nothing of the block stands here any more: the line, a comment or the sign ends it.
    bool is_end(std::size_t at) const {
        return at >= line_.size() || is_comment(at) || is_block_end(at);
    }
    /// A name with its digits, on a control without blanks letters alone; `#` begins one too.
    LetterRun word_at(std::size_t at) const;
    bool is_same(std::string_view a, std::string_view b) const;
    bool starts_with(std::size_t at, std::string_view text) const;
    /// Whether the word is this keyword, a short form of it, or begins with it where blanks do not
    /// count.
    bool matches(const LetterRun& word, std::string_view keyword) const;
    /// The same; a keyword of one letter has digits behind it, `L5` for `L{from}`.
    bool matches_with_digits(const LetterRun& word, std::string_view keyword) const;
    /// The same for operators, which have no short forms.
    bool matches_operator(const LetterRun& word, std::string_view text) const;
    /// How much of the word the keyword is.
    std::size_t length_of(const LetterRun& word, std::string_view keyword) const;
    /// Whether a variable with a number or a sign (`#1`, `R5`, `$P_EP`) begins here.
    bool begins_variable(std::size_t at) const;
    /// 120 for `N120`; -1: it is another name.
    std::int64_t block_number(std::string_view name) const;

  private:
    const DialectTables& tables_;
    std::string_view line_;
    std::string_view comment_;
};

}  // namespace kadr::nc
