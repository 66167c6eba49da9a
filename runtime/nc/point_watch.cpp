#include "nc/point_watch.h"

#include <algorithm>

#include "base/danger_limits.h"
#include "base/diagnostics/doubtful.h"
#include "nc/line_reader.h"

namespace kadr::nc {

namespace {

/// Positions without a point that are remembered where none has one; behind so many it is how the
/// text is written.
constexpr std::size_t kMostSeen = 4096;
/// Positions without a point among others that are told one by one; more of them are a habit.
constexpr int kMostTold = 5;

}  // namespace

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
    return kept_.size() < std::size_t{kMostTold};
}

std::vector<WholePosition> PointWatch::take_told() {
    if (!has_points_) return {};
    std::vector<WholePosition> told = std::exchange(kept_, {});
    told_ += static_cast<int>(told.size());
    if (told_ >= kMostTold) is_open_ = false;
    return told;
}

// ---------------------------------------------------------------- where the reader asks

/// A position of the line as it was read: whether it has its point, where a number without one is a
/// thousandth.
void LineReader::watch_point(const Claim& claim, std::string_view line) {
    const GivenWord& word = lexed_->words[claim.word];
    const Address& address = tables_.addresses[word.address];
    if (word.is_computed || !counts_increments(address)) return;
    const Decimal& decimal = lexed_->decimals[claim.word];
    const Span& span = lexed_->spans[claim.word];
    if (decimal.has_point) points_.note_point();
    if (!decimal.has_point && decimal.value != 0 &&
        points_.takes(decimal.value, line_number_, span.begin)) {
        const double meaning = read_meaning(decimal, address.format, claim.dimension, units_);
        points_.keep({place(line, line_number_, span), word_text(line, claim.word),
                      quantity_words(meaning, claim.dimension, units_)});
    }
    for (WholePosition& whole : points_.take_told()) {
        DiagnosticBuilder message = sink_.report(diag::PointMissing, std::move(whole.place));
        message.arg(whole.word).arg(whole.quantity).fix("`" + whole.word + ".` has its point");
        write_notes(message);
    }
}

void LineReader::finish_points() {
    if (failed_ || !points_.is_all_whole()) return;
    points_.close();
    const TextUnits& units = units_;
    const double reach = points_.reach() * increment_size(tables_, Dimension::Length, units);
    DiagnosticBuilder message = sink_.report(diag::PathInIncrements, points_.first().place);
    message.arg(quantity_words(reach, Dimension::Length, units));
    // What a number without a point is on other machines.
    const auto other = tables_.foreign.find(".");
    if (other != tables_.foreign.end() && !other->second.empty()) message.fix(other->second);
}

}  // namespace kadr::nc
