// reader.h — ISO-7bit text → Block.
//
// Our own table-driven reader, straight from bytes; about 0.1 µs a block. It knows the control's
// lexical rules and word patterns, and the little modal state that a number's meaning depends on
// (inch or metric). What a block does is the interpreter's matter.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "base/stream.h"
#include "nc/dialect.h"

namespace kadr::nc {

/// Text in pieces, so that a program of any length is read in bounded memory.
class TextSource {
  public:
    virtual ~TextSource() = default;
    /// The next piece, valid until the next call; empty: the end. Pieces may end inside a line.
    virtual std::string_view next() = 0;
    /// The next piece begins so many bytes behind the head of the text; false: it cannot be read
    /// again.
    virtual bool seek(std::uint64_t offset) {
        static_cast<void>(offset);
        return false;
    }
};

/// Where blocks of the latest batch stand in their text, and whether a mistake ended it.
class BlockLocations {
  public:
    virtual ~BlockLocations() = default;
    /// The line of the block and the column of its first word or, if a slot or a function is named,
    /// of the word that set it.
    virtual TextLocation location(const Block& block) const = 0;
    virtual TextLocation location(const Block& block, Slot slot) const = 0;
    virtual TextLocation location(const Block& block, Function function) const = 0;
    /// Where the program of the block was called, the nearest call first.
    virtual std::vector<TextLocation> calls(const Block& block) const {
        static_cast<void>(block);
        return {};
    }
    virtual bool failed() const = 0;
    /// Whether the blocks ended where somebody wanted them to, in front of more.
    virtual bool stopped() const { return false; }
    /// Whether a program of the text is called at the positions of this block, which is a pattern.
    virtual bool calls_at_positions(const Block& block) const {
        static_cast<void>(block);
        return false;
    }
    /// Whether the control stopped at a mistake before this block.
    virtual bool is_behind_fault(const Block& block) const = 0;
    virtual std::uint64_t lines() const = 0;  // read so far
};

class Reader final : public Stream<Block>, public BlockLocations {
  public:
    /// `name` is shown in messages. A mistake is reported as the control's alarm, the block is
    /// left out, and `failed()` is true.
    Reader(const Dialect& dialect, TextSource& text, std::string name, DiagnosticSink& sink);
    ~Reader() override;

    std::size_t pull(std::span<Block> out) override;
    bool failed() const override;
    std::uint64_t lines() const override;
    /// Line of the first mistake, where the control would stop; 0: none so far.
    std::uint64_t first_fault() const;
    bool is_behind_fault(const Block& block) const override {
        return failed() && block.line > first_fault();
    }

    TextLocation location(const Block& block) const override;
    TextLocation location(const Block& block, Slot slot) const override;
    TextLocation location(const Block& block, Function function) const override;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace kadr::nc
