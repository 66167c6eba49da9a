// reporter.h — messages of the interpreter, and whether the run has ended: an alarm ends it.
#pragma once

#include <cstddef>
#include <string>

#include "base/diagnostic.h"
#include "base/discarding_sink.h"
#include "nc/block.h"
#include "nc/dialect.h"
#include "nc/reader.h"

namespace kadr::interp {

class Reporter {
  public:
    /// locations  where blocks stand in the text; null: messages point at lines
    Reporter(const nc::Dialect& dialect, const nc::BlockLocations* locations, DiagnosticSink& sink)
        : dialect_(dialect), locations_(locations), sink_(&sink) {}
    Reporter(const Reporter&) = delete;
    Reporter& operator=(const Reporter&) = delete;

    /// Points at the block, at one of its words, at one of its functions, at an argument of one, or
    /// anywhere. An alarm ends the run, and has the number and the text of the control.
    DiagnosticBuilder report(const DiagnosticRow& row, const nc::Block& block);
    DiagnosticBuilder report(const DiagnosticRow& row, const nc::Block& block, nc::Slot slot);
    DiagnosticBuilder report(const DiagnosticRow& row, const nc::Block& block,
                             nc::Function function);
    DiagnosticBuilder report(const DiagnosticRow& row, const nc::Block& block,
                             nc::Function function, std::size_t argument);
    DiagnosticBuilder report(const DiagnosticRow& row, TextLocation location);

    /// A function as the text of the block spells it; by the vocabulary where no text does.
    std::string word_of(const nc::Block& block, nc::Function function) const;
    /// A function as the control spells it, whether a block has programmed it or not; by the
    /// vocabulary where the control has no word for it.
    std::string spelling_of(nc::Function function) const;

    const nc::BlockLocations* locations() const { return locations_; }

    bool has_ended() const { return ended_; }
    bool has_alarm() const { return alarmed_; }
    /// The program has come to its end.
    void end() { ended_ = true; }
    /// An alarm of which others have reported.
    void stop() { ended_ = alarmed_ = true; }
    /// What has ended the run does not count.
    void go_on() { ended_ = alarmed_ = false; }

    enum class Locations : std::uint8_t { Kept, Hidden };
    /// While it lives, nobody hears of anything.
    class Silence {
      public:
        explicit Silence(Reporter& reporter, Locations locations = Locations::Kept);
        ~Silence();
        Silence(const Silence&) = delete;
        Silence& operator=(const Silence&) = delete;

      private:
        DiscardingSink nobody_;
        Reporter& reporter_;
        DiagnosticSink* sink_;
        const nc::BlockLocations* locations_;
    };

  private:
    DiagnosticBuilder note_calls(DiagnosticBuilder builder, const nc::Block& block) const;

    const nc::Dialect& dialect_;
    const nc::BlockLocations* locations_;
    DiagnosticSink* sink_;
    bool ended_ = false;
    bool alarmed_ = false;
};

}  // namespace kadr::interp
