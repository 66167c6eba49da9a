// done.h — what a function answers that may refuse.
//
// A name that is a verb and says Done (`require_plane`, `read_word`, `take_edge`) has done it, or
// has told why not and wants its caller to go no further. Whether that is `true` or `false` never
// has to be looked up. What only asks (`is_…`, `has_…`) answers with bool and tells nothing.
#pragma once

namespace kadr {

class [[nodiscard]] Done {
  public:
    constexpr explicit Done(bool is_done) : is_done_(is_done) {}

    constexpr explicit operator bool() const { return is_done_; }

  private:
    bool is_done_;
};

inline constexpr Done kDone{true};
inline constexpr Done kFailed{false};  // and the reason has been told

}  // namespace kadr
