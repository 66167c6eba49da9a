#include "path/contour_offset.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kadr::path {

namespace {

/// Corners that turn by less than this are none (rad): a corner arc of 1 m radius would be shorter
/// than kSamePoint.
constexpr double kNoCorner = 1e-8;

/// Pieces whose ends are this near belong together, mm. Where curves touch, their common point is
/// known to the root of the last digit only.
constexpr double kJoin = 5e-6;

/// Shorter pieces do not decide anything, mm.
constexpr double kShort = 1e-7;

/// Longest bit that may stand over where parallels cross at an angle which hardly is one, mm: with
/// kFirm, angles below 1e-8 rad.
constexpr double kLooseEnd = 0.2;

/// An attempt that does not join is repeated with a distance that differs by this, mm: what is
/// degenerate at one distance is not at the next. Well inside kOffsetTolerance.
constexpr double kNudge = 1.3e-7;
constexpr int kAttempts = 6;

/// Alone beside an open contour a piece is a crumb up to this length, mm: where parallels of
/// elements that are tangent but for the last decimal cross twice.
constexpr double kCrumb = 1e-3;

Vec2 left_of(const Vec2& v) { return {-v.y(), v.x()}; }

/// What keeps the distance to this, mm, keeps it as well as numbers can tell.
constexpr double kFirm = 1e-9;

/// Pairs of elements between two looks at the clock.
constexpr std::size_t kSlice = 4096;

/// A cut-out of a candidate between two neighbouring crossings.
struct Slice {
    Element element;
    std::size_t candidate = 0;
    // Not by rounding alone: behind a corner that hardly turns the parallels run too near by less
    // than the tolerance. Such a piece may close a gap, but nothing is missing without it.
    bool is_firm = false;
    bool is_used = false;
};

struct FlatBox {
    Rectangle rectangle;
    std::size_t index = 0;
};

/// Pairs of elements whose boxes, widened by `by`, meet; each pair once, i < j.
template <typename IsOver>
std::vector<std::pair<std::size_t, std::size_t>> near_pairs(const std::vector<Element>& elements,
                                                            double by, const IsOver& is_over) {
    std::vector<FlatBox> boxes;
    boxes.reserve(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i) boxes.push_back({bounds(elements[i]), i});
    std::sort(boxes.begin(), boxes.end(), [](const FlatBox& a, const FlatBox& b) {
        return a.rectangle.lower.x() < b.rectangle.lower.x();
    });
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < boxes.size() && !is_over(); ++i) {
        const Rectangle& a = boxes[i].rectangle;
        for (std::size_t j = i + 1; j < boxes.size(); ++j) {
            const Rectangle& b = boxes[j].rectangle;
            if (b.lower.x() > a.upper.x() + by) break;
            if (a.lower.y() > b.upper.y() + by || b.lower.y() > a.upper.y() + by) continue;
            pairs.emplace_back(std::min(boxes[i].index, boxes[j].index),
                               std::max(boxes[i].index, boxes[j].index));
        }
    }
    return pairs;
}

class Offsetting {
  public:
    Offsetting(std::span<const Contour> contours, double distance,
               const std::function<bool()>& is_over)
        : distance_(distance), is_closed_(path::is_closed(contours.front())), is_over_(is_over) {
        for (const Contour& contour : contours) add_source(contour);
        for (const Element& element : source_) boxes_.push_back(bounds(element));
    }

    std::optional<std::vector<Contour>> run() {
        make_candidates();
        cut();
        cancel_opposites();
        auto joined = join();
        if (is_stopped_) return std::nullopt;
        return joined;
    }
    bool is_stopped() const { return is_stopped_; }

  private:
    /// Asked in front of what takes as long as there are elements.
    bool is_over() {
        is_stopped_ = is_stopped_ || (is_over_ && is_over_());
        return is_stopped_;
    }

    double size() const { return std::fabs(distance_); }

