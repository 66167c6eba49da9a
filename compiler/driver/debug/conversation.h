// conversation.h — the engine's face at a terminal: shows where the run stands, and does what a
// person answers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/done.h"
#include "driver/debug/engine.h"
#include "driver/options.h"

namespace kadr::driver {

class Conversation {
  public:
    /// All outlive it.
    Conversation(Session& session, const Onlooker& onlooker, DebugEngine& engine);

    /// Takes the places of a job. Not done: one is none, which is reported.
    Done take_places(const RunJob& job);
    /// Warns of places of the job that the run never came to.
    void warn_of_places() const;

  private:
    Done take(const std::vector<std::string>& texts, WatchedPlace::Effect effect);
    Resume stand(const Stop& stop);
    void report(const Stop& stop);
    /// What a command asks for; nothing: the conversation goes on.
    std::optional<Resume> obey(std::string_view command);
    void show_state();
    void show_variables(std::string_view part);
    void show_locals(std::string_view what);
    void show_globals(std::string_view part);
    void show_calls();
    void add_place(std::string_view text);
    bool is_called() const;
    void say(const std::string& text) const;

    Session& session_;
    const Onlooker& onlooker_;
    DebugEngine& engine_;
    std::vector<PlaceId> asked_;  // places of the job, in its order
    Stop stop_;
    std::string last_command_;
};

}  // namespace kadr::driver
