#include "path/polyline_fit.h"

#include <algorithm>

#include "path/complete_spline.h"
#include "path/polyline_deviation.h"

namespace kadr::path {

namespace {

/// Part of the tolerance that is used; the rest is for corners that are blended behind it.
constexpr double kUsed = 0.95;
/// So often a line may be fitted anew. Smooth lines need the halvings of the longest run, about
/// ten; lines that are broken out of a run twice as many and a few more.
constexpr std::size_t kMostWork = 64;

/// Lines between two points, to be fitted by themselves.
struct LineRun {
    std::size_t first;
    std::size_t last;
    bool is_broken = false;  // a line beside which no cubic stays
};

class Fit {
  public:
    Fit(std::span<const Vec3> points, const PolylineFitOptions& options)
        : points_(points), options_(options), lengths_(points.size(), 0) {
        for (std::size_t i = 1; i < points.size(); ++i)
            lengths_[i] = lengths_[i - 1] + (points[i] - points[i - 1]).norm();
    }

    std::vector<PolylinePart> run() {
        waiting_ = {{0, points_.size() - 1}};
        while (!waiting_.empty()) {
            const LineRun run = waiting_.back();
            waiting_.pop_back();
            fit(run);
        }
        return std::move(done_);
    }

  private:
    /// Cubics for a run, or lines out of it and what is left between them.
    void fit(const LineRun& run) {
        const bool is_alone = run.last - run.first == 1 && !begins_with_slope(run);
        if (run.is_broken || is_alone) return add_line(run.first);
        set_nodes(run);
        while (true) {
            work_ += run.last - run.first;
            solve(run);
            std::vector<std::size_t> halves;
            std::vector<std::size_t> broken;
            for (PolylinePart& part : parts_) {
                const auto apart = deviation_from_lines(
                    part.cubic, points_.subspan(part.from, part.to - part.from + 1),
                    kUsed * options_.tolerance);
                if (apart) part.apart = *apart;
                else if (part.to == part.from + 1) broken.push_back(part.from);
                else halves.push_back(middle(part));
            }
            if (halves.empty() && broken.empty()) {
                done_.insert(done_.end(), parts_.begin(), parts_.end());
                return;
            }
            if (work_ > kMostWork * points_.size()) return add_lines(run);
            // A line beside which a cubic is still too long may yet be good when that is halved.
            if (halves.empty()) return break_at(broken, run);
            nodes_.insert(nodes_.end(), halves.begin(), halves.end());
            std::sort(nodes_.begin(), nodes_.end());
        }
    }

    /// Lines stay, what is between them begins anew: what was halved beside a corner may do without
    /// once the corner is apart. The first comes next, for parts are in order.
    void break_at(const std::vector<std::size_t>& lines, const LineRun& run) {
        std::size_t last = run.last;
        for (std::size_t i = lines.size(); i-- > 0;) {
            if (lines[i] + 1 < last) waiting_.push_back({lines[i] + 1, last});
            waiting_.push_back({lines[i], lines[i] + 1, true});
            last = lines[i];
        }
        if (run.first < last) waiting_.push_back({run.first, last});
    }

    void add_lines(const LineRun& run) {
        for (std::size_t i = run.first; i < run.last; ++i) add_line(i);
    }
    void add_line(std::size_t at) {
        const Vec3 delta = points_[at + 1] - points_[at];
        done_.push_back({at, at + 1, true, hermite(points_[at], delta, points_[at + 1], delta),
                         delta / width(at, at + 1)});
    }
    double width(std::size_t from, std::size_t to) const { return lengths_[to] - lengths_[from]; }

    bool begins_with_slope(const LineRun& run) const {
        return run.first == 0 && options_.first_slope.has_value();
    }

    /// No more than there have to be.
    void set_nodes(const LineRun& run) {
        nodes_ = {run.first};
        for (const std::size_t end : options_.ends) {
            if (end > run.first && end < run.last) nodes_.push_back(end);
        }
        nodes_.push_back(run.last);
    }

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

    /// Cubics through the nodes.
    void solve(const LineRun& run) {
        const std::size_t count = nodes_.size();
        std::vector<SplineNode> nodes;
        for (const std::size_t node : nodes_) nodes.push_back({lengths_[node], points_[node]});
        const auto forward = [&](std::size_t i) { return nodes[i]; };
        const auto backward = [&](std::size_t i) { return nodes[count - 1 - i]; };
        const Vec3 slope =
            begins_with_slope(run) ? *options_.first_slope : end_slope(forward, count);
        const auto slopes = complete_slopes(nodes, slope, end_slope(backward, count));
        parts_.clear();
        for (std::size_t i = 1; i < count; ++i) {
            const std::size_t from = nodes_[i - 1];
            const std::size_t to = nodes_[i];
            const double h = width(from, to);
            parts_.push_back({from, to, false,
                              hermite(points_[from], slopes[i - 1] * h, points_[to], slopes[i] * h),
                              slopes[i]});
        }
    }

    /// The point between both ends that is nearest to the middle of the path.
    std::size_t middle(const PolylinePart& part) const {
        const double half = (lengths_[part.from] + lengths_[part.to]) / 2;
        const auto begin = lengths_.begin() + static_cast<std::ptrdiff_t>(part.from) + 1;
        const auto end = lengths_.begin() + static_cast<std::ptrdiff_t>(part.to);
        const auto found = std::lower_bound(begin, end - 1, half);
        return static_cast<std::size_t>(found - lengths_.begin());
    }

    std::span<const Vec3> points_;
    const PolylineFitOptions& options_;
    std::vector<double> lengths_;      // of the polyline up to every point
    std::vector<LineRun> waiting_;     // the first one last
    std::vector<std::size_t> nodes_;   // of the run that is fitted; parts end there
    std::vector<PolylinePart> parts_;  // of it
    std::vector<PolylinePart> done_;
    std::size_t work_ = 0;  // lines that were fitted, each as often as it was
};

}  // namespace

std::vector<PolylinePart> fit_polyline(std::span<const Vec3> points,
                                       const PolylineFitOptions& options) {
    return Fit(points, options).run();
}

}  // namespace kadr::path
