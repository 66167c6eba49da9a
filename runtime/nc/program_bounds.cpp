#include "nc/program_bounds.h"

#include <algorithm>
#include <vector>

#include "base/numbers.h"
#include "base/text.h"
#include "nc/calls.h"
#include "nc/head_words.h"
#include "nc/letters.h"

namespace kadr::nc {

namespace {

/// Whether a line is the last one of a program: it begins as the template does before what is
/// filled in.
bool is_end_line(std::string_view line, std::string_view end) {
    const std::size_t fixed = end.find_first_of("{[");
    if (fixed == 0 || fixed == std::string_view::npos) return line == end;
    return line.starts_with(end.substr(0, fixed));
}

}  // namespace

TextLocation location_in_line(const std::string& file, std::string_view line, std::uint64_t number,
                              const Span& span) {
    constexpr std::size_t kShown = 400;  // bytes of a line that a message keeps
    TextLocation location;
    location.file = file;
    location.line = static_cast<std::uint32_t>(number);
    const std::size_t begin = std::min<std::size_t>(span.begin, line.size());
    const std::size_t end = std::clamp<std::size_t>(span.end, begin, line.size());
    location.column = static_cast<std::uint32_t>(count_code_points(line.substr(0, begin)) + 1);
    location.length = static_cast<std::uint32_t>(
        std::max<std::size_t>(1, count_code_points(line.substr(begin, end - begin))));
    location.text = line.substr(0, std::max(kShown, std::min(end, line.size())));
    return location;
}

ProgramBounds::LineKind ProgramBounds::kind_of(std::string_view line) {
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
    if (line.empty()) return LineKind::Nothing;
    const std::vector<std::string>& ends = tables_.program.end;
    const auto is_end = [&](const std::string& end) { return is_end_line(line, end); };
    if (text_->has_content && std::ranges::any_of(ends, is_end)) text_->has_ended = true;
    if (text_->has_ended) return LineKind::Nothing;
    // `O100`, `O<NAME>`, and no word that begins with the letter.
    const bool is_header =
        std::ranges::any_of(tables_.program.skipped, [&](const std::string& front) {
            const bool goes_on = !front.empty() && is_letter(front.back()) &&
                                 line.size() > front.size() && is_letter(line[front.size()]);
            return line.starts_with(front) && !goes_on;
        });
    if (!is_header) return LineKind::Words;
    if (!text_->has_content) note_program(line);
    if (text_->has_content &&
        program_of_header(tables_.language.calls, line, tables_.notation.ignores_case)) {
        text_->has_ended = true;
        return LineKind::Nothing;
    }
    if (has_wrong_number(line)) return LineKind::WrongNumber;
    if (!text_->has_content) return LineKind::Nothing;
    // Where a mark ends the text, another program may begin before it.
    text_->has_ended = !ends.empty();
    return text_->has_ended ? LineKind::Nothing : LineKind::Misplaced;
}

void ProgramBounds::note_program(std::string_view line) {
    if (auto program =
            program_of_header(tables_.language.calls, line, tables_.notation.ignores_case))
        text_->program = std::move(*program);
}

std::string_view ProgramBounds::without_head(std::string_view line, std::uint64_t number) {
    if (text_->has_content || line.empty()) return line;
    const std::size_t words = words_behind_head(tables_, line);
    const std::size_t begin = line.find_first_not_of(" \t");
    if (words == std::string_view::npos || has_wrong_number(line.substr(begin))) return line;
    note_program(line);
    head_line_ = head_text_ = line;
    head_number_ = number;
    std::fill_n(head_line_.begin(), words, ' ');
    return head_line_;
}

/// Whether the line names the program by a number that the control does not have.
bool ProgramBounds::has_wrong_number(std::string_view line) const {
    const ProgramTemplates& frame = tables_.program;
    if (frame.most_read_number == 0) return false;
    for (const std::string& header : frame.header) {
        const std::size_t front = header.find("{number");
        if (front == 0 || front == std::string::npos) continue;
        if (!line.starts_with(std::string_view(header).substr(0, front))) continue;
        const char* const digits = line.data() + front;
        const Decimal number = parse_decimal(digits, line.data() + line.size());
        return number.end != digits && (number.value < static_cast<double>(frame.least_number) ||
                                        number.value > static_cast<double>(frame.most_read_number));
    }
    return false;
}

}  // namespace kadr::nc
