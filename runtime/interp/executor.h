// executor.h — executes blocks one by one and puts commands out. Internal to interp.
//
// What a block does is told in chapters: executor.cpp (the order of things in a block, its single
// functions), power_on.cpp (how the control begins), plain_moves.cpp (what nearly every block is),
// motion.cpp (targets, lines, arcs, tool length, limits), circles.cpp and angles.cpp
// (what controls work out of other words), orienting.cpp, tool_words.cpp and tool_orientation.cpp
// (the machine's transformation, and how the tool turns under it), tilted_planes.cpp and
// swivelling.cpp (tilted planes), carrier_words.cpp (tool carriers that are turned),
// virtual_axes.cpp (faces and cylinders), cornering.cpp and compensating.cpp (what the commands
// pass through), approach_moves.cpp (soft approaches and retracts), smoothing.cpp (rounded corners,
// compressed lines), cycles.cpp (machining cycles), patterns.cpp (places at which a cycle is
// called), feed_words.cpp (feeds), shapes.cpp (cycles along a shape
// that stands in the program), contours.cpp (contours that become tables), splines.cpp,
// through_splines.cpp, spline_neighbours.cpp, polynomials.cpp, involutes.cpp and curves.cpp (other
// curves), arc_threads.cpp (threads along arcs), numbered_spindles.cpp (several spindles),
// rare_words.cpp and data_input.cpp (rarer words), dangers.cpp (what no control minds and no
// spindle stands).
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/done.h"
#include "control/frames.h"
#include "interp/axis_data.h"
#include "interp/block_actions.h"
#include "interp/block_queue.h"
#include "interp/compensation.h"
#include "interp/contour_run.h"
#include "interp/corners.h"
#include "interp/cycle_run.h"
#include "interp/dangers.h"
#include "interp/interpreter.h"
#include "interp/motion_words.h"
#include "interp/output.h"
#include "interp/position_words.h"
#include "interp/probe.h"
#include "interp/program_clocks.h"
#include "interp/programmed_dynamics.h"
#include "interp/reported_in_run.h"
#include "interp/reporter.h"
#include "interp/shape_run.h"
#include "interp/smooth_approach.h"
#include "interp/snapshot.h"
#include "interp/spline_commands.h"
#include "interp/state.h"
#include "interp/through_run.h"
#include "interp/tool_carrier.h"
#include "interp/tool_names.h"
#include "interp/tool_offsets.h"
#include "interp/work_area.h"
#include "machine/orientation.h"
#include "machine/path_choice.h"
#include "nc/effects.h"
#include "nc/rules.h"
#include "path/arc.h"
#include "path/curve.h"
#include "path/involute.h"
#include "path/orient_law.h"

namespace kadr::interp {

constexpr CornerSettings corner_settings(const nc::Rules& rules) {
    return {rules.corner_strict, rules.corner_feed_of_next, rules.corner_empty_blocks};
}

class Executor {
  public:
    Executor(const nc::Dialect& dialect, const machine::Machine& machine, Stream<nc::Block>& blocks,
             const nc::BlockLocations* places, CycleExpander* cycles,
             const InterpreterOptions& options, DiagnosticSink& sink);

    std::size_t pull(std::span<path::Command> out);
    std::vector<ProbeTouch> touches_ahead() const { return probe_.touches_ahead(); }
    bool alarmed() const { return reporter_.has_alarm(); }
    std::uint64_t blocks() const { return block_count_; }
    /// Whether a motion that is out may have a course of its feed to be worked out.
    bool has_feed_characteristic() const { return dynamics_.has_feed_characteristic(); }
    void report_varying_feed(const path::Command& command, double feed);  // feed_words.cpp
    std::vector<StateItem> state() const;                                 // describe.cpp
    const AxisValues& position() const { return position_.here; }
    Snapshot snapshot() const;  // snapshot.cpp

    // answers.cpp: what a program asks while it runs
    double elapsed() { return run_time(); }
    std::optional<double> quantity(nc::Quantity quantity, std::int64_t first, std::int64_t second);
    ControlAccess::Write set_quantity(nc::Quantity quantity, std::int64_t first,
                                      std::int64_t second, double value,
                                      bool acts_at_once);  // offsets.cpp
    // frame_variables.cpp
    control::ControlFrame total_frame() const;
    std::optional<control::ControlFrame> frame(nc::Quantity quantity, std::int64_t number);
    ControlAccess::Write set_frame(nc::Quantity quantity, std::int64_t number,
                                   const control::ControlFrame& frame, bool acts_at_once);
    void keep_frames() { kept_frames_.push_back({frames_, work_offset_}); }
    void restore_frames(bool is_wanted);
    // answers.cpp
    bool is_length(std::int64_t axis) const;
    std::optional<std::string> text(nc::Quantity quantity, std::int64_t index);
    ControlAccess::Write set_text(nc::Quantity quantity, std::int64_t index, std::string_view text);
    std::optional<std::int64_t> axis_number(Axis axis) const;
    bool has_spindle(std::int64_t number) const;  // numbered_spindles.cpp; 0 is the master
    double word_factor(std::int64_t axis) const;
    bool is_compensated() const { return is_any_comp_on() || smooth_approach_.is_active(); }
    std::string_view begin_contour();  // contours.cpp
    std::optional<ContourElements> end_contour();
    bool is_at_pattern_position() const;
    void leave_pattern_position();
    void leave_pattern();

