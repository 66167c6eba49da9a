#include "plot/plot_svg.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "base/numbers.h"
#include "plot/plot_colors.h"
#include "plot/plot_layout.h"
#include "plot/svg_text.h"

namespace kadr::plot {

namespace {

using path::Vec3;

constexpr double kFlatStep = 0.06;    // rad between the points of an arc that is drawn as a line
constexpr double kArcMismatch = 0.4;  // pixels by which the radii of a drawn arc may differ
constexpr double kPoint = 0.5;        // pixels that look like a point

std::string mm(double value) { return format_shortest(round_to(value, 3)); }

// ------------------------------------------------------------------------------- grid and scales

void draw_lines(std::string& out, const View& view, double step, const char* color, double width) {
    const PlotFrame& f = view.frame;
    put(out, "<path fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" d=\"", color, width);
    for (const double v :
         grid_values(view.lower_across, view.lower_across + f.width / view.scale, step)) {
        put(out, "M{:.1f} {:.1f}v{:.1f}", view.x(v), f.top, f.height);
    }
    for (const double v : grid_values(view.lower_up, view.lower_up + f.height / view.scale, step)) {
        put(out, "M{:.1f} {:.1f}h{:.1f}", f.left, view.y(v), f.width);
    }
    out += "\"/>\n";
}

void draw_zero_lines(std::string& out, const View& view) {
    const PlotFrame& f = view.frame;
    put(out, "<path fill=\"none\" stroke=\"#aab1ba\" stroke-width=\"1.1\" d=\"");
    if (const double x = view.x(0); x >= f.left && x <= f.right()) {
        put(out, "M{:.1f} {:.1f}v{:.1f}", x, f.top, f.height);
    }
    if (const double y = view.y(0); y >= f.top && y <= f.bottom()) {
        put(out, "M{:.1f} {:.1f}h{:.1f}", f.left, y, f.width);
    }
    out += "\"/>\n";
}

void draw_labels(std::string& out, const View& view, double step) {
    const PlotFrame& f = view.frame;
    put(out, "<g font-size=\"11\" fill=\"{}\">\n", kSoft);
    for (const double v :
         grid_values(view.lower_across, view.lower_across + f.width / view.scale, step)) {
        put(out, "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", view.x(v),
            f.bottom() + 14, mm(v));
    }
    for (const double v : grid_values(view.lower_up, view.lower_up + f.height / view.scale, step)) {
        put(out, "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", f.left - 6,
            view.y(v) + 4, mm(v * view.up_given));
    }
    out += "</g>\n";
    put(out,
        "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"12\" font-weight=\"600\" "
        "fill=\"{}\">{}</text>\n",
        f.left, f.top - 7, kInk, view.name);
}

/// Name, edge, and in a corner where the axes go.
void draw_isometric_paper(std::string& out, const View& view) {
    constexpr double kArrow = 34;   // pixels
    constexpr double kCorner = 56;  // of the axes, from the edges of the frame
    const PlotFrame& f = view.frame;
    put(out,
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" "
        "stroke=\"#c3c8cf\"/>\n"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"12\" font-weight=\"600\" "
        "fill=\"{}\">{}</text>\n",
        f.left, f.top, f.width, f.height, f.left, f.top - 7, kInk, view.name);
    for (int axis = 0; axis < 3; ++axis) {
        const double across = kArrow * view.rightwards()[axis];
        const double down = -kArrow * view.upwards()[axis];
        const double x = f.left + kCorner;
        const double y = f.bottom() - kCorner;
        put(out,
            "<path d=\"M{:.1f} {:.1f}l{:.1f} {:.1f}\" stroke=\"{}\" fill=\"none\" "
            "marker-end=\"url(#tip)\"/>\n"
            "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"11\" text-anchor=\"middle\" "
            "fill=\"{}\">{}</text>\n",
            x, y, across, down, kSoft, x + 1.4 * across, y + 1.4 * down + 4, kSoft, "XYZ"[axis]);
    }
}

void draw_paper(std::string& out, const View& view, const PlotLayout& layout) {
    const PlotFrame& f = view.frame;
    put(out,
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"#ffffff\"/>\n",
        f.left, f.top, f.width, f.height);
    if (view.is_isometric) return draw_isometric_paper(out, view);
    draw_lines(out, view, layout.grid / 5, "#f1f2f4", 0.8);
    draw_lines(out, view, layout.grid, "#dfe2e6", 1);
    draw_zero_lines(out, view);
    put(out,
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" "
        "stroke=\"#c3c8cf\"/>\n",
        f.left, f.top, f.width, f.height);
    draw_labels(out, view, layout.grid);
}

// ------------------------------------------------------------------------------------ dimensions

/// A dimension line with arrows at both ends and the length over it.
void draw_dimension_across(std::string& out, const View& view, double from, double to, double y) {
    const double a = view.x(from);
    const double b = view.x(to);
    put(out,
        "<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"{}\" fill=\"none\" marker-start=\"url(#tip)\" "
        "marker-end=\"url(#tip)\"/>\n",
        a, y, b, kInk);
    put(out, "<path d=\"M{0:.1f} {2:.1f}v10M{1:.1f} {2:.1f}v10\" stroke=\"{3}\" fill=\"none\"/>\n",
        a, b, y - 5, kInk);
    put(out,
        "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"13\" text-anchor=\"middle\" fill=\"{}\" "
        "class=\"halo wide\">{}</text>\n",
        (a + b) / 2, y + 4.5, kInk, mm(to - from));
}

void draw_dimension_up(std::string& out, const View& view, double from, double to, double x) {
    const double a = view.y(from);
    const double b = view.y(to);
    put(out,
        "<path d=\"M{:.1f} {:.1f}V{:.1f}\" stroke=\"{}\" fill=\"none\" marker-start=\"url(#tip)\" "
        "marker-end=\"url(#tip)\"/>\n",
        x, a, b, kInk);
    put(out, "<path d=\"M{2:.1f} {0:.1f}h10M{2:.1f} {1:.1f}h10\" stroke=\"{3}\" fill=\"none\"/>\n",
        a, b, x - 5, kInk);
    put(out,
        "<text transform=\"translate({:.1f} {:.1f}) rotate(-90)\" font-size=\"13\" "
        "text-anchor=\"middle\" fill=\"{}\" class=\"halo wide\">{}</text>\n",
        x + 4.5, (a + b) / 2, kInk, mm((to - from) * view.up_given));
}

void draw_dimensions(std::string& out, const PlotLayout& layout, const SceneBox& part) {
    constexpr double kOutside = 32;  // pixels between a view and its dimension
    if (part.is_empty()) return;
    const auto across = [&](const View& view) {
        const double from = part.lower[view.across];
        const double to = part.upper[view.across];
        if (from < to) draw_dimension_across(out, view, from, to, view.frame.bottom() + kOutside);
    };
    const auto upwards = [&](const View& view) {
        const double from = part.lower[view.up];
        const double to = part.upper[view.up];
        if (from < to) draw_dimension_up(out, view, from, to, view.frame.left - kOutside - 20);
    };
    across(layout.views[0]);
    upwards(layout.views[0]);
    if (layout.views.size() > 1) upwards(layout.views[1]);
}

// ------------------------------------------------------------------------------------------ path

/// Draws the pieces of one view; neighbours of one look share an element.
class Pen {
  public:
    Pen(std::string& out, const View& view) : out_(out), view_(view) {}
    ~Pen() { lift(); }
    Pen(const Pen&) = delete;
    Pen& operator=(const Pen&) = delete;

