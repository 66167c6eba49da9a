// The commands of the prompt, `:help` and so on: one table, one function each.
#include "repl/commands.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iterator>

#include <fmt/format.h>

#include "base/text.h"
#include "driver/modules.h"
#include "driver/output.h"
#include "driver/program.h"
#include "driver/session.h"
#include "driver/summary.h"
#include "plot/plot_svg.h"
#include "repl/contracts.h"
#include "repl/prompt.h"
#include "repl/sketch.h"
#include "syntax/format.h"

namespace kadr::repl {

namespace {

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
}

/// What `:save` reports of a file that is there already and is not replaced; empty: it may be
/// written.
std::string kept(const Prompt& prompt, const std::string& path) {
    const bool is_new =
        prompt.files().kind_of(path) == FileKind::Missing || prompt.has_written(path);
    if (is_new || prompt.asks("replace " + path + "?")) return {};
    return "not written: `" + path + "` is there already";
}

/// Writes a file whole or not at all; the messages report why not.
std::string write_whole(Files& files, const std::string& path, std::string_view text) {
    std::string words;
    Sources sources(files);
    driver::Messages messages(sources, {}, [&](std::string_view line) { words += line; });
    const auto output = driver::Output::open(files, path, messages);
    if (output == nullptr) return words;
    output->write(text);
    (void)output->commit(messages);  // `words` is empty if it is written
    return words;
}

std::string stock_machine(const driver::Options& options, driver::SharedInputs& inputs) {
    Sources sources = inputs.new_sources();
    driver::Messages messages(sources, {}, [](std::string_view) {});
    return driver::Session(options, inputs, sources, messages).stock_machine();
}

/// The program in its canonical layout; as it is if that cannot be had.
std::string laid_out(const driver::Options& options, driver::SharedInputs& inputs,
                     std::string program) {
    Sources sources = inputs.new_sources();
    driver::Messages messages(sources, {}, [](std::string_view) {});
    driver::Session session(options, inputs, sources, messages);
    session.access().allow_home_of("-");
    const FileId file = sources.add("prompt.kadr", program);
    const driver::SourceWords words = driver::words_of(session, file);
    if (!words) return program;
    return syntax::format(sources, file, *words.keywords, *words.dialect, messages)
        .value_or(std::move(program));
}

/// The import of a file whose name is relative, as a program in another folder writes it. Other
/// texts stay as they are, and so does a name that is not found from here.
std::string moved_import(const std::string& text, const std::filesystem::path& folder,
                         const Files& files) {
    namespace fs = std::filesystem;
    const std::size_t open = text.find('"');
    const std::size_t close = text.find('"', open + 1);
    if (open == std::string::npos || close == std::string::npos) return text;
    const fs::path name = text.substr(open + 1, close - open - 1);
    if (name.is_absolute() || !files.is_file(name.string())) return text;
    const fs::path real = files.real_path(name.string());
    const fs::path seen = real.lexically_relative(files.real_path(folder.string()));
    if (seen.empty()) return text;
    return text.substr(0, open + 1) + seen.generic_string() + text.substr(close);
}

/// What the prompt has been given, for a file that lies in this folder.
Transcript moved(const Transcript& transcript, const std::filesystem::path& folder,
                 const Files& files) {
    Transcript out;
    for (Input input : transcript.inputs()) {
        if (input.kind == Input::Kind::Import) input.text = moved_import(input.text, folder, files);
        out.add(std::move(input));
    }
    return out;
}

/// What is wrong with the program as a file of this name; empty if it can be run.
std::string faults_of(const driver::Options& options, driver::SharedInputs& inputs,
                      const std::string& file, const std::string& program) {
    std::string words;
    Sources sources = inputs.new_sources();
    driver::Messages messages(sources, {}, [&](std::string_view text) { words += text; });
    driver::Session session(options, inputs, sources, messages);
    const bool can_run = driver::load_program(session, sources.add(file, program)).has_value();
    messages.finish();
    return can_run ? std::string() : words;
}

/// Names of the variables that statements declare at their outermost level.
std::vector<std::string> variables(const driver::Options& options, driver::SharedInputs& inputs,
                                   const std::string& program) {
    Sources sources = inputs.new_sources();
    driver::Messages messages(sources, {}, [](std::string_view) {});
    driver::Session session(options, inputs, sources, messages);
    session.access().allow_home_of("-");
    const FileId file = sources.add("prompt.kadr", program);
    const driver::SourceWords words = driver::words_of(session, file);
    std::vector<std::string> names;
    if (!words) return names;
    const syntax::Ast ast = syntax::parse(sources, file, *words.keywords, *words.dialect, messages);
    for (const syntax::DeclId id : ast.top) {
        const syntax::Decl& decl = ast[id];
        if (decl.kind == syntax::DeclKind::Variable) names.emplace_back(ast.text(decl.name));
        if (decl.kind != syntax::DeclKind::Program || ast.text(decl.name) != "prompt") continue;
        for (const syntax::StmtId statement : ast.stmts(ast[decl.body].statements)) {
            const syntax::Stmt& stmt = ast[statement];
            if (stmt.kind != syntax::StmtKind::Declaration) continue;
            const std::string name(ast.text(ast[stmt.declaration].name));
            if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
        }
    }
    return names;
}

std::string program_word_of(const driver::Options& options, driver::SharedInputs& inputs,
                            const Transcript& transcript) {
    Sources sources = inputs.new_sources();
    driver::Messages messages(sources, {}, [](std::string_view) {});
    driver::Session session(options, inputs, sources, messages);
    return program_word(session, transcript.headers());
}

std::string numbered(const std::string& text) {
    std::string out;
    std::size_t number = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        out +=
            fmt::format("{:4}  {}\n", ++number, std::string_view(text).substr(begin, end - begin));
        begin = end + 1;
    }
    return out;
}

}  // namespace