  private:
    std::optional<Axis> axis_of(std::int64_t index) const;
    std::optional<double> place_of(nc::Quantity quantity, Axis axis) const;
    double place_within(const control::ControlFrame& frame, Axis axis) const;
    double mirrored_axes() const;
    // frame_variables.cpp
    bool set_plain_frame(nc::Quantity quantity, const control::ControlFrame& frame);
    void select_stored_bases();
    ControlAccess::Write set_base_mask(nc::Quantity quantity, double mask);
    // answers.cpp
    std::optional<double> clock(nc::Quantity quantity);
    std::optional<double> calendar(nc::Quantity quantity);
    std::optional<double> tool_datum(std::int64_t number) const;
    ControlAccess::Write set_extra(nc::Quantity quantity, std::int64_t first, double value);
    bool has_edge(std::int64_t tool, std::int64_t edge) const;
    ControlAccess::Write set_edge_offset(nc::Quantity quantity, std::int64_t tool,
                                         std::int64_t edge, double value);
    ControlAccess::Write set_active_datum(std::int64_t datum, double value);
    bool set_tool_datum(std::int64_t number, std::int64_t datum_and_edge, double value);
    double timer(std::int64_t number);
    void set_timer(std::int64_t number, double value);
    void count_time();
    double run_time();
    // offsets.cpp: what a program writes
    void write_data(const nc::Block& block, const nc::Invocation& invocation);
    void write_work_offset(const nc::Block& block, const nc::Invocation& invocation);
    void write_tool_offset(const nc::Block& block, const nc::Invocation& invocation);
    void write_lathe_offset(const nc::Block& block, const nc::Invocation& invocation);
    void put_tool_offset(const nc::Block& block, const nc::Invocation& invocation,
                         ToolOffsets::Column column, double value);
    control::ControlFrame work_offset_frame(std::int64_t number) const;
    control::ControlFrame& work_offset_at(std::int64_t number);
    void work_offset_changed(std::int64_t number, bool acts_at_once);
    ControlAccess::Write set_edge_speed(double value);
    ControlAccess::Write set_work_offset(std::int64_t number, Axis axis, double value,
                                         bool acts_at_once);
    ControlAccess::Write set_tool_offset(ToolOffsets::Column column, std::int64_t number,
                                         double value);
    // power_on.cpp
    void power_on();
    void begin_with(nc::Function function);

    // executor.cpp: the order of things
    void execute_next();
    bool acts(const nc::Block& block) const;
    void execute(const nc::Block& block);
    void run(const nc::Block& block);
    void run_functions(const nc::Block& block);
    void end_of_blocks();
    void end_where_stopped();
    Actions apply_functions(const nc::Block& block);
    nc::Changer changer() const { return is_lathe_ ? nc::Changer::Turret : nc::Changer::Magazine; }
    Done require_allowed(const nc::Block& block, nc::Function function);
    void apply(const nc::Block& block, const nc::Effect& effect, Actions& actions);
    void apply_own(const nc::Block& block, const nc::Invocation& invocation, Actions& actions);
    void set_member(const nc::Block& block, const nc::Effect& effect, Actions& actions);
    template <typename Choose>
    void choose_of_comp(Actions& actions, Choose choose);
    void set_diameter(const nc::Block& block, nc::Function member);
    void switch_tcp(const nc::Block& block, const nc::Invocation& invocation, Actions& actions);
    void select_tool(const nc::Block& block, const nc::Invocation& invocation, Actions& actions);
    void select_edge(const nc::Block& block, const nc::Invocation& invocation, Actions& actions);
    void change_length(const nc::Block& block, const nc::Invocation& invocation, Actions& actions);
    void act_before_motion(const nc::Block& block, const Actions& actions);
    void act_after_motion(const nc::Block& block, const Actions& actions);

    // executor.cpp: single functions
    void dwell(const nc::Block& block, const nc::Invocation& invocation);
    void select_feed_mode(nc::Function member);
    void set_feed(const nc::Block& block);
    void program_speed(const nc::Block& block);
    void leave_cutting_speed();
    void limit_speed(const nc::Block& block, nc::Function function, double limit);
    void bound_speed(const nc::Block& block, nc::Function function, bool is_upper, double bound);
    SpeedLimits speed_limits() const;
    void put_speed_limits(const nc::Block& block, const SpeedLimits& before);
    double highest_speed() const;
    double bounded_speed(const nc::Block& block);
    double turning_speed() const;
    void set_area_limit(const nc::Block& block, const nc::Invocation& invocation);
    void update_spindle(const nc::Block& block);
    void orient_spindle(const nc::Block& block, const nc::Invocation& invocation);
    void check_edge_turns(const nc::Block& block);
    void stand_spindle(const nc::Block& block, nc::Function function, double angle, bool is_by);
    // numbered_spindles.cpp
    void set_up_spindles();
    const Spindle* spindle_at(std::int64_t number) const;
    template <typename Act>
    void with_spindle(const nc::Block& block, const nc::Invocation& invocation, Act act);
    path::Command& put_spindle(const nc::Block& block);
    std::uint8_t shown_number() const;
    void select_master(const nc::Block& block, const nc::Invocation& invocation);
    void act_on_spindle(const nc::Block& block, const nc::Invocation& invocation);
    void update_other_spindles(const nc::Block& block);
    void dwell_by_spindle(const nc::Block& block, const nc::Invocation& invocation);
    void stop_spindle_and_coolant(const nc::Block& block, const Actions& actions);
    void set_coolant(const nc::Block& block, path::CoolantMode mode);
    void set_length_source(Tool::Source source, Actions& actions);
    std::int64_t tool_number(const nc::Block& block, const nc::Invocation& invocation);
    std::int64_t named_tool(const nc::Block& block);
    void take_edge(const nc::Block& block);
    void check_edge(const nc::Block& block);
    void choose_sum_offset(const nc::Block& block, const nc::Invocation& invocation,
                           Actions& actions);
    double sum_offset(std::size_t part) const;
    void change_tool(const nc::Block& block);
    void select_work_offset(const nc::Block& block, std::int64_t number);
    void change_plane(const nc::Block& block, nc::Function plane);
    bool needs_comp_off(const nc::Block& block, nc::Function function) const;
    bool is_too_late(nc::Function function) const;
    bool is_other_plane(nc::Function function) const;
    void change_frame(const nc::Block& block, const nc::Invocation& invocation,
                      void (control::Frames::*change)(const control::FrameWords&));
    void let_comp_go(const nc::Block& block, const nc::Invocation& invocation);
    control::FrameWords words_of_frame(const nc::Block& block,
                                       const nc::Invocation& invocation) const;
    Done require_no_places(const nc::Block& block, const nc::Invocation& invocation);
    void set_position(const nc::Block& block, const nc::Invocation& invocation);
    void reset_position(const nc::Block& block, const nc::Invocation& invocation);
    void name_position(const control::FrameWords& words);
    void rotate(const nc::Block& block, const nc::Invocation& invocation);
    void end_rotation();
    void end_scaling();
    void end_mirroring(const nc::Block& block, const nc::Invocation& invocation);
    Done require_named_axes(const nc::Block& block, const nc::Invocation& invocation,
                            AxisMask named);
    control::FrameWords center_of(const nc::Block& block, const nc::Invocation& invocation) const;
    void scale(const nc::Block& block, const nc::Invocation& invocation);
    void rotate_in_space(const nc::Block& block, const nc::Invocation& invocation);
    /// M functions that take the machine time, at one side of the block's motion.
    enum class Side : std::uint8_t { Before, Behind };
    bool is_awaited(const nc::Block& block, const nc::Invocation& invocation) const;
    void issue_functions(const nc::Block& block, const Actions& actions, Side side);
    bool has_changed(std::int64_t code, const Actions& actions) const;
    void pass_machine_function(const nc::Block& block, std::int64_t number);