    void set_style(const std::string& style) {
        if (style == style_) return;
        lift();
        style_ = style;
    }
    void line(const Vec3& from, const Vec3& to) {
        begin(from);
        draw_to(to);
    }
    void arc(const PlotArc& arc, const Vec3& from, const Vec3& to);

  private:
    void begin(const Vec3& from) {
        if (!is_down_) put(out_, "<path {} d=\"", style_);
        if (!is_down_ || from != at_) put(out_, "M{:.2f} {:.2f}", view_.x(from), view_.y(from));
        is_down_ = true;
    }
    void draw_to(const Vec3& to) {
        put(out_, "L{:.2f} {:.2f}", view_.x(to), view_.y(to));
        at_ = to;
    }
    void round_to_point(const PlotArc& arc, const Vec3& to, double radius, double sweep) {
        const bool is_ccw = arc.normal.dot(view_.towards_eye()) > 0;
        put(out_, "A{0:.2f} {0:.2f} 0 {1} {2} {3:.2f} {4:.2f}", radius * view_.scale,
            sweep > std::numbers::pi ? 1 : 0, is_ccw ? 0 : 1, view_.x(to), view_.y(to));
        at_ = to;
    }
    void lift() {
        if (is_down_) out_ += "\"/>\n";
        is_down_ = false;
    }

