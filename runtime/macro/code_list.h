// code_list.h — the codes of a control that act, one a modal group, for traces.
#pragma once

#include <string_view>
#include <vector>

#include "macro/active_codes.h"

namespace kadr::macro {

/// The code that acts of a group: `G1` of `motion`. The texts are those of the dialect.
struct ActiveCode {
    std::string_view group;
    std::string_view code;
    friend bool operator==(const ActiveCode&, const ActiveCode&) = default;
};

class CodeList {
  public:
    /// References outlive the list.
    CodeList(const ActiveCodes& active, const nc::DialectTables& tables,
             const nc::ReadingModes& modes)
        : active_(active), tables_(tables), modes_(modes) {}

    /// The groups of which a code acts, in the order of the dialect. Looked up anew only if a line
    /// that was read since has changed something.
    const std::vector<ActiveCode>& now();

  private:
    bool catch_up();

    const ActiveCodes& active_;
    const nc::DialectTables& tables_;
    const nc::ReadingModes& modes_;
    bool is_filled_ = false;
    nc::ModalFunctions modal_{};
    std::vector<nc::FormId> forms_;
    std::vector<ActiveCode> codes_;
};

}  // namespace kadr::macro
