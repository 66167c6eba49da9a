#include "write/idle_lines.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/diagnostics/dialect.h"
#include "base/diagnostics/iso.h"

namespace kadr::write {

void IdleLines::count(const Block& block, std::uint32_t written) {
    constexpr int kContour = 2;  // moves: the path to the contour, and its first element
    if (!text_.is_compensated()) return void(now_ = {});
    if (!std::exchange(now_.is_begun, true)) now_.level = block.skip_level;
    const auto axes = text_.plane_axes();
    const SlotMask plane = SlotMask{1} << axes[0] | SlotMask{1} << axes[1];
    const bool moves = (block.given & (plane | kCenterSlots)) != 0;
    if (moves) now_.moves = std::min(now_.moves + 1, kContour);
    int most = 0;
    for (int i = 0; i < static_cast<int>(now_.lines.size()); ++i) {
        const bool is_left_out = i > 0 && (i == 1 + block.skip_level ||
                                           (block.further_skip_levels >> (i - 1) & 1u) != 0);
        int& lines = now_.lines[static_cast<std::size_t>(i)];
        if (!is_left_out) lines = moves ? 0 : lines + static_cast<int>(written);
        // Without the blocks of a level in which the compensation begins nothing is compensated.
        if (now_.level < 0 || i != 1 + now_.level) most = std::max(most, lines);
    }
    if (now_.moves < kContour || most <= text_.tables.rules.comp_empty_blocks) return;
    if (!messages_.fails_first_time(block, "idle")) return;
    const std::string fix = "end the compensation before them, or move in the plane in between";
    if (!text_.tables.rules.comp_more_empty_is_alarm) {
        messages_.report(diag::IdleCutsCorners, block)
            .arg(text_.tables.name)
            .arg(text_.tables.rules.comp_empty_blocks)
            .fix(fix);
        return;
    }
    const auto alarm = dialect_.alarm(diag::CompEmptyBlocks);
    messages_.report(diag::TooManyIdle, block)
        .arg(text_.tables.name)
        .arg(alarm && !alarm->number.empty() ? " with alarm " + alarm->number : std::string())
        .arg(text_.tables.rules.comp_empty_blocks)
        .fix(fix);
}

}  // namespace kadr::write
