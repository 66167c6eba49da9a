#include "driver/messages.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/allow.h"
#include "base/diagnostics/driver.h"
#include "base/render.h"

namespace kadr::driver {

Messages::Messages(const Sources& sources, MessageOptions options, Write write)
    : sources_(sources), options_(options), write_(std::move(write)) {}

std::string Messages::rendered(const Diagnostic& diagnostic) const {
    if (options_.format == MessageFormat::Json) return render_json(diagnostic, sources_) + '\n';
    return render_text(diagnostic, sources_, {.color = options_.color});
}

void Messages::count(const Diagnostic& diagnostic) {
    const bool is_first = errors_ == 0 && alarms_ == 0;
    if (is_first && diagnostic.severity != Severity::Warning) first_error_ = diagnostic.message();
    switch (diagnostic.severity) {
        case Severity::Warning: ++warnings_; return;
        case Severity::Error: ++errors_; return;
        case Severity::Alarm: break;
    }
    if (++alarms_ > 1) return;
    const std::string all = render_text(diagnostic, sources_);
    first_alarm_ = all.substr(0, all.find('\n'));
}

namespace {

/// The comment at the end of a line, without `//`; empty if there is none.
std::string_view comment_of(std::string_view line) {
    bool is_text = false;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        if (line[i] == '\\' && is_text) ++i;
        else if (line[i] == '"') is_text = !is_text;
        else if (!is_text && line[i] == '/' && line[i + 1] == '/') return line.substr(i + 2);
    }
    return {};
}

}  // namespace

/// Whether `// kadr: allow K2501 why` stands in the line of the location, or alone in the line
/// before.
bool Messages::is_allowed(std::string_view code, const SourceRange& location) const {
    if (!location.file.is_valid()) return false;
    const std::string_view text = sources_.text(location.file);
    const std::string_view line = sources_.line_at(location.file, location.begin);
    if (allowed_codes(comment_of(line)).contains(code)) return true;
    const auto begin = static_cast<std::size_t>(line.data() - text.data());
    if (begin == 0) return false;
    const std::string_view before =
        sources_.line_at(location.file, static_cast<std::uint32_t>(begin - 1));
    const std::size_t first = before.find_first_not_of(" \t");
    return first != std::string_view::npos && before.substr(first).starts_with("//") &&
           allowed_codes(before.substr(first + 2)).contains(code);
}

/// A warning is silenced where it stands. One about a line that a statement wrote, or a table that
/// it reads, is silenced at the statement.
bool Messages::is_silenced(const Diagnostic& diagnostic) const {
    if (diagnostic.severity != Severity::Warning) return false;
    if (!diagnostic.line) return is_allowed(diagnostic.row->code, diagnostic.range);
    if (iso_line_allows(diagnostic.line->text, diagnostic.row->code)) return true;
    return std::any_of(diagnostic.notes.begin(), diagnostic.notes.end(), [&](const auto& note) {
        return is_allowed(diagnostic.row->code, note.range);
    });
}

/// Whether these words are to be written: from here on they count as written.
bool Messages::first_time(const std::string& text) {
    return shown_.insert(std::hash<std::string>{}(text)).second;
}

void Messages::take(Diagnostic diagnostic) {
    // A row that was reported often enough is only counted, so that a mistake in a loop of a
    // million passes costs neither time nor memory.
    if (is_silenced(diagnostic)) return;
    std::size_t& seen = seen_[diagnostic.row];
    if (seen >= options_.repeats) {
        ++seen;
        count(diagnostic);
        return;
    }
    const std::string text = rendered(diagnostic);
    if (!first_time(text)) return;
    ++seen;
    count(diagnostic);
    write_(text);
}

void Messages::finish() {
    std::vector<std::pair<std::string_view, std::size_t>> left_out;
    for (const auto& [row, seen] : seen_) {
        if (seen > options_.repeats) left_out.emplace_back(row->code, seen - options_.repeats);
    }
    std::sort(left_out.begin(), left_out.end());
    for (const auto& [code, number] : left_out) {
        Diagnostic diagnostic;
        diagnostic.row = &diag::MessagesLeftOut;
        diagnostic.severity = Severity::Warning;
        diagnostic.arguments = {std::to_string(number), std::string(code)};
        write_(rendered(diagnostic));
    }
    seen_.clear();
}

}  // namespace kadr::driver
