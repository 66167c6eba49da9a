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

    /// Another member of the groups of the tool's turning and of its words.
    void choose(nc::Function member);
    void choose_point_to_point(nc::Function function);
    /// A work offset stands behind the switch.
    void offset_is_said() { orienting_.owes_offset = false; }

    Done require_transformation(const nc::Block& block, const nc::Invocation& invocation);
    void switch_transformation(const nc::Block& block, const nc::Invocation& invocation);
    std::array<std::size_t, 2> joints_in_order() const;
    Done require_no_spline(const nc::Block& block, nc::Function function);
    Done require_no_lone_axis(const nc::Block& block, nc::SlotMask targets);
    void begin_length_transformation(const nc::Block& block, const nc::Invocation& invocation,
                                     Actions& actions);
    void end_length_transformation(Actions& actions);
    void check_offset_programmed(const nc::Block& block);
    Done require_allowed_under_tcp(const nc::Block& block, nc::Function function);
    path::Vec3 joints_of(const AxisValues& base) const;
    AxisMask joint_axes() const;
    AxisValues machine_axes() const;
    AxisValues machine_axes_at(const AxisValues& base) const;
    bool is_transformed() const { return orienting_.is_on || virtual_.axes.is_on(); }

    /// The axes stand; the tip has another place in the base system.
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
    ReportedInRun& told_;
    const AxisValues& length_shift_;
};

}  // namespace kadr::interp
