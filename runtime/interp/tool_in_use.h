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
    /// The lengths in force are these, or those that should act, without a way of the axes.
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
    /// Acts as if the program had said no length and no data of its own.
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

    ControlAccess::Write set_extra(nc::Quantity quantity, std::int64_t first, double value);
    bool has_edge(std::int64_t tool, std::int64_t edge) const;
    ControlAccess::Write set_edge_offset(nc::Quantity quantity, std::int64_t tool,
                                         std::int64_t edge, double value);
    ControlAccess::Write set_active_datum(std::int64_t datum, double value);
    bool set_tool_datum(std::int64_t number, std::int64_t datum_and_edge, double value);
    void write_tool_offset(const nc::Block& block, const nc::Invocation& invocation);
    void write_lathe_offset(const nc::Block& block, const nc::Invocation& invocation);
    ControlAccess::Write set_tool_offset(ToolOffsets::Column column, std::int64_t number,
                                         double value);
    void select_tool(const nc::Block& block, const nc::Invocation& invocation, Actions& actions);
    void select_edge(const nc::Block& block, const nc::Invocation& invocation, Actions& actions);
    void change_length(const nc::Block& block, const nc::Invocation& invocation, Actions& actions);
    void set_length_source(Tool::Source source, Actions& actions);
    void take_edge(const nc::Block& block);
    void choose_sum_offset(const nc::Block& block, const nc::Invocation& invocation,
                           Actions& actions);
    double sum_offset(std::size_t part) const;
    void change_tool(const nc::Block& block);
    path::Vec3 wanted_lengths() const;
    path::Vec3 activate_length(const nc::Block& block, AxisMask moved);
    Done activate_length_on_arc(const nc::Block& block, const path::Vec3& normal, AxisMask moved);
    void move_length_alone(const nc::Block& block);
    void move_behind_switch(const nc::Block& block);
    path::Vec3 length_shift_of(const path::Vec3& lengths) const;
    void set_length_shift(const path::Vec3& shift);
    path::Command& put_tool_length(const nc::Block& block, Axis axis);

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
    const Units& units_;
    ReportedInRun& told_;
    const Dangers& dangers_;
    const AxisData& axes_;
    AxisValues& length_shift_;
};

}  // namespace kadr::interp
