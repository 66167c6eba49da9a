#include "driver/recording.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <variant>

#include "base/numbers.h"

namespace kadr::driver {

using expand::FigureAnswer;
using path::Vec3;
using sema::Figure;

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr AxisMask kXy = 3;
constexpr AxisMask kZ = 4;

/// Two points closer than this are one, mm: half a thousandth is what the numbers of the text round
/// at each of them.
constexpr double kSame = 0.001 + 1e-9;
/// How far a move may come beyond a limit, mm: what the number of its end rounds.
constexpr double kBeyond = sema::kExpectTolerance;

/// A key for points in the plane that are one. Coordinates are mostly whole thousandths: those lie
/// in the middle of a cell, so that noise does not part what is the same.
std::pair<std::int64_t, std::int64_t> cell(const Vec3& point) {
    const auto index = [](double value) {
        return static_cast<std::int64_t>(std::floor(value / 0.001 + 0.5));
    };
    return {index(point.x()), index(point.y())};
}

/// Noise of frames and conversions does not show: a millionth of a millimetre.
double clean(double value) { return round_to(value, 6); }

std::string coordinate(double value) { return format_shortest(round_to(value, 4)); }

std::string point_text(const Vec3& point) {
    return "X" + coordinate(point.x()) + " Y" + coordinate(point.y()) + " Z" +
           coordinate(point.z());
}

bool is_vertical(const Vec3& direction) { return std::hypot(direction.x(), direction.y()) < 1e-9; }

/// The part of a curve that lies below a height; nothing if none does.
std::optional<path::Curve> part_below(const path::Curve& curve, double height) {
    const path::Box box = path::bounds(curve);
    if (box.lower.z() >= height - kBeyond) return std::nullopt;
    if (box.upper.z() <= height) return curve;
    // Along a line, and along a helix about the tool axis, the height changes evenly with the path.
    const auto* helix = std::get_if<path::Helix>(&curve);
    if (helix != nullptr && !is_vertical(helix->normal)) return curve;
    if (path::bends_freely(curve)) return curve;
    const double from = path::start(curve).z();
    const double to = path::end(curve).z();
    if (from == to) return curve;
    const double length = path::length(curve);
    const double crossing = std::clamp((height - from) / (to - from), 0.0, 1.0) * length;
    return from < to ? path::part(curve, 0, crossing) : path::part(curve, crossing, length);
}

/// Distance in the plane from a point to a curve, and the curve's height there.
std::pair<double, double> nearest(const path::Curve& curve, const Vec3& point) {
    const double length = path::length(curve);
    const auto away = [&](double s) {
        const Vec3 gap = path::position(curve, s) - point;
        return std::hypot(gap.x(), gap.y());
    };
    // The distance to a line has one least value; an arc is looked at in pieces of a few degrees.
    const int pieces = std::holds_alternative<path::Line>(curve) ? 1 : 128;
    std::pair<double, double> best = {std::numeric_limits<double>::infinity(), 0};
    for (int i = 0; i < pieces; ++i) {
        double low = length * i / pieces;
        double high = length * (i + 1) / pieces;
        for (int turn = 0; turn < 60; ++turn) {
            const double a = low + (high - low) / 3;
            const double b = high - (high - low) / 3;
            if (away(a) < away(b)) high = b;
            else low = a;
        }
        const double s = (low + high) / 2;
        if (away(s) < best.first) best = {away(s), path::position(curve, s).z()};
    }
    return best;
}

}  // namespace

bool Recording::Move::is_known() const {
    return (known_before & known_after & (kXy | kZ)) == (kXy | kZ);
}

bool Recording::Move::is_in_plane() const {
    if (std::holds_alternative<path::Helix>(curve)) return true;
    if (path::bends_freely(curve)) return true;
    const Vec3 delta = end() - start();
    return std::hypot(delta.x(), delta.y()) > kBeyond;
}

