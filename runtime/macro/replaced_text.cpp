#include "macro/replaced_text.h"

#include <algorithm>
#include <utility>

namespace kadr::macro {

void ReplacedText::put(std::string_view replacement, std::size_t begin, std::size_t end,
                       std::string name) {
    const auto first = static_cast<std::uint32_t>(text.size());
    text.append(replacement);
    words.push_back({{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)},
                     {first, static_cast<std::uint32_t>(text.size())},
                     std::move(name)});
}

const ReplacedText::Word* ReplacedText::word_at(std::uint32_t byte) const {
    const auto found = std::ranges::find_if(
        words, [&](const Word& word) { return word.put.begin <= byte && byte < word.put.end; });
    return found == words.end() ? nullptr : &*found;
}

nc::Span ReplacedText::written(const nc::Span& span) const {
    const auto place = [&](std::uint32_t at, bool is_end) {
        std::uint32_t in_line = at;
        for (const Word& word : words) {
            if (is_end ? at <= word.put.begin : at < word.put.begin) break;
            const bool is_inside = is_end ? at <= word.put.end : at < word.put.end;
            if (is_inside) return is_end ? word.written.end : word.written.begin;
            in_line = at - word.put.end + word.written.end;
        }
        return in_line;
    };
    return {place(span.begin, false), place(span.end, true)};
}

}  // namespace kadr::macro
