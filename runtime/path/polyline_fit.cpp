#include "path/polyline_fit.h"

#include <algorithm>
#include <cmath>

#include "path/complete_spline.h"

namespace kadr::path {

namespace {

/// Part of the tolerance that is used: between the places that are looked at a cubic may be a
/// little farther away.
constexpr double kUsed = 0.95;
/// Places on every line that are looked at.
constexpr int kPlaces = 4;
/// How far a place of the cubic may be ahead of that of the polyline with the same parameter or
/// behind it, in tolerances: then the distance across tells how far both are apart.
constexpr double kAhead = 4;
/// Four times the halvings of the longest run that is fitted at once; what is not good then are
/// lines.
constexpr int kRounds = 40;

class Fit {
  public:
    Fit(std::span<const Vec3> points, const PolylineFitOptions& options)
        : points_(points),
          options_(options),
          lengths_(points.size(), 0),
          is_line_(points.size(), false) {
        for (std::size_t i = 1; i < points.size(); ++i)
            lengths_[i] = lengths_[i - 1] + (points[i] - points[i - 1]).norm();
        set_nodes();
    }

    std::vector<PolylinePart> run() {
        for (int round = 0; round < kRounds; ++round) {
            solve();
            if (!refine(round + 1 == kRounds)) break;
        }
        solve();
        return std::move(parts_);
    }

  private:
    /// Cubics through the nodes between lines that stay.
    void solve() {
        parts_.clear();
        std::size_t first = 0;
        while (first + 1 < points_.size()) {
            if (is_line_[first]) {
                add_line(first);
                ++first;
                continue;
            }
            nodes_.clear();
            std::size_t last = first;
            for (; last < points_.size(); ++last) {
                if (is_node_[last]) nodes_.push_back({lengths_[last], points_[last]});
                if (is_node_[last] && is_line_[last]) break;
            }
            add_cubics(first, std::min(last, points_.size() - 1));
            first = last;
        }
    }

    void add_line(std::size_t at) {
        PolylinePart part{at, at + 1, true, {}, slope_of_line(at)};
        part.cubic = hermite(points_[at], part.slope * width(at, at + 1), points_[at + 1],
                             part.slope * width(at, at + 1));
        parts_.push_back(part);
    }
    Vec3 slope_of_line(std::size_t at) const {
        return (points_[at + 1] - points_[at]) / width(at, at + 1);
    }
    double width(std::size_t from, std::size_t to) const { return lengths_[to] - lengths_[from]; }

    /// Slope of the parabola through three nodes at the first of them, or of the line through two.
    template <typename Node>
    static Vec3 end_slope(const Node& node, std::size_t count) {
        const double h0 = node(1).parameter - node(0).parameter;
        const Vec3 d0 = (node(1).position - node(0).position) / h0;
        if (count < 3) return d0;
        const double h1 = node(2).parameter - node(1).parameter;
        const Vec3 d1 = (node(2).position - node(1).position) / h1;
        return d0 + (d0 - d1) * (h0 / (h0 + h1));
    }

    void add_cubics(std::size_t first, std::size_t last) {
        const std::size_t count = nodes_.size();
        const auto forward = [&](std::size_t i) { return nodes_[i]; };
        const auto backward = [&](std::size_t i) { return nodes_[count - 1 - i]; };
        const bool is_given = first == 0 && options_.first_slope.has_value();
        const Vec3 slope = is_given ? *options_.first_slope : end_slope(forward, count);
        const auto slopes = complete_slopes(nodes_, slope, end_slope(backward, count));
        std::size_t from = first;
        std::size_t node = 0;
        for (std::size_t to = first + 1; to <= last; ++to) {
            if (!is_node_[to]) continue;
            PolylinePart part{from, to, false, {}, slopes[node + 1]};
            part.cubic = hermite(points_[from], slopes[node] * width(from, to), points_[to],
                                 slopes[node + 1] * width(from, to));
            parts_.push_back(part);
            from = to;
            ++node;
        }
    }

    /// Halves what is not good; false if everything is.
    bool refine(bool is_last) {
        bool is_changed = false;
        bool has_broken = false;
        for (const PolylinePart& part : parts_) {
            if (part.is_line || keeps(part)) continue;
            is_changed = true;
            if (is_last || part.to == part.from + 1) {
                for (std::size_t i = part.from; i < part.to; ++i) is_line_[i] = true;
                has_broken = true;
            } else {
                is_node_[middle(part)] = true;
            }
        }
        // What was halved beside a corner may do without, once the corner is apart.
        if (has_broken) set_nodes();
        return is_changed;
    }

    /// No more than what has to be.
    void set_nodes() {
        is_node_.assign(points_.size(), false);
        is_node_.front() = is_node_.back() = true;
        for (const std::size_t end : options_.ends) is_node_[end] = true;
        for (std::size_t i = 0; i + 1 < points_.size(); ++i)
            if (is_line_[i]) is_node_[i] = is_node_[i + 1] = true;
    }

    /// The point between both ends that is nearest to the middle of the way.
    std::size_t middle(const PolylinePart& part) const {
        const double half = (lengths_[part.from] + lengths_[part.to]) / 2;
        const auto begin = lengths_.begin() + static_cast<std::ptrdiff_t>(part.from) + 1;
        const auto end = lengths_.begin() + static_cast<std::ptrdiff_t>(part.to);
        const auto found = std::lower_bound(begin, end - 1, half);
        return static_cast<std::size_t>(found - lengths_.begin());
    }

    bool keeps(const PolylinePart& part) const {
        const double whole = width(part.from, part.to);
        const double most = kUsed * options_.tolerance;
        for (std::size_t i = part.from; i < part.to; ++i) {
            for (int k = 0; k < kPlaces; ++k) {
                const double share = static_cast<double>(k) / kPlaces;
                const Vec3 place = points_[i] + (points_[i + 1] - points_[i]) * share;
                const double at = lengths_[i] + width(i, i + 1) * share - lengths_[part.from];
                const auto [position, derivative] = evaluate(part.cubic, at / whole);
                const Vec3 way = place - position;
                const double along = way.dot(derivative) / derivative.norm();
                if (!(std::fabs(along) <= kAhead * options_.tolerance)) return false;
                if (way.squaredNorm() - along * along > most * most) return false;
            }
        }
        return true;
    }

    std::span<const Vec3> points_;
    const PolylineFitOptions& options_;
    std::vector<double> lengths_;  // of the polyline up to every point
    std::vector<bool> is_node_;    // a part ends there
    std::vector<bool> is_line_;    // what begins there stays a line
    std::vector<SplineNode> nodes_;
    std::vector<PolylinePart> parts_;
};

}  // namespace

std::vector<PolylinePart> fit_polyline(std::span<const Vec3> points,
                                       const PolylineFitOptions& options) {
    return Fit(points, options).run();
}

}  // namespace kadr::path
