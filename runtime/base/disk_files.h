// disk_files.h — the files of the disk, with standard input and output.
#pragma once

#include "base/files.h"

namespace kadr {

/// A file grows as a neighbour of its final name and is renamed when it is complete; standard
/// output and special files get everything at the end, spooled until then.
class DiskFiles final : public Files {
  public:
    FileKind kind_of(const std::string& path) const override;
    std::vector<FolderEntry> list(const std::string& folder) const override;
    std::string real_path(const std::string& path) const override;
    std::optional<std::string> link_target(const std::string& path) const override;
    std::optional<Identity> identity_of(const std::string& path) const override;
    Result<std::string, ReadFault> read(const std::string& path,
                                        std::uint64_t most_bytes) const override;
    std::unique_ptr<FileReader> open(const std::string& path) const override;
    std::unique_ptr<FileWriter> create(const std::string& path) override;
    std::string why_unreadable(const std::string& path) const override;
    std::string why_unwritable(const std::string& path) const override;
};

/// The disk has no state of ours: there is one.
Files& disk();

/// The whole file as bytes, or nothing if it cannot be read (missing, a folder, no permission). For
/// tools and tests; who works for a user is handed his files.
std::optional<std::string> read_file(const std::string& path);
/// Writes a file whole or not at all, likewise. False if the folder cannot be written; an existing
/// file is then as it was.
bool write_file_whole(const std::string& path, std::string_view text);

/// Opens what is written to `path`; null if it cannot be. For DiskFiles only.
std::unique_ptr<FileWriter> create_on_disk(const std::string& path);

/// What the system's number of an error means: "there is no space left".
std::string system_fault(int error);

}  // namespace kadr
