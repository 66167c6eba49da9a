#include "repl/contracts.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "base/identifier.h"
#include "driver/parameters.h"
#include "driver/program.h"
#include "driver/session.h"
#include "driver/tables.h"
#include "sema/builtins.h"
#include "syntax/contract.h"

namespace kadr::repl {

namespace {

using syntax::DeclKind;

bool can_be_called(DeclKind kind) {
    return kind == DeclKind::Function || kind == DeclKind::Cycle || kind == DeclKind::Program ||
           kind == DeclKind::Curve;
}

/// As it is declared, but on one line.
std::string signature(const syntax::Contract& contract) {
    std::string out = contract.heading + '(';
    for (const syntax::ParameterContract& parameter : contract.parameters) {
        if (&parameter != &contract.parameters.front()) out += ", ";
        out += parameter.type + ' ' + parameter.name;
        if (!parameter.initial.empty()) out += " = " + parameter.initial;
    }
    return out + ')' + (contract.ending.empty() ? "" : ' ' + contract.ending) + '\n';
}

std::string shown(const syntax::Ast& ast, syntax::DeclId id, std::string_view text) {
    const syntax::Contract contract = syntax::contract_of(ast, id, text);
    std::string out = signature(contract);
    if (!contract.about.empty()) out += contract.about + '\n';
    if (contract.parameters.empty()) return out;
    std::vector<driver::ParameterRow> rows;
    for (const syntax::ParameterContract& parameter : contract.parameters)
        rows.push_back(driver::parameter_row(ast, parameter));
    out += driver::parameter_table(rows);
    for (const std::string& condition : contract.conditions) out += "  and " + condition + '\n';
    return out;
}

/// The contract in a program and what it imports; nothing: the name is not declared there.
std::optional<std::string> declared(const driver::Options& options, driver::SharedInputs& inputs,
                                    const std::string& program, const std::string& name) {
    Sources sources = inputs.new_sources();
    driver::Messages messages(sources, {}, [](std::string_view) {});
    driver::Options chosen = options;
    chosen.check = {.calls_programs = "prompt"};
    driver::Session session(chosen, inputs, sources, messages);
    session.access().allow_home_of("-");
    const FileId file = sources.add("prompt.kadr", program);
    const auto loaded = driver::load_program(session, file);
    if (!loaded) return std::nullopt;
    std::optional<std::string> found;
    for (const syntax::Ast* ast : loaded->modules->trees()) {
        for (const syntax::DeclId id : ast->top) {
            const syntax::Decl& decl = (*ast)[id];
            if (!can_be_called(decl.kind) || ast->text(decl.name) != name) continue;
            if (found && ast->file != file) continue;  // what was typed here comes first
            found = shown(*ast, id, sources.text(ast->file));
        }
    }
    return found;
}

std::optional<std::string> library_module(const driver::Options& options,
                                          driver::SharedInputs& inputs, const std::string& name) {
    Sources sources = inputs.new_sources();
    driver::Messages messages(sources, {}, [](std::string_view) {});
    driver::Session session(options, inputs, sources, messages);
    return driver::Modules(session).library_module_of(name);
}

/// What the control's table says of a command of the vocabulary or of a word.
std::string on_the_control(const driver::Options& options, driver::SharedInputs& inputs,
                           const std::string& name) {
    Sources sources = inputs.new_sources();
    driver::Messages messages(sources, {}, [](std::string_view) {});
    driver::Session session(options, inputs, sources, messages);
    const std::string control = options.dialect.empty() ? "iso" : options.dialect;
    return driver::explain_word(session, control, name).text;
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlanks = " \t\r\n";
    const std::size_t begin = text.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

}  // namespace

std::string asked_name(std::string_view line) {
    constexpr std::string_view kHelp = "help ";
    std::string_view name = trimmed(line);
    bool asks = false;
    if (name.ends_with(';')) name = trimmed(name.substr(0, name.size() - 1));
    if (name.starts_with(kHelp)) {
        name = trimmed(name.substr(kHelp.size()));
        asks = true;
    }
    if (name.starts_with('?') || name.ends_with('?')) {
        name = trimmed(name.starts_with('?') ? name.substr(1) : name.substr(0, name.size() - 1));
        asks = true;
    }
    if (name.ends_with("()")) name.remove_suffix(2);
    const bool is_name = !name.empty() && (name[0] < '0' || name[0] > '9') &&
                         std::ranges::all_of(name, [](char c) { return is_name_part(c); });
    return asks && is_name ? std::string(name) : std::string();
}

std::string meaning_of(const driver::Options& options, driver::SharedInputs& inputs,
                       const Transcript& transcript, std::string_view word_for_program,
                       const std::string& name) {
    if (auto text = declared(options, inputs, transcript.program(word_for_program), name))
        return *std::move(text);
    if (const auto module = library_module(options, inputs, name)) {
        const std::string import = "import " + *module + ';';
        Transcript longer = transcript;
        longer.add({Input::Kind::Import, import});
        if (auto text = declared(options, inputs, longer.program(word_for_program), name))
            return *text + "type `" + import + "` first\n";
    }
    if (const std::string text = on_the_control(options, inputs, name); !text.empty()) return text;
    if (std::ranges::find(sema::builtin_names(), name) != sema::builtin_names().end())
        return '`' + name + "` is a function of the language; docs/language.md, chapter 5\n";
    return {};
}

}  // namespace kadr::repl