void Recording::add(const path::Command& command) {
    using path::Op;
    if (command.op() == Op::Tool && command.source.is_valid())
        tools_.push_back(static_cast<double>(command.tool().number));
    if (!command.is_motion()) return;
    const AxisMask before = known_;
    const auto moved = static_cast<AxisMask>(command.motion().moved & (kXy | kZ));
    known_ = command.is_unshifted ? static_cast<AxisMask>(known_ & ~moved)
                                  : static_cast<AxisMask>(known_ | moved);
    if (known_ == before) return;
    if (!knowledge_.empty() && knowledge_.back().line == command.line) {
        knowledge_.back().after = known_;
    } else {
        knowledge_.push_back({command.line, before, known_});
    }
}

void Recording::add(const motion::Segment& segment) {
    if (segment.source.is_valid()) segments_.push_back(segment);
}

Recording::Knowledge Recording::knowledge_at(std::uint32_t line) const {
    const auto next =
        std::lower_bound(knowledge_.begin(), knowledge_.end(), line,
                         [](const Knowledge& entry, std::uint32_t l) { return entry.line < l; });
    if (next != knowledge_.end() && next->line == line) return *next;
    const AxisMask known = next == knowledge_.begin() ? AxisMask{0} : std::prev(next)->after;
    return {line, known, known};
}

void Recording::finish() {
    std::uint32_t last_line = 0;  // of the motion before
    for (const motion::Segment& segment : segments_) {
        time_ += segment.duration;
        if (!motion::is_motion(segment.kind)) {
            if (segment.kind != motion::SegmentKind::ToolChange) dwell_time_ += segment.duration;
            continue;
        }
        const bool is_rapid = segment.kind == motion::SegmentKind::Rapid;
        (is_rapid ? rapid_time_ : cutting_time_) += segment.duration;
        if (segment.is_rotary_only) continue;
        (is_rapid ? rapid_length_ : cutting_length_) += path::arc_length(segment.curve);
        Knowledge known = knowledge_at(segment.line);
        // A cycle moves from the position to which its block has brought the tool.
        if (segment.cycle != 0 && segment.line == last_line) known.before = known.after;
        last_line = segment.line;
        moves_.push_back({segment.curve, is_rapid, known.before, known.after, segment.source});
    }
    segments_.clear();
    find_holes();
    find_levels();
}

void Recording::find_holes() {
    std::map<std::pair<std::int64_t, std::int64_t>, std::size_t> known;
    bool is_open = false;
    Vec3 bottom = Vec3::Zero();
    double height = 0;  // of the tool
    const auto close = [&] {
        if (!is_open || height <= bottom.z() + kSame) return;
        const auto [hole, is_new] = known.try_emplace(cell(bottom), holes_.size());
        if (is_new) holes_.push_back({bottom});
        Vec3& deepest = holes_[hole->second].bottom;
        if (bottom.z() < deepest.z()) deepest = bottom;
    };
    for (const Move& move : moves_) {
        if (!move.is_known() || move.is_in_plane()) {
            // Who goes on at feed mills; who is down there still, too.
            if (move.is_rapid) close();
            is_open = false;
            continue;
        }
        height = move.end().z();
        if (move.is_rapid || height >= move.start().z()) continue;
        if (!is_open || height < bottom.z()) bottom = move.end();
        is_open = true;
    }
    close();
}

void Recording::find_levels() {
    for (const Move& move : moves_) {
        const bool is_known = (move.known_before & move.known_after & kZ) != 0;
        if (move.is_rapid || !is_known || !move.is_in_plane()) continue;
        const path::Box box = path::bounds(move.curve);
        if (box.upper.z() - box.lower.z() <= kBeyond) levels_.push_back(move.end().z());
    }
    std::sort(levels_.begin(), levels_.end(), std::greater<>());
    const auto same = [](double above, double below) { return above - below <= kSame; };
    levels_.erase(std::unique(levels_.begin(), levels_.end(), same), levels_.end());
}

