#include "syntax/lexeme.h"

#include <algorithm>

namespace kadr::syntax {

LineStarts::LineStarts(std::string_view text) {
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        const std::size_t first = std::min(text.find_first_not_of(" \t", start), end);
        lines_.push_back(
            {static_cast<std::uint32_t>(start), static_cast<std::uint32_t>(first - start)});
        start = end + 1;
    }
}

const LineStarts::Line& LineStarts::line(std::uint32_t index) const {
    const auto next = std::upper_bound(
        lines_.begin(), lines_.end(), index,
        [](std::uint32_t wanted, const Line& line) { return wanted < line.start; });
    return *(next - 1);
}

}  // namespace kadr::syntax
