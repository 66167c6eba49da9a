// frame_variables.cpp — the frames of the run as variables of a program. S 6.1, 6.4.
#include "interp/channel.h"
#include "interp/programmed_frames.h"
#include "interp/splines.h"

namespace kadr::interp {

using nc::SystemQuantity;
using Write = ControlAccess::Write;

namespace {

constexpr bool is_global(SystemQuantity quantity) {
    return quantity == SystemQuantity::GlobalBaseFrame ||
           quantity == SystemQuantity::GlobalBaseNow || quantity == SystemQuantity::GlobalBaseMask;
}

constexpr bool is_numbered_base(SystemQuantity quantity) {
    return quantity == SystemQuantity::ChannelBaseFrame ||
           quantity == SystemQuantity::ChannelBaseNow ||
           quantity == SystemQuantity::GlobalBaseFrame || quantity == SystemQuantity::GlobalBaseNow;
}

/// Whether what is written waits until a work offset is called.
constexpr bool waits_for_call(SystemQuantity quantity) {
    return quantity == SystemQuantity::ChannelBaseFrame ||
           quantity == SystemQuantity::GlobalBaseFrame;
}

bool has_base_frame(std::int64_t number) {
    return number >= 0 && number < static_cast<std::int64_t>(control::BaseFrames::kEach);
}

/// The frame of a number.
template <typename Bases>
auto& numbered(Bases& bases, SystemQuantity quantity, std::int64_t number) {
    const auto i = static_cast<std::size_t>(number);
    return is_global(quantity) ? bases.global[i] : bases.channel[i];
}

}  // namespace

control::ControlFrame ProgrammedFrames::total_frame() const {
    const control::ControlFrame outside = chain(frames_.base(), frames_.work_offset());
    const control::ControlFrame inside = chain(frames_.programmable(), frames_.inner());
    if (!frames_.is_swivelled()) return chain(outside, inside);
    const control::ControlFrame planes =
        control::plain_frame(frames_.tool_frame() * frames_.tilt());
    return chain(control::plain_frame(frames_.tables()), chain(outside, chain(planes, inside)));
}

std::optional<control::ControlFrame> ProgrammedFrames::frame(SystemQuantity quantity,
                                                             std::int64_t number) {
    if (is_numbered_base(quantity)) {
        if (!has_base_frame(number)) return std::nullopt;
        const control::BaseFrames& bases =
            waits_for_call(quantity) ? stored_bases_.frames : frames_.bases();
        return numbered(bases, quantity, number);
    }
    switch (quantity) {
        case SystemQuantity::SettableFrame: {
            if (number < 0 || number > rules_.work_offsets) return std::nullopt;
            const auto i = static_cast<std::size_t>(number);
            return i < work_offsets_.size() ? work_offsets_[i] : control::ControlFrame();
        }
        case SystemQuantity::ActiveFrame: return frames_.work_offset();
        case SystemQuantity::BaseFrame: return frames_.bases().channel[0];
        case SystemQuantity::AllBaseFrames: return frames_.bases().numbered();
        case SystemQuantity::ExternalFrame: return frames_.bases().external;
        case SystemQuantity::SetFrame: return frames_.bases().set;
        case SystemQuantity::TableFrame: return control::plain_frame(frames_.tables());
        case SystemQuantity::ToolFrame: return control::plain_frame(frames_.tool_frame());
        case SystemQuantity::PlaneFrame: return control::plain_frame(frames_.tilt());
        case SystemQuantity::ProgrammableFrame: return frames_.programmable();
        case SystemQuantity::InnerFrame: return frames_.inner();
        case SystemQuantity::TotalFrame: return total_frame();
        default: return std::nullopt;
    }
}

Write ProgrammedFrames::set_frame(SystemQuantity quantity, std::int64_t number,
                                  const control::ControlFrame& frame, bool acts_at_once) {
    channel_.splines.finish_open_spline();
    if (quantity == SystemQuantity::SettableFrame) {
        if (number < 0 || number > rules_.work_offsets) return Write::NoSuchEntry;
        work_offset_at(number) = frame;
        work_offset_changed(number, acts_at_once);
        return Write::Done;
    }
    if (is_numbered_base(quantity)) {
        if (!has_base_frame(number)) return Write::NoSuchEntry;
        if (waits_for_call(quantity)) {
            numbered(stored_bases_.frames, quantity, number) = frame;
            std::uint16_t& fresh =
                is_global(quantity) ? stored_bases_.new_global : stored_bases_.new_channel;
            fresh = static_cast<std::uint16_t>(fresh | 1u << number);
            return Write::Done;
        }
        control::BaseFrames bases = frames_.bases();
        numbered(bases, quantity, number) = frame;
        frames_.select_bases(bases);
    } else if (!set_plain_frame(quantity, frame)) {
        return Write::Refused;
    }
    frame_changed();
    return Write::Done;
}

/// Frames of which there is one each. False: nobody sets this one.
bool ProgrammedFrames::set_plain_frame(SystemQuantity quantity,
                                       const control::ControlFrame& frame) {
    control::BaseFrames bases = frames_.bases();
    switch (quantity) {
        case SystemQuantity::ActiveFrame: frames_.select_work_offset(frame); return true;
        case SystemQuantity::ProgrammableFrame: frames_.set_programmable(frame); return true;
        case SystemQuantity::InnerFrame: frames_.select_inner(frame); return true;
        case SystemQuantity::BaseFrame: bases.channel[0] = frame; break;
        case SystemQuantity::ExternalFrame: bases.external = frame; break;
        case SystemQuantity::SetFrame: bases.set = frame; break;
        case SystemQuantity::TableFrame: frames_.set_tables(frame.whole()); return true;
        case SystemQuantity::ToolFrame: {
            const path::Frame whole = frame.whole();
            const bool is_nothing = path::is_nothing(whole);
            frames_.set_tool_frame(is_nothing ? std::nullopt : std::optional(whole));
            return true;
        }
        case SystemQuantity::PlaneFrame: frames_.set_tilted_plane(frame.whole()); return true;
        default: return false;
    }
    frames_.select_bases(bases);
    return true;
}

/// What was written of base frames acts from now on.
void ProgrammedFrames::select_stored_bases() {
    StoredBases& stored = stored_bases_;
    if (stored.new_channel == 0 && stored.new_global == 0) return;
    control::BaseFrames bases = frames_.bases();
    for (std::size_t i = 0; i < control::BaseFrames::kEach; ++i) {
        if ((stored.new_channel >> i & 1u) != 0) bases.channel[i] = stored.frames.channel[i];
        if ((stored.new_global >> i & 1u) != 0) bases.global[i] = stored.frames.global[i];
    }
    stored.new_channel = stored.new_global = 0;
    frames_.select_bases(bases);
}

Write ProgrammedFrames::set_base_mask(SystemQuantity quantity, double mask) {
    constexpr double kMost = 0xffff;
    if (!(mask >= 0 && mask <= kMost)) return Write::TooLarge;
    channel_.splines.finish_open_spline();
    control::BaseFrames bases = frames_.bases();
    (is_global(quantity) ? bases.global_mask : bases.channel_mask) =
        static_cast<std::uint16_t>(mask);
    frames_.select_bases(bases);
    frame_changed();
    return Write::Done;
}

void ProgrammedFrames::restore_frames(bool is_wanted) {
    if (kept_frames_.empty()) return;
    if (is_wanted) {
        go_back_to(kept_frames_.back().frames);
        work_offset_ = kept_frames_.back().work_offset;
        frame_changed();
    }
    kept_frames_.pop_back();
}

}  // namespace kadr::interp
