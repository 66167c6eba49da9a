// Arcs on the grid of the text: whatever radius, opening and gap, the control goes the circle that
// is meant. The text is read here by a small reader of its own, which knows G0 to G3, G17 to G19,
// I, J, K, R and CR, and what two kinds of controls make of radii that differ (S 4.2, F 3.5).
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <numbers>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include "tests/common/scratch.h"
#include "tests/nc/nc_testing.h"
#include "write/writer.h"

namespace kadr::write::arc_text_test {

using namespace nc;
namespace testing = nc::testing;

namespace {

using Point = std::array<double, 3>;
constexpr double kTurn = 2 * std::numbers::pi;

/// A control as this test needs it.
struct Control {
    std::string name;
    double increment = 1e-3;         // of the coordinates
    double center_increment = 1e-3;  // of I, J, K
    bool shifts_center = false;      // onto the bisector of the ends, at the radius of the start
    bool has_coordinate_centers = false;
    bool has_centers = true;
    bool says_diameter = false;  // a word for it, DIAMOF
    bool is_lathe = false;       // X is a diameter, and the plane is ZX
    double inch_ratio = 10;      // an increment in inches is so much smaller a number
    double inch_center_ratio = 10;
};

/// One motion of the text.
struct Motion {
    int code = 0;
    Point from{}, to{};
    std::array<std::size_t, 3> axes = {0, 1, 2};
    std::optional<std::array<double, 2>> center;
    std::optional<double> radius;
    double turns = 0;
};

/// Reads a text, without modal words that the test does not write.
class TextReader {
  public:
    TextReader(const Control& control, double unit) : control_(control), unit_(unit) {
        if (control.is_lathe) axes_ = {2, 0, 1};
    }

    std::vector<Motion> read(std::string_view text) {
        std::vector<Motion> motions;
        while (!text.empty()) {
            const std::size_t end = std::min(text.find('\n'), text.size() - 1);
            read_line(text.substr(0, end), motions);
            text.remove_prefix(end + 1);
        }
        return motions;
    }

  private:
    void read_line(std::string_view line, std::vector<Motion>& motions) {
        if (line.starts_with('%') || line.starts_with('O')) return;
        const std::map<std::string, double> words = words_of(line);
        Motion motion;
        motion.from = at_;
        for (const char axis : {'X', 'Y', 'Z'}) {
            const auto word = words.find(std::string(1, axis));
            if (word == words.end()) continue;
            const bool is_diameter = axis == 'X' && control_.is_lathe;
            at_[static_cast<std::size_t>(axis - 'X')] =
                word->second * unit_ * (is_diameter ? 0.5 : 1);
        }
        motion.to = at_;
        motion.code = code_;
        motion.axes = axes_;
        std::array<double, 2> center{};
        bool has_center = false;
        for (std::size_t i = 0; i < 2; ++i) {
            const std::size_t axis = axes_[i];
            const auto word = words.find(std::string(1, "IJK"[axis]));
            center[i] = control_.has_coordinate_centers ? center_[axis] : motion.from[axis];
            if (word == words.end()) continue;
            has_center = true;
            center[i] =
                word->second * unit_ + (control_.has_coordinate_centers ? 0 : motion.from[axis]);
            center_[axis] = center[i];
        }
        if (has_center) motion.center = center;
        for (const char* name : {"R", "CR"}) {
            if (words.contains(name)) motion.radius = words.at(name) * unit_;
        }
        if (words.contains("TURN")) motion.turns = words.at("TURN");
        const bool moves = words.contains("X") || words.contains("Y") || words.contains("Z") ||
                           has_center || motion.radius;
        if (moves) motions.push_back(motion);
    }

    std::map<std::string, double> words_of(std::string_view line) {
        std::map<std::string, double> words;
        for (std::size_t i = 0; i < line.size();) {
            if (line[i] == '(' || line[i] == ';') break;  // a comment
            std::string name;
            while (i < line.size() && line[i] >= 'A' && line[i] <= 'Z') name += line[i++];
            if (name.empty()) {
                ++i;
                continue;
            }
            if (i < line.size() && line[i] == '=') ++i;
            const std::string rest(line.substr(i));
            char* end = nullptr;
            const double number = std::strtod(rest.c_str(), &end);
            i += static_cast<std::size_t>(end - rest.c_str());
            if (name == "G") take_code(static_cast<int>(number));
            else words[name] = number;
        }
        return words;
    }

