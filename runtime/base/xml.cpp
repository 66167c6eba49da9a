#include "base/xml.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <pugixml.hpp>

#include "base/assert.h"
#include "base/diagnostics/xml.h"
#include "base/text.h"
#include "base/utf8.h"

namespace kadr {

namespace {

constexpr int kDeepest = 64;

/// Where and why a text is not XML.
struct Fault {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::string what;
};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

std::string_view words_of(pugi::xml_parse_status status) {
    switch (status) {
        case pugi::status_ok: return "";
        case pugi::status_file_not_found:
        case pugi::status_io_error: return "the file cannot be read";
        case pugi::status_out_of_memory: return "there is not enough memory for it";
        case pugi::status_internal_error:
        case pugi::status_append_invalid_root: return "the parser gave up";
        case pugi::status_unrecognized_tag: return "this tag is of no known kind";
        case pugi::status_bad_pi: return "the declaration is broken";
        case pugi::status_bad_comment: return "the comment is not closed";
        case pugi::status_bad_cdata: return "the CDATA section is not closed";
        case pugi::status_bad_doctype: return "the document type is broken";
        case pugi::status_bad_pcdata: return "the text is broken";
        case pugi::status_bad_start_element: return "the start tag is broken";
        case pugi::status_bad_attribute: return "the attribute is broken";
        case pugi::status_bad_end_element: return "the end tag is broken";
        case pugi::status_end_element_mismatch: return "start tag and end tag do not match";
        case pugi::status_no_document_element: return "there is no element";
    }
    return "";
}

/// The first `&` that begins no entity of XML, from `begin` to `end`; npos if there is none.
std::size_t find_bad_entity(std::string_view text, std::size_t begin, std::size_t end) {
    constexpr std::array<std::string_view, 5> kEntities = {"amp;", "lt;", "gt;", "quot;", "apos;"};
    const std::string_view piece = text.substr(begin, end - begin);
    for (std::size_t at = piece.find('&'); at != std::string_view::npos;
         at = piece.find('&', at + 1)) {
        const std::string_view rest = piece.substr(at + 1);
        const bool is_known = std::ranges::any_of(
            kEntities, [rest](std::string_view name) { return rest.starts_with(name); });
        if (!is_known && !rest.starts_with('#')) return begin + at;
    }
    return std::string_view::npos;
}

/// Copies the library's tree and finds the locations, of which it keeps only those of the elements.
/// The text is well-formed here, so plain scans over names and quotes are enough.
class Copier {
  public:
    Copier(FileId file, std::string_view text) : file_(file), text_(text) {}

    XmlElement copy(const pugi::xml_node& node, int depth) {
        XmlElement element;
        element.name = node.name();
        const std::size_t begin = offset_of(node);
        element.range = range(begin, begin + element.name.size());
        copy_attributes(node, begin + element.name.size(), element);
        if (depth == kDeepest && node.first_child()) {
            fail(begin, begin + element.name.size(), "elements are nested deeper than 64");
            return element;
        }
        for (const pugi::xml_node& child : node.children()) {
            if (child.type() == pugi::node_element) {
                element.children.push_back(copy(child, depth + 1));
            } else if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) {
                copy_text(child, element);
            }
        }
        return element;
    }

    const std::optional<Fault>& fault() const { return fault_; }

