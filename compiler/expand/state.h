// state.h — a running program: registers, calls, modal state, the batch that is being filled.
//
// The chapters: vm.cpp (the instructions), blocks.cpp (blocks, frames, `with`), tilted_planes.cpp
// and orienting.cpp (planes and directions of five axes), input.cpp and cycles.cpp (blocks written
// in the manner of another control), contours.cpp, unknown.cpp (modal state that is not known),
// curves.cpp, faults.cpp (errors with the call stack), start.cpp (programs, parameters), tests.cpp,
// text_format.cpp. For the room expand only.
#pragma once

#include <array>
#include <chrono>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/done.h"
#include "control/cycle_levels.h"
#include "expand/expander.h"
#include "expand/heap.h"
#include "expand/modal.h"
#include "expand/reported_in_program.h"
#include "path/command.h"
#include "path/contour.h"
#include "path/contour_offset.h"
#include "path/spline_fit.h"
#include "sema/arithmetic.h"

namespace kadr::expand {

using sema::Instruction;
using sema::OpCode;

/// A call that has not returned yet.
struct CallFrame {
    const sema::FunctionCode* function = nullptr;
    std::uint32_t return_to = 0;  // instruction behind the call
    std::uint32_t base = 0;       // of its registers in the stack
    std::uint32_t given = 0;      // bit i: argument i was given
    std::uint32_t promises = 0;   // `preserves` open when it began
    std::uint32_t loops = 0;      // loop counters of its callers
};

/// The calls that have not returned, outermost first. A vector that never shrinks: a call writes
/// its frame into memory that is there.
class CallStack {
  public:
    CallFrame& push() {
        if (size_ == frames_.size()) [[unlikely]]
            frames_.resize(2 * size_ + 64);
        return frames_[size_++];
    }
    void pop() { --size_; }
    CallFrame& back() { return frames_[size_ - 1]; }
    const CallFrame& back() const { return frames_[size_ - 1]; }
    const CallFrame& operator[](std::size_t i) const { return frames_[i]; }
    std::size_t size() const { return size_; }

  private:
    std::vector<CallFrame> frames_;
    std::size_t size_ = 0;
};

/// What the blocks that follow a contour or a curve have in common.
struct FollowedBlock {
    SourceId source;
    unsigned depth = 0;        // loops around the statement
    double feed = 0;           // of the block, second form included; NaN: none
    bool is_diameter = false;  // the word X is a diameter
};

/// A curve that is being followed: its blocks may fill several batches.
struct Following {
    std::unique_ptr<path::CurveFit> fit;
    path::Nurbs spline;  // its control points are the blocks, if it has any; then there is no fit
    std::size_t next_knot = 0;  // of the spline: block number
    path::Plane plane = path::Plane::Xy;
    std::array<bool, 3> is_given{};  // coordinates, in the order of the plane
    bool has_coordinates = false;    // is_given holds
    path::Vec2 at = path::Vec2::Zero();
    FollowedBlock next;
};

/// A word of a cycle's mode that the next cycle need not give again, and the parameter that it
/// gives.
struct HeldWord {
    std::string_view parameter;
    char letter;  // of the control
};
inline constexpr std::array<HeldWord, 4> kHeldWords = {
    {{"to", 'Z'}, {"retract", 'R'}, {"peck", 'Q'}, {"dwell", 'P'}}};

/// The cycle of the input dialect's control that was programmed last; see sema::SourceCycle.
struct ActiveCycle {
    const sema::SourceCycle* source = nullptr;
    bool is_active = false;   // further blocks are positions of it
    bool is_due = false;      // RunCycle calls it
    bool is_running = false;  // its blocks are being made
    std::array<double, nc::kMaxArguments> arguments{};
    std::uint32_t given = 0;  // bit i: argument i
    /// Words of the mode that further cycles need not give again, by the parameters of the library.
    std::array<std::optional<double>, kHeldWords.size()> held;
    control::CycleLevels levels;
    bool returns_low = false;   // G99: to the retract level, not to where the mode began
    bool taps_rigidly = false;  // M29
    // Where the mode began, along the tool axis.
    double initial = 0;
    bool is_initial_known = false;
    control::ProgramFrame frame;
    double work_offset = 0;
    // What its block found and holds again behind it.
    nc::Function motion = nc::Function::None;
    bool was_incremental = false;
};

/// What a `with` or a promise of a cycle found, and which of it holds again behind it.
struct OpenWith {
    sema::ModalMask mask = 0;
    ModalState before;
};

struct Expander::State {
    State(const sema::Code& program, const nc::Dialect& dialect, const ExpandOptions& wanted,
          DiagnosticSink& messages);

