#include "plot/chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers.h"
#include "plot/svg_text.h"

namespace kadr::plot {

namespace {

constexpr double kGridAcross = 90;  // px between labelled lines, about
constexpr double kGridUp = 34;
constexpr double kFlat = 1e-9;
constexpr double kHeadroom = 0.06;  // share of the height above and below the curves

/// The numbers of a chart as positions on paper.
struct Scale {
    PlotFrame frame;
    double lower_across = 0;
    double lower_up = 0;
    double per_across = 1;  // px
    double per_up = 1;

    double x(double value) const { return frame.left + (value - lower_across) * per_across; }
    double y(double value) const { return frame.bottom() - (value - lower_up) * per_up; }
};

Scale scale_of(const Chart& chart) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const ChartLine& line : chart.lines) {
        for (std::size_t i = 0; i < line.up.size(); ++i) {
            if (line.across[i] < chart.lower || line.across[i] > chart.upper) continue;
            if (chart.most && line.up[i] > *chart.most) continue;
            low = std::min(low, line.up[i]);
            high = std::max(high, line.up[i]);
        }
    }
    if (!(low <= high)) low = high = 0;
    // What is flat but for rounding has no grid of its own.
    if (high - low < kFlat * std::max({1.0, std::abs(low), std::abs(high)})) high = low + 1;
    const double room = kHeadroom * (high - low);
    Scale scale;
    scale.frame = chart.frame;
    scale.lower_across = chart.lower;
    scale.lower_up = low - room;
    scale.per_across = chart.frame.width / (chart.upper - chart.lower);
    scale.per_up = chart.frame.height / (high - low + 2 * room);
    return scale;
}

std::string label(double value) { return fmt::format("{:.10g}", round_to(value, 6)); }

/// `least`: pixels that it is wide at least; 0: one that has no width is not drawn.
void draw_band(std::string& out, const Scale& scale, const Chart& chart, const ChartBand& band,
               const char* color, double least) {
    const PlotFrame& f = chart.frame;
    const double from = scale.x(std::max(band.from, chart.lower));
    const double width = std::max(scale.x(std::min(band.to, chart.upper)) - from, least);
    if (!(width > 0)) return;
    put(out, "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"/>\n",
        from, f.top, width, f.height, color);
}

void draw_grid(std::string& out, const Chart& chart, const Scale& scale) {
    const PlotFrame& f = chart.frame;
    put(out,
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"#ffffff\" "
        "stroke=\"#c3c8cf\"/>\n",
        f.left, f.top, f.width, f.height);
    for (const ChartBand& band : chart.bands) draw_band(out, scale, chart, band, "#eff2f6", 0);
    for (const ChartBand& band : chart.alerts)
        draw_band(out, scale, chart, band, kAlertGround, 1.5);
    const auto across =
        grid_values(chart.lower, chart.upper, round_step(kGridAcross / scale.per_across));
    const double upper_up = scale.lower_up + f.height / scale.per_up;
    auto up = grid_values(scale.lower_up, upper_up, round_step(kGridUp / scale.per_up));
    constexpr double kFiner = 2.5;
    if (up.size() < 3)
        up = grid_values(scale.lower_up, upper_up, round_step(kGridUp / scale.per_up / kFiner));
    put(out, "<path fill=\"none\" stroke=\"#e3e6ea\" d=\"");
    for (const double v : across) put(out, "M{:.1f} {:.1f}v{:.1f}", scale.x(v), f.top, f.height);
    for (const double v : up) put(out, "M{:.1f} {:.1f}h{:.1f}", f.left, scale.y(v), f.width);
    put(out, "\"/>\n<g font-size=\"11\" fill=\"{}\">\n", kSoft);
    for (const double v : up) {
        put(out, "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", f.left - 6,
            scale.y(v) + 4, label(v));
    }
    if (!chart.across.empty()) {
        for (const double v : across) {
            put(out, "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
                scale.x(v), f.bottom() + 15, label(v));
        }
        put(out, "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", f.right(),
            f.bottom() + 31, escaped(chart.across));
    }
    out += "</g>\n";
}

void draw_head(std::string& out, const Chart& chart) {
    const PlotFrame& f = chart.frame;
    put(out,
        "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"12\" font-weight=\"600\" "
        "fill=\"{}\">{}</text>\n",
        f.left, f.top - 7, kInk, escaped(chart.title));
    double right = f.right();
    for (auto line = chart.lines.rbegin(); line != chart.lines.rend(); ++line) {
        if (line->name.empty()) continue;
        put(out,
            "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"11\" text-anchor=\"end\" "
            "fill=\"{}\">{}</text>\n",
            right, f.top - 7, line->color, escaped(line->name));
        right -= 14 + 6 * static_cast<double>(line->name.size());
    }
}

