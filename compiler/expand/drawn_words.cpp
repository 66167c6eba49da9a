#include "expand/drawn_words.h"

#include <cmath>
#include <optional>
#include <string>

#include "base/diagnostics/expand.h"
#include "base/readable.h"
#include "expand/block_values.h"
#include "expand/contour_recording.h"
#include "expand/contour_values.h"
#include "expand/corners.h"
#include "expand/cycles.h"
#include "expand/faults.h"
#include "expand/input_words.h"
#include "expand/text_format.h"
#include "nc/parameters.h"
#include "path/angled_line.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using nc::Group;
using nc::Invocation;
using nc::parameter_of;

using path::Vec2;

namespace {

constexpr double kFullTurn = 360;  // deg

/// One block whose words are taken.
class DrawnWords {
  public:
    DrawnWords(Running& run, Block& block, const sema::Plan& plan, std::uint32_t at)
        : run_(run),
          block_(block),
          plan_(plan),
          at_(at),
          wording_{plane_of(run.modal[Group::Plane]), run.modal.is_diameter},
          axes_(wording_.axes()) {}

    Done take() {
        if (block_.skip_level >= 0) {
            fault(run_, diag::CornerBeside, at_)
                .arg("corner, angle, pole or polar coordinate")
                .arg("stands in a block that the operator may leave out");
            return kFailed;
        }
        KnownDrawing& drawing = run_.modal.drawing;
        if (drawing.plane != wording_.plane) {
            drawing.pole = Vec2::Zero();
            drawing.angle_deg = 0;
            drawing.plane = wording_.plane;
        }
        if (const Invocation* pole = block_.find(Function::Pole)) {
            if (!take_pole(*pole)) return kFailed;
        }
        if ((block_.given & nc::kPolarSlots) != 0 && !take_polar()) return kFailed;
        if (const Invocation* all = block_.find(Function::CornerRoundModal)) {
            if (!take_modal_rounding(*all)) return kFailed;
        }
        if (!take_corners()) return kFailed;
        const Invocation* angle = block_.find(Function::ContourAngle);
        if (angle != nullptr && !take_angle(*angle)) return kFailed;
        erase_taken();
        return kDone;
    }

  private:
    /// Where the value of a function's parameter stands in the source.
    std::uint32_t where(Function function) const {
        for (const sema::Filling& filling : plan_.fillings) {
            if (filling.is_argument && plan_.functions[filling.invocation].function == function)
                return word_of(run_, filling, at_);
        }
        return at_;
    }
    std::uint32_t where(nc::Slot slot) const {
        for (const sema::Filling& filling : plan_.fillings) {
            if (!filling.is_argument && filling.index == static_cast<std::size_t>(slot))
                return word_of(run_, filling, at_);
        }
        return at_;
    }

    bool is_distance(nc::Slot slot) const {
        const nc::SlotMask mask = nc::bit(slot);
        return (block_.incremental & mask) != 0 ||
               (run_.modal[Group::Distance] == Function::Incremental &&
                (block_.absolute & mask) == 0);
    }

    /// Where the tool stands in the plane; reported if nobody knows.
    std::optional<Vec2> here(std::string_view word, std::uint32_t at) {
        const KnownPosition& position = run_.modal.position;
        for (const std::size_t axis : {axes_.first, axes_.second}) {
            if (position.knows(axis)) continue;
            auto builder = fault(run_, diag::DrawnFromWhere, at);
            builder.arg(kAxisNames[axis]).arg(word);
            builder.fix("name a coordinate of " + std::string(kAxisNames[axis]) + " before it");
            return std::nullopt;
        }
        return wording_.point({position[axes_.first], position[axes_.second]});
    }