    // ---- start.cpp
    Done start(std::string_view program, const std::vector<sema::Define>& defines);
    Done start_cycle(std::string_view name, std::span<const double> arguments, std::uint32_t given,
                     const Surroundings& at);
    const sema::FunctionCode* find_program(std::string_view name);
    Done set_parameter(const sema::FunctionCode& function, const sema::ParameterInfo& parameter,
                       const std::string& text, Slot& slot);
    static bool set_number(const sema::ParameterInfo& parameter, double value, Slot& slot);
    void enter(const sema::FunctionCode& function, std::uint32_t given);
    ModalState first_state(const sema::FunctionCode& function) const;

    // ---- tests.cpp
    void start_test(std::uint32_t index, std::span<const Slot> values, TestBench& asked);
    std::optional<std::vector<Slot>> read_values(std::uint32_t index,
                                                 const std::vector<sema::Define>& defines);
    Done test_call(const Instruction& instruction, Slot* registers, std::uint32_t at);
    void ask_figure(const Instruction& instruction, Slot* registers);
    void list_dialects(const Instruction& instruction, Slot* registers);
    void report_expectation(const Instruction& instruction, const Slot* registers,
                            std::uint32_t at);
    bool stops_at_failure();
    void start_call(const CallUnderTest& call);
    void set_up(const CallUnderTest& call);

    // ---- vm.cpp
    std::size_t pull(std::span<nc::Block> out);
    /// With kSlopes every real number carries its derivative by a curve's parameter (forward
    /// differentiation): it stands in `slopes` under the number of its register. What comes out of
    /// an array counts as constant.
    template <bool kTrace, bool kSlopes>
    void run();
    void reserve_stack(std::size_t slots);
    std::int64_t make_fixed(std::uint32_t layout, std::int64_t count);
    Done read_image(const sema::PictureSource& source, Slot path, std::uint32_t at, Slot* image);
    void make_image(const sema::PictureSource& source, const sema::Picture& picture, Slot* image);
    Done read_table(const sema::TableSchema& schema, Slot path, std::uint32_t at, Slot& table);
    std::int64_t make_table(const sema::TableSchema& schema, const sema::TableRows& rows);
    void collect_garbage(const Slot* registers);
    bool collect_in_time(const Slot* registers);
    /// Looks whether somebody wants the evaluation to end, and at the clock. True: it is to end.
    bool look_for_end();
    void report_end(std::uint32_t at);
    void offset_fault(path::OffsetFault why, double distance, std::uint32_t at);

    // ---- blocks.cpp
    /// A block to fill: of the batch while there is room, else one that waits for the next batch.
    nc::Block& next_block(SourceId source);
    /// Takes back the block that was made last: it could not be finished.
    void drop_block(const nc::Block& block);
    Done emit(const Instruction& instruction, const Slot* registers, std::uint32_t at);
    Done emit_block(const sema::Plan& plan, const Instruction& instruction, const Slot* registers,
                    std::uint32_t at);
    Done fill_plan(const sema::Plan& plan, const Instruction& instruction, const Slot* registers,
                   std::uint32_t at);
    Done fill_block(const sema::Plan& plan, const Instruction& instruction, const Slot* registers,
                    std::uint32_t at);

