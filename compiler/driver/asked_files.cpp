#include "driver/asked_files.h"

namespace kadr::driver {

namespace {

FileAnswer::Content content_of(const Result<std::string, ReadFault>& text) {
    return text ? FileAnswer::Content(*text) : std::nullopt;
}

/// Asks again what was asked before.
struct SameAnswer {
    const std::string& path;
    const Files& files;

    bool operator()(FileKind kind) const { return files.kind_of(path) == kind; }
    bool operator()(const FileAnswer::Content& content) const {
        return content_of(files.read(path)) == content;
    }
    bool operator()(const std::vector<FolderEntry>& entries) const {
        return files.list(path) == entries;
    }
};

}  // namespace

bool is_still_so(const FileAnswer& answer, const Files& files) {
    return std::visit(SameAnswer{answer.path, files}, answer.answer);
}

FileKind AskedFiles::kind_of(const std::string& path) const {
    const FileKind kind = below().kind_of(path);
    answers_.push_back({path, kind});
    return kind;
}

std::vector<FolderEntry> AskedFiles::list(const std::string& folder) const {
    std::vector<FolderEntry> entries = below().list(folder);
    answers_.push_back({folder, entries});
    return entries;
}

Result<std::string, ReadFault> AskedFiles::read(const std::string& path,
                                                std::uint64_t most_bytes) const {
    auto text = below().read(path, most_bytes);
    answers_.push_back({path, content_of(text)});
    return text;
}

}  // namespace kadr::driver