    // plain_moves.cpp
    enum class Plainly : std::uint8_t { NotPlain, Executed };
    Plainly move_plainly(const nc::Block& block);
    bool is_plain_block(const nc::Block& block) const;
    bool is_plain_state() const;

    // motion.cpp
    void move_with_own_feed(const nc::Block& places, const Actions& actions);
    void move(const nc::Block& block, const Actions& actions);
    void check_place(const nc::Block& block, nc::SlotMask targets);
    void arrive(const Target& target);
    // probing.cpp
    Target part_of_move(const Target& target, double part) const;
    Probing probe_along(const nc::Block& block, const Target& target, const ProgrammedMove& way);
    std::optional<double> touch_of_scene(const Target& target, bool springs_back);
    void note_probed(const Probing& probing);
    void use_probed(const nc::Block& block, const nc::Invocation& invocation);
    void line(const nc::Block& block, const Target& programmed, path::Op op, bool exact_stop);
    bool is_without_frames(const Actions& actions) const;
    Done take_frames_off(const nc::Block& block);
    void put_frames_back(const nc::Block& block);
    void move_in_machine_coordinates(const nc::Block& block);
    void rapid_to_machine_position(const nc::Block& block, const AxisValues& to, AxisMask moved);
    void refer(const nc::Block& block, const nc::Invocation& invocation);
    void return_to_reference(const nc::Block& block, const nc::Invocation& invocation);
    void check_reference(const nc::Block& block);
    void leave_reference(const nc::Block& block);
    Done increase_by_tool_offset(const nc::Block& block, double times, Target& target);
    void tap(const nc::Block& block, const Target& target);
    void thread(const nc::Block& block, const Target& target, const Actions& actions);
    Done require_thread_spindle(const nc::Block& block);
    std::optional<double> thread_change(const nc::Block& block, double pitch, double way);
    std::optional<double> thread_pitch(const nc::Block& block, const path::Vec3& way);
    Axis wanted_length_axis() const;
    path::Vec3 wanted_lengths() const;
    void check_length_known(const nc::Block& block);
    path::Vec3 activate_length(const nc::Block& block, AxisMask moved);
    Done activate_length_on_arc(const nc::Block& block, const path::Vec3& normal, AxisMask moved);
    void move_length_alone(const nc::Block& block);
    void move_behind_switch(const nc::Block& block);
    void arc(const nc::Block& block, const Target& target, bool exact_stop);
    void put_arc(const nc::Block& block, const path::Arc& programmed, const Target& target,
                 bool exact_stop);
    void put_base_arc(const nc::Block& block, const path::Arc& arc, const Target& programmed,
                      bool exact_stop);
    void stretched_arc_about_center(const nc::Block& block, const Target& target, bool exact_stop);
    void stretched_arc(const nc::Block& block, const Target& target, bool exact_stop);
    // circles.cpp
    void arc_over_point(const nc::Block& block, const Target& target, bool exact_stop);
    void arc_along(const nc::Block& block, const Target& target, bool exact_stop);

    // orienting.cpp: the machine's transformation
    Done require_transformation(const nc::Block& block, const nc::Invocation& invocation);
    void switch_transformation(const nc::Block& block, const nc::Invocation& invocation);
    std::array<std::size_t, 2> joints_in_order() const;
    Done require_axes_for_direction(const nc::Block& block);
    Done require_no_spline(const nc::Block& block, nc::Function function);
    Done require_no_lone_axis(const nc::Block& block, nc::SlotMask targets);
    void begin_length_transformation(const nc::Block& block, const nc::Invocation& invocation,
                                     Actions& actions);
    void end_length_transformation(Actions& actions);
    void check_offset_programmed(const nc::Block& block);
    Done require_allowed_under_tcp(const nc::Block& block, nc::Function function);
    path::Vec3 joints_of(const AxisValues& base) const;
    AxisMask joint_axes() const;
    AxisValues machine_axes() const;
    AxisValues machine_axes_at(const AxisValues& base) const;

