#include "repl/prompt.h"

#include <algorithm>

#include <fmt/format.h>

#include "driver/session.h"
#include "driver/summary.h"
#include "repl/line_ends.h"

namespace kadr::repl {

namespace {

constexpr int kDecimals = 3;

std::string position_text(const AxisValues& position) {
    std::string out;
    for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
        out += fmt::format(" {}{:.{}f}", kAxisNames[index(axis)], position[index(axis)], kDecimals);
    }
    for (std::size_t axis = 3; axis < kAxes; ++axis) {
        if (position[axis] == 0) continue;
        out += fmt::format(" {}{:.{}f}", kAxisNames[axis], position[axis], kDecimals);
    }
    return out;
}

/// Entries of the modal state that are not as before: "feed 200 mm/min, plane ZX".
std::string changes(const std::vector<interp::StateItem>& before,
                    const std::vector<interp::StateItem>& after) {
    std::string out;
    for (const interp::StateItem& item : after) {
        if (std::find(before.begin(), before.end(), item) != before.end()) continue;
        out += (out.empty() ? "" : ", ") + std::string(item.name) + ' ' + item.value;
    }
    return out;
}

/// A session for looking at texts only; what it reports is nobody's concern.
class QuietSession {
  public:
    QuietSession(const driver::Options& options, driver::SharedInputs& inputs)
        : sources_(inputs.new_sources()), session_(options, inputs, sources_, messages_) {}
    driver::Session& session() { return session_; }

  private:
    Sources sources_;
    driver::Messages messages_{sources_, {}, [](std::string_view) {}};
    driver::Session session_;
};

}  // namespace

Prompt::Prompt(driver::Options options, driver::SharedInputs& inputs, Surroundings surroundings,
               const std::atomic<bool>* stop)
    : options_(std::move(options)),
      inputs_(inputs),
      surroundings_(std::move(surroundings)),
      stop_(stop) {
    options_.stop = stop_;
    (void)refresh();  // what is wrong is shown
}

void Prompt::take(std::string_view line) {
    const bool is_first = pending_.empty();
    const std::size_t begin = line.find_first_not_of(" \t\r\n");
    if (is_first && begin == std::string_view::npos) return;
    if (is_first && line[begin] == ':') return command(line.substr(begin + 1));
    if (is_first && answers(line)) return;
    pending_ += std::string(line) + '\n';
    QuietSession quiet(options_, inputs_);
    const std::string headers = transcript_.headers();
    if (!has_open_end(pending_)) pending_ = with_line_ends(quiet.session(), headers, pending_);
    if (is_incomplete(quiet.session(), headers, pending_)) return;
    take_input(std::exchange(pending_, {}));
}

void Prompt::finish() {
    if (!pending_.empty()) take_input(std::exchange(pending_, {}));
}

void Prompt::take_input(std::string text) {
    QuietSession quiet(options_, inputs_);
    Input input = classify(quiet.session(), transcript_.headers(), std::move(text));
    // What is wrong is taken for a statement, to have it reported why. So is a header behind
    // statements: it would change how they are read.
    const bool is_late = input.kind == Input::Kind::Header && transcript_.has_statements();
    if (input.kind == Input::Kind::Wrong || is_late) input.kind = Input::Kind::Statement;
    Transcript longer = transcript_;
    longer.add(input);
    ReplayOutcome outcome = evaluate(longer);
    if (!outcome.is_ok) {
        has_failed_ = true;
        return write(outcome.messages);
    }
    const bool is_asked =
        input.kind == Input::Kind::Value ||
        (input.kind == Input::Kind::Call && outcome.lines == now_.lines && !outcome.values.empty());
    if (is_asked) return show_values(outcome);
    keep(std::move(input), std::move(outcome));
}

void Prompt::keep(Input input, ReplayOutcome outcome) {
    write(outcome.messages);
    transcript_.add(std::move(input));
    if (is_stepping_) step_lines(outcome);
    else show_lines(outcome);
    show_values(outcome);
    show_change(now_, outcome);
    now_ = std::move(outcome);
}

