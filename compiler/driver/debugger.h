// debugger.h — looks on while a control's program runs: shows what each block changes, stops at
// break points.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/done.h"
#include "driver/break_points.h"
#include "driver/execution.h"
#include "driver/trace.h"

namespace kadr::driver {

class Debugger final : public macro::LineWatch {
  public:
    /// Is shown every block, and the state behind it; block 0 is what the program found.
    using Look = std::function<void(const TraceStep&, const TraceState&)>;

    /// Null: a break point of the job is none, which is reported. `look` may be empty. All
    /// references outlive the debugger.
    static std::unique_ptr<Debugger> open(Session& session, const RunJob& job, Look look);

    /// What the execution is opened with, besides its map.
    void look_on(Aside& aside) {
        aside.watch = this;
        aside.changes = &changes_;
    }
    /// The execution that it looks at; before the first command is pulled.
    void follow(Execution& execution) { execution_ = &execution; }

    bool comes_to(const macro::WatchedLine& line) override;
    /// Shows the block that was executed last, and warns of break points that the run never came
    /// to. `alarm`: that ended the run; empty: none.
    void finish(const std::string& alarm);

  private:
    struct WatchedPoint {
        BreakPoint point;
        bool was_reached = false;
    };
    Debugger(Session& session, const RunJob& job, Look look)
        : session_(session), job_(job), look_(std::move(look)) {}

    static Done take_watched_points(const std::vector<std::string>& texts,
                                    std::vector<WatchedPoint>& points, DiagnosticSink& sink);
    TraceState state();
    void end_step();
    void begin_step(const macro::WatchedLine& line);
    void find_statement(TraceStep& step) const;
    StopArrival arrival_at(const macro::WatchedLine& line);
    FileLine lines_of(const SourceRange& range) const;
    static const WatchedPoint* find(std::vector<WatchedPoint>& points, const StopArrival& arrival);
    void warn_of(const std::vector<WatchedPoint>& points);

    // the conversation
    bool stop(std::string_view reason);
    bool obey(std::string_view command, bool& is_over);
    void show_stop(std::string_view reason);
    void show_position();
    void show_state();
    void show_variables(std::string_view part);
    void show_calls();
    std::string stop_json(std::string_view reason);
    void say(const std::string& text) const;

    Session& session_;
    const RunJob& job_;
    Look look_;
    Execution* execution_ = nullptr;
    std::vector<WatchedPoint> breaks_;
    std::vector<WatchedPoint> until_;
    std::vector<macro::VariableChange> changes_;
    std::optional<TraceStep> step_;  // that is executed
    std::uint64_t traced_ = 0;
    std::uint64_t blocks_before_ = 0;
    std::uint64_t statements_before_ = 0;
    CallWatch calls_;
    std::string program_;  // that the line before belongs to
    std::size_t level_ = 0;
    bool is_stepping_ = false;
    bool has_begun_ = false;
    std::string last_command_;
};

}  // namespace kadr::driver
