// program_head.h — what the lines program that stand before the first block of a program.
//
// They are the dialect's own, so they are read here by its own rules: a program that was written
// for the control has programmed this much when its first block comes.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "nc/dialect.h"
#include "nc/reader.h"

namespace kadr::nc {

/// What the lines program that stand before the first block of a program.
std::vector<Block> blocks_of_head(const Dialect& dialect);

/// The number of the work offset that the head of every program of the control programs
/// (`<start>G54 …`); nothing if it programs none.
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
