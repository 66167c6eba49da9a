// text_scan.h — one look through a text, line by line, as a run reads it for the first time.
// Internal to macro.
#pragma once

#include <cstdint>
#include <string>

#include "base/discarding_sink.h"
#include "macro/line_uses.h"
#include "macro/program_units.h"
#include "macro/scanned_text.h"
#include "macro/variable_numbers.h"
#include "nc/line_reader.h"

namespace kadr::macro {

class TextScan {
  public:
    /// References outlive it.
    ///
    /// names       that all programs have
    /// axis_names  null: as machines call them
    TextScan(const nc::Dialect& dialect, ScannedText& out, NamesOfProgram names,
             const nc::MachineAxisNames* axis_names);

    /// Looks through the text, which can be read again.
    ///
    /// mark  bytes in front of its first line that are none of it
    /// main  where the main program begins
    void read(nc::LineSource& source, std::uint64_t mark, const LinePosition& main);

    /// The names that all programs have behind the text.
    const NamesOfProgram& common() const { return common_; }

  private:
    void take_line(std::string_view line, const ProgramLine& place);
    void take_head(std::string_view line, const LinePosition& at);
    void take_block(std::string_view line, const ProgramLine& place);
    void take_label(std::string_view line, const ProgramLine& place);
    void compile(const ReadLine& line);
    void take_shape(const ReadLine& line);
    bool calls_shape(const nc::Block& block) const;
    void keep_lost_names(const ReadLine& line);
    void follow_modal_calls();
    void begin_program(const LinePosition& begin);
    void end_program(const LinePosition& end);
    bool is_of_definitions() const;
    std::uint64_t byte_of(const ProgramLine& place) const {
        return place.line.offset + (place.line.offset == 0 ? mark_ : 0);
    }

    const nc::Dialect& dialect_;
    const nc::DialectTables& tables_;
    ScannedText& out_;
    const nc::MachineAxisNames* axis_names_;
    DiscardingSink nobody_;
    nc::LineReader lines_;
    nc::TextBounds bounds_;
    nc::Block block_;
    nc::ControlLine code_;
    LineUses uses_;
    NamesOfProgram common_;
    NamesOfProgram own_;       // of the program that is read
    VariableNumbers numbers_;  // names that stand for them, in all programs
    LinePosition main_;
    std::uint64_t mark_ = 0;
    const bool has_shapes_;      // cycles may name blocks, labels or programs
    bool takes_blocks_ = false;  // blocks are arguments of a modal call
};

/// The same variables as all programs have them, who may declare others of their names.
nc::SymbolTable shared(const nc::SymbolTable& symbols);

/// The blocks at which the uses aim, and which of the targets stand twice: a second look, for lines
/// with numbers are many.
void index_blocks(const nc::DialectTables& tables, nc::LineSource& source, std::uint64_t mark,
                  ScannedText& out);

}  // namespace kadr::macro
