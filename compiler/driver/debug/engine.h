// engine.h — looks on while a program runs, and lets it stand where somebody wants it to.
//
// Knows places, steps and reasons, and shows them as data (stop.h, inspection.h). It says nothing:
// that is for its faces, as the conversation at a break point is one.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include "driver/debug/call_trail.h"
#include "driver/debug/inspection.h"
#include "driver/debug/next_lines.h"
#include "driver/debug/places.h"
#include "driver/debug/stepping.h"
#include "driver/debug/steps.h"
#include "driver/debug/stop.h"
#include "driver/execution.h"

namespace kadr::driver {

class DebugEngine final : public macro::LineWatch, public expand::StatementWatch {
  public:
    /// Is shown where the run stands, and says how it goes on. While it works, everything that the
    /// run is can be asked.
    using Stand = std::function<Resume(const Stop&)>;

    /// The session outlives the engine.
    explicit DebugEngine(Session& session);

    /// To be set before the execution is opened, as the first places: without one and without
    /// `stop_at_entry` a Kadr program is only traced.
    void stand_by(Stand stand) { stand_ = std::move(stand); }
    void stop_at_entry() { advance_ = {Resume::StepIn, {}, StopReason::Entry}; }
    void trace_to(Steps::Look look) { steps_.show_to(std::move(look)); }
    Places& places() { return places_; }
    const Places& places() const { return places_; }
    /// What the execution is opened with, besides its map.
    void look_on(Aside& aside);
    /// The execution that it looks at; before the first command is pulled.
    void follow(Execution& execution);

    /// Any thread may ask: it stands in front of what comes next.
    void pause() { wants_pause_ = true; }
    /// The run has ended. `alarm`: that was why; empty: none. What is evaluated from here on,
    /// nobody looks at.
    void finish(const std::string& alarm);
    /// Whether who looks on has ended it.
    bool has_ended_run() const { return has_ended_; }
    /// Why it has ended: Until, Alarm or End.
    StopReason ending() const { return ending_; }

    Inspection& inspection() { return inspection_; }
    const Execution& execution() const { return *execution_; }
    /// Whether no run can come to the place: it is a line of a source of the program, and no
    /// statement begins there.
    bool is_out_of_reach(const BreakPoint& point) const;
    /// Whether a line is one of those that the range takes.
    bool is_on_lines(const BreakPoint& point, const SourceRange& range) const;

    bool comes_to(const macro::WatchedLine& line) override;
    Answer comes_to(std::uint32_t statement) override;
    /// Also if an error has ended a program that it sees statement by statement.
    bool has_ended() const override;

  private:
    StopArrival arrival_at(const macro::WatchedLine& line, const TraceStep& step);
    FileLine lines_of(const SourceRange& range) const;
    std::string_view started() const;
    const WatchedPlace* reach(const StopArrival& arrival);
    bool goes_on(const StopArrival& arrival, const Arrival& at, Stop stop);
    bool stand(Stop stop, const Arrival& at);
    std::optional<TraceStep> next_line();
    bool waits_for_start();
    void end(StopReason why);

    Session& session_;
    Stand stand_;
    Places places_;
    Steps steps_;
    Inspection inspection_;
    CallTrail trail_;
    std::unique_ptr<NextLines> ahead_;  // made when it is asked
    Execution* execution_ = nullptr;
    Advance advance_;
    std::atomic<bool> wants_pause_ = false;
    bool sees_statements_ = false;
    bool has_ended_ = false;
    bool is_finished_ = false;
    StopReason ending_ = StopReason::End;
    Stop last_;            // in front of what was executed last
    std::string program_;  // that the line before belongs to
    std::size_t level_ = 0;
};

}  // namespace kadr::driver