    void take_code(int code) {
        if (code <= 3) code_ = code;
        if (code == 17) axes_ = {0, 1, 2};
        if (code == 18) axes_ = {2, 0, 1};
        if (code == 19) axes_ = {1, 2, 0};
    }

    const Control& control_;
    double unit_;  // mm
    int code_ = 0;
    Point at_{};
    Point center_{};
    std::array<std::size_t, 3> axes_ = {0, 1, 2};
};

/// What is meant: an arc about a centre in a plane, or a helix.
struct Meant {
    std::array<std::size_t, 3> axes = {0, 1, 2};
    std::array<double, 2> center{};
    double radius = 0, start = 0, sweep = 0, height = 0;
    bool is_clockwise = false;

    Point at(double share) const {
        const double angle = start + (is_clockwise ? -sweep : sweep) * share;
        Point point{};
        point[axes[0]] = center[0] + radius * std::cos(angle);
        point[axes[1]] = center[1] + radius * std::sin(angle);
        point[axes[2]] = height * share;
        return point;
    }
};

/// How a control goes a motion of the text.
struct Way {
    std::array<double, 2> center{};
    double first = 0, last = 0;  // radii
    double start = 0, sweep = 0;
};

Way way_of(const Motion& motion, const Control& control) {
    const std::array<double, 2> a = {motion.from[motion.axes[0]], motion.from[motion.axes[1]]};
    const std::array<double, 2> b = {motion.to[motion.axes[0]], motion.to[motion.axes[1]]};
    const double dx = b[0] - a[0];
    const double dy = b[1] - a[1];
    const double chord = std::hypot(dx, dy);
    const double side = motion.code == 2 ? -1 : 1;
    Way way;
    const auto on_bisector = [&](double radius, double left) {
        const double height = std::sqrt(std::max(0.0, radius * radius - chord * chord / 4));
        return std::array{(a[0] + b[0]) / 2 - left * height * dy / chord,
                          (a[1] + b[1]) / 2 + left * height * dx / chord};
    };
    if (motion.radius) {
        way.center = on_bisector(std::abs(*motion.radius), *motion.radius < 0 ? -side : side);
    } else {
        way.center = *motion.center;
        const double first = std::hypot(a[0] - way.center[0], a[1] - way.center[1]);
        const double last = std::hypot(b[0] - way.center[0], b[1] - way.center[1]);
        if (control.shifts_center && std::abs(first - last) > 1e-9 && chord > 0) {
            const double left = dx * (way.center[1] - a[1]) - dy * (way.center[0] - a[0]);
            way.center = on_bisector(std::max(first, chord / 2), left < 0 ? -1 : 1);
        }
    }
    way.first = std::hypot(a[0] - way.center[0], a[1] - way.center[1]);
    way.last = std::hypot(b[0] - way.center[0], b[1] - way.center[1]);
    way.start = std::atan2(a[1] - way.center[1], a[0] - way.center[0]);
    const double end = std::atan2(b[1] - way.center[1], b[0] - way.center[0]);
    way.sweep = std::fmod(side * (end - way.start) + 2 * kTurn, kTurn);
    if (chord == 0) way.sweep = kTurn;
    return way;
}

enum class Said { ByCenter, ByRadius };

/// What the text says against what is meant; an empty text: all is well.
std::string difference(const std::vector<Motion>& motions, const Meant& meant, Said said,
                       const Control& control) {
    double increment = std::max(control.increment, control.center_increment);
    // What binary numbers leave of a centre that follows from a radius near half a turn.
    if (said == Said::ByRadius) increment += 5e-8 * meant.radius;
    const double round = control.increment / 2 * 1.001 + 1e-12;
    const auto misses = [&](const Point& a, const Point& b) {
        return std::abs(a[0] - b[0]) > round || std::abs(a[1] - b[1]) > round ||
               std::abs(a[2] - b[2]) > round;
    };
    if (motions.empty()) return "nothing is written";
    if (misses(motions.front().from, meant.at(0))) return "begins elsewhere";
    if (misses(motions.back().to, meant.at(1))) return "ends elsewhere";
    double swept = 0;
    double error = 0;
    double lift = 0;
    bool by_radius = false;
    for (const Motion& motion : motions) {
        if (motion.code < 2) {  // too small for an arc
            // … or the half of one that is nowhere beside its line.
            const double part = std::hypot(motion.to[meant.axes[0]] - motion.from[meant.axes[0]],
                                           motion.to[meant.axes[1]] - motion.from[meant.axes[1]]);
            const bool is_flat = part * part / (8 * meant.radius) < increment / 3;
            const bool is_small = meant.radius * meant.sweep <= 4 * increment;
            if (!is_small && meant.radius > 2 * increment && !is_flat) return "a line";
            return {};
        }
        if ((motion.code == 2) != meant.is_clockwise) return "the wrong way";
        by_radius |= motion.radius.has_value();
        const Way way = way_of(motion, control);
        if (control.has_centers) {
            const auto& center = motion.center ? *motion.center : way.center;
            const double beside =
                std::hypot(center[0] - meant.center[0], center[1] - meant.center[1]);
            if (beside > increment * 1.001)
                return "the centre is " + std::to_string(1000 * beside) + " um off";
        }
        for (int i = 0; i <= 200; ++i) {
            const double share = i / 200.0;
            const double angle = way.start + (motion.code == 2 ? -1 : 1) * way.sweep * share;
            const double radius = way.first + (way.last - way.first) * share;
            const double x = way.center[0] + radius * std::cos(angle) - meant.center[0];
            const double y = way.center[1] + radius * std::sin(angle) - meant.center[1];
            error = std::max(error, std::abs(std::hypot(x, y) - meant.radius));
            const double turned = (motion.turns * kTurn + way.sweep) * share + swept;
            const std::size_t third = motion.axes[2];
            const double z = motion.from[third] + (motion.to[third] - motion.from[third]) * share;
            lift = std::max(lift, std::abs(z - meant.height * turned / meant.sweep));
        }
        swept += motion.turns * kTurn + way.sweep;
    }
    // Both ends and the centre are rounded; a control that moves a coarse centre makes it worse.
    const bool is_coarse = control.center_increment > control.increment / 2;
    const double most = !control.shifts_center || by_radius ? 2.3 * increment
                        : is_coarse                         ? 3.2 * increment
                                    : control.increment + control.center_increment;
    if (error > most * 1.001) return "leaves the circle by " + std::to_string(1000 * error) + " um";
    // By radius alone three parts have three roundings.
    const double angle = (control.has_centers ? 8 : 24) * increment / meant.radius;
    if (std::abs(swept - meant.sweep) > angle)
        return "turns " + std::to_string(swept) + " instead of " + std::to_string(meant.sweep);
    if (lift > round + 2 * std::abs(meant.height) * angle / meant.sweep) return "another helix";
    return {};
}

/// The line of the start at rapid, and those of the arc.
std::string written(const Dialect& dialect, const Control& control, const Meant& meant, Said said,
                    bool is_inch, std::string& codes) {
    DiagnosticList sink;
    Writer writer(dialect, {.number_blocks = false}, sink);
    std::string text;
    writer.begin({"arcs", 1, "", is_inch}, text);
    writer.write({}, text);  // brings the safety line
    text.clear();
    const auto put = [&](Block& block, double share) {
        const Point point = meant.at(share);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (control.is_lathe && axis == 1) continue;
            const bool is_diameter = control.is_lathe && axis == 0;
            block.set(static_cast<Slot>(axis), point[axis] * (is_diameter ? 2 : 1));
        }
    };
    constexpr std::array kPlanes = {Function::PlaneYz, Function::PlaneZx, Function::PlaneXy};
    Block first;
    first.motion = Function::Rapid;
    first.add(kPlanes[meant.axes[2]]);
    if (dialect.can_write(Function::DiameterOff)) first.add(Function::DiameterOff);
    put(first, 0);
    writer.write(first, text);
    Block arc;
    arc.motion = meant.is_clockwise ? Function::ArcCw : Function::ArcCcw;
    put(arc, 1);
    if (said == Said::ByRadius) {
        arc.set(Slot::Radius, meant.sweep > kTurn / 2 ? -meant.radius : meant.radius);
    } else {
        const Point from = meant.at(0);
        for (std::size_t i = 0; i < 2; ++i) {
            const std::size_t axis = meant.axes[i];
            arc.set(static_cast<Slot>(static_cast<std::size_t>(Slot::CenterX) + axis),
                    meant.center[i] - from[axis]);
        }
    }
    writer.write(arc, text);
    codes = testing::codes(sink);
    return text;
}

Dialect loaded(const std::string& name) {
    Sources sources;
    DiagnosticList sink;
    auto dialect = load_dialect(name, testing::dialect_folders(), sources, sink);
    EXPECT_TRUE(dialect.has_value()) << testing::rendered(sink, sources);
    return std::move(*dialect);
}

/// A dialect like another one but for what the text says.
Dialect with(const std::string& name, const std::string& base, const std::string& body) {
    const std::string path = kadr::testing::scratch(name + ".xml");
    std::ofstream(path) << "<dialect name=\"" << name << "\" extends=\"" << base
                        << "\" title=\"t\" suffix=\"t\"><doc>d</doc>" << body << "</dialect>";
    return loaded(path);
}

/// Openings: small, quarters, close to half a turn and to a full one, anywhere.
double any_sweep(std::mt19937& random, double radius, double increment) {
    std::uniform_real_distribution<double> share(0, 1);
    // A gap from one increment to the radius, evenly by its logarithm.
    const double gap = increment * std::pow(radius / increment, share(random));
    switch (random() % 6) {
        case 0: return gap / radius;
        case 1: return kTurn - gap / radius;
        case 2: return kTurn / 2 - gap / radius;
        case 3: return kTurn / 2 + gap / radius;
        case 4: return kTurn / 4 * static_cast<double>(1 + random() % 3);
        default: return kTurn * (0.001 + 0.998 * share(random));
    }
}

/// Arcs of every kind; the first few that are another arc in the text.
void check_arcs(const Dialect& dialect, const Control& metric, int count) {
    std::mt19937 random(20261128);
    std::uniform_real_distribution<double> share(0, 1);
    int failures = 0;
    int parts = 0;
    for (int n = 0; n < count && failures < 5; ++n) {
        const bool is_inch = n % 5 == 4;
        Control control = metric;
        if (is_inch) {  // one decimal more, of inches
            control.increment = 25.4 * metric.increment / metric.inch_ratio;
            control.center_increment = 25.4 * metric.center_increment / metric.inch_center_ratio;
        }
        Meant meant;
        std::size_t third = control.is_lathe ? 1 : random() % 3;
        if (!control.has_centers && third == 1) third = 2;  // nothing says what X is there
        meant.axes = {(third + 1) % 3, (third + 2) % 3, third};
        constexpr std::array kRadii = {0.05, 0.4, 3.0, 12.7, 50.0, 300.0, 2500.0};
        meant.radius = kRadii[random() % kRadii.size()] * (0.8 + 0.4 * share(random));
        meant.sweep = any_sweep(random, meant.radius, std::max(control.increment, 1e-3));
        meant.start = kTurn * share(random);
        if (random() % 4 == 0) meant.start = kTurn / 8 * static_cast<double>(random() % 8);
        meant.center = {200 * share(random) - 100, 200 * share(random) - 100};
        if (random() % 3 == 0) meant.center = {0, 0};
        meant.is_clockwise = random() % 2 == 0;
        if (!control.is_lathe && random() % 3 == 0) meant.height = 20 * share(random) - 10;
        // Where nothing says what X is, a radius stays one if its centre is a few increments off.
        const bool is_unclear = third == 1 && !control.is_lathe && !control.says_diameter;
        const bool by_center = control.has_centers && (is_unclear || random() % 2 == 0);
        const Said said = by_center ? Said::ByCenter : Said::ByRadius;
        std::string codes;
        const std::string text = written(dialect, control, meant, said, is_inch, codes);
        TextReader reader(control, is_inch ? 25.4 : 1);
        std::vector<Motion> motions = reader.read(text);
        ASSERT_FALSE(motions.empty());
        motions.erase(motions.begin());
        parts += motions.size() > 1;
        const std::string fault = difference(motions, meant, said, control);
        if (fault.empty() && (codes.empty() || codes == "K4213")) continue;
        ++failures;
        ADD_FAILURE() << control.name << ", r " << meant.radius << ", " << meant.sweep / kTurn * 360
                      << " deg, gap " << (kTurn - meant.sweep) * meant.radius << ", height "
                      << meant.height
                      << (said == Said::ByRadius ? ", by radius: " : ", by centre: ") << fault
                      << ' ' << codes << '\n'
                      << text;
    }
    EXPECT_GT(parts, 0) << "no arc had to be written in parts";
}

constexpr int kArcs = 4000;

TEST(ArcText, Iso) {
    check_arcs(loaded("iso"),
               {.name = "iso", .increment = 1e-6, .center_increment = 1e-6, .says_diameter = true},
               kArcs);
}

/// Decimals: three of coordinates and six of centres; in inches five and seven.
const Control kSinumerik = {
    .name = "sinumerik", .center_increment = 1e-6, .shifts_center = true, .inch_ratio = 100};

TEST(ArcText, Sinumerik) { check_arcs(loaded("sinumerik"), kSinumerik, kArcs); }

TEST(ArcText, Axioma) {
    Control control = kSinumerik;
    control.name = "axioma";
    check_arcs(loaded("axioma"), control, kArcs);
}

// Other decimals than those of the shipped files, as shops set them.
TEST(ArcText, SinumerikWithFourDecimals) {
    Control control = kSinumerik;
    control.name = "four";
    control.increment = control.center_increment = 1e-4;
    control.inch_ratio = 10;
    check_arcs(
        with("four", "sinumerik",
             "<number addresses=\"X Y Z U V W CR I J K\" decimals=\"4\" inch_decimals=\"5\"/>"),
        control, kArcs);
}

TEST(ArcText, Fanuc) { check_arcs(loaded("fanuc"), {.name = "fanuc"}, kArcs); }

TEST(ArcText, FanucLathe) {
    check_arcs(loaded("fanuc-lathe"), {.name = "fanuc-lathe", .is_lathe = true}, kArcs);
}

TEST(ArcText, Haas) {
    check_arcs(loaded(KADR_ROOT "/examples/dialects/haas.xml"), {.name = "haas"}, kArcs);
}

TEST(ArcText, CentresAsCoordinates) {
    check_arcs(loaded(KADR_ROOT "/examples/dialects/heidenhain-iso.xml"),
               {.name = "heidenhain-iso", .has_coordinate_centers = true}, kArcs);
}

// Radii of such words differ by more than the usual tolerance.
TEST(ArcText, HundredthsOfAMillimetre) {
    check_arcs(
        with("coarse", "iso",
             "<number addresses=\"X Y Z I J K R CR\" decimals=\"2\" inch_decimals=\"3\"/>"
             "<rule name=\"arc_tolerance\" value=\"0.1\"/>"),
        {.name = "coarse", .increment = 1e-2, .center_increment = 1e-2, .says_diameter = true},
        kArcs);
}

// A control that has arcs by their radius alone.
TEST(ArcText, NoCentres) {
    check_arcs(with("radius", "fanuc", "<remove addresses=\"I J K\"/>"),
               {.name = "radius", .has_centers = false}, kArcs);
}

// What stops or ends comes behind the last part, a full stop of the path, too; the rest first.
TEST(ArcText, FunctionsOfAnArcInParts) {
    DiagnosticList sink;
    Writer writer(testing::shipped("sinumerik"), {.number_blocks = false}, sink);
    std::string text;
    writer.begin({"test", 1, "", false}, text);
    Block start = testing::source_block(testing::shipped("iso"), "G0 X50.0004 Y0");
    writer.write(start, text);
    text.clear();
    Block arc = testing::source_block(testing::shipped("iso"),
                                      "G3 X50.0004 Y-0.0514 I-50 J0 F100 M8 M30 G9");
    writer.write(arc, text);
    EXPECT_EQ(text,
              "G3 X-24.985 Y43.31 I-49.9996 J0 F100 M8\nG9 X50 Y-0.051 I24.9854 J-43.31 M30\n");
}

}  // namespace
}  // namespace kadr::write::arc_text_test
