// Checks of a whole dialect, and the indexes that make it fast.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/diagnostics/dialect.h"
#include "base/done.h"
#include "base/numbers.h"
#include "nc/builder_codes.h"
#include "nc/load.h"

namespace kadr::nc {

namespace {

class Finisher {
  public:
    Finisher(DialectTables& tables, DiagnosticSink& sink) : tables_(tables), sink_(sink) {}

    Done finish() {
        add_builder_form(tables_);
        index_forms();
        index_codes();
        index_slots();
        note_kinds_of_names();
        index_power_on();
        for (const Form& form : tables_.forms) check_parameters(form);
        check_conflicts();
        check_groups();
        return Done(!failed_);
    }

  private:
    void index_forms() {
        tables_.forms_of_cycle.assign(tables_.cycles.size(), {});
        for (Address& address : tables_.addresses) address.forms.clear();
        for (std::size_t i = 0; i < tables_.forms.size(); ++i) {
            const Form& form = tables_.forms[i];
            const auto id = static_cast<FormId>(i);
            if (form.is_written) {
                if (form.function == Function::Cycle) {
                    tables_.forms_of_cycle[form.cycle].push_back(id);
                } else {
                    tables_.forms_of[static_cast<std::size_t>(form.function)].push_back(id);
                }
            }
            if (form.is_comment) {
                if (form.is_read) tables_.comment_forms.push_back(id);
                continue;
            }
            if (!form.is_read) continue;
            if (form.is_verbatim) {
                tables_.verbatim_forms.push_back(id);
                continue;
            }
            const FormWord& first = form.words[0];
            if (first.kind != FormWord::Kind::Fixed)
                tables_.addresses[first.address].forms.push_back(id);
        }
        // A form that programs several functions serves each of them, behind the form of its own.
        for (std::size_t i = 0; i < tables_.forms.size(); ++i) {
            const Form& form = tables_.forms[i];
            if (form.sets.empty() || !form.is_written) continue;
            tables_.given_with_others.set(static_cast<std::size_t>(form.function));
            for (const Function also : form.sets) {
                tables_.forms_of[static_cast<std::size_t>(also)].push_back(static_cast<FormId>(i));
            }
        }
    }

    /// Whether the form is one code and nothing around it has to be looked at.
    static bool is_simple(const Form& form) {
        return form.words.size() == 1 && form.words[0].kind == FormWord::Kind::Fixed &&
               !form.is_comment;
    }

    void index_codes() {
        tables_.code_index.assign(tables_.addresses.size(), {});
        tables_.codes.clear();
        for (std::size_t i = 0; i < tables_.forms.size(); ++i) {
            const Form& form = tables_.forms[i];
            if (!form.is_read || form.is_comment) continue;
            const FormWord& first = form.words[0];
            if (first.kind != FormWord::Kind::Fixed) continue;
            std::vector<std::uint16_t>& index = tables_.code_index[first.address];
            const auto tenths = static_cast<std::size_t>(std::lround(first.number * 10));
            if (index.size() <= tenths) index.resize(tenths + 1, 0);
            if (index[tenths] == 0) {
                tables_.codes.emplace_back();
                index[tenths] = static_cast<std::uint16_t>(tables_.codes.size());
            }
            CodeStart& code = tables_.codes[index[tenths] - 1u];
            code.forms.push_back(static_cast<FormId>(i));
            if (is_simple(form) && code.simple == kNoForm) code.simple = static_cast<FormId>(i);
        }
        for (Form& form : tables_.forms) form.excludes = groups_of(form);
        for (CodeStart& code : tables_.codes) {
            if (code.forms.size() != 1 || code.simple == kNoForm) continue;
            const Form& form = tables_.forms[code.simple];
            code.function = form.function;
            // Which one of such a group was programmed last is noted where lines are looked at
            // closely.
            const bool is_noted = info(form.function).group == Group::NonModal && has_default(form);
            code.is_plain = !is_noted && form.function != Function::None && form.sets.empty() &&
                            form.fixed.empty() && form.during.empty() && !form.owns_block &&
                            !form.owns_axes && !form.owns_line && form.without.empty() &&
                            !form.owns_address && form.unsupported.empty() && !form.remembers &&
                            form.function != Function::Cycle &&
                            info(form.function).parameters.empty();
        }
        // Codes that call a program are looked at closely.
        for (const CallForm& call : tables_.language.calls.calls) {
            if (call.is_name || call.any_number) continue;
            const AddressId address = tables_.find_address({&call.letter, 1});
            const auto tenths = static_cast<std::size_t>(std::lround(call.number * 10));
            if (address == kNoAddress || tables_.code_index[address].size() <= tenths) continue;
            const std::uint16_t code = tables_.code_index[address][tenths];
            if (code != 0) tables_.codes[code - 1u].is_plain = false;
        }
    }

