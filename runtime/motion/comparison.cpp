#include "motion/comparison.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/transformed.h"
#include "path/curve.h"

namespace kadr::motion {

namespace {

using path::Vec3;

constexpr std::size_t kBatch = 32;
constexpr double kStep = 0.1;               // mm along the path between two looks
constexpr double kParts = 4;                // looks at every piece, however short
constexpr double kNothing = 1e-9;           // mm: rounding of lengths
constexpr double kStanding = 1e-6;          // of a tip's path, of that of the point that touches
constexpr double kSameTime = 1e-6;          // s
constexpr double kSameAngle = 1e-4;         // rad, 0.006 deg; mm of a parallel axis
constexpr double kSameRate = 1e-3;          // of a pitch, of a speed: what rounded words leave
constexpr double kSameTurn = 1e-5;          // of the spindle: 0.004 deg
constexpr double kRoundedTurns = 0.5 / 60;  // rev/s: S in whole revolutions
constexpr double kRoundedCuts = 0.5 * 1000.0 / 60;  // mm/s: S in whole metres
constexpr double kRoundedShare = 0.1;               // … which a text gives no worse than that

/// A motion, and how far along it the walk has come.
class Walker {
  public:
    Walker(Stream<Segment>& segments, const machine::Chain& chain)
        : segments_(segments), chain_(chain) {
        settle();
    }

    bool is_over() const { return at_ == size_; }
    const Segment& segment() const { return batch_[at_]; }
    double rest() const { return length_ - along_; }
    double length() const { return length_; }
    /// Where the tip is, and its direction.
    path::CurvePoint here() const {
        path::CurvePoint point = path::evaluate(segment().curve, along_);
        if (!is_beside()) return point;
        point.position = tip_at(along_);
        const Vec3 slope = slope_of_tip();
        if (slope.norm() > kStanding) point.tangent = slope.normalized();
        return point;
    }
    /// How far the tip goes for each millimetre of the path. Where it stands, all the same: the
    /// walk is to come to an end.
    double pace() const {
        if (!is_beside()) return 1;
        const double pace = slope_of_tip().norm();
        return pace > kStanding ? pace : 1;
    }
    /// From the tip to what the linear axes carry.
    const Vec3& carrier() const { return segment().carrier; }
    double follower(std::size_t i) const {
        return segment().follower_start[i] + segment().follower_rate[i] * along_;
    }
    /// Whether it goes on with the same kind of motion.
    bool goes_on(SegmentKind kind) const { return !is_over() && segment().kind == kind; }
    std::uint32_t line() const { return is_over() ? line_ : segment().line; }
    /// Where the last piece ended, and whether that was in the workpiece as it is turned.
    const Vec3& end() const { return end_; }
    bool ended_transformed() const { return ended_transformed_; }
    const Vec3& end_carrier() const { return end_carrier_; }
    /// Points that were burnt so far.
    std::uint64_t pulses() const { return pulses_; }

    /// Goes on by this distance, not farther than the end of the piece. True: the piece is through.
    bool advance(double distance) {
        along_ = std::min(along_ + distance, length_);
        if (length_ - along_ > kNothing) return false;
        next();
        return true;
    }
    void next() {
        if (segment().has_pulse) ++pulses_;
        end_ = is_beside() ? tip_at(length_) : path::end(segment().curve);
        line_ = segment().line;
        ended_transformed_ = segment().is_in_workpiece();
        end_carrier_ = segment().carrier;
        ++at_;
        settle();
    }

  private:
    /// Makes batch_[at_] the piece that comes, one that moves the tip or takes time.
    void settle() {
        for (;;) {
            if (at_ == size_) {
                size_ = segments_.pull(batch_);
                at_ = 0;
                if (size_ == 0) return;
            }
            along_ = 0;
            length_ = is_motion(segment().kind) ? segment().profile.length : 0;
            if (!is_motion(segment().kind) || length_ > kNothing) return;
            ++at_;
        }
    }

    /// Whether the tip is somewhere else than on the path.
    bool is_beside() const {
        return segment().contact.kind != path::ContactKind::Tip || segment().goes_straight();
    }
    Vec3 tip_at(double along) const {
        return pose_at(chain_, segment(), along, path::position(segment().curve, along)).tip;
    }
    /// By the path.
    Vec3 slope_of_tip() const {
        const double step = 1e-4 * length_;
        const double before = std::max(0.0, along_ - step);
        const double behind = std::min(length_, along_ + step);
        return (tip_at(behind) - tip_at(before)) / (behind - before);
    }

