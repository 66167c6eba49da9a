#include "nc/line_source.h"

#include <algorithm>
#include <cstring>

namespace kadr::nc {

namespace {

/// Editors put it before a text in UTF-8; no control sees it.
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// A line without an end is no text: behind so many bytes nothing is read, as of a device that
/// gives zeros for ever.
constexpr std::size_t kEndlessLine = std::size_t{1} << 30;

}  // namespace

/// The first line of the text, of a piece, or one that goes over from one piece to the next.
bool LineSource::next_at_edge(std::string_view& line, bool& is_too_long) {
    const bool is_first = offset() == 0;
    if (!take(line, is_too_long)) return false;
    if (is_first && line.starts_with(kByteOrderMark)) line.remove_prefix(kByteOrderMark.size());
    return true;
}

/// The next piece, and how lines end if it shows that. Of CR alone every one becomes the LF that
/// the rest of Kadr looks for, those at the end of the piece before among them.
void LineSource::next_piece() {
    base_ += piece_.size();
    piece_ = source_.next();
    at_ = 0;
    std::size_t waiting = 0;  // CR of which it was open whether they end lines
    if (ends_ == LineEnds::Unknown) {
        const std::size_t text = carry_.find_last_not_of('\r');
        waiting = carry_.size() - (text == std::string::npos ? 0 : text + 1);
        ends_ = line_ends(std::string(waiting, '\r').append(piece_));
    }
    if (ends_ != LineEnds::Returns) return;
    carry_.resize(carry_.size() - waiting);
    base_ -= waiting;
    with_feeds_.assign(waiting, '\n');
    with_feeds_ += piece_;
    std::ranges::replace(with_feeds_, '\r', '\n');
    piece_ = with_feeds_;
}

bool LineSource::take(std::string_view& line, bool& is_too_long) {
    carry_.clear();
    is_too_long = false;
    if (is_endless_) return false;
    std::size_t skipped = 0;
    while (true) {
        is_endless_ = skipped > kEndlessLine;
        if (is_endless_) {
            line = carry_;
            return true;
        }
        if (at_ == piece_.size()) {
            next_piece();
            if (piece_.empty()) {
                if (carry_.empty() && !is_too_long) return false;
                line = carry_;
                return true;
            }
        }
        const char* const begin = piece_.data() + at_;
        const auto* end = static_cast<const char*>(std::memchr(begin, '\n', piece_.size() - at_));
        const std::size_t length =
            end == nullptr ? piece_.size() - at_ : static_cast<std::size_t>(end - begin);
        at_ += length + (end == nullptr ? 0 : 1);
        if (end != nullptr && carry_.empty() && !is_too_long) {
            is_too_long = length > longest_;
            line = std::string_view(begin, std::min(length, longest_));
            if (!line.empty() && line.back() == '\r' && !is_too_long) line.remove_suffix(1);
            return true;
        }
        const std::size_t room = longest_ - carry_.size();
        if (length > room) is_too_long = true;
        skipped += length;
        carry_.append(begin, std::min(length, room));
        if (end == nullptr) continue;
        if (!is_too_long && !carry_.empty() && carry_.back() == '\r') carry_.pop_back();
        line = carry_;
        return true;
    }
}

bool LineSource::seek(std::uint64_t offset) {
    if (offset >= base_ && offset - base_ <= piece_.size() && !piece_.empty()) {
        at_ = static_cast<std::size_t>(offset - base_);
        return true;
    }
    if (!source_.seek(offset)) return false;
    piece_ = {};
    base_ = offset;
    at_ = 0;
    return true;
}

std::string_view KeptText::next() {
    if (at_ < text_.size()) {
        const std::string_view piece = std::string_view(text_).substr(at_);
        at_ = text_.size();
        return piece;
    }
    const std::string_view piece = source_.next();
    if (is_lost_ || piece.size() > most_ - text_.size()) {
        is_lost_ = true;
        text_ = {};
        at_ = 0;
        return piece;
    }
    text_ += piece;
    at_ = text_.size();
    return piece;
}

bool KeptText::seek(std::uint64_t offset) {
    if (is_lost_ || offset > text_.size()) return false;
    at_ = static_cast<std::size_t>(offset);
    return true;
}

}  // namespace kadr::nc
