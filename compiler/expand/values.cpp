// Values on the heap that instructions make: texts taken apart, arrays, tables, pictures.
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "base/text.h"
#include "expand/state.h"
#include "sema/csv.h"
#include "sema/picture.h"

namespace kadr::expand {

using sema::SlotKind;

void Expander::State::collect_garbage(const Slot* registers) {
    const std::size_t top =
        static_cast<std::size_t>(registers - stack.data()) + frames.back().function->registers;
    heap.collect(std::span<const Slot>(stack.data(), std::min(top, stack.size())));
}

/// The characters of a text as an array.
std::int64_t Expander::State::split_text(std::int64_t text, std::uint32_t layout) {
    const std::int64_t list = heap.new_array(layout);
    const std::string whole = heap.text(text);
    for (std::string_view rest = whole; !rest.empty() && !heap.gives_up();) {
        const std::string_view character = code_points(rest, 0, 1);
        Slot slot{};
        slot.integer = heap.new_text(std::string(character));
        heap.append(list, &slot);
        rest.remove_prefix(character.size());
    }
    return list;
}

std::int64_t Expander::State::make_table(const sema::TableSchema& schema,
                                         const sema::TableRows& rows) {
    const std::int64_t table = heap.new_array(schema.layout);
    const std::vector<SlotKind>& kinds = code.layouts[schema.layout].slots;
    std::vector<Slot> row(schema.slots);
    for (std::size_t first = 0; first < rows.slots.size() && !heap.gives_up();
         first += schema.slots) {
        for (std::size_t i = 0; i < schema.slots; ++i) {
            row[i] = rows.slots[first + i];
            const bool is_text =
                kinds[i] == SlotKind::Text && row[i].integer != sema::kNotGivenInteger;
            if (is_text) {
                row[i].integer =
                    heap.new_text(rows.texts[static_cast<std::size_t>(row[i].integer)]);
            }
        }
        heap.append(table, row.data());
    }
    return table;
}

std::int64_t Expander::State::make_fixed(std::uint32_t layout, std::int64_t count) {
    const std::int64_t array = heap.new_array(layout);
    std::vector<Slot> element;
    for (const SlotKind kind : code.layouts[layout].slots) {
        Slot slot{};
        if (kind == SlotKind::Number) {
            slot.number = sema::kNotGivenNumber;
        } else {
            slot.integer = sema::kNotGivenInteger;
        }
        element.push_back(slot);
    }
    for (std::int64_t i = 0; i < count && !heap.gives_up(); ++i) heap.append(array, element.data());
    return array;
}

void Expander::State::make_image(const sema::PictureSource& source, const sema::Picture& picture,
                                 Slot* image) {
    const std::int64_t dots = heap.new_array(source.layout);
    for (const double brightness : picture.brightness) {
        if (heap.gives_up()) break;
        Slot dot{};
        dot.number = brightness;
        heap.append(dots, &dot);
    }
    image[source.width].integer = static_cast<std::int64_t>(picture.width);
    image[source.height].integer = static_cast<std::int64_t>(picture.height);
    image[source.dots].integer = dots;
}

Done Expander::State::read_image(const sema::PictureSource& source, Slot path, std::uint32_t at,
                                 Slot* image) {
    const std::optional<sema::Picture> picture = sema::read_picture(
        source.folder, heap.text(path.integer), code.locations[at], options.files, sink);
    if (!picture) {
        has_failed = true;
        is_running = false;
        return kFailed;
    }
    make_image(source, *picture, image);
    return kDone;
}

Done Expander::State::read_table(const sema::TableSchema& schema, Slot path, std::uint32_t at,
                                 Slot& table) {
    const std::optional<sema::TableRows> rows = sema::read_table(
        schema, code.enums, heap.text(path.integer), code.locations[at], options.files, sink);
    if (!rows) {
        has_failed = true;
        is_running = false;
        return kFailed;
    }
    table.integer = make_table(schema, *rows);
    return kDone;
}

}  // namespace kadr::expand
