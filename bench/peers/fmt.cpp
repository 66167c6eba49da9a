// The blocks by libfmt.
#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>

#include "points.h"

namespace {

/// ` X12.5`: three decimals at most, no zeros behind the last digit that counts.
void write_word(fmt::memory_buffer& out, char letter, double value) {
    const std::size_t begin = out.size() + 2;
    fmt::format_to(std::back_inserter(out), " {}{:.3f}", letter, value);
    std::size_t size = out.size();
    while (out[size - 1] == '0') --size;
    if (out[size - 1] == '.') --size;
    if (size == begin + 2 && out[begin] == '-' && out[begin + 1] == '0') {
        out[begin] = '0';
        --size;
    }
    out.resize(size);
}

}  // namespace

int main(int argc, char** argv) {
    const long blocks = argc > 1 ? std::atol(argv[1]) : 1'000'000;
    fmt::memory_buffer out;
    std::fputs("N10 G90\n", stdout);
    for (long i = 0; i < blocks; ++i) {
        const Point p = point(i);
        fmt::format_to(std::back_inserter(out), "N{}{}", 10 * (i + 2), i == 0 ? " G1" : "");
        write_word(out, 'X', p.x);
        write_word(out, 'Y', p.y);
        write_word(out, 'Z', p.z);
        out.push_back('\n');
        if (out.size() > (1 << 16) - 512) {
            std::fwrite(out.data(), 1, out.size(), stdout);
            out.clear();
        }
    }
    std::fwrite(out.data(), 1, out.size(), stdout);
}
