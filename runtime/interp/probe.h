// probe.h — the probe: where it triggers on its path, and what it has found. Internal to interp.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "control/frames.h"
#include "interp/axis_data.h"
#include "interp/block_actions.h"
#include "interp/interpreter.h"
#include "interp/modes.h"
#include "interp/reporter.h"
#include "path/command.h"

namespace kadr::interp {

class Probe {
  public:
    /// scene    what the probe meets; null: nobody knows
    /// touches  where it triggers, given from outside; they have to live as long
    Probe(const machine::ProbeScene* scene, std::span<const ProbeTouch> touches)
        : scene_(scene), touches_(touches) {}

    bool knows_touches() const { return scene_ != nullptr || !touches_.empty(); }
    const machine::ProbeScene* scene() const { return scene_; }
    /// Touches whose block has not probed so far.
    std::vector<ProbeTouch> touches_ahead() const;

    /// What is reported for a block.
    struct Event {
        bool is_given = false;
        std::optional<double> part;  // of the path; nothing: it does not trigger
    };
    /// The part of the path that is reported for the block. Of several for one block each is for
    /// one run of it, the last one for all behind.
    Event touch_of_event(const nc::Block& block, const ProgrammedMove& move, const AxisData& axes,
                         ProgrammedUnits units, Reporter& reporter);

    /// A part stays where it is, whatever becomes of the offset that gives its nominal position.
    bool has_part() const { return part_.has_value(); }
    void place_part(const control::ControlFrame& frame) { part_ = frame; }
    struct SceneMove {
        path::Vec3 from;  // the probe's tip, in the base system, mm
        path::Vec3 to;
        double tool_radius;  // where the scene has none, mm
        Axis tool_axis;
        bool springs_back;  // it has touched, and triggers where it is free
    };
    /// The part of the path up to a surface of the scene; nothing: it meets none.
    std::optional<double> touch_of_scene(const SceneMove& move) const;

    const std::optional<Probed>& found() const { return found_; }
    void find(const Probed& probed) { found_ = probed; }
    double kept() const { return kept_; }
    void keep(double coordinate) { kept_ = coordinate; }

  private:
    const ProbeTouch* take_touch(const nc::Block& block);

    const machine::ProbeScene* scene_;
    std::span<const ProbeTouch> touches_;
    std::vector<bool> touches_done_;             // of touches_: the block has probed
    std::optional<control::ControlFrame> part_;  // of the surfaces that the probe meets
    std::optional<Probed> found_;                // by the latest probing
    double kept_ = 0;                            // a coordinate that was measured
};

}  // namespace kadr::interp
