// What the rounding of a word costs: feeds and speeds that become others, and angles of frames,
// whose rounding grows with the distance of the tool from their centre.
#include <algorithm>
#include <cmath>

#include "base/diagnostics/dialect.h"
#include "base/numbers.h"
#include "base/readable.h"
#include "base/units.h"
#include "write/block_writer.h"

namespace kadr::write {

/// A feed or a speed that the decimals of its word make another one.
void BlockWriter::check_rounding(const Block& block, double number, int places, Dimension dimension,
                                 std::string_view name) {
    if (dimension != Dimension::Feed && dimension != Dimension::Speed) return;
    const double written = round_to(number, places);
    if (written == number || written == 0 || !std::isfinite(number)) return;  // 0 has its message
    constexpr double kWarning = 0.01;
    constexpr double kError = 0.1;
    const double share = std::fabs(written / number - 1);
    if (share <= kWarning) return;
    const bool is_error = share > kError;
    const std::string key = std::string(name) + " rounded";
    if (is_error ? !messages_.fails_first_time(block, key) : !messages_.first_time(block, key))
        return;
    messages_.report_word(is_error ? diag::RoundedFar : diag::RoundedAside, block, name)
        .arg(name)
        .arg(quantity_words(written, dimension, modal_.units))
        .arg(quantity_words(number, dimension, modal_.units))
        .arg(readable(round_to(100 * share, 1)));
}

/// Where the rounded angle of a frame takes the tool beside its place by more than the text's own
/// rounding does. A rotation turns its plane, a tilted plane all of space.
void BlockWriter::check_turn(const Block& block) {
    const auto lever = [&](const TurnMiss& turn, std::size_t axes) {
        const std::array<std::size_t, 3> order = text_.plane_axes();
        double square = 0;
        for (std::size_t i = 0; i < axes; ++i) {
            if (!text_.is_known(order[i])) continue;
            const double arm = (modal_.position.meant[order[i]] - turn.center[order[i]]) *
                               text_.on_part(order[i]) * modal_.frame.factors[order[i]];
            square += arm * arm;
        }
        return std::sqrt(square);
    };
    // A text in nanometres asks for no more than machines resolve.
    constexpr double kSeen = 1e-4;  // mm
    const double half =
        std::max(kSeen, text_.end_increment() /
                            text_.to_text(static_cast<Slot>(text_.plane_axes()[0]), 1) / 2);
    const auto report = [&](const TurnMiss& turn, double beside, const DiagnosticRow& row) {
        const SourceRange statement = messages_.place(turn.source);
        DiagnosticBuilder message = messages_.report(row, block);
        message.arg(tables_.name).arg(readable(round_to(1000 * beside, 1)));
        if (statement.file.is_valid()) message.note(statement, "the angle is said here");
    };
    // Once for each frame.
    const auto is_far = [&](const TurnMiss& turn, double beside) {
        return turn.miss > 0 && beside > half && messages_.first_time_of_frame(turn.source);
    };
    if (const double beside = modal_.frame.turn.miss * lever(modal_.frame.turn, 2);
        is_far(modal_.frame.turn, beside)) {
        messages_.fail();
        report(modal_.frame.turn, beside, diag::RotationTooFine);
    }
    if (const double beside = modal_.frame.tilt.miss * lever(modal_.frame.tilt, 3);
        is_far(modal_.frame.tilt, beside))
        report(modal_.frame.tilt, beside, diag::TiltTooFine);
}

}  // namespace kadr::write
