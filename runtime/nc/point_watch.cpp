#include "nc/point_watch.h"

#include <algorithm>
#include <cmath>

#include "base/danger_limits.h"
#include "base/diagnostics/doubtful.h"

namespace kadr::nc {

namespace {

/// Positions without a point that are remembered where none has one; behind so many it is how the
/// text is written.
constexpr std::size_t kMostSeen = 4096;
/// Positions without a point among others that are reported one by one; more of them are a habit.
constexpr int kMostReported = 5;

}  // namespace

void PointWatch::watch(const Claim& claim, const LexedLine& words, std::string_view line) {
    const GivenWord& word = words.words[claim.word];
    const Address& address = tables_.addresses[word.address];
    if (word.is_computed || !counts_increments(address)) return;
    const Decimal& decimal = words.decimals[claim.word];
    const Span& span = words.spans[claim.word];
    const TextUnits& units = modes_.units();
    if (decimal.has_point) note_point();
    if (!decimal.has_point && decimal.value != 0 &&
        takes(decimal.value, faults_.line_number(), span.begin)) {
        const double meaning = read_meaning(decimal, address.format, claim.dimension, units);
        kept_.push_back({faults_.location(line, span), words.text_of(line, claim.word),
                         quantity_words(meaning, claim.dimension, units)});
    }
    for (WholePosition& whole : take_reported()) {
        DiagnosticBuilder message = faults_.message(diag::PointMissing, std::move(whole.location));
        message.arg(whole.word).arg(whole.quantity).fix("`" + whole.word + ".` has its point");
        faults_.write_notes(message);
    }
}

void PointWatch::finish() {
    if (faults_.failed() || !is_all_whole()) return;
    is_open_ = false;
    const double reach = reach_ * increment_size(tables_, Dimension::Length, modes_.units());
    DiagnosticBuilder message = faults_.message(diag::PathInIncrements, kept_.front().location);
    message.arg(quantity_words(reach, Dimension::Length, modes_.units()));
    // What a number without a point is on other machines.
    const auto other = tables_.foreign.find(".");
    if (other != tables_.foreign.end() && !other->second.empty()) message.fix(other->second);
}

/// A number without a point, which stands at this line and column; false: it was noted before, or
/// shows that the text is written in increments.
bool PointWatch::takes(double number, std::uint64_t line, std::uint32_t column) {
    // Far from zero it is no millimetre that lost its point: somebody counts in increments.
    if (std::fabs(number) > danger::kMostWholePosition || seen_.size() == kMostSeen) {
        is_open_ = false;
        return false;
    }
    if (std::ranges::find(seen_, std::pair{line, column}) != seen_.end()) return false;
    seen_.emplace_back(line, column);
    ++count_;
    reach_ = std::max(reach_, std::fabs(number));
    return kept_.size() < std::size_t{kMostReported};
}

/// What is to be reported now: nothing before a position with a point has come.
std::vector<PointWatch::WholePosition> PointWatch::take_reported() {
    if (!has_points_) return {};
    std::vector<WholePosition> reported = std::exchange(kept_, {});
    reported_ += static_cast<int>(reported.size());
    if (reported_ >= kMostReported) is_open_ = false;
    return reported;
}

}  // namespace kadr::nc
