// told_once.h — what a program is told once and not again. For the room expand only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace kadr::expand {

/// What is told once, or once more when it is renewed.
enum class Once : std::uint8_t {
    AfterEnd,  // blocks behind M30; anew behind another one
    Diameter,  // a lathe's X is not said to be one
    Feed,      // none was ever set
    NoTool,    // none was ever called
    Plane,     // the tool's length turns with it
    Rapid,     // into the work, while the spindle stands
    SpindleInDoubt,
    SpindleStopped,
};

class ToldOnce {
  public:
    bool has_told(Once what) const { return (told_ >> bit_of(what) & 1u) != 0; }
    void count_as_told(Once what) { told_ |= 1u << bit_of(what); }
    /// Whether it is to be told: from here on it counts as told.
    [[nodiscard]] bool first_time(Once what) {
        const bool is_first = !has_told(what);
        count_as_told(what);
        return is_first;
    }
    /// It is told anew when it comes again.
    void renew(Once what) { told_ &= ~(1u << bit_of(what)); }
    /// The spindle was switched: what was said of it is said anew.
    void renew_spindle() {
        renew(Once::SpindleStopped);
        renew(Once::Rapid);
    }

  private:
    static unsigned bit_of(Once what) { return static_cast<unsigned>(what); }

    std::uint32_t told_ = 0;
};

/// What is told once at a place of the program, until it is told at another.
enum class OnceAt : std::uint8_t {
    Spline,     // the control has none
    Tap,        // the control has cycles, but none that taps as the call says
    Tolerance,  // the control's increments do not let a curve keep it
};

class ToldAt {
  public:
    /// Whether it is to be told there: from here on it counts as told.
    [[nodiscard]] bool first_time(OnceAt what, std::uint32_t at) {
        return std::exchange(places_[static_cast<std::size_t>(what)], at) != at;
    }

  private:
    std::array<std::uint32_t, 3> places_{};  // for each OnceAt
};

}  // namespace kadr::expand
