// keywords.cpp — dialects/languages/*.xml → KeywordTable. The only place that reads these files.
#include <algorithm>
#include <filesystem>

#include "base/diagnostics/syntax.h"
#include "base/identifier.h"
#include "base/text.h"
#include "base/xml.h"
#include "syntax/keyword.h"
#include "syntax/parse.h"

namespace kadr::syntax {

namespace {

/// What a file with keywords may hold.
const XmlShape& language_shape() {
    constexpr auto Filled = XmlAttributeRule::Use::Filled;
    static const std::vector<XmlRule> rules = {
        {"language", {{"name", Filled}, "title"}, {"keyword"}},
        {"keyword", {{"name", Filled}, {"lexeme", Filled}}, {}},
    };
    static const XmlShape shape = {"a file with keywords", rules};
    return shape;
}

class Loader {
  public:
    Loader(Sources& sources, FileId file, DiagnosticSink& sink)
        : sources_(sources), file_(file), sink_(sink) {}

    std::optional<KeywordTable> load();

  private:
    void keyword(const XmlAttribute& name, const XmlAttribute& lexeme);
    void require_all(const XmlElement& root);
    DiagnosticBuilder report(const DiagnosticRow& row, const SourceRange& range) {
        is_good_ = false;
        return sink_.report(row, range);
    }

    Sources& sources_;
    FileId file_;
    DiagnosticSink& sink_;
    KeywordTable table_;
    std::unordered_map<std::string, SourceRange> locations_;  // of the lexemes
    bool is_good_ = true;
};

std::optional<KeywordTable> Loader::load() {
    const auto root = parse_xml(file_, sources_, language_shape(), sink_);
    if (!root || !check_xml(*root, language_shape(), sink_)) return std::nullopt;
    table_.name = root->find("name")->value;
    for (const XmlElement& element : root->children) {
        keyword(*element.find("name"), *element.find("lexeme"));
    }
    require_all(*root);
    if (!is_good_) return std::nullopt;
    return std::move(table_);
}

void Loader::keyword(const XmlAttribute& name, const XmlAttribute& lexeme) {
    if (find_keyword(name.value) == nullptr) {
        std::vector<std::string_view> names;
        for (const Keyword& known : all_keywords()) names.push_back(known.name);
        const auto near = nearest_name(name.value, names.data(), names.size());
        auto message = report(diag::LanguageKeyword, name.value_range);
        message.arg(shown_value(name.value));
        if (near) message.fix(name.value_range, std::string(*near), "is this meant?");
        return;
    }
    const std::string& spelled = lexeme.value;
    // Only what the lexer takes for one identifier can be a keyword.
    const bool is_identifier = std::ranges::all_of(spelled, is_name_part);
    if (!is_identifier || (spelled[0] >= '0' && spelled[0] <= '9')) {
        report(diag::LanguageLexeme, lexeme.value_range).arg(shown_value(spelled));
        return;
    }
    const auto [entry, is_new] = table_.canonical.emplace(spelled, name.value);
    if (is_new) {
        locations_.emplace(spelled, lexeme.value_range);
        return;
    }
    report(diag::LanguageDouble, lexeme.value_range)
        .arg(spelled)
        .arg(entry->second)
        .note(locations_.at(spelled), "the first one");
}

void Loader::require_all(const XmlElement& root) {
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
    if (!missing.empty() && is_good_) report(diag::LanguageMissing, root.range).arg(missing);
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
        if (!sources.files().is_file(candidate)) continue;
        const std::optional<FileId> file = sources.read(candidate);
        if (file) return Loader(sources, *file, sink).load();
    }
    auto message = sink.report(diag::LanguageUnknown);
    message.arg(name_or_file);
    std::vector<std::string> known;
    for (const std::string& folder : folders) {
        for (const FolderEntry& entry : sources.files().list(folder)) {
            const std::filesystem::path name = entry.name;
            if (name.extension() == ".xml") known.push_back(name.stem().string());
        }
    }
    std::sort(known.begin(), known.end());
    std::string names;
    for (const std::string& name : known) names += (names.empty() ? "`" : ", `") + name + '`';
    if (!known.empty()) message.note("known are " + names);
    return std::nullopt;
}

}  // namespace kadr::syntax
