// line_source.h — lines out of pieces of text.
#pragma once

#include <string>
#include <string_view>

#include "nc/reader.h"

namespace kadr::nc {

/// A line inside one piece is not copied.
class LineSource {
  public:
    /// longest  bytes of a line that are kept
    LineSource(TextSource& source, std::size_t longest) : source_(source), longest_(longest) {}

    /// The next line without its end; false at the end of the text. `is_too_long`: only the front
    /// of the line is kept.
    bool next(std::string_view& line, bool& is_too_long);
    /// Where the next line begins, bytes from the head of the text.
    std::uint64_t offset() const { return base_ + at_; }
    /// The next line is the one that begins there; false if the text cannot be read again.
    bool seek(std::uint64_t offset);

  private:
    bool take(std::string_view& line, bool& is_too_long);

    TextSource& source_;
    std::size_t longest_;
    std::string_view piece_;
    std::uint64_t base_ = 0;  // where the piece begins
    std::size_t at_ = 0;
    std::string carry_;
};

/// A text that cannot be read again, kept so that it can; until it is too long.
class KeptText final : public TextSource {
  public:
    KeptText(TextSource& source, std::size_t most) : source_(source), most_(most) {}

    std::string_view next() override;
    bool seek(std::uint64_t offset) override;
    /// From here on all is kept, however long; false: the beginning is gone already.
    bool keep_all() {
        if (!is_lost_) most_ = ~std::size_t{0};
        return !is_lost_;
    }

  private:
    TextSource& source_;
    std::size_t most_;
    std::string text_;
    std::size_t at_ = 0;  // in the text that is kept
    bool is_lost_ = false;
};

}  // namespace kadr::nc
