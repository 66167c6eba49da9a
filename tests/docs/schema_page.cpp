#include "tests/docs/schema_page.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "base/xml.h"
#include "tests/docs/cells.h"

namespace docs {
namespace {

using kadr::XmlElement;

constexpr const char* kSchema = KADR_ROOT "/dialects/dialect.xsd";

std::string value_of(const XmlElement& element, std::string_view attribute) {
    const kadr::XmlAttribute* found = element.find(attribute);
    return found == nullptr ? "" : found->value;
}

std::vector<const XmlElement*> children_of(const XmlElement& element, std::string_view name) {
    std::vector<const XmlElement*> found;
    for (const XmlElement& child : element.children)
        if (child.name == name) found.push_back(&child);
    return found;
}

/// The text of <xs:annotation><xs:documentation>, if there is one.
std::string documentation_of(const XmlElement& element) {
    for (const XmlElement* annotation : children_of(element, "xs:annotation")) {
        for (const XmlElement* text : children_of(*annotation, "xs:documentation"))
            return text->text;
    }
    return "";
}

/// The elements that a type holds, in the order of the schema.
std::vector<const XmlElement*> held_elements(const XmlElement& type) {
    std::vector<const XmlElement*> found;
    for (const char* list : {"xs:choice", "xs:sequence"}) {
        for (const XmlElement* each : children_of(type, list)) {
            const auto inside = children_of(*each, "xs:element");
            found.insert(found.end(), inside.begin(), inside.end());
        }
    }
    return found;
}

/// Values of <xs:enumeration>, at any depth.
void add_enumerations(const XmlElement& element, std::vector<std::string>& out) {
    if (element.name == "xs:enumeration") out.push_back('`' + value_of(element, "value") + '`');
    for (const XmlElement& child : element.children) add_enumerations(child, out);
}

std::string joined(const std::vector<std::string>& words, const char* between) {
    std::string out;
    for (const std::string& word : words) out += (out.empty() ? "" : between) + word;
    return out;
}

/// Where an element stands, and what the schema says of it.
struct Described {
    std::string heading;  // "`<code>` in `<group>`"
    std::string name;
    const XmlElement* type = nullptr;
    std::string own_text;  // of the element itself, if it says more than its type
    std::vector<std::string> inside;
};

class SchemaPage {
  public:
    explicit SchemaPage(const XmlElement& schema) {
        for (const XmlElement* type : children_of(schema, "xs:complexType"))
            types_[value_of(*type, "name")] = type;
        for (const XmlElement* type : children_of(schema, "xs:simpleType"))
            simple_types_[value_of(*type, "name")] = type;
        for (const XmlElement* element : children_of(schema, "xs:element")) describe(*element, "");
    }

    std::string text() const {
        std::string out;
        for (const Described& element : elements_) out += text_of(element);
        return out;
    }

  private:
    /// An element with everything below it, each type once.
    void describe(const XmlElement& element, const std::string& inside) {
        const std::string name = value_of(element, "name");
        const std::string type_name = value_of(element, "type");
        const XmlElement* type = nullptr;
        if (type_name.empty()) {
            const auto own = children_of(element, "xs:complexType");
            if (!own.empty()) type = own.front();
        } else if (const auto found = types_.find(type_name); found != types_.end()) {
            type = found->second;
        }
        if (type == nullptr) return;  // a text: it stands in the list of the element around it
        const auto known = std::ranges::find(elements_, type, &Described::type);
        if (known != elements_.end()) {
            known->inside.push_back(inside);
            return;
        }
        const std::string tag = "`<" + name + ">`";
        const bool is_part = type_name.empty() && !inside.empty();
        elements_.push_back(
            {is_part ? tag + " in " + inside : tag, name, type, documentation_of(element), {}});
        if (!inside.empty()) elements_.back().inside.push_back(inside);
        for (const XmlElement* child : held_elements(*type)) describe(*child, tag);
    }

    std::string text_of(const Described& element) const {
        std::string out = "### " + element.heading + "\n\n";
        for (const std::string& text : {element.own_text, documentation_of(*element.type)})
            if (!text.empty()) out += plain(text) + "\n\n";
        const bool says_where = element.heading.find(" in ") != std::string::npos;
        if (!element.inside.empty() && !says_where)
            out += "Stands in " + joined(element.inside, ", ") + ".\n\n";
        out += held_text(*element.type) + attributes_text(*element.type);
        return out;
    }

