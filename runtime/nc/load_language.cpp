// The control's own parametric language: <language> and what stands in it.
#include <algorithm>
#include <cctype>
#include <set>

#include "base/done.h"
#include "nc/load_parts.h"
#include "nc/statement_holes.h"

namespace kadr::nc {

namespace {

/// The index of the row with this name; reports a name that no row has.
template <typename Row>
std::optional<std::size_t> row_named(std::span<const Row> rows, const XmlAttribute& attribute,
                                     std::string_view why, Attributes& attributes) {
    Names names;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].name == attribute.value && !attribute.value.empty()) return i;
        names.push_back(rows[i].name);
    }
    attributes.bad_name({attribute.value, attribute.value_range}, attribute.name, names, why);
    return std::nullopt;
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_name_char(char c) { return is_letter(c) || c == '_'; }

class LanguageLoader {
  public:
    LanguageLoader(DialectTables& tables, Attributes& attributes)
        : tables_(tables), language_(tables.language), attributes_(attributes) {}

    void load(const XmlElement& element) {
        language_.is_present = true;
        read_sign(element, "open", language_.open);
        read_sign(element, "close", language_.close);
        read_sign(element, "index_open", language_.index_open);
        read_sign(element, "index_close", language_.index_close);
        Attributes::read_text(element, "label_sign", language_.label_sign);
        Attributes::read_text(element, "label_quote", language_.label_quote);
        attributes_.read_number(element, "label_length", language_.label_length);
        attributes_.read_flag(element, "block_words", language_.names_blocks);
        if (const XmlAttribute* quote = element.find("label_quote");
            quote != nullptr && !language_.label_sign.empty())
            attributes_.bad_value(*quote, "labels have a `label_sign` already");
        Attributes::read_text(element, "end_label", language_.end_label);
        Attributes::read_text(element, "axis_word", language_.axis_word);
        if (const XmlAttribute* words = element.find("lone_axis_words")) {
            language_.lone_axis_words.clear();
            for (const XmlWord& word : words_of(*words))
                language_.lone_axis_words.push_back(word.text);
        }
        for (const XmlElement& child : element.children) {
            load_examples(child);
            if (child.name == "example") load_example(child, tables_);
            if (child.name == "rule") load_rule(child);
            if (child.name == "operator") load_operator(child);
            if (child.name == "function") load_function(child);
            if (child.name == "variable") load_variable(child);
            if (child.name == "statement") load_statement(child);
            if (child.name == "type") load_type(child);
            if (child.name == "component") load_component(child);
            if (child.name == "codes") load_codes(child);
        }
        load_calls(element, language_, attributes_);
        check_called_names(element);
    }

  private:
    void read_sign(const XmlElement& element, std::string_view name, char& out) {
        const XmlAttribute* attribute = element.find(name);
        if (attribute == nullptr) return;
        if (attribute->value.size() != 1)
            return attributes_.bad_value(*attribute, "one sign is expected");
        out = attribute->value[0];
    }

    void load_examples(const XmlElement& element) {
        for (const XmlElement& child : element.children) {
            if (child.name == "example") load_example(child, tables_);
        }
    }

    void load_rule(const XmlElement& element) {
        const XmlAttribute& name = needed(element, "name");
        const XmlAttribute& value = needed(element, "value");
        if (value.value.starts_with('-'))
            return attributes_.bad_value(value, "0 or more is expected");
        if (set_language_rule(language_.rules, name.value, value.value)) return;
        const auto row =
            row_named(all_language_rules(), name, "the language has no such rule", attributes_);
        if (!row) return;
        const std::string why = "it takes: " + std::string(all_language_rules()[*row].values);
        attributes_.bad_value(value, why);
    }

    /// Whether an operation that has a text takes that of another one, which it was given: `*`
    /// would be a second sign of the division, and 6*3 were 2. A text may get another meaning, as
    /// MOD that of another remainder.
    template <typename Form, typename IsSame>
    Done require_own_text(const std::vector<Form>& forms, Operation operation,
                          const IsSame& is_same, const XmlAttribute& text) {
        const auto taken = std::ranges::find_if(forms, is_same);
        const bool is_taken = taken != forms.end() && taken->operation != operation;
        const auto own = std::ranges::find(forms, operation, &Form::operation);
        // What stands twice in one file is reported by lint.cpp.
        const bool is_new = said_texts_.insert(text.value).second;
        if (!is_taken || own == forms.end() || !is_new) return kDone;
        attributes_.bad_value(text, "it is `" + std::string(info(taken->operation).name) +
                                        "` already, and `" + std::string(info(operation).name) +
                                        "` has a text");
        return kFailed;
    }

