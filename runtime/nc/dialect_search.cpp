#include "nc/dialect_search.h"

#include <filesystem>

namespace kadr::nc {

namespace fs = std::filesystem;

bool is_dialect_file(const std::string& name) {
    return name.find('/') != std::string::npos || name.ends_with(".xml");
}

std::optional<std::string> find_dialect_file(const std::string& name, const SearchPath& folders,
                                             const Files& files) {
    if (is_dialect_file(name)) {
        if (files.is_file(name)) return name;
        return std::nullopt;
    }
    for (const std::string& folder : folders) {
        std::string path = (fs::path(folder) / (name + ".xml")).string();
        if (files.is_file(path)) return path;
    }
    return std::nullopt;
}

SearchPath search_path_of(const std::string& name_or_file, const SearchPath& folders) {
    SearchPath with_own = folders;
    if (is_dialect_file(name_or_file)) {
        const fs::path folder = fs::path(name_or_file).parent_path();
        with_own.insert(with_own.begin(), folder.empty() ? "." : folder.string());
    }
    return with_own;
}

std::string extended_name(const XmlAttribute& extends, const std::string& path) {
    if (!is_dialect_file(extends.value)) return extends.value;
    return (fs::path(path).parent_path() / extends.value).string();
}

}  // namespace kadr::nc
