#include "nc/builder_codes.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/numbers.h"

namespace kadr::nc {

namespace {

/// A form of machine_function that begins with a code: the builder's codes have its address.
const Form* usual_form(const DialectTables& tables) {
    const auto is_usual = [&](const Form& form) {
        return form.function == Function::MachineFunction && form.words.size() == 1 &&
               form.words[0].address != kNoAddress &&
               tables.addresses[form.words[0].address].kind == Address::Kind::Code;
    };
    const auto found = std::ranges::find_if(tables.forms, is_usual);
    return found == tables.forms.end() ? nullptr : &*found;
}

/// M98 and M99: the control has them, though no form of a block does.
bool calls_program(const DialectTables& tables, AddressId address, double number) {
    const std::string& name = tables.addresses[address].name;
    return std::ranges::any_of(tables.language.calls.calls, [&](const CallForm& call) {
        return !call.is_name && !call.any_number && name.size() == 1 && call.letter == name[0] &&
               call.number == number;
    });
}

bool is_unsupported(const DialectTables& tables, AddressId address, double number) {
    if (tables.unsupported.empty()) return false;
    std::string word = tables.addresses[address].name;
    append_shortest(word, number);
    return tables.unsupported.contains(word);
}

bool is_free(const DialectTables& tables, AddressId address, double number) {
    return address == tables.builder_address && number >= 0 && number == std::floor(number) &&
           tables.find_code(address, number) == nullptr && !calls_program(tables, address, number);
}

}  // namespace

bool is_builder_code(const DialectTables& tables, AddressId address, double number) {
    const CodeRange& codes = tables.notation.builder_codes;
    return number >= codes.least && number <= codes.most && is_free(tables, address, number) &&
           !is_unsupported(tables, address, number);
}

bool is_passed_to_builder(const DialectTables& tables, AddressId address, double number) {
    if (is_builder_code(tables, address, number)) return true;
    return number <= tables.notation.most_builder_code && is_free(tables, address, number);
}

void add_builder_form(DialectTables& tables) {
    const Form* const usual = usual_form(tables);
    tables.builder_address = usual == nullptr ? kNoAddress : usual->words[0].address;
    const CodeRange& codes = tables.notation.builder_codes;
    if (usual == nullptr || codes.most < codes.least) return;
    Form form;
    form.function = Function::MachineFunction;
    form.group = usual->group;
    form.order = usual->order;
    form.range = usual->range;
    form.is_read = false;
    form.is_by_number = true;
    constexpr int kNumber = parameter_of<Function::MachineFunction>("number");
    form.when.push_back({kNumber, codes.least, codes.most});
    FormWord word;
    word.kind = FormWord::Kind::Value;
    word.address = tables.builder_address;
    word.text = tables.addresses[word.address].name;
    word.dimension = Dimension::Count;
    word.parameter = kNumber;
    form.pattern = word.text + "{number}";
    form.words.push_back(std::move(word));
    tables.forms.push_back(std::move(form));
}

}  // namespace kadr::nc
