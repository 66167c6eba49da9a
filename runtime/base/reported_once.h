// reported_once.h — what is reported once and not again: each room has an enum of such things, and
// whoever reports them owns the flags.
#pragma once

#include <cstdint>

namespace kadr {

/// Flags of what has been reported.
///
/// What  an enum with less than 32 members
template <typename What>
class ReportedOnce {
  public:
    bool has_reported(What what) const { return (reported_ >> bit_of(what) & 1u) != 0; }
    void count_as_reported(What what) { reported_ |= 1u << bit_of(what); }
    /// Whether it is to be reported: from here on it counts as reported.
    [[nodiscard]] bool first_time(What what) {
        const bool is_first = !has_reported(what);
        count_as_reported(what);
        return is_first;
    }
    /// It is reported anew when it comes again.
    void renew(What what) { reported_ &= ~(1u << bit_of(what)); }

  private:
    static unsigned bit_of(What what) { return static_cast<unsigned>(what); }

    std::uint32_t reported_ = 0;
};

}  // namespace kadr