    /// The axis goes to a coordinate of the part.
    void go_to(std::size_t axis, double words) {
        const auto slot = static_cast<nc::Slot>(axis);
        block_.set(slot, words);
        block_.incremental &= ~nc::bit(slot);
        if (run_.modal[Group::Distance] == Function::Incremental) block_.absolute |= nc::bit(slot);
    }
    void go_to(const Vec2& point) {
        const Vec2 words = wording_.words(point);
        go_to(axes_.first, words.x());
        go_to(axes_.second, words.y());
    }

    Done refuse_polar(const std::string& why, std::uint32_t at) {
        fault(run_, diag::PolarWords, at).arg(why);
        return kFailed;
    }

    Done take_pole(const Invocation& invocation) {
        constexpr double kHere = 0;
        constexpr double kPole = 2;
        constexpr std::size_t kX = parameter_of<Function::Pole>("x");
        constexpr std::size_t kAngle = parameter_of<Function::Pole>("angle");
        constexpr std::size_t kRadius = parameter_of<Function::Pole>("radius");
        const std::uint32_t at = where(Function::Pole);
        if (invocation.has(kX + axes_.across))
            return refuse_polar("have their pole in the plane, and `" +
                                    std::string(kAxisNames[axes_.across]) + "` is no axis of it",
                                at);
        const bool is_polar = invocation.has(kAngle) || invocation.has(kRadius);
        if (is_polar && (invocation.has(kX + axes_.first) || invocation.has(kX + axes_.second)))
            return refuse_polar("have a pole by coordinates or by an angle and a radius, not both",
                                at);
        const double radius = block_.argument(invocation, kRadius);
        if (radius < 0)
            return refuse_polar("have a radius of 0 or more, not " + length_text(radius), at);
        KnownDrawing& drawing = run_.modal.drawing;
        Vec2 point = radius * path::unit_at(block_.argument(invocation, kAngle));
        if (!is_polar)
            point = wording_.point({block_.argument(invocation, kX + axes_.first),
                                    block_.argument(invocation, kX + axes_.second)});
        const double from = block_.argument(invocation, parameter_of<Function::Pole>("from"));
        if (from == kHere) {
            const std::optional<Vec2> start = here("G110", at);
            if (!start) return kFailed;
            point += *start;
        }
        if (from == kPole) point += drawing.pole;
        drawing.pole = point;
        drawing.angle_deg = 0;
        return kDone;
    }

    Done take_polar() {
        KnownDrawing& drawing = run_.modal.drawing;
        for (const std::size_t axis : {axes_.first, axes_.second}) {
            if (block_.has(static_cast<nc::Slot>(axis)))
                return refuse_polar("do not stand beside `" + std::string(kAxisNames[axis]) + '`',
                                    where(static_cast<nc::Slot>(axis)));
        }
        if (block_.has(nc::Slot::PolarRadius)) {
            drawing.radius = block_.at(nc::Slot::PolarRadius);
            if (drawing.radius < 0)
                return refuse_polar(
                    "have a radius of 0 or more, not " + length_text(drawing.radius),
                    where(nc::Slot::PolarRadius));
        }
        if (block_.has(nc::Slot::PolarAngle)) {
            const double angle_deg = block_.at(nc::Slot::PolarAngle);
            drawing.angle_deg =
                is_distance(nc::Slot::PolarAngle) ? drawing.angle_deg + angle_deg : angle_deg;
            // Sums of many steps keep their digits.
            drawing.angle_deg = std::remainder(drawing.angle_deg, kFullTurn);
        }
        const bool is_arc = nc::is_arc(run_.modal[Group::Motion]);
        if (is_arc && (block_.given & nc::kArcSlots & ~nc::bit(nc::Slot::Turns)) != 0)
            return refuse_polar("of an arc have its centre in the pole, and no other", at_);
        block_.given &= ~nc::kPolarSlots;
        block_.incremental &= ~nc::kPolarSlots;
        block_.absolute &= ~nc::kPolarSlots;
        go_to(drawing.pole + drawing.radius * path::unit_at(drawing.angle_deg));
        if (!is_arc) return kDone;
        const double centers[2] = {drawing.pole.x(), drawing.pole.y()};
        const std::size_t plane_axes[2] = {axes_.first, axes_.second};
        for (std::size_t i = 0; i < 2; ++i) {
            const auto center =
                static_cast<nc::Slot>(static_cast<std::size_t>(nc::Slot::CenterX) + plane_axes[i]);
            block_.set(center, centers[i]);
            block_.absolute |= nc::bit(center);
            block_.incremental &= ~nc::bit(center);
        }
        return kDone;
    }

