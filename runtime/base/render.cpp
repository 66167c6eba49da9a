#include "base/render.h"

#include <algorithm>
#include <vector>

#include "base/json_writer.h"
#include "base/printable.h"
#include "base/text.h"
#include "base/unicode.h"

namespace kadr {

namespace {

constexpr std::size_t kMostText = 5000;  // bytes of an argument, a note or a fix that are shown
constexpr std::size_t kShownLine = 160;  // bytes of a long line that are shown around the caret

TextLocation resolve(const SourceRange& range, const Sources& sources) {
    TextLocation location;
    if (!range.file.is_valid()) return location;
    const LineColumn at = sources.locate(range.file, range.begin);
    location.file = sources.name(range.file);
    location.line = at.line;
    location.column = at.column;
    location.text = sources.line_at(range.file, range.begin);
    const std::string_view marked = sources.text(range);
    const std::string_view first_line = marked.substr(0, marked.find_first_of("\r\n"));
    location.length =
        std::max<std::uint32_t>(1, static_cast<std::uint32_t>(count_code_points(first_line)));
    return location;
}

TextLocation location_of(const Diagnostic& diagnostic, const Sources& sources) {
    return diagnostic.line ? *diagnostic.line : resolve(diagnostic.range, sources);
}

std::string_view severity_name(Severity severity) {
    switch (severity) {
        case Severity::Warning: return "warning";
        case Severity::Error: return "error";
        case Severity::Alarm: return "alarm";
    }
    return "error";
}

std::string_view severity_color(Severity severity) {
    return severity == Severity::Warning ? "\033[1;35m" : "\033[1;31m";
}

std::string code_of(const Diagnostic& diagnostic) {
    return diagnostic.alarm_number.empty() ? std::string(diagnostic.row->code)
                                           : diagnostic.alarm_number;
}

/// The wording, with arguments that are whole lines of a program, or files, cut.
std::string wording_of(const Diagnostic& diagnostic) {
    std::vector<std::string> arguments;
    for (const std::string& argument : diagnostic.arguments)
        arguments.push_back(shortened(argument, kMostText));
    return format_message(diagnostic.row->message, arguments);
}

std::string message_of(const Diagnostic& diagnostic) {
    const std::string message = wording_of(diagnostic);
    if (diagnostic.alarm_text.empty()) return message;
    return diagnostic.alarm_text + ": " + message;
}

/// Byte offset of the character with number `count` (from 0).
std::size_t byte_of_character(std::string_view text, std::size_t count) {
    std::size_t byte = 0;
    while (byte < text.size() && count > 0) {
        ++byte;
        while (byte < text.size() && (static_cast<unsigned char>(text[byte]) & 0xC0) == 0x80)
            ++byte;
        --count;
    }
    return byte;
}

/// A line as it is shown above its caret: each control character is one blank, so that what stands
/// behind keeps its column.
void append_shown(std::string& out, std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        const bool has_next = c == 0xC2 && i + 1 < text.size();
        const bool is_two_bytes =
            has_next && (static_cast<unsigned char>(text[i + 1]) & 0xE0) == 0x80;
        if (is_two_bytes) ++i;
        out += c < 0x20 || c == 0x7f || is_two_bytes ? ' ' : text[i];
    }
}

void append_line(std::string& out, const TextLocation& location, std::string_view color) {
    if (location.line == 0 || location.text.empty()) return;
    std::string_view text = location.text;
    std::size_t before = byte_of_character(text, location.column - 1);
    if (text.size() > kShownLine) {
        const std::size_t start = byte_of_character(
            text, count_code_points(text.substr(0, before > 60 ? before - 60 : 0)));
        const std::size_t shown = std::min(text.size() - start, kShownLine);
        text = text.substr(start, byte_of_character(text.substr(start), shown));
        before -= start;
    }
    const std::string number = std::to_string(location.line);
    const std::string margin(number.size() < 4 ? 4 - number.size() : 0, ' ');
    out += margin + number + " | ";
    append_shown(out, text);
    out += '\n';
    out.append(std::max<std::size_t>(4, number.size()), ' ');
    out += " | ";
    before = std::min(before, text.size());
    const std::string_view marked = text.substr(before);
    const std::size_t width =
        display_width(marked.substr(0, byte_of_character(marked, location.length)));
    out.append(display_width(text.substr(0, before)), ' ');
    out += color;
    out += '^';
    out.append(std::max<std::size_t>(1, width) - 1, '~');
    if (!color.empty()) out += "\033[0m";
    out += '\n';
}

void append_location(std::string& out, const TextLocation& location) {
    if (location.file.empty()) return;
    out += printable(location.file);
    if (location.line > 0) {
        out += ':' + std::to_string(location.line) + ':' + std::to_string(location.column);
    }
    out += ": ";
}

/// The marked line as it looks once the fix is applied; empty if the fix is words only or spans
/// lines.
std::string mended_line(const Diagnostic::Fix& fix, const Sources& sources) {
    if (!fix.range.file.is_valid() || fix.replacement.empty()) return {};
    const std::string_view removed = sources.text(fix.range);
    if (removed.find('\n') != std::string_view::npos) return {};
    const std::string_view line = sources.line_at(fix.range.file, fix.range.begin);
    const std::size_t start =
        fix.range.begin -
        static_cast<std::size_t>(line.data() - sources.text(fix.range.file).data());
    if (start + removed.size() > line.size()) return {};
    std::string mended(line.substr(0, start));
    mended += fix.replacement;
    mended += line.substr(start + removed.size());
    const std::size_t indent = mended.find_first_not_of(" \t");
    return indent == std::string::npos ? std::string() : mended.substr(indent);
}

}  // namespace