/// Each takes what stands behind the command's name.
struct Commands {
    Prompt& prompt;

    void help(std::string_view name) {
        if (name.starts_with(':')) name.remove_prefix(1);
        if (!name.empty()) return meaning(std::string(name));
        std::string out =
            "Type statements, blocks, calls and expressions of the Kadr language; a forgotten `;` "
            "is put behind.\n";
        for (const CommandRow& row : command_table()) {
            out += fmt::format("  {:<22} {}\n",
                               ':' + std::string(row.name) + ' ' + std::string(row.argument),
                               row.meaning);
        }
        prompt.write(out +
                     "`drill_peck?` shows what a cycle or a function takes. "
                     "Ctrl-C stops what runs, Ctrl-D leaves.\n");
    }

    /// What a name stands for, or what a command of the prompt does.
    void meaning(const std::string& name) {
        const std::string word =
            program_word_of(prompt.options_, prompt.inputs_, prompt.transcript_);
        std::string text =
            meaning_of(prompt.options_with_files(), prompt.inputs_, prompt.transcript_, word, name);
        for (const CommandRow& row : command_table()) {
            if (row.name == name) text += ':' + name + ": " + std::string(row.meaning) + '\n';
        }
        if (!text.empty()) return prompt.write(text);
        text = "nothing is known of `" + name + '`';
        const std::vector<std::string> names = prompt.completions("");
        const std::vector<std::string_view> views(names.begin(), names.end());
        if (const auto near = nearest_name(name, views.data(), views.size()))
            text += "; did you mean `" + std::string(*near) + "`?";
        wrong(text);
    }

    void dialect(std::string_view name) {
        if (name.empty()) {
            const std::string& chosen = prompt.options_.dialect;
            return prompt.write((chosen.empty() ? "iso" : chosen) + '\n');
        }
        change(prompt.options_.dialect, name);
    }

    void machine(std::string_view name) {
        if (name.empty()) {
            const std::string& chosen = prompt.options_.machine;
            return prompt.write(
                (chosen.empty() ? stock_machine(prompt.options_, prompt.inputs_) : chosen) + '\n');
        }
        change(prompt.options_.machine, name);
    }

