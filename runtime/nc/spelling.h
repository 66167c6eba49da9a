// spelling.h — how a control says something: a block by itself, and what the head of its programs
// has said before the first one.
//
// For messages, examples and whoever has to know what stands in a text before it is written.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nc/dialect.h"
#include "nc/reader.h"
#include "nc/refusals.h"

namespace kadr::nc {

/// The text of blocks, or the message that says why the control cannot say them.
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

/// What the lines say that stand before the first block of a program.
std::vector<Block> blocks_of_head(const Dialect& dialect);

/// The number of the work offset that the head of every program of the control says
/// (`<start>G54 …`); nothing if it says none.
std::optional<int> offset_of_head(const Dialect& dialect);

/// A text that is all there.
class WholeText final : public TextSource {
  public:
    explicit WholeText(std::string_view text) : text_(text) {}
    std::string_view next() override;

  private:
    std::string_view text_;
};

}  // namespace kadr::nc
