// How a control calls programs: <begins>, <file>, <call> and <argument> of a <language>.
#include <algorithm>
#include <charconv>

#include "nc/load_parts.h"

namespace kadr::nc {

namespace {

class CallLoader {
  public:
    CallLoader(Language& language, Attributes& attributes)
        : language_(language), calls_(language.calls), attributes_(attributes) {}

    void load(const XmlElement& element) {
        Attributes::read_text(element, "reference_word", calls_.reference_word);
        Attributes::read_text(element, "save_word", calls_.save_word);
        read_names(element, "options", calls_.options);
        read_names(element, "definitions", calls_.definitions);
        read_names(element, "scope_words", calls_.scope_words);
        for (const XmlElement& child : element.children) {
            if (child.name == "begins") load_pattern(child, calls_.headers);
            if (child.name == "file") load_pattern(child, calls_.files);
            if (child.name == "call") load_call(child);
            if (child.name == "argument") load_argument(child);
        }
    }

  private:
    static void read_names(const XmlElement& element, std::string_view name,
                           std::vector<std::string>& out) {
        const XmlAttribute* names = element.find(name);
        if (names == nullptr) return;
        out.clear();
        for (const XmlWord& word : words_of(*names)) out.push_back(word.text);
    }

    void load_pattern(const XmlElement& element, std::vector<ProgramPattern>& out) {
        const XmlAttribute& form = needed(element, "program");
        ProgramPattern pattern;
        if (!read_program_pattern(form.value, pattern))
            return attributes_.bad_value(form, "{n} or {name} is expected in it");
        if (const auto kind = attributes_.choice(element, "kind", {"main", "subprogram"}))
            pattern.is_subprogram = *kind == 1;
        std::erase_if(out, [&](const ProgramPattern& old) { return old.form == pattern.form; });
        out.push_back(std::move(pattern));
    }

    void load_call(const XmlElement& element) {
        CallForm form;
        const XmlAttribute& code = needed(element, "code");
        form.code = code.value;
        if (!read_code(form)) {
            return attributes_.bad_value(
                code,
                "a code as M98 is expected, T{n} for any number, {name} or L{digits} for a name");
        }
        const auto kind =
            attributes_.choice(element, "kind", {"subprogram", "macro", "return", "end_modal"});
        if (!kind) return;
        form.kind = static_cast<CallForm::Kind>(*kind);
        if (const auto modal = attributes_.choice(element, "modal", {"no", "motion", "block"}))
            form.modal = static_cast<CallForm::Modal>(*modal);
        read_letter(element, "program", form.program);
        read_letter(element, "repeats", form.repeats);
        read_letter(element, "start", form.start);
        read_letter(element, "target", form.target);
        Attributes::read_text(element, "always", form.fixed);
        Attributes::read_text(element, "value", form.value);
        Attributes::read_text(element, "doc", form.doc);
        attributes_.read_number(element, "split", form.split);
        attributes_.read_flag(element, "external", form.is_external);
        if (const XmlAttribute* value = element.find("value")) {
            std::uint32_t slot = 0;
            VariableRange::Kind scope{};
            if (!find_variable(value->value, slot, scope) || scope != VariableRange::Kind::Global)
                return attributes_.bad_value(*value, "a variable of the whole run is expected");
        }
        const bool calls =
            form.kind == CallForm::Kind::Subprogram || form.kind == CallForm::Kind::Macro;
        // A block alone stands in the program that runs.
        const bool has_program =
            form.program != '\0' || form.is_name || !form.fixed.empty() || form.start != '\0';
        if (calls && !has_program) {
            return attributes_.bad_value(code,
                                         "it needs `program`, the address that says it, `always`, "
                                         "the one program, or `start`, a block of this one");
        }
        std::erase_if(calls_.calls, [&](const CallForm& old) { return old.code == form.code; });
        calls_.calls.push_back(std::move(form));
    }

    /// `M98`, `G66.1`, `T{n}`, `{name}`, `L{digits}`
    static bool read_code(CallForm& form) {
        const std::string& code = form.code;
        const std::size_t hole = code.find('{');
        if (hole != std::string::npos) {
            const std::string_view name = std::string_view(code).substr(hole);
            form.is_name = name == "{name}" || (name == "{digits}" && hole > 0);
            form.any_number = name == "{n}";
            form.letter = hole == 0 ? '\0' : code[0];
            return form.is_name || (form.any_number && hole == 1);
        }
        const char* const end = code.data() + code.size();
        const auto result = std::from_chars(code.data() + 1, end, form.number);
        form.letter = code[0];
        return code.size() > 1 && form.letter >= 'A' && form.letter <= 'Z' &&
               result.ec == std::errc() && result.ptr == end;
    }

    void read_letter(const XmlElement& element, std::string_view name, char& out) {
        const XmlAttribute* attribute = element.find(name);
        if (attribute == nullptr) return;
        if (attribute->value.size() != 1)
            return attributes_.bad_value(*attribute, "one letter is expected");
        out = attribute->value[0];
    }

    /// `#24`
    bool find_variable(std::string_view text, std::uint32_t& slot,
                       VariableRange::Kind& kind) const {
        for (const VariableForm& form : language_.variables) {
            if (!form.is_family || !text.starts_with(form.name)) continue;
            const std::string_view digits = text.substr(form.name.size());
            std::int64_t number = 0;
            const char* const end = digits.data() + digits.size();
            const auto result = std::from_chars(digits.data(), end, number);
            const VariableRange* range = find_range(form, number);
            if (result.ec != std::errc() || result.ptr != end || range == nullptr) continue;
            kind = range->kind;
            slot = range->slot + static_cast<std::uint32_t>(number - range->first);
            return true;
        }
        return false;
    }

    void load_argument(const XmlElement& element) {
        ArgumentForm form;
        read_letter(element, "address", form.letter);
        read_letter(element, "like", form.like);
        attributes_.read_flag(element, "series", form.in_series);
        if (const auto only = attributes_.choice(element, "only", {"any", "block"}))
            form.only_block = *only == 1;
        const XmlAttribute& variable = needed(element, "variable");
        form.variable = variable.value;
        VariableRange::Kind kind{};
        if (!find_variable(variable.value, form.slot, kind) || kind != VariableRange::Kind::Local)
            return attributes_.bad_value(variable, "a variable of each level of calls is expected");
        std::erase_if(calls_.arguments,
                      [&](const ArgumentForm& old) { return old.letter == form.letter; });
        calls_.arguments.push_back(std::move(form));
    }

    Language& language_;
    CallLanguage& calls_;
    Attributes& attributes_;
};

}  // namespace

void load_calls(const XmlElement& language, Language& out, Attributes& attributes) {
    CallLoader(out, attributes).load(language);
}

}  // namespace kadr::nc
