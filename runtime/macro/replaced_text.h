// replaced_text.h — a line in which words were replaced by what they stand for, and where it was
// written what stands in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "nc/lexer.h"

namespace kadr::macro {

struct ReplacedText {
    struct Word {
        nc::Span written;  // in the line
        nc::Span put;      // in `text`
        std::string name;  // as the language compares names
    };
    std::string text;
    std::vector<Word> words;  // in their order

    /// Adds what stands for the word that the line has from `begin` to `end`.
    void put(std::string_view replacement, std::size_t begin, std::size_t end, std::string name);
    /// The word inside of which the byte of `text` stands; null: it stands in the line itself.
    const Word* word_at(std::uint32_t byte) const;
    /// A piece of `text` in the line: of what a word stands for the word itself.
    nc::Span written(const nc::Span& span) const;
};

}  // namespace kadr::macro