    // tool_words.cpp: what a block says of the tool
    void take_orientation(const nc::Block& block, const nc::Invocation& invocation,
                          Actions& actions);
    void take_lead_tilt(const nc::Block& block, const nc::Invocation& invocation, ToolWords& tool);
    void take_opening(const nc::Block& block, const nc::Invocation& invocation, ToolWords& tool);
    Done require_one_turn(const nc::Block& block, const ToolWords& tool);
    Done require_no_idle_words(const nc::Block& block, const ToolWords& tool);
    bool keeps_lead_tilt_to_surface() const;
    bool is_led_by_surface(const ToolWords& tool) const;
    machine::Mat3 rotation_by_angles(const path::Vec3& angles_deg) const;
    machine::Mat3 turn_into_base() const;
    bool mirrors_words() const;
    std::optional<path::Vec3> direction_in_base(const nc::Block& block, const path::Vec3& said,
                                                nc::Function word);
    std::optional<path::Vec3> wanted_direction(const nc::Block& block, const ToolWords& tool);

    // tool_orientation.cpp: how the tool turns
    Done orient(const nc::Block& block, const Actions& actions, Target& target);
    Done lay_tool_words(const nc::Block& block, const ToolWords& tool, Target& target);
    void settle_orientation(const Target& target);
    Done orient_by_axes(const nc::Block& block, Target& target);
    Done orient_to(const nc::Block& block, const ToolWords& tool, const path::Vec3& to,
                   Target& target);
    Done lay_orientation(const nc::Block& block, const path::Vec3& to, Target& target,
                         const ToolWords* angles = nullptr);
    Done lay_cone(const nc::Block& block, const ToolWords& tool, const path::Vec3& to,
                  Target& target);
    std::optional<machine::OrientationArc> cone_to(const nc::Block& block, const ToolWords& tool,
                                                   const path::Vec3& from, const path::Vec3& to);
    Done follow_directions(const nc::Block& block, const path::Turn& turn, const path::Curve& curve,
                           Target& target);
    Done lay_directions(const nc::Block& block, const path::Curve& curve, Target& target);
    Done apply_lead_tilt_at_end(const nc::Block& block, const ToolWords& tool,
                                const path::Curve& curve, Target& target);
    std::optional<path::Vec3> direction_on_surface(const nc::Block& block, const path::Vec3& normal,
                                                   const path::Vec3& tangent,
                                                   const path::Lean& lean);
    Done require_small_rise(const nc::Block& block, double rise);
    Done require_small_rise_along(const nc::Block& block, const path::Turn& surface,
                                  const path::Curve& curve);
    bool surface_leads_end() const;
    std::optional<std::array<path::Vec3, 2>> normals_of(const nc::Block& block,
                                                        const ToolWords& tool);
    Done lead_by_surface(const nc::Block& block, const ToolWords& tool, const path::Curve& curve,
                         Target& target);
    Done lead_by_point(const nc::Block& block, const ToolWords& tool, const path::Curve& curve,
                       Target& target);
    Done orient_first(const nc::Block& block, const path::Vec3& to);
    bool spins_with_path(const ToolWords& tool) const;
    std::optional<path::Vec3> spin_reference(const path::Vec3& tool,
                                             const path::Curve* curve) const;
    Done lay_spin(const nc::Block& block, const ToolWords& tool, Target& target,
                  const path::Curve* curve = nullptr);
    void reset_orientation(const nc::Block& block, const nc::Invocation& invocation);
    machine::Mat3 base_rotation() const;
    machine::JointLimits joint_limits() const;
    void put_joints(const path::Vec3& joints, Target& target) const;
    void report_no_solution(const nc::Block& block, const machine::PathRefusal& refusal);
    void put_orientation(path::Command& command);
    machine::PathQuery query_to(const path::Vec3& to, const ToolWords* angles) const;
    // point_to_point.cpp: … where the axes go straight
    bool goes_straight(path::Op op) const;
    bool goes_straight(const nc::Block& block, const Actions& actions) const;
    Done require_point_to_point_way(const nc::Block& block, const Actions& actions);
    void choose_axes(const nc::Block& block, const nc::Invocation& invocation, ToolWords& tool);
    machine::JointLimits signed_limits(const ToolWords& tool) const;
    Done lay_point_to_point(const nc::Block& block, const ToolWords& tool, Target& target);
    Done stand_along(const nc::Block& block, const ToolWords& tool, const path::Vec3& to,
                     Target& target);
    Done turn_by_signs(const nc::Block& block, const ToolWords& tool, Target& target);
    // spline_orientation.cpp: … along splines and polynomials
    Done require_orientation_along(const nc::Block& block, const ToolWords& tool);
    Done orient_control_point(const nc::Block& block, const ToolWords& tool,
                              ControlPointBlock& pole);
    Done turn_along(const nc::Block& at, const ControlPointBlock& said, const path::Curve& span,
                    AxisValues& to);
    Done lay_span_orientation(const nc::Block& at, const ControlPointBlock& said,
                              const path::Curve& span, Target& target);
    Done share_orientation(const nc::Block& block, const ToolWords& tool,
                           const std::vector<double>& shares,
                           const std::vector<ControlPointBlock*>& pieces);
    // tilted_planes.cpp: tilted planes, and the rotary axes that stand to them
    void tilt(const nc::Block& block, const nc::Invocation& invocation);
    std::optional<path::Frame> plane_by_angles(const nc::Block& block,
                                               const nc::Invocation& invocation);
    void set_plane_by_blocks(const nc::Block& block, const nc::Invocation& invocation);
    std::optional<path::Frame> plane_by_blocks(const nc::Block& block, const OpenPlane& said);
    std::optional<path::Vec3> origin_of_plane(const nc::Block& block,
                                              const nc::Invocation& invocation, std::size_t first);
    Done require_place_for_plane(const nc::Block& block, const nc::Invocation& invocation,
                                 bool is_added);
    void set_plane(const path::Frame& plane, bool is_added);
    void tilt_along_tool(const nc::Block& block, const nc::Invocation& invocation);
    void end_tilted_plane(const nc::Block& block);
    void turn_in_space(const nc::Block& block, const nc::Invocation& invocation);
    Done end_rotations_3d(const nc::Block& block);
    Done require_nested_length(const nc::Block& block, nc::Function function);
    void align(const nc::Block& block, const nc::Invocation& invocation);
    Done require_rotary_axes(const nc::Block& block, nc::Function function);
    std::optional<path::Vec3> joints_for_plane(const nc::Block& block, nc::Function function,
                                               int sense);
    void turn_joints(const nc::Block& block, const path::Vec3& joints, path::Op op);
    void turn_about_tip(const nc::Block& block, const path::Vec3& joints, path::Op op,
                        double above);
    void hold_tip(const nc::Block& block, const path::Vec3& joints, path::Op op);
    void carry(const nc::Block& block, const path::Vec3& joints);
    void drop_carry(const nc::Block& block);
    void stand_at(const nc::Block& block, const AxisValues& axes, bool tool_turns);
    path::Vec3 length_shift_of(const path::Vec3& lengths) const;
    void set_length_shift(const path::Vec3& shift);
    path::Command& put_tool_length(const nc::Block& block, Axis axis);
    void check_carried(const nc::Block& block);
    Done require_block_of_open_plane(const nc::Block& block);

