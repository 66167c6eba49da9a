// Blocks in which the cutter stays where it is beside a contour.
#include <algorithm>
#include <string>
#include <utility>

#include "base/diagnostics/dialect.h"
#include "base/diagnostics/iso.h"
#include "write/block_writer.h"

namespace kadr::write {

/// Lines in a row in which the cutter stays where it is beside a contour: behind so many of them
/// the control stops with an alarm, or cuts into inner corners, once the contour has begun.
/// Optional blocks may be left out, so each level is counted with them and without.
///
/// before       lines of the text before the block's
/// source       S 5.2 MD20250; F 4.3 No.19625
void BlockWriter::count_idle(const Block& block, std::uint32_t before) {
    constexpr int kContour = 2;  // moves: the way to the contour, and its first element
    if (!text_.is_compensated()) return void(idle_ = {});
    if (!std::exchange(idle_.is_begun, true)) idle_.level = block.skip;
    const auto axes = text_.plane_axes();
    const SlotMask plane = SlotMask{1} << axes[0] | SlotMask{1} << axes[1];
    const bool moves = (block.given & (plane | kCenterSlots)) != 0;
    if (moves) idle_.moves = std::min(idle_.moves + 1, kContour);
    int most = 0;
    for (int i = 0; i < static_cast<int>(idle_.lines.size()); ++i) {
        const bool is_left_out =
            i > 0 && (i == 1 + block.skip || (block.skip_also >> (i - 1) & 1u) != 0);
        int& lines = idle_.lines[static_cast<std::size_t>(i)];
        if (!is_left_out) lines = moves ? 0 : lines + static_cast<int>(lines_.count() - before);
        // Without the blocks of a level in which the compensation begins nothing is compensated.
        if (idle_.level < 0 || i != 1 + idle_.level) most = std::max(most, lines);
    }
    if (idle_.moves < kContour || most <= rules_.comp_empty_blocks) return;
    if (!messages_.fails_first_time(block, "idle")) return;
    const std::string fix = "end the compensation before them, or move in the plane in between";
    if (!rules_.comp_more_empty_is_alarm) {
        messages_.report(diag::IdleCutsCorners, block)
            .arg(tables_.name)
            .arg(rules_.comp_empty_blocks)
            .fix(fix);
        return;
    }
    const auto alarm = dialect_.alarm(diag::CompEmptyBlocks);
    messages_.report(diag::TooManyIdle, block)
        .arg(tables_.name)
        .arg(alarm && !alarm->number.empty() ? " with alarm " + alarm->number : std::string())
        .arg(rules_.comp_empty_blocks)
        .fix(fix);
}

}  // namespace kadr::write
