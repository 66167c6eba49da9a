#include "nc/rule_defaults.h"

#include <algorithm>

#include "base/assert.h"
#include "base/numbers.h"

namespace kadr::nc {

namespace {

constexpr RuleDefault kDefaults[] = {
    // name, text of the default
    {"arc_error", "spread"},
    {"arc_tolerance", "0.01"},
    {"arc_tolerance_factor", "0.0"},
    {"comp_empty_blocks", "3"},
    {"comp_more_empty_is_alarm", "yes"},
    {"cycle_distances_scaled", "yes"},
    {"cycle_levels_incremental", "no"},
    {"default_work_offset", "0"},
    {"feed_deleted_on_mode_change", "no"},
    {"feed_of_all_axes", "no"},
    {"frame_center_at_tool", "no"},
    {"helix_feed_along_arc", "no"},
    {"incremental_frame", "distance"},
    {"length_axis", "plane"},
    {"machine_coordinates_keep_length", "no"},
    {"machine_coordinates_rapid", "no"},
    {"mirror_replaces", "no"},
    {"modal_cycles", "no"},
    {"most_message", "0"},
    {"place_behind_rotation", "no"},
    {"rigid_tap_stops_spindle", "no"},
    {"rotate_replaces", "no"},
    {"rotation_is_innermost", "no"},
    {"scale_replaces", "no"},
    {"shift_in_diameter", "no"},
    {"shift_keeps_unnamed", "no"},
    {"stops_after_motion", "no"},
    {"tool_change_activates_length", "no"},
    {"tool_change_moves_plane", "no"},
    {"tool_change_stops_spindle", "no"},
    {"tool_select_changes", "no"},
    {"transformation_wants_offset", "no"},
};

}  // namespace

std::span<const RuleDefault> rule_defaults() { return kDefaults; }

std::string_view rule_text(std::span<const RuleSetting> settings, std::string_view name) {
    const auto set = std::ranges::find(settings, name, &RuleSetting::name);
    if (set != settings.end()) return set->value;
    const auto* row = std::ranges::find(kDefaults, name, &RuleDefault::name);
    KADR_ASSERT(row != std::end(kDefaults), "a rule that rule_defaults.cpp does not have");
    return row->text;
}

double rule_value(const Dialect& dialect, std::string_view name) {
    const std::string_view text = rule_text(dialect.rules(), name);
    return parse_decimal(text.data(), text.data() + text.size()).value;
}

}  // namespace kadr::nc
