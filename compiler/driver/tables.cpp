#include "driver/tables.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "base/diagnostic.h"
#include "base/diagnostics/driver.h"
#include "base/done.h"
#include "base/text.h"
#include "driver/examples.h"
#include "driver/pipeline_stages.h"
#include "machine/machine.h"
#include "nc/alarms.h"
#include "nc/command_names.h"
#include "nc/lint.h"
#include "write/check.h"

namespace kadr::driver {

namespace {

constexpr std::size_t kLineWidth = 88;  // of an explanation

std::string_view severity_word(Severity severity) {
    switch (severity) {
        case Severity::Warning: return "warning";
        case Severity::Error: return "error";
        case Severity::Alarm: return "alarm";
    }
    return "error";
}

/// Breaks a paragraph at blanks.
std::string wrapped(std::string_view text) {
    std::string out;
    while (text.size() > kLineWidth) {
        std::size_t end = text.rfind(' ', kLineWidth);
        if (end == std::string_view::npos) end = std::min(text.find(' '), text.size());
        out += text.substr(0, end);
        out += '\n';
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return out + std::string(text) + '\n';
}

std::string indented(std::string_view text) {
    std::string out = "    ";
    for (const char c : text) {
        out += c;
        if (c == '\n') out += "    ";
    }
    return out + '\n';
}

/// The wording as a person reads it: `{0}` is an ellipsis.
std::string wording(const DiagnosticRow& row) {
    const std::vector<std::string> ellipses(10, "…");
    return format_message(row.message, ellipses);
}

std::string all_messages() {
    std::string out;
    for (const DiagnosticRow* row : all_diagnostics()) {
        fmt::format_to(std::back_inserter(out), "{}  {:<8} {}\n", row->code,
                       severity_word(row->severity), wording(*row));
    }
    return out;
}

std::size_t widest(const std::vector<std::string>& names) {
    std::size_t width = 0;
    for (const std::string& name : names) width = std::max(width, name.size());
    return width;
}

/// What is named as a file can be read; if not, it is wrong usage, not a mistake in it.
Done require_file(Session& session, const std::string& name_or_file) {
    const bool is_file =
        name_or_file.find('/') != std::string::npos || name_or_file.ends_with(".xml");
    if (!is_file) return kDone;
    const auto text = session.access().read(name_or_file);
    if (text) return kDone;
    report_unread(session.messages(), diag::FileUnreadable, {}, name_or_file, text.error(),
                  session.access());
    session.mark_usage();
    return kFailed;
}

/// A name that nothing here has is wrong usage, as a missing file is.
template <class Summaries>
void mark_unknown(Session& session, const std::string& name, const Summaries& summaries) {
    const auto has_name = [&](const auto& summary) { return summary.name == name; };
    const bool is_file = name.find('/') != std::string::npos || name.ends_with(".xml");
    if (!is_file && std::ranges::none_of(summaries, has_name)) session.mark_usage();
}

std::string explanation_of(const DiagnosticRow& row) {
    std::string out =
        fmt::format("{}[{}]: {}\n\n", severity_word(row.severity), row.code, wording(row));
    out += wrapped(row.explanation);
    if (!row.wrong.empty()) out += "\nwrong:\n" + indented(row.wrong);
    if (!row.right.empty()) out += "\nright:\n" + indented(row.right);
    return out;
}

/// An alarm by the number that controls show, with everything that raises it; empty: no shipped
/// dialect has it.
std::string explanation_of_alarm(Session& session, std::string_view number) {
    std::vector<const DiagnosticRow*> rows;
    std::string out;
    for (const nc::DialectSummary& summary :
         nc::list_dialects(session.share().dialects, session.files())) {
        const bool is_sound =
            nc::can_be_loaded(summary.name, session.share().dialects, session.files());
        const nc::Dialect* dialect = is_sound ? session.dialect(summary.name) : nullptr;
        if (dialect == nullptr) continue;
        const std::vector<nc::KnownAlarm> found = nc::alarms_numbered(*dialect, number);
        if (found.empty()) continue;
        out += fmt::format("alarm {} of {}: {}\n", found[0].alarm.number, dialect->title(),
                           found[0].alarm.text);
        for (const nc::KnownAlarm& known : found) {
            if (std::ranges::find(rows, known.row) == rows.end()) rows.push_back(known.row);
        }
    }
    for (const DiagnosticRow* row : rows) out += '\n' + explanation_of(*row);
    return out;
}

/// One after the other as their lines stand in the files, whoever found them.
void say_in_order(const DiagnosticList& found, DiagnosticSink& sink) {
    std::vector<Diagnostic> all = found.all();
    std::ranges::stable_sort(all, [](const Diagnostic& a, const Diagnostic& b) {
        if (a.range.file != b.range.file) return a.range.file.index < b.range.file.index;
        return a.range.begin < b.range.begin;
    });
    for (Diagnostic& one : all) sink.take(std::move(one));
}

}  // namespace

Reply explain_message(Session& session, std::string_view code) {
    if (code.empty()) return {Status::Done, all_messages()};
    const DiagnosticRow* row = find_diagnostic(upper_ascii(code));
    if (row == nullptr) row = find_diagnostic(code);
    if (row != nullptr) return {Status::Done, explanation_of(*row)};
    if (std::string alarm = explanation_of_alarm(session, code); !alarm.empty())
        return {Status::Done, std::move(alarm)};
    session.messages().report(diag::NoDiagnostic).arg(code);
    session.mark_usage();
    return {session.status(), {}};
}

Reply list_dialects(Session& session) {
    const auto summaries = nc::list_dialects(session.share().dialects, session.files());
    std::vector<std::string> names;
    names.reserve(summaries.size());
    for (const auto& summary : summaries) names.push_back(summary.name);
    const std::size_t width = widest(names);
    std::string out;
    for (const auto& summary : summaries) {
        const bool is_sound =
            nc::can_be_loaded(summary.name, session.share().dialects, session.files());
        fmt::format_to(std::back_inserter(out), "{:<{}}  {:<4} {}{}\n", summary.name, width,
                       summary.suffix.empty() ? "-" : summary.suffix, summary.title,
                       is_sound ? "" : ", has mistakes");
    }
    return {Status::Done, std::move(out)};
}

Reply check_dialect(Session& session, const std::string& name_or_file) {
    if (!require_file(session, name_or_file)) return {session.status(), {}};
    DiagnosticList found;
    const nc::InspectedDialect inspected = session.inspect_dialect(name_or_file, found);
    if (inspected.dialect) nc::check_sense(inspected.root, *inspected.dialect, found);
    say_in_order(found, session.messages());
    if (!inspected.dialect) {
        mark_unknown(session, name_or_file,
                     nc::list_dialects(session.share().dialects, session.files()));
        return {session.status(), {}};
    }
    const nc::Dialect& dialect = *inspected.dialect;
    if (inspected.has_mistakes) {
        // What is tried out would only report the same mistakes again.
        return {session.status(),
                fmt::format("{}: the examples are tried when these are mended\n", dialect.name())};
    }
    write::check_frame(dialect, session.messages());
    check_cycles(session, dialect);
    check_examples(session, dialect);
    if (session.messages().errors() > 0) return {session.status(), {}};
    return {session.status(),
            fmt::format("{}: {}, no mistakes\n", dialect.name(), dialect.title())};
}

Reply explain_word(Session& session, const std::string& name_or_file, const std::string& word) {
    if (!require_file(session, name_or_file)) return {session.status(), {}};
    const nc::Dialect* dialect = session.dialect(name_or_file);
    if (dialect == nullptr) {
        session.mark_usage();
        return {session.status(), {}};
    }
    std::string out;
    const std::vector<std::string> lines =
        word.empty() ? nc::command_names(*dialect) : nc::explain(*dialect, word);
    for (const std::string& line : lines) out += line + '\n';
    if (!out.empty()) return {Status::Done, std::move(out)};
    session.messages().report(diag::WordUnknown).arg(dialect->name()).arg(word);
    return {session.status(), {}};
}

Reply list_machines(Session& session) {
    const auto summaries = machine::list(session.share().machines, session.files());
    std::vector<std::string> names;
    names.reserve(summaries.size());
    for (const auto& summary : summaries) names.push_back(summary.name);
    const std::size_t width = widest(names);
    std::string out;
    for (const auto& summary : summaries) {
        fmt::format_to(std::back_inserter(out), "{:<{}}  {} ({})\n", summary.name, width,
                       summary.title, summary.axes.empty() ? "has mistakes" : summary.axes);
    }
    return {Status::Done, std::move(out)};
}

std::optional<machine::Machine> machine_of(Session& session, const std::string& name_or_file) {
    if (!require_file(session, name_or_file)) return std::nullopt;
    auto machine = session.load_machine(name_or_file);
    if (machine) return std::move(machine->machine);
    mark_unknown(session, name_or_file, machine::list(session.share().machines, session.files()));
    return std::nullopt;
}

Reply check_machine(Session& session, const std::string& name_or_file) {
    const auto machine = machine_of(session, name_or_file);
    if (!machine) return {session.status(), {}};
    if (!require_modules(*machine, session.messages())) {
        session.mark_usage();
        return {session.status(), {}};
    }
    return {session.status(), fmt::format("{}: {}, {} axes, no mistakes\n", machine->name,
                                          machine->title, machine->axes.size())};
}

}  // namespace kadr::driver
