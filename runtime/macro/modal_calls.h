// modal_calls.h — calls that are made behind the blocks that come, or at the positions of a
// pattern.
#pragma once

#include "macro/outcome.h"
#include "macro/program_frame.h"

namespace kadr::macro {

class ProgramRun;

class ModalCalls {
  public:
    /// run  outlives it
    explicit ModalCalls(ProgramRun& run) : run_(run) {}

    bool is_empty() const { return calls_.empty(); }
    /// A call becomes modal; `out` is a block where it ends cycles.
    Outcome begin(CompiledLine& line, const nc::ControlStatement& statement, nc::Block& out);
    /// It is modal no more.
    Outcome end(CompiledLine& line, const nc::ControlStatement& statement);
    /// The modal call that a block of the program which runs makes; null: none.
    const PreparedCall* acting() const;
    /// Its code; without one that which ends it.
    double code() const;
    /// Whether the words of blocks are its arguments.
    bool takes_blocks() const;
    /// The words of the block are the arguments of the modal call.
    Outcome call_with_block(CompiledLine& line);
    /// What the block makes the modal call do.
    void call_behind(const nc::Block& block, std::string_view text, std::uint64_t number);
    /// An axis of the block moves by itself, beside the path.
    void note_lone_motion() { moves_alone_ = true; }
    // A call that is due behind the block that was given last.
    bool has_due() const { return due_.has_value(); }
    void make_due(PreparedCall call) { due_ = std::move(call); }
    void drop_due() { due_.reset(); }
    /// It begins.
    Outcome begin_due();
    /// At a position of a pattern: the call, or on to the next position.
    Outcome go_on_at_positions(nc::Block& out);
    /// A return that goes elsewhere leaves the positions that are left.
    void leave_pattern_positions(RunningProgram& of);

  private:
    void call_at_positions(const nc::Block& block, const PreparedCall& active,
                           std::string_view text, std::uint64_t number);

    ProgramRun& run_;
    std::vector<std::shared_ptr<PreparedCall>> calls_;
    std::optional<PreparedCall> due_;
    bool keeps_calls_ = false;  // the block that begins one ends those of cycles
    bool moves_alone_ = false;
};

}  // namespace kadr::macro
