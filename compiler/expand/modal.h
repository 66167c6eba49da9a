// modal.h — what the expander knows of the control's state behind the blocks that it has made.
//
// Only what the language needs: members of the modal groups for `with` and `preserves`, F and S,
// the programmed position for `position.x`, the programmable frame.
#pragma once

#include <array>

#include "base/axes.h"
#include "control/frame_steps.h"
#include "control/program_frame.h"
#include "expand/reported_in_program.h"
#include "nc/block.h"
#include "nc/effects.h"
#include "sema/code.h"

namespace kadr::expand {

/// What has made modal state unknown.
enum class Loss : std::uint8_t { RawText, SkippedBlock, EndOfWith, Control };

/// … and by which statement.
struct LostBy {
    SourceId statement;
    Loss how = Loss::Control;  // Control: it alone knows what its block has done
};

/// Position less the coordinate that was programmed last: what changes of the frame have made of it
/// since. Some controls travel it with the next increment. mm.
struct Drift {
    AxisValues by{};
    AxisMask has = 0;   // axes of which it is not 0
    AxisMask lost = 0;  // … and of which it is not known

    void add(std::size_t axis, double distance);
    void lose(AxisMask axes) { lost |= axes; }
    /// The tool is where only the control knows.
    void lose_all() { lost |= has; }
    /// Coordinates of these axes were named: increments count from there.
    void forget(AxisMask axes);
    AxisMask acts() const { return has | lost; }
};

/// What is known of the tool's length beside the member of its group.
struct KnownLength {
    std::optional<double> offset;  // of LengthCompOn, where it has one
    bool is_away = false;          // its axis is at a point of the machine that no length shifts
    bool has_ended = false;        // `D0` of a source that counts edges is in the text
};

struct ModalState {
    std::array<nc::Function, nc::kGroups> active{};  // None: not known
    std::array<SourceId, nc::kGroups> changed_by{};  // statement behind the present member
    double work_offset = 0;                          // parameter of WorkOffset
    KnownLength length;
    double master_spindle = 1;  // whose sense M3, M4 and M5 are; 0: nobody knows
    bool has_feed = false;
    bool has_speed = false;
    bool had_cutting_speed = false;  // S has been programmed under constant cutting speed
    bool is_feed_lost = false;       // it was given, and then the feed mode changed
    double feed = 0;                 // as in Block
    double speed = 0;
    bool has_tool = false;
    bool lacks_tool = true;  // none was called, and no text of unknown meaning stood there
    double tool = 0;         // that was called last
    bool has_tool_in = false;
    double tool_in = 0;                            // that was changed in last
    AxisValues position{};                         // in the programmable frame, mm, degrees
    AxisMask known = 0;                            // which of them are known
    std::array<LostBy, kAxes> position_lost_by{};  // holds if it was known before
    Drift drift;                                   // from what is programmed …
    Drift text_drift;              // … and from what its text has, which names more
    AxisMask named_by_text = 0;    // axes of the block that is made, not programmed
    bool is_position_due = false;  // the frame has changed since a block was made
    AxisMask unplaced = 0;         // of which no position was named since a rotation began or ended
    bool owes_incremental = false;  // the text is under absolute dimensions for one block
    bool is_diameter = false;       // words of X
    control::ProgramFrame frame;
    bool is_stretched = false;          // the frame makes ellipses of the circles of some plane
    control::FrameSteps steps;          // of the program, that make the frame …
    control::FrameSteps written_steps;  // … and of its text
    control::FrameFormFault frame_fault =
        control::FrameFormFault::None;  // no frame is what they make
    /// A tilted plane that acts: of the control, which has frames in it (Own) or none (Closed), or
    /// a frame that stands for it.
    enum class PlaneTilt : std::uint8_t { None, Own, Closed, Resolved };
    PlaneTilt tilt = PlaneTilt::None;
    control::ProgramFrame tilted_plane_frame;  // Resolved: the frame that is the plane
    /// Tool centre point control: by functions of its own, or as a kind of tool length.
    enum class Tcp : std::uint8_t { Off, Own, Length };
    Tcp tcp = Tcp::Off;
    double tcp_offset = 0;  // Length: number of the offset
    nc::Function before_tcp = nc::Function::LengthCompOff;
    bool is_inclined = false;  // the tool has been inclined away from Z under it
    bool is_turned = false;    // rotary axes may stand elsewhere than at 0
    SourceId frame_by;
    SourceId feed_by;
    SourceId speed_by;
    bool restate_motion = false;  // after a native cycle
    int due_offset = 0;  // of the control of a source, to be programmed before the first move
    // Under which cutter radius compensation the tool moved in the plane last; None: not known.
    nc::Function moved_under = nc::Function::RadiusCompOff;
    // … and whether it compensates at all is the operator's choice: the level of the blocks that he
    // may leave out, and what acts if he does.
    int comp_choice = kNoChoice;
    nc::Function comp_without = nc::Function::RadiusCompOff;
    SourceId comp_by;
    static constexpr int kNoChoice = -1;
    static constexpr int kSeveralLevels = -2;
    nc::Function diameter_due = nc::Function::None;  // what X is; the text does not have it yet
    bool is_edge_off = false;      // `D0` of a source that counts edges: no tool length
    bool is_feed_deleted = false;  // by a feed mode of a source whose control does that
    sema::ModalMask lost = 0;      // what something has made unknown: it must be programmed again
    SourceId lost_by;              // statement that did so last
    Loss lost_in = Loss::RawText;
    sema::ModalMask restate = 0;    // set by a block that may be left out: written again
    bool spindle_in_doubt = false;  // likewise, but the operator's choice
    bool lacks_speed = true;     // no S was programmed, and no text of unknown meaning stood there
    ReportedInProgram reported;  // of this state; a change of it renews that
    bool has_ended = false;      // behind M30
    SourceId ended_by;

