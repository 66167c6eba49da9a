#include "repl/terminal.h"

#include <algorithm>
#include <atomic>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <histedit.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "repl/prompt.h"

namespace kadr::repl {

namespace {

namespace fs = std::filesystem;

constexpr int kHistoryLines = 2000;
constexpr const char* kFirstPrompt = "kadr> ";
constexpr const char* kNextPrompt = "  ... ";

/// Set by Ctrl-C; a signal handler can reach nothing but a global.
std::atomic<bool> interrupted{false};

void on_interrupt(int) { interrupted = true; }

void write_out(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fflush(stdout);
}

std::size_t terminal_columns() {
    winsize size{};
    if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
    return 80;
}

/// $XDG_STATE_HOME/kadr/history, by default below ~/.local/state; empty: there is no such folder.
std::string history_file() {
    const char* state = std::getenv("XDG_STATE_HOME");
    const char* home = std::getenv("HOME");
    fs::path folder;
    if (state != nullptr && *state != '\0') folder = state;
    else if (home != nullptr && *home != '\0') folder = fs::path(home) / ".local" / "state";
    else return {};
    std::error_code error;
    fs::create_directories(folder / "kadr", error);
    return error ? std::string() : (folder / "kadr" / "history").string();
}

/// libedit with its history, for one conversation.
class Editor {
  public:
    explicit Editor(Prompt& prompt);
    ~Editor();
    Editor(const Editor&) = delete;
    Editor& operator=(const Editor&) = delete;

    /// The next line; null at the end.
    const char* line();
    /// Whether Ctrl-C was pressed instead of ending the line.
    bool was_cancelled() const { return was_cancelled_; }

  private:
    static char* shown_prompt(EditLine* edit);
    static unsigned char complete(EditLine* edit, int);
    unsigned char complete();
    static unsigned char cancel(EditLine* edit, int);
    unsigned char cancel();