    // swivelling.cpp: SINUMERIK's swivelling cycle, frames along tool and tables
    void swivel(const nc::Block& block, const nc::Invocation& invocation);
    std::optional<path::Mat3> swivel_rotation(const nc::Block& block,
                                              const nc::Invocation& invocation);
    path::Vec3 direct_joints(const nc::Block& block, const nc::Invocation& invocation) const;
    Done retract_before_swivel(const nc::Block& block, const nc::Invocation& invocation);
    Done retract_along_tool(const nc::Block& block, std::optional<double> by);
    void end_swivel(const nc::Block& block);
    void frame_along_tool(const nc::Block& block, const nc::Invocation& invocation);
    void follow_tables(const nc::Block& block, bool is_wanted);
    // carrier_words.cpp: tool carriers
    void choose_carrier(const nc::Block& block, const nc::Invocation& invocation, Actions& actions);
    bool takes_carrier(const nc::Block& block, const Actions& actions) const;
    void take_carrier(const nc::Block& block);
    std::optional<Carrier> standing_carrier(const nc::Block& block, const CarrierData& data);
    void lay_on_carrier();
    void end_carrier();
    bool leave_carrier();
    Done require_no_carrier(const nc::Block& block, nc::Function function);
    bool is_turned_by_carrier() const;
    bool is_plane_on_carrier() const;
    std::optional<double> carrier_quantity(nc::Quantity quantity, std::int64_t first,
                                           std::int64_t second) const;
    ControlAccess::Write set_carrier(nc::Quantity quantity, std::int64_t first, std::int64_t second,
                                     double value);
    std::optional<std::string> carrier_text(nc::Quantity quantity, std::int64_t number) const;
    ControlAccess::Write set_carrier_text(nc::Quantity quantity, std::int64_t number,
                                          std::string_view text);
    // virtual_axes.cpp: faces, cylinders and inclined slides
    void begin_virtual(const nc::Block& block, const nc::Invocation& invocation);
    void end_virtual(const nc::Block& block);
    void take_virtual_position(const path::Vec3& place);
    double virtual_angle() const;
    std::optional<path::VirtualAxes> wanted_virtual(const nc::Block& block,
                                                    const nc::Invocation& invocation);
    std::optional<path::VirtualAxes> wanted_polar_interpolation(const nc::Block& block);
    std::optional<path::VirtualAxes> wanted_cylinder(const nc::Block& block,
                                                     const nc::Invocation& invocation);
    std::optional<path::VirtualAxes> wanted_inclined(const nc::Block& block,
                                                     const nc::Invocation& invocation);
    void refuse_virtual(const nc::Block& block, nc::Function function);
    void refuse_virtual(const nc::Block& block, nc::Slot slot);
    Done require_virtual_words(const nc::Block& block);
    Done take_rotary_word(const nc::Block& block);
    const nc::Block* in_virtual(const nc::Block& block);
    void say_virtual_plane(path::Plane said);
    void follow_from_here();
    void follow_rotary();
    Done follow_leg_by_leg(const path::Command& command, const path::Curve& curve);
    bool is_transformed() const { return orienting_.is_on || virtual_.axes.is_on(); }
    // arc_threads.cpp
    void thread_along_arc(const nc::Block& block, const Target& target, const Actions& actions);
    std::optional<path::Arc> arc_of_thread(const nc::Block& block, const Target& target);
    std::optional<Lead> pitch_of_arc(const nc::Block& block, const path::Vec3& way);

    // rare_words.cpp: what words of tools and of their places do besides
    void move_without_length(const nc::Block& block, const Target& target, bool exact_stop);
    void preset_axes(const nc::Block& block, const nc::Invocation& invocation);
    void set_tooth_feed(const nc::Block& block, double feed);
    void take_tooth_feed();
    void measure_length(const nc::Block& block, const nc::Invocation& invocation);

    // data_input.cpp: blocks that write data of the control
    void write_parameter(const nc::Block& block, const nc::Invocation& invocation);
    void tell_life_data(const nc::Block& block);

