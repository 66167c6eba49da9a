// block_values.h — values from registers into words, and back. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// The instruction that made the value of a word; its location is the word, not the whole block.
std::uint32_t word_of(const Running& run, const sema::Filling& filling, std::uint32_t at);
/// Puts one value into the block: an argument of a function, or a word.
///
/// at           the instruction of the block
Done fill(Running& run, nc::Block& block, const sema::Filling& filling, Slot value,
          std::uint32_t at);
/// Puts F into the block, in the units of the feed mode that acts.
///
/// value        mm/s or mm/rev, as the form of the filling is
Done fill_feed(Running& run, nc::Block& block, const sema::Filling& filling, double value,
               std::uint32_t at);
/// `state.feed` and `state.speed` as registers have them; NaN: nobody knows.
double state_value(const Running& run, sema::StateValue which);
/// 3, 4, 5 as in M3, M4, M5; kNotGivenInteger: nobody knows.
std::int64_t spindle_code(const Running& run);

}  // namespace kadr::expand
