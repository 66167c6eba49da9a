// command_modules.h — who serves a command: the axes, nobody, or a module written for the machine.
//
// The machine file chooses it (`<pipeline><serve command="function" by="press"/>`). A module of
// one's own is one file and one registration, linked into the program:
//
//     class Press final : public process::CommandModule { std::vector<path::Command> serve(…) … };
//     const process::ModuleRegistration registered("press", [](const machine::Machine&) …);
//
// What the scanner serves is scanner.h's matter.
#pragma once

#include <array>
#include <cstdint>
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
    /// as long as the module works; several, one after the other; or none. For a motion the last
    /// one leads to the same end. The answers go to the axes, to no module again. Commands come in
    /// the order of the program.
    virtual std::vector<path::Command> serve(const path::Command& command) = 0;
};

using ModuleFactory = std::unique_ptr<CommandModule> (*)(const machine::Machine& machine);

/// Makes a module known. Two of one name, or one named as those that every program has, are our own
/// fault. The registry is filled before `main` begins and only read from then on.
void register_module(std::string_view name, ModuleFactory factory);

/// The names that a machine file may use, in their order.
std::vector<std::string_view> module_names();
bool is_module(std::string_view name);

/// Registers a module where it is defined, as a constant of a file's own namespace.
struct ModuleRegistration {
    ModuleRegistration(std::string_view name, ModuleFactory factory) {
        register_module(name, factory);
    }
};

/// Commands on their way to the planner, those that modules serve replaced.
class ServedCommands final : public Stream<path::Command> {
  public:
    /// Every module of the machine is known. References outlive the stream.
    ServedCommands(Stream<path::Command>& commands, const machine::Machine& machine);

    std::size_t pull(std::span<path::Command> out) override;

    /// Commands of the program that were taken.
    std::uint64_t taken() const { return taken_; }
    /// … how many had been taken when the `count`-th one was put out; of
    /// the last batch.
    std::uint64_t taken_for(std::uint64_t count) const;

  private:
    static constexpr std::size_t kOps = static_cast<std::size_t>(path::Op::External) + 1;

    Stream<path::Command>& commands_;
    std::vector<std::unique_ptr<CommandModule>> modules_;
    std::array<CommandModule*, kOps> serves_{};

    std::vector<path::Command> batch_ = std::vector<path::Command>(kBatch);
    std::size_t batch_size_ = 0;
    std::size_t batch_at_ = 0;
    std::vector<path::Command> answers_;  // to the command taken last
    std::size_t answer_at_ = 0;
    std::uint64_t taken_ = 0;
    std::uint64_t put_ = 0;
    std::uint64_t batch_first_ = 0;       // commands put out before the last batch
    std::uint64_t taken_first_ = 0;       // … and taken for them
    std::vector<std::uint64_t> origins_;  // taken_ at each command of the batch
};

}  // namespace kadr::process