    // ---- tilted_planes.cpp
    bool is_about_tilted_plane(const sema::Plan& plan) const;
    Done emit_tilted_plane(const sema::Plan& plan, const Instruction& instruction,
                           const Slot* registers, std::uint32_t at);
    Done emit_plan_of_frame(const sema::Plan& plan, const Instruction& instruction,
                            const Slot* registers, std::uint32_t at);
    Done refuse_in_tilted_plane(std::string_view what, std::uint32_t at);
    Done read_plane(const sema::Plan& plan, const Instruction& instruction, const Slot* registers,
                    std::uint32_t at, std::array<double, 6>& values);
    Done say_euler(const std::array<double, 6>& values, SourceId source, std::uint32_t at,
                   unsigned depth);
    Done resolve_tilted_plane(const std::array<double, 6>& values, SourceId source,
                              std::uint32_t at, unsigned depth);
    Done say_joints(const machine::Chain& chain, const path::Vec3& joints, SourceId source,
                    std::uint32_t at, unsigned depth);

    // ---- orienting.cpp
    struct Argument {
        std::size_t parameter;  // of the function, as parameter_of<> counts
        double value;
    };
    void put_function(nc::Function function, std::span<const Argument> arguments, SourceId source,
                      std::uint32_t at, unsigned depth);
    void put_function(nc::Function function, std::initializer_list<Argument> arguments,
                      SourceId source, std::uint32_t at, unsigned depth) {
        put_function(function, std::span(arguments.begin(), arguments.size()), source, at, depth);
    }
    enum class ToolTaken : std::uint8_t {
        Failed,
        Done,
        Nothing,  // of it: the block is like any other
    };
    static ToolTaken tool_taken(Done done) { return done ? ToolTaken::Done : ToolTaken::Failed; }
    ToolTaken take_tool(const sema::Plan& plan, const Instruction& instruction, std::uint32_t at);
    Done refuse_under_tcp(std::string_view what, std::uint32_t at);
    std::string tcp_hindrance() const;
    std::optional<double> length_number() const;
    void say_offset_again(SourceId source, std::uint32_t at, unsigned depth);
    Done begin_tcp(std::span<const nc::Invocation> said, SourceId source, std::uint32_t at,
                   unsigned depth);
    Done choose_orient_interpolation(nc::Function orientation, SourceId source, std::uint32_t at,
                                     unsigned depth);
    Done end_tcp(SourceId source, std::uint32_t at, unsigned depth);
    Done set_back_tcp(const ModalState& before, SourceId source, std::uint32_t at, unsigned depth);
    Done require_leading_tool(std::uint32_t at);
    Done settle_direction(nc::Block& block, std::uint32_t at);
    Done check_leading(const nc::Block& block, std::uint32_t at);

