// Writes random programs with fixed seeds, in the three languages in turn, for scripts/same:
//   random_programs FOLDER COUNT
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <string>

#include <rapidcheck.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/control/random_program.h"

namespace {

namespace fs = std::filesystem;
using namespace kadr::control_testing;

struct Form {
    Language language;
    const char* folder;  // tells scripts/programs.py the control
    const char* suffix;
};
constexpr Form kForms[] = {{Language::Fanuc, "fanuc", ".nc"},
                           {Language::Sinumerik, "sinumerik", ".mpf"},
                           {Language::Kadr, "kadr", ".kadr"}};

bool write(const fs::path& folder, std::uint64_t seed) {
    const auto program = rc::gen::exec(any_program)(rc::Random(seed), rc::kNominalSize).value();
    const Form& form = kForms[seed % std::size(kForms)];
    const std::string name = "r" + std::to_string(seed) + form.suffix;
    const std::string path = (folder / form.folder / name).string();
    return kadr::write_file_whole(path, text_of(program, form.language));
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 3) {
        std::cerr << "random_programs FOLDER COUNT\n";
        return 2;
    }
    const fs::path folder = arguments[1];
    for (const Form& form : kForms) fs::create_directories(folder / form.folder);
    const auto last = std::stoull(arguments[2]);
    for (std::uint64_t seed = 1; seed <= last; ++seed) {
        if (!write(folder, seed)) return 1;
    }
    return 0;
}
