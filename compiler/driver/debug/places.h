// places.h — the points of a program that somebody has named, and whether the run came to them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "driver/debug/break_points.h"

namespace kadr::driver {

/// Names a place as long as there is one.
struct PlaceId {
    std::uint32_t number = 0;  // 0: none
    bool is_valid() const { return number != 0; }
    friend bool operator==(PlaceId, PlaceId) = default;
};

struct WatchedPlace {
    enum class Effect : std::uint8_t {
        Stops,  // the run stands in front of it
        Ends,   // the program ends in front of it
    };
    PlaceId id;
    BreakPoint point;
    Effect effect = Effect::Stops;
    bool was_reached = false;
};

class Places {
  public:
    PlaceId add(BreakPoint point, WatchedPlace::Effect effect);
    void remove(PlaceId id);
    bool is_empty() const { return places_.empty(); }
    std::span<const WatchedPlace> all() const { return places_; }
    /// Null: there is none any more.
    const WatchedPlace* find(PlaceId id) const;
    /// The first one with this effect that the arrival is at; null: none. All of them are reached.
    const WatchedPlace* reach(const StopArrival& arrival, WatchedPlace::Effect effect);

  private:
    std::vector<WatchedPlace> places_;
    std::uint32_t last_ = 0;  // number that was given
};

}  // namespace kadr::driver
