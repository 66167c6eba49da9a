#include "base/source.h"

#include <algorithm>
#include <utility>

#include "base/disk_files.h"
#include "base/text.h"

namespace kadr {

Sources::Sources() : Sources(disk()) {}

Sources::Sources(const Files& files, Role role)
    : store_(&files), first_(role == Role::Shared ? kFirstShared : 0) {}

Sources::Sources(const Files& files, const Sources& shared) : store_(&files), shared_(&shared) {}

FileId Sources::add(std::string name, std::string text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
    end_lines_with_feeds(text);
    File file{std::move(name), std::move(text), {0}};
    for (std::size_t i = 0; i < file.text.size(); ++i) {
        if (file.text[i] == '\n') file.line_starts.push_back(static_cast<std::uint32_t>(i + 1));
    }
    files_.push_back(std::move(file));
    return nth(files_.size() - 1);
}

std::optional<FileId> Sources::read(const std::string& path) {
    auto text = store_->read(path);
    if (!text) return std::nullopt;
    return add(path == "-" ? "<stdin>" : path, *std::move(text));
}

void Sources::drop(FileId file) {
    File& dropped = files_.at(file.index - first_);
    dropped = {std::move(dropped.name), {}, {0}};
}

const Sources::File& Sources::at(FileId file) const {
    const bool is_shared = shared_ != nullptr && file.index >= shared_->first_;
    return is_shared ? shared_->at(file) : files_.at(file.index - first_);
}

std::string_view Sources::name(FileId file) const {
    return file.is_valid() ? std::string_view(at(file).name) : std::string_view();
}

std::string_view Sources::text(FileId file) const { return at(file).text; }

std::string_view Sources::text(const SourceRange& range) const {
    const std::string_view all = text(range.file);
    const std::size_t begin = std::min<std::size_t>(range.begin, all.size());
    const std::size_t end = std::clamp<std::size_t>(range.end, begin, all.size());
    return all.substr(begin, end - begin);
}

LineColumn Sources::locate(FileId file, std::uint32_t byte) const {
    const File& f = at(file);
    byte = std::min<std::uint32_t>(byte, static_cast<std::uint32_t>(f.text.size()));
    const auto after = std::upper_bound(f.line_starts.begin(), f.line_starts.end(), byte);
    const auto start = *(after - 1);
    const std::string_view before = std::string_view(f.text).substr(start, byte - start);
    return {static_cast<std::uint32_t>(after - f.line_starts.begin()),
            static_cast<std::uint32_t>(count_code_points(before) + 1)};
}

std::string_view Sources::line_at(FileId file, std::uint32_t byte) const {
    const File& f = at(file);
    byte = std::min<std::uint32_t>(byte, static_cast<std::uint32_t>(f.text.size()));
    const auto start = *(std::upper_bound(f.line_starts.begin(), f.line_starts.end(), byte) - 1);
    std::string_view line = std::string_view(f.text).substr(start);
    line = line.substr(0, line.find('\n'));
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

}  // namespace kadr