/// A curve has many points to one pixel: of each pixel the first, the least, the greatest and the
/// last are drawn, so that no peak is lost.
class PixelLine {
  public:
    PixelLine(std::string& out, const Scale& scale) : out_(out), scale_(scale) {}

    void add(double across, double up) {
        const double x = scale_.x(across);
        const double y = scale_.y(up);
        const double column = std::floor(2 * x);
        if (!is_open_ || column != column_) {
            flush();
            column_ = column;
            first_ = least_ = greatest_ = y;
            x_ = x;
            is_open_ = true;
        }
        least_ = std::min(least_, y);
        greatest_ = std::max(greatest_, y);
        last_ = y;
    }
    void flush() {
        if (!is_open_) return;
        to(first_);
        if (least_ < std::min(first_, last_)) to(least_);
        if (greatest_ > std::max(first_, last_)) to(greatest_);
        if (last_ != first_) to(last_);
        is_open_ = false;
    }

  private:
    void to(double y) {
        put(out_, "{}{:.1f} {:.1f}", is_down_ ? 'L' : 'M', x_, y);
        is_down_ = true;
    }

    std::string& out_;
    const Scale& scale_;
    bool is_open_ = false;
    bool is_down_ = false;
    double column_ = 0;
    double x_ = 0;
    double first_ = 0, least_ = 0, greatest_ = 0, last_ = 0;
};

void draw_line(std::string& out, const Chart& chart, const ChartLine& line, const Scale& scale) {
    put(out,
        "<path fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"{} d=\"",
        line.color, line.is_dashed ? 1 : 1.6, line.is_dashed ? " stroke-dasharray=\"5 3\"" : "");
    PixelLine pen(out, scale);
    for (std::size_t i = 0; i < line.up.size(); ++i) {
        if (line.across[i] < chart.lower || line.across[i] > chart.upper) continue;
        pen.add(line.across[i], line.up[i]);
    }
    pen.flush();
    out += "\"/>\n";
}

constexpr double kBadge = 7.5;  // px, radius of the disc of a number

void draw_marks(std::string& out, const Chart& chart, const Scale& scale) {
    const PlotFrame& f = chart.frame;
    double free_from = f.left;
    for (const ChartMark& mark : chart.marks) {
        if (mark.across < chart.lower || mark.across > chart.upper) continue;
        const double x = scale.x(mark.across);
        put(out,
            "<path fill=\"none\" stroke=\"{}\" stroke-dasharray=\"2 3\" "
            "d=\"M{:.1f} {:.1f}v{:.1f}\"/>\n",
            kAlert, x, f.top, f.height);
        if (mark.name.empty()) continue;
        // Marks that stand close to each other have their numbers side by side.
        const double at = std::max(x, free_from);
        free_from = at + 2 * kBadge + 1;
        draw_badge(out, at, f.top - kBadge - 2, mark.name);
    }
}

}  // namespace

void draw_badge(std::string& out, double x, double y, const std::string& name) {
    put(out,
        "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"{2}\" fill=\"{3}\"/>\n"
        "<text x=\"{0:.1f}\" y=\"{4:.1f}\" font-size=\"10\" font-weight=\"600\" "
        "text-anchor=\"middle\" fill=\"#ffffff\">{5}</text>\n",
        x, y, kBadge, kAlert, y + 3.5, escaped(name));
}

void draw_chart(std::string& out, const Chart& chart) {
    const Scale scale = scale_of(chart);
    const PlotFrame& f = chart.frame;
    draw_grid(out, chart, scale);
    draw_head(out, chart);
    // Each chart has its position on paper: that names what its curves are cut off by.
    put(out,
        "<clipPath id=\"chart{0:.0f}-{1:.0f}\"><rect x=\"{0:.1f}\" y=\"{1:.1f}\" "
        "width=\"{2:.1f}\" height=\"{3:.1f}\"/></clipPath>\n"
        "<g clip-path=\"url(#chart{0:.0f}-{1:.0f})\">\n",
        f.left, f.top, f.width, f.height);
    for (const ChartLine& line : chart.lines) draw_line(out, chart, line, scale);
    out += "</g>\n";
    draw_marks(out, chart, scale);
}

}  // namespace kadr::plot
