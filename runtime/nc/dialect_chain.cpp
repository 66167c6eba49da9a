#include "nc/dialect_chain.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "base/discarding_sink.h"
#include "nc/dialect_search.h"
#include "nc/load.h"

namespace kadr::nc {

namespace {

using Kind = ChainEntry::Kind;

/// How an element names what it defines.
struct NamedElement {
    std::string_view element;
    std::string_view attribute;  // empty: by its text
    Kind kind;
    bool has_words;  // each word of the attribute is one
};

constexpr std::array kOfDialect = {
    NamedElement{"address", "name", Kind::Address, false},
    NamedElement{"rule", "name", Kind::Rule, false},
    NamedElement{"alarm", "for", Kind::Alarm, false},
    NamedElement{"unsupported", "words", Kind::Unsupported, true},
    NamedElement{"foreign", "words", Kind::Foreign, true},
    NamedElement{"passed", "words", Kind::Passed, true},
};
constexpr std::array kOfLanguage = {
    NamedElement{"rule", "name", Kind::LanguageRule, false},
    NamedElement{"operator", "text", Kind::Operator, false},
    NamedElement{"function", "form", Kind::Function, false},
    NamedElement{"variable", "form", Kind::Variable, false},
    NamedElement{"statement", "", Kind::Statement, false},
    NamedElement{"call", "code", Kind::Call, false},
    NamedElement{"argument", "address", Kind::Argument, false},
    NamedElement{"type", "name", Kind::Type, false},
};

/// The entries of one file, in its order.
class FileEntries {
  public:
    FileEntries(std::size_t file, DialectChain& out) : file_(file), out_(out) {}

    void take(const XmlElement& root) {
        for (const XmlElement& element : root.children) {
            take_named(element, kOfDialect);
            if (element.name == "language")
                for (const XmlElement& child : element.children) take_named(child, kOfLanguage);
            if (element.name == "group")
                for (const XmlElement& code : element.children) take_code(code);
            if (element.name == "command" || element.name == "cycle") take_forms(element);
            if (element.name == "remove") take_removed(element);
        }
    }
    /// Functions and cycles that this file spells anew, or takes away.
    const std::set<std::string>& spelled() const { return spelled_; }
    /// Addresses that it takes away.
    const std::set<std::string>& removed() const { return removed_; }

  private:
    template <std::size_t n>
    void take_named(const XmlElement& element, const std::array<NamedElement, n>& rows) {
        const auto row = std::ranges::find(rows, element.name, &NamedElement::element);
        if (row == rows.end()) return;
        if (row->attribute.empty()) return add(row->kind, element.text, element.text_range);
        const XmlAttribute* const attribute = element.find(row->attribute);
        if (attribute == nullptr) return;
        if (!row->has_words) return add(row->kind, attribute->value, attribute->value_range);
        for (const XmlWord& word : words_of(*attribute)) add(row->kind, word.text, word.range);
    }

    void take_code(const XmlElement& code) {
        const XmlAttribute* const text = code.find("text");
        const XmlAttribute* const command = code.find("command");
        if (text == nullptr || command == nullptr) return;
        spelled_.insert(command->value);
        add_word(text->value, text->value_range, command->value);
    }

    void take_forms(const XmlElement& element) {
        const XmlAttribute* const name = element.find("name");
        if (name == nullptr) return;
        spelled_.insert(name->value);
        for (const XmlElement& form : element.children)
            if (form.name == "form") add_word(form.text, form.text_range, name->value);
    }

    static void add_words(const XmlElement& element, std::string_view name,
                          std::set<std::string>& out) {
        const XmlAttribute* const words = element.find(name);
        if (words == nullptr) return;
        for (const XmlWord& word : words_of(*words)) out.insert(word.text);
    }

    void take_removed(const XmlElement& element) {
        for (const char* const what : {"commands", "cycles"}) add_words(element, what, spelled_);
        add_words(element, "addresses", removed_);
    }

    /// The word in front of a spelling, up to a blank, a bracket or a hole; a hole alone is none.
    void add_word(const std::string& spelling, SourceRange range, const std::string& of) {
        const std::size_t end = std::min(spelling.find_first_of(" \t\r\n({=["), spelling.size());
        if (end == 0) return;
        range.end = std::min(range.end, range.begin + static_cast<std::uint32_t>(end));
        add(Kind::Word, spelling.substr(0, end), range);
        out_.entries.back().of = of;
    }