    void load(std::string_view file) {
        if (file.empty()) return wrong("which file? `:load part.kadr`");
        prompt.allow_beside(std::filesystem::path(file));
        const std::string import = "import \"" + std::string(file) + "\";";
        prompt.take_input(import);
    }

    void reload(std::string_view) {
        if (prompt.refresh()) prompt.write(fmt::format("{} lines\n", prompt.now_.lines));
    }

    void state(std::string_view) {
        std::string out = "position";
        for (std::size_t axis = 0; axis < 3; ++axis) {
            out += fmt::format(" {}{:.3f}", kAxisNames[axis], prompt.now_.position[axis]);
        }
        out += '\n';
        for (const interp::StateItem& item : prompt.now_.state) {
            out += fmt::format("{:<12} {}\n", item.name, item.value);
        }
        prompt.write(out);
    }

    void vars(std::string_view) {
        const std::vector<std::string> names =
            variables(prompt.options_, prompt.inputs_, prompt.program_of(prompt.transcript_));
        if (names.empty()) return prompt.write("no variables\n");
        for (const std::string& name : names)
            prompt.write(name + " = " + prompt.value_of(name) + '\n');
    }

    void list(std::string_view what) {
        if (what.empty()) return prompt.write(numbered(prompt.program_of(prompt.transcript_)));
        if (what != "iso") return wrong("`:list` shows the program, `:list iso` the text");
        const std::uint32_t lines = std::exchange(prompt.now_.lines, 0);
        const ReplayOutcome all = prompt.evaluate(prompt.transcript_);
        prompt.show_lines(all);
        prompt.now_.lines = lines;
    }

    void plot(std::string_view file) {
        if (!file.empty()) {
            plot::PlotText text;
            text.title = "prompt";
            text.subtitle = prompt.now_.plot_subtitle;
            const std::string path(file);
            if (const std::string left = kept(prompt, path); !left.empty()) return wrong(left);
            const std::string words = write_whole(
                prompt.files(), path, plot_svg(prompt.now_.scene, text, plot::PlotColor::Feed));
            if (!words.empty()) return prompt.write(words);
            prompt.note_written(path);
        }
        prompt.write(sketch(prompt.now_.scene, prompt.surroundings_.columns));
    }

    void step(std::string_view what) {
        if (!what.empty() && what != "on" && what != "off") {
            return wrong("`:step on`, `:step off`, or `:step` to change it");
        }
        prompt.is_stepping_ = what.empty() ? !prompt.is_stepping_ : what == "on";
        prompt.write(prompt.is_stepping_ ? "block by block\n" : "all blocks at once\n");
    }

    void undo(std::string_view text) {
        std::size_t count = 1;
        const auto read = std::from_chars(text.data(), text.data() + text.size(), count);
        const bool is_number = read.ec == std::errc() && read.ptr == text.data() + text.size();
        if (!text.empty() && (!is_number || count == 0))
            return wrong("how many inputs? `:undo 2` takes the last two back");
        prompt.undo(count);
    }

    void save(std::string_view file) {
        if (file.empty()) return wrong("where to? `:save part.kadr`");
        const std::string path(file);
        const std::filesystem::path folder =
            std::filesystem::path(prompt.files().real_path(path)).parent_path();
        const std::string program =
            laid_out(prompt.options_, prompt.inputs_,
                     prompt.program_of(moved(prompt.transcript_, folder, prompt.files())));
        const std::string faults = faults_of(prompt.options_, prompt.inputs_, path, program);
        if (faults.find("[K2017]") != std::string::npos) {
            wrong(
                "not saved: only at the prompt one program calls another; in a file what it calls "
                "is a cycle");
            return prompt.write(faults);
        }
        if (!faults.empty()) {
            wrong("not saved: as a file this program cannot be run");
            return prompt.write(faults);
        }
        if (const std::string left = kept(prompt, path); !left.empty()) return wrong(left);
        const std::string words = write_whole(prompt.files(), path, program);
        if (words.empty()) prompt.note_written(path);
        prompt.write(words.empty() ? "saved in " + path + '\n' : words);
    }

