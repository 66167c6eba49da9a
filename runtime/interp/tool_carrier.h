// tool_carrier.h — tool carriers that can be turned: what is programmed of them, and how one
// of them stands.
//
// A carrier is a chain of vectors with one or two rotary axes in it, on the side of the tool, of
// the workpiece, or one on each. It moves nothing: it turns the tool's lengths and shifts the
// workpiece as axes have turned it that somebody else has set. Blocks and frames are the
// executor's (carrier_words.cpp). S 7.1; the example in the function manual W1, chapter 4.1.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/axes.h"
#include "base/result.h"
#include "machine/machine.h"
#include "path/frame.h"

namespace kadr::interp {

/// Data of one carrier, by their numbers in $TC_CARR1 … : vectors in mm, angles in degrees.
struct CarrierData {
    static constexpr std::size_t kMost = 65;
    std::array<double, kMost + 1> values{};
    std::array<std::optional<Axis>, 2> axes;  // whose positions are its angles
    std::string kind = "T";
    std::array<std::string, 3> names;  // its own, and of its axes for cycles
};

class ToolCarriers {
  public:
    static constexpr std::int64_t kMostCarriers = 99;

    /// A machine with rotary axes has carrier 1 from its file.
    explicit ToolCarriers(const machine::Machine& machine);

    /// Null: nobody has given anything of it.
    const CarrierData* find(std::int64_t number) const;
    /// The carrier with this number, which must be 1 to 99, as it is to be written.
    CarrierData& at(std::int64_t number) { return carriers_[number]; }
    void clear() { carriers_.clear(); }

  private:
    std::map<std::int64_t, CarrierData> carriers_;
};

/// A carrier with its angles.
struct Carrier {
    enum class Kind : std::uint8_t { Tool, Part, Mixed };  // T, P, M

    Kind kind = Kind::Tool;
    std::array<path::Vec3, 4> offsets{};     // l1 to l4, mm
    std::array<path::Vec3, 2> directions{};  // v1, v2: unit vectors; zero: no axis
    std::array<double, 2> zeros{};           // angles at which nothing is turned, rad
    std::array<double, 2> angles{};          // rad
    std::array<double, 2> left_over{};       // that a grid of angles has rounded off, rad
    int solutions = 0;                       // of an orientation; 0: none was wanted

    path::Mat3 turn(std::size_t axis) const;
    /// How the tool is oriented, from where it stands with all angles at zero.
    path::Mat3 head() const;
    /// … and the workpiece.
    path::Mat3 table() const;
    /// From the tip to what the linear axes carry, for a tool with these lengths, mm.
    path::Vec3 length(const path::Vec3& lengths) const;
    /// How far the workpiece's zero has gone with the table, mm.
    path::Vec3 table_shift() const;
};

/// The chain of a carrier; nothing: its kind is none of T, P, M.
std::optional<Carrier> carrier_of(const CarrierData& data);

/// What TCOFR wants: the angles with which a direction of the tool is along one of the frame.
struct CarrierQuery {
    path::Vec3 tool = path::Vec3::UnitZ();   // of the tool that is not inclined, unit vector
    path::Vec3 frame = path::Vec3::UnitZ();  // in the frame, on a table that is not turned
    std::array<double, 2> near{};            // the solution next to these is taken, rad
};

enum class CarrierFault : std::uint8_t {
    Unreachable,  // no angles lead there
    Limits,       // those that do lie outside of the limits
};

/// The carrier with the angles that the query wants, on the grid of its data.
Result<Carrier, CarrierFault> laid_along(Carrier carrier, const CarrierData& data,
                                         const CarrierQuery& query);

/// The carrier that the program has chosen.
struct ActiveCarrier {
    std::int64_t number = 0;       // 0: none
    int frame_axis = 0;            // 1 to 3: X, Y or Z of the frame leads it; 0: its data do
    std::optional<Carrier> stand;  // as it acts; nothing: none does
};

}  // namespace kadr::interp
