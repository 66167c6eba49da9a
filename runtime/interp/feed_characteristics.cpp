#include "interp/feed_characteristics.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "path/complete_spline.h"
#include "path/curve_of.h"
#include "path/linear.h"

namespace kadr::interp {

using path::Command;
using path::FeedCharacteristic;
using path::FeedPolynomial;
using path::linear;
using path::Op;
using path::Vec3;

namespace {

/// Commands that are read at once where some are kept back.
constexpr std::size_t kBatch = 64;
/// A spline through points changes by a quarter from point to point towards the one that moves:
/// with so many known ahead the slopes are those of the whole, to the last digit.
constexpr std::size_t kKnown = 32;
constexpr std::size_t kWindow = 2 * kKnown;
/// Commands of which a block may consist.
constexpr std::size_t kMostOfBlock = 1024;
constexpr double kStill = 1e-9;  // mm or deg

bool has_feed(Op op) { return op >= Op::Line && op <= Op::Parametric; }

FeedCharacteristic kind_of(const Command& command) {
    const bool has_dynamics = command.is_motion() && command.motion().dynamics;
    return has_dynamics ? command.motion().dynamics->law.kind : FeedCharacteristic::Constant;
}

/// Words behind which lengths are not known, or no motion goes on.
bool breaks(const Command& command) {
    return command.op() == Op::ToolLength || command.op() == Op::Tool || command.op() == Op::End;
}

/// The same polynomial over a part of its range as one over 0 … 1.
FeedPolynomial part_of(const FeedPolynomial& feed, double from, double to) {
    return path::feed_in_units(path::feed_from(feed, from), 1, to - from);
}

}  // namespace

std::size_t FeedCharacteristics::pull(std::span<Command> out) {
    std::size_t written = 0;
    if (taken_ == held_.size()) {
        held_.clear();
        taken_ = ready_ = 0;
        if (is_drained_) return 0;
        written = commands_.pull(out);
        std::size_t plain = written;
        if (has_varying_feed_()) {
            const auto first = std::ranges::find_if(out.first(written), [](const Command& c) {
                return kind_of(c) != FeedCharacteristic::Constant;
            });
            plain = static_cast<std::size_t>(first - out.begin());
        }
        // Only what is last counts for what follows.
        std::size_t from = plain;
        while (from > 0 && !has_feed(out[from - 1].op())) --from;
        for (std::size_t i = from > 0 ? from - 1 : 0; i < plain; ++i) note(out[i]);
        if (plain == written) return written;
        const auto begin = out.begin() + static_cast<std::ptrdiff_t>(plain);
        held_.assign(begin, out.begin() + static_cast<std::ptrdiff_t>(written));
        written = plain;
    }
    while (written < out.size()) {
        if (taken_ == ready_) settle();
        if (taken_ == ready_) break;
        out[written++] = std::move(held_[taken_++]);
        // A batch that is out of varying feeds goes the short path again.
    }
    return written;
}

/// False: no command comes any more.
bool FeedCharacteristics::read() {
    if (is_drained_) return false;
    batch_.resize(kBatch);
    const std::size_t count = commands_.pull(batch_);
    is_drained_ = count == 0;
    std::move(batch_.begin(), batch_.begin() + static_cast<std::ptrdiff_t>(count),
              std::back_inserter(held_));
    return count > 0;
}

/// Lets some of what is held be ready.
void FeedCharacteristics::settle() {
    if (ready_ > kBatch) {
        held_.erase(held_.begin(), held_.begin() + static_cast<std::ptrdiff_t>(taken_));
        taken_ = ready_ = 0;
    }
    if (ready_ == held_.size()) return;
    const Command& next = held_[ready_];
    if (kind_of(next) == FeedCharacteristic::Constant) {
        note(next);
        ++ready_;
        return;
    }
    const BlockMotions run = run_from(ready_);
    // Reading has moved what is held.
    if (kind_of(held_[ready_]) == FeedCharacteristic::Spline) settle_spline(run);
    else settle_block(run);
}

/// Whether the next motion belongs to the same block.
bool FeedCharacteristics::continues(const Command& command, const Command& next) const {
    const path::Motion& first = command.motion();
    const path::Motion& then = next.motion();
    const path::FeedLaw& law = first.dynamics->law;
    return kind_of(next) == law.kind && then.dynamics->law.block == law.block &&
           then.feed == first.feed && then.feed_mode == first.feed_mode;
}

/// The motions of the block that begins here; reads until it is known where it ends.
FeedCharacteristics::BlockMotions FeedCharacteristics::run_from(std::size_t first) {
    BlockMotions run{first, first, 0};
    for (std::size_t i = first; i < first + kMostOfBlock; ++i) {
        if (i == held_.size() && !read()) break;
        if (breaks(held_[i])) break;
        if (!held_[i].is_motion()) continue;
        if (!continues(held_[first], held_[i])) break;
        run.end = i + 1;
    }
    AxisValues from = at_;
    for (std::size_t i = first; i-- > ready_;)
        if (held_[i].is_motion()) {
            from = held_[i].motion().to;
            break;
        }
    for (std::size_t i = run.first; i < run.end; ++i) {
        if (!held_[i].is_motion()) continue;
        run.length += length_of(held_[i].motion(), from);
        from = held_[i].motion().to;
    }
    return run;
}

/// mm, or deg where only rotary axes move.
double FeedCharacteristics::length_of(const path::Motion& motion, const AxisValues& from) const {
    const double length = path::length(path::curve_of(motion, linear(from), linear(motion.to)));
    if (length > kStill) return length;
    double turned = 0;
    for (std::size_t i = 3; i < kAxes; ++i) turned = std::hypot(turned, motion.to[i] - from[i]);
    return turned;
}

/// What was put out last gives where the next motion begins, and with which feed.
void FeedCharacteristics::note(const Command& command) {
    if (!command.is_motion()) return;
    const path::Motion& motion = command.motion();
    at_ = motion.to;
    if (has_feed(motion.op())) reached_ = {motion.feed, motion.feed_mode, 0, false};
    if (motion.op() == Op::Thread) reached_.reset();
}

/// Over the path of the block: from the feed before to F.
FeedPolynomial FeedCharacteristics::polynomial_of(const BlockMotions& run, double from) const {
    const path::Motion& motion = held_[run.first].motion();
    const path::FeedLaw& law = motion.dynamics->law;
    return {from, motion.feed - from - law.square - law.cube, law.square, law.cube};
}

void FeedCharacteristics::settle_block(const BlockMotions& run) {
    const Command& command = held_[run.first];
    const path::Motion& motion = command.motion();
    const bool goes_on = reached_ && reached_->mode == motion.feed_mode;
    const auto feed = polynomial_of(run, goes_on ? reached_->feed : motion.feed);
    const bool is_tangent =
        kind_of(command) == FeedCharacteristic::Polynomial && run.length > kStill;
    const Reached behind{motion.feed, motion.feed_mode,
                         is_tangent ? (feed[1] + 2 * feed[2] + 3 * feed[3]) / run.length : 0,
                         is_tangent};
    if (lay(run, feed)) reached_ = behind;
}

/// The blocks of a spline, as many as are settled at once: its slopes by those that come behind.
void FeedCharacteristics::settle_spline(const BlockMotions& first) {
    const path::Motion& start = held_[first.first].motion();
    const path::FeedMode mode = start.feed_mode;
    const bool goes_on = reached_ && reached_->mode == mode;
    std::vector<BlockMotions> runs{first};
    std::vector<path::SplineNode> nodes{{0, Vec3(goes_on ? reached_->feed : start.feed, 0, 0)}};
    const auto add = [&](const BlockMotions& run) {
        const double length = std::max(run.length, kStill);
        nodes.push_back(
            {nodes.back().parameter + length, Vec3(held_[run.first].motion().feed, 0, 0)});
    };
    add(first);
    std::optional<Vec3> last_slope;  // of a polynomial behind
    bool is_open = true;             // the spline goes on behind what is looked at
    while (is_open && runs.size() < kWindow) {
        std::size_t i = runs.back().end;
        bool is_broken = false;
        while ((i < held_.size() || read()) && !held_[i].is_motion())
            is_broken |= breaks(held_[i++]);
        is_open = i < held_.size() && !is_broken && held_[i].motion().feed_mode == mode &&
                  kind_of(held_[i]) == FeedCharacteristic::Spline;
        const bool is_polynomial = i < held_.size() && !is_broken &&
                                   held_[i].motion().feed_mode == mode &&
                                   kind_of(held_[i]) == FeedCharacteristic::Polynomial;
        if (!is_open && !is_polynomial) break;
        const BlockMotions next = run_from(i);
        if (is_open) {
            runs.push_back(next);
            add(next);
        } else if (next.length > kStill) {
            last_slope = Vec3(polynomial_of(next, nodes.back().position[0])[1] / next.length, 0, 0);
        }
    }
    const bool is_tangent = goes_on && reached_->is_tangent;
    const auto slopes = path::complete_slopes(
        nodes, is_tangent ? std::optional(Vec3(reached_->slope, 0, 0)) : std::nullopt, last_slope);
    const std::size_t settled = is_open ? kWindow - kKnown : runs.size();
    for (std::size_t k = 0; k < settled; ++k) {
        const double h = nodes[k + 1].parameter - nodes[k].parameter;
        const double rise = nodes[k + 1].position[0] - nodes[k].position[0];
        const double m0 = h * slopes[k][0];
        const double m1 = h * slopes[k + 1][0];
        if (!lay(runs[k], {nodes[k].position[0], m0, 3 * rise - 2 * m0 - m1, m0 + m1 - 2 * rise}))
            return;
        // What comes behind begins as if the spline had been one.
        reached_ = {nodes[k + 1].position[0], mode, slopes[k + 1][0], is_open};
    }
}

/// The motions of a block have this feed over the path of all of them, and may go out. False: the
/// feed falls to 0, which was reported, and nothing is held from there on.
bool FeedCharacteristics::lay(const BlockMotions& run, const FeedPolynomial& feed) {
    const double lowest = path::feed_range(feed, 0, 1).least;
    double distance = 0;
    for (std::size_t i = ready_; i < run.end; ++i) {
        Command& command = held_[i];
        if (!command.is_motion()) continue;
        if (!(lowest > 0)) {
            report_(command, lowest);
            held_.resize(i);
            is_drained_ = true;
            ready_ = i;
            return false;
        }
        path::Motion& motion = command.motion();
        const double length = length_of(motion, at_);
        const double from = run.length > 0 ? distance / run.length : 0;
        distance += length;
        const double to = i + 1 == run.end || !(run.length > 0) ? 1 : distance / run.length;
        path::FeedLaw law;
        law.feed = part_of(feed, from, to);
        if (law.is_constant() && law.feed[0] == motion.feed) law = {};
        motion.dynamics->law = law;
        if (*motion.dynamics == path::Dynamics()) motion.dynamics.reset();
        at_ = motion.to;
    }
    ready_ = run.end;
    return true;
}

}  // namespace kadr::interp