    std::string& out_;
    const View& view_;
    std::string style_;
    bool is_down_ = false;
    Vec3 at_ = Vec3::Zero();
};

void Pen::arc(const PlotArc& arc, const Vec3& from, const Vec3& to) {
    begin(from);
    const double start_radius =
        (from - arc.center - arc.normal * (from - arc.center).dot(arc.normal)).norm();
    const double end_radius =
        (to - arc.center - arc.normal * (to - arc.center).dot(arc.normal)).norm();
    const bool is_round = std::abs(arc.normal.dot(view_.towards_eye())) > 1 - 1e-9 &&
                          std::abs(start_radius - end_radius) * view_.scale < kArcMismatch;
    if (!is_round) {
        const int steps = std::max(2, static_cast<int>(std::min(arc.sweep / kFlatStep, 2000.0)));
        for (int i = 1; i < steps; ++i) {
            draw_to(point_on_arc(arc, from, to, static_cast<double>(i) / steps));
        }
        draw_to(to);
        return;
    }
    // An SVG arc is less than one turn: long ones are drawn in thirds of a turn, and what runs over
    // itself is drawn once.
    const double shown = std::min(arc.sweep, 2 * std::numbers::pi);
    const int parts = shown > 1.9 * std::numbers::pi ? 3 : 1;
    const PlotArc first_turn{arc.center, arc.normal, shown};
    for (int i = 1; i < parts; ++i) {
        round_to_point(arc, point_on_arc(first_turn, from, to, static_cast<double>(i) / parts),
                       start_radius, shown / parts);
    }
    const Vec3 end = arc.sweep > shown ? point_on_arc(first_turn, from, to, 1) : to;
    round_to_point(arc, end, start_radius, shown / parts);
}

/// A straight piece that goes into the paper, as a drilled hole in the plan view.
bool is_plunge(const PlotPiece& piece, const Vec3& from, const View& view) {
    const double seen =
        std::hypot(view.x(piece.to) - view.x(from), view.y(piece.to) - view.y(from));
    return piece.arc < 0 && seen < kPoint && (piece.to - from).norm() * view.scale > 4 * kPoint;
}

std::string style_of(const PlotPiece& piece, bool is_dot, const std::vector<LegendEntry>& legend) {
    if (piece.kind == PlotPiece::Kind::Rapid) return "class=\"rapid\"";
    return std::string(is_dot ? "class=\"feed dot\"" : "class=\"feed\"") + " stroke=\"" +
           entry_for(legend, piece.shade).color + '"';
}

/// The lines of a view that were drawn. Dashes over dashes make a solid line, so that a rapid to
/// and fro is drawn once.
class DrawnLines {
  public:
    bool is_new(const View& view, const Vec3& a, const Vec3& b) {
        const auto place = [&view](const Vec3& p) {
            return Point(std::lround(view.x(p)), std::lround(view.y(p)));
        };
        const Point from = place(a);
        const Point to = place(b);
        return from != to && lines_.emplace(std::min(from, to), std::max(from, to)).second;
    }