    void time(std::string_view) {
        const motion::Totals& totals = prompt.now_.totals;
        prompt.write(fmt::format("{}: cutting {}, rapid {}; {:.1f} mm\n",
                                 driver::duration_text(totals.time),
                                 driver::duration_text(totals.cutting_time),
                                 driver::duration_text(totals.rapid_time), totals.length));
    }

    void quit(std::string_view) { prompt.is_over_ = true; }

    /// Sets an option; back to what it was if nothing works with it.
    void change(std::string& option, std::string_view value) {
        const std::string before = std::exchange(option, std::string(value));
        if (prompt.refresh()) return;
        option = before;
        (void)prompt.refresh();  // as it was before
    }

    void wrong(std::string_view text) {
        prompt.has_failed_ = true;
        prompt.write(std::string(text) + '\n');
    }
};

namespace {

struct CommandEntry {
    CommandRow row;
    void (Commands::*run)(std::string_view);
};

constexpr CommandEntry kRows[] = {
    {{"help", "[NAME]", "what can be typed, or what a name takes"}, &Commands::help},
    {{"dialect", "[NAME]", "the control that the text is for"}, &Commands::dialect},
    {{"machine", "[NAME]", "the machine that executes it"}, &Commands::machine},
    {{"load", "FILE", "use what a Kadr file declares, programs too"}, &Commands::load},
    {{"reload", "", "evaluate all again, files read anew"}, &Commands::reload},
    {{"state", "", "position and modal state"}, &Commands::state},
    {{"vars", "", "variables and their values"}, &Commands::vars},
    {{"list", "[iso]", "the program so far, or its text"}, &Commands::list},
    {{"plot", "[FILE.svg]", "sketch of the path; drawing into a file"}, &Commands::plot},
    {{"step", "[on|off]", "show block by block what is executed"}, &Commands::step},
    {{"undo", "[N]", "take the last input back, or the last N"}, &Commands::undo},
    {{"save", "FILE", "the program so far as a file"}, &Commands::save},
    {{"time", "", "machine time so far"}, &Commands::time},
    {{"quit", "", "leave"}, &Commands::quit},
};

}  // namespace

std::vector<CommandRow> command_table() {
    std::vector<CommandRow> rows;
    for (const CommandEntry& row : kRows) rows.push_back(row.row);
    return rows;
}

void Prompt::command(std::string_view text) {
    const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
    const std::string_view name = trimmed(text.substr(0, end));
    const std::string_view argument = trimmed(text.substr(end));
    if (name == "exit") return Commands{*this}.quit(argument);  // what other prompts call it
    // A beginning that is no other command's will do: `:h`.
    const CommandEntry* found = nullptr;
    int matches = 0;
    for (const CommandEntry& row : kRows) {
        if (row.row.name == name) {
            found = &row;
            matches = 1;
            break;
        }
        if (!name.empty() && row.row.name.starts_with(name)) {
            found = &row;
            ++matches;
        }
    }
    Commands commands{*this};
    if (matches == 1) return (commands.*found->run)(argument);
    commands.wrong(fmt::format("there is no command `:{}`; `:help` lists them", name));
}

bool Prompt::declares(const std::string& name) const {
    const std::vector<std::string> names = variables(options_, inputs_, program_of(transcript_));
    return std::ranges::find(names, name) != names.end() ||
           std::ranges::find(now_.names, name) != now_.names.end();
}

bool Prompt::answers(std::string_view line) {
    Commands commands{*this};
    if (const std::string name = asked_name(line); !name.empty()) {
        commands.help(name);
        return true;
    }
    std::string_view word = trimmed(line);
    if (word.ends_with(';')) word = trimmed(word.substr(0, word.size() - 1));
    if (word.ends_with("()")) word.remove_suffix(2);
    const bool leaves = word == "quit" || word == "exit";
    if (word != "help" && word != "?" && !leaves) return false;
    if (declares(std::string(word))) return false;  // it means that here
    if (leaves) commands.quit({});
    else commands.help({});
    return true;
}

}  // namespace kadr::repl
