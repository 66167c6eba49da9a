#include "machine/pulse_clock.h"

#include <algorithm>
#include <cmath>

namespace kadr::machine {

std::optional<PulseClock> pulse_clock(const Laser& laser, double tick) {
    constexpr double kRounding = 1e-9;  // of a tick
    const double nominal = 1 / (laser.pulse * tick);
    PulseClock clock;
    clock.least = static_cast<std::int64_t>(std::ceil((1 - laser.tolerance) * nominal - kRounding));
    clock.most = static_cast<std::int64_t>(std::floor((1 + laser.tolerance) * nominal + kRounding));
    clock.least = std::max<std::int64_t>(clock.least, 1);
    if (clock.least > clock.most) return std::nullopt;
    clock.nominal = std::clamp<std::int64_t>(std::llround(nominal), clock.least, clock.most);
    return clock;
}

PulseWindow pulse_window(const PulseClock& clock, std::int64_t k) {
    const std::int64_t before = (k - 1) * clock.nominal;
    return {before + clock.least, before + clock.most};
}

std::int64_t best_tick(const PulseClock& clock, std::int64_t k) {
    return k == 1 ? clock.nominal : pulse_window(clock, k).first;
}

std::int64_t pulse_at_or_after(const PulseClock& clock, std::int64_t ticks) {
    const std::int64_t beyond = std::max<std::int64_t>(0, ticks - clock.most);
    return 1 + (beyond + clock.nominal - 1) / clock.nominal;
}

}  // namespace kadr::machine
