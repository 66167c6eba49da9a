// point_watch.h — which positions of a text have a decimal point, where a number without one counts
// in increments: a thousandth of what it looks like.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostic.h"

namespace kadr::nc {

/// A position without a decimal point.
struct WholePosition {
    TextLocation place;
    std::string word;      // as it stands: `X118`
    std::string quantity;  // what it is: `0.118 mm`
};

class PointWatch {
  public:
    /// Whether a position without a point is still worth a second look.
    bool is_open() const { return is_open_; }
    void note_point() { has_points_ = true; }
    void close() { is_open_ = false; }
    bool has_points() const { return has_points_; }
    /// A number without a point, which stands at this line and column; false: it was noted before,
    /// or tells that the text is written in increments.
    bool takes(double number, std::uint64_t line, std::uint32_t column);
    void keep(WholePosition position) { kept_.push_back(std::move(position)); }
    /// What is to be told now: nothing before a position with a point has come.
    std::vector<WholePosition> take_told();
    /// Whether no position has a point, and all lie as if they were millimetres.
    bool is_all_whole() const { return is_open_ && !has_points_ && count_ >= kLeastPositions; }
    /// The greatest of them, in increments, and where the first stands.
    double reach() const { return reach_; }
    const WholePosition& first() const { return kept_.front(); }

  private:
    static constexpr int kLeastPositions = 2;  // one alone may be what it says

    bool is_open_ = true;
    bool has_points_ = false;
    int count_ = 0;
    int told_ = 0;
    double reach_ = 0;
    std::vector<WholePosition> kept_;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> seen_;
};

}  // namespace kadr::nc
