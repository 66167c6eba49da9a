#include "driver/debug/break_points.h"

#include <algorithm>
#include <charconv>

#include "base/text.h"

namespace kadr::driver {

namespace {

std::optional<std::uint64_t> whole(std::string_view digits) {
    std::uint64_t value = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool is_whole = read.ec == std::errc() && read.ptr == digits.data() + digits.size();
    return is_whole ? std::optional(value) : std::nullopt;
}

bool is_name(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
        const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        const bool is_digit = c >= '0' && c <= '9';
        return is_letter || is_digit || c == '_' || c == '.' || c == '%' || c == '/' || c == '-' ||
               static_cast<unsigned char>(c) >= 0x80;
    });
}

/// `rows.kadr` is what `parts/rows.kadr` may be called, `./rows.kadr` too.
bool is_file(std::string_view file, std::string_view called) {
    while (called.starts_with("./")) called.remove_prefix(2);
    if (file.empty() || !file.ends_with(called)) return false;
    return file.size() == called.size() || file[file.size() - called.size() - 1] == '/';
}

/// `O0012` and `O12` are one program.
std::string without_zeros(std::string_view head) {
    const std::size_t digits = std::min(head.find_first_of("0123456789"), head.size());
    const auto number = whole(head.substr(digits));
    return number ? upper_ascii(head.substr(0, digits)) + std::to_string(*number)
                  : upper_ascii(head);
}

}  // namespace

std::optional<BreakPoint> BreakPoint::parse(std::string_view text) {
    BreakPoint point;
    point.text_ = text;
    if (const std::size_t colon = text.rfind(':'); colon != std::string_view::npos) {
        const auto line = whole(text.substr(colon + 1));
        if (!line || *line == 0) return std::nullopt;
        point.kind_ = Kind::Line;
        point.number_ = *line;
        point.name_ = text.substr(0, colon);
        return point;
    }
    const bool has_letter = text.starts_with('N') || text.starts_with('n');
    if (const auto number = whole(has_letter ? text.substr(1) : text)) {
        point.kind_ = Kind::Number;
        point.number_ = *number;
        point.has_letter_ = has_letter;
        return point;
    }
    if (!is_name(text)) return std::nullopt;
    point.name_ = upper_ascii(text);
    return point;
}

BreakPoint BreakPoint::at_line(std::string_view file, std::uint64_t line) {
    BreakPoint point;
    point.kind_ = Kind::Line;
    point.number_ = line;
    point.name_ = file;
    point.text_ = point.name_ + ':' + std::to_string(line);
    return point;
}

bool BreakPoint::is_in(std::string_view file, std::string_view started) const {
    return name_.empty() ? file == started : is_file(file, name_);
}

bool BreakPoint::is_line(const FileLine& line, std::string_view started) const {
    if (line.file.empty() || number_ < line.first || number_ > line.last) return false;
    return is_in(line.file, started);
}

bool BreakPoint::is_program(const StopArrival& arrival) const {
    if (arrival.program.empty()) return false;
    if (kind_ == Kind::Number) return !has_letter_ && whole(arrival.program) == number_;
    return upper_ascii(arrival.program) == name_ ||
           (!arrival.program_head.empty() &&
            without_zeros(arrival.program_head) == without_zeros(name_));
}

bool BreakPoint::is_at(const StopArrival& arrival) const {
    switch (kind_) {
        case Kind::Number:
            return (arrival.has_number && arrival.number == number_) || is_program(arrival);
        case Kind::Line:
            return is_line(arrival.text, arrival.started) ||
                   is_line(arrival.statement, arrival.started);
        case Kind::Name: break;
    }
    const auto is_called = [this](std::string_view name) {
        return !name.empty() && upper_ascii(name) == name_;
    };
    return is_called(arrival.label) || is_program(arrival) || is_called(arrival.entered);
}

}  // namespace kadr::driver
