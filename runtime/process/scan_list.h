// scan_list.h — what a scanner is given in one go, and how long it takes.
//
// Motions come one after the other; each is written down when the next one is known, because the
// delay behind it depends on what follows: behind a jump the jump delay, between two marks the
// polygon delay with the beam on, behind the last mark of a chain the mark delay. The beam comes
// `laser_on` behind the start of a chain and goes `laser_off` behind its end. Motions and delays
// last a whole number of the controller's steps.
//
// No commands of programs and no axes (scanner.h); no points on the workpiece (scan_field.h).
//
// source: reference motion §4; manuals of the RTC boards, chapter on delays
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "machine/scanner_data.h"
#include "motion/segment.h"
#include "process/scan_field.h"

namespace kadr::process {

/// One line of a list.
struct ScanCommand {
    enum class Kind : std::uint8_t {
        MarkSpeed,  // `value` mm/s on the workpiece, for the marks from here on
        Jump,       // to `to` in `value` s
        Mark,       // likewise, the beam on
        Micro,      // a mark without a delay behind it: the path goes on
        Wait,       // `value` s, the beam off
        Expose,     // `value` s, the beam on
    };
    Kind kind = Kind::Jump;
    Vec2 to = Vec2::Zero();  // mm in the field, corrected
    double value = 0;
    std::uint32_t line = 0;  // of the ISO-7bit text
};

struct ScanList {
    std::vector<ScanCommand> commands;
    std::vector<motion::Segment> pieces;  // kind, curve, times from the list's start, feed, line
    double duration = 0;                  // s
};

/// A motion of the beam; its segment has the path on the workpiece, its kind, feed and line.
struct ScanMotion {
    motion::Segment segment;
    std::vector<FieldStep> vectors;       // at least one
    double duration = 0;                  // s, before it is rounded up to steps
    Vec2 first_direction = Vec2::Zero();  // unit vectors on the workpiece
    Vec2 last_direction = Vec2::Zero();
};

class ScanListBuilder {
  public:
    /// The scanner outlives the builder.
    explicit ScanListBuilder(const machine::Scanner& scanner) : scanner_(scanner) {}

    /// `speed` of a mark, mm/s on the workpiece.
    void add(ScanMotion motion, double speed);
    /// Waits in place, with the beam or without. The segment has position and line.
    void stand(const motion::Segment& segment, double time, bool is_exposing);

    /// Commands that the list has at least.
    std::size_t size() const { return list_.commands.size(); }
    bool is_empty() const { return list_.commands.empty() && !waiting_; }
    /// The list so far, without the motion that waits for the next one; the beam goes on.
    ScanList cut();
    /// The list to its end, the beam off.
    ScanList finish();

  private:
    enum class Next : std::uint8_t { Mark, Other };
    struct Waiting {
        ScanMotion motion;
        double speed = 0;
    };

    double whole_steps(double time) const;
    void write_waiting(Next next, const Vec2& direction);
    void write_motion(const Waiting& waiting);
    void write_delay(const motion::Segment& behind, double time, double beam_off);
    void put_piece(motion::Segment piece, double duration, double beam_off);
    void open_beam(double time);

    const machine::Scanner& scanner_;
    ScanList list_;
    std::optional<Waiting> waiting_;
    double speed_ = 0;         // given last
    bool is_beam_on_ = false;  // or will be, at `next_pulse_`
    double next_pulse_ = 0;    // s from the list's start
};

}  // namespace kadr::process