    Stream<Segment>& segments_;
    const machine::Chain& chain_;
    std::vector<Segment> batch_ = std::vector<Segment>(kBatch);
    std::size_t at_ = 0;
    std::size_t size_ = 0;
    double along_ = 0;
    double length_ = 0;
    Vec3 end_ = Vec3::Zero();
    bool ended_transformed_ = false;
    Vec3 end_carrier_ = Vec3::Zero();
    std::uint32_t line_ = 0;
    std::uint64_t pulses_ = 0;
};

bool is_same_rate(double a, double b) {
    return std::abs(a - b) <= kSameRate * std::max(std::abs(a), std::abs(b));
}

/// Whether two speeds are one but for the rounding of S.
bool is_same_speed(double a, double b, double rounding) {
    const double apart = std::abs(a - b);
    return is_same_rate(a, b) ||
           apart <= std::min(rounding * (1 + 1e-9), kRoundedShare * std::max(a, b));
}

/// mm of path for each revolution of the spindle.
double pitch_of(const Segment& piece) {
    return piece.spindle.speed > 0 ? piece.feed / piece.spindle.speed : 0;
}

class ComparisonWalk {
  public:
    ComparisonWalk(Stream<Segment>& first, Stream<Segment>& second, double tolerance,
                   const machine::Chain& chain)
        : first_(first, chain), second_(second, chain), tolerance_(tolerance) {}

    Comparison go() {
        while (!first_.is_over() && !second_.is_over() && !result_.parting) {
            const Segment& a = first_.segment();
            const Segment& b = second_.segment();
            if (a.kind != b.kind && (awaits_mark(a, b) || awaits_mark(b, a))) meet_threads();
            else if (a.kind != b.kind) part(Parting::Kind);
            else if (is_motion(a.kind)) walk_stretch(a.kind);
            else stand(a, b);
        }
        if (!result_.parting && first_.is_over() != second_.is_over()) part(Parting::End);
        return result_;
    }

  private:
    ComparedPoint point() const {
        const auto at = [](const Walker& walker) {
            return walker.is_over() ? walker.end() : walker.here().position;
        };
        return {at(first_), at(second_), first_.line(), second_.line()};
    }

    void part(Parting why) {
        result_.parting = why;
        result_.parted = point();
    }

    void stand(const Segment& a, const Segment& b) {
        if (is_external(a.kind) && !mark_alike(a, b)) return part(Parting::Marks);
        if (std::abs(a.duration - b.duration) <= kSameTime) {
            first_.next();
            second_.next();
            return;
        }
        if (a.kind == SegmentKind::Wait) return meet_threads();
        part(Parting::Standing);
    }

    /// Whether the one waits while the other cuts its thread: its spindle was at the mark.
    static bool awaits_mark(const Segment& wait, const Segment& thread) {
        return wait.kind == SegmentKind::Wait && thread.is_thread;
    }

    /// How long a thread waits for the mark of the spindle hangs on all that came before: any time
    /// up to a revolution is the same wait. No other one is.
    void meet_threads() {
        const ComparedPoint here = point();
        bool is_mark = true;
        for (Walker* walker : {&first_, &second_}) {
            if (walker->segment().kind != SegmentKind::Wait) continue;
            const double speed = walker->segment().spindle.speed;
            is_mark &= speed > 0 && walker->segment().duration * speed <= 1 + 1e-6;
            walker->next();
            is_mark &= !walker->is_over() && walker->segment().is_thread;
        }
        if (is_mark) return;
        result_.parting = Parting::Standing;
        result_.parted = here;
    }

    /// Whether a module takes the same path, by its start, its middle and its end.
    bool mark_alike(const Segment& a, const Segment& b) const {
        const double first = path::length(a.curve);
        const double second = path::length(b.curve);
        for (const double share : {0.0, 0.5, 1.0}) {
            const Vec3 apart = a.stage + path::position(a.curve, share * first) - b.stage -
                               path::position(b.curve, share * second);
            if (apart.norm() > tolerance_) return false;
        }
        return a.train.count == b.train.count;
    }

    /// Side by side until one comes to an end; rounded paths are not equally long, so the second is
    /// led to where it is beside the first.
    void walk_stretch(SegmentKind kind) {
        ++result_.stretches;
        while (first_.goes_on(kind) && second_.goes_on(kind)) {
            const double ahead = look();
            if (result_.parting) return;
            // Of the tips: where what is touched is the path, that is longer or shorter.
            const double pace = first_.pace();
            const double other = second_.pace();
            const double step =
                std::min({kStep, pace * first_.rest(), other * second_.rest(),
                          pace * first_.length() / kParts, other * second_.length() / kParts});
            // A step leads both to an end of a piece if there is one; what lies behind it is seen
            // at the next look.
            first_.advance(step / pace);
            second_.advance(std::max(0.0, step - ahead) / other);
        }
        finish(first_, second_, kind);
        finish(second_, first_, kind);
        if (result_.parting) return;
        look_at_ends();
        if (first_.pulses() != second_.pulses()) part(Parting::Pulses);
    }

    /// Where both are through: along the path one may have come farther.
    void look_at_ends() {
        if (first_.ended_transformed() != second_.ended_transformed()) return;
        const Vec3 carried = first_.ended_transformed()
                                 ? Vec3::Zero()
                                 : Vec3(second_.end_carrier() - first_.end_carrier());
        const double distance = (second_.end() - first_.end() + carried).norm();
        if (distance <= result_.greatest_distance) return;
        result_.greatest_distance = distance;
        result_.widest = {first_.end(), second_.end(), first_.line(), second_.line()};
    }

