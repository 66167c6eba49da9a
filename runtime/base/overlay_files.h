// overlay_files.h — files of another store, and texts over them that nobody has saved yet.
#pragma once

#include <map>
#include <mutex>

#include "base/forwarded_files.h"

namespace kadr {

/// An editor's texts are read instead of the files that they will become. What is written goes
/// through to the store below. Threads may share it.
class OverlayFiles final : public ForwardedFiles {
  public:
    using ForwardedFiles::ForwardedFiles;

    /// What an editor shows at this path, from now on; the file need not exist.
    void put(const std::string& path, std::string text);
    /// It is closed: the file is what it was.
    void remove(const std::string& path);

    FileKind kind_of(const std::string& path) const override;
    std::vector<FolderEntry> list(const std::string& folder) const override;
    Result<std::string, ReadFault> read(const std::string& path,
                                        std::uint64_t most_bytes) const override;
    std::unique_ptr<FileReader> open(const std::string& path) const override;
    std::string why_unreadable(const std::string& path) const override;

  private:
    using Text = std::shared_ptr<const std::string>;

    /// The text over this path; null: none.
    Text find(const std::string& path) const;

    mutable std::mutex mutex_;
    std::map<std::string, Text> texts_;  // by real path
};

}  // namespace kadr
