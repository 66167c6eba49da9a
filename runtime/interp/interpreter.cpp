#include "interp/interpreter.h"

#include "interp/executor.h"
#include "interp/feed_characteristics.h"

namespace kadr::interp {

namespace {

/// The executor as a stream.
class Executed final : public Stream<path::Command> {
  public:
    explicit Executed(Executor& executor) : executor_(executor) {}
    std::size_t pull(std::span<path::Command> out) override { return executor_.pull(out); }

  private:
    Executor& executor_;
};

}  // namespace

struct Interpreter::State {
    Executor executor;
    Executed executed{executor};
    FeedCharacteristics courses{executed, [this] { return executor.has_feed_characteristic(); },
                                [this](const path::Command& command, double feed) {
                                    executor.report_varying_feed(command, feed);
                                }};
};

Interpreter::Interpreter(const nc::Dialect& dialect, const machine::Machine& machine,
                         Stream<nc::Block>& blocks, const nc::BlockLocations* places,
                         CycleExpander* cycles, const InterpreterOptions& options,
                         DiagnosticSink& sink)
    : state_(new State{Executor(dialect, machine, blocks, places, cycles, options, sink)}) {}

Interpreter::~Interpreter() = default;

std::size_t Interpreter::pull(std::span<path::Command> out) { return state_->courses.pull(out); }
bool Interpreter::alarmed() const { return state_->executor.alarmed(); }
std::vector<StateItem> Interpreter::state() const { return state_->executor.state(); }
const AxisValues& Interpreter::position() const { return state_->executor.position(); }
Snapshot Interpreter::snapshot() const { return state_->executor.snapshot(); }
std::vector<ProbeTouch> Interpreter::touches_ahead() const {
    return state_->executor.touches_ahead();
}

std::uint64_t Interpreter::blocks() const { return state_->executor.blocks(); }

double Interpreter::elapsed() { return state_->executor.elapsed(); }
std::optional<double> Interpreter::quantity(nc::Quantity quantity, std::int64_t first,
                                            std::int64_t second) {
    return state_->executor.quantity(quantity, first, second);
}
ControlAccess::Write Interpreter::set_quantity(nc::Quantity quantity, std::int64_t first,
                                               std::int64_t second, double value,
                                               bool acts_at_once) {
    return state_->executor.set_quantity(quantity, first, second, value, acts_at_once);
}
std::optional<control::ControlFrame> Interpreter::frame(nc::Quantity quantity,
                                                        std::int64_t number) {
    return state_->executor.frame(quantity, number);
}
ControlAccess::Write Interpreter::set_frame(nc::Quantity quantity, std::int64_t number,
                                            const control::ControlFrame& frame, bool acts_at_once) {
    return state_->executor.set_frame(quantity, number, frame, acts_at_once);
}
bool Interpreter::is_length(std::int64_t axis) const { return state_->executor.is_length(axis); }
bool Interpreter::is_compensated() const { return state_->executor.is_compensated(); }
std::string_view Interpreter::begin_contour() { return state_->executor.begin_contour(); }
std::optional<ContourElements> Interpreter::end_contour() { return state_->executor.end_contour(); }
bool Interpreter::is_at_pattern_position() const {
    return state_->executor.is_at_pattern_position();
}
void Interpreter::leave_pattern_position() { state_->executor.leave_pattern_position(); }
void Interpreter::leave_pattern() { state_->executor.leave_pattern(); }
void Interpreter::keep_frames() { state_->executor.keep_frames(); }
void Interpreter::restore_frames(bool is_wanted) { state_->executor.restore_frames(is_wanted); }
std::optional<std::string> Interpreter::text(nc::Quantity quantity, std::int64_t index) {
    return state_->executor.text(quantity, index);
}
ControlAccess::Write Interpreter::set_text(nc::Quantity quantity, std::int64_t index,
                                           std::string_view text) {
    return state_->executor.set_text(quantity, index, text);
}
std::optional<std::int64_t> Interpreter::axis_number(Axis axis) const {
    return state_->executor.axis_number(axis);
}
bool Interpreter::has_spindle(std::int64_t number) const {
    return state_->executor.has_spindle(number);
}
double Interpreter::word_factor(std::int64_t axis) const {
    return state_->executor.word_factor(axis);
}

}  // namespace kadr::interp
