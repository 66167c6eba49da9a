#include "driver/messages.h"

#include <algorithm>
#include <utility>
#include <vector>

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

bool Messages::is_known(const std::string& text) {
    return !shown_.insert(std::hash<std::string>{}(text)).second;
}

void Messages::take(Diagnostic diagnostic) {
    // A row that was said often enough is only counted, so that a mistake in a loop of a million
    // turns costs neither time nor memory.
    std::size_t& seen = seen_[diagnostic.row];
    if (seen >= options_.repeats) {
        ++seen;
        count(diagnostic);
        return;
    }
    const std::string text = rendered(diagnostic);
    if (is_known(text)) return;
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
