// compensation.h — cutter radius compensation: commands of the programmed contour in, commands of
// the cutter's centre out, a block or more later.
//
// What a corner becomes is path/radius_comp.h; here is the order of things in a program: how the
// cutter comes to the contour and leaves it, blocks without motion in the plane, what inserted
// pieces inherit from their block.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "base/diagnostic.h"
#include "interp/rules.h"
#include "nc/block.h"
#include "path/command.h"
#include "path/frame.h"
#include "path/radius_comp.h"

namespace kadr::interp {

struct CompSettings {
    path::CompRules corners;
    CompStart start = CompStart::Normal;
    CompFeed feed = CompFeed::Contour;
    int empty_blocks = 3;             // without motion in the plane that may stand in a row
    bool more_empty_is_fault = true;  // else the cutter goes to the normal before them
};

/// The tool beside the contour.
struct CompTool {
    double distance = 0;  // radius and allowance, mm, positive left of the contour
    /// From the point that is programmed to the centre of the tool, in the plane, mm: of a lathe's
    /// tool, whose tip lies on the nose. On the contour the centre is led; what goes out is the
    /// tip.
    path::Vec2 center = path::Vec2::Zero();
};

/// What was wrong, and where: the command of the block.
struct CompAlarm {
    const DiagnosticRow* row = nullptr;
    SourceId source;
    std::uint32_t line = 0;
};

class Compensation {
  public:
    bool is_on() const { return state_ != State::Off; }

    /// Compensation begins with the next motion in the plane. `here` is where the tool is.
    ///
    void begin(const CompSettings& settings, path::Plane plane, const CompTool& tool,
               const AxisValues& here);
    void set_tool(const CompTool& tool);
    void set_settings(const CompSettings& settings);
    /// The next motion in the plane leaves the contour.
    void leave();
    path::Plane plane() const { return plane_; }

    /// Where the executor puts a command while compensation is on.
    path::Command& next() { return fresh_.emplace_back(); }
    /// Takes what a block has put. `here` is where the tool is behind it, not compensated; `block`
    /// tells the place of a block that has put nothing.
    std::optional<CompAlarm> end_block(const AxisValues& here, const nc::Block& block);
    /// What the program's end, or a way in machine coordinates, lets go of.
    std::optional<CompAlarm> flush();
    /// Commands that are settled, in order. The caller clears them.
    std::vector<path::Command>& settled() { return settled_; }

  private:
    enum class State : std::uint8_t { Off, Starting, On, Leaving };
    struct Held {
        path::Command command;
        std::size_t index = 0;      // of the element; 0: no motion in the plane
        double radius = 0;          // of an arc as programmed
        bool is_departure = false;  // ends where it is programmed
    };
    using Fault = const DiagnosticRow*;  // null: none

    Fault take(path::Command& command, const AxisValues& behind);
    Fault take_motion(path::Command& command);
    Fault approach(path::Command& command);
    Fault follow(path::Command& command);
    Fault depart(path::Command& command);
    Fault enter(const path::Element& first);
    Fault push(const path::Element& element, Held held);
    Fault finish();
    bool moves_in_plane(const path::Command& command) const;
    path::Element element_of(const path::Command& command) const;
    Fault way_in(const path::Element& first, std::optional<path::Element>& way) const;
    Fault way_out(const path::Vec2& to, std::optional<path::Element>& way) const;
    std::optional<path::Vec2> touched(const path::Vec2& corner, const path::Vec2& from,
                                      double distance) const;
    CompAlarm alarm(Fault fault, const path::Command& command) const;
    void emit_pieces();
    void emit(const path::CompPiece& piece);
    void emit_empty();
    void emit_line(const Held& held, const path::Vec2& to, bool is_inserted);
    void emit_arc(const Held& held, const path::CompPiece& piece);
    void emit_rapid_around(const Held& held, const path::Element& arc);
    void put(path::Command command);
    path::Vec2 in_plane(const AxisValues& values) const;
    /// Where the centre is while the tip is there.
    path::Vec2 center_at(const AxisValues& tip) const { return in_plane(tip) + center_; }
    void set_in_plane(AxisValues& values, const path::Vec2& at) const;

    State state_ = State::Off;
    CompSettings settings_;
    path::PlaneAxes axes_;
    path::Plane plane_ = path::Plane::Xy;
    double distance_ = 0;
    path::Vec2 center_ = path::Vec2::Zero();  // as of CompTool
    AxisValues here_{};                       // programmed
    AxisValues shown_{};  // centre at the end of the last command that was let go
    path::RadiusComp corners_{{}};
    std::size_t elements_ = 0;
    path::Element last_;  // of the contour
    bool has_last_ = false;
    bool approaches_ = false;  // the first of `held_` waits for the first element
    int empty_blocks_ = 0;
    std::deque<Held> held_;
    std::vector<path::Command> fresh_;
    std::vector<path::Command> settled_;
};

}  // namespace kadr::interp
