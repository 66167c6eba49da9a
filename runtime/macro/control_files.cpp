#include "macro/control_files.h"

#include <algorithm>
#include <cmath>

namespace kadr::macro {

namespace {

constexpr std::size_t kOfLine = 32;  // bytes that a line takes besides its text

}  // namespace

bool ControlFiles::has(const std::string& name) const {
    const auto found = files_.find(name);
    return found != files_.end() && found->second.has_value();
}

ControlFiles::Error ControlFiles::write(const std::string& name, std::string_view line) {
    if (bytes_ + line.size() + kOfLine > kMostBytes) return Error::FileFull;
    std::optional<Lines>& file = files_[name];
    if (!file) file.emplace();
    file->emplace_back(line);
    bytes_ += line.size() + kOfLine;
    return Error::None;
}

ControlFiles::Error ControlFiles::remove(const std::string& name) {
    if (!has(name)) return Error::FileMissing;
    for (const std::string& line : *files_[name]) bytes_ -= std::min(bytes_, line.size() + kOfLine);
    files_[name].reset();
    return Error::None;
}

ControlFiles::Error ControlFiles::read(const std::string& name, double first, double count,
                                       Lines& out) const {
    if (!has(name)) return Error::FileMissing;
    const Lines& lines = *files_.at(name);
    const auto size = static_cast<double>(lines.size());
    const double from = first == 0 ? std::max(0.0, size - count) : first - 1;
    if (!(count >= 1) || !(from >= 0) || from >= size) return Error::LineMissing;
    const double end = std::min(size, from + count);
    out.assign(lines.begin() + static_cast<std::ptrdiff_t>(from),
               lines.begin() + static_cast<std::ptrdiff_t>(end));
    return end - from < count ? Error::TooManyLines : Error::None;
}

}  // namespace kadr::macro
