// line_source.h — lines out of pieces of text.
#pragma once

#include <cstring>
#include <string>
#include <string_view>

#include "base/text.h"
#include "nc/phrases.h"
#include "nc/reader.h"

namespace kadr::nc {

/// A line inside one piece is not copied.
class LineSource {
  public:
    /// longest  bytes of a line that are kept
    LineSource(TextSource& source, std::size_t longest)
        : source_(source), phrases_(dynamic_cast<const PhraseText*>(&source)), longest_(longest) {}

    /// The next line without its end; false at the end of the text. `is_too_long`: only the front
    /// of the line is kept.
    bool next(std::string_view& line, bool& is_too_long) {
        Ahead ahead;
        if (!look(ahead)) return next_at_edge(line, is_too_long);
        pass(ahead);
        line = ahead.line;
        is_too_long = false;
        return true;
    }

    /// A line that was looked at, and is still the next one.
    struct Ahead {
        std::string_view line;
        std::size_t length = 0;  // with its end
    };
    /// The next line, if it stands whole in the piece and behind the head of the text, as nearly
    /// every line does.
    bool look(Ahead& ahead) const {
        const std::size_t left = piece_.size() - at_;
        if (left == 0 || offset() == 0) return false;
        const char* const begin = piece_.data() + at_;
        const auto* const end = static_cast<const char*>(std::memchr(begin, '\n', left));
        if (end == nullptr) return false;
        const auto length = static_cast<std::size_t>(end - begin);
        if (length > longest_) return false;
        ahead.line = {begin, length - (length != 0 && begin[length - 1] == '\r' ? 1 : 0)};
        ahead.length = length + 1;
        return true;
    }
    void pass(const Ahead& ahead) { at_ += ahead.length; }
    /// Where the next line begins, bytes from the head of the text.
    std::uint64_t offset() const { return base_ + at_; }
    /// The next line is the one that begins there; false if the text cannot be read again.
    bool seek(std::uint64_t offset);
    /// Whether Kadr itself has written the line for one of its functions.
    bool is_phrase(std::uint64_t line) const {
        return phrases_ != nullptr && phrases_->is_phrase(line);
    }

  private:
    bool next_at_edge(std::string_view& line, bool& is_too_long);
    bool take(std::string_view& line, bool& is_too_long);
    void next_piece();

    TextSource& source_;
    const PhraseText* phrases_;  // the source, if it is one
    std::size_t longest_;
    std::string_view piece_;
    std::uint64_t base_ = 0;  // where the piece begins
    std::size_t at_ = 0;
    std::string carry_;
    bool is_endless_ = false;  // a line was so long that nothing behind it is looked for
    LineEnds ends_ = LineEnds::Unknown;
    std::string with_feeds_;  // the piece, of a text whose lines end with CR alone
};

/// A text that cannot be read again, kept so that it can; until it is too long.
class KeptText final : public TextSource, public PhraseText {
  public:
    KeptText(TextSource& source, std::size_t most)
        : source_(source), phrases_(dynamic_cast<const PhraseText*>(&source)), most_(most) {}

    std::string_view next() override;
    bool seek(std::uint64_t offset) override;
    bool is_phrase(std::uint64_t line) const override {
        return phrases_ != nullptr && phrases_->is_phrase(line);
    }
    /// From here on all is kept, however long; false: the beginning is gone already.
    bool keep_all() {
        if (!is_lost_) most_ = ~std::size_t{0};
        return !is_lost_;
    }

  private:
    TextSource& source_;
    const PhraseText* phrases_;  // the source, if it is one
    std::size_t most_;
    std::string text_;
    std::size_t at_ = 0;  // in the text that is kept
    bool is_lost_ = false;
};

}  // namespace kadr::nc
