// state.h — what changes while a program runs, in small structs by concern.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "base/axes.h"
#include "control/cycle_levels.h"
#include "interp/modes.h"
#include "interp/position.h"
#include "interp/tool_offsets.h"
#include "nc/block.h"
#include "nc/rules.h"
#include "path/command.h"
#include "path/contour.h"
#include "path/radius_comp.h"

namespace kadr::interp {

/// The modal functions that a cycle finds and has to leave as they were.
struct Modal {
    nc::Function motion = nc::Function::Rapid;
    path::Plane plane = path::Plane::Xy;
    path::FeedMode feed_mode = path::FeedMode::PerMinute;
    bool is_incremental = false;
    bool has_exact_stop = false;
    bool taps = false;  // neither an override of the feed nor a hold acts
    Blend blend = Blend::None;
    bool has_feed = false;
    double feed = 0;  // unit of the feed mode
    /// F that is in force again behind a block with a feed of its own; S 2.3 FB.
    struct ModalFeed {
        bool is_given = false;
        double value = 0;
    };
    std::optional<ModalFeed> feed_behind;

    /// The feed of a block with one of its own: it acts until end_block_feed.
    void begin_block_feed(double value) {
        feed_behind = ModalFeed{has_feed, feed};
        has_feed = true;
        feed = value;
    }
    void end_block_feed() {
        if (!feed_behind) return;
        has_feed = feed_behind->is_given;
        feed = feed_behind->value;
        feed_behind.reset();
    }
    /// function  of the group PathMode
    void set_path_mode(nc::Function function);
    void move_by(nc::Function code) { motion = code; }
};

/// What the program takes from the operator, and how fast it lets its motions be.
struct PanelState {
    bool has_hold = true;
    bool has_override = true;  // of the feed
    bool has_exact_stop = true;
    Boxed<path::Dynamics> dynamics;  // none as long as nothing was programmed

    /// Of axes that position by themselves.
    struct Positioning {
        AxisValues speed;  // mm/s or rad/s; infinite: all that the axis has
        AxisValues part;   // of it
        bool is_given = false;

        Positioning() {
            speed.fill(std::numeric_limits<double>::infinity());
            part.fill(1);
        }
    };
    Positioning positioning;
    bool has_feed_characteristic = false;  // whatever follows was programmed once
    path::FeedCharacteristic feed_characteristic =
        path::FeedCharacteristic::Constant;  // of the feeds from here on
    path::FeedLaw polynomial;                // … of its block alone
};

/// Speeds of a spindle under constant cutting speed, rpm; 0: none.
struct SpeedLimits {
    double least = 0;
    double most = 0;

    friend bool operator==(const SpeedLimits&, const SpeedLimits&) = default;
};

struct ProgrammedSpindle {
    std::int64_t number = 1;
    path::SpindleMode mode = path::SpindleMode::Stop;
    double speed = 0;                // rpm
    double cutting_speed = 0;        // m/min; 0: never programmed
    double limit = 0;                // rpm under constant cutting speed; 0: none
    double least = 0;                // rpm, whatever is programmed …
    double most = 0;                 // … 0: none
    bool has_cutting_speed = false;  // constant cutting speed is on
    double angle_deg = 0;            // where it stands, if it is oriented

    /// What the motion side was commanded last.
    struct Commanded {
        path::SpindleMode mode = path::SpindleMode::Stop;
        double speed = 0;
        bool has_cutting_speed = false;
        friend bool operator==(const Commanded&, const Commanded&) = default;
    };
    Commanded commanded;
};

/// The tool and the length that should act, and the length that does.
struct Tool {
    enum class Source : std::uint8_t { None, Edge, Offset };  // of the length

    std::int64_t selected = 0;
    std::int64_t current = 0;  // in the spindle; 0 none
    Source source = Source::None;
    std::int64_t offset = 0;         // Source::Offset: number of the length offset
    bool is_taken_off = false;       // … and whether it counts the other way
    bool has_changed = false;        // the length that should act has to be looked up
    std::int64_t radius_offset = 0;  // number of the radius offset for compensation
    std::int64_t edge = 1;           // of the tool in the spindle
    std::int64_t sum = 0;            // number of the edge's sum offset; 0 none
    std::int64_t edge_called = 0;  // … that a block has programmed, for the tool that is selected

    path::Vec3 lengths = path::Vec3::Zero();  // in force along X, Y, Z, mm
    Axis axis = Axis::Z;                      // along which the chief one of them lies

