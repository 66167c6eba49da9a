// known_frame.h — the programmable frame, tilted planes and tool centre point control, as far as
// the program tells. For the room expand only.
#pragma once

#include <array>
#include <cstdint>

#include "base/source.h"
#include "control/frame_steps.h"
#include "control/program_frame.h"
#include "nc/vocabulary.h"

namespace kadr::expand {

/// The frame that acts, and the steps that make it: those of the program, and those of its text.
class KnownFrame {
  public:
    const control::ProgramFrame& now() const { return now_; }
    /// It makes ellipses of the circles of some plane.
    bool is_stretched() const { return is_stretched_; }
    const control::FrameSteps& steps() const { return steps_; }
    const control::FrameSteps& written_steps() const { return written_steps_; }
    /// Why no frame is what the steps make.
    control::FrameFormFault fault() const { return fault_; }
    bool has_fault() const { return fault_ != control::FrameFormFault::None; }
    SourceId by() const { return by_; }

    void set(const control::ProgramFrame& frame, SourceId by) {
        now_ = frame;
        is_stretched_ = frame.scale[0] != frame.scale[1] || frame.scale[1] != frame.scale[2];
        by_ = by;
    }
    /// One further step, in both.
    template <typename Change>
    void change(Change change) {
        change(steps_);
        change(written_steps_);
    }
    /// … which in the text stands outside of a scale, where the control takes it so.
    void rotate(double angle_deg, nc::Function plane, const std::array<double, 3>& center,
                bool is_outside_scale) {
        steps_.rotate(angle_deg, plane, center);
        if (is_outside_scale) written_steps_.rotate_scaled(angle_deg, plane, center);
        else written_steps_.rotate(angle_deg, plane, center);
    }
    /// The frame that the steps make now; a fault stays known.
    control::ProgramFrame made();
    /// Blocks have programmed it anew: nothing else made it.
    void write(const control::ProgramFrame& frame) {
        steps_.say(frame);
        written_steps_ = steps_;
        fault_ = control::FrameFormFault::None;
    }
    /// The program has made it by these steps, whatever its text says.
    void name_steps(const control::FrameSteps& steps) { steps_ = steps; }

  private:
    control::ProgramFrame now_;
    bool is_stretched_ = false;
    control::FrameSteps steps_;
    control::FrameSteps written_steps_;
    control::FrameFormFault fault_ = control::FrameFormFault::None;
    SourceId by_;
};

/// A tilted plane that acts: of the control, which has frames in it (Own) or none (Closed), or
/// a frame that stands for it.
enum class PlaneTilt : std::uint8_t { None, Own, Closed, Resolved };

class TiltInUse {
  public:
    PlaneTilt kind() const { return kind_; }
    bool acts() const { return kind_ != PlaneTilt::None; }
    /// Resolved: the frame that is the plane.
    const control::ProgramFrame& frame() const { return frame_; }

    void choose(PlaneTilt kind) { kind_ = kind; }
    void resolve(const control::ProgramFrame& frame) {
        kind_ = PlaneTilt::Resolved;
        frame_ = frame;
    }

  private:
    PlaneTilt kind_ = PlaneTilt::None;
    control::ProgramFrame frame_;
};

/// Tool centre point control: by functions of its own, or as a kind of tool length.
enum class TcpKind : std::uint8_t { Off, Own, Length };

class TcpInUse {
  public:
    TcpKind kind() const { return kind_; }
    bool acts() const { return kind_ != TcpKind::Off; }
    bool is_length() const { return kind_ == TcpKind::Length; }
    /// Length: number of the offset.
    double offset() const { return offset_; }
    /// Length: the member of that group that acted before.
    nc::Function before() const { return before_; }
    /// The tool has been inclined away from Z under it.
    bool is_inclined() const { return is_inclined_; }

    void begin() { kind_ = TcpKind::Own; }
    void begin_as_length(double offset, nc::Function before) {
        kind_ = TcpKind::Length;
        offset_ = offset;
        before_ = before;
        is_inclined_ = false;
    }
    void end() { kind_ = TcpKind::Off; }
    void incline(bool is_inclined) { is_inclined_ = is_inclined; }
    void join(const TcpInUse& other) { is_inclined_ |= other.is_inclined_; }

  private:
    TcpKind kind_ = TcpKind::Off;
    double offset_ = 0;
    nc::Function before_ = nc::Function::LengthCompOff;
    bool is_inclined_ = false;
};

}  // namespace kadr::expand
