#include "driver/debug/places.h"

#include <algorithm>
#include <utility>

namespace kadr::driver {

PlaceId Places::add(BreakPoint point, WatchedPlace::Effect effect) {
    const PlaceId id{++last_};
    places_.push_back({id, std::move(point), effect, false});
    return id;
}

void Places::remove(PlaceId id) {
    std::erase_if(places_, [id](const WatchedPlace& place) { return place.id == id; });
}

const WatchedPlace* Places::find(PlaceId id) const {
    const auto found = std::ranges::find(places_, id, &WatchedPlace::id);
    return found == places_.end() ? nullptr : &*found;
}

const WatchedPlace* Places::reach(const StopArrival& arrival, WatchedPlace::Effect effect) {
    const WatchedPlace* found = nullptr;
    for (WatchedPlace& place : places_) {
        if (place.effect != effect || !place.point.is_at(arrival)) continue;
        place.was_reached = true;
        if (found == nullptr) found = &place;
    }
    return found;
}

}  // namespace kadr::driver
