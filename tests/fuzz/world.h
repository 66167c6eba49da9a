// world.h — what the targets share: controls, keyword languages, the mill and the standard library,
// loaded once; and the roads that foreign text takes through them, cut short.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "expand/expander.h"
#include "machine/machine.h"
#include "nc/dialect.h"
#include "sema/check.h"
#include "syntax/parse.h"

namespace kadr::fuzz {

struct World {
    Sources sources;  // the standard library
    std::map<std::string, nc::Dialect, std::less<>> dialects;
    std::vector<const nc::Dialect*>
        controls;  // the same, to choose by number; scripts/fuzz counts so
    std::map<std::string, syntax::KeywordTable, std::less<>> languages;
    machine::Machine mill;
    machine::Machine lathe;
    std::map<std::string, syntax::Ast, std::less<>> library;  // by module: "cycles.drilling"

    World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    /// The dialect and the keywords that a source asks for; unknown names: ISO, English.
    const nc::Dialect& dialect_for(std::string_view source) const;
    const syntax::KeywordTable& keywords_for(std::string_view source) const;
    /// A lathe for the controls of lathes.
    const machine::Machine& machine_for(const nc::Dialect& dialect) const;
};

/// Loaded by the first call.
const World& world();

/// The standard library and nothing else: no file that the input could name is opened.
class LibraryOnly final : public sema::ModuleLoader {
  public:
    explicit LibraryOnly(DiagnosticSink& sink) : sink_(sink) {}
    Module load(std::string_view import, bool is_file, FileId from,
                const SourceRange& place) override;

  private:
    DiagnosticSink& sink_;
};

/// A source that was parsed and, if it had no errors, checked.
struct Checked {
    Sources sources;
    DiagnosticList messages;
    syntax::Ast ast;
    std::unique_ptr<sema::Code> code;  // null: it has errors, and they are told
};

/// Parses a source as the file "fuzz.kadr".
std::unique_ptr<Checked> parse(std::string_view source);
/// Parses and checks it.
std::unique_ptr<Checked> check(std::string_view source);

/// Limits that end a program after a few milliseconds.
expand::RunLimits small_limits();

/// Reads ISO-7bit text in pieces that cut lines anywhere, interprets, plans and samples a little of
/// it.
void execute(const nc::Dialect& dialect, std::string_view text);

/// Reads all of a text: the first message, as a person sees it; empty if there is none.
std::string complaint_about(const nc::Dialect& dialect, std::string_view text);

/// Shows every message in both forms: whatever the input, there are words for it.
void show(const DiagnosticList& messages, const Sources& sources);

/// A promise of ours was broken by this input: says which and stops, so that the fuzzer keeps it.
[[noreturn]] void broken(std::string_view promise, std::string_view details);

}  // namespace kadr::fuzz
