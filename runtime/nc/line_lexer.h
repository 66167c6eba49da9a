// line_lexer.h — how a line is split into words: what begins at an index of the line, and how far
// it goes. Internal to lexer.cpp, lexer_letters.cpp and lexer_names.cpp; others ask lex_line.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/done.h"
#include "base/text.h"
#include "nc/letters.h"
#include "nc/lexer.h"
#include "nc/mode_words.h"

namespace kadr::nc {

class Lexer {
  public:
    /// References outlive it.
    ///
    /// compiler  as lex_line has it
    Lexer(const DialectTables& tables, std::string_view line, LexedLine& out,
          ValueCompiler* compiler);

    /// Splits the line; what is wrong with it, if anything is.
    std::optional<LineFault> run();

  private:
    /// Whether what begins here is of the kind that was asked for; then it is in the line, or the
    /// fault tells what is wrong with it.
    enum class Claimed : std::uint8_t { No, Yes };

    static char upper(char c) { return is_lower(c) ? static_cast<char>(c - 'a' + 'A') : c; }
    char peek(std::size_t ahead = 0) const { return peek_at(at_ + ahead); }
    char peek_at(std::size_t i) const {
        if (i >= line_.size()) return '\0';
        return notation_.ignores_case ? upper(line_[i]) : line_[i];
    }
    bool skip_blanks() {
        while (at_ < line_.size() && is_blank(line_[at_])) ++at_;
        return at_ < line_.size();
    }
    void skip_inner_blanks() {
        if (notation_.blanks_inside_words) skip_blanks();
    }
    bool is_letter(char c) const { return is_upper(c) || (notation_.ignores_case && is_lower(c)); }

    // Faults: only the first one of a line counts.
    void fail(const DiagnosticRow& row, std::size_t begin, std::size_t end,
              std::vector<std::string> arguments);
    /// A word that the dialect does not declare; the control may have it all the same.
    void fail_unknown(std::size_t begin, std::size_t end);
    /// `XY1.` on a control whose words are letters with numbers: X has none.
    Done require_number_behind(std::size_t begin);
    /// `A3=`: a letter with a number of its own, behind which `=` stands.
    void fail_assigned(std::size_t begin, const char* otherwise);
    /// `E=0`, `Q1=5`: the control has axes of any letter, and this machine none such.
    void fail_at_missing_axis(std::size_t begin);
    /// `C1=5`: an axis of that name is not there; `F1=5`: words of others are.
    void fail_numbered(AddressId address, std::size_t begin);
    /// What stands behind a word that Kadr does not know may have a form that it does not know: the
    /// fault is that word then.
    Done require_supported_words();
    void fail_here(const DiagnosticRow& row);

    // The front of a block, and which kind of piece stands behind it.
    void take_skip();
    /// `/`, `/2`: the level, or nothing if it was reported.
    std::optional<int> take_skip_level();
    /// The rest of the block is left out if the operator wants it. Behind a value of the control's
    /// own language the sign could be a division.
    void take_skip_of_rest();
    void take_skip_sign();
    Claimed take_language();
    /// `AX[AXA]=10`: the address of X stands for the axis that is known when the line runs.
    Claimed take_axis_word();
    /// A value that is computed when the line runs.
    void take_computed(AddressId address, std::size_t begin);
    /// Whether what stands here is more than one number.
    bool is_computed(std::size_t at) const;
    void take_piece();
    /// The sign that ends a block; nothing stands behind it in the line.
    void take_end();
    void take_comment();
    void note_comment(std::string_view text);
    /// The signs of a comment that is only read, if one begins here.
    const CommentMarks* other_comment(std::size_t at) const;
    void take_other_comment(const CommentMarks& marks);
    Claimed take_front();
    void take_label(std::string_view written, std::size_t begin);
    bool is_comment(std::size_t at) const;
    void add_word(AddressId address, std::size_t begin);