    /// Number of the tool in the spindle with its edge, as ToolOffsets counts.
    std::int64_t edge_number() const {
        return current == 0 ? 0 : ToolOffsets::of_edge(current, edge);
    }
    /// Number of the edge or offset whose length should act.
    std::int64_t length_number() const { return source == Source::Edge ? edge_number() : offset; }
};

/// What the program adds to the data of the tool in the spindle, mm.
struct ExtraTool {
    path::Vec3 lengths = path::Vec3::Zero();  // of lengths 1 to 3
    path::Vec3 along = path::Vec3::Zero();    // … or along X, Y, Z
    double radius = 0;
};

/// What the program has chosen of the cutter radius compensation.
struct RadiusCompState {
    CompSide side = CompSide::Off;
    std::optional<nc::CompStart> start;    // nothing: as the control begins
    std::optional<nc::CompCorner> corner;  // likewise
    bool has_check = false;
    path::OpenEnd open_end = path::OpenEnd::None;
    std::optional<std::int64_t> feed;     // CompFeed by number; nothing: as the control begins
    double pointed = 0;                   // of arcs about corners, percent
    double allowance = 0;                 // mm
    CompKind system = CompKind::InPlane;  // chosen for where it begins next …
    bool is_in_frame = false;             // … in the plane that frames have tilted
    bool is_peripheral_code = false;      // … unless its own code means peripheral milling
    CompKind acting = CompKind::InPlane;  // where it has begun
    bool is_mirrored = false;             // … and whether a frame mirrored its plane there
    bool orients_on_arc = true;           // 3D: blocks at corners that only orient the tool
    double depth = 0;                     // 3D: of the contour above the tip, mm

    bool is_on() const { return side != CompSide::Off; }
    CompKind chosen() const { return is_peripheral_code ? CompKind::Peripheral : system; }
    bool is_face_milling_acting() const { return is_on() && is_face_milling(acting); }
    /// Whether the surface normals of blocks are the cutter's matter.
    bool takes_surface_normals() const {
        return is_face_milling_acting() || is_face_milling(chosen());
    }
};

/// What the program has chosen for smooth approaches and retractions.
struct ApproachChoice {
    enum class Side : std::uint8_t { OfCutter, Left, Right, OfTool };
    Side side = Side::OfCutter;
    bool in_steps = false;
};

/// What is programmed for corner blending and compressed lines, mm.
struct Smoothing {
    double feed_distance = 0;
    double rapid_distance = 0;
    std::optional<double> tolerance;    // mm; nothing: as the machine has it
    std::optional<double> orientation;  // rad; likewise
    bool compresses = false;
    bool smooths_orientation = false;  // of the tool, from motion to motion
};

/// How words of the orientation are understood, and how the orientation is interpolated.
struct OrientModes {
    OrientInterpolation interpolation = OrientInterpolation::Plane;
    ToolAngles angles = ToolAngles::Euler;
    ToolAngles euler = ToolAngles::Euler;  // what Euler's angles are on this control
    SpinFrom spin = SpinFrom::Fixed;
    bool is_in_base = false;  // orientations are programmed in the base system

    /// Whether the tool is led by a surface in every block.
    bool keeps_lead_tilt_to_surface() const {
        return interpolation == OrientInterpolation::Surface;
    }
};

/// What the program has chosen of the machine's transformation and of the orientation.
struct Orienting : OrientModes {
    bool is_on = false;          // X, Y and Z are the tip in the workpiece
    bool has_length = false;     // it was switched on as a kind of tool length compensation
    bool takes_vectors = false;  // … whose blocks program the tool's direction
    PointToPoint point_to_point = PointToPoint::None;
    int configuration = 0;           // wanted there, 1 or 2; 0: any
    double lead = 0;                 // deg, of a direction whose block does not program another one
    path::LeadTiltAngles lead_tilt;  // from the surface normal
    bool has_lead_tilt = false;  // … at the end of every block, until one programs a direction
    // Behind the latest motion, in the base system:
    std::optional<path::Vec3> normal;      // of the surface; nothing: none was yet programmed
    path::Vec3 rate = path::Vec3::Zero();  // how the tool's direction changed at its end
    std::optional<path::Vec3> point;       // the second point of the tool's axis
    bool owes_offset = false;              // a work offset is to be programmed behind the switch

    void lead_tilt_at_ends(bool is_wanted) { has_lead_tilt = is_wanted; }
};

/// What the words of one block program for the tool. Components and angles that are not programmed
/// are 0.
struct ToolWords {
    /// Three components of which bit i tells whether number i is programmed.
    struct Triple {
        std::array<double, 3> values{};
        std::uint8_t parts = 0;

