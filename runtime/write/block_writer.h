// block_writer.h — one Block → its line or lines, against the modal state of the text.
//
// For writer.cpp, which puts the frame of the program around it.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "write/choice.h"
#include "write/fast_moves.h"
#include "write/idle_lines.h"
#include "write/lines.h"
#include "write/messages.h"
#include "write/shape_behind_cycle.h"
#include "write/targets.h"
#include "write/text_state.h"
#include "write/words.h"
#include "write/writer.h"

namespace kadr::write {

class BlockWriter {
  public:
    BlockWriter(const Dialect& dialect, const WriteOptions& options, DiagnosticSink& sink);

    const WriterModal& modal() const { return state_.modal(); }
    const TextView& view() const { return text_; }
    bool is_ready_for(const Block& cycle, const Block& move) const;
    void set_statements(std::span<const SourceRange> statements, const Sources* sources) {
        messages_.set_statements(statements, sources);
    }
    void begin(const ProgramInfo& program);

    /// Appends the line or lines of the block; returns the number of the first one.
    std::uint32_t write(const Block& block, std::string& out);
    /// For the lines of the program's frame, which are none of its blocks.
    TextState& text_state() { return state_; }
    Lines& text_lines() { return lines_; }

    std::uint32_t lines() const { return lines_.count(); }
    bool failed() const { return messages_.failed(); }
    bool has_ended() const { return state_.has_ended(); }

  private:
    /// Whether the block stands in the text, or has a message instead.
    enum class Written : std::uint8_t { NotYet, Already };
    /// No: the block is a part of an arc already, and is not written in parts again.
    enum class Whole : std::uint8_t { No, Yes };
    void write_raw(const Block& block, std::string& out);
    void write_block(const Block& block, std::string& out, Whole whole = Whole::Yes);
    void write_long(const Block& block, std::string& out);
    Targets place_words(const Block& block, Function motion);
    Written write_thread(const Block& block, std::string& out);
    std::optional<std::size_t> longer_travel(const Block& block) const;
    void check_front(const Block& block);
    void check_arc_words(const Block& block);
    void check_knot(const Block& block, Function motion);

    // Functions
    void write_needs(const nc::Form& form, const Block& block, std::string& out);
    void write_functions_alone(const Block& block, Choice& choice, std::string& out);
    void collect_functions(const Block& block, const Choice& choice, Items& items);
    void add_code(const Block& block, Function function, Items& items);
    bool needs_distance(const Block& block, const Choice& choice, Function distance) const;
    void restore_modal(const Block& block, const Choice& choice, Items& items);
    void say_doubtful(const Block& block, std::string& out);
    bool is_shift_standing(const Form& form, const Block& block,
                           const Invocation& invocation) const;
    void write_before(const Form& form, const Block& block, std::string& out);
    void write_pitch(const Form& form, const Block& block, const Invocation& invocation,
                     std::string& out);
    void leave_cycle(const Block& block, const Choice& choice, std::string& out);
    bool ends_cycle(const Block& block) const;
    void follow_cycle(const Block& block, const Choice& choice, std::string& out);
    void close_cycle(std::string& out);
    void write_further_lines(const Form& form, const Block& block, const Invocation* invocation,
                             std::string& out);
    bool is_at_level(const Form& form, const Block& block, const Invocation& invocation) const;
    double cycle_speed(const Block& block, const Invocation& invocation) const;
    Function spindle_behind(const Form& form, const Block& block,
                            const Invocation& invocation) const;
    bool has_speed(const Block& block, const Invocation& invocation) const;
    void write_waiting_edge(const Block& block, std::string& out);
    void put_waiting_edge(const Block& block, std::string& out);
    void check_length_due(const Block& block);
    void add_edge(const Block& block, Items& items);
    bool holds_length(const Block& block) const;
    void write_without_length(const Block& block, std::string& out);
    void write_initial_level(const Form& form, const Block& block, const Invocation& invocation,
                             std::string& out);
    void check_message(const Block& block);
    bool shares_address(const Form& form, const Block& block) const;

    // Arcs
    Written write_other_arc(const Block& block, Whole whole, std::string& out);
    Written write_turns(const Block& block, Whole whole, std::string& out);
    Written write_parts(const Block& block, std::string& out);
    Written straighten(const Block& block, std::string& out);

    // Lines
    bool repeats_feed(const Block& block, const Choice& choice, const Targets& targets) const;
    bool is_call(const Choice& choice, const Block& block, const Invocation& cycle) const;
    bool has_feed_word(const Block& block, const Choice& choice, const Invocation& cycle) const;
    void collect_slots(const Block& block, const Choice& choice, const Targets& targets,
                       Items& items);
    void add_deferred(const Block& block, const Choice& choice, Items& items);
    double own_offset(const Choice& choice, const Pending& pending, const Block& block) const;
    void write_apart(const Block& block, const Items& items, const LineChoices& choices,
                     bool is_behind, std::string& out);
    void write_items(const Block& block, Items& items, const Targets& targets, std::string& out);
    void note_line(const std::vector<FormWord>& words);

    const Dialect& dialect_;
    const DialectTables& tables_;
    const Rules& rules_ = tables_.rules;
    WriteOptions options_;
    TextState state_;
    const TextView& text_ = state_.view();
    const WriterModal& modal_ = state_.modal();
    BlockMessages messages_;
    Lines lines_;
    Words words_;
    FormChooser chooser_;
    FastMoves fast_;
    IdleLines idle_;
    /// A cycle that is called at the positions which follow, until `cycle_modal` stands alone.
    struct OpenCycle {
        Block block;
        Choice choice;
    };
    std::optional<OpenCycle> open_cycle_;
    ShapeBehindCycle shape_;
};

}  // namespace kadr::write
