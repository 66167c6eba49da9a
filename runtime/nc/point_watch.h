// point_watch.h — which positions of a text have a decimal point, where a number without one counts
// in increments: a thousandth of what it looks like.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
#include "nc/lexer.h"
#include "nc/line_faults.h"
#include "nc/reading_modes.h"

namespace kadr::nc {

/// Whether a number without a point is a thousandth of what it looks like.
inline bool counts_increments(const Address& address) {
    return address.format.increment > 0 && address.format.increment < 1;
}

/// Whether the word gives a position: an end, a centre or a radius.
inline bool is_position(Slot slot) {
    return ((kTargetSlots | kCenterSlots | bit(Slot::Radius)) & bit(slot)) != 0;
}

class PointWatch {
  public:
    /// References outlive it. What is doubtful is reported by `faults`.
    PointWatch(const DialectTables& tables, const ReadingModes& modes, LineFaults& faults)
        : tables_(tables), modes_(modes), faults_(faults) {}

    /// Whether a position without a point is still worth a second look.
    bool is_open() const { return is_open_; }
    void note_point() { has_points_ = true; }
    /// A position of the line, as it was read.
    void watch(const Claim& claim, const LexedLine& words, std::string_view line);
    /// The program is at its end: positions that all have no decimal point are reported.
    void finish();

  private:
    /// A position without a decimal point.
    struct WholePosition {
        TextLocation location;
        std::string word;      // as it stands: `X118`
        std::string quantity;  // what it is: `0.118 mm`
    };
    bool takes(double number, std::uint64_t line, std::uint32_t column);
    std::vector<WholePosition> take_reported();
    bool is_all_whole() const { return is_open_ && !has_points_ && count_ >= kLeastPositions; }

    static constexpr int kLeastPositions = 2;  // one alone may be meant so

    const DialectTables& tables_;
    const ReadingModes& modes_;
    LineFaults& faults_;
    bool is_open_ = true;
    bool has_points_ = false;
    int count_ = 0;
    int reported_ = 0;
    double reach_ = 0;  // the greatest of them, in increments
    std::vector<WholePosition> kept_;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> seen_;
};

}  // namespace kadr::nc
