// line_reader.h — one line of ISO-7bit text → Block, under the modal state that the lines before it
// have left.
//
// Where lines come from, and in which order, is not known here: reader.h reads a text from its head
// to its end, interp runs a program with jumps. For the rooms of nc and for interp.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/done.h"
#include "nc/block_values.h"
#include "nc/computed_values.h"
#include "nc/control_line.h"
#include "nc/lexer.h"
#include "nc/line_faults.h"
#include "nc/matched_line.h"
#include "nc/passed_over.h"
#include "nc/plain_lines.h"
#include "nc/point_watch.h"
#include "nc/program_bounds.h"
#include "nc/reading_modes.h"
#include "nc/verbatim_lines.h"

namespace kadr::nc {

class LineReader {
  public:
    /// `name` is shown in messages. A mistake is reported as the control's alarm.
    LineReader(const Dialect& dialect, std::string name, DiagnosticSink& sink);
    LineReader(const LineReader&) = delete;  // its parts refer to each other
    LineReader& operator=(const LineReader&) = delete;

    using LineKind = ProgramBounds::LineKind;

    enum class Makes : std::uint8_t { Block, Nothing };

    /// The meaning of a line of words and numbers. Where it makes nothing, what is wrong has been
    /// reported, and `faults().failed()` is true.
    Makes read(std::string_view line, std::uint64_t number, Block& block);

    // The same in steps, for who knows more kinds of lines.
    void begin(std::uint64_t number) {
        faults_.begin(number);
        lexed_ = nullptr;  // of a line before, which may be gone
    }
    /// As ProgramBounds has it, of the line that was begun.
    std::string_view without_head(std::string_view line) {
        return bounds_.without_head(line, faults_.line_number());
    }
    /// Plain codes and numbers behind letters: nearly every block. The block is empty before. Gives
    /// up, without a word, on anything that needs a second look.
    bool read_plain(std::string_view line, Block& block);
    /// What kind of line it is; reports what stands at a wrong location.
    LineKind check_kind(std::string_view line);
    /// A line of the control's own language that the dialect knows by its letters.
    bool read_known(std::string_view line, Block& block);
    /// Whether it is one; the block is empty before and after.
    bool knows(std::string_view line, Block& block) const {
        const bool is_known = read_verbatim(tables_, modes_.units(), line, block);
        block.reset();
        return is_known;
    }
    /// The words of a compiled line with the values that were computed for it.
    ///
    /// known  what an earlier run of the line has found; null: nobody keeps it
    Done read_words(std::string_view line, ControlLine& compiled, std::span<const WordValue> values,
                    Block& block, MatchedLine* known = nullptr);
    /// The line is not written as the control wants it.
    void report_fault(std::string_view line, const LineFault& fault);
    /// What came up while the line was executed; how it is written is right. Notes of who asks may
    /// be added.
    DiagnosticBuilder report_event(std::string_view line, const LineFault& fault);
    void report_too_long(std::string_view line, std::uint64_t number);
    /// Each word of a line that has no effect here is reported once.
    void report_passed(const LexedLine& words, std::string_view line) {
        passed_.announce(words, line);
    }
    /// The program is at its end: what is doubtful of all its lines is reported.
    void finish() { points_.finish(); }

    LineFaults& faults() { return faults_; }
    const LineFaults& faults() const { return faults_; }
    ReadingModes& modes() { return modes_; }
    const ReadingModes& modes() const { return modes_; }
    ProgramBounds& bounds() { return bounds_; }
    const ProgramBounds& bounds() const { return bounds_; }
    /// A location in a line of the text.
    TextLocation location(std::string_view line, std::uint64_t number, const Span& span) const {
        return bounds_.location(line, number, span);
    }
    const DialectTables& tables() const { return tables_; }

  private:
    Done read_slow(std::string_view line, Block& block);
    Done fill(std::string_view line, Block& block, MatchedLine* known = nullptr,
              const ControlLine* compiled = nullptr);
    Done apply(std::string_view line, Block& block);
    Done check_code_points(std::string_view line);
    void note_machine_code(std::string_view line);
    bool is_in_cycle() const;

    const DialectTables& tables_;
    ProgramBounds bounds_;
    LineFaults faults_;
    ReadingModes modes_;
    PointWatch points_;
    PassedOver passed_;
    PlainLines plain_;
    BlockValues values_;
    LexedLine* lexed_ = nullptr;  // of the line that is read, when it is
    LexedLine own_lexed_;
    Match match_;
};

}  // namespace kadr::nc
