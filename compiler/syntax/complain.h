// complain.h — what a syntax error is in a technologist's words, and where the parser goes on.
#pragma once

#include <algorithm>
#include <deque>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/done.h"
#include "nc/dialect.h"
#include "syntax/antlr.h"
#include "syntax/limits.h"

namespace kadr::syntax {

/// A Lexeme as ANTLR wants to see it.
class LexemeToken final : public antlr4::Token {
  public:
    LexemeToken(const Lexeme& lexeme, std::size_t index) : lexeme_(lexeme), index_(index) {}
    const Lexeme& lexeme() const { return lexeme_; }

    std::string getText() const override { return ""; }
    std::size_t getType() const override {
        return lexeme_.token == syntax::Token::EndOfFile ? antlr4::Token::EOF
                                                         : static_cast<std::size_t>(lexeme_.token);
    }
    std::size_t getLine() const override { return 0; }
    std::size_t getCharPositionInLine() const override { return 0; }
    std::size_t getChannel() const override { return DEFAULT_CHANNEL; }
    std::size_t getTokenIndex() const override { return index_; }
    std::size_t getStartIndex() const override { return lexeme_.begin; }
    std::size_t getStopIndex() const override { return lexeme_.end; }
    antlr4::TokenSource* getTokenSource() const override { return nullptr; }
    antlr4::CharStream* getInputStream() const override { return nullptr; }
    std::string toString() const override { return ""; }

  private:
    Lexeme lexeme_;
    std::size_t index_;
};

/// The lexemes as the stream that ANTLR's parser reads.
class LexemeStream final : public antlr4::TokenStream {
  public:
    /// `limit` outlives the stream; null: there is no clock.
    explicit LexemeStream(const std::vector<Lexeme>& lexemes, const LimitedSink* limit = nullptr);

    /// Throws what ends the parser where there is no time left.
    void consume() override {
        if (at_ + 1 < tokens_.size()) ++at_;
        if (at_ % kSlice == 0 && limit_ != nullptr && limit_->is_late())
            throw antlr4::ParseCancellationException();
    }
    std::size_t LA(ssize_t offset) override { return LT(offset)->getType(); }
    antlr4::Token* LT(ssize_t offset) override;
    antlr4::Token* get(std::size_t index) const override;
    ssize_t mark() override { return 0; }
    void release(ssize_t) override {}
    std::size_t index() override { return at_; }
    std::size_t place() const { return at_; }
    void seek(std::size_t index) override { at_ = index; }
    std::size_t size() override { return tokens_.size(); }
    std::size_t size() const { return tokens_.size(); }
    std::string getSourceName() const override { return ""; }
    antlr4::TokenSource* getTokenSource() const override { return nullptr; }
    std::string getText(const antlr4::misc::Interval&) override { return ""; }
    std::string getText() override { return ""; }
    std::string getText(antlr4::RuleContext*) override { return ""; }
    std::string getText(antlr4::Token*, antlr4::Token*) override { return ""; }

    /// The lexeme at an index; behind the end of the file that end.
    const Lexeme& lexeme(std::size_t index) const {
        return tokens_[std::min(index, tokens_.size() - 1)].lexeme();
    }

  private:
    const LimitedSink* limit_;
    mutable std::vector<LexemeToken> tokens_;
    std::size_t at_ = 0;
};

/// Reports syntax errors and finds the point where the parser can go on: behind the next `;` or `}`
/// of the statement or declaration that holds the mistake.
class Complaints final : public antlr4::DefaultErrorStrategy {
  public:
    /// `lost_names` gets the names of declarations that stand where there can be none.
    Complaints(const SourceFile& file, LexemeStream& stream, const LimitedSink& limit,
               const nc::Dialect& dialect, bool has_broken_blocks,
               std::vector<std::string>& lost_names)
        : file_(file),
          stream_(stream),
          limit_(limit),
          dialect_(dialect),
          has_broken_blocks_(has_broken_blocks),
          lost_names_(lost_names) {}

    antlr4::Token* recoverInline(antlr4::Parser* parser) override;
    void reportError(antlr4::Parser* parser, const antlr4::RecognitionException& e) override;
    void recover(antlr4::Parser* parser, std::exception_ptr e) override;
    void sync(antlr4::Parser* parser) override;