    // ---- input.cpp: what the control of the input dialect would have done
    /// Whether a function of the plan has no word in the target, but a frame does the same.
    bool needs_frame(const sema::Plan& plan) const;
    bool needs_frame(const sema::Plan& plan, std::size_t invocation) const;
    Done read_arguments(const sema::Plan& plan, std::size_t invocation,
                        const Instruction& instruction, const Slot* registers, std::uint32_t at,
                        std::array<double, 4>& values, std::array<bool, 4>& given);
    Done emit_rest(const sema::Plan& plan, const sema::Instruction& instruction,
                   const sema::Slot* registers, std::uint32_t at);
    Done emit_frame(const sema::Plan& plan, const Instruction& instruction, const Slot* registers,
                    std::uint32_t at);
    /// Arguments are in the block; the modal state is that before it.
    Done adapt(nc::Block& block, const sema::Plan& plan, std::uint32_t at);
    void adapt_shift(nc::Block& block, nc::Invocation& shift);
    Done adapt_machine(nc::Block& block, const sema::Plan& plan, std::uint32_t at);
    Done require_plane_of_source(const sema::Plan& plan, std::uint32_t at);
    Done require_free_frame(nc::Function function, std::uint32_t at);
    void say_offset(const sema::Plan& plan, const Instruction& instruction, std::uint32_t at);
    /// The block may move, with the tool length and the feed that act.
    Done check_move(const nc::Block& block, std::uint32_t at);
    Done adapt_increments(nc::Block& block, const sema::Plan& plan, std::uint32_t at);
    void center_unknown(nc::Function function, std::size_t axis, std::uint32_t at);
    Done complete_center(nc::Block& block, nc::Invocation& invocation, std::uint32_t at);
    bool is_increment(const nc::Block& block, nc::SlotMask axis) const;
    void become_place(nc::Block& block, std::size_t axis) const;
    Done name_positions(nc::Block& block, std::uint32_t at);
    bool is_whole_circle(const sema::Plan& plan) const;
    Done write_positions(SourceId source, std::uint32_t at, unsigned depth);
    void return_to_increments(nc::Block& block);
    void say_reference(nc::Block& block);
    void go_over_position(SourceId source);
    Done take_station(nc::Block& block, nc::Invocation& select, std::uint32_t at);
    Done take_offsets_as_edges(nc::Block& block, std::uint32_t at);
    Done take_edges_as_offsets(nc::Block& block, std::uint32_t at);
    Done take_core_offsets(nc::Block& block, std::uint32_t at);
    Done take_edge_as_length(nc::Block& block, nc::Invocation& edge, std::uint32_t at);

    // ---- cycles.cpp: cycles as the control of the input dialect has them
    bool is_between_positions() const {
        return active_cycle.is_active && !active_cycle.is_running && recordings.empty();
    }
    Done refuse_beside_cycle(std::string_view what, std::uint32_t at);
    Done require_between_positions(const sema::Plan& plan, const Instruction& instruction,
                                   std::uint32_t at);
    /// A block of a source that has cycles, with all its words: a position, or the end of the mode.
    Done take_position(nc::Block& block, const sema::Plan& plan, std::uint32_t at);
    void take_levels(nc::Block& block);
    /// `Q2.` or `P100` beside a position: the stroke or the dwell from here on.
    Done require_no_stroke(std::uint32_t at);
    Done take_cycle_words(const nc::Block& block, const nc::Invocation& invocation,
                          std::uint32_t at);
    Done say_cycle(const Instruction& instruction, const Slot* registers, std::uint32_t at);
    void take_given_levels(std::uint32_t said);
    Done complete_levels(const sema::FunctionCode& function, std::uint32_t at);
    std::optional<double> initial_level(std::uint32_t at);
    /// Completes the arguments and calls the library's cycle.
    Done call_cycle(const Instruction& instruction, const Slot* registers, std::uint32_t at);
    Done complete_cycle(const sema::FunctionCode& function, std::uint32_t at);
    void keep_words();
    void take_kept_words();
    Done require_words(std::uint32_t at);
    Done complete_pitch(std::size_t pitch, std::uint32_t at);
    void say_distance(nc::Function function, SourceId source, std::uint32_t at, unsigned depth);
    void leave_cycle(const Instruction& instruction, std::uint32_t at);

    std::uint32_t word_of(const sema::Filling& filling, std::uint32_t at) const;
    Done fill(nc::Block& block, const sema::Filling& filling, Slot value, std::uint32_t at);
    Done fill_feed(nc::Block& block, const sema::Filling& filling, double value, std::uint32_t at);
    Done fill_speed(nc::Block& block, const sema::Filling& filling, double value, std::uint32_t at);
    Done emit_text(const Instruction& instruction, const Slot* registers, std::uint32_t at);
    Done require_room(std::uint32_t at);
    double state_value(sema::StateValue which) const;
    std::int64_t spindle_code() const;  // 3, 4, 5 as in M3, M4, M5

