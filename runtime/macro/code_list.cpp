#include "macro/code_list.h"

namespace kadr::macro {

/// Keeps what the list depends on. True: it is as it was when the list was made.
bool CodeList::catch_up() {
    const std::size_t groups = tables_.groups.size();
    forms_.resize(groups, nc::kNoForm);
    bool is_same = is_filled_ && modal_ == modes_.modal();
    for (std::size_t group = 0; group < groups; ++group) {
        is_same = is_same && forms_[group] == modes_.last_form(group);
        forms_[group] = modes_.last_form(group);
    }
    modal_ = modes_.modal();
    return is_same;
}

const std::vector<ActiveCode>& CodeList::now() {
    if (catch_up()) return codes_;
    is_filled_ = true;
    codes_.clear();
    const auto& groups = tables_.groups;
    for (std::size_t group = 0; group < groups.size(); ++group) {
        const nc::Form* form = active_.form(group);
        if (form == nullptr || form->words.empty()) continue;
        codes_.push_back({groups[group].name, form->words[0].text});
    }
    return codes_;
}

}  // namespace kadr::macro
