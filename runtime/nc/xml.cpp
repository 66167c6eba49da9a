#include "nc/xml.h"

#include <pugixml.hpp>

namespace kadr::nc {

namespace {

/// Where the attributes of a start tag stand; the library keeps no places for them.
class TagScanner {
  public:
    TagScanner(std::string_view text, FileId file, std::size_t tag)
        : text_(text), file_(file), at_(tag) {}

    /// Place of the next attribute with this name behind the last one found.
    SourceRange find(std::string_view name) {
        bool in_quotes = false;
        char quote = 0;
        for (std::size_t i = at_; i < text_.size(); ++i) {
            const char c = text_[i];
            if (in_quotes) {
                in_quotes = c != quote;
            } else if (c == '"' || c == '\'') {
                in_quotes = true;
                quote = c;
            } else if (c == '>') {
                break;
            } else if (text_.compare(i, name.size(), name) == 0 && is_blank(text_[i - 1])) {
                at_ = i + name.size();
                return {file_, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(at_)};
            }
        }
        const auto here = static_cast<std::uint32_t>(at_);
        return {file_, here, here};
    }

  private:
    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
    std::string_view text_;
    FileId file_;
    std::size_t at_;
};

XmlElement convert(const pugi::xml_node& node, FileId file, std::string_view text) {
    XmlElement element;
    element.name = node.name();
    const auto begin = static_cast<std::uint32_t>(node.offset_debug());
    const auto end = static_cast<std::uint32_t>(begin + element.name.size());
    element.range = {file, begin, end};
    TagScanner scanner(text, file, end);
    for (const pugi::xml_attribute& attribute : node.attributes()) {
        element.attributes.push_back(
            {attribute.name(), attribute.value(), scanner.find(attribute.name())});
    }
    for (const pugi::xml_node& child : node.children()) {
        if (child.type() == pugi::node_element) {
            element.children.push_back(convert(child, file, text));
        } else if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) {
            element.text += child.value();
        }
    }
    return element;
}

}  // namespace

std::optional<XmlElement> parse_xml(FileId file, const Sources& sources, DiagnosticSink& sink) {
    const std::string_view text = sources.text(file);
    pugi::xml_document document;
    const pugi::xml_parse_result result =
        document.load_buffer(text.data(), text.size(),
                             pugi::parse_default | pugi::parse_trim_pcdata, pugi::encoding_utf8);
    if (!result) {
        // What holds no element at all is wrong from its first byte, not from its last.
        const bool is_no_xml = result.status == pugi::status_no_document_element;
        const auto at = static_cast<std::uint32_t>(
            is_no_xml
                ? 0
                : std::min<std::size_t>(static_cast<std::size_t>(result.offset), text.size()));
        sink.report(diag::DialectMalformed, SourceRange{file, at, at}).arg(result.description());
        return std::nullopt;
    }
    const pugi::xml_node root = document.document_element();
    if (!root) {
        sink.report(diag::DialectMalformed, SourceRange{file, 0, 0}).arg("there is no element");
        return std::nullopt;
    }
    return convert(root, file, text);
}

}  // namespace kadr::nc
