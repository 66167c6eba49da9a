// stretch_window.h — the stretches whose speeds are not fixed yet, from the pieces that they are
// gathered from to the junction speeds that the look-ahead gives them.
//
// The look-ahead keeps of a stretch what its passes need; what the profile behind it needs is kept
// here beside it, for the same stretches in the same order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>

#include "motion/bent_cell.h"
#include "motion/lookahead.h"
#include "motion/stretch.h"

namespace kadr::motion {

class StretchWindow {
  public:
    /// gathers       pieces to stretches, as under a limit of the jerk; else each is one by itself
    /// keeps_limits  of stretches that are one piece, as where an operator may change their speeds
    struct Kind {
        bool gathers = false;
        bool keeps_limits = false;
    };
    /// depth  pieces that are known ahead at least
    StretchWindow(std::size_t depth, const Kind& kind)
        : kind_(kind), gathered_(std::max<std::size_t>(depth, 1)), lookahead_(depth) {}

    /// As of the look-ahead: whether enough is known, and whether a stretch can be taken.
    bool is_full() const { return lookahead_.is_full(); }
    bool is_ready() const { return lookahead_.is_ready(); }

    /// The next piece.
    ///
    /// exit_limit  speed that the corner behind it allows; counts where pieces are gathered
    void append(const Stretch& piece, double exit_limit);
    /// A cell of bent path, by itself; its limits are not kept.
    void append(const BentCell& cell, double entry_limit) { lookahead_.append(cell, entry_limit); }
    /// No more pieces come; the path ends at rest.
    void finish();

    /// The oldest stretch. Only if it is ready and its limits are kept.
    const Stretch& oldest() const { return stretches_.front(); }
    /// Path speed at which the oldest stretch is entered, and the one that is allowed behind it.
    double reached() const { return lookahead_.reached(); }
    double exit_limit() { return lookahead_.exit_limit(); }
    /// Speeds of the oldest stretch, which is then forgotten. Only if it is ready.
    JunctionSpeeds take() {
        forget_limits();
        return lookahead_.take();
    }
    /// Forgets the oldest stretch.
    void drop() {
        forget_limits();
        lookahead_.drop();
    }
    /// What was taken last was left at another path speed than planned.
    void depart(double speed) { lookahead_.depart(speed); }
    /// What is left of the stretch that was taken last, to be entered at this path speed.
    void put_back(const Stretch& rest, double entry) {
        stretches_.push_front(rest);
        lookahead_.put_back(rest, entry);
    }
    /// For all stretches, those that come later too.
    void set_overrides(const Overrides& overrides) { lookahead_.set_overrides(overrides); }

  private:
    bool keeps_limits() const { return kind_.gathers || kind_.keeps_limits; }
    void forget_limits() {
        if (keeps_limits()) stretches_.pop_front();
    }
    void append_complete();

    Kind kind_;
    StretchBuilder gathered_;
    LookAhead lookahead_;
    std::deque<Stretch> stretches_;  // in the look-ahead, if their limits are kept
};

}  // namespace kadr::motion