    Prompt& prompt_;
    EditLine* edit_;
    History* history_;
    HistEvent event_{};
    bool was_cancelled_ = false;
    std::string file_ = history_file();
};

Editor::Editor(Prompt& prompt)
    : prompt_(prompt), edit_(el_init("kadr", stdin, stdout, stderr)), history_(history_init()) {
    history(history_, &event_, H_SETSIZE, kHistoryLines);
    history(history_, &event_, H_SETUNIQUE, 1);
    if (!file_.empty()) history(history_, &event_, H_LOAD, file_.c_str());
    el_set(edit_, EL_CLIENTDATA, this);
    el_set(edit_, EL_PROMPT, &Editor::shown_prompt);
    el_set(edit_, EL_EDITOR, "emacs");
    el_set(edit_, EL_HIST, history, history_);
    el_set(edit_, EL_ADDFN, "kadr-complete", "complete names and words",
           static_cast<unsigned char (*)(EditLine*, int)>(&Editor::complete));
    el_set(edit_, EL_BIND, "^I", "kadr-complete", nullptr);
    // While a line is edited Ctrl-C is a key; while an input is evaluated it is a signal.
    el_set(edit_, EL_SETTY, "-d", "-isig", nullptr);
    el_set(edit_, EL_ADDFN, "kadr-cancel", "forget the line",
           static_cast<unsigned char (*)(EditLine*, int)>(&Editor::cancel));
    el_set(edit_, EL_BIND, "^C", "kadr-cancel", nullptr);
    el_set(edit_, EL_SIGNAL, 0);
    el_source(edit_, nullptr);  // the user's own ~/.editrc
}

Editor::~Editor() {
    if (!file_.empty()) history(history_, &event_, H_SAVE, file_.c_str());
    history_end(history_);
    el_end(edit_);
}

char* Editor::shown_prompt(EditLine* edit) {
    Editor* self = nullptr;
    el_get(edit, EL_CLIENTDATA, &self);
    // libedit's interface is older than const.
    return const_cast<char*>(self->prompt_.is_waiting() ? kNextPrompt : kFirstPrompt);
}

unsigned char Editor::complete(EditLine* edit, int) {
    Editor* self = nullptr;
    el_get(edit, EL_CLIENTDATA, &self);
    return self->complete();
}

/// Puts in what all candidates have in common; lists them if that is nothing.
unsigned char Editor::complete() {
    const LineInfo* info = el_line(edit_);
    const std::string line(info->buffer, info->cursor);
    const std::vector<std::string> found = prompt_.completions(line);
    if (found.empty()) return CC_ERROR;
    std::size_t known = 0;
    while (known < line.size() && !found.front().starts_with(line.substr(known))) ++known;
    std::string common = found.front();
    for (const std::string& name : found) {
        const auto end = std::mismatch(common.begin(), common.end(), name.begin(), name.end());
        common.erase(end.first, common.end());
    }
    const std::string rest = common.substr(std::min(line.size() - known, common.size()));
    if (!rest.empty()) return el_insertstr(edit_, rest.c_str()) == 0 ? CC_REFRESH : CC_ERROR;
    std::string list = "\n";
    for (const std::string& name : found) list += name + "  ";
    write_out(list + '\n');
    return CC_REDISPLAY;
}

unsigned char Editor::cancel(EditLine* edit, int) {
    Editor* self = nullptr;
    el_get(edit, EL_CLIENTDATA, &self);
    return self->cancel();
}

unsigned char Editor::cancel() {
    const LineInfo* info = el_line(edit_);
    el_cursor(edit_, static_cast<int>(info->lastchar - info->cursor));
    el_deletestr(edit_, static_cast<int>(info->lastchar - info->buffer));
    was_cancelled_ = true;
    return CC_NEWLINE;
}

const char* Editor::line() {
    was_cancelled_ = false;
    int count = 0;
    // Before the prompt shows: a Ctrl-D that came between the two would be lost.
    el_set(edit_, EL_PREP_TERM, 1);
    const char* text = el_gets(edit_, &count);
    if (was_cancelled_) return "";
    if (text == nullptr || count <= 0) return nullptr;
    if (count > 1) history(history_, &event_, H_ENTER, text);
    return text;
}

bool wait_for_enter() {
    write_out("    ↵ next, q end ");
    std::string line;
    for (int c = std::getchar(); c != '\n'; c = std::getchar()) {
        if (c == EOF) {
            std::clearerr(stdin);
            break;
        }
        line += static_cast<char>(c);
    }
    interrupted = false;
    return line.find('q') == std::string::npos;
}

bool ask(std::string_view question) {
    write_out(std::string(question) + " y, or n: ");
    std::string line;
    for (int c = std::getchar(); c != '\n'; c = std::getchar()) {
        if (c == EOF) {
            std::clearerr(stdin);
            break;
        }
        line += static_cast<char>(c);
    }
    interrupted = false;
    return line == "y" || line == "Y" || line == "yes";
}

void converse_at_terminal(Prompt& prompt) {
    struct sigaction action {};
    action.sa_handler = on_interrupt;
    sigaction(SIGINT, &action, nullptr);
    Editor editor(prompt);
    write_out("Kadr. `:help` says what can be typed; Ctrl-D leaves.\n");
    while (!prompt.is_over()) {
        const char* line = editor.line();
        if (line == nullptr) break;
        if (editor.was_cancelled()) {
            prompt.cancel();
            continue;
        }
        interrupted = false;
        prompt.take(std::string_view(line).substr(0, std::string_view(line).find('\n')));
    }
    write_out("\n");
}

void converse_in_pipe(Prompt& prompt) {
    std::string line;
    for (int c = std::getchar(); !prompt.is_over(); c = std::getchar()) {
        if (c != '\n' && c != EOF) {
            line += static_cast<char>(c);
            continue;
        }
        if (c == EOF && line.empty()) break;
        prompt.take(line);
        line.clear();
        if (c == EOF) break;
    }
    prompt.finish();
}

}  // namespace

driver::Status converse(const driver::Options& options, driver::SharedInputs& inputs) {
    const bool is_terminal = ::isatty(STDIN_FILENO) != 0 && ::isatty(STDOUT_FILENO) != 0;
    if (is_terminal)
        std::setlocale(LC_CTYPE, "");  // libedit counts columns by it; nothing else does
    Surroundings surroundings{write_out, {}, 80};
    if (is_terminal) {
        surroundings.ask = ask;
        surroundings.wait = wait_for_enter;
        surroundings.columns = terminal_columns();
    }
    Prompt prompt(options, inputs, surroundings, &interrupted);
    if (is_terminal) {
        converse_at_terminal(prompt);
        return driver::Status::Done;
    }
    converse_in_pipe(prompt);
    return prompt.has_failed() ? driver::Status::Failed : driver::Status::Done;
}

}  // namespace kadr::repl
