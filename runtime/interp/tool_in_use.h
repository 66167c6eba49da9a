// tool_in_use.h — the tool in the spindle, its edge, and which of its lengths act.
#pragma once

#include <utility>

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// The tool in the spindle, its edge, and which of its lengths act.
class ToolInUse {
  public:
    explicit ToolInUse(Channel& channel);
    ToolInUse(const ToolInUse&) = delete;
    ToolInUse& operator=(const ToolInUse&) = delete;

    /// The length that should act may have become another one: the next motion looks it up.
    void expect_length(bool is_due = true) { tool_.has_changed = is_due; }
    /// The lengths in force are these, or those that should act, without a motion of the axes.
    void set_lengths(const path::Vec3& lengths) { tool_.lengths = lengths; }
    void take_wanted_lengths() { tool_.lengths = wanted_lengths(); }
    /// The number of the length offset, added or taken off.
    void choose_offset(std::int64_t number) { tool_.offset = number; }
    void add_length() { tool_.is_taken_off = false; }
    /// Whose length should act.
    void measure_from(Tool::Source source) {
        tool_.source = source;
        expect_length();
    }
    void choose_radius_offset(std::int64_t number) { tool_.radius_offset = number; }
    /// Acts as if no length and no data of its own were programmed.
    template <typename Act>
    void without_length(Act act) {
        const ExtraTool extra = std::exchange(extra_, {});
        const Tool::Source source = std::exchange(tool_.source, Tool::Source::None);
        expect_length();
        act();
        tool_.source = source;
        extra_ = extra;
        expect_length();
    }

    /// Acts with the next motion; S 5.1. Whether the two kinds of lengths end each other is not
    /// known (unsure).
    ControlAccess::Write set_extra(nc::SystemQuantity quantity, std::int64_t first, double value);
    /// Whether there may be such a tool and such an edge of it; an edge that is not programmed is
    /// 0.
    bool has_edge(std::int64_t tool, std::int64_t edge) const;
    /// A datum of an edge, as its variable gives it; mm.
    ControlAccess::Write set_edge_offset(nc::SystemQuantity quantity, std::int64_t tool,
                                         std::int64_t edge, double value);
    /// Of the edge that acts, whose data are the same by its number, $TC_DPx[T,D].
    ControlAccess::Write set_active_datum(std::int64_t datum, double value);
    /// `datum_and_edge`: the number of the datum a thousand times, and the cutting edge.
    bool set_tool_datum(std::int64_t number, std::int64_t datum_and_edge, double value);
    /// A block of data writes it: G10 L10 to L13.
    void write_tool_offset(const nc::Block& block, const nc::Invocation& invocation);
    /// Which columns of the offset the parameters are. The position of the tip is no wear.
    void write_lathe_offset(const nc::Block& block, const nc::Invocation& invocation);
    /// By its number; mm.
    ControlAccess::Write set_tool_offset(ToolOffsets::Column column, std::int64_t number,
                                         double value);
    /// T: the tool waits, or is in at once, as the control's rule wants.
    void select_tool(const nc::Block& block, const nc::Invocation& invocation, Actions& actions);
    /// D of a control that counts edges.
    void select_edge(const nc::Block& block, const nc::Invocation& invocation, Actions& actions);
    /// G43, G44, G49.
    void change_length(const nc::Block& block, const nc::Invocation& invocation, Actions& actions);
    /// Whose length should act from this block on.
    void set_length_source(Tool::Source source, Actions& actions);
    /// The edge that was programmed last is of the tool that was selected last: of one that is not
    /// in the spindle yet it acts when it comes there.
    void take_edge(const nc::Block& block);
    /// DL. A new edge has none, and a tool that is changed; S 2.3 with MD20272 = 0 (unsure).
    void choose_sum_offset(const nc::Block& block, const nc::Invocation& invocation,
                           Actions& actions);
    /// What the sum offset adds, mm: to length 1, 2 or 3 (part 1 to 3), or to the radius (4): wear
    /// by the location of use, and what was set up. As data of the edge they are $TC_SCP13 … and
    /// $TC_ECP13 …, ten further for each sum offset.
    double sum_offset(std::size_t part) const;
    /// The tool that was selected is in the spindle.
    void change_tool(const nc::Block& block);
    /// What should be added to X, Y, Z; S 5.1.
    path::Vec3 wanted_lengths() const;
    /// A length that was selected acts along an axis with the first motion of that axis: the motion
    /// side is given the length just before it, and only if the length is another one than before.
    ///
    /// returns  how far the tip goes by it while the axes stand, in the base system, mm
    path::Vec3 activate_length(const nc::Block& block, AxisMask moved);
    /// … with an arc. On a line the tip comes from wherever the length has left it; an arc that
    /// begins beside its circle is none. Along its axis it rises.
    Done activate_length_on_arc(const nc::Block& block, const path::Vec3& normal, AxisMask moved);
    /// `G43 H1` in a block without axis words: the programmed position stays, so the machine axis
    /// moves by the change of the length, in the active kind of motion.
    void move_length_alone(const nc::Block& block);
    /// A transformation with a length was switched in a block without axis words: the position in
    /// the program stays, and so the axes move.
    void move_behind_switch(const nc::Block& block);
    /// What the linear axes stand beside the tip, for a tool with these lengths.
    path::Vec3 length_shift_of(const path::Vec3& lengths) const;
    /// Machine position less base position, mm.
    void set_length_shift(const path::Vec3& shift);
    /// Gives the motion side what lies between the tip and what the linear axes carry.
    path::ToolLength& put_tool_length(const nc::Block& block, Axis axis);

  private:
    void put_tool_offset(const nc::Block& block, const nc::Invocation& invocation,
                         ToolOffsets::Column column, double value);
    std::int64_t tool_number(const nc::Block& block, const nc::Invocation& invocation);
    std::int64_t named_tool(const nc::Block& block);
    void check_edge(const nc::Block& block);
    Axis wanted_length_axis() const;
    void check_length_known(const nc::Block& block);

    Channel& channel_;
    const machine::Machine& machine_;
    ToolOffsets& tool_offsets_;
    ToolNames& tool_names_;
    Reporter& reporter_;
    const nc::Rules& rules_;
    const Modal& modal_;
    const Position& position_;
    const control::Frames& frames_;
    Tool& tool_;
    ExtraTool& extra_;
    const ActiveCarrier& carrier_;
    const Orienting& orienting_;
    const Tilting& tilted_plane_;
    const RadiusCompState& comp_;
    const ProgrammedUnits& units_;
    ReportedInRun& reported_;
    const Dangers& dangers_;
    const AxisData& axes_;
    AxisValues& length_shift_;
};

}  // namespace kadr::interp