    void load_operator(const XmlElement& element) {
        const XmlAttribute& name = needed(element, "name");
        const auto row =
            row_named(all_operations(), name, "there is no such operation", attributes_);
        if (!row) return;
        OperatorForm form;
        form.operation = static_cast<Operation>(*row);
        form.text = needed(element, "text").value;
        form.is_word = is_letter(form.text[0]);
        attributes_.read_number(element, "level", form.level);
        attributes_.read_flag(element, "prefix", form.is_prefix);
        const int count = form.is_prefix ? 1 : 2;
        const OperationInfo& operation = info(form.operation);
        if (count < operation.least_arguments || count > operation.most_arguments)
            return attributes_.bad_value(name, "it takes another number of operands");
        const auto is_same = [&](const OperatorForm& old) {
            return old.text == form.text && old.is_prefix == form.is_prefix;
        };
        if (!require_own_text(language_.operators, form.operation, is_same,
                              needed(element, "text")))
            return;
        std::erase_if(language_.operators, is_same);
        language_.operators.push_back(std::move(form));
    }

    /// `SIN[{a}]`, `ATAN[{a}]/[{b}]`, `SUBSTR({a},{b},{c})`
    void load_function(const XmlElement& element) {
        const XmlAttribute& name = needed(element, "name");
        const auto row =
            row_named(all_operations(), name, "there is no such operation", attributes_);
        if (!row) return;
        const XmlAttribute& text = needed(element, "form");
        FunctionForm form;
        form.operation = static_cast<Operation>(*row);
        form.form = text.value;
        Attributes::read_text(element, "doc", form.doc);
        std::size_t at = 0;
        while (at < text.value.size() && is_name_char(text.value[at])) ++at;
        while (at < text.value.size() && std::isdigit(static_cast<unsigned char>(text.value[at])))
            ++at;
        form.name = text.value.substr(0, at);
        form.arguments = static_cast<int>(std::ranges::count(text.value, '{'));
        const std::string between = std::string{language_.close} + '/' + language_.open;
        form.is_divided = text.value.find(between) != std::string::npos;
        const auto has = [&](const char* hole) {
            return text.value.find(hole) < text.value.size();
        };
        form.takes_any = has("{pairs}") || has("{axes}") || has("{values}");
        form.references = references_of(text.value);
        form.indexed = references_of(text.value, language_.index_open);
        const OperationInfo& operation = info(form.operation);
        const bool fits =
            !form.name.empty() && at < text.value.size() && text.value[at] == language_.open &&
            text.value.back() == language_.close && form.arguments >= operation.least_arguments &&
            form.arguments <= operation.most_arguments;
        if (!fits) {
            return attributes_.bad_value(
                text, "a name and its arguments in brackets are expected, as `SIN[{a}]`");
        }
        const auto is_same = [&](const FunctionForm& old) { return old.form == form.form; };
        if (!require_own_text(language_.functions, form.operation, is_same, text)) return;
        std::erase_if(language_.functions, is_same);
        language_.functions.push_back(std::move(form));
    }

    /// Which of the holes are `{array}` or `{variable}`; with a sign those behind which it stands.
    static std::uint32_t references_of(std::string_view form, char behind = '\0') {
        std::uint32_t out = 0;
        std::uint32_t index = 1;
        for (std::size_t at = 0; (at = form.find('{', at)) < form.size(); ++at, index <<= 1u) {
            const std::string_view hole = form.substr(at);
            if (!hole.starts_with("{array}") && !hole.starts_with("{variable}")) continue;
            const std::size_t end = hole.find('}') + 1;
            if (behind == '\0' || (end < hole.size() && hole[end] == behind)) out |= index;
        }
        return out;
    }

    // ---------------------------------------------------------------- variables