    std::string length_text(double value) const {
        return quantity_text(run_, value, sema::kLength);
    }

    Done take_modal_rounding(const Invocation& invocation) {
        const double radius =
            block_.argument(invocation, parameter_of<Function::CornerRoundModal>("radius"));
        if (radius < 0) {
            fault(run_, diag::CornerSize, where(Function::CornerRoundModal))
                .arg("rounding of all corners")
                .arg(length_text(radius))
                .fix("`RNDM=0` ends it");
            return kFailed;
        }
        run_.modal.drawing.rounding = radius;
        return kDone;
    }

    Done take_corners() {
        constexpr std::size_t kLength = parameter_of<Function::CornerChamfer>("length");
        constexpr std::size_t kWidth = parameter_of<Function::CornerChamfer>("width");
        constexpr std::size_t kRadius = parameter_of<Function::CornerRound>("radius");
        using Kind = path::CornerShape::Kind;
        std::optional<WantedCorner>& wanted = run_.corners.wanted;
        wanted.reset();
        for (std::size_t i = 0; i < block_.function_count; ++i) {
            const Invocation& invocation = block_.functions[i];
            const bool is_round = invocation.function == Function::CornerRound;
            if (!is_round && invocation.function != Function::CornerChamfer) continue;
            WantedCorner corner;
            corner.at = where(invocation.function);
            corner.shape.kind = is_round                 ? Kind::Rounding
                                : invocation.has(kWidth) ? Kind::ChamferWidth
                                                         : Kind::ChamferLength;
            const std::size_t size = is_round ? kRadius : invocation.has(kWidth) ? kWidth : kLength;
            corner.shape.size = block_.argument(invocation, size);
            if (wanted) {
                fault(run_, diag::CornerBeside, corner.at)
                    .arg(corner.name())
                    .arg("stands beside another one in its block");
                return kFailed;
            }
            if (!(corner.shape.size > 0)) {
                fault(run_, diag::CornerSize, corner.at)
                    .arg(corner.name())
                    .arg(length_text(corner.shape.size));
                return kFailed;
            }
            wanted = corner;
        }
        return kDone;
    }

    Done refuse_angle(const std::string& why) {
        fault(run_, diag::AngleOpen, where(Function::ContourAngle)).arg(why);
        return kFailed;
    }

