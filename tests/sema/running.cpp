#include "tests/sema/running.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <deque>

#include "base/diagnostics/driver.h"
#include "base/disk_files.h"
#include "base/text.h"
#include "syntax/parse.h"

namespace kadr::testing {

namespace {

const std::string kRoot = KADR_ROOT;

/// Modules from the test's own texts, then from the library.
class TestModules final : public sema::ModuleLoader {
  public:
    TestModules(const RunOptions& options, Sources& sources, DiagnosticSink& sink)
        : options_(options), sources_(sources), sink_(sink) {}

    Module load(std::string_view import, bool, FileId, const SourceRange& location) override {
        const std::string name(import);
        if (const auto known = loaded_.find(name); known != loaded_.end())
            return {known->second, &dialect("iso")};
        std::string file = name + ".kadr";
        std::string text;
        if (const auto own = options_.modules.find(name); own != options_.modules.end()) {
            text = own->second;
        } else if (options_.with_stdlib) {
            std::string path = name;
            for (char& c : path) c = c == '.' ? '/' : c;
            file = kRoot + "/stdlib/" + path + ".kadr";
            const auto read = read_file(file);
            if (!read) return missing(name, location);
            text = *read;
        } else {
            return missing(name, location);
        }
        const FileId id = sources_.add(file, text);
        asts_.push_back(syntax::parse(sources_, id, keywords(), dialect("iso"), sink_));
        loaded_[name] = &asts_.back();
        return {&asts_.back(), &dialect("iso")};
    }

  private:
    Module missing(const std::string& name, const SourceRange& location) {
        if (name != "prelude") sink_.report(diag::FileUnreadable, location).arg(name);
        return {};
    }

    const RunOptions options_;
    Sources& sources_;
    DiagnosticSink& sink_;
    std::deque<syntax::Ast> asts_;
    std::map<std::string, const syntax::Ast*> loaded_;
};

std::string place(const Sources& sources, const SourceRange& range) {
    if (!range.file.is_valid()) return "-";
    const LineColumn at = sources.locate(range.file, range.begin);
    return std::to_string(at.line) + ':' + std::to_string(at.column);
}

void collect(const Sources& sources, const DiagnosticList& messages, Outcome& outcome) {
    for (const Diagnostic& message : messages.all()) {
        std::string where = place(sources, message.range);
        if (message.line) {
            where = std::to_string(message.line->line) + ':' + std::to_string(message.line->column);
        }
        outcome.messages.push_back(where + ' ' + std::string(message.row->code));
        outcome.texts.push_back(message.message());
        for (const Diagnostic::Note& note : message.notes) {
            outcome.notes.push_back(place(sources, note.range) + ' ' + note.text);
        }
    }
}

std::string joined(const std::vector<std::string>& lines) {
    std::string all;
    for (const std::string& line : lines) {
        if (!all.empty()) all += '\n';
        all += line;
    }
    return all;
}

struct Parts {
    syntax::Ast ast;
    std::unique_ptr<TestModules> modules;
};

}  // namespace

const syntax::KeywordTable& keywords() {
    static const syntax::KeywordTable table = [] {
        Sources sources;
        DiagnosticList messages;
        auto loaded =
            syntax::load_keywords("en", {kRoot + "/dialects/languages"}, sources, messages);
        if (!loaded) std::abort();
        return std::move(*loaded);
    }();
    return table;
}

std::string Outcome::all_blocks() const { return joined(blocks); }

std::string Outcome::all_messages() const {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < messages.size(); ++i) lines.push_back(messages[i] + ' ' + texts[i]);
    return joined(lines);
}

const nc::Dialect& dialect(const std::string& name) {
    static std::map<std::string, nc::Dialect> loaded;
    const auto known = loaded.find(name);
    if (known != loaded.end()) return known->second;
    Sources sources;
    DiagnosticList messages;
    auto read = nc::load_dialect(name, {kRoot + "/dialects"}, sources, messages);
    if (!read) {
        for (const Diagnostic& message : messages.all())
            std::fprintf(stderr, "%s\n", message.message().c_str());
        std::abort();
    }
    return loaded.emplace(name, std::move(*read)).first->second;
}

/// Tests put tables and pictures where they like.
static FileAccess& whole_disk() {
    static FileAccess access(disk());
    access.allow("/");
    return access;
}

Checked check_program(const std::string& source, const RunOptions& options) {
    Checked checked;
    checked.sources = std::make_unique<Sources>();
    checked.messages = std::make_unique<DiagnosticList>();
    const FileId file = checked.sources->add(options.file, source);
    auto parts = std::make_shared<Parts>();
    parts->modules = std::make_unique<TestModules>(options, *checked.sources, *checked.messages);
    parts->ast = syntax::parse(*checked.sources, file, keywords(), dialect(options.source),
                               *checked.messages);
    const bool was_read = !checked.messages->has_errors();
    if (was_read || options.with_broken_text) {
        sema::CheckOptions checking;
        checking.access = &whole_disk();
        checking.keeps_names = options.keeps_names;
        sema::CheckResult result = sema::check(parts->ast, dialect(options.source), *parts->modules,
                                               *checked.sources, *checked.messages, checking);
        checked.code = std::move(result.code);
        checked.facts = std::move(result.checked);
    }
    checked.modules = parts;
    return checked;
}

Outcome check(const std::string& source, const RunOptions& options) {
    const Checked checked = check_program(source, options);
    Outcome outcome;
    collect(*checked.sources, *checked.messages, outcome);
    if (checked.code) outcome.code = sema::print(*checked.code);
    return outcome;
}

Outcome run(const std::string& source, const RunOptions& options) {
    const Checked checked = check_program(source, options);
    Outcome outcome;
    if (checked.code) {
        outcome.code = sema::print(*checked.code);
        expand::ExpandOptions expanding = options.expand;
        expanding.access = &whole_disk();
        expand::Expander expander(*checked.code, dialect(options.target), expanding,
                                  *checked.messages);
        if (expander.start(options.program, options.defines)) {
            // A small batch, so that instructions which make several blocks cross its end.
            std::array<nc::Block, 3> batch;
            while (const std::size_t count = expander.pull(batch)) {
                for (std::size_t i = 0; i < count; ++i) {
                    if (batch[i].kind == nc::Block::Kind::Position) continue;  // no text
                    outcome.blocks.push_back(nc::describe(batch[i]));
                    if (options.expand.trace) outcome.traces.push_back(expander.trace(i));
                }
            }
        }
    }
    collect(*checked.sources, *checked.messages, outcome);
    return outcome;
}

Outcome run_body(const std::string& statements, const RunOptions& options) {
    return run("program p() {\n" + statements + "\n}\n", options);
}

}  // namespace kadr::testing
