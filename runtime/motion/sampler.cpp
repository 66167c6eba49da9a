#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/units.h"
#include "motion/pipeline.h"
#include "motion/transformed.h"

namespace kadr::motion {

namespace {

// Segments are half a kilobyte; a small batch stays in the first cache.
constexpr std::size_t kSegmentBatch = 32;

// A tick that misses the end by less is at the end (reference motion §2.7).
constexpr double kTickRounding = 1e-9;

/// Speed of the tool in parts of that at which the curve is walked.
template <typename Kind>
double tool_speed(const Kind&, double) {
    return 1;
}
double tool_speed(const path::Glide& glide, double distance) {
    return path::evaluate(glide, distance).tangent.norm();
}

}  // namespace

struct Sampler::State {
    State(Stream<Segment>& segments_in, const machine::Machine& machine, double tick_in)
        : segments(segments_in), tick(tick_in > 0 ? tick_in : machine.tick) {
        if (machine.kinematics) chain = &machine.kinematics->chain;
        for (const machine::MachineAxis& axis : machine.axes) order.push_back(index(axis.axis));
    }

    std::size_t pull(std::span<Setpoint> out);
    bool next_segment();
    std::size_t walk(const Segment& segment, std::span<Setpoint> out);
    void count_train(const Segment& segment, double time);
    void rest(Setpoint& out) const;
    void place(const Segment& segment, const path::Vec3& tip, double distance, Setpoint& out) const;

    void place_transformed(const Segment& segment, double distance, Setpoint& out) const;

    double now() const { return static_cast<double>(ticks) * tick; }

    Stream<Segment>& segments;
    const machine::Chain* chain = &kNoChain;
    double tick;
    std::vector<std::size_t> order;  // logical axis of every setpoint column

    std::vector<Segment> batch = std::vector<Segment>(kSegmentBatch);
    std::size_t batch_size = 0;
    std::size_t batch_at = 0;
    Segment last;  // the segment before the one at batch_at
    bool has_any = false;
    bool has_ended = false;     // no segment is left
    bool is_done = false;       // the setpoint at rest is out
    std::uint64_t ticks = 0;    // of the next setpoint
    std::uint32_t pulses = 0;   // that the next setpoint carries
    std::uint32_t counted = 0;  // of the train of the segment at batch_at
};

/// Makes batch[batch_at] the segment of the next setpoint.
bool Sampler::State::next_segment() {
    if (batch_at == batch_size) {
        if (batch_size > 0) last = batch[batch_size - 1];
        batch_at = 0;
        batch_size = segments.pull(batch);
        if (batch_size == 0) return false;
        has_any = true;
    }
    return true;
}

std::size_t Sampler::State::pull(std::span<Setpoint> out) {
    std::size_t written = 0;
    while (written < out.size() && !has_ended) {
        if (!next_segment()) {
            has_ended = true;
            break;
        }
        const Segment& segment = batch[batch_at];
        written += walk(segment, out.subspan(written));
        // Ticks inside are written unless `out` is full.
        if (now() >= segment.end_time() - kTickRounding * tick) {
            if (segment.has_pulse) ++pulses;
            pulses += segment.train.count - counted;
            counted = 0;
            ++batch_at;
        }
    }
    if (has_ended && has_any && !is_done && written < out.size()) {
        rest(out[written++]);
        is_done = true;
    }
    return written;
}

inline void Sampler::State::place(const Segment& segment, const path::Vec3& tip, double distance,
                                  Setpoint& out) const {
    const bool is_cut = segment.kind == SegmentKind::Feed && segment.spindle.is_turning;
    out.programmed_feed = is_cut ? segment.feed : 0;
    out.nominal_feed = is_cut ? segment.nominal_feed : 0;
    out.line = segment.line;
    out.source = segment.source;
    out.tip = tip;
    if (segment.is_in_workpiece()) return place_transformed(segment, distance, out);
    const path::Vec3& carried = is_external(segment.kind) ? segment.stage : tip;
    const path::Vec3 carrier = carried + segment.carrier;
    out.tool = segment.tool;
    std::size_t column = 0;
    for (const std::size_t c : order) {
        out.axis[column++] =
            c < 3 ? carrier[static_cast<Eigen::Index>(c)]
                  : segment.follower_start[c - 3] + segment.follower_rate[c - 3] * distance;
    }
    for (; column < kAxes; ++column) out.axis[column] = 0;
}

/// The tip stays on its path, whatever the tool does; from point to point it is where the axes lead
/// it.
void Sampler::State::place_transformed(const Segment& segment, double distance,
                                       Setpoint& out) const {
    const ToolPose placed = pose_at(*chain, segment, distance, out.tip);
    out.tip = placed.tip;
    out.tool = placed.tool;
    std::size_t column = 0;
    for (const std::size_t c : order) out.axis[column++] = placed.axes[c];
    for (; column < kAxes; ++column) out.axis[column] = 0;
}

/// Writes the setpoints of the ticks before the segment's end, as far as `out` has room.
std::size_t Sampler::State::walk(const Segment& segment, std::span<Setpoint> out) {
    const double end = segment.end_time() - kTickRounding * tick;
    std::size_t written = 0;
    const auto fill = [&](const auto& curve) {
        for (; written < out.size(); ++written, ++ticks) {
            const double time = now();
            if (time >= end) return;
            const ProfileState state = state_at(segment.profile, time - segment.start_time);
            Setpoint& setpoint = out[written];
            setpoint.time = time;
            setpoint.feed = state.speed * tool_speed(curve, state.distance);
            if (segment.train.count > 0) count_train(segment, time);
            setpoint.pulses = std::exchange(pulses, 0);
            place(segment, path::position(curve, state.distance), state.distance, setpoint);
        }
    };
    std::visit(fill, segment.curve);
    return written;
}

/// The pulses of a train up to this time; one that falls on a tick belongs to it.
void Sampler::State::count_train(const Segment& segment, double time) {
    const PulseTrain& train = segment.train;
    const double since = time - segment.start_time - train.first + kTickRounding * tick;
    if (since < 0) return;
    const double passed =
        std::min(std::floor(since / train.period) + 1, static_cast<double>(train.count));
    const auto reached = std::max(counted, static_cast<std::uint32_t>(passed));
    pulses += reached - counted;
    counted = reached;
}

/// The last setpoint: at rest in the end of the path.
void Sampler::State::rest(Setpoint& out) const {
    out.time = now();
    out.feed = 0;
    out.pulses = pulses;
    place(last, path::end(last.curve), last.profile.length, out);
}

Sampler::Sampler(Stream<Segment>& segments, const machine::Machine& machine, double tick)
    : state_(std::make_unique<State>(segments, machine, tick)) {}
Sampler::~Sampler() = default;

std::size_t Sampler::pull(std::span<Setpoint> out) { return state_->pull(out); }

}  // namespace kadr::motion
