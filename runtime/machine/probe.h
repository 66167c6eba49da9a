// probe.h — where a touch probe meets something: solids of the set-up, and the first contact of its
// ball on a straight path.
//
// Geometry alone; which motions probe and what becomes of a touch is the interpreter's matter.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "base/xml.h"
#include "path/vec3.h"

namespace kadr::machine {

/// Material. A plane bounds it on one side, a block lies between two corners, a boss is a cylinder
/// along Z below its upper centre.
struct ProbeSolid {
    enum class Kind : std::uint8_t { Plane, Block, Boss };
    Kind kind = Kind::Block;
    path::Vec3 from = path::Vec3::Zero();  // Block: the lower corner; Boss: the upper centre
    path::Vec3 to = path::Vec3::Zero();    // Block: the upper corner
    std::size_t axis = 2;                  // Plane: across it, 0 X
    double at = 0;                         // Plane: mm
    bool is_above = false;                 // Plane: the material is
    double radius = 0;                     // Boss: mm
    double height = std::numeric_limits<double>::infinity();  // Boss: mm
};

/// A hole in the material along Z, open upwards.
struct ProbeBore {
    path::Vec3 center = path::Vec3::Zero();                  // of its mouth
    double radius = 0;                                       // mm
    double depth = std::numeric_limits<double>::infinity();  // mm
};

/// What the probe of a machine meets.
struct ProbeScene {
    std::optional<double> radius;  // of the ball, mm; nothing: that of the tool in the spindle
    bool is_center_given = false;  // the tool's length ends at the ball's centre, not below it
    std::int64_t offset = 0;  // the coordinates are those of this work offset; 0: of the machine
    path::Vec3 error = path::Vec3::Zero();  // by which everything lies wrong, mm
    std::vector<ProbeSolid> solids;
    std::vector<ProbeBore> bores;
};

/// How far a point is from the material, mm; not above 0: it is inside. Exact outside, but where
/// two surfaces of different solids are near alike.
double distance_to_material(const ProbeScene& scene, const path::Vec3& point);

/// The part of a straight path, 0 to 1, at which a ball on it first meets the material. Who begins
/// at the material and leaves it does not meet it. Nothing: it never does.
///
/// from, to  centre of the ball, mm, in the coordinates of the scene
/// radius    of the ball, mm, ≥ 0
std::optional<double> first_touch(const ProbeScene& scene, const path::Vec3& from,
                                  const path::Vec3& to, double radius);
/// The part at which a ball that begins at the material is clear of it; nothing: it is not.
std::optional<double> first_release(const ProbeScene& scene, const path::Vec3& from,
                                    const path::Vec3& to, double radius);

/// `<probe>` of a machine file. Every mistake is reported with its location.
ProbeScene read_probe(const XmlElement& element, DiagnosticSink& sink);

}  // namespace kadr::machine
