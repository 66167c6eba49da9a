// held_text.h — a text that is all in memory, as a source that can be read again.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "nc/reader.h"

namespace kadr::nc {

class HeldText final : public TextSource {
  public:
    /// piece  bytes that are given at a time
    explicit HeldText(std::string text, std::size_t piece = std::string::npos)
        : text_(std::move(text)), piece_(piece) {}

    std::string_view next() override {
        const std::size_t from = at_;
        at_ = from + std::min(text_.size() - from, piece_);
        return std::string_view(text_).substr(from, at_ - from);
    }
    bool seek(std::uint64_t offset) override {
        at_ = static_cast<std::size_t>(std::min<std::uint64_t>(offset, text_.size()));
        return true;
    }
    const std::string& all() const { return text_; }

  private:
    std::string text_;
    std::size_t piece_;
    std::size_t at_ = 0;
};

}  // namespace kadr::nc