Recording::Extent Recording::extent(const Move& move) {
    Extent extent{{kNone, kNone, kNone}, {kNone, kNone, kNone}};
    const path::Box box = path::bounds(move.curve);
    const Vec3 end = move.end();
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        if ((move.known_after >> i & 1u) == 0) continue;
        const bool is_whole = (move.known_before >> i & 1u) != 0;
        extent.lower[at] = is_whole ? box.lower[i] : end[i];
        extent.upper[at] = is_whole ? box.upper[i] : end[i];
    }
    return extent;
}

Recording::Extent Recording::extent_of_all(bool with_rapids) const {
    Extent all{{kNone, kNone, kNone}, {kNone, kNone, kNone}};
    for (const Move& move : moves_) {
        if (move.is_rapid && !with_rapids) continue;
        const Extent one = extent(move);
        for (std::size_t i = 0; i < 3; ++i) {
            // fmin and fmax take the number where the other is none.
            all.lower[i] = std::fmin(all.lower[i], clean(one.lower[i]));
            all.upper[i] = std::fmax(all.upper[i], clean(one.upper[i]));
        }
    }
    return all;
}

std::array<double, 3> Recording::final_position() const {
    std::array<double, 3> point = {kNone, kNone, kNone};
    if (moves_.empty()) return point;
    const Vec3 end = moves_.back().end();
    for (int i = 0; i < 3; ++i) {
        if ((moves_.back().known_after >> i & 1u) != 0)
            point[static_cast<std::size_t>(i)] = clean(end[i]);
    }
    return point;
}

/// Whether a move at feed, one of the first `before`, came by here as deep as this.
bool Recording::was_cut(std::size_t before, const Vec3& point) const {
    for (std::size_t i = 0; i < before; ++i) {
        const Move& move = moves_[i];
        if (move.is_rapid || !move.is_known()) continue;
        const path::Box box = path::bounds(move.curve);
        const bool is_apart =
            point.x() < box.lower.x() - kSame || point.x() > box.upper.x() + kSame ||
            point.y() < box.lower.y() - kSame || point.y() > box.upper.y() + kSame ||
            box.lower.z() > point.z() + kBeyond;
        if (is_apart) continue;
        if (!move.is_in_plane()) return true;  // straight down here, and deep enough
        const auto [away, height] = nearest(move.curve, point);
        if (away <= kSame && height <= point.z() + kBeyond) return true;
    }
    return false;
}

void Recording::answer_rapids(bool blind, double height, FigureAnswer& answer) const {
    for (std::size_t i = 0; i < moves_.size(); ++i) {
        const Move& move = moves_[i];
        if (!move.is_rapid || (move.known_after & kZ) == 0) continue;
        const Vec3 end = move.end();
        const bool has_start = (move.known_before & kZ) != 0;
        const double lowest = has_start ? path::bounds(move.curve).lower.z() : end.z();
        if (!(lowest < height - kBeyond)) continue;
        const bool is_straight = !move.is_in_plane();
        if (is_straight && has_start && end.z() > move.start().z()) continue;
        if (blind && (!is_straight || was_cut(i, end))) continue;
        if (answer.count++ > 0) continue;
        answer.reason = "this moves at rapid to " + point_text(end);
        answer.reason_at = move.source;
    }
}

void Recording::answer_inside(std::span<const sema::Slot> arguments, FigureAnswer& answer) const {
    const double margin = arguments[6].number == arguments[6].number ? arguments[6].number : 0;
    const double below = arguments[7].number;
    std::array<double, 3> lower{};
    std::array<double, 3> upper{};
    for (std::size_t i = 0; i < 3; ++i) {
        // The margin is of the walls: a tool has its radius in the plane.
        const double inset = i < 2 ? margin : 0;
        lower[i] = std::fmin(arguments[i].number, arguments[i + 3].number) + inset;
        upper[i] = std::fmax(arguments[i].number, arguments[i + 3].number) - inset;
    }
    answer.count = 1;
    for (const Move& move : moves_) {
        Move piece = move;
        if (below == below) {
            const bool has_heights = (move.known_before & move.known_after & kZ) != 0;
            if (!has_heights && !(move.end().z() < below - kBeyond)) continue;
            if (has_heights) {
                const std::optional<path::Curve> deep = part_below(move.curve, below);
                if (!deep) continue;
                piece.curve = *deep;
            }
        }
        const Extent reach = extent(piece);
        for (std::size_t i = 0; i < 3; ++i) {
            const bool is_low = reach.lower[i] < lower[i] - kBeyond;
            const bool is_high = reach.upper[i] > upper[i] + kBeyond;
            if (!is_low && !is_high) continue;
            answer.count = 0;
            answer.reason = "the move to " + point_text(move.end()) + " reaches " + "XYZ"[i] +
                            coordinate(is_low ? reach.lower[i] : reach.upper[i]) + ", beyond " +
                            coordinate(is_low ? lower[i] : upper[i]);
            answer.reason_at = move.source;
            return;
        }
    }
}

