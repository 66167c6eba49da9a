// virtual_plane.h — polar coordinate interpolation, cylinders and inclined axes: planes that the
// machine does not have.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// Polar coordinate interpolation, cylinders and inclined axes: planes that the machine does not
/// have.
class VirtualPlane {
  public:
    explicit VirtualPlane(Channel& channel);
    VirtualPlane(const VirtualPlane&) = delete;
    VirtualPlane& operator=(const VirtualPlane&) = delete;

    /// G12.1, TRANSMIT; G7.1, TRACYL; TRAANG.
    void begin_virtual(const nc::Block& block, const nc::Invocation& invocation);
    /// The tool stays where it is, in the machine's own axes.
    void end_virtual(const nc::Block& block);
    /// A block whose words are those of the virtual coordinates; null if it was reported.
    const nc::Block* in_virtual(const nc::Block& block);
    /// From here on the rotary axis is followed through the commands that are put out.
    void follow_from_here();
    /// Writes in the commands that came out since it was last asked where the rotary axis is behind
    /// them.
    void follow_rotary();

  private:
    /// Where the commands that are out have led the tip and the rotary axis.
    struct Followed {
        std::size_t followed = 0;  // so many commands of this batch, and of those that wait
        path::Vec3 tip = path::Vec3::Zero();
        double at = 0;  // rad
    };
    void take_virtual_position(const path::Vec3& point);
    double virtual_angle() const;
    std::optional<path::VirtualAxes> wanted_virtual(const nc::Block& block,
                                                    const nc::Invocation& invocation);
    std::optional<path::VirtualAxes> wanted_polar_interpolation(const nc::Block& block);
    std::optional<path::VirtualAxes> wanted_cylinder(const nc::Block& block,
                                                     const nc::Invocation& invocation);
    std::optional<path::VirtualAxes> wanted_inclined(const nc::Block& block,
                                                     const nc::Invocation& invocation);
    void refuse_virtual(const nc::Block& block, nc::Function function);
    void refuse_virtual(const nc::Block& block, nc::Slot slot);
    Done require_virtual_words(const nc::Block& block);
    Done take_rotary_word(const nc::Block& block);
    void put_virtual_plane(path::Plane programmed);
    Done follow_leg_by_leg(const path::Command& command, const path::Curve& curve);

    Channel& channel_;
    const nc::Dialect& dialect_;
    const machine::Machine& machine_;
    Reporter& reporter_;
    const nc::Rules& rules_;
    CommandOutput& output_;
    Modal& modal_;
    Position& position_;
    const control::Frames& frames_;
    const Tool& tool_;
    const Orienting& orienting_;
    Virtual& virtual_;
    const RadiusCompState& comp_;
    const Compensation& compensation_;
    const ProgrammedUnits& units_;
    const AxisData& axes_;
    Followed rotary_;
    nc::Block around_{};  // a block whose rotary word has become a coordinate around
};

}  // namespace kadr::interp