    // angles.cpp
    path::Plane plane_in(const nc::Block& block) const;
    bool opens_line(const nc::Block& block);
    void close_line(const nc::Block& block);
    bool is_open_distance(const nc::Block& first, const nc::Block& second, nc::Slot slot) const;
    const nc::Block* with_positions(const nc::Block& block);

    // cornering.cpp
    void choose_corner(const nc::Block& block, const nc::Invocation& invocation, Actions& actions);
    void take_corner_feed(const nc::Block& block, const nc::Invocation& invocation,
                          Actions& actions);
    void wish_corner(const nc::Block& block, const Actions& actions);
    void put_wish(const nc::Block& block, CornerWish wish);
    /// Whether a corner at the end of a motion may still be wished for, by a block behind it.
    bool wishes_corners() const { return rounding_ > 0 || rules_.corner_in_own_block; }
    bool has_square_corner(const nc::Block& block) const;
    void wish_square_corner(const nc::Block& block, const Target& target);
    bool has_stages() const;
    void settle(const nc::Block& block);
    void settle_stages(const nc::Block& block, const AxisValues& here, bool is_last);
    void leave_corners(const DiagnosticRow& why);
    void pass_corners();
    void report_corner(const CornerMessage& message);

    // compensating.cpp
    void choose_pointed_corners(const nc::Block& block, const nc::Invocation& invocation);
    void choose_comp_side(const nc::Block& block, nc::Function function, Actions& actions);
    void begin_comp(const nc::Block& block, CompSide side);
    void act_on_comp(const nc::Block& block, const Actions& actions);
    bool is_any_comp_on() const { return compensation_.is_on() || comp_3d_.is_on(); }
    void send_comp(const CompChange& change);
    void change_comp_3d(const CompChange& change);
    bool is_in_space(CompChange::Kind kind) const;
    Done require_comp_in_plane(const nc::Block& block, nc::Function function);
    path::Mat3 comp_lie() const;
    path::Mat3 plane_lie() const;
    Comp3dSettings comp_3d_settings() const;
    path::Vec3 tool_direction() const;
    void change_comp(const CompChange& change);
    void settle_comp(const nc::Block& block, const AxisValues& here, bool is_last = true);
    void flush_comp();
    void stop_comp();
    void take_comp(const std::optional<CompAlarm>& alarm);
    void round_comp_corner(const nc::Block& block, const nc::Invocation& invocation);
    std::optional<path::Vec2> direction_in_base(const path::Vec3& programmed) const;
    std::optional<path::Vec2> leave_direction(const nc::Block& block) const;
    CompSettings comp_settings() const;
    std::optional<std::int64_t> comp_offset() const;
    CompChange comp_change(const nc::Block& block, CompChange::Kind kind);
    void take_comp_tool(const nc::Block& block, std::int64_t number, CompChange& change);
    void report_comp(const CompAlarm& alarm);

    // approach_moves.cpp
    void approach_smoothly(const nc::Block& block, const Actions& actions);
    void retract_smoothly(const nc::Block& block, const Actions& actions);
    std::optional<ApproachMove> approach_move_of(const nc::Block& block, const Actions& actions);
    double base_level(double programmed) const;
    std::optional<path::ApproachPath> soft_way(const nc::Block& block, const ApproachMove& move,
                                               const ApproachPoint& at);
    std::optional<double> approach_level(const nc::Block& block, const ApproachMove& move,
                                         double contour, double tool);
    void settle_approach(const nc::Block& block);
    void put_smooth_approach();
    void put_infeed(path::Command command, AxisValues& here, double level);
    void put_approach_path(path::Command command, const path::Element& element);
    path::Vec2 in_plane(const AxisValues& values) const;
    void set_in_plane(AxisValues& values, const path::Vec2& place) const;

    // shapes.cpp: the blocks of the program along which a cycle works
    void begin_shape(const nc::Block& block, const ModalCycle& call);
    Done require_shape_block(const nc::Block& block);
    bool is_behind_shape(const nc::Block& block) const;
    void end_shape_block(const nc::Block& block);
    void finish_shape();
    void return_from_shape();
    CycleShape shape_of(const ShapeRun& run) const;
    bool keeps_shape() const { return shape_ && !shape_->is_followed; }

    // contours.cpp
    Done require_contour_block(const nc::Block& block);
    void note_contour_block(const nc::Block& block);
    std::optional<ContourElements> contour_of(const ContourRun& run);

    // splines.cpp
    bool continues_spline(const nc::Block& block) const;
    void set_spline_degree(const nc::Block& block, const nc::Invocation& invocation);
    void spline(const nc::Block& block, const ToolWords& tool);
    Done start_spline(const nc::Block& block, bool by_knots);
    Done add_control_point(const nc::Block& block, nc::SlotMask targets, const ToolWords& tool);
    void move_along_spline();
    void finish_spline();
    void put_span(const path::SplineSpan& span, const ControlPointBlock& said, AxisMask moved,
                  bool exact_stop);
    void report_spline(const nc::Block& block, path::NurbsFault fault);

    // through_splines.cpp: splines through points
    void choose_spline_end(const nc::Block& block, const nc::Invocation& invocation);
    bool continues_through(const nc::Block& block);
    bool only_turns(const nc::Block& block);
    void go_through(const nc::Block& block, nc::SlotMask targets, const ToolWords& tool);
    Done start_through(const nc::Block& block);
    void move_through();
    void finish_through(const nc::Block* next);
    std::optional<path::Vec3> direction_into(const nc::Block& next);
    bool is_in_spline() const { return spline_ || through_; }
    bool leaves_spline_open(const nc::Block& block, const nc::Invocation& invocation) const;
    ControlPointBlock control_point_block(const nc::Block& block, const AxisValues& to);
    path::Command span_as_programmed(const nc::Block& block);
    void as_programmed(path::Command& command) const;
    void put_commands_before(std::uint32_t number);
    void finish_open_spline(const nc::Block* next = nullptr);

