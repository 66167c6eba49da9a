#include "process/command_modules.h"

#include <algorithm>
#include <map>
#include <string>

#include "base/assert.h"

namespace kadr::process {

namespace {

using path::Command;

/// In a function: registrations run before `main`, in an order that nobody knows.
std::map<std::string_view, ModuleFactory>& factories() {
    static std::map<std::string_view, ModuleFactory> all;
    return all;
}

/// Leaves a command out: it is counted, and neither moves nor takes time.
class NoModule final : public CommandModule {
  public:
    std::vector<Command> serve(const Command&) override { return {}; }
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

// One pull takes from the stream behind once at most if it puts anything out: an alarm about a
// command has to find the commands behind it not looked at.
std::size_t ServedCommands::pull(std::span<Command> out) {
    origins_.clear();
    batch_first_ = put_;
    taken_first_ = taken_;
    std::size_t written = 0;
    const auto put = [&](const Command& command) {
        out[written++] = command;
        origins_.push_back(taken_);
    };
    while (written < out.size()) {
        if (answer_at_ < answers_.size()) {
            put(answers_[answer_at_++]);
            continue;
        }
        if (batch_at_ == batch_size_) {
            if (written > 0) break;
            batch_at_ = 0;
            batch_size_ = commands_.pull(std::span(batch_).first(std::min(out.size(), kBatch)));
            if (batch_size_ == 0) break;
        }
        const Command& command = batch_[batch_at_++];
        ++taken_;
        CommandModule* module = serves_[static_cast<std::size_t>(command.op())];
        if (module == nullptr) {
            put(command);
            continue;
        }
        answers_ = module->serve(command);
        answer_at_ = 0;
    }
    put_ += written;
    return written;
}

std::uint64_t ServedCommands::taken_for(std::uint64_t count) const {
    if (count <= batch_first_) return taken_first_;
    if (count > batch_first_ + origins_.size()) return taken_;
    return origins_[static_cast<std::size_t>(count - batch_first_) - 1];
}

}  // namespace kadr::process
