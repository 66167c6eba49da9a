// page.h — the page that plays a machine: a template with the data of a run put in.
//
// The template, markup, style and program in one file, is bundled from web/ when Kadr is built;
// web/README.md tells what the data mean.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plot/page_trace.h"

namespace kadr::plot {

/// The texts that a page shows beside the machine, in bounded memory.
class PageTexts {
  public:
    struct Text {
        std::string name;
        bool is_kadr = false;
        std::string text;
        bool is_cut = false;  // more was there than a page holds
    };

    /// The text of this name, empty at first.
    std::int32_t index_of(std::string_view name, bool is_kadr);
    /// Adds to a text what still has room.
    void append(std::int32_t index, std::string_view piece);

    const std::vector<Text>& all() const { return texts_; }

  private:
    std::vector<Text> texts_;
    std::size_t room_ = 2'500'000;  // bytes, of all of them
};

struct PageHead {
    std::string title;     // "blade.mpf"
    std::string subtitle;  // "SINUMERIK 840D sl · trunnion table · 34.2 s"
    std::string warning;   // "not complete, ended by …"; empty: none
};

/// How many samples and blocks a page of this machine has room for: together with its texts and the
/// template it stays below 10 MB.
std::size_t most_page_samples(const machine::Machine& machine);
std::size_t most_page_blocks();

/// What a template lacks into which a page is put; nothing: it is one.
std::optional<std::string_view> missing_in_template(std::string_view page);

/// The page.
///
/// page  a template that lacks nothing
std::string page_html(std::string_view page, const PageHead& head, const PageTrace& trace,
                      const PageTexts& texts);

}  // namespace kadr::plot