    static std::size_t offset_of(const pugi::xml_node& node) {
        return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, node.offset_debug()));
    }

  private:
    SourceRange range(std::size_t begin, std::size_t end) const {
        return {file_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
    }

    void fail(std::size_t begin, std::size_t end, std::string what) {
        if (!fault_) fault_ = Fault{begin, end, std::move(what)};
    }

    void check_entities(std::size_t begin, std::size_t end) {
        const std::size_t bad = find_bad_entity(text_, begin, end);
        if (bad != std::string_view::npos) {
            fail(bad, bad + 1, "`&` begins no entity here; the sign itself is written `&amp;`");
        }
    }

    void copy_attributes(const pugi::xml_node& node, std::size_t at, XmlElement& element) {
        for (const pugi::xml_attribute& attribute : node.attributes()) {
            while (at < text_.size() && is_blank(text_[at])) ++at;
            const std::size_t name = at;
            while (at < text_.size() && text_[at] != '=' && !is_blank(text_[at])) ++at;
            const std::size_t name_end = at;
            const std::size_t quote = text_.find_first_of("\"'", at);
            if (quote == std::string_view::npos) break;
            const std::size_t close = text_.find(text_[quote], quote + 1);
            if (close == std::string_view::npos) break;
            element.attributes.push_back({attribute.name(), attribute.value(),
                                          range(name, name_end), range(quote + 1, close)});
            check_entities(quote + 1, close);
            at = close + 1;
        }
    }

    void copy_text(const pugi::xml_node& piece, XmlElement& element) {
        const std::size_t begin = offset_of(piece);
        const bool is_cdata = piece.type() == pugi::node_cdata;
        std::size_t end = std::min(text_.find(is_cdata ? "]]>" : "<", begin), text_.size());
        if (!is_cdata) check_entities(begin, end);
        while (end > begin && is_blank(text_[end - 1])) --end;
        if (!element.text_range.file.is_valid()) element.text_range = range(begin, end);
        element.text += piece.value();
    }

    FileId file_;
    std::string_view text_;
    std::optional<Fault> fault_;
};

/// The one element of a document that has nothing else outside of its comments.
std::optional<pugi::xml_node> only_element(const pugi::xml_document& document,
                                           std::string_view text, Fault& fault) {
    const pugi::xml_node root = document.document_element();
    if (!root) {
        fault = {0, 0, "there is no element"};
        return std::nullopt;
    }
    for (const pugi::xml_node& node : document.children()) {
        if (node == root) continue;
        const std::size_t at = Copier::offset_of(node);
        if (node.type() == pugi::node_element) {
            fault = {at, at + std::string_view(node.name()).size(),
                     "there is a second outermost element"};
            return std::nullopt;
        }
        if (node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata) {
            fault = {at, std::min(at + 1, text.size()), "there is text outside of the element"};
            return std::nullopt;
        }
    }
    return root;
}

/// What the declaration claims that the text is not: files are read as UTF-8, whatever it is.
std::optional<Fault> fault_of_encoding(std::string_view text) {
    if (const std::size_t at = find_malformed(text); at != std::string_view::npos)
        return Fault{at, at + 1, "this byte is no UTF-8; the file must be stored as UTF-8"};
    if (!text.starts_with("<?xml")) return std::nullopt;
    constexpr std::string_view kAttribute = "encoding=";
    const std::string_view head = text.substr(0, text.find("?>"));
    const std::size_t name = head.find(kAttribute);
    if (name == std::string_view::npos) return std::nullopt;
    const std::size_t begin = name + kAttribute.size() + 1;
    const std::size_t end = std::min(head.find_first_of("\"'", begin), head.size());
    const std::string words = upper_ascii(head.substr(std::min(begin, end), end - begin));
    if (words == "UTF-8" || words == "UTF8" || words == "US-ASCII" || words == "ASCII")
        return std::nullopt;
    return Fault{begin, end, "the file says that it is " + words + ", and is read as UTF-8"};
}

std::optional<XmlElement> parse(FileId file, std::string_view text, Fault& fault) {
    if (const auto encoding = fault_of_encoding(text)) {
        fault = *encoding;
        return std::nullopt;
    }
    pugi::xml_document document;
    // As a fragment, the library keeps what stands beside the outermost element.
    const pugi::xml_parse_result parsed = document.load_buffer(
        text.data(), text.size(),
        pugi::parse_default | pugi::parse_trim_pcdata | pugi::parse_fragment, pugi::encoding_utf8);
    if (!parsed) {
        const auto at = std::min(
            static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, parsed.offset)), text.size());
        fault = {at, std::min(at + 1, text.size()), std::string(words_of(parsed.status))};
        return std::nullopt;
    }
    const auto root = only_element(document, text, fault);
    if (!root) return std::nullopt;
    Copier copier(file, text);
    XmlElement element = copier.copy(*root, 1);
    if (!copier.fault()) return element;
    fault = *copier.fault();
    return std::nullopt;
}

/// A text that does not even begin as XML may have been named by mistake, or by somebody who wants
/// to see it in messages: its line is not shown.
DiagnosticBuilder report_malformed(const SourceRange& location, const Sources& sources,
                                   DiagnosticSink& sink) {
    const std::string_view text = sources.text(location.file);
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || text[first] == '<')
        return sink.report(diag::XmlMalformed, location);
    const LineColumn at = sources.locate(location.file, location.begin);
    return sink.report(
        diag::XmlMalformed,
        TextLocation{std::string(sources.name(location.file)), at.line, at.column, 1, {}});
}