    nc::Function operator[](nc::Group group) const {
        return active[static_cast<std::size_t>(group)];
    }

    /// A member that acts without a block of its own that programs it.
    void assume(nc::Group group, nc::Function member) {
        active[static_cast<std::size_t>(group)] = member;
    }
    /// … because of a statement, which `by` is: whatever was unknown before it.
    void assume(nc::Group group, nc::Function member, SourceId by) {
        assume(group, member);
        changed_by[static_cast<std::size_t>(group)] = by;
        lost &= ~sema::group_bit(group);
    }
    /// The state in which every Kadr program begins.
    static ModalState at_start(const sema::FunctionCode& entry);
    /// What the functions of a block do before it moves.
    ///
    /// target  the control for which the program is written: some of its customs the text has
    /// Returns whether something of it comes true behind the motion only: `take_behind` is due.
    bool take_functions(const nc::Block& block, const nc::Rules& target);
    /// … then its words …
    void take_words(const nc::Block& block);
    /// … and what is so behind its motion, by the functions that the block has then: a return to
    /// the reference point may have become another one.
    void take_behind(const nc::Block& block, const nc::Rules& target);
    /// All of that.
    void take_block(const nc::Block& block, const nc::Rules& target);
    nc::Changer changer() const;
    /// Whether the spindle turns, as far as the program is known.
    bool is_spindle_turning() const {
        const nc::Function spindle = (*this)[nc::Group::Spindle];
        const bool is_on = spindle == nc::Function::SpindleCw ||
                           spindle == nc::Function::SpindleCcw || spindle == nc::Function::None;
        return is_on && !lacks_speed && !(has_speed && speed == 0);
    }
    /// Whether a motion in the plane begins or ends cutter radius compensation.
    bool is_compensation_due() const {
        const nc::Function wanted = (*this)[nc::Group::RadiusComp];
        return moved_under != nc::Function::None && wanted != nc::Function::None &&
               nc::has_fact(moved_under, nc::Fact::CompSide) !=
                   nc::has_fact(wanted, nc::Fact::CompSide);
    }
    void switch_spindle(nc::Function member, SourceId source);
    /// Positions that were known before the statement and are not any more.
    void note_lost_positions(AxisMask before, SourceId by, Loss how);
    /// Text of unknown meaning: nothing is known any more.
    void forget(SourceId source);
    /// Behind a `with` that set the first F: what held before it was none.
    void forget_feed(SourceId source);
    /// Keeps what is so whether the operator lets a block run, as it did here, or leaves it out.
    ///
    /// without  the state before it. What the writer writes again by itself is as the block has it
    void join(const ModalState& without, SourceId block);
    void set_frame(const control::ProgramFrame& frame, SourceId source);
    /// The frame, as blocks have programmed it anew.
    void put_frame(const control::ProgramFrame& frame, SourceId source);
    /// Of the program and of its text alike.
    void forget_drift(AxisMask axes);
    void lose_drift(AxisMask axes);
    void lose_all_drift();
    /// Axes whose words a block may have to give otherwise than the program does.
    AxisMask adapts() const { return drift.acts() | text_drift.acts() | unplaced; }
    /// 3, 4, 5 as in M3, M4, M5.
    void turn_spindle(const nc::Block& block, const nc::Effect& effect);
    void lose_spindle(SourceId source);
    void take_speed(double value, const nc::Block& block);
    void take_numbered_speed(const nc::Block& block, const nc::Effect& effect);
    void take_length_offset(const nc::Block& block, const nc::Effect& effect);
    void set_spindle(double code, SourceId source);

  private:
    void take(const nc::Block& block, const nc::Effect& effect, const nc::Rules& target);
    void take_at(nc::When when, const nc::Block& block, const nc::Rules& target,
                 const nc::Effects& effects);
    void set_member(const nc::Block& block, const nc::Effect& effect);
    template <typename Change>
    void change_steps(SourceId source, Change change);
    void scale(const nc::FrameChange& change, SourceId source);
    void rotate(const nc::FrameChange& change, SourceId source, const nc::Rules& target);
    void name_position(const nc::FrameChange& change);
    void frame_from_steps(SourceId source);
    void take_targets(const nc::Block& block);
    void select_work_offset(double number);
    void write_offset(const nc::Block& block, const nc::Effect& effect);
    void lose_system();
    void lose_axes(AxisMask axes);
    void lose_words(const nc::Block& block, const nc::Effect& effect);
    void go_to_point(const nc::Block& block, const nc::Effect& effect);
    void change_tool(const nc::Block& block, const nc::Rules& target);
    void set_diameter(bool is_on, bool was_known);
    void note_rotary(const nc::Block& block);
    void join_group(nc::Group group, SourceId block);
    void lose_to_choice(sema::ModalMask what, SourceId block);
    void choose_compensation(nc::Function side, int skip_level, SourceId source);
    void lose_corrected(double axis);
    void note_drift(std::size_t axis, bool is_known, double by);
};

/// Groups of the mask whose state differs, F and S and frames included.
sema::ModalMask difference(const ModalState& a, const ModalState& b, sema::ModalMask mask);

}  // namespace kadr::expand
