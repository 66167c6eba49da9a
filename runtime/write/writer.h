// writer.h — Block → ISO-7bit text.
//
// Knows the control's spelling, its number formats and what is modal. Every word that it writes
// reads back, under the same dialect's rules, as the intended value within half an increment; a
// value that cannot be written so is an error, never a wrong word.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "write/names.h"

namespace kadr::write {

struct WriteOptions {
    bool verbose_modal = false;                // repeat modal words
    bool number_blocks = true;                 // as in the dialect; false: never
    bool native_cycles = true;                 // false: cycles have been expanded by the caller
    std::vector<Refusal>* refusals = nullptr;  // gets the forms that were passed over; null: nobody
};

struct WriterModal;

class Writer {
  public:
    /// dialect and sink outlive the writer. Reports with the range that `range_of` gives.
    Writer(const Dialect& dialect, WriteOptions options, DiagnosticSink& sink);
    ~Writer();
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    /// Statement ranges for messages, index SourceId, and the texts that they lie in, so that a
    /// message can point at one word. Outlive the writer; may be empty.
    void set_statements(std::span<const SourceRange> statements, const Sources* sources = nullptr);

    void begin(const ProgramInfo& program, std::string& out);
    /// Appends the line or lines of the block and returns the number of the first one (from 1).
    std::uint32_t write(const Block& block, std::string& out);
    void end(std::string& out);
    /// The lines with which a program begins, unless they are written: the first block that does
    /// something has them in front of it.
    void write_start(std::string& out);
    bool has_started() const;
    /// The statement whose codes stand in the latest line with which a program or a section begins;
    /// none: it has its own only.
    SourceId taken() const;
    /// Whether codes of the latest blocks wait for that line: the text does not have them yet.
    bool holds_codes() const;

    std::uint32_t lines() const;  // written so far
    bool failed() const;          // an error was reported
    /// What the text has written behind its last line, as far as the writer knows (modal.h).
    const WriterModal& believed() const;
    /// The member of a modal group that acts for the program's blocks; None: not known.
    Function means(Group group) const;
    /// First, second and third axis of the working plane.
    std::array<std::size_t, 3> plane_axes() const;
    /// Whether the cycle can stand in one line with the move to its position: the tool is at its
    /// level, nothing waits for a move along its axis, and no word would stand twice.
    bool is_ready_for(const Block& cycle, const Block& move) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace kadr::write