  private:
    struct ParserPosition;
    ParserPosition location_of(antlr4::Parser& parser, std::size_t index);
    void complain(antlr4::Parser& parser, std::size_t index);
    void explain(const ParserPosition& at);
    Done check_number(const ParserPosition& at);
    Done check_capitals(const ParserPosition& at);
    std::string form_of_control(std::string_view keyword, std::size_t head) const;
    Done check_program_number(const ParserPosition& at);
    Done check_habit(const ParserPosition& at);
    bool is_program_number(const Lexeme& lexeme) const;
    void fix_program_number(const Lexeme& lexeme, DiagnosticBuilder& report) const;
    void fix_call(const ParserPosition& at, DiagnosticBuilder& report) const;
    std::size_t word_to(std::size_t first) const;
    void fix_counting(const ParserPosition& at, DiagnosticBuilder& report) const;
    bool is_cast(const ParserPosition& at) const;
    bool fix_sign(const ParserPosition& at, DiagnosticBuilder& report) const;
    void fix_operator(const ParserPosition& at, DiagnosticBuilder& report) const;
    void fix_parentheses(const ParserPosition& at, DiagnosticBuilder& report) const;
    void fix_word_value(const ParserPosition& at, DiagnosticBuilder& report) const;
    bool is_declared(std::string_view name) const;
    void fix_control_variable(const Lexeme& word, DiagnosticBuilder& report) const;
    void fix_name_of_word(const Lexeme& word, DiagnosticBuilder& report) const;
    void fix_value_of_word(const Lexeme& word, DiagnosticBuilder& report) const;
    bool is_list(std::size_t open, std::size_t close) const;
    bool is_then(std::size_t index) const;
    std::size_t last_comma(std::size_t index) const;
    void fix_comma_of_loop(const ParserPosition& at, DiagnosticBuilder& report) const;
    void fix_brackets(const ParserPosition& at, DiagnosticBuilder& report) const;
    Done check_glued_words(const ParserPosition& at);
    std::size_t matching(std::size_t open) const;
    std::string round_brackets(std::size_t open) const;
    bool ends_line(std::size_t index) const;
    Done check_name(const ParserPosition& at);
    Done check_value(const ParserPosition& at);
    Done check_for(const ParserPosition& at);
    Done check_do(std::size_t index);
    Done check_sign(const ParserPosition& at);
    void fix_include(std::size_t index, DiagnosticBuilder& report) const;
    Done check_closing(const ParserPosition& at);
    Done check_assignment(const ParserPosition& at);
    bool is_foreign_word(const ParserPosition& at) const;
    Done check_name_in_list(const ParserPosition& at);
    bool is_closed_behind(std::size_t last) const;
    Done check_small_address(const ParserPosition& at);
    Done check_comma(const ParserPosition& at);
    Done check_declaration(const ParserPosition& at);
    void explain_address_name(const Lexeme& lexeme);
    void explain_start(antlr4::Parser& parser);
    void lose_names(std::size_t index);
    void lose_variable(const ParserPosition& at);
    bool is_semicolon_forgotten(const ParserPosition& at) const;
    std::vector<Token> open_brackets(const antlr4::ParserRuleContext& context) const;
    void skip_parameters(const antlr4::ParserRuleContext& context);
    void skip_statement(antlr4::Parser& parser, const antlr4::ParserRuleContext& context);
    void skip_start(antlr4::Parser& parser, bool is_file);
    std::string quoted(const Lexeme& lexeme) const;

    const SourceFile& file_;
    LexemeStream& stream_;
    const LimitedSink& limit_;
    const nc::Dialect& dialect_;  // whose words blocks have
    bool has_broken_blocks_;
    std::vector<std::string>& lost_names_;
    std::deque<LexemeToken> conjured_;   // tokens that were missing
    std::set<std::string> bad_names_;    // addresses that stood in the place of a name
    std::size_t last_place_ = SIZE_MAX;  // index of the token of the last complaint
};

}  // namespace kadr::syntax