    void load_variable(const XmlElement& element) {
        const XmlAttribute& text = needed(element, "form");
        VariableForm form;
        form.form = text.value;
        form.range = text.value_range;
        if (!read_variable_form(text.value, form)) {
            return attributes_.bad_value(
                text,
                "a name is expected, and {n}, indices or {name} behind it: `R{n}`, "
                "`$P_EP[{axis}]`, `#<{name}>`, `$MN_{name}`");
        }
        for (const XmlElement& child : element.children) {
            if (child.name == "range") load_range(child, form);
        }
        if (form.ranges.empty())
            return attributes_.bad_value(text, "it needs a <range> that says what it is");
        if (form.is_open && form.ranges[0].kind != VariableRange::Kind::Input) {
            return attributes_.bad_value(
                text, "a name without an end needs `scope=\"input\"` or `scope=\"shared\"`");
        }
        // Of a family only the numbers that are given become something else.
        for (const VariableForm& old : language_.variables) {
            if (old.form == form.form && form.is_family)
                form.ranges.insert(form.ranges.end(), old.ranges.begin(), old.ranges.end());
        }
        std::erase_if(language_.variables,
                      [&](const VariableForm& old) { return old.form == form.form; });
        for (VariableForm& other : language_.variables) {
            const bool is_like = !other.is_family && !form.is_family && other.name == form.name;
            if (!is_like || other.indices.empty() == form.indices.empty()) continue;
            other.has_namesake = form.has_namesake = true;
        }
        language_.variables.push_back(std::move(form));
    }

    bool read_variable_form(std::string_view text, VariableForm& form) const {
        const std::size_t end = std::min(text.find_first_of("{["), text.size());
        form.name = text.substr(0, end);
        if (form.name.empty()) return false;
        form.has_signs = std::ranges::any_of(form.name, [](char c) {
            return !is_name_char(c) && c != '#' && c != '$' &&
                   std::isdigit(static_cast<unsigned char>(c)) == 0;
        });
        text.remove_prefix(end);
        if (text.empty()) return true;
        if (text == "{n}") {
            form.is_family = true;
            return true;
        }
        constexpr std::string_view kName = "{name}";
        if (text.starts_with(kName)) {
            form.closing = text.substr(kName.size());
            form.is_open = form.closing.empty();
            return form.closing.find_first_of("{}") == std::string::npos;
        }
        if (text.front() != language_.index_open || text.back() != language_.index_close)
            return false;
        text = text.substr(1, text.size() - 2);
        while (!text.empty()) {
            const std::size_t comma = std::min(text.find(','), text.size());
            IndexHole hole;
            const std::string_view piece = text.substr(0, comma);
            if (piece == "{axis}") {
                hole.kind = IndexHole::Kind::Axis;
            } else if (!piece.starts_with('{')) {
                hole.kind = IndexHole::Kind::Word;
                hole.word = piece;
            } else if (piece != "{n}") {
                return false;
            }
            form.indices.push_back(std::move(hole));
            text.remove_prefix(std::min(comma + 1, text.size()));
        }
        return !form.indices.empty();
    }

    void load_range(const XmlElement& element, VariableForm& form) {
        VariableRange range;
        attributes_.read_number(element, "first", range.first);
        range.last = range.first;
        attributes_.read_number(element, "last", range.last);
        attributes_.read_number(element, "start", range.start);
        attributes_.read_number(element, "stride", range.stride);
        attributes_.read_number(element, "second", range.second);
        Attributes::read_text(element, "meaning", range.meaning);
        if (const auto type = attributes_.choice(element, "type", kTypeNames))
            range.type = static_cast<ValueType>(*type);
        const XmlAttribute* scope = element.find("scope");
        const XmlAttribute* constant = element.find("constant");
        const XmlAttribute* quantity = element.find("quantity");
        if (scope != nullptr) {
            const auto found =
                attributes_.choice(element, "scope", {"global", "local", "input", "shared"});
            const bool is_input = found && *found >= 2;
            range.is_shared = found == std::size_t{3};
            range.kind = is_input                  ? VariableRange::Kind::Input
                         : found == std::size_t{1} ? VariableRange::Kind::Local
                                                   : VariableRange::Kind::Global;
            range.has_initial = !is_input && element.find("initial") != nullptr;
            attributes_.read_number(element, "initial", range.value);
            if (!is_input) allot(range);
        } else if (element.find("bits") != nullptr) {
            range.kind = VariableRange::Kind::Bits;
            attributes_.read_number(element, "bits", range.value);
        } else if (constant != nullptr) {
            range.kind = VariableRange::Kind::Constant;
            range.is_vacant = constant->value == "vacant";
            if (!range.is_vacant) attributes_.read_number(element, "constant", range.value);
        } else if (element.find("same") != nullptr) {
            range.kind = VariableRange::Kind::Same;
            attributes_.read_number(element, "same", range.value);
        } else if (quantity != nullptr) {
            range.kind = VariableRange::Kind::System;
            const auto row =
                row_named(all_quantities(), *quantity, "there is no such quantity", attributes_);
            if (!row) return;
            range.quantity = static_cast<SystemQuantity>(*row);
        } else {
            range.kind = VariableRange::Kind::Unsupported;
        }
        form.ranges.push_back(std::move(range));
    }

