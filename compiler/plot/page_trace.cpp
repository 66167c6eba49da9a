#include "plot/page_trace.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/assert.h"
#include "base/units.h"

namespace kadr::plot {

namespace {

// Tolerance of the first pass, mm and deg: a tenth of a pixel where a part of 100 mm fills a
// screen.
constexpr double kFirstPageTolerance = 0.01;
// A read-out of the feed may be as far off in the first pass: 5 mm/min and 2 percent of it. Ramps
// up and down in every block would else need more room than where the axes are.
constexpr double kFeed = 5;
constexpr double kFeedShare = 0.02;
// The first joining of blocks: what passes in less cannot be seen, s.
constexpr double kFirstBlock = 0.002;
constexpr double kSameTool = 1e-6;  // mm
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

PageTrace::PageTrace(const machine::Machine& machine, std::size_t most_samples,
                     std::size_t most_blocks)
    : machine_(machine),
      most_samples_(most_samples),
      most_blocks_(most_blocks),
      step_(kFirstPageTolerance),
      tolerance_(kFirstPageTolerance) {
    KADR_ASSERT(most_samples >= 4 && most_blocks >= 4, "a page without room");
}

double PageTrace::column_tolerance(const Sample& sample, std::size_t i) const {
    if (i < kAxes) return step_;
    return step_ / kFirstPageTolerance * (kFeed + kFeedShare * sample.feed);
}

void PageTrace::add(const motion::Setpoint& setpoint) {
    Sample sample;
    sample.time = setpoint.time;
    sample.feed = mm_min_from_feed(setpoint.feed);
    for (std::size_t i = 0; i < machine_.axes.size(); ++i) {
        const double value = setpoint.axis[i];
        sample.axis[i] = machine_.axes[i].is_rotary ? deg_from_rad(value) : value;
    }
    take(sample);
}

/// Holds a sample against the cone of lines that miss no setpoint since the last kept one by more
/// than the tolerance; outside of it the sample before is kept, and the cone begins there.
void PageTrace::take(const Sample& sample) {
    if (samples_.empty()) {
        samples_.push_back(sample);
        open_cone();
        return;
    }
    if (has_pending_ && !reaches(sample)) {
        samples_.push_back(pending_);
        has_pending_ = false;
        if (samples_.size() >= most_samples_) thin();
        open_cone();
    }
    narrow(sample);
    pending_ = sample;
    has_pending_ = true;
}

void PageTrace::open_cone() {
    lower_.fill(-kInfinity);
    upper_.fill(kInfinity);
}

bool PageTrace::reaches(const Sample& sample) const {
    const Sample& from = samples_.back();
    const double time = sample.time - from.time;
    for (std::size_t i = 0; i < kColumns; ++i) {
        const double distance = column(sample, i) - column(from, i);
        if (distance < lower_[i] * time || distance > upper_[i] * time) return false;
    }
    return true;
}

void PageTrace::narrow(const Sample& sample) {
    const Sample& from = samples_.back();
    const double time = sample.time - from.time;
    if (!(time > 0)) return;
    for (std::size_t i = 0; i < kColumns; ++i) {
        const double distance = column(sample, i) - column(from, i);
        lower_[i] = std::max(lower_[i], (distance - column_tolerance(sample, i)) / time);
        upper_[i] = std::min(upper_[i], (distance + column_tolerance(sample, i)) / time);
    }
}

/// The same once more over what was kept, with twice the tolerance, until a quarter of it has gone:
/// more would be a loss, less would have to be done again too soon.
void PageTrace::thin() {
    while (4 * samples_.size() > 3 * most_samples_) {
        step_ *= 2;
        tolerance_ += step_;
        const std::vector<Sample> kept = std::exchange(samples_, {});
        samples_.push_back(kept.front());
        open_cone();
        for (std::size_t i = 1; i < kept.size(); ++i) {
            if (i > 1 && !reaches(kept[i])) {
                samples_.push_back(kept[i - 1]);
                open_cone();
            }
            narrow(kept[i]);
        }
        if (samples_.back().time < kept.back().time) samples_.push_back(kept.back());
    }
}

void PageTrace::finish() {
    if (has_pending_) samples_.push_back(pending_);
    has_pending_ = false;
}

std::uint32_t PageTrace::tool_of(const motion::Segment& segment) {
    const path::Vec3 tool = segment.carrier;
    const auto known = std::ranges::find_if(
        tools_, [&](const path::Vec3& other) { return (other - tool).norm() < kSameTool; });
    if (known != tools_.end()) return static_cast<std::uint32_t>(known - tools_.begin());
    tools_.push_back(tool);
    return static_cast<std::uint32_t>(tools_.size() - 1);
}

/// Whether a block goes on as a cut: where R1 turns at the pole first, the tip stands, and that is
/// planned as rapid.
bool PageTrace::becomes_feed(const PageBlock& block) const {
    PageBlock before = blocks_.back();
    if (before.kind != motion::SegmentKind::Rapid || block.kind != motion::SegmentKind::Feed)
        return false;
    before.kind = block.kind;
    return block.is_same(before);
}

void PageTrace::add(PageBlock block, const motion::Segment& segment) {
    block.time = segment.start_time;
    block.kind = segment.kind;
    block.tool = tool_of(segment);
    const bool begins_anew = std::exchange(begins_anew_, segment.ends_command);
    if (!begins_anew && block.is_same(blocks_.back())) return;
    if (!begins_anew && becomes_feed(block)) {
        blocks_.back().kind = block.kind;
        return;
    }
    // What took no time was never seen.
    if (!blocks_.empty() && !(block.time > blocks_.back().time)) blocks_.pop_back();
    if (blocks_.size() >= most_blocks_) thin_blocks();
    blocks_.push_back(block);
}

/// Joins what passes too quickly to what comes behind it, until half of the blocks have gone.
void PageTrace::thin_blocks() {
    shortest_block_ = std::max(shortest_block_, kFirstBlock);
    while (blocks_.size() > most_blocks_ / 2) {
        std::vector<PageBlock> kept;
        for (const PageBlock& block : blocks_) {
            const bool is_short = !kept.empty() && block.time - kept.back().time < shortest_block_;
            if (is_short && kept.size() > 1) {
                const double time = kept.back().time;
                kept.back() = block;
                kept.back().time = time;
            } else {
                kept.push_back(block);
            }
        }
        blocks_ = std::move(kept);
        shortest_block_ *= 2;
    }
}

}  // namespace kadr::plot
