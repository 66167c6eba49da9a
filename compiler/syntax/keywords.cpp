// keywords.cpp — dialects/languages/*.xml → KeywordTable. The only place that reads these files.
#include <algorithm>
#include <filesystem>

#include <pugixml.hpp>

#include "base/text.h"
#include "syntax/keyword.h"
#include "syntax/parse.h"

namespace kadr::syntax {

namespace {

class Loader {
  public:
    Loader(Sources& sources, FileId file, DiagnosticSink& sink)
        : sources_(sources), file_(file), sink_(sink) {}

    std::optional<KeywordTable> load();

  private:
    void element(const pugi::xml_node& node);
    void lexeme(const pugi::xml_node& node, const std::string& name, const std::string& lexeme);
    void require_all();
    SourceRange place(const pugi::xml_node& node) const;
    DiagnosticBuilder report(const DiagnosticRow& row, const SourceRange& range) {
        is_good_ = false;
        return sink_.report(row, range);
    }

    Sources& sources_;
    FileId file_;
    DiagnosticSink& sink_;
    KeywordTable table_;
    bool is_good_ = true;
};

SourceRange Loader::place(const pugi::xml_node& node) const {
    const auto begin = static_cast<std::uint32_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
    const auto length = static_cast<std::uint32_t>(std::string_view(node.name()).size());
    return {file_, begin, begin + std::max(length, 1u)};
}

std::optional<KeywordTable> Loader::load() {
    const std::string_view text = sources_.text(file_);
    pugi::xml_document document;
    const pugi::xml_parse_result result =
        document.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!result) {
        const auto at = static_cast<std::uint32_t>(
            std::clamp<std::ptrdiff_t>(result.offset, 0, static_cast<std::ptrdiff_t>(text.size())));
        report(diag::LanguageXml, {file_, at, at + 1}).arg(result.description());
        return std::nullopt;
    }
    const pugi::xml_node root = document.document_element();
    if (std::string_view(root.name()) != "language") {
        report(diag::LanguageElement, place(root)).arg(root.name()).arg("language");
        return std::nullopt;
    }
    table_.name = root.attribute("name").value();
    if (table_.name.empty()) report(diag::LanguageAttribute, place(root)).arg("name");
    for (const pugi::xml_node& node : root.children()) {
        if (node.type() == pugi::node_element) element(node);
    }
    require_all();
    if (!is_good_) return std::nullopt;
    return std::move(table_);
}

void Loader::element(const pugi::xml_node& node) {
    if (std::string_view(node.name()) != "keyword") {
        report(diag::LanguageElement, place(node)).arg(node.name()).arg("keyword");
        return;
    }
    const std::string name = node.attribute("name").value();
    const std::string spelled = node.attribute("lexeme").value();
    for (const pugi::xml_attribute& attribute : node.attributes()) {
        const std::string_view found = attribute.name();
        if (found == "name" || found == "lexeme") continue;
        report(diag::LanguageAttributeUnknown, place(node)).arg(found);
    }
    if (name.empty() || spelled.empty()) {
        report(diag::LanguageAttribute, place(node)).arg(name.empty() ? "name" : "lexeme");
        return;
    }
    lexeme(node, name, spelled);
}

void Loader::lexeme(const pugi::xml_node& node, const std::string& name,
                    const std::string& spelled) {
    if (find_keyword(name) == nullptr) {
        std::vector<std::string_view> names;
        for (const Keyword& keyword : all_keywords()) names.push_back(keyword.name);
        const auto near = nearest_name(name, names.data(), names.size());
        auto message = report(diag::LanguageKeyword, place(node));
        message.arg(name);
        if (near) message.fix("did you mean `" + std::string(*near) + "`?");
        return;
    }
    // Only what the lexer takes for one identifier can be a keyword.
    const bool is_identifier = std::all_of(spelled.begin(), spelled.end(), [](char c) {
        return (c & 0x80) != 0 || c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
               (c >= 'A' && c <= 'Z');
    });
    if (!is_identifier || (spelled[0] >= '0' && spelled[0] <= '9')) {
        report(diag::LanguageLexeme, place(node)).arg(spelled);
        return;
    }
    const auto [entry, is_new] = table_.canonical.emplace(spelled, name);
    if (!is_new) report(diag::LanguageDouble, place(node)).arg(spelled).arg(entry->second);
}

void Loader::require_all() {
    std::string missing;
    for (const Keyword& keyword : all_keywords()) {
        if (!keyword.is_required) continue;
        const bool is_there =
            std::any_of(table_.canonical.begin(), table_.canonical.end(),
                        [&](const auto& entry) { return entry.second == keyword.name; });
        if (is_there) continue;
        if (!missing.empty()) missing += ", ";
        missing += "`" + std::string(keyword.name) + "`";
    }
    if (!missing.empty() && is_good_) report(diag::LanguageMissing, {file_, 0, 1}).arg(missing);
}

}  // namespace

std::optional<KeywordTable> load_keywords(const std::string& name_or_file,
                                          const std::vector<std::string>& folders, Sources& sources,
                                          DiagnosticSink& sink) {
    std::vector<std::string> candidates;
    const bool is_file =
        name_or_file.find('/') != std::string::npos || name_or_file.ends_with(".xml");
    if (is_file) candidates.push_back(name_or_file);
    for (const std::string& folder : folders) {
        if (!is_file) candidates.push_back(folder + "/" + name_or_file + ".xml");
    }
    for (const std::string& candidate : candidates) {
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(candidate, ignored)) continue;
        const std::optional<FileId> file = sources.read(candidate);
        if (file) return Loader(sources, *file, sink).load();
    }
    auto message = sink.report(diag::LanguageUnknown);
    message.arg(name_or_file);
    std::vector<std::string> known;
    for (const std::string& folder : folders) {
        std::error_code error;
        for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
             entry.increment(error)) {
            if (entry->path().extension() == ".xml") known.push_back(entry->path().stem().string());
        }
    }
    std::sort(known.begin(), known.end());
    std::string names;
    for (const std::string& name : known) names += (names.empty() ? "`" : ", `") + name + '`';
    if (!known.empty()) message.note("known are " + names);
    return std::nullopt;
}

}  // namespace kadr::syntax
