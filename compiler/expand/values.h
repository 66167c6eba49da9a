// values.h — values on the heap that instructions make. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// Frees what no register of the calls reaches; `registers` are those of the innermost one.
void collect_garbage(Running& run, const Slot* registers);
/// The characters of a text as an array.
std::int64_t split_text(Running& run, std::int64_t text, std::uint32_t layout);
/// The rows of a table as an array.
std::int64_t make_table(Running& run, const sema::TableSchema& schema, const sema::TableRows& rows);
/// An array of so many elements without a value.
std::int64_t make_fixed(Running& run, std::uint32_t layout, std::int64_t count);
/// A picture in the registers from `image`.
void make_image(Running& run, const sema::PictureSource& source, const sema::Picture& picture,
                Slot* image);
/// Reads a picture that a name chooses while the program runs.
Done read_image(Running& run, const sema::PictureSource& source, Slot path, std::uint32_t at,
                Slot* image);
/// Reads a table that a name chooses while the program runs.
Done read_table(Running& run, const sema::TableSchema& schema, Slot path, std::uint32_t at,
                Slot& table);

}  // namespace kadr::expand
