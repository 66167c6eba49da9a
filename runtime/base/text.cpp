#include "base/text.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <vector>

#include <unistd.h>

namespace kadr {

std::size_t count_code_points(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    }));
}

std::string_view code_points(std::string_view text, std::size_t from, std::size_t count) {
    const auto past = [](std::string_view rest, std::size_t points) {
        std::size_t at = 0;
        for (; points > 0 && at < rest.size(); --points) {
            do ++at;
            while (at < rest.size() && (static_cast<unsigned char>(rest[at]) & 0xC0) == 0x80);
        }
        return at;
    };
    text.remove_prefix(past(text, from));
    return text.substr(0, past(text, count));
}

std::optional<std::string> read_file(const std::string& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) return std::nullopt;
    std::ifstream in(path, std::ios::binary);
    if (!in) return std::nullopt;
    // In pieces: what is read may be no file with a size.
    std::string text;
    constexpr std::size_t kPiece = std::size_t{1} << 16;
    while (in) {
        const std::size_t before = text.size();
        text.resize(before + kPiece);
        in.read(text.data() + before, kPiece);
        text.resize(before + static_cast<std::size_t>(in.gcount()));
    }
    if (in.bad()) return std::nullopt;
    return text;
}

bool write_file_whole(const std::string& path, std::string_view text) {
    const std::string draft = path + ".kadr-" + std::to_string(::getpid()) + "~";
    std::FILE* out = std::fopen(draft.c_str(), "wb");
    if (out == nullptr) return false;
    const bool written = std::fwrite(text.data(), 1, text.size(), out) == text.size();
    const bool closed = std::fclose(out) == 0;
    std::error_code error;
    if (written && closed) {
        std::filesystem::rename(draft, path, error);
        if (!error) return true;
    }
    std::filesystem::remove(draft, error);
    return false;
}

namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
        }
    }
    return row.back();
}

}  // namespace

std::optional<std::string_view> nearest_name(std::string_view wrong,
                                             const std::string_view* candidates,
                                             std::size_t count) {
    // A third of the letters may differ; beyond that a proposal misleads more than it helps.
    std::size_t best = std::max<std::size_t>(1, (wrong.size() + 1) / 3) + 1;
    std::optional<std::string_view> nearest;
    for (std::size_t i = 0; i < count; ++i) {
        if (upper_ascii(candidates[i]) == upper_ascii(wrong)) return candidates[i];
        const std::size_t distance = edit_distance(wrong, candidates[i]);
        if (distance < best) {
            best = distance;
            nearest = candidates[i];
        }
    }
    return nearest;
}

std::string upper_ascii(std::string_view text) {
    std::string upper(text);
    for (char& c : upper) {
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    }
    return upper;
}

}  // namespace kadr
