#include "repl/sketch.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace kadr::repl {

namespace {

using path::Vec3;
using plot::PlotPiece;

constexpr std::size_t kMaxRows = 24;
constexpr int kRapidGap = 3;      // dots of a rapid stand this far apart
constexpr double kArcStep = 0.1;  // rad

/// A raster of dots; character cells are two dots wide and four high.
class Dots {
  public:
    Dots(std::size_t columns, std::size_t rows)
        : columns_(columns), rows_(rows), cells_(columns * rows) {}

    void set(long x, long y) {
        if (x < 0 || y < 0) return;
        const auto column = static_cast<std::size_t>(x / 2);
        const auto row = static_cast<std::size_t>(y / 4);
        if (column >= columns_ || row >= rows_) return;
        // Unicode numbers the dots of a cell down the left column, down the right one, and the
        // bottom row last.
        constexpr unsigned char kBits[4][2] = {
            {0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};
        cells_[row * columns_ + column] |= kBits[y % 4][x % 2];
    }

    std::string text() const {
        std::string out;
        for (std::size_t row = 0; row < rows_; ++row) {
            std::string line;
            for (std::size_t column = 0; column < columns_; ++column) {
                const unsigned cell = cells_[row * columns_ + column];
                // U+2800 and up, in UTF-8.
                line += static_cast<char>(0xe2);
                line += static_cast<char>(0xa0 + (cell >> 6));
                line += static_cast<char>(0x80 + (cell & 0x3f));
            }
            out += line + '\n';
        }
        return out;
    }

  private:
    std::size_t columns_;
    std::size_t rows_;
    std::vector<unsigned char> cells_;
};

class SketchPen {
  public:
    SketchPen(Dots& dots, const plot::SceneBox& box, double dots_per_mm, long height)
        : dots_(dots), box_(box), scale_(dots_per_mm), height_(height) {}

    void line(const Vec3& from, const Vec3& to, bool is_rapid) {
        const double x0 = x(from), y0 = y(from), x1 = x(to), y1 = y(to);
        const long steps =
            std::max(1L, std::lround(std::max(std::fabs(x1 - x0), std::fabs(y1 - y0))));
        for (long i = 0; i <= steps; ++i) {
            if (is_rapid && i % kRapidGap != 0) continue;
            const double share = static_cast<double>(i) / static_cast<double>(steps);
            dots_.set(std::lround(x0 + (x1 - x0) * share), std::lround(y0 + (y1 - y0) * share));
        }
    }

  private:
    double x(const Vec3& point) const { return (point.x() - box_.lower.x()) * scale_; }
    double y(const Vec3& point) const {
        return static_cast<double>(height_ - 1) - (point.y() - box_.lower.y()) * scale_;
    }

    Dots& dots_;
    const plot::SceneBox& box_;
    double scale_;
    long height_;
};

}  // namespace

std::string sketch(const plot::PlotScene& scene, std::size_t columns) {
    plot::SceneBox box = scene.feed_box();
    if (box.is_empty()) box = scene.rapid_box();
    if (box.is_empty()) return "nothing has moved\n";
    columns = std::clamp<std::size_t>(columns, 20, 100);
    const double width = std::max(box.upper.x() - box.lower.x(), 1e-9);
    const double height = std::max(box.upper.y() - box.lower.y(), 1e-9);
    constexpr double kLeast = 1e-6;  // mm: less is one point, a hole seen from above
    if (width < kLeast && height < kLeast)
        return fmt::format("at X {:g}, Y {:g} mm from Z {:g} to {:g} mm\n", box.lower.x(),
                           box.lower.y(), box.lower.z(), box.upper.z());
    const double scale = std::min((static_cast<double>(2 * columns) - 1) / width,
                                  (static_cast<double>(4 * kMaxRows) - 1) / height);
    const auto rows = static_cast<std::size_t>(std::ceil((height * scale + 1) / 4));
    const auto used = static_cast<std::size_t>(std::ceil((width * scale + 1) / 2));
    Dots dots(std::max<std::size_t>(used, 1), std::max<std::size_t>(rows, 1));
    SketchPen pen(dots, box, scale, static_cast<long>(4 * std::max<std::size_t>(rows, 1)));
    Vec3 at = Vec3::Zero();
    bool has_begun = false;
    for (const PlotPiece& piece : scene.pieces()) {
        const bool is_rapid = piece.kind == PlotPiece::Kind::Rapid;
        if (piece.kind != PlotPiece::Kind::Jump && has_begun) {
            if (piece.arc < 0) {
                pen.line(at, piece.to, is_rapid);
            } else {
                const plot::PlotArc& arc = scene.arc(piece);
                const int parts = std::max(2, static_cast<int>(std::fabs(arc.sweep) / kArcStep));
                Vec3 from = at;
                for (int i = 1; i <= parts; ++i) {
                    const Vec3 to =
                        plot::point_on_arc(arc, at, piece.to, static_cast<double>(i) / parts);
                    pen.line(from, to, is_rapid);
                    from = to;
                }
            }
        }
        at = piece.to;
        has_begun = true;
    }
    return dots.text() + fmt::format("X {:g} … {:g} mm, Y {:g} … {:g} mm\n", box.lower.x(),
                                     box.upper.x(), box.lower.y(), box.upper.y());
}

}  // namespace kadr::repl
