// motion_plot.h — position, velocity, acceleration and jerk of every axis over time, as a drawing.
//
// Derivatives are differences from tick to tick, as the summary has them: of the commanded
// positions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/axes.h"
#include "machine/machine.h"
#include "motion/pipeline.h"
#include "plot/choices.h"

namespace kadr::plot {

/// The setpoints of a run, gathered in a bounded number of bins: of each the first, the least, the
/// greatest and the last value, so that no peak is lost however long the program is.
class MotionTrace {
  public:
    enum Quantity : std::size_t { Position, Velocity, Acceleration, Jerk };
    static constexpr std::size_t kQuantities = 4;

    struct Span {
        double first = 0, least = 0, greatest = 0, last = 0;
    };
    struct Bin {
        double time = 0;                                        // s, of its first tick
        Span feed;                                              // path speed, mm/s
        Span programmed;                                        // … that was asked for
        std::array<std::array<Span, kAxes>, kQuantities> axes;  // mm or rad per s, s², s³
    };
    /// While the tool stands along the rotary axis R1, or nearly so.
    struct PoleSpan {
        double from = 0;  // s
        double to = 0;
    };
    /// Where a block of the text begins to move.
    struct BlockStart {
        double time = 0;
        std::uint32_t line = 0;
    };

    /// The machine outlives the trace.
    MotionTrace(const machine::Machine& machine, double tick, const TimeWindow& window)
        : machine_(machine), tick_(tick), window_(window) {}

    void add(const motion::Setpoint& setpoint);

    const std::vector<Bin>& bins() const { return bins_; }
    const std::vector<BlockStart>& blocks() const { return blocks_; }
    /// In their order; those that are too close to be told apart are one.
    const std::vector<PoleSpan>& poles() const { return poles_; }
    /// There were more blocks than can be shown.
    bool has_too_many_blocks() const { return has_too_many_blocks_; }
    const machine::Machine& machine() const { return machine_; }

  private:
    void keep(const motion::Setpoint& setpoint);
    void keep_block(const motion::Setpoint& setpoint);
    void keep_pole(const motion::Setpoint& setpoint);
    void halve();

    const machine::Machine& machine_;
    double tick_;
    TimeWindow window_;
    std::vector<Bin> bins_;
    std::size_t stride_ = 1;   // ticks that a bin holds
    std::size_t pending_ = 0;  // of the last one, so far
    std::vector<BlockStart> blocks_;
    bool has_too_many_blocks_ = false;
    std::vector<PoleSpan> poles_;
    bool has_any_ = false;
    double last_time_ = 0;  // of the setpoint before that was shown
    std::array<std::array<double, kAxes>, kQuantities> now_{};
};

struct MotionText {
    std::string title;
    std::string subtitle;
    std::string warning;  // empty: none
};

/// The drawing as an SVG document: path speed, then a chart for each quantity with all linear axes,
/// and one with all rotary ones. Where a curve comes near a limit of its axis, the limit is a
/// dashed line; where the tool is at the pole, the charts show it.
std::string motion_svg(const MotionTrace& trace, const MotionText& text);

}  // namespace kadr::plot
