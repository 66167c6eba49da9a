// cycles.h — machining cycles: calls, the blocks of the one that runs, and the positions of a
// pattern.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// Machining cycles: calls, the blocks of the one that runs, and the positions of a pattern.
class Cycles {
  public:
    explicit Cycles(Channel& channel);
    Cycles(const Cycles&) = delete;
    Cycles& operator=(const Cycles&) = delete;

    /// No cycle is repeated any more.
    void end_modal() { modal_cycles_.modal.is_active = false; }
    /// This call is the one that counts.
    void make_modal(const ModalCycle& call) { modal_cycles_.modal = call; }
    /// A motion code ends the modal cycle, and rigid tapping with it.
    void end_by_motion_code() {
        taps_rigidly_ &= !modal_cycles_.modal.is_active;
        end_modal();
    }
    /// No cycle is repeated, and none taps rigidly.
    void cancel() {
        end_modal();
        taps_rigidly_ = false;
    }
    void tap_rigidly() { taps_rigidly_ = true; }
    /// Every motion from here on is followed by the call in this block; null: none is.
    void call_behind_motions(const nc::Block* block) {
        modal_cycles_.behind_motions.reset();
        if (block != nullptr) modal_cycles_.behind_motions = *block;
    }
    /// Along another tool axis the initial level is where the tool stands.
    void begin_level_here();
    void return_to_retract(bool is_wanted) { modal_cycles_.returns_to_retract = is_wanted; }

    /// Whether a program runs that is called at a position.
    bool is_at_pattern_position() const;
    /// It has ended: the next position comes.
    void leave_pattern_position();
    /// The program leaves the pattern before its last position.
    void leave_pattern();
    /// Here, or at every position from here on where it is modal.
    void call_cycle(const nc::Block& block, const Actions& actions);
    /// Keeps parameters for the calls that follow; each line gives all of its own anew.
    void preset_cycle(const nc::Block& block, const nc::Invocation& invocation);
    /// The cycle that was defined last, with the parameters of its definition.
    void call_defined(const nc::Block& block);
    /// At the position that the block names.
    void repeat_cycle(const nc::Block& block, const Actions& actions);
    /// The cycle that is called wherever an axis has moved; its location is the motion's.
    void call_behind_motion(const nc::Block& block);
    /// The motion code behind a cycle ended it; what was its depth is the position of the tool
    /// axis.
    void move_instead_of_cycle(const nc::Block& block, const Actions& actions);
    /// Moves to the position in the plane and opens the stream of the cycle's blocks.
    void start_cycle(const nc::Block& block, ModalCycle call, const CycleShape* shape = nullptr);
    /// The level of a cycle is a word of the plane's normal; in another plane than X-Y its word of
    /// Z is a position.
    const nc::Block& with_depth_apart(const nc::Block& block);
    /// What acted before it acts again; what its caller does behind its motion is due.
    void finish_cycle();
    /// null: the pattern has no more positions
    void go_to_position(const nc::Block* position);
    /// A code of a single motion is executed in the mode of a cycle to an end in X and Z; what the
    /// calls before have given of the end holds no longer.
    void forget_ends();
    /// Whether a modal cycle acts among whose positions no other motion stands.
    bool is_among_positions() const;
    /// A block that goes to a machine coordinate or probes stands in no cycle. Behind a single
    /// cycle to an end in X and Z the travel to a machine coordinate is a motion of its own.
    Done require_no_cycle(const nc::Block& block, const Actions& actions);
    /// Cycles are written for the plane X-Y with the tool axis Z; in another plane the words belong
    /// to its first axis, its second axis and its tool axis.
    const nc::Block& in_plane_of_cycle(const nc::Block& block);

  private:
    /// Blocks of a cycle are under absolute dimensions, and begin at rapid.
    void begin_blocks();
    void take_back(const Modal& modal) { modal_ = modal; }
    void complete_call(ModalCycle& call) const;
    void take_letter(const nc::Block& block, ModalCycle& call) const;
    bool is_modal(nc::CycleId cycle) const;
    bool count_times(const CycleWords& words);
    void keep_words(const CycleWords& words);
    void keep_call(const ModalCycle& call);
    void keep_levels(const nc::Block& block);
    void warn_levels(const nc::Block& block);
    control::CycleLevel depth_now(double value) const;
    control::CycleLevel retract_now(double value) const;
    void complete_words(ModalCycle& call);
    void go_straight(ModalCycle& call);
    Done time_turns(const nc::Block& block, ModalCycle& call);
    void take_off_scale(ModalCycle& call);
    Done complete_tap(const nc::Block& block, ModalCycle& call);
    Done complete_thread(const nc::Block& block, ModalCycle& call);
    void open_cycle(const nc::Block& block, std::unique_ptr<Stream<nc::Block>> blocks);
    Done require_no_refusal(const nc::Block& block);
    void refuse_cycle(const nc::Block& block, std::string_view words);
    Done require_surroundings(const nc::Block& block, const ModalCycle& call);
    Done require_whole_counts(const nc::Block& block, const ModalCycle& call);
    Done require_words_of_cycle(const nc::Block& block, const Actions& actions);
    void complete_surroundings(ModalCycle& call, bool calls_program) const;
    void begin_pattern(const nc::Block& block, std::unique_ptr<Stream<nc::Block>> places);
    void finish_pattern();
    bool calls_program_at(const nc::Block& block) const;
    void return_to_level();
    void take_ends(const nc::Block& block, ModalCycle& call) const;
    void complete_ends(ModalCycle& call) const;
    void end_where_tool_stands(ModalCycle& call) const;
    path::Plane cycle_plane() const;
    AxisValues position_in_cycle() const;

    Channel& channel_;
    const nc::Dialect& dialect_;
    const bool is_lathe_;
    const ToolOffsets& tool_offsets_;
    CycleExpander* cycles_;
    Reporter& reporter_;
    const nc::Rules& rules_;
    Modal& modal_;
    Position& position_;
    control::Frames& frames_;
    const ProgrammedSpindle& spindle_;
    const Tool& tool_;
    PositionWords& position_words_;
    const Corners& corners_;
    const RadiusCompState& comp_;
    bool& taps_rigidly_;
    AxisData& axes_;
    ModalCycles& modal_cycles_;
    CycleRun& cycle_;
    const std::optional<ShapeRun>& shape_;
    std::vector<PatternRun>& patterns_;
    Callers& callers_;
    nc::Block place_{};   // of the pattern, at its caller's location
    nc::Block called_{};  // a call whose word of Z is a position, in another plane than X-Y
};

}  // namespace kadr::interp