        bool is_given() const { return parts != 0; }
        path::Vec3 vector() const { return path::Vec3(values.data()); }
        void set(std::size_t part, double to) {
            values[part] = to;
            parts = static_cast<std::uint8_t>(parts | 1u << part);
        }
    };
    Triple vector;
    Triple angles;                  // deg
    std::array<Triple, 2> normals;  // of the surface, at start and end
    Triple cone_axis;
    Triple between;
    Triple point;                   // mm, in the programmed system
    std::optional<double> opening;  // deg, of the cone
    std::optional<double> lead;     // deg, from the vector towards the direction of travel
    std::optional<double> spin;     // deg, about the tool
    std::optional<double> spin_by;  // deg
    bool changes_lead_tilt = false;
    std::optional<unsigned> signs;        // bit i: axis i of the machine shall stand below 0
    bool programs_configuration = false;  // of the rotary axes

    bool programs_direction() const { return vector.is_given() || angles.is_given(); }
    bool programs_surface() const {
        return changes_lead_tilt || normals[0].is_given() || normals[1].is_given();
    }
    /// Whether the block orients the tool even where no axis is named. A lead and a tilt act on
    /// travel.
    bool turns() const {
        const bool has_normal = normals[0].is_given() || normals[1].is_given();
        return programs_direction() || has_normal || point.is_given() || spin || spin_by;
    }
    bool is_any() const {
        return turns() || changes_lead_tilt || cone_axis.is_given() || between.is_given() ||
               opening || lead;
    }
};

/// What the blocks of one tilted plane have programmed so far, if it takes several.
struct OpenPlane {
    bool is_by_points = false;  // or by vectors
    bool is_added = false;
    unsigned next = 0;  // number of the block that has to come
    std::array<path::Vec3, 4> values{};
    path::Vec3 origin = path::Vec3::Zero();
    double turn = 0;  // rad
};

/// A tilted working plane, and how the rotary axes stand to it.
struct Tilting {
    bool is_on = false;      // a plane acts
    bool carries = false;    // frames lie on the turned tables, lengths along the inclined tool …
    bool on_tables = false;  // … or the frames do so alone
    path::Vec3 joints = path::Vec3::Zero();  // R1, R2, Ψ there, rad
    int turns = 0;  // rotations in space that made it; the tool lies along its Z
    std::optional<OpenPlane> open;
};

/// The polar, cylindrical or inclined-axis transformation that the program is written for.
struct Virtual {
    path::VirtualAxes axes;  // off: every axis by itself
    /// Of the program's words: the rotary one is the coordinate around, and in the plane with X
    /// (G18) arcs and compensation go the other way round.
    bool by_rotary = false;
    bool is_turned_over = false;
    path::Plane plane_before = path::Plane::Xy;
};

/// The tool orientation in a motion, as a Command has it.
struct OrientPlan {
    path::OrientKind orient_kind = path::OrientKind::Axes;
    path::Vec3 direction = path::Vec3::UnitZ();  // at the end
    path::Vec3 from = path::Vec3::UnitZ();
    path::Vec3 axis = path::Vec3::Zero();
    double angle = 0;
    path::LeadTiltAngles lead_tilt;
    bool is_made = false;  // else the tool stays as it stands
    /// Words that can be laid only where the path of the motion is known; null: there are none.
    const ToolWords* waiting = nullptr;
};

/// Polar coordinates, in the working plane of the programmed system.
struct Polar {
    bool is_on = false;         // the words of the plane's axes are radius and angle
    bool is_by_points = false;  // the end of the motion that acts is by angle and radius
    path::Vec2 pole = path::Vec2::Zero();
    double radius = 0;  // programmed last, mm
    double angle_deg = 0;
};

/// What the words of modal cycles have programmed: it holds for every further cycle in that mode.
struct CycleData {
    double initial = 0;  // level of the tool axis when the mode was entered
    control::CycleLevels levels;
    std::optional<double> stroke;
    std::optional<double> dwell;
};

/// Words beside a modal cycle that are not its own.
struct CycleWords {
    std::optional<double> stroke;
    std::optional<double> dwell;
    std::optional<double> times;
    std::optional<double> start_deg;  // angle at which the thread of this block begins
};

/// A cycle that is called, and repeated in every block with axis words while it is active.
struct ModalCycle {
    bool is_active = false;
    nc::CycleId cycle = 0;
    std::uint32_t given = 0;
    std::uint16_t by_form = 0;  // parameters that the code itself brings
    std::array<double, nc::kMaxArguments> arguments{};

    bool has(std::optional<std::size_t> parameter) const {
        return parameter && (given >> *parameter & 1u) != 0;
    }
    /// Nothing where the cycle has no such parameter.
    void set(std::optional<std::size_t> parameter, double value) {
        if (!parameter) return;
        arguments[*parameter] = value;
        given |= 1u << *parameter;
    }
};

}  // namespace kadr::interp