    // ---- cuts.cpp
    Done check_cutting_speed(const nc::Block& block, std::uint32_t at);
    Done check_mirror(const nc::Block& block, const sema::Plan& plan, std::uint32_t at);
    Done settle_frame(nc::Block& block, std::uint32_t at);
    Done check_factor(double factor, std::uint32_t at);
    void warn_of_plane(const nc::Block& block, std::uint32_t at);
    nc::Changer changer() const;
    bool changes_tool(const nc::Block& block) const;
    Done check_tool_change(const nc::Block& block, std::uint32_t at);
    Done check_pitch(const nc::Block& block, std::uint32_t at);
    /// The block may cut: a feed that belonged to another feed mode does not count.
    Done check_cut(const nc::Block& block, std::uint32_t at);
    void warn_of_cut(std::uint32_t at, bool needs_feed = true);
    void warn_of_spindle(std::uint32_t at);
    /// Whether a comment in the source silences the warning there: it is not reported then.
    bool is_allowed(const DiagnosticRow& row, std::uint32_t at) const {
        return options.is_allowed && options.is_allowed(row, code.locations[at]);
    }
    /// Whether no tool was called, and that has not been reported yet.
    bool misses_tool() const {
        return modal.lacks_tool && !modal.reported.has_reported(ProgramNotice::NoTool);
    }
    bool is_cut_doubtful() const {
        return !modal.has_feed ||
               (options.warns_of_cuts && (misses_tool() || !modal.is_spindle_turning()));
    }
    /// A rapid below the zero of the workpiece while the spindle stands. The block has not moved
    /// yet.
    void check_rapid(const nc::Block& block, std::uint32_t at);
    Done refuse_lost_feed(std::uint32_t at, std::size_t depth);

    // ---- native_cycles.cpp
    bool spares_distances(nc::CycleId cycle, std::uint32_t given) const;
    void compensated_cycle(const sema::FunctionCode& cycle);
    void warn_of_tap();
    void go_back(std::span<const sema::ParameterInfo> parameters, std::uint32_t given,
                 std::span<const double> values);
    enum class CycleOutcome : std::uint8_t {
        Moves,   // the control has no such cycle: its body is executed
        Block,   // a block stands for it
        Failed,  // reported
    };
    /// A cycle whose refusal has been reported.
    static CycleOutcome failed(Done) { return CycleOutcome::Failed; }
    CycleOutcome emit_cycle(nc::CycleId cycle, const Slot* registers);

    // ---- frame_blocks.cpp
    Done change_frame(const Instruction& instruction, const Slot* registers, std::uint32_t at);
    void write_position(const sema::Plan& plan, const sema::Instruction& instruction,
                        std::uint32_t at);
    void scale_frame_x(nc::Block& block, double factor) const;
    Done refuse_frame(control::FrameFormFault why, std::uint32_t at);
    void write_frame(const control::ProgramFrame& next, SourceId source, std::uint32_t at,
                     unsigned depth);
    void put_frame_again(SourceId source, std::uint32_t at, unsigned depth);

    // ---- scopes.cpp
    Done set_back(const OpenWith& scope, SourceId source, std::uint32_t at, unsigned depth);
    void take_offset_of_head(ModalState& state) const;
    Done leave_with(SourceId source, std::uint32_t at, unsigned depth);
    Done check_needs(std::uint32_t at);
    Done check_preserves(std::uint32_t at);

    // ---- unknown.cpp
    /// Checks what the block needs of the modal state, and programs again what may have been left
    /// out.
    Done settle_unknown(nc::Block& block, std::uint32_t at);
    Done require_state(const nc::Block& block, std::uint32_t at);
    Done require_state_for_cycle(const sema::FunctionCode& cycle, std::uint32_t given,
                                 std::uint32_t at);
    Done require_frame(bool turns, std::uint32_t at);
    Done require_sure_compensation(const nc::Block& block, std::uint32_t at);
    void compensation_chosen(DiagnosticBuilder builder);
    Done require_feed_mode(std::uint32_t at);
    Done require_speed_mode(std::uint32_t at);
    Done refuse_lost_state(std::string_view what, std::string_view fix, std::uint32_t at);
    void report_lost_position(DiagnosticBuilder& builder, std::size_t axis) const;
    void report_loss(DiagnosticBuilder builder, std::string_view what, std::string_view fix);
    void put_again(nc::Block& block);
    void say_again_alone(SourceId source, std::uint32_t at, std::size_t depth);
    void warn_of_choice(DiagnosticBuilder builder);
    void say_diameter(nc::Block& block);
    void say_diameter_alone(SourceId source, std::uint32_t at, std::size_t depth);
    /// A block that turns while nothing tells whether X is a diameter.
    void warn_of_radius(const nc::Block& block, std::uint32_t at);
    Done keep_promise(const OpenWith& promise, std::uint32_t at);
    void warn_after_end(std::uint32_t at);
    /// An arc's center is not its start.
    Done require_radius(const nc::Block& block, std::uint32_t at);

