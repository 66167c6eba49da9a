// short_waits.h — motion without the middle of its long waits, for those who draw it.
//
// A dwell of a year has as many ticks as a year of motion, and all of them are the same. Who walks
// the shortened motion meets each wait for some ticks at its begin and at its end; the times of the
// setpoints are put right behind.
#pragma once

#include <deque>
#include <mutex>
#include <span>
#include <vector>

#include "base/stream.h"
#include "motion/pipeline.h"

namespace kadr::driver {

class ShortWaits final : public Stream<motion::Segment> {
  public:
    /// segments  outlives the stream
    /// tick      s, at which the motion is walked
    ShortWaits(Stream<motion::Segment>& segments, double tick) : segments_(segments), tick_(tick) {}

    std::size_t pull(std::span<motion::Segment> out) override;

    /// The setpoints of the shortened motion, in their order, at the times of the whole one; valid
    /// until the next call. From another thread than `pull`, if the caller likes.
    std::span<const motion::Setpoint> restored(std::span<const motion::Setpoint> setpoints);

  private:
    struct Cut {
        double at = 0;     // s of the shortened motion
        double total = 0;  // s that are missing from there on
    };
    void shorten(motion::Segment& segment);

    Stream<motion::Segment>& segments_;
    double tick_;
    double missing_ = 0;  // s, in front of the next segment
    std::mutex mutex_;    // of the cuts
    std::deque<Cut> cuts_;
    double passed_ = 0;  // s, in front of the next setpoint
    std::vector<motion::Setpoint> setpoints_;
};

}  // namespace kadr::driver
