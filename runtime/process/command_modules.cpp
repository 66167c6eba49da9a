#include "process/command_modules.h"

#include <algorithm>
#include <map>
#include <string>

#include "base/assert.h"

namespace kadr::process {

namespace {

using path::Command;

/// In a function: registrations run before `main`, in an order that nobody says.
std::map<std::string_view, ModuleFactory>& factories() {
    static std::map<std::string_view, ModuleFactory> all;
    return all;
}

/// Leaves a command out: it is counted, and neither moves nor takes time.
class NoModule final : public CommandModule {
  public:
    Command serve(const Command& command) override {
        Command nothing;
        nothing.op = path::Op::Message;
        nothing.to = command.to;
        nothing.source = command.source;
        nothing.line = command.line;
        return nothing;
    }
};

bool is_everywhere(std::string_view name) {
    return name == machine::kNoModule || name == machine::kScannerModule;
}

}  // namespace

void register_module(std::string_view name, ModuleFactory factory) {
    KADR_ASSERT(!is_module(name), "two modules have one name");
    KADR_ASSERT(factory != nullptr, "a module lacks its factory");
    factories().emplace(name, factory);
}

std::vector<std::string_view> module_names() {
    std::vector<std::string_view> names = {machine::kNoModule, machine::kScannerModule};
    for (const auto& [name, factory] : factories()) names.push_back(name);
    std::ranges::sort(names);
    return names;
}

bool is_module(std::string_view name) { return is_everywhere(name) || factories().contains(name); }

ServedCommands::ServedCommands(Stream<Command>& commands, const machine::Machine& machine)
    : commands_(commands) {
    // One module serves all its commands: it may remember.
    std::map<std::string_view, CommandModule*> made;
    for (const machine::ModuleRow& row : machine.pipeline.modules) {
        if (row.module == machine::kScannerModule) continue;
        CommandModule*& module = made[row.module];
        if (module == nullptr) {
            KADR_ASSERT(is_module(row.module), "a machine names a module that nobody registered");
            modules_.push_back(row.module == machine::kNoModule
                                   ? std::make_unique<NoModule>()
                                   : factories().at(row.module)(machine));
            module = modules_.back().get();
        }
        serves_[static_cast<std::size_t>(row.command)] = module;
    }
}

std::size_t ServedCommands::pull(std::span<Command> out) {
    const std::size_t count = commands_.pull(out);
    for (Command& command : out.first(count)) {
        CommandModule* module = serves_[static_cast<std::size_t>(command.op)];
        if (module != nullptr) command = module->serve(command);
    }
    return count;
}

}  // namespace kadr::process
