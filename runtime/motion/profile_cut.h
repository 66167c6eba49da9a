// profile_cut.h — one profile shared out among the pieces of path that it runs over.
//
// A profile over many pieces is planned as if they were one; each piece takes the phases that pass
// on it. Neighbours meet in one state, so nothing is lost or counted twice between them.
#pragma once

#include <array>
#include <cstddef>

#include "motion/profile.h"

namespace kadr::motion {

class ProfileCut {
  public:
    ProfileCut() = default;
    /// Of a run of phases; a trapezoid cannot be cut.
    explicit ProfileCut(const Profile& whole);

    /// The part over the next `length` of the path. `is_last`: all that is left.
    Profile next(double length, bool is_last);

  private:
    /// Where a phase begins.
    struct Start {
        double distance = 0;
        double speed = 0;
    };
    double time_at(double distance) const;
    Phase phase(std::size_t i) const { return phase_of(whole_, i, i == first_); }
    void take_phase(Profile& part, double until);

    Profile whole_;
    std::array<Start, kPhases + 1> starts_{};
    std::size_t first_ = 0;  // phase that lasts
    std::size_t phase_ = 0;  // the current one
    double time_ = 0;        // in it
    double distance_ = 0;    // from the start of the whole
    double speed_ = 0;
};

}  // namespace kadr::motion
