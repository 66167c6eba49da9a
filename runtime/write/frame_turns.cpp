#include "write/frame_turns.h"

#include <algorithm>
#include <cmath>

#include "base/diagnostics/dialect.h"
#include "base/numbers.h"
#include "base/readable.h"

namespace kadr::write {

void check_turn(const TextView& text, BlockMessages& messages, const Block& block) {
    const auto lever = [&](const TurnMiss& turn, std::size_t axes) {
        const std::array<std::size_t, 3> order = text.plane_axes();
        double square = 0;
        for (std::size_t i = 0; i < axes; ++i) {
            if (!text.is_known(order[i])) continue;
            const double arm = (text.modal.position.meant[order[i]] - turn.center[order[i]]) *
                               text.on_part(order[i]) * text.modal.frame.factors[order[i]];
            square += arm * arm;
        }
        return std::sqrt(square);
    };
    // A text in nanometres asks for no more than machines resolve.
    constexpr double kSeen = 1e-4;  // mm
    const double half = std::max(
        kSeen, text.end_increment() / text.to_text(static_cast<Slot>(text.plane_axes()[0]), 1) / 2);
    const auto report = [&](const TurnMiss& turn, double beside, const DiagnosticRow& row) {
        const SourceRange statement = messages.location(turn.source);
        DiagnosticBuilder message = messages.report(row, block);
        message.arg(text.tables.name).arg(readable(round_to(1000 * beside, 1)));
        if (statement.file.is_valid()) message.note(statement, "the angle is programmed here");
    };
    // Once for each frame.
    const auto is_far = [&](const TurnMiss& turn, double beside) {
        return turn.miss > 0 && beside > half && messages.first_time_of_frame(turn.source);
    };
    if (const double beside = text.modal.frame.turn.miss * lever(text.modal.frame.turn, 2);
        is_far(text.modal.frame.turn, beside)) {
        messages.fail();
        report(text.modal.frame.turn, beside, diag::RotationTooFine);
    }
    if (const double beside = text.modal.frame.tilt.miss * lever(text.modal.frame.tilt, 3);
        is_far(text.modal.frame.tilt, beside))
        report(text.modal.frame.tilt, beside, diag::TiltTooFine);
}

}  // namespace kadr::write
