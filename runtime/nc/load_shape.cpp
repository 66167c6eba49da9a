// Which elements and attributes a dialect file may have, and where; mirrors dialect.xsd.
#include <algorithm>

#include "base/text.h"
#include "nc/load.h"

namespace kadr::nc {

namespace {

using Names = std::vector<std::string_view>;

/// The attributes that an element may have; also what its children may be. Mirrors dialect.xsd.
struct ElementRule {
    std::string_view name;
    Names attributes;
    Names children;
};

const std::vector<ElementRule>& element_rules() {
    static const std::vector<ElementRule> rules = {
        {"dialect",
         {"name", "extends", "title", "suffix"},
         {"doc", "program", "blocks", "comment", "rules", "address", "number", "group", "command",
          "cycle", "deferred", "alarm", "rule", "remove", "example"}},
        {"doc", {}, {}},
        {"program",
         {"name_length", "name_letters", "least_number", "most_number"},
         {"header", "start", "finish", "end", "skipped"}},
        {"header", {}, {}},
        {"start", {}, {}},
        {"finish", {}, {}},
        {"end", {}, {}},
        {"skipped", {}, {}},
        {"blocks", {"numbers", "start", "step", "most"}, {}},
        {"comment", {"open", "close", "case", "charset", "max_length"}, {"replace"}},
        {"replace", {"character", "by"}, {}},
        {"rules",
         {"repeated_address", "repeated_group", "case", "assignment", "modes",
          "blanks_inside_words", "skip_levels", "default_skip", "read_line", "write_line",
          "line_end"},
         {}},
        {"address",
         {"name", "kind", "slot", "dimension", "order", "write_max", "read_max", "doc"},
         {}},
        {"number",
         {"addresses", "decimals", "inch_decimals", "point", "digits", "max_digits", "increment",
          "inch_increment", "revolution_increment", "truncates", "minus"},
         {}},
        {"group", {"name", "default"}, {"code"}},
        {"code", {"text", "function", "sets", "use", "feed", "own_block", "doc"}, {"example"}},
        {"command", {"name", "group", "doc"}, {"form", "example"}},
        {"form",
         {"when", "sets", "needs", "before", "during", "outside", "first", "lead", "use",
          "own_block", "remembers", "keeps_length", "implied", "feed", "note"},
         {}},
        {"cycle", {"name", "parameters", "meaning", "doc"}, {"form", "example"}},
        {"deferred", {"axis", "functions"}, {}},
        {"alarm", {"for", "number", "text"}, {}},
        {"rule", {"name", "value", "doc"}, {}},
        {"remove", {"commands", "addresses", "cycles"}, {}},
        {"example", {"source", "text", "block", "meaning"}, {}},
    };
    return rules;
}

const ElementRule* find_rule(std::string_view name) {
    for (const ElementRule& rule : element_rules()) {
        if (rule.name == name) return &rule;
    }
    return nullptr;
}

/// Reports a name that is not allowed, with the one that may have been meant.
void report_unknown(const DiagnosticRow& row, const SourceRange& range, std::string_view first,
                    std::string_view second, std::string_view wrong, const Names& allowed,
                    DiagnosticSink& sink) {
    auto report = std::move(sink.report(row, range).arg(first).arg(second));
    if (const auto near = nearest_name(wrong, allowed.data(), allowed.size())) {
        report.fix(range, std::string(*near), "is this meant?");
    }
}

}  // namespace

bool check_shape(const XmlElement& element, DiagnosticSink& sink) {
    bool is_fine = true;
    const ElementRule* rule = find_rule(element.name);
    for (const XmlAttribute& attribute : element.attributes) {
        const std::string_view name = attribute.name;
        if (name.starts_with("xmlns") || name.starts_with("xsi:")) continue;
        if (std::ranges::find(rule->attributes, name) != rule->attributes.end()) continue;
        is_fine = false;
        report_unknown(diag::DialectUnknownAttribute, attribute.range, element.name, name, name,
                       rule->attributes, sink);
    }
    for (const XmlElement& child : element.children) {
        if (std::ranges::find(rule->children, child.name) != rule->children.end()) {
            is_fine &= check_shape(child, sink);
            continue;
        }
        is_fine = false;
        report_unknown(diag::DialectUnknownElement, child.range, child.name, element.name,
                       child.name, rule->children, sink);
    }
    return is_fine;
}

}  // namespace kadr::nc
