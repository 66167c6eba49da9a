#include "plot/plot_colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "base/numbers.h"

namespace kadr::plot {

namespace {

// Told apart by people with colour-blindness too (after Okabe and Ito, darkened for a light
// ground).
constexpr std::array<const char*, 7> kDistinct = {"#0072b2", "#d55e00", "#00916a", "#b4518f",
                                                  "#b98a00", "#3f4a5a", "#2b9bd6"};
// From slow to fast, or from first to last: dark blue over green to orange.
constexpr std::array<const char*, 7> kRamp = {"#2c3e91", "#2467ac", "#16899f", "#27a077",
                                              "#7fae3a", "#d09a1c", "#e06a1b"};

std::string short_number(double value) { return format_shortest(round_to(value, 3)); }

/// A limit of a group: nobody needs its decimals.
double rounded(double value) { return round_to(value, value < 20 ? 2 : 0); }

std::string range_label(PlotColor color, double from, double to) {
    const std::string text =
        from == to ? short_number(from) : short_number(from) + " to " + short_number(to);
    return color == PlotColor::Line ? (from == to ? "line " : "lines ") + text : text;
}

/// Groups of equally many different feeds: a single fast move does not swallow the scale.
std::vector<LegendEntry> feed_groups(const std::vector<double>& sorted) {
    std::vector<LegendEntry> legend;
    for (std::size_t i = 0; i < kRamp.size(); ++i) {
        const double first = sorted[i * sorted.size() / kRamp.size()];
        const double last = sorted[(i + 1) * sorted.size() / kRamp.size() - 1];
        legend.push_back(
            {kRamp[i], range_label(PlotColor::Feed, rounded(first), rounded(last)), last});
    }
    return legend;
}

/// Equal shares of the program from its first to its last line.
std::vector<LegendEntry> line_groups(double first, double last) {
    std::vector<LegendEntry> legend;
    const double share = (last - first + 1) / static_cast<double>(kRamp.size());
    double from = first;
    for (const char* color : kRamp) {
        const double to = std::round(first + share * static_cast<double>(legend.size() + 1)) - 1;
        legend.push_back({color, range_label(PlotColor::Line, from, to), to});
        from = to + 1;
    }
    return legend;
}

}  // namespace

std::vector<LegendEntry> legend_of(const PlotScene& scene, PlotColor color) {
    std::set<double> shades;
    for (const PlotPiece& piece : scene.pieces()) {
        if (piece.kind == PlotPiece::Kind::Feed) shades.insert(piece.shade);
    }
    std::vector<LegendEntry> legend;
    if (shades.size() <= kDistinct.size()) {
        for (const double shade : shades) {
            // What only rounding of the path makes different is one feed.
            constexpr double kSame = 1e-4;
            const bool is_same = color == PlotColor::Feed && !legend.empty() &&
                                 shade - legend.back().upper < kSame * shade;
            if (is_same) {
                legend.back().upper = shade;
                continue;
            }
            const std::size_t i = legend.size();
            legend.push_back({color == PlotColor::Line ? kRamp[i] : kDistinct[i],
                              range_label(color, shade, shade), shade});
        }
        return legend;
    }
    const std::vector<double> sorted(shades.begin(), shades.end());
    return color == PlotColor::Line ? line_groups(sorted.front(), sorted.back())
                                    : feed_groups(sorted);
}

const LegendEntry& entry_for(const std::vector<LegendEntry>& legend, double shade) {
    const auto found = std::find_if(legend.begin(), legend.end(),
                                    [shade](const LegendEntry& e) { return shade <= e.upper; });
    return found == legend.end() ? legend.back() : *found;
}

}  // namespace kadr::plot
