// share.h — where Kadr's own files are: dialects, keyword languages, machines, standard library,
// the template of pages.
#pragma once

#include <string>
#include <vector>

#include "base/files.h"

namespace kadr::driver {

/// Folders by what is looked for in them, first match wins.
struct Share {
    std::vector<std::string> dialects;
    std::vector<std::string> languages;
    std::vector<std::string> machines;
    std::string library;        // the standard library
    std::string page_template;  // of the page that plays a machine
};

/// Finds the shared files: the folder that the environment's KADR_SHARE names, else the one that
/// was installed beside the program, else the tree that the program was built from.
Share find_share(const Files& files);

/// The layout below one root, installed (`machines`) or a source tree (`runtime/machines`).
Share share_below(const std::string& root, const Files& files);

}  // namespace kadr::driver