    /// What is left of the stretch of one when the other is through. Where it is in other
    /// coordinates, as the rounding behind the end of a transformation, the ends before it count.
    void finish(Walker& walker, const Walker& other, SegmentKind kind) {
        double left = 0;
        const bool moves = !other.is_over() && is_motion(other.segment().kind);
        while (walker.goes_on(kind) && !result_.parting) {
            left += walker.rest();
            if (left > tolerance_) return part(moves ? Parting::Kind : Parting::Length);
            if (walker.segment().is_in_workpiece() != other.ended_transformed()) look_at_ends();
            walker.advance(walker.rest());
        }
    }

    /// Whether one is still, or only just, in other coordinates than the other.
    bool is_between_systems() const {
        return first_.segment().is_in_workpiece() != second_.segment().is_in_workpiece() &&
               std::min(first_.rest(), second_.rest()) <= tolerance_;
    }

    /// Whether one is as good as at the end of its piece, so that the other may be in the next one:
    /// what belongs to a piece is not compared there.
    bool is_between_pieces() const {
        const auto is_at_end = [&](const Walker& walker) {
            constexpr double kShare = 0.125;  // of the piece, so that a short one is compared, too
            return walker.rest() <= std::min(tolerance_, kShare * walker.length());
        };
        return is_at_end(first_) || is_at_end(second_);
    }

    /// By how much the second is ahead of the first along the path, mm.
    double look() {
        if (is_between_systems()) return 0;
        const path::CurvePoint a = first_.here();
        const path::CurvePoint b = second_.here();
        const Vec3 apart = b.position - a.position + carried_apart();
        const double ahead = first_.segment().is_rotary_only ? 0 : apart.dot(a.tangent);
        const bool leads = std::abs(ahead) <= tolerance_;
        const double distance = leads ? (apart - ahead * a.tangent).norm() : apart.norm();
        if (distance > result_.greatest_distance) {
            result_.greatest_distance = distance;
            result_.widest = point();
        }
        if (distance > tolerance_) part(Parting::Path);
        else if (!do_followers_agree()) part(Parting::Followers);
        else if (first_.segment().kind == SegmentKind::Feed && !is_between_pieces()) compare_cuts();
        if (!is_between_pieces()) compare_feeds();
        return leads ? ahead : 0;
    }

    /// Without a transformation the machine moves alike if what its axes carry does: a text that
    /// takes the length of the tool off for a retract has its tip elsewhere, and moves no axis.
    Vec3 carried_apart() const {
        if (first_.segment().is_in_workpiece() || second_.segment().is_in_workpiece())
            return Vec3::Zero();
        return second_.carrier() - first_.carrier();
    }

    bool do_followers_agree() const {
        for (std::size_t i = 0; i < kFollowers; ++i) {
            if (std::abs(first_.follower(i) - second_.follower(i)) > kSameAngle + tolerance_)
                return false;
        }
        return true;
    }

    /// What makes another workpiece of the same path.
    void compare_cuts() {
        const Segment& a = first_.segment();
        const Segment& b = second_.segment();
        const CommandedSpindle& s = a.spindle;
        const CommandedSpindle& t = b.spindle;
        const bool turns_alike =
            s.is_turning == t.is_turning && s.holds_cutting_speed == t.holds_cutting_speed &&
            (!s.is_turning || (s.is_counterclockwise == t.is_counterclockwise &&
                               is_same_speed(s.speed, t.speed, kRoundedTurns) &&
                               is_same_speed(s.cutting_speed, t.cutting_speed, kRoundedCuts)));
        if (!turns_alike) {
            result_.first_spindle = s;
            result_.second_spindle = t;
            return part(Parting::Spindle);
        }
        if (a.is_thread != b.is_thread) return part(Parting::Gear);
        if (!a.is_thread) return;
        if (!is_same_rate(pitch_of(a), pitch_of(b))) return part(Parting::Pitch);
        const double apart = a.thread_start - b.thread_start;
        if (std::abs(apart - std::round(apart)) > kSameTurn) part(Parting::Start);
    }

    void compare_feeds() {
        if (first_.segment().kind != SegmentKind::Feed) return;
        const double a = first_.segment().feed;
        const double b = second_.segment().feed;
        const double greater = std::max(a, b);
        const double share = greater > 0 ? std::abs(a - b) / greater : 0;
        if (share <= result_.greatest_feed_share) return;
        result_.greatest_feed_share = share;
        result_.fastest = point();
    }

    Walker first_;
    Walker second_;
    double tolerance_;
    Comparison result_;
};

}  // namespace

Comparison compare(Stream<Segment>& first, Stream<Segment>& second, double tolerance,
                   const machine::Chain& chain) {
    return ComparisonWalk(first, second, tolerance, chain).go();
}

}  // namespace kadr::motion