    void add(Kind kind, std::string name, const SourceRange& range) {
        out_.entries.push_back({kind, std::move(name), {}, range, file_, true});
    }

    std::size_t file_;
    DialectChain& out_;
    std::set<std::string> spelled_;
    std::set<std::string> removed_;
};

/// What a file replaces of those that it extends.
void hide_replaced(DialectChain& chain, const std::vector<FileEntries>& files) {
    // The last one of a name in a file acts, and the nearest file; words act with what they spell.
    std::map<std::pair<Kind, std::string_view>, std::size_t> acting;
    for (std::size_t i = 0; i < chain.entries.size(); ++i) {
        ChainEntry& entry = chain.entries[i];
        const auto hides = [&](const FileEntries& nearer) {
            return entry.kind == Kind::Word      ? nearer.spelled().contains(entry.of)
                   : entry.kind == Kind::Address ? nearer.removed().contains(entry.name)
                                                 : false;
        };
        const auto first = files.begin();
        entry.acts = std::none_of(first, first + static_cast<std::ptrdiff_t>(entry.file), hides);
        // What files say of an address adds up.
        if (entry.kind == Kind::Word || entry.kind == Kind::Address) continue;
        const auto [known, is_new] =
            acting.emplace(std::pair(entry.kind, std::string_view(entry.name)), i);
        if (is_new) continue;
        ChainEntry& other = chain.entries[known->second];
        if (other.file != entry.file) {
            entry.acts = false;
            continue;
        }
        other.acts = false;
        known->second = i;
    }
}

}  // namespace

namespace {

/// Follows `extends` as far as files can be read.
void read_files(const std::string& name_or_file, const SearchPath& folders, Sources& sources,
                DialectChain& chain, std::vector<FileEntries>& entries) {
    DiscardingSink nobody;
    std::set<std::string> seen;
    std::optional<std::string> next = name_or_file;
    while (next) {
        const auto path = find_dialect_file(*next, folders, sources.files());
        if (!path) return;
        const std::string real = sources.files().real_path(*path);
        if (!seen.insert(real.empty() ? *path : real).second) return;  // it extends itself
        const auto file = sources.read(*path);
        const auto root = file ? parse_xml(*file, sources, dialect_shape(), nobody) : std::nullopt;
        if (!root) return;
        const XmlAttribute* const name = root->find("name");
        const XmlAttribute* const extends = root->find("extends");
        chain.files.push_back({*file, *path, name != nullptr ? name->value : std::string(),
                               extends != nullptr ? extends->value_range : SourceRange()});
        entries.emplace_back(chain.files.size() - 1, chain);
        entries.back().take(*root);
        next.reset();
        if (extends != nullptr) next = extended_name(*extends, *path);
    }
    chain.is_whole = true;
}

}  // namespace

DialectChain dialect_chain(const std::string& name_or_file, const SearchPath& folders,
                           Sources& sources) {
    DialectChain chain;
    std::vector<FileEntries> entries;
    read_files(name_or_file, search_path_of(name_or_file, folders), sources, chain, entries);
    hide_replaced(chain, entries);
    return chain;
}

const ChainFile* extended_at(const DialectChain& chain, FileId file, std::uint32_t byte) {
    for (std::size_t i = 0; i + 1 < chain.files.size(); ++i) {
        const SourceRange& range = chain.files[i].extends;
        if (range.file == file && range.begin <= byte && byte <= range.end)
            return &chain.files[i + 1];
    }
    return nullptr;
}

std::vector<const ChainEntry*> entries_of(const DialectChain& chain, ChainEntry::Kind kind,
                                          std::string_view name) {
    std::vector<const ChainEntry*> found;
    for (const ChainEntry& entry : chain.entries)
        if (entry.kind == kind && entry.name == name) found.push_back(&entry);
    std::ranges::stable_sort(
        found, {}, [](const ChainEntry* entry) { return std::tuple(!entry->acts, entry->file); });
    return found;
}

}  // namespace kadr::nc
