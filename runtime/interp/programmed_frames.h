// programmed_frames.h — work offsets and the frames of the program, and the position as they
// change.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// Work offsets and the frames of the program, and the position as they change.
class ProgrammedFrames {
  public:
    explicit ProgrammedFrames(Channel& channel);
    ProgrammedFrames(const ProgrammedFrames&) = delete;
    ProgrammedFrames& operator=(const ProgrammedFrames&) = delete;

    /// From the base system to the programmed one; S 6.1.
    control::ControlFrame total_frame() const;
    /// A frame by its variable; nothing: there is none of this number.
    std::optional<control::ControlFrame> frame(nc::SystemQuantity quantity, std::int64_t number);
    /// acts_at_once  or with the next call of a work offset
    ControlAccess::Write set_frame(nc::SystemQuantity quantity, std::int64_t number,
                                   const control::ControlFrame& frame, bool acts_at_once);
    /// Back to those of the latest keep_frames, or not: they are kept no longer.
    void restore_frames(bool is_wanted);
    /// Which base frames act, a bit for each number.
    ControlAccess::Write set_base_mask(nc::SystemQuantity quantity, double mask);
    /// A block of data writes it: G10 L2.
    void write_work_offset(const nc::Block& block, const nc::Invocation& invocation);
    /// By its number; 0 is the external one. Made where there is none.
    control::ControlFrame& work_offset_at(std::int64_t number);
    /// mm or degrees.
    ControlAccess::Write set_work_offset(std::int64_t number, Axis axis, double value,
                                         bool acts_at_once);
    /// 0: none acts.
    void select_work_offset(const nc::Block& block, std::int64_t number);
    /// A change of the frames by words that name axes.
    void change_frame(const nc::Block& block, const nc::Invocation& invocation,
                      void (control::Frames::*change)(const control::FrameWords&));
    /// The position where the tool stands gets other coordinates.
    void set_position(const nc::Block& block, const nc::Invocation& invocation);
    /// … or has those of its work offset again.
    void reset_position(const nc::Block& block, const nc::Invocation& invocation);
    /// In the working plane, about the centre that the words name.
    void rotate(const nc::Block& block, const nc::Invocation& invocation);
    /// Behind it some controls want a coordinate of each axis of the plane.
    void end_rotation();
    void end_scaling();
    /// Of the named axes; of all if it names none.
    void end_mirroring(const nc::Block& block, const nc::Invocation& invocation);
    /// One factor, or one for each axis; the axes that are not given keep their size.
    void scale(const nc::Block& block, const nc::Invocation& invocation);
    /// About X, Y and Z, as far as they are named.
    void rotate_in_space(const nc::Block& block, const nc::Invocation& invocation);
    /// Whether the block is one like any other, to positions of the tip in machine coordinates: it
    /// is compensated and blended, and it may be an arc or a thread. S 6.3.
    bool is_without_frames(const Actions& actions) const;
    /// For this block no frame acts.
    Done take_frames_off(const nc::Block& block);
    /// Behind the motion of a block in machine coordinates.
    void put_frames_back(const nc::Block& block);
    /// No axis moves when a frame changes, but the tool has other coordinates now.
    void frame_changed();
    /// Those of the machine act, and of its work offsets the one that acts at power on.
    void begin();
    /// The frames that acted at another time; the position is seen in them by frame_changed.
    void go_back_to(const control::Frames& frames) { frames_ = frames; }
    void keep_frames() { kept_frames_.push_back({frames_, work_offset_}); }
    /// A block in machine coordinates has taken the frames off for its motion.
    bool are_off() const { return frames_off_.has_value(); }

  private:
    struct KeptFrames {
        control::Frames frames;
        std::int64_t work_offset;
    };
    /// Base frames that were written and act when a work offset is called next.
    struct StoredBases {
        control::BaseFrames frames;
        std::uint16_t new_global = 0;  // a bit for each number
        std::uint16_t new_channel = 0;
    };
    /// What a block in machine coordinates goes back to behind it.
    struct FramesOff {
        control::Frames frames;
        Position before;
    };
    bool set_plain_frame(nc::SystemQuantity quantity, const control::ControlFrame& frame);
    void select_stored_bases();
    control::ControlFrame work_offset_frame(std::int64_t number) const;
    void work_offset_changed(std::int64_t number, bool acts_at_once);
    void let_comp_go(const nc::Block& block, const nc::Invocation& invocation);
    control::FrameWords words_of_frame(const nc::Block& block,
                                       const nc::Invocation& invocation) const;
    Done require_no_places(const nc::Block& block, const nc::Invocation& invocation);
    void name_position(const control::FrameWords& words);
    Done require_named_axes(const nc::Block& block, const nc::Invocation& invocation,
                            AxisMask named);
    control::FrameWords center_of(const nc::Block& block, const nc::Invocation& invocation) const;

    Channel& channel_;
    std::vector<control::ControlFrame>& work_offsets_;
    std::int64_t& work_offset_;
    Reporter& reporter_;
    const nc::Rules& rules_;
    const Modal& modal_;
    Position& position_;
    control::Frames& frames_;
    const RadiusCompState& comp_;
    AxisMask& unplaced_;
    const AxisData& axes_;
    const ModalCycles& modal_cycles_;
    std::vector<KeptFrames> kept_frames_;  // of programs that go back to them
    StoredBases stored_bases_;
    std::optional<FramesOff> frames_off_;
};

}  // namespace kadr::interp