    void add_source(const Contour& contour) {
        const std::size_t first = source_.size();
        // Halves of circles: what follows needs ends that differ.
        for (const Element& element : contour) {
            if (length(element) <= kShort) continue;
            if (std::fabs(element.sweep) > 1.5 * std::numbers::pi) {
                source_.push_back(part(element, 0, 0.5));
                source_.push_back(part(element, 0.5, 1));
                source_.back().from = source_[source_.size() - 2].to;
            } else {
                source_.push_back(element);
            }
            const Rectangle box = bounds(element);
            scale_ = std::max(
                {scale_, box.upper.cwiseAbs().maxCoeff(), box.lower.cwiseAbs().maxCoeff()});
        }
        chains_.emplace_back(first, source_.size());
    }

    void make_candidates() {
        for (const auto& [first, end] : chains_) {
            for (std::size_t i = first; i < end; ++i) {
                add_parallel(source_[i]);
                const std::size_t next = i + 1 < end ? i + 1 : first;
                if (next != first || is_closed_) add_corner(source_[i], source_[next]);
            }
        }
    }

    void add_parallel(const Element& element) {
        const Vec2 at_start = left_of(start_direction(element)) * distance_;
        const Vec2 at_end = left_of(end_direction(element)) * distance_;
        if (element.is_arc()) {
            // Left of a counter-clockwise arc is inside: there the radius becomes smaller, and
            // beyond the centre nothing is left.
            const double r = radius(element) - (element.sweep > 0 ? distance_ : -distance_);
            if (r <= kShort) return;
        }
        Element parallel = element;
        parallel.from += at_start;
        parallel.to += at_end;
        candidates_.push_back(parallel);
    }

    void add_corner(const Element& before, const Element& after) {
        const Vec2 in = end_direction(before);
        const Vec2 out = start_direction(after);
        const double turn = std::atan2(cross(in, out), in.dot(out));
        if (std::fabs(turn) < kNoCorner) return;
        // On the outer side of the corner the parallels leave a gap. A turn back is open on both.
        const bool turns_back = std::fabs(turn) > std::numbers::pi - kNoCorner;
        const bool opens = distance_ > 0 ? turn < 0 : turn > 0;
        if (!opens && !turns_back) return;
        Element arc;
        arc.center = after.from;
        arc.from = before.to + left_of(in) * distance_;
        arc.to = after.from + left_of(out) * distance_;
        arc.sweep = turns_back ? (distance_ > 0 ? -std::numbers::pi : std::numbers::pi) : turn;
        candidates_.push_back(arc);
    }