    // ---- contours.cpp
    /// A contour outside of the heap, with the plane in which it lies.
    /// Geometry as it is on the part; as words and as points of the program X may be a diameter.
    struct PlaneContour {
        path::Contour elements;
        path::Plane plane = path::Plane::Xy;
        bool is_diameter = false;
    };
    PlaneContour read_contour(Slot handle);
    std::int64_t split_text(std::int64_t text, std::uint32_t layout);
    std::int64_t make_contour(const PlaneContour& contour, std::uint32_t layout);
    std::int64_t make_contours(const std::vector<path::Contour>& contours, const PlaneContour& like,
                               std::uint32_t layout);
    Done offset_all(const Instruction& instruction, Slot* registers, std::uint32_t at);
    Done contour_value(const Instruction& instruction, Slot* registers, std::uint32_t at);
    void begin_contour();
    Done close_contour(std::uint32_t at);
    std::int64_t end_contour(std::uint32_t layout);
    Done keep_plan(const sema::Plan& plan, const Instruction& instruction, const Slot* registers,
                   std::uint32_t at);
    Done keep(const nc::Block& block, std::uint32_t at);
    Done refuse_in_contour(std::string_view what, std::uint32_t at);
    /// What `follow` travels: beside the contour, leads included. Nothing: reported.
    std::optional<PlaneContour> followed(const Slot* arguments, std::uint32_t at);
    Done follow_start(const Instruction& instruction, Slot* registers, std::uint32_t at);
    Done follow_contour(const Instruction& instruction, const Slot* registers, std::uint32_t at);
    Done emit_element(const path::Element& element, const FollowedBlock& next, std::uint32_t at);
    Done finish_followed(nc::Block& block, const FollowedBlock& next, std::uint32_t at);
    /// Finest tolerance of a curve, mm: the increment of the finest controls.
    static constexpr double kLeastTolerance = 1e-5;

    // ---- curves.cpp
    enum class Progress : std::uint8_t { Failed, BatchFull, Done };
    /// What a millimetre along an axis is in its word.
    double word_scale(std::size_t axis, bool is_diameter) const {
        return is_diameter && axis == index(Axis::X) ? 2 : 1;
    }
    Progress follow_curve(const Instruction& instruction, std::uint32_t at);
    Done start_curve(const Instruction& instruction, std::uint32_t at);
    std::optional<path::CurveSample> curve_point(const Instruction& instruction, std::uint32_t at,
                                                 double parameter);
    void keep_back_rounding(std::uint32_t at, int coordinates, path::FitOptions& fit);
    Done start_fit(const Instruction& instruction, std::uint32_t at, bool wants_nurbs,
                   const path::FitOptions& fit);
    Done fit_spline(const Instruction& instruction, std::uint32_t at, const path::FitOptions& fit);
    std::size_t block_count(const path::Nurbs& spline) const;
    void set_coordinates(nc::Block& block, const path::Vec3& to) const;
    Done emit_control_point(const FollowedBlock& next, std::uint32_t at);
    void jump_fault(const Instruction& instruction, std::uint32_t at, double parameter);
    Done emit_line(const path::Vec3& to, const FollowedBlock& next, std::uint32_t at);

