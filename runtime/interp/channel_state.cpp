#include "interp/channel_state.h"

#include <limits>

#include "base/units.h"
#include "nc/dialect.h"

namespace kadr::interp {

namespace {

constexpr CornerSettings corner_settings(const nc::Rules& rules) {
    return {rules.corner_strict, rules.corner_feed_of_next, rules.corner_empty_blocks};
}

/// A number of the machine, mm or degrees.
double in_degrees(const machine::MachineAxis& axis, double value) {
    return axis.is_rotary ? deg_from_rad(value) : value;
}

AxisData axis_data(const machine::Machine& machine, bool is_lathe) {
    AxisData axes;
    axes.lower.fill(-std::numeric_limits<double>::infinity());
    axes.upper.fill(std::numeric_limits<double>::infinity());
    axes.word_scale.fill(1);
    if (is_lathe) axes.word_scale[index(Axis::X)] = 0.5;
    for (const machine::MachineAxis& axis : machine.axes) {
        axes.present |= bit(axis.axis);
        axes.lower[index(axis.axis)] = in_degrees(axis, axis.lower);
        axes.upper[index(axis.axis)] = in_degrees(axis, axis.upper);
        for (std::size_t point = 0; point < machine::kReferencePoints; ++point) {
            const std::optional<double> place =
                point == 0 ? axis.home : axis.further_homes[point - 1];
            if (!place) continue;
            axes.reference_points[point][index(axis.axis)] = in_degrees(axis, *place);
            axes.has_reference_point[point] |= bit(axis.axis);
        }
    }
    return axes;
}

/// Blocks of a batch: enough to hide the cost of a pull, few enough to stay in the nearest cache.
constexpr std::size_t kProgramBatch = 64;

}  // namespace

ChannelState::ChannelState(const nc::Dialect& of_dialect, const machine::Machine& of_machine,
                           Stream<nc::Block>& blocks, const nc::BlockLocations* locations,
                           CycleExpander* cycles, const InterpreterOptions& given,
                           DiagnosticSink& sink)
    : dialect(of_dialect),
      machine(of_machine),
      rules(dialect.rules()),
      is_lathe(machine.is_lathe || dialect.is_of_lathe()),
      options(given),
      axes(axis_data(machine, is_lathe)),
      reporter(dialect, locations, sink),
      clocks(machine),
      motion{.dynamics = ProgrammedDynamics(machine, axes, reporter),
             .probe = Probe(options.probe, options.touches)},
      frame{.frames = control::Frames(rules)},
      tool{.tool_offsets = ToolOffsets(machine, is_lathe),
           .tool_names = ToolNames(machine),
           .carriers = ToolCarriers(machine)},
      stage{.corners = Corners(corner_settings(rules))},
      cycle{.cycles = cycles, .callers = Callers(blocks, options.in_step ? 1 : kProgramBatch)} {
    AxisValues home{};
    for (const machine::MachineAxis& axis : machine.axes)
        home[index(axis.axis)] = in_degrees(axis, axis.home);
    motion.position.stand_at(home);
    motion.position.come_from({home[0], home[1], home[2]});
    for (const AxisValues& offset : machine.work_offsets)
        frame.work_offsets.push_back({.shift = offset});
    frame.work_offset = rules.default_work_offset;
}

KeptState ChannelState::keep() const {
    return {motion.position, spindle.spindle, tool.tool, motion.length_shift, spindle.coolant};
}

void ChannelState::take_back(const KeptState& kept) {
    motion.position = kept.position;
    spindle.spindle = kept.spindle;
    tool.tool = kept.tool;
    motion.length_shift = kept.length_shift;
    spindle.coolant = kept.coolant;
}

}  // namespace kadr::interp
