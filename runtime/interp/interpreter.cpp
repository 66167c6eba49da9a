#include "interp/interpreter.h"

#include "interp/answers.h"
#include "interp/block_functions.h"
#include "interp/carriers.h"
#include "interp/channel.h"
#include "interp/contour_tables.h"
#include "interp/cornering.h"
#include "interp/cycle_shapes.h"
#include "interp/cycles.h"
#include "interp/danger_watch.h"
#include "interp/executor.h"
#include "interp/feed_characteristics.h"
#include "interp/feed_words.h"
#include "interp/motion_checks.h"
#include "interp/motions.h"
#include "interp/path_smoothing.h"
#include "interp/programmed_frames.h"
#include "interp/radius_compensation.h"
#include "interp/smooth_approaches.h"
#include "interp/spindles.h"
#include "interp/splines.h"
#include "interp/stages.h"
#include "interp/tilted_planes.h"
#include "interp/tool_in_use.h"
#include "interp/tool_motion.h"
#include "interp/transformation.h"
#include "interp/virtual_plane.h"

namespace kadr::interp {

/// The executor as a stream.
class Executed final : public Stream<path::Command> {
  public:
    explicit Executed(Executor& executor) : executor_(executor) {}
    std::size_t pull(std::span<path::Command> out) override { return executor_.pull(out); }

  private:
    Executor& executor_;
};

/// One channel of a control: its state, its parts, and the road of the blocks through them.
struct Interpreter::State {
    State(const nc::Dialect& dialect, const machine::Machine& machine, Stream<nc::Block>& blocks,
          const nc::BlockLocations* locations, CycleExpander* expander,
          const InterpreterOptions& options, DiagnosticSink& sink)
        : channel_state(dialect, machine, blocks, locations, expander, options, sink) {
        executor.start();
    }

    /// For what may change something outside of the blocks.
    State& asked() {
        executor.look_again();
        return *this;
    }

    ChannelState channel_state;
    Channel channel{channel_state,  spindles,     feed,          frames,    tool,
                    transformation, tool_motion,  tilted_planes, carriers,  virtual_plane,
                    cornering,      compensation, approaches,    stages,    smoothing,
                    splines,        cycles,       shapes,        contours,  motions,
                    checks,         dangers,      answers,       functions, executor};
    Spindles spindles{channel};
    FeedWords feed{channel};
    ProgrammedFrames frames{channel};
    ToolInUse tool{channel};
    Transformation transformation{channel};
    ToolMotion tool_motion{channel};
    TiltedPlanes tilted_planes{channel};
    Carriers carriers{channel};
    VirtualPlane virtual_plane{channel};
    Cornering cornering{channel};
    RadiusCompensation compensation{channel};
    SmoothApproaches approaches{channel};
    Stages stages{channel};
    PathSmoothing smoothing{channel};
    Splines splines{channel};
    Cycles cycles{channel};
    CycleShapes shapes{channel};
    ContourTables contours{channel};
    Motions motions{channel};
    MotionChecks checks{channel};
    DangerWatch dangers{channel};
    Answers answers{channel};
    BlockFunctions functions{channel};
    Executor executor{channel};
    Executed executed{executor};
    FeedCharacteristics characteristics{
        executed, [this] { return channel_state.motion.dynamics.has_feed_characteristic(); },
        [this](const path::Command& command, double at) { feed.report_varying_feed(command, at); }};
};

Interpreter::Interpreter(const nc::Dialect& dialect, const machine::Machine& machine,
                         Stream<nc::Block>& blocks, const nc::BlockLocations* locations,
                         CycleExpander* cycles, const InterpreterOptions& options,
                         DiagnosticSink& sink)
    : state_(new State(dialect, machine, blocks, locations, cycles, options, sink)) {}

Interpreter::~Interpreter() = default;

std::size_t Interpreter::pull(std::span<path::Command> out) {
    return state_->characteristics.pull(out);
}
bool Interpreter::alarmed() const { return state_->channel_state.reporter.has_alarm(); }
std::vector<StateItem> Interpreter::state() const { return state_->answers.state(); }
const AxisValues& Interpreter::position() const {
    return state_->channel_state.motion.position.here();
}
Snapshot Interpreter::snapshot() const { return state_->answers.snapshot(); }
std::vector<ProbeTouch> Interpreter::touches_ahead() const {
    return state_->channel_state.motion.probe.touches_ahead();
}

std::uint64_t Interpreter::blocks() const { return state_->channel_state.motion.block_count; }

double Interpreter::elapsed() { return state_->asked().answers.run_time(); }
std::optional<double> Interpreter::quantity(nc::SystemQuantity quantity, std::int64_t first,
                                            std::int64_t second) {
    return state_->asked().answers.quantity(quantity, first, second);
}
ControlAccess::Write Interpreter::set_quantity(nc::SystemQuantity quantity, std::int64_t first,
                                               std::int64_t second, double value,
                                               bool acts_at_once) {
    return state_->asked().answers.set_quantity(quantity, first, second, value, acts_at_once);
}
std::optional<control::ControlFrame> Interpreter::frame(nc::SystemQuantity quantity,
                                                        std::int64_t number) {
    return state_->asked().frames.frame(quantity, number);
}
ControlAccess::Write Interpreter::set_frame(nc::SystemQuantity quantity, std::int64_t number,
                                            const control::ControlFrame& frame, bool acts_at_once) {
    return state_->asked().frames.set_frame(quantity, number, frame, acts_at_once);
}
bool Interpreter::is_length(std::int64_t axis) const { return state_->answers.is_length(axis); }
bool Interpreter::is_compensated() const { return state_->answers.is_compensated(); }
std::string_view Interpreter::begin_contour() { return state_->asked().contours.begin_contour(); }
std::optional<ContourElements> Interpreter::end_contour() {
    return state_->asked().contours.end_contour();
}
bool Interpreter::is_at_pattern_position() const { return state_->cycles.is_at_pattern_position(); }
void Interpreter::leave_pattern_position() { state_->asked().cycles.leave_pattern_position(); }
void Interpreter::leave_pattern() { state_->asked().cycles.leave_pattern(); }
void Interpreter::keep_frames() { state_->asked().frames.keep_frames(); }
void Interpreter::restore_frames(bool is_wanted) {
    state_->asked().frames.restore_frames(is_wanted);
}
std::optional<std::string> Interpreter::text(nc::SystemQuantity quantity, std::int64_t index) {
    return state_->answers.text(quantity, index);
}
ControlAccess::Write Interpreter::set_text(nc::SystemQuantity quantity, std::int64_t index,
                                           std::string_view text) {
    return state_->asked().answers.set_text(quantity, index, text);
}
std::optional<std::int64_t> Interpreter::axis_number(Axis axis) const {
    return state_->answers.axis_number(axis);
}
bool Interpreter::has_spindle(std::int64_t number) const {
    return state_->spindles.has_spindle(number);
}
double Interpreter::word_factor(std::int64_t axis) const {
    return state_->answers.word_factor(axis);
}

}  // namespace kadr::interp
