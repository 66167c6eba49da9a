// kept_lines.h — the lines behind the blocks of the latest batch, for messages.
#pragma once

#include <string>
#include <vector>

#include "nc/line_reader.h"

namespace kadr::nc {

class KeptLines {
  public:
    explicit KeptLines(const LineReader& reader) : reader_(reader) {}

    void clear() {
        lines_.clear();
        text_.clear();
    }
    void add(std::uint32_t number, std::string_view line) {
        lines_.push_back({number, static_cast<std::uint32_t>(text_.size()),
                          static_cast<std::uint32_t>(line.size())});
        text_ += line;
    }
    /// The line of the block and its first word, the word that set the slot, the one that said the
    /// function.
    LinePlace place(const Block& block) const;
    LinePlace place(const Block& block, Slot slot) const;
    LinePlace place(const Block& block, Function function) const;

  private:
    struct Line {
        std::uint32_t number = 0;
        std::uint32_t offset = 0;
        std::uint32_t length = 0;
    };
    template <typename IsWanted>
    LinePlace place_word(const Block& block, IsWanted is_wanted) const;

    const LineReader& reader_;
    std::vector<Line> lines_;
    std::string text_;
};

}  // namespace kadr::nc
