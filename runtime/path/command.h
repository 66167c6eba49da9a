// command.h — what the interpreter gives the motion side.
//
// Resolved: frames, units, plane, modal state and offsets are worked in; nobody behind this point
// knows a G-code. Positions are of the tool tip in the base coordinate system, mm and degrees; X of
// a lathe is a radius.
//
// A command is a head, which holds for all of them, and one of the things that it can be. Its op is
// read off that, so that both agree.
#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "base/axes.h"
#include "base/source.h"
#include "path/motion.h"
#include "path/op.h"

namespace kadr::path {

enum class SpindleMode : std::uint8_t { Stop, Cw, Ccw, Orient };
enum class CoolantMode : std::uint8_t { Off, Flood, Mist };
/// What becomes of an M function where its command stands.
enum class FunctionStep : std::uint8_t {
    Issue,  // the motion goes on
    Await,  // of what was issued before: the motion waits for the acknowledgement
    Both,
};

struct Spindle {
    SpindleMode mode = SpindleMode::Stop;
    bool is_master = true;           // which paths follow
    bool has_cutting_speed = false;  // `speed` is m/min
    std::uint8_t number = 0;         // where the machine has several; else 0
    double speed = 0;                // rpm or m/min
    double angle_deg = 0;            // Orient

    Op op() const { return is_master ? Op::Spindle : Op::OtherSpindle; }
};

struct SpeedLimit {
    double most = 0;   // rpm
    double least = 0;  // rpm, under constant cutting speed; 0: none

    static constexpr Op op() { return Op::SpeedLimit; }
};

struct ToolChange {
    std::int64_t number = 0;

    static constexpr Op op() { return Op::Tool; }
};

struct ToolLength {
    std::int64_t number = 0;    // of the tool or offset
    double length = 0;          // what is added along the normal of `plane`, mm …
    Vec3 aside = Vec3::Zero();  // … and along the other axes, mm
    Plane plane = Plane::Xy;
    bool is_swivelled = false;       // `direction` is the tool's, which a head turns
    Vec3 direction = Vec3::UnitZ();  // unit vector from tip to holder, in the base system
    AxisMask changed = 0;            // axes that have another length now

    static constexpr Op op() { return Op::ToolLength; }
};

struct Coolant {
    CoolantMode mode = CoolantMode::Off;

    static constexpr Op op() { return Op::Coolant; }
};

/// An M function.
struct MFunction {
    std::int64_t code = 0;  // M10 is 10
    FunctionStep step = FunctionStep::Both;

    static constexpr Op op() { return Op::Function; }
};

struct Dwell {
    double time = 0;  // s; 0 if revolutions
    double revolutions = 0;

    static constexpr Op op() { return Op::Dwell; }
};

struct Message {
    std::string text;

    static constexpr Op op() { return Op::Message; }
};

/// The axes stand while a module beside them works.
struct External {
    double time = 0;  // s

    static constexpr Op op() { return Op::External; }
};

/// What has no more than its name.
class Mark {
  public:
    explicit Mark(Op op);
    Op op() const { return op_; }

  private:
    Op op_;  // Stop, OptionalStop, End, ScannerOn, ScannerOff
};

class Command {
  public:
    SourceId source;
    std::uint32_t line = 0;   // of the ISO-7bit text
    std::uint16_t cycle = 0;  // a part of one: its index in the dialect's list, from 1; 0: of none
    /// Its block is programmed in machine coordinates, whatever a motion's end is in. Of all
    /// commands: a contour ends before the first of such a block.
    bool is_unshifted = false;

    /// A rapid that has no content.
    Command() = default;
    explicit Command(Op op) { become(op); }

    Op op() const {
        if (const auto* moves = std::get_if<Motion>(&what_)) return moves->op();
        return other_op();
    }
    bool is_motion() const { return std::holds_alternative<Motion>(what_); }
    /// Another op. What it holds is not given yet, but for a motion that was one: there all but the
    /// shape stays. The head stays.
    void become(Op op);

    // What it holds, by the name of its kind.
    const Motion& motion() const { return read_as<Motion>(what_); }
    Motion& motion() { return read_as<Motion>(what_); }
    const Spindle& spindle() const { return read_as<Spindle>(what_); }
    Spindle& spindle() { return read_as<Spindle>(what_); }
    const SpeedLimit& speed_limit() const { return read_as<SpeedLimit>(what_); }
    SpeedLimit& speed_limit() { return read_as<SpeedLimit>(what_); }
    const ToolChange& tool() const { return read_as<ToolChange>(what_); }
    ToolChange& tool() { return read_as<ToolChange>(what_); }
    const ToolLength& tool_length() const { return read_as<ToolLength>(what_); }
    ToolLength& tool_length() { return read_as<ToolLength>(what_); }
    const Coolant& coolant() const { return read_as<Coolant>(what_); }
    Coolant& coolant() { return read_as<Coolant>(what_); }
    const MFunction& function() const { return read_as<MFunction>(what_); }
    MFunction& function() { return read_as<MFunction>(what_); }
    const Dwell& dwell() const { return read_as<Dwell>(what_); }
    Dwell& dwell() { return read_as<Dwell>(what_); }
    const Message& message() const { return read_as<Message>(what_); }
    Message& message() { return read_as<Message>(what_); }
    const External& external() const { return read_as<External>(what_); }
    External& external() { return read_as<External>(what_); }

  private:
    Op other_op() const;

    std::variant<Motion, Spindle, SpeedLimit, ToolChange, ToolLength, Coolant, MFunction, Dwell,
                 Message, External, Mark>
        what_;
};

// Millions of them pass by: what is rare is boxed.
static_assert(sizeof(Command) < 300);

}  // namespace kadr::path
