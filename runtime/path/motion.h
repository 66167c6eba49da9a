// motion.h — what a command has of a motion: its end, its shape, its feed, and its orientation.
//
// A motion has no start: that is the end of the motion before, so that they stay joined when a
// stage moves an end. Rare parts are boxed; where they are not there, nothing is given of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <variant>

#include "base/axes.h"
#include "base/boxed.h"
#include "path/contact.h"
#include "path/dynamics.h"
#include "path/op.h"
#include "path/orient_kind.h"
#include "path/parametric.h"
#include "path/spline.h"
#include "path/virtual_axes.h"

namespace kadr::path {

enum class FeedMode : std::uint8_t { PerMinute, PerRevolution, InverseTime };
enum class Plane : std::uint8_t { Xy, Zx, Yz };

/// How the corner behind a motion is blended, if the next motion lets it.
enum class BlendKind : std::uint8_t {
    None,
    Distance,   // from `size` before the corner to as far behind it, at most
    Tolerance,  // leaving the programmed path by `size` at most
};
struct Blending {
    BlendKind kind = BlendKind::None;
    bool with_tangents = false;  // also where only the curvature jumps
    double size = 0;             // mm
    /// So far the tool's direction may leave the programmed one meanwhile, rad.
    double orientation = std::numeric_limits<double>::infinity();
    /// Where the tip is not led around the corner, the tool is: the tip stays on its path.
    bool smooths_orientation = false;

    friend bool operator==(const Blending&, const Blending&) = default;
};

// ------------------------------------------------------------------------------ shapes

/// Straight; so are a line, a thread and a probe.
struct RapidShape {};
struct LineShape {};

/// Runs counter-clockwise about `normal` by `sweep` while the height along it grows evenly. The
/// radius goes linearly from the start's to the end's (within the control's tolerance).
struct ArcShape {
    Vec3 center = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ();
    double sweep = 0;           // rad, > 0, additional turns included
    double turns = 0;           // additional full turns, as programmed
    bool is_clockwise = false;  // in the plane of the base system, mirrors worked in; for listings
};

/// Of a circle about `center`, counter-clockwise about `normal` from where the tool is to the end;
/// the height along the normal grows evenly with the path.
struct InvoluteShape {
    Vec3 center = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ();
    double base_radius = 0;     // of the circle, mm
    bool is_clockwise = false;  // as of an arc
};

struct ThreadShape {
    double pitch_change = 0;  // by how much the feed changes in a revolution, mm/rev
    double start_deg = 0;     // angle of the spindle at its start
};
struct ProbeShape {};

/// In the order of their commands' names: the op of a motion is the index of its shape. A spline is
/// one span, from where the tool is.
using Shape = std::variant<RapidShape, LineShape, ArcShape, Boxed<SplineShape>, InvoluteShape,
                           Boxed<CurveShape>, ThreadShape, ProbeShape>;
static_assert(std::variant_size_v<Shape> == static_cast<std::size_t>(Op::Probe) + 1);

// ------------------------------------------------------------------------------ the motion

/// Orientation interpolation that is not by the axes: fields as of an OrientLaw, but over the whole
/// motion: `angle` is rad and `axis` of a Point mm from its start to the end, lead and tilt go from
/// the first to the second.
struct OrientDetails {
    Vec3 from = Vec3::UnitZ();  // Surface, Point
    Vec3 axis = Vec3::Zero();   // Cone, Surface, Point
    double angle = 0;           // Cone, Surface; by the right-hand rule
    double outwards = 0;        // Point
    LeadTiltAngles lead_tilt;   // Surface
};

/// The alternative that is there. To ask for another one is a fault of Kadr.
template <typename T, typename... Others>
const T& read_as(const std::variant<Others...>& what) {
    const T* const found = std::get_if<T>(&what);
    KADR_ASSERT(found != nullptr, "a command is read as one of another kind");
    return *found;
}
template <typename T, typename... Others>
T& read_as(std::variant<Others...>& what) {
    T* const found = std::get_if<T>(&what);
    KADR_ASSERT(found != nullptr, "a command is read as one of another kind");
    return *found;
}

struct Motion {
    AxisValues to{};  // end position of every axis, mm and deg
    Shape shape;

    double feed = 0;  // mm/min, mm/rev or 1/min, by feed_mode; of a thread mm/rev
    FeedMode feed_mode = FeedMode::PerMinute;
    Plane plane = Plane::Xy;
    AxisMask moved = 0;                // axes that the block programmed
    bool machine_coordinates = false;  // `to` is in machine coordinates, tool length not counted
    bool keeps_feed = false;           // no override of the feed acts, as when tapping
    bool ignores_hold = false;         // a hold waits until the motions with this are through
    bool exact_stop = false;           // ends at rest
    /// Orientation interpolation under a transformation: `to` is the tip in the workpiece system or
    /// in virtual coordinates, and where the rotary axes stand there.
    OrientKind orient_kind = OrientKind::None;
    Blending blending;    // of the corner behind it; none where it ends at rest
    double compress = 0;  // a line may become a part of a curve within this tolerance, mm; 0: it
                          // stays what it is
    Vec3 direction = Vec3::UnitZ();       // of the tool at the end, unit vector from tip to holder
    Boxed<OrientDetails> orient_details;  // Cone, Surface, Point
    Boxed<ContactMotion> contact;         // the path is that of the point where the cutter touches
    Boxed<VirtualAxes> virtual_system;  // in which the motion is given; its orientation stays then
    Boxed<Dynamics> dynamics;           // where they are programmed

    Op op() const { return static_cast<Op>(shape.index()); }
    /// Another op, with a shape of which nothing is given yet; all else stays.
    void become(Op op);

    // The shape, by its name.
    const ArcShape& arc() const { return read_as<ArcShape>(shape); }
    ArcShape& arc() { return read_as<ArcShape>(shape); }
    const SplineShape& spline() const { return *read_as<Boxed<SplineShape>>(shape); }
    SplineShape& spline() { return *read_as<Boxed<SplineShape>>(shape); }
    const InvoluteShape& involute() const { return read_as<InvoluteShape>(shape); }
    InvoluteShape& involute() { return read_as<InvoluteShape>(shape); }
    const CurveShape& curve() const { return *read_as<Boxed<CurveShape>>(shape); }
    CurveShape& curve() { return *read_as<Boxed<CurveShape>>(shape); }
    const ThreadShape& thread() const { return read_as<ThreadShape>(shape); }
    ThreadShape& thread() { return read_as<ThreadShape>(shape); }

    /// Orientation interpolation; the least where nothing is given of it.
    const OrientDetails& orientation() const;
    /// The tool goes with the axes, or does not change: nothing more is given of it.
    void orient_plainly(OrientKind how) {
        orient_kind = how;
        orient_details.reset();
    }
    /// Off where the motion is in no virtual coordinates.
    const VirtualAxes& virtual_axes() const;
};

}  // namespace kadr::path
