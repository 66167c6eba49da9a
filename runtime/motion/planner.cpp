#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/assert.h"
#include "motion/axis_table.h"
#include "motion/lookahead.h"
#include "motion/pipeline.h"
#include "motion/prepare.h"

namespace kadr::motion {

namespace {

/// Pieces between preparation and delivery: a ring that grows to the length of the look-ahead.
class PieceRing {
  public:
    Piece& push_back() {
        if (count_ == pieces_.size()) grow();
        return pieces_[(first_ + count_++) & (pieces_.size() - 1)];
    }
    void drop_back() { --count_; }
    Piece& back(std::size_t i) { return pieces_[(first_ + count_ - 1 - i) & (pieces_.size() - 1)]; }
    Piece& front() { return pieces_[first_]; }
    void pop_front() {
        first_ = (first_ + 1) & (pieces_.size() - 1);
        --count_;
    }

  private:
    void grow() {
        std::vector<Piece> larger(2 * pieces_.size());
        for (std::size_t i = 0; i < count_; ++i) {
            larger[i] = pieces_[(first_ + i) & (pieces_.size() - 1)];
        }
        pieces_ = std::move(larger);
        first_ = 0;
    }

    std::vector<Piece> pieces_ = std::vector<Piece>(64);  // a power of two
    std::size_t first_ = 0;
    std::size_t count_ = 0;
};

}  // namespace

struct Planner::State {
    State(Stream<path::Command>& commands, const machine::Machine& machine,
          const PlannerOptions& options_in, DiagnosticSink& sink)
        : options(options_in),
          axes(machine),
          preparer(commands, machine, axes, options, sink),
          lookahead(options.lookahead),
          tick(options.tick > 0 ? options.tick : machine.tick) {
        record_travel();
    }

    bool next(Segment& segment);
    void fill();
    void hand_on(const Piece& piece);
    void plan(Piece& piece, const JunctionSpeeds& speeds);
    void record(const Piece& piece);
    void record_corner(const Piece& piece);
    void record_travel();

    PlannerOptions options;
    AxisTable axes;
    Preparer preparer;
    LookAhead lookahead;
    PieceRing pieces;
    double tick;
    bool has_ended = false;
    bool is_waiting = false;  // the last piece, for the corner behind it

    Totals totals;
    AxisRates last_rates{};  // of the piece delivered last, at its end
    AxisTable::Loads last_loads;
    double last_along = 0;  // its acceleration along the path
};

void Planner::State::fill() {
    while (!has_ended && !lookahead.is_full()) {
        Piece& piece = pieces.push_back();
        if (!preparer.next(piece)) {
            pieces.drop_back();
            if (is_waiting) hand_on(pieces.back(0));
            lookahead.finish();
            has_ended = true;
            return;
        }
        // The corner behind a piece has its say in the piece's acceleration.
        if (is_waiting) {
            Piece& before = pieces.back(1);
            before.acceleration *= std::min(1.0, piece.ramp_before / before.ramp);
            hand_on(before);
        }
        is_waiting = true;
    }
}

void Planner::State::hand_on(const Piece& piece) {
    lookahead.append({piece.length, piece.speed, piece.acceleration, piece.entry_limit});
}

bool Planner::State::next(Segment& segment) {
    if (!lookahead.is_ready()) fill();
    if (!lookahead.is_ready()) {
        totals.commands = preparer.commands();
        record_travel();
        return false;
    }
    Piece& piece = pieces.front();
    plan(piece, lookahead.take());
    record(piece);
    segment = piece.segment;
    pieces.pop_front();
    return true;
}

void Planner::State::plan(Piece& piece, const JunctionSpeeds& speeds) {
    Segment& segment = piece.segment;
    segment.start_time = totals.time;
    if (!is_motion(segment.kind)) return;
    const auto profile = trapezoid(piece.length, speeds.entry, speeds.exit,
                                   {piece.speed, piece.acceleration, piece.acceleration});
    KADR_ASSERT(profile.has_value(), "the look-ahead promised a change of speed that does not fit");
    segment.profile = *profile;
    segment.duration = segment.profile.duration();
}

void Planner::State::record(const Piece& piece) {
    const Segment& segment = piece.segment;
    totals.time += segment.duration;
    switch (segment.kind) {
        case SegmentKind::Rapid: totals.rapid_time += segment.duration; break;
        case SegmentKind::Feed: totals.cutting_time += segment.duration; break;
        case SegmentKind::Dwell:
        case SegmentKind::Orient: totals.dwell_time += segment.duration; break;
        case SegmentKind::ToolChange: totals.tool_change_time += segment.duration; break;
    }
    if (!is_motion(segment.kind)) return;
    ++totals.segments;
    const double length = path::length(segment.curve);
    totals.length += length;
    if (segment.kind == SegmentKind::Feed) totals.cutting_length += length;
    const AxisTable::Peaks peaks = axes.peaks(segment, piece.loads);
    for (std::size_t i = 0; i < axes.size(); ++i) {
        totals.max_velocity[i] = std::max(totals.max_velocity[i], peaks.velocity[i]);
        totals.max_acceleration[i] = std::max(totals.max_acceleration[i], peaks.acceleration[i]);
        // The acceleration of a trapezoid begins and ends at once.
        if (peaks.acceleration[i] > 0) {
            totals.max_jerk[i] = std::numeric_limits<double>::infinity();
        }
    }
    record_corner(piece);
}

/// What setpoints show at a corner: the jump of the velocity and the ramps beside it.
void Planner::State::record_corner(const Piece& piece) {
    const Segment& segment = piece.segment;
    const double speed = segment.profile.entry_speed;
    const double along = path_acceleration(segment.profile);
    if (speed > 0) {
        for (std::size_t i = 0; i < axes.size(); ++i) {
            const double jump = std::abs(piece.rates[i] - last_rates[i]) * speed / tick;
            if (jump == 0) continue;
            const double reached = corner_acceleration(last_loads.at(i, speed, last_along),
                                                       piece.loads.at(i, speed, along), jump);
            totals.max_acceleration[i] = std::max(totals.max_acceleration[i], reached);
        }
    }
    const bool is_straight = std::holds_alternative<path::Line>(segment.curve);
    last_rates = is_straight ? piece.rates : axes.end_rates(segment);
    last_loads = piece.loads;
    last_along = along;
}

void Planner::State::record_travel() {
    totals.travel_min = preparer.travel().lower;
    totals.travel_max = preparer.travel().upper;
}

Planner::Planner(Stream<path::Command>& commands, const machine::Machine& machine,
                 const PlannerOptions& options, DiagnosticSink& sink)
    : state_(std::make_unique<State>(commands, machine, options, sink)) {}
Planner::~Planner() = default;

std::size_t Planner::pull(std::span<Segment> out) {
    std::size_t written = 0;
    while (written < out.size() && state_->next(out[written])) ++written;
    return written;
}

const Totals& Planner::totals() const { return state_->totals; }
bool Planner::alarmed() const { return state_->preparer.alarmed(); }

}  // namespace kadr::motion
