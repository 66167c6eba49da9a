// done.h — what a function answers that may refuse.
//
// A name that is a verb and returns Done (`require_plane`, `read_word`, `take_edge`) has done it,
// or has reported why not and wants its caller to go no further. Whether that is `true` or `false`
// never has to be looked up. What only asks (`is_…`, `has_…`) answers with bool, in silence.
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
inline constexpr Done kFailed{false};  // and the reason has been reported

}  // namespace kadr
