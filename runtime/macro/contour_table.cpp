#include "macro/contour_table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "base/units.h"

namespace kadr::macro {

using path::Element;
using path::Vec2;

namespace {

/// Heights that differ less are one level.
constexpr double kSameLevel = 1e-6;  // mm, inches
/// Behind the last rise there is no further undercut.
constexpr double kNoFurther = -1111;
constexpr std::size_t kLeastElements = 3;  // the path to the first point included (unsure)

bool is_full_circle(const ContourElement& element) {
    constexpr double kWhole = 2 * std::numbers::pi - 1e-9;
    return std::fabs(element.shape.sweep) >= kWhole;
}

int motion_digit(const ContourElement& element) {
    if (element.is_rapid) return 0;
    if (!element.shape.is_arc()) return 1;
    return element.shape.sweep < 0 ? 2 : 3;
}

/// How high a point is: material is taken away from above.
class Heights {
  public:
    explicit Heights(const ContourCut& cut)
        : coordinate_(cut.is_face ? 0 : 1), sign_(cut.is_inside ? -1 : 1) {}

    double of(const Vec2& point) const { return sign_ * point[coordinate_]; }
    /// The point above or below another one, at a height.
    Vec2 at(const Vec2& point, double height) const {
        Vec2 out = point;
        out[coordinate_] = sign_ * height;
        return out;
    }
    /// Shares of an arc at which it is highest or lowest, between its ends, in the order of travel.
    std::vector<double> turning_points(const Element& arc) const {
        std::vector<double> out;
        const Vec2 spoke = arc.from - arc.center;
        const double begin = std::atan2(spoke.y(), spoke.x());
        const double first = coordinate_ == 0 ? 0 : std::numbers::pi / 2;
        for (int half = -5; half <= 5; ++half) {
            const double share = (first + half * std::numbers::pi - begin) / arc.sweep;
            if (share > 1e-9 && share < 1 - 1e-9) out.push_back(share);
        }
        std::ranges::sort(out);
        return out;
    }
    /// The share of a piece that only rises at which it has come to a height.
    double share_at(const Element& piece, double height) const {
        const double from = of(piece.from);
        const double to = of(piece.to);
        if (!piece.is_arc()) return (height - from) / (to - from);
        double low = 0;
        double high = 1;
        for (int i = 0; i < 60; ++i) {
            const double middle = (low + high) / 2;
            (of(path::point_at(piece, middle)) < height ? low : high) = middle;
        }
        return (low + high) / 2;
    }

  private:
    Eigen::Index coordinate_;
    double sign_;
};

/// Angle between an element and the abscissa, in facing the ordinate: degrees, below 180; of an arc
/// the greatest one, to 180.
double steepest(const Element& shape, bool is_face) {
    if (path::length(shape) < path::kSamePoint) return 0;
    const auto angle = [&](const Vec2& direction) {
        return is_face ? std::atan2(direction.x(), direction.y())
                       : std::atan2(direction.y(), direction.x());
    };
    const double begin = angle(path::start_direction(shape));
    const double end = begin + (is_face ? -shape.sweep : shape.sweep);
    constexpr double kSlack = 1e-9;
    const double high = std::max(begin, end);
    const double turns = std::floor(high / std::numbers::pi + kSlack) * std::numbers::pi;
    if (std::min(begin, end) < turns - kSlack) return 180;
    return std::max(0.0, deg_from_rad(high - turns));
}

/// The contour in one direction, divided and closed, with the rows of its pieces.
class ElementChain {
  public:
    struct Piece {
        ContourElement element;
        std::int64_t row = 0;
        double mark = 0;
    };

    /// next  the first row for what is divided, and from there on by `step`
    ElementChain(const ContourCut& cut, std::int64_t next, std::int64_t step)
        : heights_(cut), next_(next), step_(step) {}