std::string render_text(const Diagnostic& diagnostic, const Sources& sources,
                        const RenderOptions& options) {
    const TextLocation location = location_of(diagnostic, sources);
    const std::string_view color = options.color ? severity_color(diagnostic.severity) : "";
    const std::string_view reset = options.color ? "\033[0m" : "";
    std::string out;
    append_location(out, location);
    out += color;
    out += severity_name(diagnostic.severity);
    out += '[' + code_of(diagnostic) + "]";
    out += reset;
    out += ": " + printable(message_of(diagnostic)) + '\n';
    append_line(out, location, color);
    for (const Diagnostic::Note& note : diagnostic.notes) {
        const TextLocation at = note.line ? *note.line : resolve(note.range, sources);
        append_location(out, at);
        out += (at.file.empty() ? "  note: " : "note: ") +
               printable(shortened(note.text, kMostText)) + '\n';
    }
    for (const Diagnostic::Fix& fix : diagnostic.fixes) {
        out += "  fix: " + printable(shortened(fix.text, kMostText));
        const std::string mended = mended_line(fix, sources);
        // A line that is cut would not show what it mends.
        if (!mended.empty() && mended.size() <= kMostText) out += ": `" + printable(mended) + '`';
        out += '\n';
    }
    return out;
}

namespace {

void put_end(JsonWriter& json, std::uint32_t line, std::uint32_t column) {
    json.key("end_line").value(line);
    json.key("end_column").value(column);
}

void put_begin(JsonWriter& json, const TextLocation& location) {
    json.key("file").value(location.file);
    if (location.line == 0) return;
    json.key("line").value(location.line);
    json.key("column").value(location.column);
}

/// What is marked: at a location where something is missing, the character behind it.
void put_position(JsonWriter& json, const std::optional<TextLocation>& line,
                  const SourceRange& range, const Sources& sources) {
    const TextLocation location = line ? *line : resolve(range, sources);
    put_begin(json, location);
    if (location.line == 0) return;
    if (!line && range.end > range.begin) {
        const LineColumn end = sources.locate(range.file, range.end);
        put_end(json, end.line, end.column);
    } else {
        put_end(json, location.line, location.column + location.length);
    }
}

/// What is replaced: of an insertion nothing. A fix in words alone has neither location nor text.
void put_edit(JsonWriter& json, const Diagnostic::Fix& fix, const Sources& sources) {
    if (!fix.range.file.is_valid()) return;
    put_begin(json, resolve(fix.range, sources));
    const LineColumn end = sources.locate(fix.range.file, fix.range.end);
    put_end(json, end.line, end.column);
    json.key("replacement").value(fix.replacement);
}

void put_note(JsonWriter& json, const Diagnostic::Note& note, const Sources& sources) {
    json.object([&] {
        put_position(json, note.line, note.range, sources);
        json.key("text").value(shortened(note.text, kMostText));
    });
}

void put_fix(JsonWriter& json, const Diagnostic::Fix& fix, const Sources& sources) {
    json.object([&] {
        put_edit(json, fix, sources);
        json.key("text").value(shortened(fix.text, kMostText));
    });
}

}  // namespace

std::string render_json(const Diagnostic& diagnostic, const Sources& sources) {
    std::string out;
    JsonWriter json(out);
    json.object([&] {
        put_position(json, diagnostic.line, diagnostic.range, sources);
        json.key("severity").value(severity_name(diagnostic.severity));
        json.key("code").value(diagnostic.row->code);
        if (!diagnostic.alarm_number.empty()) {
            json.key("alarm").value(diagnostic.alarm_number);
            json.key("alarm_text").value(diagnostic.alarm_text);
        }
        json.key("message").value(wording_of(diagnostic));
        json.key("notes").array([&] {
            for (const Diagnostic::Note& note : diagnostic.notes) put_note(json, note, sources);
        });
        json.key("fixes").array([&] {
            for (const Diagnostic::Fix& fix : diagnostic.fixes) put_fix(json, fix, sources);
        });
    });
    return out;
}

}  // namespace kadr