const XmlRule* find_rule(const XmlShape& shape, std::string_view element) {
    const auto found = std::ranges::find(shape.rules, element, &XmlRule::element);
    return found == shape.rules.end() ? nullptr : &*found;
}

std::vector<std::string_view> attribute_names(const XmlRule& rule) {
    std::vector<std::string_view> names;
    for (const XmlAttributeRule& attribute : rule.attributes) names.push_back(attribute.name);
    return names;
}

/// Adds the name that may have been meant. Returns it.
std::optional<std::string_view> propose(DiagnosticBuilder& message, const SourceRange& range,
                                        std::string_view wrong,
                                        const std::vector<std::string_view>& allowed) {
    const auto near = nearest_name(wrong, allowed.data(), allowed.size());
    if (near) message.fix(range, std::string(*near), "is this meant?");
    return near;
}

bool belongs_to_xml(std::string_view attribute) {
    return attribute.starts_with("xmlns") || attribute.starts_with("xsi:");
}

/// The attributes of one element are as the rule wants.
Done check_attributes(const XmlElement& element, const XmlRule& rule, DiagnosticSink& sink) {
    bool is_good = true;
    const std::vector<std::string_view> names = attribute_names(rule);
    std::vector<std::string_view> meant;  // needed ones that stand there misspelt
    for (const XmlAttribute& attribute : element.attributes) {
        if (belongs_to_xml(attribute.name)) continue;
        if (std::ranges::find(names, attribute.name) == names.end()) {
            is_good = false;
            auto message = sink.report(diag::XmlUnknownAttribute, attribute.name_range);
            message.arg(element.name).arg(shown_value(attribute.name));
            const auto near = propose(message, attribute.name_range, attribute.name, names);
            if (near) meant.push_back(*near);
        } else if (element.find(attribute.name) != &attribute) {
            is_good = false;
            sink.report(diag::XmlAttributeTwice, attribute.name_range)
                .arg(attribute.name)
                .arg(element.name)
                .note(element.find(attribute.name)->name_range, "the first one");
        }
    }
    for (const XmlAttributeRule& wanted : rule.attributes) {
        if (wanted.use == XmlAttributeRule::Use::Optional) continue;
        const XmlAttribute* attribute = element.find(wanted.name);
        if (attribute == nullptr) {
            is_good = false;
            if (std::ranges::find(meant, wanted.name) != meant.end()) continue;  // reported already
            sink.report(diag::XmlMissingAttribute, element.range)
                .arg(element.name)
                .arg(wanted.name);
        } else if (wanted.use == XmlAttributeRule::Use::Filled && attribute->value.empty()) {
            is_good = false;
            sink.report(diag::XmlAttributeEmpty, attribute->name_range)
                .arg(wanted.name)
                .arg(element.name);
        }
    }
    return Done{is_good};
}

}  // namespace

const XmlAttribute* XmlElement::find(std::string_view attribute) const {
    const auto found = std::ranges::find(attributes, attribute, &XmlAttribute::name);
    return found == attributes.end() ? nullptr : &*found;
}

std::optional<XmlElement> parse_xml(FileId file, const Sources& sources, const XmlShape& shape,
                                    DiagnosticSink& sink) {
    Fault fault;
    auto root = parse(file, sources.text(file), fault);
    if (!root) {
        const SourceRange location{file, static_cast<std::uint32_t>(fault.begin),
                                   static_cast<std::uint32_t>(fault.end)};
        report_malformed(location, sources, sink).arg(fault.what);
        return std::nullopt;
    }
    const std::string_view wanted = shape.rules.front().element;
    if (root->name == wanted) return root;
    auto message = sink.report(diag::XmlRoot, root->range);
    message.arg(shown_value(root->name)).arg(shape.kind).arg(wanted);
    propose(message, root->range, root->name, {wanted});
    return std::nullopt;
}

