#include "driver/machine_inputs.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

#include "base/diagnostics/driver.h"
#include "base/files.h"
#include "base/numbers.h"
#include "base/text.h"

namespace kadr::driver {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

std::optional<double> number_of(std::string_view text) {
    const Decimal number = parse_decimal(text.data(), text.data() + text.size());
    const bool is_whole = !text.empty() && number.end == text.data() + text.size();
    return is_whole ? std::optional(number.value) : std::nullopt;
}

// ---------------------------------------------------------------- JSON

/// An object of names and single values → `NAME = VALUE`, where they stand in the text.
class ObjectLines {
  public:
    explicit ObjectLines(std::string_view text) : text_(text), out_(text) {
        for (char& c : out_)
            if (c != '\n') c = ' ';
    }

    bool read() {
        if (!take('{')) return false;
        skip();
        if (peek() != '}') {
            do {
                if (!take_member()) return false;
                skip();
            } while (take(','));
        }
        if (!take('}')) return false;
        skip();
        return at_ == text_.size();
    }
    std::size_t at() const { return at_; }
    std::string lines() && { return std::move(out_); }

  private:
    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    void skip() {
        while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    }
    bool take(char sign) {
        skip();
        if (peek() != sign) return false;
        ++at_;
        return true;
    }

    bool take_member() {
        skip();
        const std::size_t key = at_ + 1;
        if (!take_string()) return false;
        const std::size_t key_length = at_ - 1 - key;
        if (!take(':')) return false;
        const std::size_t colon = at_ - 1;
        skip();
        const std::size_t value = at_;
        std::string shown;
        if (peek() == '"') {
            if (!take_string()) return false;
            shown = text_.substr(value, at_ - value);
        } else {
            while (at_ < text_.size() && !is_blank(text_[at_]) && text_[at_] != ',' &&
                   text_[at_] != '}')
                ++at_;
            const std::string_view word = text_.substr(value, at_ - value);
            if (word == "null") return true;  // no value: there is nothing to set
            if (word != "true" && word != "false" && !is_number(word)) {
                at_ = value;
                return false;
            }
            shown = word == "true" ? "1" : word == "false" ? "0" : without_exponent(word);
        }
        out_.replace(key, key_length, text_.substr(key, key_length));
        out_[colon] = '=';
        // A number without its exponent may be longer: the rest of its line is blank, or the line
        // of the member behind.
        const std::size_t room = std::min(shown.size(), out_.size() - value);
        if (shown.size() <= at_ - value) out_.replace(value, room, shown);
        else longer_.emplace_back(value, shown);
        return true;
    }

    /// No escapes: names and texts of controls have none that a block could hold.
    bool take_string() {
        if (peek() != '"') return false;
        const std::size_t end = text_.find_first_of("\"\\\n", at_ + 1);
        if (end == std::string_view::npos || text_[end] != '"') return false;
        at_ = end + 1;
        return true;
    }

    static bool is_number(std::string_view word) {
        double value = 0;
        const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
        return result.ec == std::errc() && result.ptr == word.data() + word.size() &&
               std::isfinite(value);
    }

    /// No control reads `1e-07`.
    static std::string without_exponent(std::string_view word) {
        if (word.find_first_of("eE") == std::string_view::npos) return std::string(word);
        double value = 0;
        std::from_chars(word.data(), word.data() + word.size(), value);
        std::array<char, 400> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                       std::chars_format::fixed);
        return {digits.data(), end.ptr};
    }

  public:
    /// Values that did not fit where they stand, put in from the last to the first.
    void put_longer() {
        for (auto longer = longer_.rbegin(); longer != longer_.rend(); ++longer)
            out_.insert(longer->first, longer->second);
    }

  private:
    std::string_view text_;
    std::string out_;
    std::size_t at_ = 0;
    std::vector<std::pair<std::size_t, std::string>> longer_;
};

// ---------------------------------------------------------------- lines of a control

/// The number of the block is no part of what it holds.
std::string_view without_number(std::string_view line) {
    const auto trim = [&] {
        while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
        while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
    };
    trim();
    std::size_t digits = 1;
    while (digits < line.size() && is_digit(line[digits])) ++digits;
    const bool has_number = line.size() > 1 && (line[0] == 'N' || line[0] == 'n') && digits > 1 &&
                            (digits == line.size() || is_blank(line[digits]));
    if (has_number) line.remove_prefix(digits);
    trim();
    return line;
}

