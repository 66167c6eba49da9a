#include "nc/spindle_words.h"

#include <algorithm>
#include <string>

namespace kadr::nc {

namespace {

/// Whether the first word of a form may have this number.
bool takes_number(const Form& form, double number) {
    return std::ranges::none_of(form.when, [&](const Constraint& c) {
        return c.parameter == form.words[0].parameter && (number < c.least || number > c.most);
    });
}

}  // namespace

bool name_spindles(const DialectTables& tables, const ReadingModes& modes, LexedLine& words) {
    bool has_any = false;
    for (GivenWord& word : words.words) {
        if (!word.names_first) continue;
        has_any = true;
        const std::string& name = tables.addresses[word.address].name;
        const bool is_numbered = name.back() == '1' || name.back() == ']';
        if (is_numbered == modes.has_other_master()) continue;
        const std::string plain = is_numbered ? name.substr(0, name.find_first_of("1[")) : name;
        AddressId wanted = tables.find_address(plain);
        if (!is_numbered) wanted = tables.find_address(name + '1');
        if (wanted == kNoAddress) wanted = tables.find_address(name + "[1]");
        // M1=8 is no function of a spindle.
        const auto takes = [&](FormId id) { return takes_number(tables.forms[id], word.number); };
        const bool is_taken =
            is_numbered ||
            (wanted != kNoAddress && std::ranges::any_of(tables.addresses[wanted].forms, takes));
        if (wanted != kNoAddress && is_taken) word.address = wanted;
    }
    return has_any;
}

}  // namespace kadr::nc
