#include "write/lines.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/numbers.h"
#include "nc/comment_text.h"

namespace kadr::write {

void Lines::begin(std::int64_t greatest_number) {
    sections_ = 0;
    const BlockNumbers& numbers = tables_.block_numbers;
    const std::int64_t above =
        numbers.step > 0 ? (greatest_number / numbers.step + 1) * numbers.step : 0;
    number_ = greatest_number > 0 && above <= numbers.most ? std::max(numbers.start, above)
                                                           : numbers.start;
}

std::int32_t Lines::next_section() {
    const BlockNumbers& numbers = tables_.block_numbers;
    if (!numbers.at_sections || !is_numbered_ || sections_ == nc::kMostSections) return -1;
    if (number_ > numbers.most) return -1;
    ++sections_;
    return static_cast<std::int32_t>(std::exchange(number_, number_ + numbers.step));
}

void Lines::open(int skip_level, bool has_number, std::string& out) {
    start_ = out.size();
    if (skip_level >= 0) {
        out += '/';
        if (skip_level != tables_.notation.default_skip) out += static_cast<char>('0' + skip_level);
        out += ' ';
    }
    const BlockNumbers& numbers = tables_.block_numbers;
    if (!has_number) return;
    // A number of the program's own goes before the counted ones, which go on behind it.
    std::int64_t n = std::exchange(given_number_, -1);
    if (numbers.is_on && is_numbered_) {
        if (n < 0) {
            n = number_;
            number_ += numbers.step;
        } else {
            number_ = std::max(number_, (n / numbers.step + 1) * numbers.step);
        }
        if (number_ > numbers.most) number_ = numbers.start;
    }
    if (n < 0) return;
    std::array<char, 24> digits;
    char* end = digits.data() + digits.size();
    char* const begin = write_digits_backwards(end, static_cast<std::uint64_t>(n));
    out += 'N';
    out.append(begin, end);
}

void Lines::end_block(std::string& out) const {
    if (!tables_.notation.block_end.empty()) out += tables_.notation.block_end;  // rarely one
}

void Lines::close(std::string& out) {
    const std::size_t length = out.size() - start_;
    if (length + 1 > tables_.notation.write_line) messages_.line_too_long(length);
    if (tables_.notation.crlf) out += '\r';
    out += '\n';
    ++count_;
}

void Lines::write(std::string_view line, bool has_number, std::string& out) {
    open(-1, has_number, out);
    if (has_number) blank(out);
    out += line;
    if (has_number) end_block(out);
    close(out);
}

void Lines::write_comment(std::string_view comment, std::string& out) {
    do {
        const std::size_t end = std::min(comment.find('\n'), comment.size());
        write_comment_line(nc::comment_text(comment.substr(0, end), tables_.comment), out);
        comment.remove_prefix(std::min(end + 1, comment.size()));
    } while (!comment.empty());
}

/// A long comment goes on in the next line, cut at a blank.
void Lines::write_comment_line(std::string text, std::string& out) {
    do {
        std::size_t length = text.size();
        const std::size_t most = tables_.comment.max_length;
        if (most != 0 && length > most) {
            const std::size_t cut = text.rfind(' ', most);
            length = cut == std::string::npos || cut == 0 ? most : cut;
        }
        open(-1, false, out);
        out += tables_.comment.open;
        out.append(text, 0, length);
        if (tables_.comment.close.empty()) {
            while (out.ends_with(' ')) out.pop_back();
        }
        out += tables_.comment.close;
        close(out);
        text.erase(0, std::min(text.size(), text.find_first_not_of(' ', length)));
    } while (!text.empty());
}

void Lines::append_comment(std::string_view comment, std::string& out) const {
    blank(out);
    out += tables_.comment.open;
    out += nc::comment_text(comment, tables_.comment);
    out += tables_.comment.close;
}

}  // namespace kadr::write
