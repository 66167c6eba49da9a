// prompt.h — the conversation: a line in, an answer out. No terminal here.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/done.h"
#include "driver/options.h"
#include "driver/shared_inputs.h"
#include "repl/replay.h"
#include "repl/transcript.h"

namespace kadr::repl {

/// What the prompt asks of the surroundings in which it runs.
struct Surroundings {
    /// Writes an answer, or a part of it.
    std::function<void(std::string_view)> write;
    /// Waits for a key before the next block of `:step`; false: the rest is not shown. Empty: no
    /// one is there to press one.
    std::function<bool()> wait;
    std::size_t columns = 80;
    /// Asks a question; true: yes. Empty: nobody is there to answer, which is a no.
    std::function<bool(std::string_view)> ask = {};
};

class Prompt {
  public:
    /// `stop` is set from outside to end a running evaluation. Both references outlive the prompt.
    Prompt(driver::Options options, driver::SharedInputs& inputs, Surroundings surroundings,
           const std::atomic<bool>* stop);

    /// Takes one line. What is not complete waits for more lines.
    void take(std::string_view line);
    /// Forgets the lines of an input that is not complete.
    void cancel() { pending_.clear(); }
    /// Reports an input that the end of the lines left incomplete.
    void finish();

    bool is_waiting() const { return !pending_.empty(); }
    bool is_over() const { return is_over_; }
    /// An input came to an error, in a conversation that nobody watches.
    bool has_failed() const { return has_failed_; }

    /// Files that the conversation wrote itself may be written again without a question.
    bool has_written(const std::string& path) const { return written_.contains(path); }
    void note_written(const std::string& path) { written_.insert(path); }
    /// A file that the user names may lie anywhere, and may read what lies beside it.
    void allow_beside(const std::filesystem::path& file) {
        const std::string folder = file.parent_path().string();
        allowed_.push_back(folder.empty() ? "." : folder);
    }
    Files& files() const { return inputs_.files(); }
    bool asks(std::string_view question) const {
        return surroundings_.ask && surroundings_.ask(question);
    }

    /// What can stand at the end of `line`: whole words, sorted, all beginning with its last one.
    std::vector<std::string> completions(std::string_view line) const;

  private:
    friend struct Commands;

    void take_input(std::string text);
    void show_values(const ReplayOutcome& outcome) const;
    std::string value_of(const std::string& variable);
    void keep(Input input, ReplayOutcome outcome);
    /// The program that the inputs amount to.
    std::string program_of(const Transcript& transcript) const;
    ReplayOutcome evaluate(const Transcript& transcript);
    /// Takes back so many inputs.
    void undo(std::size_t count);
    Done refresh();
    void show_change(const ReplayOutcome& before, const ReplayOutcome& after);
    void show_lines(const ReplayOutcome& outcome);
    void step_lines(const ReplayOutcome& outcome);
    void command(std::string_view text);
    /// Answers `help`, `quit`, `exit` and `drill_peck?`; false: the line is something else.
    bool answers(std::string_view line);
    bool declares(const std::string& name) const;
    /// The options with the folders of files that were loaded.
    driver::Options options_with_files() const;
    void write(std::string_view text) const { surroundings_.write(text); }

    driver::Options options_;
    driver::SharedInputs& inputs_;
    Surroundings surroundings_;
    const std::atomic<bool>* stop_;
    Transcript transcript_;
    ReplayOutcome now_;  // of the whole transcript
    std::string pending_;
    std::set<std::string> written_;
    std::vector<std::string> allowed_;  // folders of files that were loaded
    bool is_stepping_ = false;
    bool is_over_ = false;
    bool has_failed_ = false;
};

}  // namespace kadr::repl
