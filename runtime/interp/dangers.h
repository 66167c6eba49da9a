// dangers.h — what the watch for dangerous words has seen so far. Internal to interp.
//
// The watch (dangers.cpp) looks where something changes: at the first cut of a feed, at the first
// motion of a length, at a change of the tool. A plain block pays one comparison.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "path/command.h"

namespace kadr::interp {

struct Dangers {
    /// The feed of the latest cut that was looked at, in the unit of its mode.
    double feed = std::numeric_limits<double>::quiet_NaN();
    path::FeedMode feed_mode = path::FeedMode::PerMinute;

    /// The length that the latest motion of its axis had, and the tool that was in.
    std::int64_t length = 0;
    std::int64_t tool = 0;
    bool has_lengths = false;               // the program has called a length by its number
    std::int64_t cut_tool = 0;              // whose cuts were looked at for a length
    std::vector<std::int64_t> own_offsets;  // of a lathe: numbers that tools have called as theirs

    bool has_moved = false;                     // since the start
    bool is_at_rapid = false;                   // the latest motion was one
    bool has_rapid_end = false;                 // … and before a cut there was one
    path::Vec3 rapid_end = path::Vec3::Zero();  // of the tip in the base system

    /// A motion is about to be put out.
    ///
    /// here  where the tip stands, that is the end of the motion before
    void begin_motion(path::Op op, const AxisValues& here) {
        if (is_at_rapid) {
            rapid_end = {here[0], here[1], here[2]};
            has_rapid_end = true;
        }
        is_at_rapid = op == path::Op::Rapid;
        has_moved = true;
    }
};

}  // namespace kadr::interp
