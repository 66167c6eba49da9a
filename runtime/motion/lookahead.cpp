#include "motion/lookahead.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/assert.h"
#include "motion/smooth_profile.h"

namespace kadr::motion {

LookAhead::LookAhead(std::size_t depth) {
    depth = std::max<std::size_t>(depth, 1);
    // One pass costs at most the whole window, so a piece costs at most 33 steps.
    chunk_ = depth / 32 + 1;
    capacity_ = depth + chunk_ - 1;
    nodes_.resize(std::bit_ceil(capacity_));
    mask_ = nodes_.size() - 1;
}

void LookAhead::append(const Stretch& stretch) {
    KADR_ASSERT(!is_finished_, "the look-ahead has ended");
    if (count_ == nodes_.size()) grow();
    Node& fresh = node(count_++);
    fresh = node_of(stretch);
    fresh.limit = std::min({fresh.corner, last_speed_, fresh.speed});
    last_ = fresh;
    last_speed_ = fresh.exit_speed(overrides_);
    pieces_ += stretch.pieces;
}

LookAhead::Node LookAhead::node_of(const Stretch& stretch) const {
    Node fresh;
    fresh.length = stretch.length;
    fresh.acceleration = stretch.acceleration;
    fresh.jerk = stretch.jerk;
    fresh.pieces = stretch.pieces;
    fresh.gain = 2 * stretch.acceleration * stretch.length;
    fresh.most = stretch.most();
    fresh.corner = stretch.entry_limit * stretch.entry_limit;
    if (stretch.has_varying_feed()) {
        fresh.has_varying_feed = true;
        fresh.entry_feed = stretch.entry_feed * stretch.entry_feed;
        fresh.exit_feed = stretch.exit_feed * stretch.exit_feed;
        fresh.corner *= fresh.entry_feed;
    }
    fresh.speed = fresh.entry_speed(overrides_);
    return fresh;
}

void LookAhead::append(const BentCell& cell, double entry_limit) {
    append(Stretch{cell.length, cell.speed, cell.acceleration, entry_limit});
    cells_.resize(nodes_.size());
    cells_[(first_ + count_ - 1) & mask_] = cell;
    node(count_ - 1).is_cell = true;
}

void LookAhead::grow() {
    std::vector<Node> larger(2 * nodes_.size());
    std::vector<BentCell> cells(cells_.empty() ? 0 : larger.size());
    for (std::size_t i = 0; i < count_; ++i) {
        larger[i] = node(i);
        if (node(i).is_cell) cells[i] = cells_[(first_ + i) & mask_];
    }
    nodes_ = std::move(larger);
    cells_ = std::move(cells);
    mask_ = nodes_.size() - 1;
    first_ = 0;
}

double LookAhead::Node::entry_speed(const Overrides& overrides) const {
    const double own = most.speed_at(overrides);
    return own * own * (has_varying_feed ? entry_feed : 1);
}

double LookAhead::Node::exit_speed(const Overrides& overrides) const {
    const double own = most.speed_at(overrides);
    return own * own * (has_varying_feed ? exit_feed : 1);
}

double LookAhead::Node::reach(double other) const {
    if (std::isinf(jerk)) return other + gain;
    const double reached = steady_reach(std::sqrt(other), length, {acceleration, jerk});
    return reached * reached;
}

double LookAhead::Node::entry_by(double after) const {
    return has_varying_feed ? entry_feed * reach(after / exit_feed) : reach(after);
}

double LookAhead::Node::exit_by(double before) const {
    return has_varying_feed ? exit_feed * reach(before / entry_feed) : reach(before);
}

/// The entry speed by what comes after.
double LookAhead::entry_of(std::size_t i, double after) const {
    const Node& current = node(i);
    if (!current.is_cell) return std::min(current.limit, current.entry_by(after));
    return entry_square(cells_[(first_ + i) & mask_], current.limit, after);
}

double LookAhead::exit_of_oldest(double limit) const {
    const Node& oldest = node(0);
    if (!oldest.is_cell) return std::min(limit, oldest.exit_by(reached_));
    return exit_square(cells_[first_], reached_, limit);
}

void LookAhead::plan_backward() {
    double after = 0;  // the path ends at rest behind what is known
    for (std::size_t i = count_; i-- > 0;) {
        Node& current = node(i);
        const double entry = entry_of(i, after);
        // Everything before depends on this speed alone: unchanged here, unchanged there.
        if (i < planned_ && entry == current.backward) break;
        current.backward = entry;
        after = entry;
    }
    planned_ = count_;
}

/// How many stretches may go before the next backward pass: as long as a window of `depth` pieces
/// is known from the current one on.
std::size_t LookAhead::takeable() const {
    if (is_finished_) return count_;
    const std::size_t depth = capacity_ + 1 - chunk_;
    std::size_t known = pieces_;
    std::size_t taken = 0;
    while (taken < count_ && known >= depth) known -= node(taken++).pieces;
    return std::max<std::size_t>(taken, 1);
}

void LookAhead::plan_if_needed() {
    KADR_ASSERT(is_ready(), "the look-ahead does not know enough yet");
    if (takeable_ > 0) return;
    plan_backward();
    takeable_ = takeable();
}

JunctionSpeeds LookAhead::take() {
    plan_if_needed();
    const double exit_limit = count_ > 1 ? node(1).backward : 0.0;
    const double exit = exit_of_oldest(exit_limit);
    const JunctionSpeeds speeds{std::sqrt(reached_), std::sqrt(exit)};
    reached_ = exit;
    drop();
    return speeds;
}

void LookAhead::drop() {
    pieces_ -= node(0).pieces;
    first_ = (first_ + 1) & mask_;
    --count_;
    if (planned_ > 0) --planned_;
    if (takeable_ > 0) --takeable_;
}

// ------------------------------------------------------------------------------ overrides

void LookAhead::set_overrides(const Overrides& overrides) {
    overrides_ = overrides;
    double before = 0;  // the entry of the oldest stretch is behind: its limit has no say
    for (std::size_t i = 0; i < count_; ++i) {
        Node& current = node(i);
        current.speed = current.entry_speed(overrides);
        current.limit = std::min({current.corner, before, current.speed});
        before = current.exit_speed(overrides);
    }
    last_speed_ = last_.exit_speed(overrides);
    planned_ = 0;
    takeable_ = 0;
}

double LookAhead::exit_limit() {
    plan_if_needed();
    return count_ > 1 ? std::sqrt(node(1).backward) : 0;
}

void LookAhead::put_back(const Stretch& stretch, double entry) {
    if (count_ == nodes_.size()) grow();
    first_ = (first_ + mask_) & mask_;
    ++count_;
    node(0) = node_of(stretch);
    node(0).limit = std::min(node(0).corner, node(0).speed);
    pieces_ += stretch.pieces;
    // What is known behind it has not changed.
    ++planned_;
    ++takeable_;
    depart(entry);
}

}  // namespace kadr::motion
