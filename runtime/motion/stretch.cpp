#include "motion/stretch.h"

#include <algorithm>
#include <cmath>

#include "motion/smooth_profile.h"

namespace kadr::motion {

namespace {

// Limits of two pieces that differ by rounding are the same.
constexpr double kSameLimit = 1e-9;
// How much of a ramp's time gathering may cost, and how much of an acceleration or a jerk.
constexpr double kCost = 0.1;
constexpr double kLeastShare = 0.5;

RampLimits ramp_of(const Stretch& limits) { return {limits.acceleration, limits.jerk}; }

/// Length of the ramps up to the speed of a stretch and down from it.
double both_ramps(const Stretch& limits) {
    return 2 * smooth_ramp_length(0, limits.speed, ramp_of(limits));
}

bool is_same(double a, double b) { return std::abs(a - b) <= kSameLimit * std::max(a, b); }

bool has_same_limits(const Stretch& a, const Stretch& b) {
    return is_same(a.speed, b.speed) && is_same(a.acceleration, b.acceleration) &&
           is_same(a.jerk, b.jerk);
}

bool is_close(double a, double b) { return std::min(a, b) >= kLeastShare * std::max(a, b); }

/// Time of a piece between its corners if it runs as fast as it can by itself: between two slow
/// corners a short piece does not come near its speed.
double time_alone(const Stretch& piece, double exit_limit) {
    const double corner = std::max(piece.entry_limit, exit_limit);
    if (corner >= piece.speed) return piece.length / piece.speed;
    const double peak = smooth_reach(corner, piece.length / 2, ramp_of(piece));
    return piece.length / std::min(piece.speed, peak);
}

}  // namespace

void StretchBuilder::add(const Stretch& piece, double exit_limit) {
    if (std::isinf(piece.jerk)) {
        close();
        complete_.push_back(piece);
        return;
    }
    const Part part{piece, time_alone(piece, exit_limit)};
    if (!joins(part)) close();
    join(part);
    split_if_long();
}

void StretchBuilder::finish() { close(); }

bool StretchBuilder::joins(const Part& part) const {
    if (parts_.empty()) return true;
    const Stretch& open = open_.limits;
    const Stretch& piece = part.limits;
    if (!(piece.entry_limit > 0)) return false;
    if (open.has_varying_feed() != piece.has_varying_feed()) return false;
    if (open.has_varying_feed() && !is_same(open.exit_feed, piece.entry_feed)) return false;
    // A thread goes on when what is before and behind it is held.
    if (!open.most().is_operated_as(piece.most())) return false;
    const double speed = std::min({open.speed, piece.speed, piece.entry_limit});
    const bool is_straight_on = std::isinf(piece.entry_acceleration);
    if (is_straight_on && piece.entry_limit >= speed && has_same_limits(open, piece)) return true;
    if (open.follows_spindle || piece.follows_spindle) return false;
    if (!is_close(open.acceleration, piece.acceleration) || !is_close(open.jerk, piece.jerk)) {
        return false;
    }
    if (open.length >= ramps_ && piece.length >= both_ramps(piece)) return false;
    const RampLimits ramp{std::min(open.acceleration, piece.acceleration),
                          std::min(open.jerk, piece.jerk)};
    const double reached = std::min(ramp.acceleration, std::sqrt(ramp.jerk * speed));
    if (piece.entry_acceleration < kLeastShare * reached) return false;
    const double cost = (open.length + piece.length) / speed - open_.time - part.time;
    return cost <= kCost * smooth_ramp_time(0, speed, ramp);
}

void StretchBuilder::join(const Part& part) {
    const Stretch& piece = part.limits;
    Stretch& open = open_.limits;
    if (parts_.empty()) {
        open_ = {piece, part.time};
        ramps_ = both_ramps(open);
    } else {
        const Stretch before = open;
        // Every boundary of pieces behind the first ramps is a point to split.
        if (cut_ == 0 && open.length >= ramps_) {
            cut_ = parts_.size();
            cut_length_ = open.length;
        }
        open.length += piece.length;
        open.exit_feed = piece.exit_feed;
        open.speed = std::min({open.speed, piece.speed, piece.entry_limit});
        open.acceleration =
            std::min({open.acceleration, piece.acceleration, piece.entry_acceleration});
        open.jerk = std::min(open.jerk, piece.jerk);
        open.feed_asked = std::min(open.feed_asked, piece.feed_asked);
        open.rapid_asked = std::min(open.rapid_asked, piece.rapid_asked);
        ++open.pieces;
        open_.time += part.time;
        if (open.speed != before.speed || open.acceleration != before.acceleration ||
            open.jerk != before.jerk) {
            ramps_ = both_ramps(open);
        }
    }
    parts_.push_back(part);
}

void StretchBuilder::split_if_long() {
    if (cut_ > 0 && cut_length_ < ramps_) cut_ = 0;  // the ramps have grown
    if (cut_ > 0 && open_.limits.length - cut_length_ >= ramps_) {
        split(cut_);
    } else if (parts_.size() >= most_) {
        split(std::max<std::size_t>(parts_.size() / 2, 1));
    }
}

/// Completes a stretch of the first `count` pieces; the others stay open.
void StretchBuilder::split(std::size_t count) {
    const std::vector<Part> all = std::move(parts_);
    parts_.clear();
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(count);
    for (auto part = all.begin(); part != middle; ++part) join(*part);
    close();
    for (auto part = middle; part != all.end(); ++part) join(*part);
}

void StretchBuilder::close() {
    if (!parts_.empty()) complete_.push_back(open_.limits);
    parts_.clear();
    cut_ = 0;
}

}  // namespace kadr::motion
