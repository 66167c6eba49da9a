#include "control/base_frames.h"

namespace kadr::control {

namespace {

ControlFrame acting(const BaseFrames::Numbered& frames, unsigned mask) {
    ControlFrame whole;
    for (std::size_t i = 0; i < frames.size(); ++i)
        if ((mask >> i & 1u) != 0) whole = chain(whole, frames[i]);
    return whole;
}

}  // namespace

ControlFrame BaseFrames::numbered() const {
    return chain(acting(global, global_mask), acting(channel, channel_mask));
}

BaseFrames BaseFrames::without_numbered() const {
    BaseFrames rest;
    rest.set = set;
    rest.external = external;
    return rest;
}

}  // namespace kadr::control