    /// `row` is that of the element's first piece.
    void add(const ContourElement& element, std::int64_t row) {
        row_ = row;
        double from = 0;
        std::vector<double> ends;
        if (element.shape.is_arc()) ends = heights_.turning_points(element.shape);
        ends.push_back(1);
        for (const double end : ends) {
            ContourElement piece = element;
            if (from > 0 || end < 1) piece.shape = path::part(element.shape, from, end);
            add_piece(piece);
            from = end;
        }
    }
    /// Rises to the levels at which undercuts have begun, and marks the rows.
    void close() {
        while (!levels_.empty() && !pieces_.empty()) {
            ContourElement wall = pieces_.back().element;
            const Vec2 end = wall.shape.to;
            wall.shape = path::line_element(end, heights_.at(end, levels_.back()));
            wall.is_rapid = false;
            add_piece(wall);
        }
        for (std::size_t i = 0; i < stretches_.size(); ++i) {
            Piece& first = pieces_[stretches_[i].first];
            const bool rises = stretches_[i].rises;
            if (i + 1 < stretches_.size()) {
                const auto next = static_cast<double>(pieces_[stretches_[i + 1].first].row);
                first.mark = rises ? -next : next;
            } else {
                first.mark = kNoFurther;
            }
        }
    }
    const std::vector<Piece>& pieces() const { return pieces_; }
    int undercuts() const { return undercuts_; }
    /// The row behind those that were used, in the direction of the chain.
    std::int64_t next_row() const { return next_; }

  private:
    struct MonotonePart {
        std::size_t first = 0;  // of the pieces
        bool rises = false;
    };

    /// One that does not turn from rising to falling.
    void add_piece(ContourElement piece) {
        const double from = heights_.of(piece.shape.from);
        const double to = heights_.of(piece.shape.to);
        if (to < from - kSameLevel && goes_on(false)) {
            levels_.push_back(from);
            ++undercuts_;
        }
        if (to > from + kSameLevel) {
            goes_on(true);
            while (!levels_.empty() && to > levels_.back() - kSameLevel) {
                const double level = levels_.back();
                levels_.pop_back();
                if (to <= level + kSameLevel) break;
                const double share = heights_.share_at(piece.shape, level);
                ContourElement below = piece;
                below.shape = path::part(piece.shape, 0, share);
                piece.shape = path::part(piece.shape, share, 1);
                put(below);
            }
        }
        put(piece);
    }
    /// A stretch that rises, or falls, goes on with the next piece; true: it begins with it.
    bool goes_on(bool rises) {
        if (!stretches_.empty() && stretches_.back().rises == rises) return false;
        stretches_.push_back({pieces_.size(), rises});
        return true;
    }
    void put(const ContourElement& piece) {
        if (!row_) {
            row_ = next_;
            next_ += step_;
        }
        pieces_.push_back({piece, *row_, 0});
        row_.reset();
    }

    Heights heights_;
    std::vector<Piece> pieces_;
    std::vector<MonotonePart> stretches_;
    std::vector<double> levels_;       // of open undercuts, the last one is the lowest
    std::optional<std::int64_t> row_;  // of the element that comes, before its first piece
    std::int64_t next_;
    std::int64_t step_;
    int undercuts_ = 0;
};

ContourElement reversed(const ContourElement& element) {
    ContourElement out = element;
    out.shape = path::reversed(element.shape);
    return out;
}

void fill_shape(ContourRow& cells, const ContourElement& element, bool is_face) {
    const Element& shape = element.shape;
    cells[2] = (element.modes.is_incremental ? 100 : 0) + (element.modes.is_metric ? 10 : 0) +
               motion_digit(element);
    cells[3] = shape.from.x();
    cells[4] = shape.from.y();
    cells[5] = shape.to.x();
    cells[6] = shape.to.y();
    cells[8] = steepest(shape, is_face);
    if (!shape.is_arc()) return;
    cells[9] = shape.center.x();
    cells[10] = shape.center.y();
}

/// The rows of a chain, each with the numbers of the ones before and behind it.
void fill_chain(const ElementChain& chain, bool is_face,
                std::vector<RowAtNumber<ContourRow>>& out) {
    const std::vector<ElementChain::Piece>& pieces = chain.pieces();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        RowAtNumber<ContourRow> row{static_cast<std::size_t>(pieces[i].row), {}};
        if (i > 0) row.cells[0] = static_cast<double>(pieces[i - 1].row);
        if (i + 1 < pieces.size()) row.cells[1] = static_cast<double>(pieces[i + 1].row);
        fill_shape(row.cells, pieces[i].element, is_face);
        row.cells[7] = pieces[i].mark;
        out.push_back(row);
    }
}

}  // namespace

