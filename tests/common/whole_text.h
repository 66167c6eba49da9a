// whole_text.h — a program of a test as a text in one piece.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "nc/reader.h"

namespace kadr {

/// A text that can be read again from any place.
class WholeText final : public nc::TextSource {
  public:
    explicit WholeText(std::string text) : text_(std::move(text)) {}
    std::string_view next() override {
        return std::string_view(text_).substr(std::exchange(at_, text_.size()));
    }
    bool seek(std::uint64_t offset) override {
        at_ = static_cast<std::size_t>(offset);
        return true;
    }

  private:
    std::string text_;
    std::size_t at_ = 0;
};

}  // namespace kadr