    // polynomials.cpp
    void polynomial(const nc::Block& block, const ToolWords& tool, bool exact_stop);

    // involutes.cpp
    void involute(const nc::Block& block, const Target& programmed, bool exact_stop);
    void put_involute(const nc::Block& block, const path::InvoluteWords& words, double radius,
                      const Target& target, bool exact_stop);

    // surfaces.cpp
    std::optional<Cutter3d> mill_shape_now(const nc::Block& block);
    Done require_constant_tool(const nc::Block& block);
    Done lay_surface(const nc::Block& block, const ToolWords& tool);
    Done require_tcp_for_peripheral_comp(const nc::Block& block, nc::Function function);
    Done require_no_peripheral_arc(const nc::Block& block);

    // curves.cpp
    void move_along_curve(const nc::Block& block, const nc::Invocation& call);

    // motion.cpp: what is wrong or strange
    void warn_arc_word(const nc::Block& block, nc::SlotMask words);
    Done require_no_move_before_tap(const nc::Block& block, nc::SlotMask targets);
    Done require_feed(const nc::Block& block, std::string_view what);
    Done require_probe_feed(const nc::Block& block);
    void check_rapid(const nc::Block& block, const Target& target);
    void check_tool(const nc::Block& block);
    void check_units(const nc::Block& block, nc::Function function);
    Done require_within_limits(const nc::Block& block, const AxisValues& base, AxisMask moved);
    Done require_within_machine(const nc::Block& block, const AxisValues& base, AxisMask moved);
    Done require_within_area(const nc::Block& block, const AxisValues& base, AxisMask moved);
    Done require_arc_within_limits(const nc::Block& block, const path::Arc& arc,
                                   const Target& target);
    Done require_box_within_limits(const nc::Block& block, const path::Box& box);
    void report_limit(const nc::Block& block, Axis axis, double at);

    // dangers.cpp: what every control takes, and no spindle
    bool is_new_feed() const {
        return modal_.feed != dangers_.feed || modal_.feed_mode != dangers_.feed_mode;
    }
    void watch_feed(const nc::Block& block);
    void watch_cutting_speed(const nc::Block& block, double from, double to);
    void watch_length(const nc::Block& block, Axis axis);
    void watch_missing_length(const nc::Block& block);
    void watch_turret_offset(const nc::Block& block, std::int64_t number);
    bool is_allowed(const DiagnosticRow& row, const nc::Block& block) const;
    bool first_time_of_feed(const DiagnosticRow& row, const nc::Block& block);
    void watch_diameter(const nc::Block& block, nc::Function function);
    void watch_dwell(const nc::Block& block);
    void watch_tap(const nc::Block& block, nc::Function function);
    double below_retract() const;
    void watch_change(const nc::Block& block);
    void watch_spindle_stop(const nc::Block& block);
    void watch_radius(const nc::Block& block, std::int64_t number);

    // cycles.cpp
    void call_cycle(const nc::Block& block, const Actions& actions);
    void preset_cycle(const nc::Block& block, const nc::Invocation& invocation);
    void complete_call(ModalCycle& call) const;
    void call_defined(const nc::Block& block);
    void repeat_cycle(const nc::Block& block, const Actions& actions);
    void call_behind_motion(const nc::Block& block);
    void move_instead_of_cycle(const nc::Block& block, const Actions& actions);
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
    void start_cycle(const nc::Block& block, ModalCycle call, const CycleShape* shape = nullptr);
    void take_off_scale(ModalCycle& call);
    const nc::Block& with_depth_apart(const nc::Block& block);
    Done complete_tap(const nc::Block& block, ModalCycle& call);
    Done complete_thread(const nc::Block& block, ModalCycle& call);
    void open_cycle(const nc::Block& block, std::unique_ptr<Stream<nc::Block>> blocks);
    void finish_cycle();
    Done require_no_refusal(const nc::Block& block);
    void refuse_cycle(const nc::Block& block, std::string_view words);
    Done require_surroundings(const nc::Block& block, const ModalCycle& call);
    Done require_whole_counts(const nc::Block& block, const ModalCycle& call);
    Done require_words_of_cycle(const nc::Block& block, const Actions& actions);
    void complete_surroundings(ModalCycle& call, bool calls_program) const;
    void begin_pattern(const nc::Block& block, std::unique_ptr<Stream<nc::Block>> places);
    void go_to_next_position();
    void finish_pattern();
    bool calls_program_at(const nc::Block& block) const;
    void return_to_level();
    void take_ends(const nc::Block& block, ModalCycle& call) const;
    void complete_ends(ModalCycle& call) const;
    void end_where_tool_stands(ModalCycle& call) const;
    void forget_ends();
    bool is_among_positions() const;
    Done require_no_cycle(const nc::Block& block, const Actions& actions);
    path::Plane cycle_plane() const;
    AxisValues position_in_cycle() const;
    const nc::Block& in_plane_of_cycle(const nc::Block& block);

