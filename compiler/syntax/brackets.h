// brackets.h — the brackets that are open at a location in the source, and what is done when they
// do not match: the mistake is reported once and the token list is mended, so that the parser
// always sees a well-formed nesting.
#pragma once

#include <vector>

#include "base/done.h"
#include "syntax/lexeme.h"

namespace kadr::syntax {

struct Bracket {
    enum class Role : std::uint8_t {
        Plain,    // a call, parentheses, an index, a value in braces
        Control,  // of if, while, switch
        For,
        Parameters,  // of a declaration
        Block,       // statements
        Members,     // of a struct
        Enumerators,
    };
    Lexeme open;
    Role role = Role::Plain;
    int questions = 0;   // `?` that wait for their `:`
    int semicolons = 0;  // inside `for (…)`
    int heads = 0;       // statements around the next one that have no braces: `if (a) for …`
    std::uint32_t indent = 0;  // of the line with the bracket

    bool is_block() const { return role >= Role::Block; }
};

class Brackets {
  public:
    Brackets(const SourceFile& file, std::vector<Lexeme>& out) : file_(file), out_(out) {}

    void open(const Lexeme& lexeme, Bracket::Role role);
    /// A closing bracket: ends what it closes, after mending what is open inside of it. What
    /// closes nothing is reported and must be dropped.
    Done close(const Lexeme& lexeme);
    /// Closes everything down to the statements around, because `before` cannot stand inside.
    void close_values(const Lexeme& before);
    /// Closes every block, because `before` can only stand at file level.
    void close_blocks(const Lexeme& before);

    bool is_file_level() const { return stack_.empty(); }
    bool is_statement_level() const { return stack_.empty() || stack_.back().is_block(); }
    std::size_t depth() const { return stack_.size() + heads_; }
    const Bracket* top() const { return stack_.empty() ? nullptr : &stack_.back(); }
    Bracket* top() { return stack_.empty() ? nullptr : &stack_.back(); }
    const Bracket& outermost() const { return stack_.front(); }
    /// Whether a block was closed too early or too late: then the level of what follows is a guess.
    bool has_broken_blocks() const { return has_broken_blocks_; }
    void add_head() { ++heads_; }
    void reset_heads();

  private:
    std::size_t end_of_top() const;
    void mend_top(const Lexeme& before);
    void exchange_top(const Lexeme& wrong);
    void pop();
    void remember_suspect(const Lexeme& brace);

    const SourceFile& file_;
    std::vector<Lexeme>& out_;
    std::vector<Bracket> stack_;
    std::size_t heads_ = 0;
    bool has_suspect_ = false;
    Lexeme suspect_;  // the first `{` whose `}` seems to be missing, judged by the indentation
    bool has_broken_blocks_ = false;
};

/// The bracket that closes this one.
Token closing_of(Token open);

}  // namespace kadr::syntax
