// kinematics.cpp — what the chain of rotary axes costs, on one core.
//
//   bench_kinematics        prints one line for each machine: solutions, setpoints, velocities a
//   second
//
// A solution is a direction solved for both configurations. A setpoint is what motion needs at a
// tick: direction to rotary axes, tip to linear axes. Nothing is timed that was not computed: the
// sum of all results is printed.
#include "machine/kinematics.h"

#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

#include "base/disk_files.h"
#include "machine/machine.h"

namespace {

using namespace kadr;
using namespace kadr::machine;

constexpr int kDirections = 4096;
constexpr int kRounds = 200;

/// Directions within reach along a spiral, so that no branch is learnt by heart.
std::vector<Vec3> directions() {
    std::vector<Vec3> found;
    for (int i = 0; i < kDirections; ++i) {
        const double lean = 0.02 + 0.9 * i / kDirections;
        const double around = 0.37 * i;
        found.emplace_back(std::sin(lean) * std::cos(around), std::sin(lean) * std::sin(around),
                           std::cos(lean));
    }
    return found;
}

/// Millions a second of a loop over all directions.
template <typename Work>
double rate(const std::vector<Vec3>& list, Work work) {
    const std::clock_t begin = std::clock();  // of the process, not of the wall
    for (int round = 0; round < kRounds; ++round) {
        for (const Vec3& direction : list) work(direction);
    }
    const double elapsed = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    return static_cast<double>(list.size()) * kRounds / elapsed * 1e-6;
}

void measure(const Machine& machine) {
    const Chain& chain = machine.kinematics->chain;
    if (!chain.orients()) return;
    const std::vector<Vec3> list = directions();
    const Vec3 tip = tip_of_length(chain, 120);
    double sum = 0;
    const double solutions = rate(list, [&](const Vec3& direction) {
        const auto found = solve(chain, direction);
        if (found) sum += (*found)[0].rotary[kR2] + static_cast<double>(found->count);
    });
    const double setpoints = rate(list, [&](const Vec3& direction) {
        const auto found = solve(chain, direction);
        if (!found) return;
        ChainPosition position;
        position.rotary = (*found)[0].rotary;
        position.linear = inverse_linear(chain, 100 * direction, position, tip);
        sum += position.linear.x();
    });
    ChainPosition position;
    position.rotary = {0.3, 0.4, 0};
    const double velocities = rate(list, [&](const Vec3& direction) {
        position.rotary[kR1] += 1e-6;
        const auto found = axis_velocities(chain, position, tip, {direction, direction});
        if (found) sum += found->rotary[kR1];
    });
    std::printf("%-12s %7.2f M solutions/s %7.2f M setpoints/s %7.2f M velocities/s   (sum %.6g)\n",
                machine.name.c_str(), solutions, setpoints, velocities, sum);
}

}  // namespace

int main() {
    const std::string folder = std::string(KADR_ROOT) + "/runtime/machines";
    for (const MachineSummary& summary : list({folder}, disk())) {
        Sources sources;
        DiagnosticList diagnostics;
        const auto machine = load_machine(summary.name, {folder}, sources, diagnostics);
        if (machine && machine->kinematics) measure(*machine);
    }
    return 0;
}
