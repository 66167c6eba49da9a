// lexer.h — a line of ISO-7bit text as words, by the lexical rules of a dialect.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "base/numbers.h"
#include "nc/match.h"

namespace kadr::nc {

/// Where a word stands in its line: bytes.
struct Span {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
};

/// What one line holds. Reused from line to line.
struct LexedLine {
    /// A word that is passed over; its row lives in the dialect.
    struct Passed {
        Span span;
        const PassedWord* word = nullptr;
    };
    std::vector<Passed> passed;
    std::vector<GivenWord> words;
    std::vector<Decimal> decimals;  // of the words
    std::vector<bool> minus;
    std::vector<Span> spans;
    std::vector<GivenArgument> arguments;  // of calls
    std::string text;                      // last text between quotes
    std::string comment;
    std::string label;
    std::int8_t skip_level = -1;
    std::uint16_t further_skip_levels = 0;  // further levels, a bit each
    std::int32_t number = -1;
    bool has_comment = false;
    FormId comment_form = kNoForm;  // of a message that stands in a comment
    Span comment_form_span;

    void clear();
    /// A word as it stands in `line`, which these words are of.
    std::string text_of(std::string_view line, std::size_t word) const {
        const Span& span = spans[word];
        return std::string(line.substr(span.begin, span.end - span.begin));
    }
};

/// A mistake in a line: the row, its location, and what to report.
struct LineFault {
    const DiagnosticRow* row = nullptr;
    Span span;
    std::vector<std::string> arguments;
    std::string fix = {};  // where the location itself shows what is meant
};

/// Compiles what stands in a line besides words with numbers: the control's own language. Each call
/// begins at `at` and moves it behind what was taken.
class ValueCompiler {
  public:
    virtual ~ValueCompiler() = default;
    /// A statement, an assignment or a main block's number where a word could begin.
    virtual std::optional<LineFault> take_piece(std::size_t& at, bool& was_taken) = 0;
    /// Whether a computed value stands here, directly behind an address.
    virtual bool begins_value(std::size_t at) const = 0;
    /// The brackets of a word whose axis is a value, `AX[AXA]`; `word` is the word that it becomes.
    virtual std::optional<LineFault> take_axis(std::size_t& at, std::uint16_t word,
                                               bool& was_taken) = 0;
    /// `[6]=2` behind the letter of codes; `word` is the word that it becomes.
    virtual std::optional<LineFault> take_code(std::size_t& at, std::uint16_t word) = 0;
    /// Whether an operator stands here, behind a number.
    virtual bool continues(std::size_t at) const = 0;
    /// Whether the operator leaves out what has this skip level.
    virtual bool leaves_out(int level) const = 0;
    /// The value of a word, or of an argument of a call (index into LexedLine::arguments).
    virtual std::optional<LineFault> take_value(std::size_t& at, std::uint16_t word,
                                                std::int32_t argument) = 0;
};

/// Splits `line`. The words are in the order of the text; a message that is written as a comment is
/// a word as well.
///
/// compiler  takes what belongs to the control's language; null: it is a fault
std::optional<LineFault> lex_line(const DialectTables& tables, std::string_view line,
                                  LexedLine& out, ValueCompiler* compiler = nullptr);

}  // namespace kadr::nc
