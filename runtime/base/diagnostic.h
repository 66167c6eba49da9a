// diagnostic.h — what Kadr has to report to its user.
//
// Every message is a row of one table (diagnostics/*.def): stable code, severity, wording, an
// explanation with a wrong and a right example. Who reports a row includes the header of its
// table (diagnostics/sema.h …): a new row builds one room again and not the house. A diagnostic
// adds location, arguments, notes and fixes, and goes to a sink; render.h renders it.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/source.h"

namespace kadr {

enum class Severity : std::uint8_t { Warning, Error, Alarm };

/// One row of the table. `message` and the explanation name arguments by `{0}`, `{1}` …
struct DiagnosticRow {
    std::string_view name;  // as in C++: "FeedMissing"
    std::string_view code;  // as the user sees it: "K3104"
    Severity severity;
    std::string_view message;
    std::string_view explanation;  // one paragraph
    std::string_view wrong;        // an example that causes it
    std::string_view right;        // the same, mended
};

/// All rows, in the order of their codes.
std::span<const DiagnosticRow* const> all_diagnostics();

/// The row with this code ("K3104") or name; nullptr if there is none.
const DiagnosticRow* find_diagnostic(std::string_view code);

/// A location in a text that is read as a stream and not kept, as ISO-7bit text is: the line comes
/// along, because nobody can look it up later.
struct TextLocation {
    std::string file;
    std::uint32_t line = 0;    // from 1
    std::uint32_t column = 1;  // from 1, in characters
    std::uint32_t length = 1;  // characters to underline, at least 1
    std::string text;          // the line, without its end
};

struct Diagnostic {
    struct Note {
        SourceRange range;  // may be invalid: a note without a location
        std::optional<TextLocation> line;
        std::string text;
    };
    struct Fix {
        SourceRange range;        // what to replace; empty range: insert
        std::string replacement;  // may be empty: the fix is words only
        std::string text;         // what to do, in words
    };

    const DiagnosticRow* row = nullptr;
    Severity severity = Severity::Error;
    SourceRange range;                 // where, in a kept text
    std::optional<TextLocation> line;  // where, in a streamed text; wins over `range`
    std::vector<std::string> arguments;
    std::vector<Note> notes;
    std::vector<Fix> fixes;
    std::string alarm_number;  // the control's own number, if the dialect names one: "14040"
    std::string alarm_text;    // the control's own words

    /// The wording of the row with the arguments filled in.
    std::string message() const;
};

/// Fills arguments into a wording: `{0}`, `{1}` …
std::string format_message(std::string_view wording, std::span<const std::string> arguments);

class DiagnosticSink;

/// Collects the parts of a diagnostic; delivered to the sink when it goes out of scope.
class DiagnosticBuilder {
  public:
    DiagnosticBuilder(DiagnosticSink& sink, Diagnostic diagnostic);
    DiagnosticBuilder(DiagnosticBuilder&& other) noexcept;
    DiagnosticBuilder(const DiagnosticBuilder&) = delete;
    DiagnosticBuilder& operator=(const DiagnosticBuilder&) = delete;
    DiagnosticBuilder& operator=(DiagnosticBuilder&&) = delete;
    ~DiagnosticBuilder();

    DiagnosticBuilder& arg(std::string_view text);
    DiagnosticBuilder& arg(const char* text) { return arg(std::string_view(text)); }
    DiagnosticBuilder& arg(double value);  // as a person would write it
    DiagnosticBuilder& arg(std::int64_t value);
    DiagnosticBuilder& arg(int value) { return arg(static_cast<std::int64_t>(value)); }
    DiagnosticBuilder& arg(std::size_t value) { return arg(static_cast<std::int64_t>(value)); }
    DiagnosticBuilder& at(TextLocation location);
    DiagnosticBuilder& note(const SourceRange& range, std::string text);
    DiagnosticBuilder& note(std::string text);
    DiagnosticBuilder& note(TextLocation location, std::string text);
    DiagnosticBuilder& fix(const SourceRange& range, std::string replacement, std::string text);
    DiagnosticBuilder& fix(std::string text);
    DiagnosticBuilder& alarm(std::string number, std::string text);

  private:
    DiagnosticSink* sink_;
    Diagnostic diagnostic_;
};

/// Where diagnostics go. `take` decides: collect, render, count.
class DiagnosticSink {
  public:
    virtual ~DiagnosticSink() = default;
    virtual void take(Diagnostic diagnostic) = 0;

    DiagnosticBuilder report(const DiagnosticRow& row, const SourceRange& range);
    DiagnosticBuilder report(const DiagnosticRow& row);
    DiagnosticBuilder report(const DiagnosticRow& row, TextLocation location);
};

/// A sink that keeps everything, for tests and for rooms that look before they speak.
class DiagnosticList final : public DiagnosticSink {
  public:
    void take(Diagnostic diagnostic) override;
    bool has_errors() const { return errors_ > 0; }
    std::size_t errors() const { return errors_; }  // errors and alarms
    const std::vector<Diagnostic>& all() const { return all_; }

  private:
    std::vector<Diagnostic> all_;
    std::size_t errors_ = 0;
};

}  // namespace kadr
