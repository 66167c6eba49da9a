#include "driver/file_text.h"

#include <utility>

#include "base/text.h"

namespace kadr::driver {

namespace {

constexpr std::size_t kBytesAtOnce = std::size_t{1} << 16;  // bytes read at a time

}  // namespace

FileText::FileText(std::unique_ptr<FileReader> file)
    : file_(std::move(file)), piece_(kBytesAtOnce), filled_(file_->read(piece_)) {}

std::unique_ptr<FileText> FileText::open(const Files& files, const std::string& path) {
    std::unique_ptr<FileReader> file = files.open(path);
    return file == nullptr ? nullptr : std::unique_ptr<FileText>(new FileText(std::move(file)));
}

std::string_view FileText::next() {
    if (!was_peeked_) filled_ = file_->read(piece_);
    was_peeked_ = false;
    if (tap_) tap_({piece_.data(), filled_});
    return {piece_.data(), filled_};
}

bool FileText::seek(std::uint64_t offset) {
    if (!file_->seek(offset)) return false;
    was_peeked_ = false;
    filled_ = 0;
    return true;
}

std::string FileText::read_all(std::size_t most) {
    std::string text;
    for (std::string_view piece = next(); !piece.empty() && text.size() <= most; piece = next())
        text += piece;
    return text;
}

bool looks_like_kadr(std::string_view text) {
    // ISO-7bit text has comments in parentheses or behind `;`, texts in quotes, and never braces.
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const char close = c == '(' ? ')' : c == '"' ? '"' : c == ';' ? '\n' : '\0';
        if (c == '{') return true;
        if (close == '\0') continue;
        const std::size_t end = text.find_first_of(close == '\n'  ? "\n"
                                                   : close == ')' ? ")\n"
                                                                  : "\"\n",
                                                   i + 1);
        if (end == std::string_view::npos) return false;
        i = end;
    }
    return false;
}

bool is_kadr_name(std::string_view path) {
    constexpr std::string_view kSuffix = ".KADR";
    return upper_ascii(path).ends_with(kSuffix);
}

}  // namespace kadr::driver
