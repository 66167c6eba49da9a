// load_parts.h — the elements of a dialect file, one loader each.
//
// An element replaces what the files that this one extends held for the same thing. Every element
// has the shape of a dialect already; what its values mean is decided here. What patterns build
// upon (addresses, comment signs) must be loaded before them.
#pragma once

#include <bitset>
#include <set>

#include "nc/load_attributes.h"

namespace kadr::nc {

// load_frame.cpp: the text around the blocks.
void load_program(const XmlElement& element, ProgramTemplates& frame, Attributes& attributes);
void load_blocks(const XmlElement& element, BlockNumbers& numbers, Attributes& attributes);
void load_comment(const XmlElement& element, CommentStyle& style, Attributes& attributes);
void load_notation(const XmlElement& element, Notation& notation, Attributes& attributes);

// load_addresses.cpp: the heads of words, and their numbers.
void load_address(const XmlElement& element, DialectTables& tables, Attributes& attributes);
void load_number(const XmlElement& element, DialectTables& tables, Attributes& attributes);
void load_remove(const XmlElement& element, DialectTables& tables, Attributes& attributes);

// load_references.cpp: what other rooms look up.
void load_alarm(const XmlElement& element, DialectTables& tables, Attributes& attributes);
void load_rule(const XmlElement& element, DialectTables& tables, Attributes& attributes);
void load_unsupported(const XmlElement& element, DialectTables& tables);
void load_foreign(const XmlElement& element, DialectTables& tables);
void load_passed(const XmlElement& element, DialectTables& tables, Attributes& attributes);
void load_example(const XmlElement& element, DialectTables& tables);

// load_language.cpp: the control's own parametric language.
void load_language(const XmlElement& element, DialectTables& tables, Attributes& attributes);

// load_calls.cpp: how programs are called; a part of the language.
void load_calls(const XmlElement& language, Language& out, Attributes& attributes);

/// load_forms.cpp: the spellings of functions and cycles. The first time that a file spells a
/// function, the spellings of the files it extends are dropped.
class FormLoader {
  public:
    FormLoader(DialectTables& tables, Attributes& attributes, const Files& files)
        : tables_(tables), attributes_(attributes), files_(files) {}

    void load_group(const XmlElement& element);
    void check_default(const XmlElement& element, std::string_view name);
    void load_command(const XmlElement& element);
    void load_cycle(const XmlElement& element);
    void load_deferred(const XmlElement& element);

  private:
    void load_code(const XmlElement& element, int group);
    void load_forms(const XmlElement& element, const Form& prototype);
    void load_examples(const XmlElement& element);
    void begin_function(Function function);
    std::optional<CycleId> cycle_of(const XmlElement& element);
    void read_cycle_of_words(const XmlElement& element, Form& form);
    void read_roles(const XmlElement& element, CycleInfo& cycle);
    void read_settings(const XmlElement& element, CycleInfo& cycle);
    void read_cycle_file(const XmlAttribute& file, CycleInfo& cycle);
    CycleId declare_cycle(std::string_view name, const XmlAttribute& parameters);
    int group_named(std::string_view name);
    void add_forms(const Form& prototype, std::string_view text);
    void read_form_attributes(const XmlElement& element, Form& form);
    void read_parameters(const XmlAttribute& attribute, const Form& form, std::vector<int>& out);
    void read_spindle(const XmlElement& element, Form& form);
    void read_constraints(const XmlAttribute& attribute, Form& form);

    DialectTables& tables_;
    Attributes& attributes_;
    const Files& files_;  // in which the Kadr files of cycles are
    std::bitset<kFunctions> seen_;
    std::set<CycleId> seen_cycles_;
    bool seen_deferred_ = false;
};

// Shared by them.
void clear_forms(DialectTables& tables, Function function, CycleId cycle);
void drop_cleared_forms(DialectTables& tables);
std::optional<CycleId> cycle_named(const DialectTables& tables, std::string_view name);

struct SlotInfo {
    std::string_view name;
    Dimension dimension;
};
/// The slots in the order of `Slot`, as the attribute `slot=` names them.
std::span<const SlotInfo> slot_infos();

}  // namespace kadr::nc
