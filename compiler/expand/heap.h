// heap.h — texts and arrays of a running program.
//
// Registers hold handles. What no register can reach any more is found by marking and reused, so
// that a loop which makes texts runs in bounded memory. Nothing is counted while values are copied.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sema/code.h"

namespace kadr::expand {

using sema::Slot;

class Heap {
  public:
    /// What all texts and arrays together may take.
    struct Limits {
        std::uint64_t elements;  // registers in arrays
        std::uint64_t bytes;
    };

    /// Texts of the program get the first handles and stay for ever.
    Heap(const sema::Code& code, const Limits& limits);

    static std::int64_t constant_text(std::uint32_t index) { return handle(index + 1); }

    std::int64_t new_text(std::string text);
    std::int64_t new_array(std::uint32_t layout);
    /// A copy that shares nothing with the original but texts.
    std::int64_t copy(std::int64_t array);
    /// A register of another running program of the same code: its texts and arrays are copied.
    Slot adopt(const Heap& other, Slot slot, sema::SlotKind kind);
    /// Replaces arrays inside a value of this layout by copies.
    void copy_parts(Slot* slots, std::uint32_t layout);

    const std::string& text(std::int64_t text_handle) const {
        return objects_[index(text_handle)].text;
    }

    /// An array's registers; elements have `stride` of them.
    struct ArrayView {
        Slot* slots;
        std::int64_t count;
        std::uint32_t stride;
    };
    ArrayView array(std::int64_t array_handle) {
        Object& object = objects_[index(array_handle)];
        return {object.slots.data(), object.count, object.stride};
    }
    const sema::ElementLayout& layout(std::int64_t array_handle) const {
        return code_.layouts[objects_[index(array_handle)].layout];
    }
    void append(std::int64_t array_handle, const Slot* element);
    void insert(std::int64_t array_handle, std::int64_t at, const Slot* element);
    void remove(std::int64_t array_handle, std::int64_t at);
    void clear(std::int64_t array_handle);

    /// References to elements: told from references to registers by their sign.
    static std::int64_t element_reference(std::int64_t array_handle, std::uint32_t slot) {
        return static_cast<std::int64_t>(
            std::uint64_t{1} << 63 | static_cast<std::uint64_t>(index(array_handle)) << 32 | slot);
    }
    /// Slot of an element reference; null if the array has shrunk below it.
    Slot* referred(std::int64_t reference, std::uint32_t slots);

    /// Whether it is time to look for what is no longer needed.
    bool is_full() const { return allocated_ > threshold_; }
    void collect(std::span<const Slot> roots);

    /// Whether a limit is passed; what is no longer needed counts until it has been collected.
    bool is_beyond() const {
        return gave_up_ || elements_ > limits_.elements || live_ + allocated_ > limits_.bytes;
    }
    /// Asked between the parts of a large value: so far beyond a limit that a collection will not
    /// help. The value is left incomplete, and `is_beyond` holds for good.
    bool gives_up();
    bool has_too_many_elements() const { return elements_ > limits_.elements; }
    const Limits& limits() const { return limits_; }

  private:
    enum class Kind : std::uint8_t { Free, Text, Array };
    struct Object {
        Kind kind = Kind::Free;
        bool is_marked = false;
        std::uint32_t layout = 0;
        std::uint32_t stride = 1;
        std::int64_t count = 0;
        std::string text;
        std::vector<Slot> slots;
    };

    // A pattern in the upper half makes it unlikely that a number is taken for a handle; if it is,
    // something lives longer than needed, no more.
    static constexpr std::int64_t kTag = 0x4b414452;
    static std::int64_t handle(std::uint32_t index) { return kTag << 32 | index; }
    static std::uint32_t index(std::int64_t value) { return static_cast<std::uint32_t>(value); }

    std::uint32_t new_object();
    std::int64_t copy_flat(std::int64_t array);
    void mark(std::int64_t value);

    const sema::Code& code_;
    Limits limits_;
    std::vector<Object> objects_;
    std::vector<std::uint32_t> free_;
    std::vector<std::uint32_t> pending_;  // marked, their elements not yet
    std::size_t constants_ = 0;
    std::size_t allocated_ = 0;  // bytes since the last collection
    std::size_t threshold_ = std::size_t{8} << 20;
    std::size_t live_ = 0;  // bytes that the last collection left
    std::uint64_t elements_ = 0;
    bool gave_up_ = false;
};

}  // namespace kadr::expand
