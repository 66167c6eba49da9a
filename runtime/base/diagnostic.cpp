#include "base/diagnostic.h"

#include <algorithm>
#include <utility>

#include "base/readable.h"

namespace kadr {

namespace diag {
#define KADR_DIAGNOSTIC(name, code, severity, message, explanation, wrong, right)              \
    extern constexpr DiagnosticRow name{#name, code, Severity::severity, message, explanation, \
                                        wrong, right};
#include "base/diagnostics/all.def"
#undef KADR_DIAGNOSTIC
}  // namespace diag

namespace {

std::vector<const DiagnosticRow*> sorted_rows() {
    std::vector<const DiagnosticRow*> rows{
#define KADR_DIAGNOSTIC(name, code, severity, message, explanation, wrong, right) &diag::name,
#include "base/diagnostics/all.def"
#undef KADR_DIAGNOSTIC
    };
    std::stable_sort(rows.begin(), rows.end(),
                     [](const auto* a, const auto* b) { return a->code < b->code; });
    return rows;
}

}  // namespace

std::span<const DiagnosticRow* const> all_diagnostics() {
    static const std::vector<const DiagnosticRow*> rows = sorted_rows();
    return rows;
}

const DiagnosticRow* find_diagnostic(std::string_view code) {
    for (const DiagnosticRow* row : all_diagnostics()) {
        if (row->code == code || row->name == code) return row;
    }
    return nullptr;
}

std::string format_message(std::string_view wording, std::span<const std::string> arguments) {
    std::string text;
    for (std::size_t i = 0; i < wording.size(); ++i) {
        const bool is_argument = wording[i] == '{' && i + 2 < wording.size() &&
                                 wording[i + 1] >= '0' && wording[i + 1] <= '9' &&
                                 wording[i + 2] == '}';
        if (!is_argument) {
            text += wording[i];
            continue;
        }
        const auto number = static_cast<std::size_t>(wording[i + 1] - '0');
        text += number < arguments.size() ? arguments[number] : std::string("?");
        i += 2;
    }
    return text;
}

std::string Diagnostic::message() const { return format_message(row->message, arguments); }

DiagnosticBuilder::DiagnosticBuilder(DiagnosticSink& sink, Diagnostic diagnostic)
    : sink_(&sink), diagnostic_(std::move(diagnostic)) {}

DiagnosticBuilder::DiagnosticBuilder(DiagnosticBuilder&& other) noexcept
    : sink_(std::exchange(other.sink_, nullptr)), diagnostic_(std::move(other.diagnostic_)) {}

DiagnosticBuilder::~DiagnosticBuilder() {
    if (sink_ != nullptr) sink_->take(std::move(diagnostic_));
}

DiagnosticBuilder& DiagnosticBuilder::arg(std::string_view text) {
    diagnostic_.arguments.emplace_back(text);
    return *this;
}

DiagnosticBuilder& DiagnosticBuilder::arg(double value) {
    return arg(std::string_view(readable(value)));
}

DiagnosticBuilder& DiagnosticBuilder::arg(std::int64_t value) { return arg(std::to_string(value)); }

DiagnosticBuilder& DiagnosticBuilder::at(TextLocation location) {
    diagnostic_.line = std::move(location);
    return *this;
}

DiagnosticBuilder& DiagnosticBuilder::note(const SourceRange& range, std::string text) {
    diagnostic_.notes.push_back({range, std::nullopt, std::move(text)});
    return *this;
}

DiagnosticBuilder& DiagnosticBuilder::note(std::string text) {
    diagnostic_.notes.push_back({{}, std::nullopt, std::move(text)});
    return *this;
}

DiagnosticBuilder& DiagnosticBuilder::note(TextLocation location, std::string text) {
    diagnostic_.notes.push_back({{}, std::move(location), std::move(text)});
    return *this;
}

DiagnosticBuilder& DiagnosticBuilder::fix(const SourceRange& range, std::string replacement,
                                          std::string text) {
    diagnostic_.fixes.push_back({range, std::move(replacement), std::move(text)});
    return *this;
}

DiagnosticBuilder& DiagnosticBuilder::fix(std::string text) {
    diagnostic_.fixes.push_back({{}, {}, std::move(text)});
    return *this;
}

DiagnosticBuilder& DiagnosticBuilder::alarm(std::string number, std::string text) {
    diagnostic_.severity = Severity::Alarm;
    diagnostic_.alarm_number = std::move(number);
    diagnostic_.alarm_text = std::move(text);
    return *this;
}

DiagnosticBuilder DiagnosticSink::report(const DiagnosticRow& row, const SourceRange& range) {
    Diagnostic diagnostic;
    diagnostic.row = &row;
    diagnostic.severity = row.severity;
    diagnostic.range = range;
    return {*this, std::move(diagnostic)};
}

DiagnosticBuilder DiagnosticSink::report(const DiagnosticRow& row) {
    return report(row, SourceRange{});
}

DiagnosticBuilder DiagnosticSink::report(const DiagnosticRow& row, TextLocation location) {
    Diagnostic diagnostic;
    diagnostic.row = &row;
    diagnostic.severity = row.severity;
    diagnostic.line = std::move(location);
    return {*this, std::move(diagnostic)};
}

void DiagnosticList::take(Diagnostic diagnostic) {
    if (diagnostic.severity != Severity::Warning) ++errors_;
    all_.push_back(std::move(diagnostic));
}

}  // namespace kadr
