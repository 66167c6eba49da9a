#include "macro/active_codes.h"

#include <algorithm>

#include "macro/whole_number.h"

namespace kadr::macro {

const nc::Form* ActiveCodes::form(std::size_t group) const {
    const auto acts = [&](const nc::Form& form) {
        const nc::Group of = info(form.function).group;
        if (of == nc::Group::NonModal || form.function == nc::Function::Cycle) return false;
        nc::Function active = modes_.active(of);
        if (of == nc::Group::Motion && active == nc::Function::None)
            active = dialect_.first_motion();
        return active == form.function;
    };
    const auto& defaults = tables_.groups[group].power_on;
    // A modal cycle is of its own group, or of the one whose default ends cycles.
    const bool is_of_cycles = std::ranges::find(defaults, nc::Function::CycleOff) != defaults.end();
    if (modes_.last_cycle() != nc::kNoForm &&
        modes_.active(nc::Group::CycleMode) == nc::Function::Cycle) {
        const nc::Form& cycle = tables_.forms[modes_.last_cycle()];
        const bool is_here =
            cycle.group >= 0 ? cycle.group == static_cast<int>(group) : is_of_cycles;
        if (is_here) return &cycle;
    }
    const nc::FormId last = modes_.last_form(group);
    if (last != nc::kNoForm) {
        const nc::Form& form = tables_.forms[last];
        // Functions that act once, as frames do, are a group where one of them is the default.
        const bool is_kept = info(form.function).group == nc::Group::NonModal &&
                             !defaults.empty() && form.function != nc::Function::Cycle;
        if (form.function == nc::Function::None || is_kept || acts(form)) return &form;
    }
    for (const nc::Form& form : tables_.forms) {
        if (form.group != static_cast<int>(group) || !form.is_read || !acts(form)) continue;
        const bool is_first_offset =
            form.function != nc::Function::WorkOffset ||
            (!form.fixed.empty() && form.fixed[0].second == dialect_.first_work_offset());
        if (is_first_offset) return &form;
    }
    // Nothing of the group was programmed, and nothing acts by itself: what the file calls its
    // default.
    for (const nc::Form& form : tables_.forms) {
        if (form.group != static_cast<int>(group) || !form.is_read) continue;
        const bool is_offset = form.function == nc::Function::WorkOffset && !form.fixed.empty() &&
                               form.fixed[0].second == dialect_.first_work_offset();
        const bool is_default = std::ranges::find(defaults, form.function) != defaults.end();
        if (is_offset || is_default) return &form;
    }
    return nullptr;
}

std::optional<std::size_t> ActiveCodes::group_of(std::int64_t group_number) const {
    const auto found = std::ranges::find_if(tables_.groups, [&](const auto& group) {
        return whole_number(group.name) == group_number;
    });
    if (found == tables_.groups.end()) return std::nullopt;
    return static_cast<std::size_t>(found - tables_.groups.begin());
}

std::optional<double> ActiveCodes::number(std::int64_t group_number) const {
    const auto group = group_of(group_number);
    if (!group) return std::nullopt;
    const nc::Form* acting = form(*group);
    if (acting == nullptr) {
        // Of codes on which nothing depends the first one acts before any was programmed.
        const auto first = std::ranges::find_if(tables_.forms, [&](const nc::Form& other) {
            return other.group == static_cast<int>(*group) && other.is_read;
        });
        const bool is_passed =
            first != tables_.forms.end() && first->function == nc::Function::None;
        if (is_passed) acting = &*first;
    }
    if (acting == nullptr) return std::nullopt;
    return acting->words[0].number;
}

std::optional<std::int64_t> ActiveCodes::place(std::int64_t group_number) const {
    const auto list = std::ranges::find_if(tables_.language.code_lists, [&](const auto& of) {
        return whole_number(of.group) == group_number;
    });
    if (list == tables_.language.code_lists.end()) return std::nullopt;
    const auto group = group_of(group_number);
    return list->standard == 0 || !group ? list->standard : place_in(*list, *group);
}

std::int64_t ActiveCodes::place_in(const nc::GroupCodes& list, std::size_t group) const {
    // A code that is no modal function of the vocabulary acts since it was programmed.
    const nc::FormId last = modes_.last_form(group);
    const bool is_given =
        last != nc::kNoForm && info(tables_.forms[last].function).group == nc::Group::NonModal;
    const nc::Form* acting = is_given ? &tables_.forms[last] : form(group);
    if (acting == nullptr) return list.standard;
    const auto found = std::ranges::find(list.codes, acting->words[0].text);
    if (found == list.codes.end()) return list.standard;
    return found - list.codes.begin() + 1;
}

}  // namespace kadr::macro