  private:
    using Point = std::pair<long, long>;
    std::set<std::pair<Point, Point>> lines_;
};

void draw_path(std::string& out, const View& view, const PlotScene& scene,
               const std::vector<LegendEntry>& legend, PlotPiece::Kind kind) {
    const bool has_dots = view.towards_eye().z() > 0;  // a hole is a dot from above
    Pen pen(out, view);
    DrawnLines drawn;
    Vec3 at = Vec3::Zero();
    for (const PlotPiece& piece : scene.pieces()) {
        const Vec3 from = std::exchange(at, piece.to);
        if (piece.kind != kind) continue;
        if (kind == PlotPiece::Kind::Rapid && !drawn.is_new(view, from, piece.to)) continue;
        pen.set_style(style_of(piece, has_dots && is_plunge(piece, from, view), legend));
        if (piece.arc >= 0) pen.arc(scene.arc(piece), from, piece.to);
        else pen.line(from, piece.to);
    }
}

/// A name beside a mark, on the side where the frame has room, and inside of it from top to bottom.
void draw_name(std::string& out, const View& view, const Vec3& at, const char* color,
               const char* name) {
    constexpr double kLetter = 7;  // px, a generous mean of the letters
    constexpr double kGap = 9;     // from the middle of the mark
    constexpr double kHeight = 14;
    const PlotFrame& frame = view.frame;
    const double room = kGap + kLetter * static_cast<double>(std::string_view(name).size());
    const double to_right = frame.right() - view.x(at);
    const bool is_left = to_right < room && view.x(at) - frame.left > to_right;
    const double above = view.y(at) - 6;
    const double y = above - kHeight < frame.top ? view.y(at) + kHeight : above;
    put(out,
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" class=\"halo mark\" "
        "fill=\"{}\">{}</text>\n",
        view.x(at) + (is_left ? -kGap : kGap), y, is_left ? "end" : "start", color, name);
}

void draw_marks(std::string& out, const View& view, const PlotScene& scene, bool has_names) {
    const Vec3& start = scene.pieces().front().to;
    const Vec3& end = scene.pieces().back().to;
    put(out, "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"5\" class=\"start\"/>\n", view.x(start),
        view.y(start));
    put(out, "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"8\" height=\"8\" class=\"end\"/>\n",
        view.x(end) - 4, view.y(end) - 4);
    if (!has_names) return;
    const bool apart = std::hypot(view.x(start) - view.x(end), view.y(start) - view.y(end)) > 24;
    draw_name(out, view, start, "#1e7d43", apart ? "start" : "start, end");
    if (apart) draw_name(out, view, end, "#b3261e", "end");
}

/// What the views show.
struct SvgPicture {
    const PlotScene& scene;
    const std::vector<LegendEntry>& legend;
    std::span<const PlotTool> tools;
};

/// The tool as a line from the tip, where it has moved or turned enough since the last one.
void draw_tools(std::string& out, const View& view, const SvgPicture& picture) {
    constexpr double kApart = 9;  // pixels between two of them, at either end
    if (picture.tools.empty()) return;
    const double length = tool_length(picture.scene);
    double last_x = 0, last_y = 0, last_top_x = 0, last_top_y = 0;
    bool has_any = false;
    put(out, "<path class=\"tool\" d=\"");
    for (const PlotTool& tool : picture.tools) {
        const Vec3 top = tool.tip + length * tool.direction;
        const double x = view.x(tool.tip), y = view.y(tool.tip);
        const double top_x = view.x(top), top_y = view.y(top);
        const bool is_near = std::hypot(x - last_x, y - last_y) < kApart &&
                             std::hypot(top_x - last_top_x, top_y - last_top_y) < kApart;
        if (has_any && is_near) continue;
        has_any = true;
        last_x = x, last_y = y, last_top_x = top_x, last_top_y = top_y;
        put(out, "M{:.1f} {:.1f}L{:.1f} {:.1f}", x, y, top_x, top_y);
    }
    out += "\"/>\n";
}

void draw_view(std::string& out, const PlotLayout& layout, std::size_t index,
               const SvgPicture& picture) {
    const PlotScene& scene = picture.scene;
    const std::vector<LegendEntry>& legend = picture.legend;
    const View& view = layout.views[index];
    const PlotFrame& f = view.frame;
    draw_paper(out, view, layout);
    put(out,
        "<clipPath id=\"view{}\"><rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
        "height=\"{:.1f}\"/>"
        "</clipPath>\n<g clip-path=\"url(#view{})\">\n",
        index, f.left, f.top, f.width, f.height, index);
    draw_path(out, view, scene, legend, PlotPiece::Kind::Rapid);
    draw_tools(out, view, picture);
    draw_path(out, view, scene, legend, PlotPiece::Kind::Feed);
    if (!scene.pieces().empty()) draw_marks(out, view, scene, index == 0);
    out += "</g>\n";
}

// ---------------------------------------------------------------------------------------- legend

void draw_legend(std::string& out, const PlotLayout& layout, const SvgPicture& picture,
                 const PlotText& text, PlotColor color) {
    const PlotScene& scene = picture.scene;
    const double left = layout.legend.left;
    double y = layout.legend.top + 4;
    const auto row = [&](const std::string& style, const std::string& label) {
        y += 19;
        put(out, "<path {} d=\"M{:.1f} {:.1f}h30\"/>\n", style, left, y - 4);
        put(out, "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"12\" fill=\"{}\">{}</text>\n",
            left + 40, y, kInk, escaped(label));
    };
    put(out,
        "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"12\" font-weight=\"600\" "
        "fill=\"{}\">{}</text>\n",
        left, y, kInk,
        color == PlotColor::Feed ? "Feed, " + text.feed_unit : "Line of the program");
    for (const LegendEntry& entry : picture.legend) {
        row("class=\"feed legend\" stroke=\"" + entry.color + '"', entry.label);
    }
    if (!scene.rapid_box().is_empty()) row("class=\"rapid\"", "rapid");
    if (!picture.tools.empty()) row("class=\"tool\"", "tool, from its tip");
    y += 8;
    for (const std::string& line :
         {std::string("dimensions of the cut, mm"), "grid " + mm(layout.grid) + " mm"}) {
        y += 16;
        put(out, "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"11\" fill=\"{}\">{}</text>\n", left,
            y, kSoft, line);
    }
}

constexpr const char* kStyle = R"(<style>
text { font-family: "Inter", "Segoe UI", "DejaVu Sans", "Liberation Sans", Arial, sans-serif; }
.feed { fill: none; stroke-width: 1.5; stroke-linejoin: round; stroke-linecap: round; }
.dot { stroke-width: 4.5; }
.legend { stroke-width: 3; }
.rapid { fill: none; stroke: #9aa3ad; stroke-width: 1; stroke-dasharray: 5 4; }
.start { fill: #ffffff; stroke: #1e7d43; stroke-width: 2.2; }
.end { fill: #b3261e; stroke: #ffffff; stroke-width: 1; }
.mark { font-size: 12px; font-weight: 600; }
.halo { paint-order: stroke; stroke: #f7f8f9; stroke-width: 5px; stroke-linejoin: round; }
.wide { stroke-width: 9px; }
</style>
<defs><marker id="tip" viewBox="0 0 10 10" refX="10" refY="5" markerWidth="9" markerHeight="9" orient="auto-start-reverse"><path d="M0 2L10 5L0 8z" fill="#2d3138"/></marker></defs>
)";

constexpr const char* kToolStyle =
    "<style>.tool { fill: none; stroke: #b3261e; stroke-width: 0.7; opacity: 0.6; }</style>\n";

}  // namespace

std::string plot_svg(const PlotScene& scene, const PlotText& text, PlotColor color,
                     std::span<const PlotTool> tools) {
    PlotLayout layout = lay_out(scene, tools);
    for (View& view : layout.views) {
        if (!text.has_diameters || view.up != 0 || view.is_isometric) continue;
        view.up_given = 2;
        view.name += ", X as diameters";
    }
    const std::vector<LegendEntry> legend = legend_of(scene, color);
    const SvgPicture picture{scene, legend, tools};
    std::string out;
    put_start(out, layout.width, layout.height);
    put(out, "<title>{}</title>\n", escaped(text.title));
    out += kStyle;
    if (!tools.empty()) out += kToolStyle;
    put(out, "<rect width=\"100%\" height=\"100%\" fill=\"#f7f8f9\"/>\n");
    put_title(out, text.title, text.subtitle, text.warning);
    for (std::size_t i = 0; i < layout.views.size(); ++i) draw_view(out, layout, i, picture);
    draw_dimensions(out, layout, scene.feed_box());
    draw_legend(out, layout, picture, text, color);
    out += "</svg>\n";
    return out;
}

}  // namespace kadr::plot
