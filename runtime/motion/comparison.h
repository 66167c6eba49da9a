// comparison.h — how far two planned motions are from being the same.
//
// Both are walked together: what counts is where the tool goes, how fast it shall go and when it
// stands, not in how many pieces a control gives it.
#pragma once

#include <cstdint>
#include <optional>

#include "base/stream.h"
#include "motion/segment.h"
#include "motion/spindle.h"
#include "path/vec3.h"

namespace kadr::motion {

/// A point in both motions at the same time.
struct ComparedPoint {
    path::Vec3 first = path::Vec3::Zero();  // of the tool tip, mm
    path::Vec3 second = path::Vec3::Zero();
    std::uint32_t first_line = 0;  // of the texts
    std::uint32_t second_line = 0;
};

/// What the motions do that is not the same at all.
enum class Parting : std::uint8_t {
    Path,       // they are farther apart than the tolerance
    Kind,       // one positions where the other cuts, or one stands where the other moves
    Length,     // one comes to its stop earlier
    Followers,  // an axis beside X, Y, Z is somewhere else
    Standing,   // they stand for different times, or for different reasons
    Pitch,      // the pitches of their threads are not the same
    Gear,       // the spindle leads one and not the other
    Start,      // their threads begin at other angles of the spindle
    Spindle,    // the spindle stands for one that cuts, or turns at another speed or the other way
                // round
    Pulses,     // they burn other points on the same path
    Marks,      // the modules beside the axes do something else
    End,        // one is over
};

struct Comparison {
    std::uint64_t stretches = 0;     // of motion without a stop or a change of its kind
    double greatest_distance = 0;    // mm, of one tip from the path of the other, or of two ends
    ComparedPoint widest;            // … there
    double greatest_feed_share = 0;  // of the difference of the feeds, of the greater one
    ComparedPoint fastest;           // … there
    std::optional<Parting> parting;  // they take different paths from here on
    ComparedPoint parted;
    CommandedSpindle first_spindle;  // where they part by it
    CommandedSpindle second_spindle;
};

/// Walks both to the end, or to where they part.
///
/// tolerance  mm; tips farther apart than this part the motions
/// chain      of the machine on which both run: where a path is that of the point that the cutter
///            touches, it gives the tip
Comparison compare(Stream<Segment>& first, Stream<Segment>& second, double tolerance,
                   const machine::Chain& chain = kNoChain);

}  // namespace kadr::motion
