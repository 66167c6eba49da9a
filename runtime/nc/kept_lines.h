// kept_lines.h — the lines behind the blocks of the latest batch, and of some before it, for
// messages.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "nc/line_reader.h"

namespace kadr::nc {

/// A block that has called the program of a line, and where that was called from.
struct CallSite {
    TextLocation location;
    std::shared_ptr<const CallSite> from;
};

/// A call and those that have led to it, the nearest first; none if null.
std::vector<TextLocation> locations_of(const CallSite* nearest);

class KeptLines {
  public:
    explicit KeptLines(const LineReader& reader) : reader_(reader) {}

    /// So many lines of earlier batches, or some more, are kept as well; none to begin with. They
    /// are for who comes to a block long after it was read: the compensation, the motion.
    void keep_earlier(std::size_t lines) { most_earlier_ = lines; }
    /// A new batch begins.
    void clear();
    /// id  by which a block names its line (Block::line); of a single text its number
    void add(std::uint32_t id, std::string_view line) { add(id, id, line, nullptr, nullptr); }
    /// file  that the line stands in; null: that of the reader
    void add(std::uint32_t id, std::uint64_t number, std::string_view line, const std::string* file,
             std::shared_ptr<const CallSite> calls) {
        now_.lines.push_back({id, static_cast<std::uint32_t>(now_.text.size()),
                              static_cast<std::uint32_t>(line.size()), number, file,
                              std::move(calls)});
        now_.text += line;
    }
    /// The calls that have led to the block, the nearest first.
    std::vector<TextLocation> calls(const Block& block) const;
    /// The line of the block and its first word, the word that set the slot, the one that gave the
    /// function. Without a text if the line is forgotten.
    TextLocation location(const Block& block) const;
    TextLocation location(const Block& block, Slot slot) const;
    TextLocation location(const Block& block, Function function) const;

  private:
    struct Line {
        std::uint32_t id = 0;
        std::uint32_t offset = 0;
        std::uint32_t length = 0;
        std::uint64_t number = 0;
        const std::string* file = nullptr;
        std::shared_ptr<const CallSite> calls;
    };
    /// Lines one behind the other, and their texts.
    struct Chunk {
        std::vector<Line> lines;
        std::string text;
    };
    struct Found {
        const Line* line = nullptr;  // null: it is forgotten
        std::string_view text;
    };
    Found find(std::uint32_t id) const;
    Found find_earlier(std::uint32_t id) const;
    template <typename IsWanted>
    TextLocation word_location(const Block& block, IsWanted is_wanted) const;

    const LineReader& reader_;
    Chunk now_;              // the batch, and what was kept before it since `earlier_`
    std::size_t batch_ = 0;  // where the batch begins in it
    std::deque<Chunk> earlier_;
    std::size_t most_earlier_ = 0;
    std::size_t count_earlier_ = 0;  // lines in `earlier_`
};

}  // namespace kadr::nc