void Prompt::show_values(const ReplayOutcome& outcome) const {
    for (const std::string& value : outcome.values) write(value + '\n');
}

std::string Prompt::value_of(const std::string& variable) {
    Transcript longer = transcript_;
    longer.add({Input::Kind::Value, variable + ';'});
    const ReplayOutcome outcome = evaluate(longer);
    return outcome.is_ok && !outcome.values.empty() ? outcome.values.front() : "…";
}

std::string Prompt::program_of(const Transcript& transcript) const {
    QuietSession quiet(options_, inputs_);
    return transcript.program(program_word(quiet.session(), transcript.headers()));
}

ReplayOutcome Prompt::evaluate(const Transcript& transcript) {
    ReplayRequest request;
    request.program = program_of(transcript);
    request.known_lines = now_.lines;
    // An input that is new shows its values.
    const std::vector<Input>& inputs = transcript.inputs();
    const bool is_new = inputs.size() > transcript_.inputs().size();
    const bool is_inside = is_new && (inputs.back().kind == Input::Kind::Statement ||
                                      inputs.back().kind == Input::Kind::Call ||
                                      inputs.back().kind == Input::Kind::Value);
    if (is_inside) request.shown_from = transcript.last_statement(request.program);
    return replay(options_with_files(), inputs_, request, now_.reported);
}

driver::Options Prompt::options_with_files() const {
    driver::Options options = options_;
    options.allow_read.insert(options.allow_read.end(), allowed_.begin(), allowed_.end());
    return options;
}

void Prompt::undo(std::size_t count) {
    if (transcript_.inputs().empty()) return write("nothing to take back\n");
    std::string taken;
    for (; count > 0 && !transcript_.inputs().empty(); --count) {
        const std::string text = transcript_.undo().text;
        taken += "taken back: " + text.substr(0, text.find('\n')) + '\n';
    }
    (void)refresh();  // what is wrong is shown
    write(taken);
}

/// Evaluates what there is once more, under other options or with other files. Not done if it has
/// an error now, which is shown.
Done Prompt::refresh() {
    now_ = {};
    now_ = evaluate(transcript_);
    if (now_.is_ok) return kDone;
    has_failed_ = true;
    write(now_.messages);
    return kFailed;
}

void Prompt::show_change(const ReplayOutcome& before, const ReplayOutcome& after) {
    std::string text;
    if (after.position != before.position) text += "at" + position_text(after.position);
    if (const std::string changed = changes(before.state, after.state); !changed.empty()) {
        text += (text.empty() ? "" : "; ") + changed;
    }
    const double time = after.totals.time - before.totals.time;
    if (time > 0.0005) text += (text.empty() ? "+" : "; +") + driver::duration_text(time);
    if (!text.empty()) write("    " + text + '\n');
}

void Prompt::show_lines(const ReplayOutcome& outcome) {
    const std::uint32_t all = outcome.lines - now_.lines;
    const std::size_t head = all > 24 ? 18 : all;
    for (std::size_t i = 0; i < std::min(head, outcome.first.size()); ++i) {
        write(outcome.first[i].text + '\n');
    }
    if (head == all) return;
    write(fmt::format("    … {} lines more\n", all - head - kLastLines));
    // The last lines stand in `last`, or still in `first` if there are not so many.
    std::vector<std::string> tail;
    for (const TextLine& line : outcome.first) tail.push_back(line.text);
    for (const TextLine& line : outcome.last) tail.push_back(line.text);
    for (std::size_t i = tail.size() - std::min(tail.size(), kLastLines); i < tail.size(); ++i) {
        write(tail[i] + '\n');
    }
}

void Prompt::step_lines(const ReplayOutcome& outcome) {
    for (const TextLine& line : outcome.first) {
        write(line.text + '\n');
        if (!line.done.empty()) write("    " + line.done + '\n');
        if (surroundings_.wait && !surroundings_.wait()) return;
    }
}

}  // namespace kadr::repl
