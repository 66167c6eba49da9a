// lost_words.h — words of a source that no text has.
//
// A control has words that the language has no meaning for (G05.1 Q1, SOFT), or only a coarser one
// (G62). Which ones, and what is missed, stands in the dialect: the attribute `lost`.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "nc/dialect.h"

namespace kadr::nc {

struct LostWord {
    std::string text;   // `G05.1 Q1`, `SOFT`
    std::string why;    // what the program does without it
    SourceRange range;  // of its first word
};

/// The words of a block that are not in the text, in the order of the block. None if the block
/// cannot be planned: plan_block tells why.
std::vector<LostWord> lost_words(const Dialect& dialect, std::span<const SourceWord> words);

}  // namespace kadr::nc
