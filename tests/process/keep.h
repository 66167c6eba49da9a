// keep.h — planned motion and its setpoints, kept for a test to look at.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "motion/pipeline.h"

namespace kadr::process::test {

/// Keeps what passes.
class Keep final : public Stream<motion::Segment> {
  public:
    Keep(Stream<motion::Segment>& from, std::vector<motion::Segment>& to) : from_(from), to_(to) {}
    std::size_t pull(std::span<motion::Segment> out) override {
        const std::size_t n = from_.pull(out);
        to_.insert(to_.end(), out.begin(), out.begin() + static_cast<long>(n));
        return n;
    }

  private:
    Stream<motion::Segment>& from_;
    std::vector<motion::Segment>& to_;
};

/// Samples a motion to its end in batches of this size; its segments are kept, too.
inline std::vector<motion::Setpoint> sampled(Stream<motion::Segment>& motion,
                                             const machine::Machine& machine,
                                             std::vector<motion::Segment>& segments,
                                             std::size_t batch_size = 13) {
    Keep keep(motion, segments);
    motion::Sampler sampler(keep, machine);
    std::vector<motion::Setpoint> setpoints;
    std::vector<motion::Setpoint> batch(batch_size);
    while (const std::size_t n = sampler.pull(batch)) {
        setpoints.insert(setpoints.end(), batch.begin(), batch.begin() + static_cast<long>(n));
    }
    return setpoints;
}

}  // namespace kadr::process::test
