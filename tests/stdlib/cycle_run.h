// cycle_run.h — runs one call of a cycle and gives the commands that came out.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace stdlib_test {

/// A length as a Kadr program writes it, to a thousandth.
std::string mm(double value);

/// What came of a program.
struct CycleRun {
    int status = 0;
    std::string messages;
    std::vector<nlohmann::json> commands;
};

/// A program that does `call` from (0, 0, 40), on a control.
CycleRun run_cycle(const std::string& module, const std::string& call,
                   const std::string& dialect = "iso");

/// The commands of a call that must succeed.
std::vector<nlohmann::json> commands_of(const std::string& module, const std::string& call);

/// How the motion of a call on another control differs from these commands of `iso`: the places of
/// all moves in order, within a thousandth. Empty if it does not.
std::string motion_difference(const std::vector<nlohmann::json>& commands,
                              const std::string& module, const std::string& call,
                              const std::string& dialect);

}  // namespace stdlib_test
