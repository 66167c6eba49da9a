// spelling.h — how a control writes something: blocks by themselves.
//
// For messages, examples and whoever has to know what stands in a text before it is written.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "nc/refusals.h"
#include "write/names.h"

namespace kadr::write {

/// The text of blocks, or the message that tells why the control cannot write them.
struct Spelling {
    std::string text;  // lines joined by line ends, none behind the last one; no block numbers
    std::string fault;
};

/// What the blocks are written as in the middle of a program. `refusals` gets the forms that were
/// passed over; null: nobody asks.
Spelling spelling_of(const Dialect& dialect, std::span<const Block> blocks,
                     std::vector<Refusal>* refusals = nullptr);

/// The word of a work offset by its number: `G55`, `G505`; empty if the control has none such.
std::string spelling_of_offset(const Dialect& dialect, std::int64_t number);

}  // namespace kadr::write
