// messages.h — the sink behind a session: renders each diagnostic as it comes, counts, and keeps a
// mistake in a loop from drowning the others.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "base/diagnostic.h"

namespace kadr::driver {

enum class MessageFormat : std::uint8_t { Text, Json };

struct MessageOptions {
    MessageFormat format = MessageFormat::Text;
    bool color = false;
    std::size_t repeats = 20;  // messages of one row that are shown
};

class Messages final : public DiagnosticSink {
  public:
    /// Takes the rendered text of one message, line end included.
    using Write = std::function<void(std::string_view)>;

    /// `sources` outlives the sink: it is asked for lines and columns.
    Messages(const Sources& sources, MessageOptions options, Write write);

    /// Renders the diagnostic at once, unless it is a warning that the source allows. The same
    /// words at the same location are reported once; of one row only the first `repeats` are shown.
    /// All are counted.
    void take(Diagnostic diagnostic) override;

    /// Reports how many messages were left out. To be called once, at the end.
    void finish();

    std::size_t warnings() const { return warnings_; }
    std::size_t errors() const { return errors_; }
    std::size_t alarms() const { return alarms_; }
    /// The first alarm as one line of text, for the outputs that end with it; empty if none.
    const std::string& first_alarm() const { return first_alarm_; }
    /// The words of the first error or alarm, without its location; empty if none.
    const std::string& first_error() const { return first_error_; }

    /// Whether a comment in the source silences warnings of this code at the location.
    bool is_allowed(std::string_view code, const SourceRange& location) const;
    /// Whether a comment at the location of a warning allows it.
    bool is_silenced(const Diagnostic& diagnostic) const;

  private:
    void count(const Diagnostic& diagnostic);
    bool first_time(const std::string& rendered);
    std::string rendered(const Diagnostic& diagnostic) const;

    const Sources& sources_;
    MessageOptions options_;
    Write write_;
    std::size_t warnings_ = 0;
    std::size_t errors_ = 0;
    std::size_t alarms_ = 0;
    std::string first_alarm_;
    std::string first_error_;
    std::unordered_map<const DiagnosticRow*, std::size_t> seen_;
    std::unordered_set<std::size_t> shown_;  // hashes of what was reported
};

}  // namespace kadr::driver