    bool has_default(const Form& form) const {
        return form.group >= 0 &&
               !tables_.groups[static_cast<std::size_t>(form.group)].power_on.empty();
    }

    /// The groups of which the form, or a code among its words, is a member. More than 64 groups
    /// share bits: what is kept apart for nothing then stands in two lines.
    std::uint64_t groups_of(const Form& form) const {
        const auto bit_of = [](int group) {
            return group < 0 ? 0 : std::uint64_t{1} << (static_cast<unsigned>(group) % 64);
        };
        std::uint64_t groups = bit_of(form.group);
        for (const FormWord& word : form.words) {
            if (word.kind != FormWord::Kind::Fixed || word.is_quantity) continue;
            const CodeStart* code = tables_.find_code(word.address, word.number);
            if (code != nullptr) groups |= bit_of(tables_.forms[code->forms[0]].group);
        }
        return groups;
    }

    void index_slots() {
        tables_.slot_address.fill(kNoAddress);
        tables_.incremental_address.fill(kNoAddress);
        for (std::size_t i = 0; i < tables_.addresses.size(); ++i) {
            const Address& address = tables_.addresses[i];
            if (address.slot < 0) continue;
            const auto slot = static_cast<std::size_t>(address.slot);
            if ((kReadSlots >> slot & 1u) != 0) continue;
            AddressId& writer = address.is_incremental ? tables_.incremental_address[slot]
                                                       : tables_.slot_address[slot];
            tables_.has_incremental_letters |= address.is_incremental;
            if (writer == kNoAddress) writer = static_cast<AddressId>(i);
        }
        tables_.slot_order.clear();
        for (std::size_t slot = 0; slot < kSlots; ++slot) {
            if (tables_.slot_address[slot] != kNoAddress)
                tables_.slot_order.push_back(static_cast<Slot>(slot));
        }
        std::stable_sort(tables_.slot_order.begin(), tables_.slot_order.end(),
                         [&](Slot a, Slot b) { return order_of(a) < order_of(b); });
    }
    /// Asked once a line; walking all names there would cost more than reading it.
    void note_kinds_of_names() {
        for (const auto& [name, id] : tables_.names) {
            tables_.has_names |= name.size() > 1 && name != "()" && name[0] != ',';
            tables_.has_comma_words |= name.size() == 2 && name[0] == ',';
        }
    }

    int order_of(Slot slot) const {
        return tables_.addresses[tables_.slot_address[static_cast<std::size_t>(slot)]].order;
    }

    void index_power_on() {
        tables_.power_on.fill(Function::None);
        for (const DialectGroup& group : tables_.groups) {
            for (const Function function : group.power_on) {
                if (info(function).group == Group::NonModal) continue;
                tables_.power_on[static_cast<std::size_t>(info(function).group)] = function;
            }
        }
    }

    // ------------------------------------------------------------ checks

    static void collect(const std::vector<FormWord>& words, std::uint32_t& said) {
        for (const FormWord& word : words) {
            if (word.parameter >= 0) said |= 1u << word.parameter;
            if (word.tail_parameter >= 0) said |= 1u << word.tail_parameter;
            collect(word.arguments, said);
        }
    }

    void check_parameters(const Form& form) {
        if (form.is_preset) return;  // the call gives the rest
        const std::span<const Parameter> parameters = tables_.parameters(form);
        std::uint32_t said = 0;
        collect(form.words, said);
        for (const std::vector<FormWord>& line : form.extra) collect(line, said);
        collect(form.lead, said);
        for (const auto& [parameter, value] : form.fixed) said |= 1u << parameter;
        for (const int parameter : form.drops) said |= 1u << parameter;
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            if (parameters[i].is_optional || (said >> i & 1u) != 0) continue;
            failed_ = true;
            sink_.report(diag::DialectMissingParameter, form.range)
                .arg(form.pattern)
                .arg(parameters[i].name);
        }
    }

