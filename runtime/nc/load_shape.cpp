// Which elements and attributes a dialect file may have, and where; mirrors dialect.xsd.
#include "nc/load.h"

namespace kadr::nc {

namespace {

constexpr auto Needed = XmlAttributeRule::Use::Needed;
constexpr auto Filled = XmlAttributeRule::Use::Filled;
constexpr auto Text = XmlRule::Text::Allowed;

const std::vector<XmlRule>& dialect_rules() {
    static const std::vector<XmlRule> rules = {
        {"dialect",
         {{"name", Filled}, "extends", {"title", Filled}, {"suffix", Filled}},
         {"doc", "program", "blocks", "comment", "rules", "address", "number", "group", "command",
          "cycle", "deferred", "alarm", "rule", "remove", "unsupported", "example", "language"}},
        {"doc", {}, {}, Text},
        {"program",
         {"name_length", "name_letters", "least_number", "most_number", "most_read_number"},
         {"header", "start", "finish", "end", "skipped"}},
        {"header", {}, {}, Text},
        {"start", {}, {}, Text},
        {"finish", {}, {}, Text},
        {"end", {}, {}, Text},
        {"skipped", {}, {}, Text},
        {"blocks", {"numbers", "start", "step", "least", "most"}, {}},
        {"comment", {{"open", Filled}, "close", "case", "charset", "max_length"}, {"replace"}},
        {"replace", {{"character", Filled}, {"by", Needed}}, {}},
        {"rules",
         {"repeated_address", "repeated_group", "case", "assignment", "modes", "number_first",
          "blanks_inside_words", "several_skips", "end_sign", "modal_call", "skip_levels",
          "default_skip", "read_line", "write_line", "line_end"},
         {}},
        {"address",
         {{"name", Filled},
          "kind",
          "slot",
          "incremental",
          "dimension",
          "order",
          "write_max",
          "read_max",
          "doc"},
         {}},
        {"number",
         {{"addresses", Filled},
          "decimals",
          "inch_decimals",
          "lead_decimals",
          "inch_lead_decimals",
          "point",
          "digits",
          "max_digits",
          "increment",
          "inch_increment",
          "revolution_increment",
          "truncates",
          "minus"},
         {}},
        {"group", {{"name", Filled}, "default"}, {"code"}},
        {"code",
         {{"text", Filled},
          {"command", Filled},
          "sets",
          "outside",
          "use",
          "feed",
          "own_block",
          "only",
          "doc"},
         {"example"}},
        {"command", {{"name", Filled}, "group", "doc"}, {"form", "example"}},
        {"form",
         {"when",    "sets",  "needs",  "before",     "during",    "outside",
          "first",   "lead",  "use",    "own_block",  "remembers", "keeps_length",
          "implied", "drops", "preset", "verbatim",   "leaves",    "spindle",
          "feed",    "note",  "only",   "unsupported"},
         {},
         Text},
        {"cycle",
         {{"name", Filled},
          "parameters",
          "module",
          "meaning",
          "modal",
          "otherwise",
          "settings",
          "depth",
          "retract",
          "stroke",
          "shift",
          "dwell",
          "doc"},
         {"form", "example"}},
        {"deferred", {"axis", "commands"}, {}, Text},
        {"alarm", {{"for", Filled}, {"number", Filled}, "text", "about"}, {}},
        {"rule", {{"name", Filled}, {"value", Filled}, "doc"}, {}},
        {"remove", {"commands", "addresses", "cycles", "deferred"}, {}},
        {"unsupported", {{"words", Filled}, {"meaning", Filled}}, {}},
        {"example", {"source", {"text", Filled}, "block", "meaning"}, {}},
        {"language",
         {"open", "close", "index_open", "index_close", "label_sign", "end_label"},
         {"doc", "rule", "operator", "function", "variable", "statement", "type", "codes"}},
        {"operator", {{"name", Filled}, {"text", Filled}, {"level", Filled}, "prefix"}, {}},
        {"function", {{"name", Filled}, {"form", Filled}, "doc"}, {}},
        {"variable", {{"form", Filled}}, {"range"}},
        {"range",
         {"first", "last", "type", "scope", "constant", "quantity", "start", "stride", "meaning"},
         {}},
        {"statement", {{"name", Filled}, "closes", "repeats", "doc"}, {}, Text},
        {"type", {{"name", Filled}, {"type", Filled}}, {}},
        {"codes", {{"group", Filled}, {"list", Filled}}, {}},
    };
    return rules;
}

}  // namespace

const XmlShape& dialect_shape() {
    static const XmlShape shape = {"a dialect file", dialect_rules()};
    return shape;
}

}  // namespace kadr::nc
