// dialect_search.h — where the files of dialects are looked for. For the rooms of nc only.
#pragma once

#include <optional>
#include <string>

#include "base/xml.h"
#include "nc/dialect.h"

namespace kadr::nc {

/// Whether it names a file, `my/fanuc.xml`, and no dialect of the search path.
bool is_dialect_file(const std::string& name);
/// The file of a dialect; nothing: there is none.
std::optional<std::string> find_dialect_file(const std::string& name, const SearchPath& folders,
                                             const Files& files);
/// The search path for a dialect and those that it extends: what a file extends may lie beside it.
SearchPath search_path_of(const std::string& name_or_file, const SearchPath& folders);
/// What a file extends, as `find_dialect_file` takes it: one that is named by its path lies where
/// the file does that extends it.
///
/// extends  the attribute of the file `path`
std::string extended_name(const XmlAttribute& extends, const std::string& path);

}  // namespace kadr::nc