    Done take_angle(const Invocation& invocation) {
        if (run_.modal[Group::Motion] != Function::Line &&
            run_.modal[Group::Motion] != Function::Rapid)
            return refuse_angle("an arc has its end and its centre or radius");
        const double angle_deg =
            block_.argument(invocation, parameter_of<Function::ContourAngle>("angle"));
        const Vec2 along = path::unit_at(angle_deg);
        const bool has_first = block_.has(static_cast<nc::Slot>(axes_.first));
        const bool has_second = block_.has(static_cast<nc::Slot>(axes_.second));
        std::optional<OpenLine>& open = open_line(run_);
        if (open) return close_line(along, has_first && has_second);
        const std::optional<Vec2> from = here("ANG", where(Function::ContourAngle));
        if (!from) return kFailed;
        if (!has_first && !has_second) {
            if (run_.modal[Group::Motion] == Function::Rapid)
                return refuse_angle("two lines that meet are travelled at feed");
            open = OpenLine{angle_deg, *from, run_.corners.wanted, where(Function::ContourAngle)};
            run_.corners.wanted.reset();
            run_.corners.opens = true;
            block_.motion = Function::Line;  // no empty block: its end comes
            run_.modal.position.lose(static_cast<AxisMask>(1u << axes_.first | 1u << axes_.second));
            return kDone;
        }
        const Vec2 to = end_of_words(*from);
        if (has_first && has_second) {
            const double tolerance = nc::Rules::of_language().arc_tolerance;
            if (std::abs(path::cross(along, to - *from)) <= tolerance && along.dot(to - *from) >= 0)
                return kDone;
            return refuse_angle("both coordinates of its end are given, and they lie elsewhere");
        }
        const Eigen::Index given = has_first ? 0 : 1;
        const std::optional<Vec2> end = path::end_at(*from, along, given, to[given]);
        if (!end)
            return refuse_angle("at " + readable(angle_deg) + " degrees it does not come to " +
                                std::string(kAxisNames[has_first ? axes_.first : axes_.second]) +
                                ' ' + readable(wording_.words(to)[given]));
        const Vec2 words = wording_.words(*end);
        go_to(has_first ? axes_.second : axes_.first, words[1 - given]);
        return kDone;
    }

    /// The end that the words of the plane's axes give, as far as they are given.
    Vec2 end_of_words(const Vec2& from) const {
        Vec2 words = wording_.words(from);
        const std::size_t plane_axes[2] = {axes_.first, axes_.second};
        for (Eigen::Index i = 0; i < 2; ++i) {
            const auto slot = static_cast<nc::Slot>(plane_axes[i]);
            if (!block_.has(slot)) continue;
            words[i] = block_.at(slot) + (is_distance(slot) ? words[i] : 0);
        }
        return wording_.point(words);
    }

    /// The second line of two: where they meet is the end of the first.
    Done close_line(const Vec2& along, bool has_end) {
        OpenLine line = *open_line(run_);
        const bool is_free = !is_distance(static_cast<nc::Slot>(axes_.first)) &&
                             !is_distance(static_cast<nc::Slot>(axes_.second));
        if (!has_end || !is_free)
            return refuse_angle(
                "the second line of two has both coordinates of its end, and absolute ones");
        const std::optional<Vec2> corner = path::meeting_point(
            line.from, path::unit_at(line.angle_deg), end_of_words(line.from), along);
        if (!corner) return refuse_angle("the two lines do not meet, going forward");
        const Vec2 words = wording_.words(*corner);
        run_.modal.position.set(axes_.first, words.x());
        run_.modal.position.set(axes_.second, words.y());
        open_line(run_).reset();
        return take_closed_line(run_, path::line_element(line.from, *corner), line.corner, at_);
    }

    /// What is taken is no function of the block any more; a corner may be one of the target's.
    void erase_taken() {
        const bool keeps_corner = !run_.recordings.is_open() && run_.corners.wanted.has_value();
        for (std::size_t i = block_.function_count; i-- > 0;) {
            const Function function = block_.functions[i].function;
            const bool is_corner =
                function == Function::CornerRound || function == Function::CornerChamfer;
            if (nc::has_fact(function, nc::Fact::Resolved) && !(is_corner && keeps_corner))
                erase(block_, i);
        }
    }

    Running& run_;
    Block& block_;
    const sema::Plan& plan_;
    std::uint32_t at_;
    Wording wording_;
    PlaneIndices axes_;
};

}  // namespace

Done take_drawn_words(Running& run, Block& block, const sema::Plan& plan, std::uint32_t at) {
    return DrawnWords(run, block, plan, at).take();
}

Done require_no_open_line(Running& run) {
    const std::optional<OpenLine>& open = open_line(run);
    if (!open) return kDone;
    fault(run, diag::AngleOpen, open->at)
        .arg("the block behind it is no line with an angle and both coordinates");
    return kFailed;
}

}  // namespace kadr::expand
