// command_modules.h — who serves a command: the axes, nobody, or a module written for the machine.
//
// The machine file says it (`<pipeline><serve command="function" by="press"/>`). A module of one's
// own is one file and one registration, linked into the program:
//
//     class Press final : public process::CommandModule { path::Command serve(…) override … };
//     const process::ModuleRegistration registered("press", [](const machine::Machine&) …);
//
// What the scanner serves is scanner.h's matter.
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "base/stream.h"
#include "machine/machine.h"
#include "path/command.h"

namespace kadr::process {

class CommandModule {
  public:
    virtual ~CommandModule() = default;
    /// What the machine does instead: one command, such as an External in which the axes stand for
    /// as long as the module works. For a motion it is a motion to the same end. Commands come in
    /// the order of the program.
    virtual path::Command serve(const path::Command& command) = 0;
};

using ModuleFactory = std::unique_ptr<CommandModule> (*)(const machine::Machine& machine);

/// Makes a module known. Two of one name, or one named as those that every program has, are our own
/// fault. The registry is filled before `main` begins and only read from then on.
void register_module(std::string_view name, ModuleFactory factory);

/// The names that a machine file may say, in their order.
std::vector<std::string_view> module_names();
bool is_module(std::string_view name);

/// Registers a module where it is defined, as a constant of a file's own namespace.
struct ModuleRegistration {
    ModuleRegistration(std::string_view name, ModuleFactory factory) {
        register_module(name, factory);
    }
};

/// Commands on their way to the planner, those that modules serve replaced. One comes out for each
/// that goes in: counts of commands mean the same before and behind.
class ServedCommands final : public Stream<path::Command> {
  public:
    /// Every module of the machine is known. References outlive the stream.
    ServedCommands(Stream<path::Command>& commands, const machine::Machine& machine);

    std::size_t pull(std::span<path::Command> out) override;

  private:
    static constexpr std::size_t kOps = static_cast<std::size_t>(path::Op::External) + 1;

    Stream<path::Command>& commands_;
    std::vector<std::unique_ptr<CommandModule>> modules_;
    std::array<CommandModule*, kOps> serves_{};
};

}  // namespace kadr::process
