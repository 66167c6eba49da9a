// file_text.h — ISO-7bit text from a file or from standard input, piece by piece.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "nc/reader.h"

namespace kadr::driver {

/// A file that was opened and whose first piece has been looked at.
class FileText final : public nc::TextSource {
  public:
    /// `-` is standard input. Null if it cannot be read.
    static std::unique_ptr<FileText> open(const Files& files, const std::string& path);

    std::string_view next() override;
    bool seek(std::uint64_t offset) override;

    /// Gets every piece that is taken; empty: nobody asks.
    void set_tap(std::function<void(std::string_view)> tap) { tap_ = std::move(tap); }

    /// The first piece, without taking it.
    std::string_view peek() const { return {piece_.data(), filled_}; }
    /// Everything, for a source that turns out to be a Kadr program. Of one that is too large for
    /// the parser so much that it reports so: the file may have no end.
    std::string read_all(std::size_t most);

  private:
    explicit FileText(std::unique_ptr<FileReader> file);

    std::unique_ptr<FileReader> file_;
    std::vector<char> piece_;
    std::size_t filled_ = 0;
    bool was_peeked_ = true;
    std::function<void(std::string_view)> tap_;
};

/// Whether a text is a Kadr program rather than ISO-7bit text: it has braces outside of what are
/// comments and texts there.
bool looks_like_kadr(std::string_view text);

/// Whether a name tells that a file is a Kadr program.
bool is_kadr_name(std::string_view path);

}  // namespace kadr::driver
