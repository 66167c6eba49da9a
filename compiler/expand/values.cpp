// Values on the heap that instructions make: texts taken apart, arrays, tables, pictures.
#include "expand/values.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "base/text.h"
#include "expand/running.h"
#include "sema/csv.h"
#include "sema/picture.h"

namespace kadr::expand {

using sema::SlotKind;

void collect_garbage(Running& run, const Slot* registers) {
    const std::size_t top = static_cast<std::size_t>(registers - run.vm.stack.data()) +
                            run.vm.calls.back().function->registers;
    run.vm.heap.collect(
        std::span<const Slot>(run.vm.stack.data(), std::min(top, run.vm.stack.size())));
}

std::int64_t split_text(Running& run, std::int64_t text, std::uint32_t layout) {
    const std::int64_t list = run.vm.heap.new_array(layout);
    const std::string whole = run.vm.heap.text(text);
    for (std::string_view rest = whole; !rest.empty() && !run.vm.heap.gives_up();) {
        const std::string_view character = code_points(rest, 0, 1);
        Slot slot{};
        slot.integer = run.vm.heap.new_text(std::string(character));
        run.vm.heap.append(list, &slot);
        rest.remove_prefix(character.size());
    }
    return list;
}

std::int64_t make_table(Running& run, const sema::TableSchema& schema,
                        const sema::TableRows& rows) {
    const std::int64_t table = run.vm.heap.new_array(schema.layout);
    const std::vector<SlotKind>& kinds = run.code.layouts[schema.layout].slots;
    std::vector<Slot> row(schema.slots);
    for (std::size_t first = 0; first < rows.slots.size() && !run.vm.heap.gives_up();
         first += schema.slots) {
        for (std::size_t i = 0; i < schema.slots; ++i) {
            row[i] = rows.slots[first + i];
            const bool is_text =
                kinds[i] == SlotKind::Text && row[i].integer != sema::kNotGivenInteger;
            if (is_text) {
                row[i].integer =
                    run.vm.heap.new_text(rows.texts[static_cast<std::size_t>(row[i].integer)]);
            }
        }
        run.vm.heap.append(table, row.data());
    }
    return table;
}

std::int64_t make_fixed(Running& run, std::uint32_t layout, std::int64_t count) {
    const std::int64_t array = run.vm.heap.new_array(layout);
    std::vector<Slot> element;
    for (const SlotKind kind : run.code.layouts[layout].slots) {
        Slot slot{};
        if (kind == SlotKind::Number) {
            slot.number = sema::kNotGivenNumber;
        } else {
            slot.integer = sema::kNotGivenInteger;
        }
        element.push_back(slot);
    }
    for (std::int64_t i = 0; i < count && !run.vm.heap.gives_up(); ++i)
        run.vm.heap.append(array, element.data());
    return array;
}

void make_image(Running& run, const sema::PictureSource& source, const sema::Picture& picture,
                Slot* image) {
    const std::int64_t dots = run.vm.heap.new_array(source.layout);
    for (const double brightness : picture.brightness) {
        if (run.vm.heap.gives_up()) break;
        Slot dot{};
        dot.number = brightness;
        run.vm.heap.append(dots, &dot);
    }
    image[source.width].integer = static_cast<std::int64_t>(picture.width);
    image[source.height].integer = static_cast<std::int64_t>(picture.height);
    image[source.dots].integer = dots;
}

Done read_image(Running& run, const sema::PictureSource& source, Slot path, std::uint32_t at,
                Slot* image) {
    const std::optional<sema::Picture> picture =
        sema::read_picture(source.folder, run.vm.heap.text(path.integer), run.code.locations[at],
                           run.options.access, run.sink);
    if (!picture) {
        run.status.fail();
        return kFailed;
    }
    make_image(run, source, *picture, image);
    return kDone;
}

Done read_table(Running& run, const sema::TableSchema& schema, Slot path, std::uint32_t at,
                Slot& table) {
    const std::optional<sema::TableRows> rows =
        sema::read_table(schema, run.code.enums, run.vm.heap.text(path.integer),
                         run.code.locations[at], run.options.access, run.sink);
    if (!rows) {
        run.status.fail();
        return kFailed;
    }
    table.integer = make_table(run, schema, *rows);
    return kDone;
}

}  // namespace kadr::expand