    /// The elements that it holds: those that are a text with what they say.
    std::string held_text(const XmlElement& type) const {
        std::vector<std::string> names;
        std::string texts;
        for (const XmlElement* child : held_elements(type)) {
            const std::string tag = "`<" + value_of(*child, "name") + ">`";
            if (value_of(*child, "type") == "xs:string")
                texts += "| " + tag + " | " + cell(documentation_of(*child)) + " |\n";
            else names.push_back(tag);
        }
        std::string out;
        if (!names.empty()) out += "Holds " + joined(names, ", ") + ".\n\n";
        if (!texts.empty()) out += "| holds the text | meaning |\n| --- | --- |\n" + texts + '\n';
        return out;
    }

    std::string attributes_text(const XmlElement& type) const {
        std::string rows;
        for (const XmlElement* attribute : children_of(type, "xs:attribute")) {
            const bool is_needed = value_of(*attribute, "use") == "required";
            const std::string type_name = value_of(*attribute, "type");
            std::string text = documentation_of(*attribute);
            if (const auto found = simple_types_.find(type_name);
                text.empty() && found != simple_types_.end())
                text = documentation_of(*found->second);
            rows += "| `" + value_of(*attribute, "name") + '`' + (is_needed ? ", needed" : "") +
                    " | " + values_text(*attribute, type_name) + " | " + cell(text) + " |\n";
        }
        if (rows.empty()) return "";
        return "| attribute | value | meaning |\n| --- | --- | --- |\n" + rows + '\n';
    }

    /// What an attribute takes.
    std::string values_text(const XmlElement& attribute, const std::string& type_name) const {
        static const std::map<std::string, std::string> kNames = {
            {"xs:string", "text"},
            {"xs:NCName", "name"},
            {"xs:nonNegativeInteger", "whole number"},
            {"xs:positiveInteger", "whole number from 1 on"},
            {"xs:integer", "whole number, with a sign"},
            {"xs:double", "number"},
            {"xs:decimal", "number"},
            {"xs:NMTOKEN", "word"},
            {"xs:NMTOKENS", "words"},
            {"sign", "one sign"},
            {"commands", "commands"}};
        if (const auto found = kNames.find(type_name); found != kNames.end()) return found->second;
        std::vector<std::string> values;
        const auto found = simple_types_.find(type_name);
        if (found != simple_types_.end()) add_values(*found->second, values);
        else add_values(attribute, values);
        EXPECT_FALSE(values.empty())
            << "no word for the values of " << value_of(attribute, "name") << ' ' << type_name;
        return joined(values, " ");
    }

    /// Of a simple type: its enumerations, those of the types that it unites, or its pattern.
    void add_values(const XmlElement& type, std::vector<std::string>& values) const {
        for (const XmlElement* both : children_of(type, "xs:union")) {
            const auto member = simple_types_.find(value_of(*both, "memberTypes"));
            if (member != simple_types_.end()) add_enumerations(*member->second, values);
        }
        add_enumerations(type, values);
        if (values.empty()) add_patterns(type, values);
    }
    static void add_patterns(const XmlElement& element, std::vector<std::string>& values) {
        if (element.name == "xs:pattern") values.emplace_back("text, as the meaning says");
        for (const XmlElement& child : element.children) add_patterns(child, values);
    }

    std::map<std::string, const XmlElement*> types_;
    std::map<std::string, const XmlElement*> simple_types_;
    std::vector<Described> elements_;
};

}  // namespace

std::string elements_of_dialects() {
    static const std::vector<kadr::XmlRule> rules = {{"xs:schema", {}, {}}};
    kadr::Sources sources;
    kadr::DiagnosticList messages;
    const auto text = kadr::read_file(kSchema);
    if (!text) {
        ADD_FAILURE() << kSchema << " cannot be read";
        return "";
    }
    const kadr::FileId file = sources.add(kSchema, *text);
    const auto schema = kadr::parse_xml(file, sources, {"a schema", rules}, messages);
    if (!schema) {
        ADD_FAILURE() << kSchema << " is no schema";
        return "";
    }
    return SchemaPage(*schema).text();
}

}  // namespace docs
