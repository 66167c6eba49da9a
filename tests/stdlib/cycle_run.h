// cycle_run.h — a call of the library in a program of its own, executed: what comes out as
// commands.
#pragma once

#include <random>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace stdlib_test {

/// Draws parameters, always the same ones for a seed; a tenth of a millimetre is fine enough.
class Dice {
  public:
    explicit Dice(unsigned seed) : engine_(seed) {}
    double length(double low, double high);
    int number(int low, int high) { return std::uniform_int_distribution<>(low, high)(engine_); }
    bool coin() { return number(0, 1) == 1; }

  private:
    std::mt19937 engine_;
};

/// A length as a program says it, in thousandths.
std::string mm(double value);

/// What a program, its whole text, makes of a machine; `error`: the messages, if it fails.
struct CycleRun {
    std::vector<nlohmann::json> commands;
    int status = 0;
    std::string error;
};
CycleRun run_text(const std::string& text, const std::string& dialect, const std::string& machine);

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