    void allot(VariableRange& range) {
        std::uint32_t& slots = range.kind == VariableRange::Kind::Global ? language_.global_slots
                                                                         : language_.local_slots;
        range.slot = slots;
        slots +=
            static_cast<std::uint32_t>(std::max<std::int64_t>(0, range.last - range.first)) + 1;
    }

    // ---------------------------------------------------------------- statements

    void load_statement(const XmlElement& element) {
        const XmlAttribute& name = needed(element, "name");
        const auto row =
            row_named(all_statements(), name, "there is no such statement", attributes_);
        if (!row) return;
        StatementForm form;
        form.statement = static_cast<Statement>(*row);
        form.form = element.text;
        attributes_.read_flag(element, "repeats", form.repeats);
        Attributes::read_text(element, "doc", form.doc);
        if (const XmlAttribute* closes = element.find("closes")) read_closes(*closes, form);
        if (const XmlAttribute* operation = element.find("operation"))
            read_operation(*operation, form);
        if (!read_tokens(element.text, form)) {
            return attributes_.bad_word(
                {element.text, element.text_range}, "statement",
                "a keyword is expected first, behind a bracket at most, and known "
                "{holes}");
        }
        if (!fits_operation(form))
            return attributes_.bad_value(name, "its operation takes another number of values");
        const XmlWord pattern{element.text, element.text_range};
        if (const std::string fault = fault_of_holes(form); !fault.empty())
            return attributes_.bad_word(pattern, "statement", fault);
        std::erase_if(language_.statements,
                      [&](const StatementForm& old) { return old.form == form.form; });
        language_.statements.push_back(std::move(form));
    }

    /// Programs that are named behind a keyword are those that `<call code="{name}">` knows.
    void check_called_names(const XmlElement& element) {
        if (std::ranges::any_of(language_.calls.calls, &CallForm::is_name)) return;
        for (const XmlElement& child : element.children) {
            if (child.name != "statement" || child.text.find("{call}") == std::string::npos)
                continue;
            attributes_.bad_word(
                {child.text, child.text_range}, "statement",
                "no program has a name here: `<call code=\"{name}\" …>` is missing");
        }
    }

    void read_closes(const XmlAttribute& attribute, StatementForm& form) {
        Names names;
        for (const StatementInfo& row : all_statements()) names.push_back(row.name);
        for (const XmlWord& word : words_of(attribute)) {
            const auto found = std::ranges::find(names, word.text);
            if (found == names.end()) {
                attributes_.bad_name(word, attribute.name, names, "there is no such statement");
            } else {
                form.closes |= 1u << (found - names.begin());
            }
        }
    }

    void read_operation(const XmlAttribute& attribute, StatementForm& form) {
        const auto row =
            row_named(all_operations(), attribute, "there is no such operation", attributes_);
        if (row) form.operation = static_cast<Operation>(*row);
    }

    /// As many values stand in the pattern as the operation takes.
    static bool fits_operation(const StatementForm& form) {
        if (!form.operation) return true;
        using Hole = StatementToken::Hole;
        const auto operands = std::ranges::count_if(form.tokens, [](const StatementToken& token) {
            return token.kind == StatementToken::Kind::Hole &&
                   (token.hole == Hole::Value || token.hole == Hole::Last);
        });
        return operands >= info(*form.operation).least_arguments &&
               operands <= info(*form.operation).most_arguments;
    }

    static bool read_tokens(std::string_view text, StatementForm& form) {
        bool is_optional = false;
        for (std::size_t at = 0; at < text.size();) {
            const char c = text[at];
            std::size_t end = at + 1;
            StatementToken token;
            if (c == ' ' || c == '\n' || c == '\t' || c == '\r') {
                ++at;
                continue;
            }
            if (c == '{') {
                end = text.find('}', at);
                if (end == std::string_view::npos) return false;
                std::string_view name = text.substr(at + 1, end - at - 1);
                ++end;
                token.kind = StatementToken::Kind::Hole;
                token.is_optional = name.ends_with('?');
                if (token.is_optional) name.remove_suffix(1);
                const auto hole = hole_named(name);
                if (!hole) return false;
                token.hole = *hole;
            } else if (is_name_char(c)) {
                const auto is_inside = [](char sign) {
                    return is_name_char(sign) ||
                           std::isdigit(static_cast<unsigned char>(sign)) != 0;
                };
                while (end < text.size() && is_inside(text[end])) ++end;
                token.text = text.substr(at, end - at);
            } else if (c == '?') {  // `?` before a piece: from here on it may be left out
                is_optional = true;
                ++at;
                continue;
            } else {
                token.kind = StatementToken::Kind::Sign;
                token.text = c;
                // In front of the keyword: `(BNC,{target})`.
                if (form.tokens.empty()) {
                    form.front += c;
                    at = end;
                    continue;
                }
            }
            token.is_optional |= is_optional;
            is_optional = false;
            form.tokens.push_back(std::move(token));
            at = end;
        }
        return !form.tokens.empty() && form.tokens[0].kind == StatementToken::Kind::Word;
    }

