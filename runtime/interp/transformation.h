// transformation.h — the transformation of the machine: X, Y and Z are the tip in the workpiece.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// The transformation of the machine: X, Y and Z are the tip in the workpiece.
class Transformation {
  public:
    explicit Transformation(Channel& channel);
    Transformation(const Transformation&) = delete;
    Transformation& operator=(const Transformation&) = delete;

    /// Another member of the groups of orientation interpolation and of orientation words.
    void choose(nc::Function member);
    /// PTP, CP and PTPG0.
    void choose_point_to_point(nc::Function function);
    /// A work offset stands behind the switch.
    void offset_is_given() { orienting_.owes_offset = false; }

    /// The transformation that a block asks for by its number and its data is the machine's. The
    /// tool at base position and the zeros of the rotary axes are the machine file's, and the axes
    /// follow them in the motion too. S 7.1.
    Done require_transformation(const nc::Block& block, const nc::Invocation& invocation);
    /// The axes stay where they are; what changes is the system in which the tip is programmed.
    /// S 7.1.
    void switch_transformation(const nc::Block& block, const nc::Invocation& invocation);
    /// The joints as the control counts its rotary axes 1 and 2. Of a head or a table alone axis 1
    /// carries axis 2; of both, axis 1 is the head's. S 6.5, 7.1.
    std::array<std::size_t, 2> joints_in_order() const;
    /// Inside of a spline no other coordinate system begins. S 7.1: 14402.
    Done require_no_spline(const nc::Block& block, nc::Function function);
    /// An axis that the transformation moves does not move by itself. S 7.1: 17610.
    Done require_no_lone_axis(const nc::Block& block, nc::SlotMask targets);
    /// As a kind of tool length compensation: the position in the program stays, and X, Y and Z are
    /// from here on the tip in the workpiece as it lies now. F 4.7.
    void begin_length_transformation(const nc::Block& block, const nc::Invocation& invocation,
                                     Actions& actions);
    /// The axes stand; the control's point goes back along the tool to where it is without a
    /// length.
    void end_length_transformation(Actions& actions);
    /// Whether a machine's transformation takes the work offset off is a matter of its set-up: what
    /// is programmed behind it acts on each. S 7.1. Reported once, of the first motion.
    void check_offset_programmed(const nc::Block& block);
    /// What the control refuses while its transformation is a kind of tool length compensation.
    /// F 4.7: PS5421.
    Done require_allowed_under_tcp(const nc::Block& block, nc::Function function);
    /// R1, R2, Psi, rad, of the axes' positions in degrees.
    path::Vec3 joints_of(const AxisValues& base) const;
    /// The rotary axes of the kinematics.
    AxisMask joint_axes() const;
    /// Where the axes of the machine stand.
    AxisValues machine_axes() const;
    /// Machine positions, mm and degrees, where the tip is there in the base system.
    AxisValues machine_axes_at(const AxisValues& base) const;
    bool is_transformed() const { return orienting_.is_on || virtual_.axes.is_on(); }

    /// The axes stand; the tip has another position in the base system.
    void take_position(const AxisValues& base);

  private:
    Channel& channel_;
    const nc::Dialect& dialect_;
    const machine::Machine& machine_;
    const std::int64_t& work_offset_;
    Reporter& reporter_;
    const nc::Rules& rules_;
    const Modal& modal_;
    Position& position_;
    control::Frames& frames_;
    const Tool& tool_;
    Orienting& orienting_;
    const Tilting& tilted_plane_;
    const Virtual& virtual_;
    const RadiusCompState& comp_;
    ReportedInRun& reported_;
    const AxisValues& length_shift_;
};

}  // namespace kadr::interp
