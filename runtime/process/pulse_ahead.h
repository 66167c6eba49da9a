// pulse_ahead.h — which speed every point between two blocks gets, so that all blocks end on
// pulses.
//
// What look-ahead is for limits of acceleration, this is for windows of time. A pass backward from
// rest gives every point the bands of speed from which the rest of the path hits its windows, band
// by band with the number of pulse intervals that it then takes: a block that ends slowly at a
// corner needs more time, and the blocks before it know. Forward, a block takes the fewest
// intervals; its end speed is reduced from what the look-ahead allows towards the mean speed of
// the blocks to come, and by bisection to where the window is hit; its top speed is reduced, again
// by bisection, until it lasts the ticks of the window exactly (pulses.h). Because every point can
// be stopped at and waited for, one is always found; a window that is missed costs one interval.
//
// Knows lengths, speeds and accelerations; no geometry and no axes. Streaming as
// motion/lookahead.h.
//
// source: the laser dissertation, Fig. 11; reference motion §3.4
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "process/pulses.h"

namespace kadr::process {

/// A leg with its time.
struct PulseBlock {
    motion::Profile profile;
    std::int64_t ticks = 0;
    std::int64_t intervals = 0;  // pulse intervals that end with it
};

class PulseAhead {
  public:
    /// `depth` ≥ 1: so many legs are known at least when one is taken, or all up to the end.
    PulseAhead(const PulseClock& clock, double tick, std::size_t depth = 32);

    bool is_empty() const { return count_ == 0; }
    bool is_full() const { return count_ == nodes_.size(); }
    /// A leg behind those that are known. The first one begins at rest.
    void append(const PulseLeg& leg);
    /// The path comes to rest behind what is known. After all legs are taken a new path may begin.
    void finish() { is_finished_ = true; }

    bool is_ready() const { return takeable_ > 0 || is_full() || (is_finished_ && count_ > 0); }
    /// The oldest leg, which is then forgotten. Only if `is_ready`.
    ///
    /// since        ticks since the last pulse; 0 if the point before was burnt just now
    PulseBlock take(std::int64_t since);

  private:
    /// Speeds from which the rest of the path takes so many intervals.
    struct Band {
        std::int64_t intervals = 0;
        double low = 0;
        double high = 0;
    };
    using Bands = std::vector<Band>;
    struct Node {
        PulseLeg leg;
        double limit = 0;  // of the point before it
        Bands bands;       // of the point before it
    };
    struct PulseChoice {
        std::int64_t window = 0;     // intervals of this leg
        std::int64_t intervals = 0;  // of the whole rest
        std::int64_t ticks = 0;      // of this leg
        double low = 0;              // end speeds, of which one takes these ticks
        double high = 0;
    };

    Node& node(std::size_t i) { return nodes_[(first_ + i) % nodes_.size()]; }
    void plan_backward();
    void find_bands(Node& at, const Bands& behind) const;
    std::vector<PulseChoice> choices(const Node& at, const Bands& behind, std::int64_t since) const;
    double wanted_exit(std::size_t legs);
    std::int64_t ticks_in(const PulseWindow& window, const Durations& time, std::int64_t wished,
                          std::int64_t since) const;
    PulseBlock block_of(const PulseLeg& leg, const PulseChoice& choice, double wanted) const;

    PulseClock clock_;
    double tick_;
    std::vector<Node> nodes_;  // a ring
    std::size_t first_ = 0;
    std::size_t count_ = 0;
    std::size_t chunk_;         // legs that one backward pass serves
    std::size_t takeable_ = 0;  // legs that may go before the next backward pass
    double speed_ = 0;          // at the point before the oldest leg
    double last_speed_ = 0;     // limit of the last leg appended
    bool is_finished_ = false;
};

}  // namespace kadr::process
