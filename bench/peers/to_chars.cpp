// The blocks by std::to_chars: exact, byte for byte as printf, and what `kadr expand` is held
// against. Half of this program's speed is the budget, 80 % the aim.
//
//   bench_to_chars [BLOCKS [repeat|flat]]
//
// repeat: G1 in every block, not in the first alone. flat: so, and block numbers begin again after
// a million, because controls take eight digits; input for the readers.
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "points.h"

namespace {

/// ` X12.5`: three decimals at most, no zeros behind the last digit that counts.
char* write_word(char* out, char letter, double value) {
    *out++ = ' ';
    *out++ = letter;
    char* const begin = out;
    out = std::to_chars(out, out + 64, value, std::chars_format::fixed, 3).ptr;
    while (out[-1] == '0') --out;
    if (out[-1] == '.') --out;
    if (out == begin + 2 && begin[0] == '-' && begin[1] == '0') {
        begin[0] = '0';
        --out;
    }
    return out;
}

}  // namespace

int main(int argc, char** argv) {
    const long blocks = argc > 1 ? std::atol(argv[1]) : 1'000'000;
    const bool is_flat = argc > 2 && std::strcmp(argv[2], "flat") == 0;
    const bool repeats_g1 = is_flat || (argc > 2 && std::strcmp(argv[2], "repeat") == 0);
    std::vector<char> buffer(1 << 16);
    char* const flush_at = buffer.data() + buffer.size() - 512;
    char* out = buffer.data();
    std::fputs("N10 G90\n", stdout);
    for (long i = 0; i < blocks; ++i) {
        const Point p = point(i);
        *out++ = 'N';
        out = std::to_chars(out, out + 32, 10 * ((is_flat ? i % 1'000'000 : i) + 2)).ptr;
        if (i == 0 || repeats_g1) {
            std::memcpy(out, " G1", 3);
            out += 3;
        }
        out = write_word(out, 'X', p.x);
        out = write_word(out, 'Y', p.y);
        out = write_word(out, 'Z', p.z);
        *out++ = '\n';
        if (out > flush_at) {
            std::fwrite(buffer.data(), 1, static_cast<std::size_t>(out - buffer.data()), stdout);
            out = buffer.data();
        }
    }
    std::fwrite(buffer.data(), 1, static_cast<std::size_t>(out - buffer.data()), stdout);
}
