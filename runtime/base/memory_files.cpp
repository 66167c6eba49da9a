#include "base/memory_files.h"

#include <algorithm>
#include <filesystem>
#include <functional>

namespace kadr {

namespace {

constexpr const char* kStandard = "-";
constexpr const char* kNoFile = "there is no such file";
constexpr const char* kIsFolder = "it is a folder";

/// What all paths below a folder begin with.
std::string front_of(const std::string& folder) {
    std::string front = path_from_root(folder);
    if (!front.ends_with('/')) front += '/';
    return front;
}

}  // namespace

/// What is written is in nobody's way until it is complete.
class MemoryFiles::Writer final : public FileWriter {
  public:
    Writer(MemoryFiles& files, std::string path) : files_(files), path_(std::move(path)) {}

    void write(std::string_view text) override { text_ += text; }
    void overwrite(std::size_t at, std::string_view text) override {
        text_.replace(at, text.size(), text);
    }
    bool commit() override {
        if (path_ != kStandard) {
            files_.put(path_, std::move(text_));
            return true;
        }
        const std::lock_guard lock(files_.mutex_);
        files_.output_ += text_;
        return true;
    }
    std::string fault() const override { return {}; }

  private:
    MemoryFiles& files_;
    std::string path_;
    std::string text_;
};

std::string path_from_root(const std::string& path) {
    std::string real = (std::filesystem::path("/") / path).lexically_normal().string();
    while (real.size() > 1 && real.ends_with('/')) real.pop_back();
    return real;
}

std::size_t MemoryReader::read(std::span<char> piece) {
    const std::size_t count = std::min(piece.size(), text_->size() - at_);
    std::copy_n(text_->data() + at_, count, piece.data());
    at_ += count;
    return count;
}

bool MemoryReader::seek(std::uint64_t offset) {
    at_ = static_cast<std::size_t>(std::min<std::uint64_t>(offset, text_->size()));
    return true;
}

void MemoryFiles::put(const std::string& path, std::string text) {
    auto kept = std::make_shared<const std::string>(std::move(text));
    const std::lock_guard lock(mutex_);
    texts_[path == kStandard ? path : path_from_root(path)] = std::move(kept);
}

void MemoryFiles::remove(const std::string& path) {
    const std::lock_guard lock(mutex_);
    texts_.erase(path == kStandard ? path : path_from_root(path));
}

std::string MemoryFiles::output() const {
    const std::lock_guard lock(mutex_);
    return output_;
}

MemoryFiles::Text MemoryFiles::find(const std::string& path) const {
    const std::lock_guard lock(mutex_);
    const auto found = texts_.find(path == kStandard ? path : path_from_root(path));
    return found == texts_.end() ? nullptr : found->second;
}

FileKind MemoryFiles::kind_of(const std::string& path) const {
    if (find(path) != nullptr) return FileKind::File;
    const std::string front = front_of(path);
    const std::lock_guard lock(mutex_);
    const auto below = texts_.lower_bound(front);
    const bool is_folder = below != texts_.end() && below->first.starts_with(front);
    return is_folder ? FileKind::Folder : FileKind::Missing;
}

std::vector<FolderEntry> MemoryFiles::list(const std::string& folder) const {
    const std::string front = front_of(folder);
    std::vector<FolderEntry> entries;
    const std::lock_guard lock(mutex_);
    for (auto at = texts_.lower_bound(front); at != texts_.end(); ++at) {
        if (!at->first.starts_with(front)) break;
        const std::string_view name = std::string_view(at->first).substr(front.size());
        const std::size_t slash = name.find('/');
        const FileKind kind = slash == name.npos ? FileKind::File : FileKind::Folder;
        FolderEntry entry{std::string(name.substr(0, slash)), kind};
        if (entries.empty() || entries.back().name != entry.name)
            entries.push_back(std::move(entry));
    }
    std::ranges::sort(entries, {}, &FolderEntry::name);
    return entries;
}

std::string MemoryFiles::real_path(const std::string& path) const { return path_from_root(path); }

std::optional<Files::Identity> MemoryFiles::identity_of(const std::string& path) const {
    if (path == kStandard || find(path) == nullptr) return std::nullopt;
    return Identity{0, std::hash<std::string>{}(path_from_root(path))};
}

Result<std::string, ReadFault> MemoryFiles::read(const std::string& path,
                                                 std::uint64_t most_bytes) const {
    const Text text = find(path);
    if (text == nullptr) return ReadFault{ReadFault::Kind::Unreadable, why_unreadable(path)};
    if (text->size() > most_bytes) return ReadFault{ReadFault::Kind::TooLarge, {}};
    return std::string(*text);
}

std::unique_ptr<FileReader> MemoryFiles::open(const std::string& path) const {
    Text text = find(path);
    return text == nullptr ? nullptr : std::make_unique<MemoryReader>(std::move(text));
}

std::unique_ptr<FileWriter> MemoryFiles::create(const std::string& path) {
    if (is_folder(path)) return nullptr;
    return std::make_unique<Writer>(*this, path);
}

std::string MemoryFiles::why_unreadable(const std::string& path) const {
    switch (kind_of(path)) {
        case FileKind::Missing: return kNoFile;
        case FileKind::Folder: return kIsFolder;
        case FileKind::File:
        case FileKind::Special: break;
    }
    return {};
}

std::string MemoryFiles::why_unwritable(const std::string& path) const {
    return is_folder(path) ? kIsFolder : std::string();
}

}  // namespace kadr
