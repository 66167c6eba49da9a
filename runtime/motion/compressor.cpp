#include "motion/compressor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>

namespace kadr::motion {

namespace {

using path::Command;
using path::Op;
using path::Vec3;

/// Lines that are fitted at once; the first half comes out then. What the second half would have
/// been with more lines behind it changes its own path, and that of the first by little: every
/// node takes it down to a quarter.
constexpr std::size_t kWindow = 1024;
constexpr std::size_t kHalf = kWindow / 2;
/// Points in the second half where a span has to end, so that it has nodes at all.
constexpr std::array<std::size_t, 4> kEnds = {kHalf, kHalf + kHalf / 4, kHalf + kHalf / 2,
                                              kHalf + 3 * (kHalf / 4)};

/// cos of the greatest turn inside a run: 30 degrees.
constexpr double kLeastCos = 0.86602540378443865;
/// A longer line is one that is meant, mm.
constexpr double kLongest = 20;
/// A span whose inner control points are this close to its chord is a line, mm.
constexpr double kFlat = 1e-6;

bool is_flat(const path::Cubic& cubic) {
    return path::distance_to_line(cubic[1], cubic[0], cubic[3]) < kFlat &&
           path::distance_to_line(cubic[2], cubic[0], cubic[3]) < kFlat;
}

/// As many lines a curve is to take the place of on average, or they stay lines; and where more
/// than half of the curves are waves. Where the points lie farther off a smooth curve than the
/// tolerance, curves follow them in waves, whose bends the axes pass more slowly than the corners.
constexpr std::size_t kLeastLines = 2;
constexpr std::size_t kLeastLinesOfWaves = 4;

/// Whether a span bends to one side and then to the other.
bool is_wave(const path::Cubic& cubic) {
    const Vec3 middle = cubic[2] - cubic[1];
    const Vec3 first = (cubic[1] - cubic[0]).cross(middle);
    return first.dot(middle.cross(cubic[3] - cubic[2])) < 0;
}

bool is_worth_it(const std::vector<path::PolylinePart>& parts) {
    std::size_t curves = 0;
    std::size_t waves = 0;
    std::size_t lines = 0;
    for (const path::PolylinePart& part : parts) {
        if (part.is_line) continue;
        ++curves;
        waves += is_wave(part.cubic) ? 1 : 0;
        lines += part.to - part.from;
    }
    const bool are_waves = 2 * waves > curves;
    return lines >= (are_waves ? kLeastLinesOfWaves : kLeastLines) * curves;
}

/// Whether the command is a line that a run can begin with.
bool is_short_line(const Command& command, double length) {
    if (command.op() != Op::Line || command.is_unshifted) return false;
    const path::Motion& line = command.motion();
    const bool is_plain = (line.moved & ~kLinearXYZ) == 0 && !line.machine_coordinates;
    const bool has_own_time = line.feed_mode == path::FeedMode::InverseTime;
    return is_plain && !has_own_time && length > kStill && length <= kLongest;
}

}  // namespace

void Compressor::take(const Command& command, const AxesPosition& standing) {
    ready_.clear();
    next_ = 0;
    if (!command.is_motion()) {
        end_run();
        ready_.push_back(command);
        return;
    }
    const path::Motion& motion = command.motion();
    const bool was_running = !lines_.empty();
    const Vec3 to = was_running ? point_of(motion) : standing.target_of(motion).tip;
    if (was_running && !joins(command, to)) end_run();
    const Vec3 from = was_running ? points_.back() : standing.tip();
    const bool is_taken = can_take(command) && is_short_line(command, (to - from).norm());
    if (!is_taken) {
        ready_.push_back(command);
        return;
    }
    if (lines_.empty()) {
        points_.assign(1, from);
        has_slope_ = false;
    }
    lines_.push_back(command);
    points_.push_back(to);
    if (motion.exact_stop) return end_run();
    if (lines_.size() == kWindow) fit(false);
}

/// Where a line leads. An axis that is not programmed stands, whatever number it has.
Vec3 Compressor::point_of(const path::Motion& motion) const {
    Vec3 to = points_.back();
    for (std::size_t i = 0; i < 3; ++i) {
        const bool is_moved = (motion.moved & bit(static_cast<Axis>(i))) != 0;
        if (is_moved || motion.to[i] != lines_.back().motion().to[i])
            to[static_cast<Eigen::Index>(i)] = motion.to[i];
    }
    return to;
}

bool Compressor::joins(const Command& command, const Vec3& to) const {
    const path::Motion& next = command.motion();
    const path::Motion& last = lines_.back().motion();
    const Vec3 delta = to - points_.back();
    const Vec3 before = points_.back() - points_[points_.size() - 2];
    const bool is_same = next.compress == last.compress && next.feed == last.feed &&
                         next.feed_mode == last.feed_mode && next.blending == last.blending &&
                         next.keeps_feed == last.keeps_feed &&
                         next.ignores_hold == last.ignores_hold && next.dynamics == last.dynamics;
    bool others_stand = true;
    for (std::size_t i = 3; i < kAxes; ++i) others_stand &= next.to[i] == last.to[i];
    return is_same && others_stand && is_short_line(command, delta.norm()) &&
           delta.dot(before) >= kLeastCos * delta.norm() * before.norm();
}

void Compressor::finish() {
    ready_.clear();
    next_ = 0;
    end_run();
}

/// What is left of the run comes out; `points_` keeps its end, where the next one may begin.
void Compressor::end_run() {
    if (lines_.empty()) return;
    fit(true);
    points_.erase(points_.begin(), points_.end() - 1);
    has_slope_ = false;
}

/// Makes commands of the lines: of all, or of the first half of a window.
void Compressor::fit(bool is_whole) {
    path::PolylineFitOptions options;
    options.tolerance = lines_.front().motion().compress;
    if (has_slope_) options.first_slope = slope_;
    if (!is_whole) options.ends = kEnds;
    std::vector<path::PolylinePart> parts = path::fit_polyline(points_, options);
    if (!is_whole) std::erase_if(parts, [](const auto& part) { return part.from >= kHalf; });
    const std::size_t done = parts.back().to;
    if (is_worth_it(parts)) {
        for (const path::PolylinePart& part : parts) put(part);
        slope_ = parts.back().slope;
        has_slope_ = !parts.back().is_line;
    } else {
        for (std::size_t i = 0; i < done; ++i) put_line(i);
        has_slope_ = false;
    }
    lines_.erase(lines_.begin(), lines_.begin() + static_cast<std::ptrdiff_t>(done));
    points_.erase(points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(done));
}

/// Lines as one command, with the location of the last one.
void Compressor::put(const path::PolylinePart& part) {
    if (part.is_line) return put_line(part.from);
    path::Motion& motion = ready_.emplace_back(lines_[part.to - 1]).motion();
    for (std::size_t i = part.from; i + 1 < part.to; ++i)
        motion.moved = static_cast<AxisMask>(motion.moved | lines_[i].motion().moved);
    if (motion.blending.kind == path::BlendKind::Tolerance)
        motion.blending.size = std::max(0.0, motion.blending.size - part.apart);
    if (is_flat(part.cubic)) return;
    motion.become(Op::Spline);
    path::SplineShape& span = motion.spline();
    span.inner[0] = part.cubic[1];
    span.inner[1] = part.cubic[2];
}

}  // namespace kadr::motion
