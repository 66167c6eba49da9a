// kept_lines.h — the lines behind the blocks of the latest batch, for messages.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "nc/line_reader.h"

namespace kadr::nc {

/// A block that has called the program of a line, and where that was called from.
struct CallSite {
    LinePlace place;
    std::shared_ptr<const CallSite> from;
};

class KeptLines {
  public:
    explicit KeptLines(const LineReader& reader) : reader_(reader) {}

    void clear() {
        lines_.clear();
        text_.clear();
    }
    /// id  by which a block names its line (Block::line); of a single text its number
    void add(std::uint32_t id, std::string_view line) { add(id, id, line, nullptr, nullptr); }
    /// file  that the line stands in; null: that of the reader
    void add(std::uint32_t id, std::uint64_t number, std::string_view line, const std::string* file,
             std::shared_ptr<const CallSite> calls) {
        lines_.push_back({id, static_cast<std::uint32_t>(text_.size()),
                          static_cast<std::uint32_t>(line.size()), number, file, std::move(calls)});
        text_ += line;
    }
    /// The calls that have led to the block, the nearest first.
    std::vector<LinePlace> calls(const Block& block) const;
    /// The line of the block and its first word, the word that set the slot, the one that said the
    /// function.
    LinePlace place(const Block& block) const;
    LinePlace place(const Block& block, Slot slot) const;
    LinePlace place(const Block& block, Function function) const;

  private:
    struct Line {
        std::uint32_t id = 0;
        std::uint32_t offset = 0;
        std::uint32_t length = 0;
        std::uint64_t number = 0;
        const std::string* file = nullptr;
        std::shared_ptr<const CallSite> calls;
    };
    std::vector<Line>::const_iterator find(const Block& block) const;
    template <typename IsWanted>
    LinePlace place_word(const Block& block, IsWanted is_wanted) const;

    const LineReader& reader_;
    std::vector<Line> lines_;
    std::string text_;
};

}  // namespace kadr::nc
