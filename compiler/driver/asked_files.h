// asked_files.h — files that remember what they were asked: whether all answers are still the same
// tells whether what was made from them still holds.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/forwarded_files.h"

namespace kadr::driver {

/// A question to a store of files, and what it answered.
struct FileAnswer {
    using Content =
        std::optional<std::string>;  // of a file that was read; nothing: it could not be
    std::string path;
    std::variant<FileKind, Content, std::vector<FolderEntry>> answer;
};

/// Whether the store would answer the same.
bool is_still_so(const FileAnswer& answer, const Files& files);

/// Reads from another store. Loaders that make something which is kept read from this.
class AskedFiles final : public ForwardedFiles {
  public:
    using ForwardedFiles::ForwardedFiles;

    /// What was asked since the last call.
    std::vector<FileAnswer> take_answers() { return std::exchange(answers_, {}); }

    FileKind kind_of(const std::string& path) const override;
    std::vector<FolderEntry> list(const std::string& folder) const override;
    Result<std::string, ReadFault> read(const std::string& path,
                                        std::uint64_t most_bytes) const override;

  private:
    mutable std::vector<FileAnswer> answers_;
};

}  // namespace kadr::driver