FigureAnswer Recording::ask(Figure figure, std::span<const sema::Slot> arguments) const {
    FigureAnswer answer;
    answer.numbers = {kNone, kNone, kNone};
    const auto count = [&](auto number) { answer.count = static_cast<std::int64_t>(number); };
    const auto moves_that = [&](auto&& condition) {
        count(std::count_if(moves_.begin(), moves_.end(), condition));
    };
    switch (figure) {
        case Figure::Text: answer.text = text; break;
        case Figure::Dialect: answer.text = dialect; break;
        case Figure::Blocks: count(blocks); break;
        case Figure::Min: answer.numbers = extent_of_all(true).lower; break;
        case Figure::Max: answer.numbers = extent_of_all(true).upper; break;
        case Figure::CutMin: answer.numbers = extent_of_all(false).lower; break;
        case Figure::CutMax: answer.numbers = extent_of_all(false).upper; break;
        case Figure::Final: answer.numbers = final_position(); break;
        case Figure::Length: answer.numbers[0] = clean(cutting_length_ + rapid_length_); break;
        case Figure::CuttingLength: answer.numbers[0] = clean(cutting_length_); break;
        case Figure::RapidLength: answer.numbers[0] = clean(rapid_length_); break;
        case Figure::Feeds: moves_that([](const Move& m) { return !m.is_rapid; }); break;
        case Figure::Rapids: moves_that([](const Move& m) { return m.is_rapid; }); break;
        case Figure::Arcs:
            moves_that([](const Move& m) { return std::holds_alternative<path::Helix>(m.curve); });
            break;
        case Figure::Time: answer.numbers[0] = time_; break;
        case Figure::CuttingTime: answer.numbers[0] = cutting_time_; break;
        case Figure::RapidTime: answer.numbers[0] = rapid_time_; break;
        case Figure::DwellTime: answer.numbers[0] = dwell_time_; break;
        case Figure::Holes: count(holes_.size()); break;
        case Figure::Hole: {
            const std::int64_t index = arguments[0].integer;
            if (index < 0 || index >= static_cast<std::int64_t>(holes_.size())) {
                answer.reason = holes_.empty() ? "there is no hole"
                                               : "holes are counted from 0 to " +
                                                     std::to_string(holes_.size() - 1);
                break;
            }
            const Vec3& bottom = holes_[static_cast<std::size_t>(index)].bottom;
            for (int i = 0; i < 3; ++i)
                answer.numbers[static_cast<std::size_t>(i)] = clean(bottom[i]);
            break;
        }
        case Figure::Passes: count(levels_.size()); break;
        case Figure::Levels:
            for (const double level : levels_) answer.list.push_back(clean(level));
            break;
        case Figure::Deepest: answer.numbers[0] = extent_of_all(false).lower[2]; break;
        case Figure::Tools: answer.list = tools_; break;
        case Figure::Inside: answer_inside(arguments, answer); break;
        case Figure::RapidsBelow: answer_rapids(false, arguments[0].number, answer); break;
        case Figure::BlindRapids: answer_rapids(true, arguments[0].number, answer); break;
        case Figure::Errors: count(errors); break;
        case Figure::Alarms: count(alarms); break;
        case Figure::Warnings: count(warnings); break;
        case Figure::Message: answer.text = message; break;
    }
    return answer;
}

}  // namespace kadr::driver