    // ---- faults.cpp: report with the call stack, end the program
    DiagnosticBuilder fault(const DiagnosticRow& row, std::uint32_t at);
    DiagnosticBuilder fault_in(const DiagnosticRow& row, std::uint32_t at, std::size_t frames);
    void fault_note(const DiagnosticRow& row, std::uint32_t at, const std::string& text);
    void math_fault(sema::MathFault why, std::uint32_t at);
    void not_given(std::string_view name, std::uint32_t at);
    /// Of two coordinates that belong together only one is given; both by their texts.
    void half_given(std::int32_t missing, std::int32_t given, std::uint32_t at);
    /// A feed or speed is not of the form that is needed; see Op::FeedForm.
    void form_fault(unsigned needed, std::uint32_t at);
    void index_fault(std::int64_t index, std::int64_t count, std::uint32_t at,
                     std::string_view whole = "the array");
    void contract_failed(const Instruction& instruction, const Slot* registers, std::uint32_t at);
    void keep_trace(std::uint32_t at, unsigned depth, SourceId source);

    bool more_turns(std::uint64_t& turns);

    // ---- text_format.cpp
    std::string format(const sema::FormatPattern& pattern, const Slot* values) const;
    /// A value for a message, in the units of the program: `2.5 mm`, `0.1 in`.
    std::string quantity_text(double value, sema::Quantity quantity) const;
    /// A value as the prompt shows it; `is_part`: inside of another one.
    std::string shown(std::uint32_t form, const Slot* value, bool is_part = false);
    std::string shown_list(const sema::ShownForm& form, Slot list);
    std::string shown_contour(const sema::ShownForm& form, Slot contour);

    const sema::Code& code;
    const nc::Dialect& target;
    ExpandOptions options;
    DiagnosticSink& sink;

    Heap heap;
    std::vector<Slot> stack;
    CallStack frames;
    std::vector<std::uint32_t> all_given;  // by function: the mask of a call with every argument
    std::uint32_t pc = 0;
    std::uint64_t turns_left = 1;     // of the present slice
    std::uint64_t turns_reserve = 0;  // of the slices to come
    bool was_stopped = false;         // from outside
    using Clock = std::chrono::steady_clock;
    Clock::time_point began = Clock::now();
    bool is_late = false;  // Limits::seconds are over
    std::uint64_t blocks_left = 0;
    bool is_running = false;
    bool has_failed = false;

    TestBench* bench = nullptr;            // only of a test
    bool is_rejected = false;              // an assumption of a property does not hold
    std::vector<std::uint32_t> failed_at;  // expectations that have been reported
    std::string reason;                    // of the figure asked last
    SourceId reason_at;

    ModalState modal;
    std::vector<OpenWith> withs;
    std::vector<OpenWith> promises;  // of `preserves`
    ActiveCycle active_cycle;
    ReportedInProgram reported;  // of the whole program; see also ModalState::reported
    ReportedAt reported_at;

    /// A contour whose blocks are being kept.
    struct Recording {
        ModalState before;
        path::Contour elements;
        path::Plane plane = path::Plane::Xy;
        bool is_diameter = false;
        path::Vec2 start = path::Vec2::Zero();
        path::Vec2 at = path::Vec2::Zero();
        bool has_start = false;
        bool is_closed = false;
    };
    std::vector<Recording> recordings;  // innermost last
    nc::Block kept_block;               // takes the words of a block that is kept

    std::optional<Following> following;
    bool is_in_curve = false;    // a point of a curve is being calculated
    std::vector<double> slopes;  // beside `stack`, while one is

    nc::Block* batch = nullptr;
    std::size_t batch_size = 0;
    std::size_t batch_count = 0;
    std::deque<nc::Block> waiting;  // made by one instruction beyond the end of a batch

    std::vector<std::uint64_t> loop_counts;  // only with a trace
    std::deque<BlockOrigin> traces;          // of the batch and of what waits
    std::size_t delivered = 0;               // traces of the batch before
};

}  // namespace kadr::expand