Result<PreparedContour, ContourFault> prepared_contour(std::span<const ContourElement> elements,
                                                       const ContourCut& cut, std::size_t rows) {
    if (elements.size() < kLeastElements) return ContourFault::TooFew;
    if (std::ranges::any_of(elements, is_full_circle)) return ContourFault::FullCircle;
    const auto count = static_cast<std::int64_t>(elements.size()) - 1;
    const auto last = static_cast<std::int64_t>(rows) - 1;
    ElementChain forwards(cut, count + 1, 1);
    for (std::int64_t i = 1; i <= count; ++i)
        forwards.add(elements[static_cast<std::size_t>(i)], i);
    forwards.close();
    ElementChain backwards(cut, last - count - 1, -1);
    for (std::int64_t i = count; cut.both_ways && i >= 1; --i)
        backwards.add(reversed(elements[static_cast<std::size_t>(i)]), last - i);
    backwards.close();
    // Behind the rows forwards one counts how many undercuts there are.
    const std::int64_t counts = forwards.next_row();
    if (counts > (cut.both_ways ? backwards.next_row() : last)) return ContourFault::TableTooSmall;

    PreparedContour out;
    out.undercuts = forwards.undercuts();
    RowAtNumber<ContourRow> head;
    head.cells[0] = static_cast<double>(forwards.pieces().back().row);
    head.cells[1] = static_cast<double>(counts - 1);
    fill_shape(head.cells, elements[0], cut.is_face);
    out.rows.push_back(head);
    fill_chain(forwards, cut.is_face, out.rows);
    RowAtNumber<ContourRow> totals{static_cast<std::size_t>(counts), {}};
    totals.cells[0] = forwards.undercuts();
    totals.cells[1] = backwards.undercuts();
    out.rows.push_back(totals);
    if (!cut.both_ways) return out;
    fill_chain(backwards, cut.is_face, out.rows);
    RowAtNumber<ContourRow> tail{static_cast<std::size_t>(last), {}};
    tail.cells[0] = static_cast<double>(backwards.next_row() + 1);
    tail.cells[1] = static_cast<double>(backwards.pieces().front().row);
    fill_shape(tail.cells, reversed(elements[0]), cut.is_face);
    out.rows.push_back(tail);
    return out;
}

Result<std::vector<RowAtNumber<CodedRow>>, ContourFault> coded_contour(
    std::span<const ContourElement> elements, std::size_t rows) {
    if (elements.empty()) return ContourFault::TooFew;
    if (std::ranges::any_of(elements, is_full_circle)) return ContourFault::FullCircle;
    if (elements.size() + 1 > rows) return ContourFault::TableTooSmall;
    std::vector<RowAtNumber<CodedRow>> out;
    const ContourElement& first = elements.front();
    out.push_back({0,
                   {10.0 * first.modes.units, first.shape.from.x(), first.shape.from.y(), 0, 0,
                    static_cast<double>(elements.size())}});
    for (const ContourElement& element : elements) {
        const ContourModes& modes = element.modes;
        const int code = motion_digit(element) + 10 * modes.units +
                         (modes.is_incremental ? 100 : 0) + 1000 * modes.feed_mode +
                         10000 * modes.path_mode + (modes.stops_once ? 100000 : 0);
        const Vec2 center = element.shape.is_arc() ? element.shape.center : Vec2(Vec2::Zero());
        out.push_back({out.size(),
                       {static_cast<double>(code), element.shape.to.x(), element.shape.to.y(),
                        center.x(), center.y(), element.feed}});
    }
    return out;
}

std::optional<ContourElement> element_of(const ContourRow& row) {
    const double code = row[2];
    if (!(code >= 0 && code < 200) || code != std::floor(code)) return std::nullopt;
    const int digits = static_cast<int>(code);
    const int motion = digits % 10;
    if (motion > 3 || digits / 10 % 10 > 1) return std::nullopt;
    ContourElement out;
    out.is_rapid = motion == 0;
    out.modes.is_metric = digits / 10 % 10 == 1;
    out.modes.is_incremental = digits / 100 == 1;
    constexpr double kFarthest = 1e8;  // mm; farther than any machine goes
    if (std::ranges::any_of(row, [](double cell) { return !(std::fabs(cell) < kFarthest); }))
        return std::nullopt;
    const Vec2 from{row[3], row[4]};
    const Vec2 to{row[5], row[6]};
    if (motion < 2) {
        out.shape = path::line_element(from, to);
        return out;
    }
    const Vec2 center{row[9], row[10]};
    constexpr double kLeastRadius = 1e-4;
    if ((from - center).norm() < kLeastRadius) return std::nullopt;
    out.shape = path::arc_element(from, to, center, motion == 2);
    return out;
}

std::optional<Vec2> common_point(const ContourElement& a, const ContourElement& b) {
    const std::vector<path::Crossing> points = path::crossings(a.shape, b.shape);
    if (points.empty()) return std::nullopt;
    return std::ranges::min(points, {}, &path::Crossing::share_a).point;
}

}  // namespace kadr::macro