    double distance_to_source(const Vec2& point, double enough) const {
        double best = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < source_.size(); ++i) {
            const Vec2 outside =
                (boxes_[i].lower - point).cwiseMax(point - boxes_[i].upper).cwiseMax(Vec2::Zero());
            if (outside.squaredNorm() >= best * best) continue;
            best = std::min(best, nearest(source_[i], point).distance);
            if (best < enough) return best;
        }
        return best;
    }

    /// How near a slice comes to the source. It is on one side of the distance throughout, but
    /// where curves touch, rounding may have cut beside the point: several points tell more than
    /// one.
    double nearest_approach(const Element& slice, double enough) const {
        double best = std::numeric_limits<double>::infinity();
        for (const double share : {0.5, 0.06, 0.94, 0.28, 0.72}) {
            best = std::min(best, distance_to_source(point_at(slice, share), enough));
            if (best < enough) break;
        }
        return best;
    }

    void cut() {
        std::vector<std::vector<std::pair<double, Vec2>>> cuts(candidates_.size());
        std::size_t pair = 0;
        for (const auto& [i, j] : near_pairs(candidates_, kShort, [this] { return is_over(); })) {
            if (++pair % kSlice == 0 && is_over()) return;
            for (const Crossing& crossing : crossings(candidates_[i], candidates_[j])) {
                cuts[i].emplace_back(crossing.share_a, crossing.point);
                cuts[j].emplace_back(crossing.share_b, crossing.point);
            }
        }
        if (!is_closed_ && !source_.empty()) {
            // Beyond an end of an open contour the distance to that end counts.
            for (const Vec2& end : {source_.front().from, source_.back().to}) {
                const Element circle =
                    arc_element(end + Vec2(size(), 0), end + Vec2(size(), 0), end, false);
                for (std::size_t i = 0; i < candidates_.size(); ++i) {
                    for (const Crossing& crossing : crossings(candidates_[i], circle)) {
                        cuts[i].emplace_back(crossing.share_a, crossing.point);
                    }
                }
            }
        }
        for (std::size_t i = 0; i < candidates_.size() && !is_over(); ++i) slice(i, cuts[i]);
    }

    void slice(std::size_t i, std::vector<std::pair<double, Vec2>>& cuts) {
        const Element& whole = candidates_[i];
        const double size_of_whole = length(whole);
        if (size_of_whole <= kShort) return;
        std::sort(cuts.begin(), cuts.end(),
                  [](const auto& a, const auto& b) { return a.first < b.first; });
        double from = 0;
        Vec2 at = whole.from;
        const auto put = [&](double to, const Vec2& point) {
            Element element = whole;
            element.from = at;
            element.to = point;
            element.sweep = whole.sweep * (to - from);
            const double needed = size() - kOffsetTolerance / 2;
            const double apart = nearest_approach(element, needed);
            const bool is_firm = apart >= size() - kFirm - 1e-13 * scale_;
            if (apart >= needed) slices_.push_back({element, i, is_firm, false});
            from = to;
            at = point;
        };
        for (const auto& [share, point] : cuts) {
            if ((share - from) * size_of_whole <= kShort) continue;
            if ((1 - share) * size_of_whole <= kShort) break;
            put(share, point);
        }
        put(1, whole.to);
    }

    /// Where a tool just fits between two walls, their parallels run over each other in opposite
    /// directions: nothing lies between them.
    void cancel_opposites() {
        for (std::size_t i = 0; i < slices_.size() && !is_over(); ++i) {
            if (slices_[i].is_used) continue;
            for (std::size_t j = i + 1; j < slices_.size(); ++j) {
                if (slices_[j].is_used) continue;
                const Element& a = slices_[i].element;
                const Element& b = slices_[j].element;
                const bool is_opposite = (a.from - b.to).squaredNorm() < kJoin * kJoin &&
                                         (a.to - b.from).squaredNorm() < kJoin * kJoin;
                if (!is_opposite) continue;
                if ((point_at(a, 0.5) - point_at(b, 0.5)).norm() > kJoin) continue;
                if (length(a) > 4 * kJoin) {
                    slices_[i].is_used = slices_[j].is_used = true;
                    break;
                }
            }
        }
    }

    /// The unused slice that goes on from the end of `last`; at a point where several begin, the
    /// one that turns most to the side of the free region, so that contours that touch stay apart.
    std::size_t next_of(const Slice& last) const {
        std::size_t best = slices_.size();
        bool best_is_firm = false;
        double best_turn = -10;
        double best_gap = kJoin;
        const Vec2 end = last.element.to;
        const Vec2 in = end_direction(last.element);
        for (std::size_t i = first_at(end.x() - kJoin); i < order_.size(); ++i) {
            const Slice& slice = slices_[order_[i]];
            const Vec2 begin = slice.element.from;
            if (begin.x() > end.x() + kJoin) break;
            const double gap = (begin - end).norm();
            if (slice.is_used || gap > kJoin) continue;
            const Vec2 out = start_direction(slice.element);
            double turn = std::atan2(cross(in, out), in.dot(out));
            if (distance_ < 0) turn = -turn;
            // Straight back is no way on, as long as there is another.
            if (std::fabs(turn) > std::numbers::pi - 1e-6) turn = -5;
            const bool is_better =
                slice.is_firm != best_is_firm
                    ? slice.is_firm
                    : turn > best_turn + 1e-6 || (turn > best_turn - 1e-6 && gap < best_gap);
            if (best != slices_.size() && !is_better) continue;
            best = order_[i];
            best_is_firm = slice.is_firm;
            best_turn = turn;
            best_gap = gap;
        }
        return best;
    }

    std::size_t first_at(double x) const {
        const auto at = std::lower_bound(
            order_.begin(), order_.end(), x,
            [&](std::size_t i, double value) { return slices_[i].element.from.x() < value; });
        return static_cast<std::size_t>(at - order_.begin());
    }

    std::optional<std::vector<Contour>> join() {
        for (std::size_t i = 0; i < slices_.size(); ++i) order_.push_back(i);
        std::sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
            return slices_[a].element.from.x() < slices_[b].element.from.x();
        });
        std::vector<Contour> result;
        for (const bool is_firm : {true, false}) {
            for (std::size_t start = 0; start < slices_.size() && !is_over(); ++start) {
                const Slice& slice = slices_[start];
                if (slice.is_used || slice.is_firm != is_firm || !begins_chain(start)) continue;
                if (!follow(start, result)) return std::nullopt;
            }
            // What is left are rings without a beginning.
            for (std::size_t start = 0; start < slices_.size() && !is_over(); ++start) {
                const Slice& slice = slices_[start];
                if (slice.is_used || slice.is_firm != is_firm) continue;
                if (!follow(start, result)) return std::nullopt;
            }
        }
        const bool has_whole = std::ranges::any_of(
            result, [](const Contour& contour) { return length(contour) > kCrumb; });
        if (!is_closed_ && has_whole)
            std::erase_if(result, [](const Contour& c) { return length(c) <= kCrumb; });
        return result;
    }

    /// Only pieces beside an open contour begin where nothing ends.
    bool begins_chain(std::size_t start) const {
        if (is_closed_) return false;
        return std::none_of(slices_.begin(), slices_.end(), [&](const Slice& slice) {
            return !slice.is_used &&
                   (slice.element.to - slices_[start].element.from).norm() <= kJoin;
        });
    }

    bool follow(std::size_t start, std::vector<Contour>& result) {
        std::vector<std::size_t> chain = {start};
        slices_[start].is_used = true;
        const Vec2 begin = slices_[start].element.from;
        double total = length(slices_[start].element);
        bool is_ring = false;
        for (;;) {
            const Slice& last = slices_[chain.back()];
            is_ring = (last.element.to - begin).norm() <= kJoin && total > 4 * kJoin;
            if (is_ring) break;
            const std::size_t next = next_of(last);
            if (next == slices_.size()) break;
            slices_[next].is_used = true;
            chain.push_back(next);
            total += length(slices_[next].element);
        }
        if (!is_ring && is_closed_) is_ring = cut_loose_ends(chain);
        Contour contour = merged(chain, is_ring);
        if (is_ring) {
            // A sliver that rounding has left where curves touch.
            if (std::fabs(signed_area(contour)) <= kJoin * total) return true;
        } else if (!slices_[start].is_firm || total <= 4 * kJoin) {
            return true;
        } else if (is_closed_) {
            return total <= 20 * kJoin;  // crumbs at a touching point, else something is missing
        }
        result.push_back(std::move(contour));
        return true;
    }

    /// Where two parallels hardly turn from one to the other, both go on a little behind their
    /// crossing without coming nearer than rounding tells: a chain may begin and end on such a bit.
    /// The ring between is what counts.
    bool cut_loose_ends(std::vector<std::size_t>& chain) const {
        double before = 0;
        for (std::size_t first = 0; first < chain.size() && before <= kLooseEnd; ++first) {
            double behind = 0;
            for (std::size_t last = chain.size(); last-- > first && behind <= kLooseEnd;) {
                const Vec2 gap =
                    slices_[chain[last]].element.to - slices_[chain[first]].element.from;
                if (gap.norm() <= kJoin && last > first) {
                    chain.resize(last + 1);
                    chain.erase(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(first));
                    return true;
                }
                behind += length(slices_[chain[last]].element);
            }
            before += length(slices_[chain[first]].element);
        }
        return false;
    }

    /// Slices of one candidate become one element again; ends that differ by rounding become the
    /// same.
    Contour merged(const std::vector<std::size_t>& chain, bool is_ring) const {
        Contour contour;
        std::vector<std::size_t> origin;
        const auto put = [&](const Slice& slice) {
            const Element& element = slice.element;
            if (!contour.empty() && goes_on(contour.back(), origin.back(), slice)) {
                contour.back().to = element.to;
                contour.back().sweep += element.sweep;
                return;
            }
            contour.push_back(element);
            origin.push_back(slice.candidate);
        };
        for (const std::size_t i : chain) put(slices_[i]);
        if (is_ring && contour.size() > 1) {
            const Slice first{contour.front(), origin.front(), true, false};
            if (goes_on(contour.back(), origin.back(), first)) {
                contour.back().to = contour.front().to;
                contour.back().sweep += contour.front().sweep;
                contour.erase(contour.begin());
            }
        }
        // Crumbs go, their neighbours close up.
        std::erase_if(contour, [&](const Element& element) {
            return contour.size() > 2 && length(element) <= kShort;
        });
        for (std::size_t i = 0; i + 1 < contour.size(); ++i) contour[i + 1].from = contour[i].to;
        if (is_ring) contour.front().from = contour.back().to;
        for (Element& element : contour) fit_center(element);
        return contour;
    }

    /// Of one candidate, or of the two halves of a circle.
    static bool goes_on(const Element& before, std::size_t candidate, const Slice& next) {
        if (candidate == next.candidate) return true;
        const Element& after = next.element;
        if (!before.is_arc() || !after.is_arc()) return false;
        if ((before.sweep > 0) != (after.sweep > 0)) return false;
        if ((before.center - after.center).norm() > 1e-9) return false;
        return std::fabs(before.sweep + after.sweep) <= 2 * std::numbers::pi + 1e-9;
    }

    /// Ends have moved by some nanometres: the centre follows onto their perpendicular bisector.
    static void fit_center(Element& element) {
        if (!element.is_arc()) return;
        const Vec2 chord = element.to - element.from;
        if (chord.norm() < 1e-3 * radius(element)) return;
        const Vec2 middle = (element.from + element.to) / 2;
        element.center -= chord * ((element.center - middle).dot(chord) / chord.squaredNorm());
        const Element fitted =
            arc_element(element.from, element.to, element.center, element.sweep < 0);
        if (std::fabs(fitted.sweep - element.sweep) < 0.1) element.sweep = fitted.sweep;
    }

    Contour source_;                                           // all contours, one behind the other
    std::vector<std::pair<std::size_t, std::size_t>> chains_;  // first and past-last of each
    std::vector<Rectangle> boxes_;
    double distance_ = 0;
    bool is_closed_ = false;
    const std::function<bool()>& is_over_;
    bool is_stopped_ = false;
    double scale_ = 1;
    std::vector<Element> candidates_;
    std::vector<Slice> slices_;
    std::vector<std::size_t> order_;  // slices by the x of their beginning
};

}  // namespace

Result<std::vector<Contour>, OffsetFault> offset(std::span<const Contour> contours, double distance,
                                                 const std::function<bool()>& is_over) {
    std::vector<Contour> given(contours.begin(), contours.end());
    std::erase_if(given, [](const Contour& contour) { return contour.empty(); });
    if (given.empty() || distance == 0) return given;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        // 0, +1, −1, +2 …: away from what was degenerate, to both sides.
        const int step = (attempt + 1) / 2 * (attempt % 2 == 1 ? 1 : -1);
        Offsetting offsetting(given, distance + step * kNudge, is_over);
        std::optional<std::vector<Contour>> result = offsetting.run();
        if (offsetting.is_stopped()) return OffsetFault::Stopped;
        if (result) return std::move(*result);
    }
    return OffsetFault::Unresolved;
}

Result<std::vector<Contour>, OffsetFault> offset(const Contour& contour, double distance,
                                                 const std::function<bool()>& is_over) {
    return offset(std::span(&contour, 1), distance, is_over);
}

}  // namespace kadr::path