    // Letters with their numbers: lexer_letters.cpp.
    void take_letter();
    /// `,C5.`: an address of two characters.
    void take_comma_word();
    /// The address of a letter with a number of its own that stands at `begin`, if the dialect
    /// declares it; `end` is behind its name.
    AddressId extended_at(std::size_t begin, std::size_t& end) const;
    /// Whether such a word stands here: it is a word of the control even where its language has
    /// variables with such names.
    bool is_declared_name() const;
    /// `X1=0`
    Claimed take_extended(std::size_t begin);
    /// `G[6]=2`: a code by its index in the list of its group; `at_` is behind the letter.
    Claimed take_code_of_group(std::size_t begin);
    void take_block_number(std::size_t begin);
    /// `10`, `-5.25`, and on some controls `1 0 . 5`.
    Done take_number(AddressId address, std::size_t begin);
    Done take_spaced_number(AddressId address, std::size_t begin);
    /// `1.5EX-3`, on controls whose words are told apart by blanks.
    Done take_exponent(Decimal& decimal);
    void add_number(AddressId address, std::size_t begin, const Decimal& decimal, bool is_minus);
    /// A word on which nothing here depends, with its brackets and its value; `at_` is behind the
    /// letters that begin at `begin`.
    Claimed take_passed(std::size_t begin);
    /// The number behind `=`, if one stands there, is one that the word takes; `at_` is behind it.
    Done require_passed_value(const PassedWord& word, std::size_t begin);
    /// Where a word ends whose letters end at `at_`: behind its number or brackets, and its value.
    std::size_t end_of_passed(std::size_t begin) const;
    /// Behind the bracket or the text that opens at `at`.
    std::size_t end_of_brackets(std::size_t at) const;

    // Names, indices, what stands behind `=`, calls: lexer_names.cpp.
    void take_name();
    /// `DIAMONA[X]`: a word of its own by the name with its brackets; `at_` stands at the bracket.
    Claimed take_bracketed_name(const std::string& name, std::size_t begin);
    /// A word that names an axis between brackets (`ACC[X]=50`) names one that is there. That of a
    /// spindle may be passed over. `at_` is behind its letters.
    Done require_axis_index(std::size_t begin);
    /// `PO[X]=(10,2)`, which a dialect declares as a call of the name `PO[X]=`, and `ACC[X]=50`, an
    /// address `ACC[X]`; `at_` is behind the letters that begin at `begin`.
    Claimed take_indexed(std::size_t begin);
    /// `S1=500`, `M1=3`, `SPOS[1]=90`, `S[SPI(1)]=500`: a word of the first spindle, which is the
    /// master unless the program chooses otherwise; `at_` is behind the letters that begin at
    /// `begin`. What the dialect declares for other spindles are addresses of their own.
    Claimed take_spindle(std::size_t begin);
    /// `S[R1]=500`, `SPOS[R1]=90`, `ACC[AXV]=50`: words of a spindle or of an axis that is known
    /// when the line runs; `at_` is behind the letters that begin at `begin`.
    Claimed take_computed_index(std::size_t begin);
    /// `=10`, `=AC(10)`, `=IC(-5)`, `=DC(90)`, `="text"`; behind the address.
    void take_assigned(AddressId address, std::size_t begin);
    /// `F=FPO(100,5)`, which a dialect declares as a call of the name `F=FPO`; `at_` is behind the
    /// sign.
    Claimed take_call_behind(const Address& head, std::size_t begin);
    /// `AC(`, `DIC(`, … stands here.
    const ModeWord* mode_here() const;
    /// `AC(` or `IC(` in front of the end of an axis in a polynomial, `PO[X]=(AC(10),2)`.
    const ModeWord* end_mode_here(AddressId address) const;
    /// Whether more than one text stands here: `"X="<<R1`.
    bool is_computed_text() const;
    Done take_text(std::size_t begin);
    void take_quoted(AddressId address, std::size_t begin);
    void take_call(AddressId address, std::size_t begin);
    /// `(UAO,1)`, `(UOT,1,X10,YE31)`, `(MIR,X)`: the brackets stand around the name.
    void take_call_in_brackets();
    /// The arguments and the closing bracket; `at_` is behind what stands in front of the first.
    void take_arguments(AddressId address, std::size_t begin);
    /// The letter of an argument that is found by it, if one stands here: `X10`, `X`.
    AddressId argument_letter() const;
    /// A word that is passed over, which ends with its closing bracket.
    Claimed take_passed_in_brackets(const std::string& name, std::size_t begin);
    /// `XE30`: a variable whose name begins with a letter, directly behind an address.
    Claimed take_letter_with_variable(std::size_t begin);

    const DialectTables& tables_;
    const Notation& notation_;
    std::string_view line_;
    LexedLine& out_;
    ValueCompiler* compiler_;
    std::string_view open_;
    std::string compact_;
    bool is_behind_statement_ = false;
    bool is_behind_computed_ = false;  // the piece before is a word that is worked out
    std::size_t at_ = 0;
    std::optional<LineFault> fault_;
};

}  // namespace kadr::nc
