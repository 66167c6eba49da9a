// scanner.h — the motion module of a galvanometer scanner, beside the axes.
//
// A program gives motions to the scanner and back to the axes by M functions (Op::ScannerOn,
// Op::ScannerOff). In between the stage stands, coordinates go on to be points on the workpiece,
// and the scanner guides the beam there: rapids are jumps, motions at feed are marks at F. A dwell
// waits; while the spindle, that is the beam, is switched on, it exposes the point. Only where both
// are at the same point, in the middle of the field, can motions go back to the axes.
//
// Two streams, one in front of the planner and one behind it. The first takes the scanner's
// commands out, makes lists of them (scan_list.h), and puts a command to stand in place of
// each: so axes and scanner alternate, each in position before the other begins, and the planner
// needs to know nothing of scanners. The second puts the pieces of the lists where the axes stand.
//
// source: reference motion §4
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/done.h"
#include "base/stream.h"
#include "machine/machine.h"
#include "motion/axis_table.h"
#include "motion/pipeline.h"
#include "motion/spindle.h"
#include "motion/standing.h"
#include "process/scan_list.h"

namespace kadr::process {

/// Lists on their way from the first stream to the second.
using ScanLists = std::deque<ScanList>;

/// In front of the planner.
class ScannerCommands final : public Stream<path::Command> {
  public:
    /// The machine has a scanner. References outlive the stream.
    ScannerCommands(Stream<path::Command>& commands, const machine::Machine& machine,
                    const motion::PlannerOptions& options, DiagnosticSink& sink, ScanLists& lists);

    std::size_t pull(std::span<path::Command> out) override;

    /// An alarm of the scanner was reported; the stream ended before the command that caused it.
    bool alarmed() const { return has_alarmed_; }
    /// Commands that were taken from the stream behind, the refused one included.
    std::uint64_t taken() const { return taken_; }
    /// How many of them had been taken when the `count`-th command was put out; of the last batch.
    std::uint64_t taken_for(std::uint64_t count) const;

  private:
    using Report = std::function<void()>;

    bool take(path::Command& out);
    void follow(const path::Command& command);
    void follow_spindle(const path::Command& command);
    void scan(const path::Command& command);
    void scan_path(const path::Command& command);
    void scan_dwell(const path::Command& command);
    void mark(const path::Command& command, ScanMotion motion, double length);
    void put_motion(const path::Command& command, ScanMotion motion, double speed);
    void switch_on();
    void return_axes(const path::Command& command);
    void switch_off(const path::Command& command);
    void put_list(const path::Command& command, ScanList list);
    void refuse(Report report) { refusal_ = std::move(report); }
    void refuse_busy(const path::Command& command, const char* what);
    Done require_own_axes(const path::Command& command, const motion::Segment& segment,
                          const motion::AxesPosition::MotionEnd& target);
    motion::Segment still(const path::Command& command) const;

    Stream<path::Command>& commands_;
    const machine::Scanner& scanner_;
    motion::PlannerOptions options_;
    DiagnosticSink& sink_;
    ScanLists& lists_;
    motion::AxisTable axes_;
    ScanField field_;
    ScanListBuilder builder_;

    std::vector<path::Command> batch_ = std::vector<path::Command>(kBatch);
    std::size_t batch_size_ = 0;
    std::size_t batch_at_ = 0;
    std::uint64_t taken_ = 0;
    std::uint64_t put_ = 0;
    std::uint64_t batch_first_ = 0;       // number of the first command of the last batch put out
    std::vector<std::uint64_t> origins_;  // taken_ at each command of it
    std::deque<path::Command> ready_;

    std::vector<path::Op> serves_;  // whatever is programmed: the machine file gives them to it
    bool is_on_ = false;
    bool is_lent_ = false;  // on for such a command alone
    bool has_ended_ = false;
    bool has_alarmed_ = false;
    Report refusal_;  // to be reported when everything before it is planned
    motion::CommandedSpindle spindle_;
    motion::AxesPosition axes_at_;  // where the axes hold the tip
    motion::AxesPosition beam_at_;  // where the beam is, while the scanner is on
};

/// What the scanner did in a run.
struct ScanFigures {
    std::uint64_t lists = 0;
    std::uint64_t jumps = 0;
    std::uint64_t marks = 0;
    double time = 0;         // s, everything
    double mark_time = 0;    // s, motion with the beam
    double jump_time = 0;    // s
    double mark_length = 0;  // mm on the workpiece
    double jump_length = 0;
    std::uint64_t pulses = 0;
};

/// A list as it begins.
struct StartedList {
    const ScanList& list;
    double start_time = 0;  // s, from the start of the program
    path::Vec3 stage = path::Vec3::Zero();
};

/// Behind the planner.
class ScannerSegments final : public Stream<motion::Segment> {
  public:
    using Look = std::function<void(const StartedList&)>;

    /// References outlive the stream. `look`, which may be empty, sees every list as it begins.
    ScannerSegments(Stream<motion::Segment>& planned, ScanLists& lists, Look look = {});

    std::size_t pull(std::span<motion::Segment> out) override;
    const ScanFigures& figures() const { return figures_; }

  private:
    bool next(motion::Segment& out);
    void begin(const motion::Segment& standing);
    void record(const motion::Segment& piece);

    Stream<motion::Segment>& planned_;
    ScanLists& lists_;
    Look look_;
    std::vector<motion::Segment> batch_;
    std::size_t batch_size_ = 0;
    std::size_t batch_at_ = 0;
    motion::Segment standing_;  // in whose place the current list is put
    ScanList list_;
    std::size_t list_at_ = 0;
    ScanFigures figures_;
};

}  // namespace kadr::process
