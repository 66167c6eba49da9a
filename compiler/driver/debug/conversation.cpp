#include "driver/debug/conversation.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "base/diagnostics/driver.h"
#include "base/text.h"
#include "driver/debug/stop_text.h"

namespace kadr::driver {

namespace {

constexpr const char* kHelp =
    ":step       execute this block, stop in front of the next; an empty line does it again\n"
    ":next       the same, but what is called is executed as a whole\n"
    ":out        on until the function or the subprogram has returned\n"
    ":continue   on to the next break point\n"
    ":state      position, codes, feed, speed, tool\n"
    ":vars [R]   variables of the control; those that begin so\n"
    ":locals [N] variables of the Kadr program; those that begin so, or those of the Nth caller\n"
    ":globals    variables of its file\n"
    ":calls      the calls of the Kadr program that led here\n"
    ":break N50  stop there too\n"
    ":quit       the program ends here\n";

struct CommandWords {
    std::string_view name;
    std::string_view rest;
};

/// `:vars R1` without its colon.
CommandWords words_of(std::string_view line) {
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    return {line.substr(0, end),
            line.substr(std::min(line.find_first_not_of(" \t", end), line.size()))};
}

std::string_view without_blanks(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t:"), line.size()));
    return line.substr(0, line.find_last_not_of(" \t\r") + 1);
}

/// What makes the run go on; `step` and `continue` come before others that begin so.
struct Going {
    std::string_view name;
    Resume resume;
};
constexpr std::array<Going, 4> kGoings = {{{"step", Resume::StepIn},
                                           {"next", Resume::StepOver},
                                           {"out", Resume::StepOut},
                                           {"continue", Resume::Continue}}};

std::optional<std::size_t> number_in(std::string_view text) {
    std::size_t number = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_whole = read.ec == std::errc() && read.ptr == text.data() + text.size();
    return is_whole ? std::optional(number) : std::nullopt;
}

}  // namespace

Conversation::Conversation(Session& session, const Onlooker& onlooker, DebugEngine& engine)
    : session_(session), onlooker_(onlooker), engine_(engine) {
    engine.stand_by([this](const Stop& stop) { return stand(stop); });
}

Done Conversation::take(const std::vector<std::string>& texts, WatchedPlace::Effect effect) {
    for (const std::string& text : texts) {
        auto point = BreakPoint::parse(text);
        if (!point) {
            session_.messages().report(diag::PlaceUnclear).arg(text);
            return kFailed;
        }
        asked_.push_back(engine_.places().add(std::move(*point), effect));
    }
    return kDone;
}

Done Conversation::take_places(const RunJob& job) {
    if (!take(job.breaks, WatchedPlace::Effect::Stops)) return kFailed;
    return take(job.until, WatchedPlace::Effect::Ends);
}

void Conversation::warn_of_places() const {
    for (const PlaceId id : asked_) {
        const WatchedPlace* place = engine_.places().find(id);
        if (place == nullptr || place->was_reached) continue;
        session_.messages().report(diag::PlaceNeverReached).arg(place->point.text());
    }
}

void Conversation::say(const std::string& text) const {
    if (onlooker_.say) onlooker_.say(text);
}

Resume Conversation::stand(const Stop& stop) {
    stop_ = stop;
    if (!onlooker_.ask) {
        if (stop.reason != StopReason::Alarm) report(stop);
        return Resume::End;
    }
    const std::string reason = reason_of(stop, engine_.places());
    say(stop.is_at_statement() ? statement_head(stop, reason, session_)
                               : line_head(stop, reason, session_));
    say(position_lines(engine_.inspection().state()));
    for (;;) {
        const std::optional<std::string> command = onlooker_.ask();
        if (!command) return Resume::End;
        if (const std::optional<Resume> resume = obey(*command)) return *resume;
    }
}

/// Nobody asks for more: all of it.
void Conversation::report(const Stop& stop) {
    const std::string reason = reason_of(stop, engine_.places());
    if (onlooker_.reads_json) return say(stop_json(stop, reason, engine_, session_));
    say(shows_line(stop, engine_) ? line_head(stop, reason, session_)
                                  : statement_head(stop, reason, session_));
    say(position_lines(engine_.inspection().state()));
    show_state();
    show_variables({});
    show_calls();
    if (!stop.is_at_statement()) return;
    Inspection& inspection = engine_.inspection();
    say(variable_lines(inspection.variables(inspection.scopes(0)[0].variables), {}));
}

std::optional<Resume> Conversation::obey(std::string_view line) {
    line = without_blanks(line);
    const std::string again = last_command_;
    if (line.empty()) line = again;
    const auto [name, rest] = words_of(line);
    const auto is = [name = name](std::string_view command) {
        return !name.empty() && command.starts_with(name);
    };
    for (const Going& going : kGoings) {
        if (!is(going.name)) continue;
        if (going.resume == Resume::StepOut && !is_called()) {
            say("nothing has called this program: `:continue` goes on to its end\n");
            return std::nullopt;
        }
        last_command_ = std::string(line);
        return going.resume;
    }
    if (is("quit")) return Resume::End;
    if (is("state")) {
        say(position_lines(engine_.inspection().state()));
        show_state();
    } else if (is("vars")) {
        show_variables(rest);
    } else if (is("locals")) {
        show_locals(rest);
    } else if (is("globals")) {
        show_globals(rest);
    } else if (is("calls")) {
        show_calls();
    } else if (is("break")) {
        add_place(rest);
    } else {
        say(kHelp);
    }
    return std::nullopt;
}

/// Whether there is a function or a program, as the one in which the run stands, that has called
/// it.
bool Conversation::is_called() const {
    const std::vector<StackFrame>& frames = engine_.inspection().frames();
    return frames.size() > 1 && frames[1].kind == frames[0].kind;
}

void Conversation::add_place(std::string_view text) {
    auto point = BreakPoint::parse(text);
    if (!point) return say("a location is missing: `:break N120`, `:break :34`, `:break NAME`\n");
    if (engine_.is_out_of_reach(*point))
        return say("no statement begins at `" + point->text() + "`\n");
    engine_.places().add(std::move(*point), WatchedPlace::Effect::Stops);
}

void Conversation::show_state() { say(state_lines(engine_.inspection().state())); }

void Conversation::show_variables(std::string_view part) {
    std::string out;
    const std::string wanted = upper_ascii(part);
    for (const macro::ControlVariable& variable : engine_.execution().variables()) {
        if (!upper_ascii(variable.name).starts_with(wanted)) continue;
        out += variable.name + " = " + json_text(variable) + '\n';
    }
    say(out.empty() ? "no variables\n" : out);
}

/// Those of the function in which the run stands, or of one of its callers.
void Conversation::show_locals(std::string_view what) {
    Inspection& inspection = engine_.inspection();
    const std::optional<std::size_t> caller = what.empty() ? std::nullopt : number_in(what);
    std::size_t left = caller.value_or(0);
    for (std::size_t i = 0; i < inspection.frames().size(); ++i) {
        const StackFrame& frame = inspection.frames()[i];
        if (frame.kind != StackFrame::Kind::Function || left-- > 0) continue;
        std::string out;
        if (caller)
            out = "in " + frame.name + ", " + frame.file + ':' + std::to_string(frame.line) + '\n';
        const std::string variables =
            variable_lines(inspection.variables(inspection.scopes(i)[0].variables),
                           caller ? std::string_view() : what);
        return say(out + (variables.empty() ? "no variables\n" : variables));
    }
    say(caller ? "there are not so many callers\n" : "no Kadr program runs here\n");
}

void Conversation::show_globals(std::string_view part) {
    Inspection& inspection = engine_.inspection();
    for (std::size_t i = 0; i < inspection.frames().size(); ++i) {
        if (inspection.frames()[i].kind != StackFrame::Kind::Function) continue;
        const std::string variables =
            variable_lines(inspection.variables(inspection.scopes(i)[1].variables), part);
        return say(variables.empty() ? "no variables\n" : variables);
    }
    say("no Kadr program runs here\n");
}

/// Of the block that is next, else of the statement.
void Conversation::show_calls() {
    std::string out;
    const auto add = [&](std::string_view function, const SourceRange& range) {
        out += "in " + std::string(function) + ", called at " + session_.source_name(range) + '\n';
    };
    const bool is_of_line = onlooker_.ask ? !stop_.is_at_statement() : shows_line(stop_, engine_);
    if (is_of_line) {
        const auto& calls = stop_.line->calls.calls;
        for (auto call = calls.rbegin(); call != calls.rend(); ++call)
            add(call->function, call->range);
    } else {
        const std::vector<StackFrame>& frames = engine_.inspection().frames();
        for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
            if (frames[i + 1].kind == StackFrame::Kind::Function)
                add(frames[i].name, frames[i + 1].range);
        }
    }
    if (!out.empty()) say(out);
}

}  // namespace kadr::driver