    /// What a reader looks at: two readable forms with the same signature cannot be told apart.
    std::string signature(const Form& form) const {
        std::vector<std::string> words;
        for (const FormWord& word : form.words) {
            std::string text = std::to_string(word.address);
            if (form.is_verbatim) text += word.text;
            if (word.kind == FormWord::Kind::Fixed) {
                text += '=';
                append_shortest(text, word.number);
            }
            if (word.kind == FormWord::Kind::Call) add_arguments(text, word);
            if (word.tail_digits > 0 && word.tail_parameter < 0) {
                text += '_';
                append_shortest(text, word.tail_value);
            }
            if (word.is_absolute) text += '!';
            if (word.is_incremental) text += '~';
            if (word.kind == FormWord::Kind::Quoted) text += '"';
            if (word.kind == FormWord::Kind::Text) text += word.text;
            words.push_back(std::move(text));
        }
        std::sort(words.begin(), words.end());
        std::string all = form.is_comment ? "(" : "";
        for (const std::string& word : words) all += word + ' ';
        for (const Constraint& c : form.when) {
            append_shortest(all, c.least + offset_of(form, c.parameter));
            all += ',';
        }
        // Of two forms that need different functions to be active, one at most can be meant.
        for (const Function needed : form.during) {
            all += '@';
            all += info(needed).name;
        }
        if (form.of_cycle) all += std::to_string(*form.of_cycle);  // as of two functions
        return all;
    }

    /// `P{number+10000}` and `P{number}` have ranges of their own.
    static double offset_of(const Form& form, int parameter) {
        const auto word = std::ranges::find(form.words, parameter, &FormWord::parameter);
        return word == form.words.end() ? 0 : word->offset;
    }

    void add_arguments(std::string& text, const FormWord& call) const {
        text += '(';
        for (const FormWord& argument : call.arguments) {
            if (argument.address != kNoAddress) {
                text += tables_.addresses[argument.address].name;
                if (argument.is_letter_alone) text += '!';
            }
            if (argument.kind == FormWord::Kind::Rest) text += "...";
            if (argument.kind == FormWord::Kind::Fixed) append_shortest(text, argument.number);
            // Two signs of one argument are two ranges of it.
            if (argument.kind == FormWord::Kind::Value) text += argument.factor < 0 ? '-' : '#';
            if (argument.kind == FormWord::Kind::Text) text += '"';
            text += ',';
        }
    }

    void check_conflicts() {
        std::map<std::string, const Form*> seen;
        for (const Form& form : tables_.forms) {
            if (!form.is_read) continue;
            const auto [other, is_new] = seen.emplace(signature(form), &form);
            if (is_new) continue;
            failed_ = true;
            auto report = std::move(sink_.report(diag::DialectConflict, form.range)
                                        .arg(form.pattern)
                                        .arg(meaning(*other->second)));
            report.note(other->second->range, "here");
        }
    }
    std::string meaning(const Form& form) const {
        if (form.function == Function::Cycle) return tables_.cycles[form.cycle].name;
        return std::string(info(form.function).name);
    }

    /// Codes of one modal group of the vocabulary stand in one group of the control.
    void check_groups() {
        std::array<const Form*, kGroups> first{};
        for (const Form& form : tables_.forms) {
            const Group group = info(form.function).group;
            const bool is_code = is_simple(form) && info(form.function).parameters.empty();
            if (!is_code || form.group < 0 || group == Group::NonModal) continue;
            const Form*& other = first[static_cast<std::size_t>(group)];
            if (other == nullptr) other = &form;
            if (other->group == form.group) continue;
            failed_ = true;
            sink_.report(diag::DialectGroupSplit, form.range)
                .arg(form.pattern)
                .arg(name_of(form.group))
                .arg(other->pattern)
                .arg(name_of(other->group))
                .note(other->range, "here");
        }
    }
    std::string_view name_of(int group) const {
        return tables_.groups[static_cast<std::size_t>(group)].name;
    }

    DialectTables& tables_;
    DiagnosticSink& sink_;
    bool failed_ = false;
};

}  // namespace

Done finish_tables(DialectTables& tables, DiagnosticSink& sink) {
    return Finisher(tables, sink).finish();
}

}  // namespace kadr::nc