    path::Command& behind_corners();
    path::Command& put(path::Op op, const nc::Block& block);
    void fill_in(path::Command& command, const nc::Block& block);
    path::Blending blending(path::Op op) const;  // smoothing.cpp
    // feed_words.cpp
    void take_polynomial(const nc::Block& block, const nc::Invocation& invocation);
    bool may_count_degrees(const nc::Block& block) const;
    void count_degrees(const nc::Block& block, path::Command& command) const;
    bool stops_exactly(bool once = false) const;
    double compressing(path::Op op) const;
    void choose_high_speed(const nc::Block& block, const nc::Invocation& invocation);
    void choose_smoothing(const nc::Block& block, const nc::Invocation& invocation);
    void frame_changed();
    AxisMask plane_mask() const;
    MotionView motion_view() const {
        return {modal_.motion,
                modal_.plane,
                modal_.is_incremental,
                diameter_is_absolute_,
                is_transformed(),
                position_,
                frames_,
                axes_,
                virtual_.axes,
                rules_,
                dialect_.tables(),
                units_};
    }
    MotionWords motion_words() { return {motion_view(), reporter_}; }
    bool has_ended() const { return reporter_.has_ended(); }
    /// A block for messages, at the place of a command. Where that is the call of the cycle that
    /// runs, it is one of the cycle's.
    nc::Block block_at(SourceId source, std::uint32_t line) const;
    void locate(nc::Block& at, SourceId source, std::uint32_t line) const;

    const nc::Dialect& dialect_;
    const machine::Machine& machine_;
    std::vector<control::ControlFrame>
        work_offsets_;              // as the machine has them, until the program sets one
    std::int64_t work_offset_ = 0;  // that acts
    const bool is_lathe_;           // the machine is one, or the control is a lathe's
    ToolOffsets tool_offsets_;
    ToolNames tool_names_;
    CycleExpander* cycles_;
    InterpreterOptions options_;
    Reporter reporter_;
    nc::Rules rules_;

    BlockQueue program_;
    Output output_;
    ProgramClocks clocks_;
    Probe probe_;
    std::uint64_t block_count_ = 0;

    Modal modal_;
    Position position_;
    control::Frames frames_{rules_};
    struct KeptFrames {
        control::Frames frames;
        std::int64_t work_offset;
    };
    std::vector<KeptFrames> kept_frames_;  // of programs that go back to them
    /// Base frames that were written and act when a work offset is called next.
    struct StoredBases {
        control::BaseFrames frames;
        std::uint16_t new_global = 0;  // a bit for each number
        std::uint16_t new_channel = 0;
    };
    StoredBases stored_bases_;
    /// What a block in machine coordinates goes back to behind it.
    struct FramesOff {
        control::Frames frames;
        Position before;
    };
    std::optional<FramesOff> frames_off_;
    Spindle spindle_;                      // the master
    std::vector<Spindle> other_spindles_;  // of machines with several
    bool is_master_away_ = false;          // another spindle has its place for a moment
    Tool tool_;
    ExtraTool extra_;
    ToolCarriers carriers_;
    ActiveCarrier carrier_;
    WorkArea area_;
    PositionWords position_words_;
    Orienting orienting_;
    Tilting tilted_plane_;
    NextOrientation next_orientation_;
    std::optional<ToolWords> course_;  // of the block: waits until its path is known
    path::Contact face_;               // normals of the surface along the block, of a Face
    Virtual virtual_;
    /// Where the commands that are out have led the tip and the rotary axis.
    struct Followed {
        std::size_t followed = 0;  // so many commands of this batch, and of those that wait
        path::Vec3 tip = path::Vec3::Zero();
        double at = 0;  // rad
    };
    Followed rotary_;
    nc::Block around_{};  // a block whose rotary word has become a place around
    path::Vec3 came_from_ = path::Vec3::Zero();  // in the base system: a place on the way to here
    bool diameter_is_absolute_ = false;          // X is a diameter as a coordinate only
    double rounding_ = 0;                        // of every corner, mm; 0: none
    double corner_feed_ = 0;                     // of every corner; 0: that of a neighbour
    Corners corners_{corner_settings(rules_)};
    RadiusCompState comp_;
    ApproachChoice approach_choice_;
    Smoothing smoothing_;
    SmoothApproach smooth_approach_;
    /// Where the latest one has met the contour, in the base system.
    struct Approached {
        AxisValues start{};  // P3
        AxisValues end{};    // P4
    };
    std::optional<Approached> approached_;
    Compensation compensation_;
    Compensation3d comp_3d_;  // in place of it under CompPeripheral
    path::CoolantMode coolant_ = path::CoolantMode::Off;
    bool is_scanning_ = false;  // motions are a scanner's
    bool has_moved_ = false;
    Units units_ = Units::Unsaid;      // that the program said last
    bool owes_speed_ = false;          // the motion side was not told of a new speed of the spindle
    std::optional<SplineRun> spline_;  // that is being read
    std::optional<ThroughRun> through_;  // … through points
    SplineCommands spline_commands_;     // beside the points of the one that is being read
    bool puts_span_ = false;             // what is put stands in front of it, not of the next one
    SplineEnds spline_ends_;
    nc::Block spline_end_{};  // place of its latest block
    int spline_degree_ = 3;
    bool taps_rigidly_ = false;  // of the tapping cycles that follow
    ProgrammedDynamics dynamics_;
    AxisMask unplaced_ = 0;  // axes that want a place behind the end of a rotation

    ReportedInRun told_;
    Dangers dangers_;

    AxisData axes_;
    AxisValues length_shift_{};  // machine position − base position: the tool length in force
    AxisValues preset_{};        // real position − the one that the program has set
    double tooth_feed_ = 0;      // mm; 0: the feed was said by itself

    ModalCycles modal_cycles_;
    CycleRun cycle_;
    std::optional<ShapeRun> shape_;      // whose blocks are coming
    std::optional<ContourRun> contour_;  // likewise, for a table of the program
    std::vector<PatternRun> patterns_;   // a program that is called at places may hold another one
    nc::Block place_{};                  // of the pattern, at its caller's place in the text
    nc::Block called_{};  // a call whose word of Z is a place, in another plane than X-Y

    std::optional<nc::Block> open_line_;  // waits for the one that tells its end
};

}  // namespace kadr::interp
