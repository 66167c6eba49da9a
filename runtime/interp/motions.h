// motions.h — the motions of a block: lines, arcs, involutes, threads, probing, motions to the
// reference point.
#pragma once

#include "interp/channel_state.h"
#include "interp/motion_kind.h"

namespace kadr::interp {

struct Channel;

/// The motions of a block: lines, arcs, involutes, threads, probing, motions to the reference
/// point.
class Motions {
  public:
    explicit Motions(Channel& channel);
    Motions(const Motions&) = delete;
    Motions& operator=(const Motions&) = delete;

    /// Which motion the block is, and its path.
    void move(const nc::Block& block, const Actions& actions);
    /// The tool stands at the target; its named axes were programmed.
    void arrive(const Target& target);
    /// The library's words about what was probed last. Where nobody has given where the part
    /// lies, it lies where the program expects it.
    void use_probed(const nc::Block& block, const nc::Invocation& invocation);
    /// A straight motion or one at rapid, with its checks.
    void line(const nc::Block& block, const Target& programmed, path::Op op, bool exact_stop);
    /// To a position in machine coordinates, `to` of all axes; `moved` are the ones that it names.
    void rapid_to_machine_position(const nc::Block& block, const AxisValues& to, AxisMask moved);
    /// Where the axes stand gets other machine coordinates; no axis moves. What the machine itself
    /// knows, limits and fixed points, stays where it is.
    void preset_axes(const nc::Block& block, const nc::Invocation& invocation);
    /// A call of a curve. What is wrong with it stops the program as any alarm does.
    void move_along_curve(const nc::Block& block, const nc::Invocation& call);
    /// Words of arcs that the motion does not take.
    void warn_arc_word(const nc::Block& block, nc::SlotMask words);
    /// The two axes of the working plane.
    AxisMask plane_mask() const;
    /// What the words of a block mean here.
    MotionView motion_view() const;
    /// What the words of a block mean here, with messages.
    MotionWords motion_words();

  private:
    MotionCase case_of(const nc::Block& block, const Actions& actions,
                       nc::SlotMask arc_words) const;
    void move_otherwise(const nc::Block& block, const Actions& actions, MotionKind kind,
                        nc::SlotMask arc_words);
    std::optional<Target> target_of(const nc::Block& block, const Actions& actions);
    void move_to_target(const nc::Block& block, const Actions& actions, MotionKind kind,
                        nc::SlotMask arc_words);
    void check_place(const nc::Block& block, nc::SlotMask targets);
    Target part_of_move(const Target& target, double part) const;
    Probing probe_along(const nc::Block& block, const Target& target, const ProgrammedMove& way);
    std::optional<double> touch_of_scene(const Target& target, bool springs_back);
    void note_probed(const Probing& probing);
    void move_in_machine_coordinates(const nc::Block& block);
    void refer(const nc::Block& block, const nc::Invocation& invocation);
    void return_to_reference(const nc::Block& block, const nc::Invocation& invocation);
    void check_reference(const nc::Block& block);
    void leave_reference(const nc::Block& block);
    Done increase_by_tool_offset(const nc::Block& block, double times, Target& target);
    void tap(const nc::Block& block, const Target& target);
    void thread(const nc::Block& block, const Target& target, const Actions& actions);
    Done require_thread_spindle(const nc::Block& block);
    std::optional<double> thread_change(const nc::Block& block, double pitch, double distance);
    std::optional<double> thread_pitch(const nc::Block& block, const path::Vec3& delta);
    void arc(const nc::Block& block, const Target& target, bool exact_stop);
    void put_arc(const nc::Block& block, const path::Arc& programmed, const Target& target,
                 bool exact_stop);
    void put_base_arc(const nc::Block& block, const path::Arc& arc, const Target& programmed,
                      bool exact_stop);
    void stretched_arc_about_center(const nc::Block& block, const Target& target, bool exact_stop);
    void stretched_arc(const nc::Block& block, const Target& target, bool exact_stop);
    void arc_over_point(const nc::Block& block, const Target& target, bool exact_stop);
    void arc_along(const nc::Block& block, const Target& target, bool exact_stop);
    void thread_along_arc(const nc::Block& block, const Target& target, const Actions& actions);
    std::optional<path::Arc> arc_of_thread(const nc::Block& block, const Target& target);
    std::optional<ThreadPitch> pitch_of_arc(const nc::Block& block, const path::Vec3& delta);
    void move_without_length(const nc::Block& block, const Target& target, bool exact_stop);
    void measure_length(const nc::Block& block, const nc::Invocation& invocation);
    void involute(const nc::Block& block, const Target& programmed, bool exact_stop);
    void put_involute(const nc::Block& block, const path::InvoluteWords& words, double radius,
                      const Target& target, bool exact_stop);

    Channel& channel_;
    const nc::Dialect& dialect_;
    const machine::Machine& machine_;
    const bool is_lathe_;
    const ToolOffsets& tool_offsets_;
    Reporter& reporter_;
    const nc::Rules& rules_;
    Probe& probe_;
    Modal& modal_;
    Position& position_;
    control::Frames& frames_;
    const ProgrammedSpindle& spindle_;
    const Tool& tool_;
    const Orienting& orienting_;
    const Tilting& tilted_plane_;
    const Virtual& virtual_;
    const bool& diameter_is_absolute_;
    const Corners& corners_;
    const RadiusCompState& comp_;
    const Compensation3d& comp_3d_;
    const ProgrammedUnits& units_;
    const ProgrammedDynamics& dynamics_;
    AxisMask& unplaced_;
    ReportedInRun& reported_;
    AxisData& axes_;
    const AxisValues& length_shift_;
    AxisValues& preset_;
    const ModalCycles& modal_cycles_;
    const std::optional<ShapeRun>& shape_;
};

}  // namespace kadr::interp
