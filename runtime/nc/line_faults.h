// line_faults.h — messages about the lines of a text: where they point, the alarm of the control
// that they are, and what to write instead.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <utility>

#include "base/diagnostic.h"
#include "nc/dialect.h"
#include "nc/foreign_words.h"
#include "nc/lexer.h"
#include "nc/program_bounds.h"

namespace kadr::nc {

/// Whether a message says that a word or a sign is not understood; others, of a number out of its
/// range or a bracket that is not closed, have nothing to do with the words of other controls.
bool is_about_words(const DiagnosticRow& row);

class LineFaults {
  public:
    /// References outlive it.
    LineFaults(const Dialect& dialect, const ProgramBounds& bounds, DiagnosticSink& sink)
        : dialect_(dialect), tables_(dialect.tables()), bounds_(bounds), sink_(sink) {}

    /// What is reported from here on stands in this line.
    void begin(std::uint64_t number) { line_number_ = number; }
    std::uint64_t line_number() const { return line_number_; }

    /// Reports what the control alarms on in the line that was begun. Notes of who asks may be
    /// added.
    DiagnosticBuilder report(std::string_view line, const LineFault& fault,
                             const ForeignLocation& came_up);
    /// A message that is no alarm, at a location in that line. Who asks writes the notes behind it.
    DiagnosticBuilder message(const DiagnosticRow& row, std::string_view line,
                              const Span& span) const {
        return message(row, bounds_.location(line, line_number_, span));
    }
    /// … at a location in a line before it.
    DiagnosticBuilder message(const DiagnosticRow& row, TextLocation location) const {
        return sink_.report(row, std::move(location));
    }
    /// A location in the line that was begun.
    TextLocation location(std::string_view line, const Span& span) const {
        return bounds_.location(line, line_number_, span);
    }
    /// An alarm that somebody else has reported came up in this line.
    void note_fault() {
        failed_ = true;
        if (first_fault_ == 0) first_fault_ = line_number_;
    }
    /// What was wrong in a line was reported, and the lines behind count as before.
    void forget_fault() {
        failed_ = false;
        first_fault_ = 0;
    }
    bool failed() const { return failed_; }
    /// The number of the first line that was wrong; 0: none was.
    std::uint64_t first_fault() const { return first_fault_; }

    /// Adds to each message what is to be reported about the location of the line.
    void add_notes(std::function<void(DiagnosticBuilder&)> notes) { notes_ = std::move(notes); }
    void write_notes(DiagnosticBuilder& message) const {
        if (notes_) notes_(message);
    }

  private:
    const Dialect& dialect_;
    const DialectTables& tables_;
    const ProgramBounds& bounds_;
    DiagnosticSink& sink_;
    std::function<void(DiagnosticBuilder&)> notes_;
    std::uint64_t line_number_ = 0;
    bool failed_ = false;
    std::uint64_t first_fault_ = 0;
};

}  // namespace kadr::nc