/// What frames the values of a file: its name, the channel, its end.
bool is_frame(std::string_view text) {
    if (text.starts_with('%')) return true;
    const std::string word = upper_ascii(text);
    if (word.starts_with("CHANDATA")) return true;
    const std::string_view head(word.data(), std::min(word.find_first_of(" ;("), word.size()));
    constexpr std::array<std::string_view, 6> kEnds = {"M17", "M30", "M2", "M02", "RET", "M99"};
    if (std::ranges::find(kEnds, head) != kEnds.end()) return true;
    return head.size() > 1 && head[0] == 'O' &&
           std::ranges::all_of(head.substr(1), [](char c) { return is_digit(c); });
}

/// `#500 12.5 (NAME)` has no sign between the variable and its value.
void put_equals(std::string& line) {
    const std::size_t sign = line.find_first_not_of(" \t");
    if (sign == std::string::npos || line[sign] != '#') return;
    std::size_t at = sign + 1;
    while (at < line.size() && is_digit(line[at])) ++at;
    const std::size_t behind = line.find_first_not_of(" \t", at);
    if (at == sign + 1 || behind == at || behind == std::string::npos) return;
    const char c = line[behind];
    if (is_digit(c) || c == '.' || c == '-' || c == '+') line[at] = '=';
}

std::string lines_of_control(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string line(text.substr(0, end));
        if (is_frame(without_number(line))) line.clear();
        put_equals(line);
        out += line;
        if (end < text.size()) out += '\n';
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return out;
}

// ---------------------------------------------------------------- the machine file

/// A value as the control writes it: a number, or a text between quotes.
std::string written(const std::string& value) {
    const bool is_reported = number_of(value).has_value() || value.starts_with('"');
    return is_reported ? value : '"' + value + '"';
}

/// Each at its line of the file, so that messages show that.
void add_data(Session& session, std::vector<macro::ProgramInputs>& out) {
    std::uint32_t line = 0;  // of the text that is being made; 0: none
    for (const machine::MachineDatum& datum : session.machine_data().data) {
        const Sources& sources = session.sources();
        const std::uint32_t at = sources.locate(datum.location.file, datum.location.begin).line;
        if (line == 0 || at <= line) {
            out.push_back({std::string(sources.name(datum.location.file)), {}, false});
            line = 1;
        }
        std::string& text = out.back().text;
        text.append(at - line, '\n');
        text += datum.name + '=' + written(datum.value);
        line = at;
    }
}

}  // namespace

std::optional<std::string> lines_of_variables(std::string_view text, std::size_t& fault) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || text[first] != '{') return lines_of_control(text);
    ObjectLines object(text);
    if (!object.read()) {
        fault = object.at();
        return std::nullopt;
    }
    object.put_longer();
    return std::move(object).lines();
}

std::optional<std::vector<macro::ProgramInputs>> machine_inputs(Session& session) {
    std::vector<macro::ProgramInputs> out;
    add_data(session, out);
    for (const std::string& file : session.options().variable_files) {
        auto source = session.access().read(file);
        if (!source) {
            report_unread(session.messages(), diag::FileUnreadable, {}, file, source.error(),
                          session.access());
            session.mark_usage();
            return std::nullopt;
        }
        std::string text = *std::move(source);
        end_lines_with_feeds(text);
        std::size_t fault = 0;
        auto lines = lines_of_variables(text, fault);
        if (!lines) {
            const FileId id = session.sources().add(file, text);
            const auto at = static_cast<std::uint32_t>(std::min(fault, text.size()));
            session.messages().report(diag::InputFile, SourceRange{id, at, at + 1});
            return std::nullopt;
        }
        out.push_back({file, std::move(*lines), false});
    }
    for (const std::string& set : session.options().sets) out.push_back({"--set", set, true});
    return out;
}

nc::MachineAxisNames axis_names(const machine::Machine& machine, const machine::MachineData& data) {
    std::vector<Axis> axes;
    for (const machine::MachineAxis& axis : machine.axes) axes.push_back(axis.axis);
    nc::MachineAxisNames names = nc::usual_axis_names(axes);
    for (const auto& [name, axis] : data.axis_names) names.insert_or_assign(name, axis);
    return names;
}

}  // namespace kadr::driver
