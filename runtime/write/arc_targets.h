// arc_targets.h — the words of an arc: its centre or its radius on the grid of the text, and its
// feed.
#pragma once

#include "write/targets.h"

namespace kadr::write {

/// The centre or the radius; the words of the end are there already.
///
/// start  where the arc begins; the text's position is its end
void place_arc(const TextView& text, BlockMessages& messages, const Block& block,
               const WrittenPosition& start, Targets& targets);

/// The words of an arc whose points nobody knows: as the block has them, nothing corrected.
void place_arc_as_given(const TextView& text, BlockMessages& messages, const Block& block,
                        const WrittenPosition& start, Targets& targets);

/// Where F of an arc under inverse time is feed/radius, it is the angle over the time: so much
/// greater than 1/time.
void place_arc_feed(const TextView& text, BlockMessages& messages, const Block& block,
                    const WrittenPosition& start, Targets& targets);

/// The tool of a helix shall be as fast as the program means it, where program and control count F
/// along different lengths: the path of the tool, or the arc that the helix is over.
void place_helix_feed(const TextView& text, BlockMessages& messages, const Block& block,
                      const WrittenPosition& start, Targets& targets);

}  // namespace kadr::write
