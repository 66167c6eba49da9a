// reader.h — ISO-7bit text → Block.
//
// Our own table-driven reader, straight from bytes; about 0.1 µs a block. It knows the control's
// lexical rules and word patterns, and the little modal state that a number's meaning depends on
// (inch or metric). What a block does is the interpreter's matter.
#pragma once

#include <memory>
#include <string_view>

#include "base/stream.h"
#include "nc/dialect.h"

namespace kadr::nc {

/// Text in pieces, so that a program of any length is read in bounded memory.
class TextSource {
  public:
    virtual ~TextSource() = default;
    /// The next piece, valid until the next call; empty: the end. Pieces may end inside a line.
    virtual std::string_view next() = 0;
};

class Reader final : public Stream<Block> {
  public:
    /// `name` is shown in messages. A mistake is reported as the control's alarm, the block is
    /// left out, and `failed()` says so.
    Reader(const Dialect& dialect, TextSource& text, std::string name, DiagnosticSink& sink);
    ~Reader() override;

    std::size_t pull(std::span<Block> out) override;
    bool failed() const;
    std::uint64_t lines() const;  // read so far
    /// Line of the first mistake, where the control would stop; 0: none so far.
    std::uint64_t first_fault() const;

    /// Place of a block of the latest batch: its line, the column of the first word or, if the slot
    /// was given, of the word that set it.
    LinePlace place(const Block& block) const;
    LinePlace place(const Block& block, Slot slot) const;
    LinePlace place(const Block& block, Function function) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace kadr::nc
