// frames.h — the frames in force: work offset, set position, programmable frame.
//
// base = table : tables : set shift + base frames : work offset : tool frame : tilted plane :
// programmable frame : inner frame (programmed point). Keeps the product and its inverse ready, so
// that a block pays for frames only when one changes.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "control/base_frames.h"
#include "control/control_frame.h"
#include "nc/rules.h"
#include "path/frame.h"

namespace kadr::control {

/// Words of a frame function: which of X, Y, Z were given, and their values, mm.
struct FrameWords {
    AxisValues values{};
    unsigned given = 0;  // bit 0: X …; of rotations, scales and mirrors up to Z
    bool has(std::size_t i) const { return (given >> i & 1u) != 0; }
};

class Frames {
  public:
    explicit Frames(const nc::Rules& rules) : rules_(&rules) {}

    void select_work_offset(const ControlFrame& offset);
    void select_bases(const BaseFrames& bases);
    /// Inside of all others.
    void select_inner(const ControlFrame& inner);
    /// Outside of all others: from the position where the table stands into the workpiece.
    void set_table(const path::Frame& table);
    const ControlFrame& work_offset() const { return work_offset_; }
    const BaseFrames& bases() const { return bases_; }
    /// All base frames, one behind the other.
    const ControlFrame& base() const { return base_; }
    const ControlFrame& inner() const { return inner_; }
    void release_table();
    /// What the functions below have made, and in its place another one.
    ControlFrame programmable() const;
    void set_programmable(const ControlFrame& frame);
    /// Of the programmable frame, mm: what stands before its rotations, scales and mirrors.
    path::Vec3 own_shift() const;
    void shift(const FrameWords& words);
    void shift_add(const FrameWords& words);
    /// The shift of the named axes, and what was added to it.
    void set_coarse(const FrameWords& words);
    void set_fine(const FrameWords& words);
    /// A rotation in space, about the origin reached so far.
    void turn(const path::Mat3& rotation);
    /// angle   rad
    /// center  in the system reached so far; what is not given is its origin
    void rotate(path::Plane plane, double angle, const FrameWords& center);
    void rotate_off();
    /// factors  along X, Y, Z, none of them 0
    void scale(const path::Vec3& factors, const FrameWords& center);
    void scale_off();
    bool is_scaled() const;
    /// The larger one of the factors by which the plane's axes are scaled.
    double larger_factor(path::Plane plane) const;
    /// Each axis that is named, about its coordinate in the system reached so far.
    void mirror(const FrameWords& words);
    /// No axes: all of them.
    void mirror_off(AxisMask axes);
    /// The tool stands at `base`; the words given are the coordinates that it gets, `here` the
    /// others'. Moves the origin of every work offset.
    void set_position(const FrameWords& words, const AxisValues& here, const AxisValues& base);

    /// The machine's own coordinates of an axis, outside of all frames, count from another zero.
    void preset(Axis axis, double by);
    /// Takes back what set_position and shift have done to these axes.
    void reset_position(AxisMask axes);

    /// From the workpiece as it lies with all tables at zero, to where they have turned it.
    void set_tables(const path::Frame& tables);
    const path::Frame& tables() const { return tables_; }
    /// A tilted plane, programmed in the system of the work offset.
    void set_tilted_plane(const path::Frame& tilt);
    const path::Frame& tilt() const { return tilted_plane_frame_; }
    /// A frame along the tool, outside of the tilted plane; nothing: none.
    void set_tool_frame(const std::optional<path::Frame>& frame);
    bool has_tool_frame() const { return has_tool_frame_; }
    const path::Frame& tool_frame() const { return tool_frame_; }
    /// Whether one of the three frames above is not nothing.
    bool is_swivelled() const { return is_swivelled_; }
    /// From the tool frame inwards: tilted plane, programmable and inner frame.
    path::Frame inside_tool_frame() const;
    /// From the base system, without tables, to the work offset.
    path::Frame outside_tool_frame() const;

    /// What is left of them in a block in machine coordinates (MachineCoordinates of
    /// nc/vocabulary.def).
    Frames machine_frames(std::int64_t keeps) const;

    AxisValues to_base(const AxisValues& programmed) const;
    AxisValues from_base(const AxisValues& base) const;
    bool is_rotated() const;
    AxisMask mirrored() const;
    /// Whether circles of the plane become ellipses.
    bool is_stretched(path::Plane plane) const;
    /// Whether what is seen from the normal of the plane is seen in a mirror.
    bool is_mirrored(path::Plane plane) const;
    /// Whether the plane does not lie as the plane of the base system does.
    bool is_plane_tilted(path::Plane plane) const;
    /// Nothing but a shift: each axis can be worked out by itself.
    bool is_shift() const { return is_shift_; }
    const AxisValues& shift_values() const { return shift_values_; }
    const path::Frame& total() const { return total_; }

  private:
    /// A step of the programmable frame behind the shift; the kind decides what deletes it.
    struct Step {
        enum class Kind : std::uint8_t { Shift, Rotation, Scale, Mirror };
        Kind kind;
        path::Frame frame;
    };

    void append(Step::Kind kind, const path::Frame& frame);
    void erase(Step::Kind kind);
    /// No axes: all of them.
    void erase_mirrors(AxisMask axes);
    AxisMask mirrored_by_steps() const;
    void update();

    const nc::Rules* rules_;
    path::Frame tables_;
    BaseFrames bases_;
    ControlFrame base_;  // their product
    ControlFrame work_offset_;
    std::optional<path::Frame> table_;
    path::Frame tool_frame_;
    path::Frame tilted_plane_frame_;
    bool has_tool_frame_ = false;
    bool is_swivelled_ = false;  // one of the three frames is not nothing
    AxisValues set_shift_{};
    AxisValues shift_{};
    AxisValues fine_{};        // added before any step
    std::vector<Step> steps_;  // in the order in which they were programmed
    ControlFrame inner_;
    path::Frame total_;
    path::Frame back_;
    AxisValues shift_values_{};  // of all axes, if is_shift_
    bool is_shift_ = true;
};

}  // namespace kadr::control
