#include "base/overlay_files.h"

#include <algorithm>
#include <filesystem>

#include "base/memory_files.h"

namespace kadr {

void OverlayFiles::put(const std::string& path, std::string text) {
    auto kept = std::make_shared<const std::string>(std::move(text));
    const std::string real = below().real_path(path);
    const std::lock_guard lock(mutex_);
    texts_[real] = std::move(kept);
}

void OverlayFiles::remove(const std::string& path) {
    const std::string real = below().real_path(path);
    const std::lock_guard lock(mutex_);
    texts_.erase(real);
}

OverlayFiles::Text OverlayFiles::find(const std::string& path) const {
    if (path == "-") return nullptr;
    {
        const std::lock_guard lock(mutex_);
        if (texts_.empty()) return nullptr;
    }
    const std::string real = below().real_path(path);
    const std::lock_guard lock(mutex_);
    const auto found = texts_.find(real);
    return found == texts_.end() ? nullptr : found->second;
}

FileKind OverlayFiles::kind_of(const std::string& path) const {
    return find(path) != nullptr ? FileKind::File : below().kind_of(path);
}

std::vector<FolderEntry> OverlayFiles::list(const std::string& folder) const {
    std::vector<FolderEntry> entries = below().list(folder);
    const std::string real = below().real_path(folder.empty() ? "." : folder);
    const std::lock_guard lock(mutex_);
    for (const auto& [path, text] : texts_) {
        const std::filesystem::path file(path);
        if (file.parent_path() != real) continue;
        const std::string name = file.filename().string();
        if (std::ranges::find(entries, name, &FolderEntry::name) == entries.end())
            entries.push_back({name, FileKind::File});
    }
    std::ranges::sort(entries, {}, &FolderEntry::name);
    return entries;
}

Result<std::string, ReadFault> OverlayFiles::read(const std::string& path,
                                                  std::uint64_t most_bytes) const {
    const Text text = find(path);
    if (text == nullptr) return below().read(path, most_bytes);
    if (text->size() > most_bytes) return ReadFault{ReadFault::Kind::TooLarge, {}};
    return std::string(*text);
}

std::unique_ptr<FileReader> OverlayFiles::open(const std::string& path) const {
    Text text = find(path);
    if (text == nullptr) return below().open(path);
    return std::make_unique<MemoryReader>(std::move(text));
}

std::string OverlayFiles::why_unreadable(const std::string& path) const {
    return find(path) != nullptr ? std::string() : below().why_unreadable(path);
}

}  // namespace kadr