std::map<std::string, std::string> first_tag(const std::string& path, const Files& files) {
    // In front of the tag stand comments at most; where they are long, the whole file is read.
    constexpr std::size_t kUsualHead = 4096;
    std::string head(kUsualHead, '\0');
    const std::unique_ptr<FileReader> file = files.open(path);
    head.resize(file == nullptr ? 0 : file->read(head));
    pugi::xml_document document;
    const auto read = [&document](const std::string& text) {
        const auto parsed = document.load_buffer(text.data(), text.size(), pugi::parse_default,
                                                 pugi::encoding_utf8);
        // Elements without an end are no fault of a head.
        return parsed || parsed.status == pugi::status_end_element_mismatch;
    };
    if (!read(head) || !document.document_element()) {
        const auto whole = files.read(path);
        read(whole ? *whole : std::string());
    }
    std::map<std::string, std::string> attributes;
    for (const pugi::xml_attribute& attribute : document.document_element().attributes())
        attributes.emplace(attribute.name(), attribute.value());
    return attributes;
}

Done check_xml(const XmlElement& element, const XmlShape& shape, DiagnosticSink& sink) {
    const XmlRule* rule = find_rule(shape, element.name);
    KADR_ASSERT(rule != nullptr, "every element that may stand somewhere has a rule");
    bool is_good{check_attributes(element, *rule, sink)};
    if (rule->text == XmlRule::Text::None && element.text_range.file.is_valid()) {
        is_good = false;
        sink.report(diag::XmlStrayText, element.text_range).arg(element.name);
    }
    for (const XmlElement& child : element.children) {
        if (std::ranges::find(rule->children, child.name) != rule->children.end()) {
            if (!check_xml(child, shape, sink)) is_good = false;
            continue;
        }
        is_good = false;
        auto message = sink.report(diag::XmlUnknownElement, child.range);
        message.arg(shown_value(child.name)).arg(element.name);
        if (propose(message, child.range, child.name, rule->children)) continue;
        for (const XmlRule& home : shape.rules) {
            if (std::ranges::find(home.children, child.name) != home.children.end())
                message.note("`<" + shown_value(child.name) + ">` may stand inside `<" +
                             std::string(home.element) + ">`");
        }
    }
    return Done{is_good};
}

bool has_needed_attributes(const XmlElement& element, const XmlShape& shape) {
    const XmlRule* rule = find_rule(shape, element.name);
    return rule != nullptr &&
           std::ranges::all_of(rule->attributes, [&](const XmlAttributeRule& wanted) {
               const XmlAttribute* attribute = element.find(wanted.name);
               const bool is_filled = attribute != nullptr && !attribute->value.empty();
               return wanted.use == XmlAttributeRule::Use::Optional ||
                      (wanted.use == XmlAttributeRule::Use::Filled ? is_filled
                                                                   : attribute != nullptr);
           });
}

XmlElement sound_part(const XmlElement& element, const XmlShape& shape) {
    XmlElement sound = element;
    sound.children.clear();
    const XmlRule* rule = find_rule(shape, element.name);
    for (const XmlElement& child : element.children) {
        const bool is_known = rule != nullptr &&
                              std::ranges::find(rule->children, child.name) != rule->children.end();
        if (is_known && has_needed_attributes(child, shape))
            sound.children.push_back(sound_part(child, shape));
    }
    return sound;
}

std::vector<XmlWord> words_of(const XmlAttribute& attribute) {
    const std::string& value = attribute.value;
    const SourceRange& range = attribute.value_range;
    const bool is_as_it_stands = range.end - range.begin == value.size();
    constexpr std::string_view kBlanks = " \t\r\n";
    std::vector<XmlWord> words;
    std::size_t at = 0;
    while ((at = value.find_first_not_of(kBlanks, at)) != std::string::npos) {
        const std::size_t end = std::min(value.find_first_of(kBlanks, at), value.size());
        XmlWord word{value.substr(at, end - at), range};
        if (is_as_it_stands) {
            word.range.begin = range.begin + static_cast<std::uint32_t>(at);
            word.range.end = range.begin + static_cast<std::uint32_t>(end);
        }
        words.push_back(std::move(word));
        at = end;
    }
    return words;
}

std::string shown_value(std::string_view value) {
    constexpr std::size_t kLongest = 60;
    if (value.size() <= kLongest) return std::string(value);
    std::size_t end = kLongest;
    while (end > 0 && (static_cast<unsigned char>(value[end]) & 0xC0) == 0x80) --end;
    return std::string(value.substr(0, end)) + "…";
}

}  // namespace kadr