    void load_type(const XmlElement& element) {
        const auto type = attributes_.choice(element, "type", kTypeNames);
        if (!type) return;
        TypeName name{needed(element, "name").value, static_cast<ValueType>(*type)};
        std::erase_if(language_.types, [&](const TypeName& old) { return old.name == name.name; });
        language_.types.push_back(std::move(name));
    }

    void load_component(const XmlElement& element) {
        const auto row = row_named(all_frame_parts(), needed(element, "name"),
                                   "frames have no such component", attributes_);
        if (!row) return;
        FramePartName name{needed(element, "word").value, static_cast<FramePart>(*row)};
        std::erase_if(language_.frame_parts,
                      [&](const FramePartName& old) { return old.word == name.word; });
        language_.frame_parts.push_back(std::move(name));
    }

    void load_codes(const XmlElement& element) {
        GroupCodes list{needed(element, "group").value, {}, 1};
        attributes_.read_number(element, "standard", list.standard);
        for (const XmlWord& word : words_of(needed(element, "list")))
            list.codes.push_back(word.text);
        std::erase_if(language_.code_lists,
                      [&](const GroupCodes& old) { return old.group == list.group; });
        language_.code_lists.push_back(std::move(list));
    }

    inline static const Names kTypeNames = {"real", "int", "bool", "char", "text", "axis", "frame"};

    DialectTables& tables_;
    Language& language_;
    Attributes& attributes_;
    std::set<std::string> said_texts_;  // of the operators and functions of this file
};

}  // namespace

void load_language(const XmlElement& element, DialectTables& tables, Attributes& attributes) {
    LanguageLoader(tables, attributes).load(element);
    Language& language = tables.language;
    language.has_axes =
        std::ranges::find(language.types, ValueType::Axis, &TypeName::type) != language.types.end();
    language.lowest_level = 0;
    for (const OperatorForm& form : language.operators)
        language.lowest_level = std::max(language.lowest_level, form.level);
    language.variable_starts.reset();
    for (const VariableForm& form : language.variables) {
        const auto first = static_cast<unsigned char>(form.name[0]);
        if (first < 128) language.variable_starts.set(first);
        if (first < 128 && tables.notation.ignores_case)
            language.variable_starts.set(static_cast<unsigned char>(std::tolower(first)));
    }
    language.has_names_with_signs = std::ranges::any_of(
        language.variables,
        [](const VariableForm& form) { return form.has_signs && form.closing.empty(); });
    language.has_label_numbers = false;
    for (const StatementForm& form : language.statements)
        language.has_label_numbers |= form.statement == Statement::Label;
    // `D01`, `L{from}`: a letter and digits, as words are.
    for (const StatementForm& form : language.statements) {
        const std::string& keyword = form.tokens[0].text;
        if (keyword.size() > 1 && is_name_char(keyword[1])) continue;
        language.variable_starts.set(static_cast<unsigned char>(keyword[0]));
        if (tables.notation.ignores_case)
            language.variable_starts.set(
                static_cast<unsigned char>(std::tolower(static_cast<unsigned char>(keyword[0]))));
    }
    language.call_starts.reset();
    for (const CallForm& call : language.calls.calls) {
        const char first = call.is_name ? call.code[0] : call.letter;
        if (first != '{') language.call_starts.set(static_cast<unsigned char>(first));
        // `P=3 NAME`
        if (call.is_name && call.repeats != '\0')
            language.call_starts.set(static_cast<unsigned char>(call.repeats));
    }
    // The longest first: `GOTOF` before `GOTO`, `<=` before `<`.
    std::ranges::stable_sort(language.operators, [](const OperatorForm& a, const OperatorForm& b) {
        return a.text.size() > b.text.size();
    });
}

}  // namespace kadr::nc
