// interpreter.h — Block → Command, as the real control would.
//
// Keeps the modal state (motion, plane, units of feed, frames, offsets, position) and resolves each
// block against it. What the control would alarm on is reported with the control's number and ends
// the run; commands up to there are delivered.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/stream.h"
#include "interp/snapshot.h"
#include "machine/machine.h"
#include "machine/probe.h"
#include "macro/control_access.h"
#include "nc/dialect.h"
#include "nc/reader.h"
#include "path/command.h"
#include "path/contour.h"

namespace kadr::interp {

using macro::ContourElements;
using macro::ControlAccess;

/// The blocks of a shape that a cycle works along, as geometry of the part.
struct CycleShape {
    path::Contour elements;  // the first one's start is where the shape's first block ends
    path::Plane plane = path::Plane::Zx;
    bool is_diameter = false;  // X of points and words is a diameter
};

/// What a machining cycle is given about its surroundings.
struct CycleCall {
    nc::CycleId cycle = 0;
    std::string_view name;
    std::span<const double> arguments;  // in the order of CycleInfo::parameters; mm, deg, s
    std::uint32_t given = 0;            // bit i: argument i holds
    /// Programmed position, mm and deg: X and Y are the axes of the plane, Z is the tool axis; of a
    /// cycle that returns to a level, Z is that level, wherever the tool comes from.
    AxisValues position{};
    double feed = 0;  // the modal feed, unit of its mode; 0: none
    path::FeedMode feed_mode = path::FeedMode::PerMinute;
    double speed = 0;                                     // of the spindle, rpm
    path::SpindleMode spindle = path::SpindleMode::Stop;  // Cw and Ccw: it turns
    SourceId source;
    std::optional<TextLocation> location;  // of the block that calls it; nothing: nobody knows
    const CycleShape* shape = nullptr;     // of a cycle that takes one
    bool x_is_diameter = true;             // X of the position, and of the words that act
};

/// Expands a machining cycle into blocks. The one thing that the runtime needs from the compiler;
/// the driver wires it. Null result: the cycle is not known or failed (it has reported).
class CycleExpander {
  public:
    virtual ~CycleExpander() = default;
    virtual std::unique_ptr<Stream<nc::Block>> expand(const CycleCall& call) = 0;
    /// Whether the cycle turns: its X and Z are those of the machine, whatever the plane.
    virtual bool turns(std::string_view cycle) {
        (void)cycle;
        return false;
    }
    /// Why the definition of the latest cycle refused its parameters, in its own words; nothing: it
    /// did not, or not yet. Known when its blocks have come to their end.
    virtual std::optional<std::string> refusal() const { return std::nullopt; }
};

/// The day that a program sees if the run is not given another one: runs are to be alike.
inline constexpr std::int64_t kFirstDate = 20000101;

/// Where a probe triggers on its path, given from outside.
struct ProbeTouch {
    // The block, by one of these: its line of the text, from 1; N.
    std::uint32_t line = 0;
    std::int32_t number = -1;
    AxisMask axes = 0;  // that are given; none: it does not trigger
    AxisValues at{};    // programmed coordinates, in the units of the text
};

struct InterpreterOptions {
    std::uint64_t max_blocks = 0;   // 0: no limit
    std::uint16_t skip_levels = 0;  // bit n: blocks with skip level n are left out
    bool optional_stop = false;
    bool asks_for_tool = true;                   // warns of a cut before any tool is called
    bool has_named_machine = true;               // false: nobody has chosen which machine it is
    std::int64_t date = kFirstDate;              // day on which the run begins, YYYYMMDD
    int time_of_day = 0;                         // … and when, in seconds since midnight
    const machine::ProbeScene* probe = nullptr;  // what a probe meets; null: nobody knows
    std::vector<ProbeTouch> touches = {};
    bool in_step = false;  // no block is read before the one in front of it is executed
    /// Whether a comment silences a warning at its location, so that it is not reported once and
    /// for all there. Empty: none does.
    std::function<bool(const DiagnosticRow& row, const TextLocation& location)> is_allowed = {};
};

/// One entry of the modal state, in words: `feed`, `200 mm/min`.
struct StateItem {
    std::string_view name;
    std::string value;
    friend bool operator==(const StateItem&, const StateItem&) = default;
};

class Interpreter final : public Stream<path::Command>, public ControlAccess {
  public:
    /// All references outlive the interpreter. `locations` give the location of a block for
    /// messages. `cycles` may be null: a cycle call is then an alarm.
    Interpreter(const nc::Dialect& dialect, const machine::Machine& machine,
                Stream<nc::Block>& blocks, const nc::BlockLocations* locations,
                CycleExpander* cycles, const InterpreterOptions& options, DiagnosticSink& sink);
    ~Interpreter() override;

    std::size_t pull(std::span<path::Command> out) override;
    bool alarmed() const;          // an alarm ended the run
    std::uint64_t blocks() const;  // executed so far
    /// Touches of the options whose block has not probed so far.
    std::vector<ProbeTouch> touches_ahead() const;
    /// The modal state behind the last block, one entry a group, for people.
    std::vector<StateItem> state() const;
    /// Where the tool stands in the programmed system; mm, deg.
    const AxisValues& position() const;
    /// The same and what the modal state holds, as numbers.
    Snapshot snapshot() const;

    // What a program asks while it runs.
    double elapsed() override;
    std::optional<double> quantity(nc::SystemQuantity quantity, std::int64_t first,
                                   std::int64_t second) override;
    Write set_quantity(nc::SystemQuantity quantity, std::int64_t first, std::int64_t second,
                       double value, bool acts_at_once) override;
    std::optional<control::ControlFrame> frame(nc::SystemQuantity quantity,
                                               std::int64_t number) override;
    Write set_frame(nc::SystemQuantity quantity, std::int64_t number,
                    const control::ControlFrame& frame, bool acts_at_once) override;
    bool is_length(std::int64_t axis) const override;
    std::optional<std::string> text(nc::SystemQuantity quantity, std::int64_t index) override;
    Write set_text(nc::SystemQuantity quantity, std::int64_t index, std::string_view text) override;
    std::optional<std::int64_t> axis_number(Axis axis) const override;
    bool has_spindle(std::int64_t number) const override;
    double word_factor(std::int64_t axis) const override;
    bool is_compensated() const override;
    std::string_view begin_contour() override;
    std::optional<ContourElements> end_contour() override;
    bool is_at_pattern_position() const override;
    void leave_pattern_position() override;
    void leave_pattern() override;
    void keep_frames() override;
    void restore_frames(bool is_wanted) override;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace kadr::interp
