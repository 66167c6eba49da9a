#include "expand/heap.h"

#include <algorithm>

namespace kadr::expand {

using sema::SlotKind;

namespace {
constexpr std::size_t kLeastThreshold = std::size_t{8} << 20;
constexpr std::size_t kGarbage = 4;  // part of the limit that may lie about before it is collected
}  // namespace

Heap::Heap(const sema::Code& code, const Limits& limits) : code_(code), limits_(limits) {
    // Object 0 is nobody's: an empty handle must not find something.
    objects_.resize(code.texts.size() + 1);
    for (std::size_t i = 0; i < code.texts.size(); ++i) {
        objects_[i + 1].kind = Kind::Text;
        objects_[i + 1].text = code.texts[i];
    }
    constants_ = objects_.size();
}

std::uint32_t Heap::new_object() {
    if (!free_.empty()) {
        const std::uint32_t at = free_.back();
        free_.pop_back();
        return at;
    }
    objects_.emplace_back();
    return static_cast<std::uint32_t>(objects_.size() - 1);
}

bool Heap::gives_up() {
    // A collection frees at most what was allocated behind the last one.
    const bool is_far = elements_ > 2 * limits_.elements ||
                        live_ + allocated_ > limits_.bytes + limits_.bytes / kGarbage;
    gave_up_ = gave_up_ || is_far;
    return gave_up_;
}

std::int64_t Heap::new_text(std::string text) {
    if (gives_up()) return handle(0);
    const std::uint32_t at = new_object();
    Object& object = objects_[at];
    object.kind = Kind::Text;
    object.text = std::move(text);
    allocated_ += sizeof(Object) + object.text.size();
    return handle(at);
}

std::int64_t Heap::new_array(std::uint32_t layout) {
    if (gives_up()) return handle(0);
    const std::uint32_t at = new_object();
    Object& object = objects_[at];
    object.kind = Kind::Array;
    object.layout = layout;
    object.stride = static_cast<std::uint32_t>(code_.layouts[layout].slots.size());
    object.count = 0;
    object.slots.clear();
    allocated_ += sizeof(Object);
    return handle(at);
}

void Heap::append(std::int64_t array_handle, const Slot* element) {
    Object& object = objects_[index(array_handle)];
    object.slots.insert(object.slots.end(), element, element + object.stride);
    ++object.count;
    elements_ += object.stride;
    allocated_ += object.stride * sizeof(Slot);
}

void Heap::insert(std::int64_t array_handle, std::int64_t at, const Slot* element) {
    Object& object = objects_[index(array_handle)];
    const auto place = object.slots.begin() + at * static_cast<std::int64_t>(object.stride);
    object.slots.insert(place, element, element + object.stride);
    ++object.count;
    elements_ += object.stride;
    allocated_ += object.stride * sizeof(Slot);
}

void Heap::remove(std::int64_t array_handle, std::int64_t at) {
    Object& object = objects_[index(array_handle)];
    const auto place = object.slots.begin() + at * static_cast<std::int64_t>(object.stride);
    object.slots.erase(place, place + object.stride);
    --object.count;
    elements_ -= object.stride;
}

void Heap::clear(std::int64_t array_handle) {
    Object& object = objects_[index(array_handle)];
    elements_ -= object.slots.size();
    object.slots.clear();
    object.count = 0;
}

/// A copy of one array; arrays in it are still those of the original.
std::int64_t Heap::copy_flat(std::int64_t array_handle) {
    if (array_handle == sema::kNotGivenInteger) return array_handle;
    const std::int64_t result = new_array(objects_[index(array_handle)].layout);
    if (gave_up_) return result;
    Object& target = objects_[index(result)];
    target.slots = objects_[index(array_handle)].slots;
    target.count = objects_[index(array_handle)].count;
    elements_ += target.slots.size();
    allocated_ += target.slots.size() * sizeof(Slot);
    return result;
}

std::int64_t Heap::copy(std::int64_t array_handle) {
    const std::int64_t result = copy_flat(array_handle);
    // With a list of its own: lists in lists may be deeper than the stack.
    std::vector<std::uint32_t> copied = {index(result)};
    while (!copied.empty() && result != sema::kNotGivenInteger && !gave_up_) {
        const std::uint32_t target = copied.back();
        copied.pop_back();
        const std::vector<SlotKind>& kinds = code_.layouts[objects_[target].layout].slots;
        if (std::find(kinds.begin(), kinds.end(), SlotKind::Array) == kinds.end()) continue;
        for (std::size_t i = 0; i < objects_[target].slots.size() && !gave_up_; ++i) {
            if (kinds[i % kinds.size()] != SlotKind::Array) continue;
            const std::int64_t inner = copy_flat(objects_[target].slots[i].integer);
            objects_[target].slots[i].integer = inner;
            if (inner != sema::kNotGivenInteger) copied.push_back(index(inner));
        }
    }
    return result;
}

Slot Heap::adopt(const Heap& other, Slot slot, SlotKind kind) {
    const bool is_handle = kind == SlotKind::Text || kind == SlotKind::Array;
    if (!is_handle || slot.integer == sema::kNotGivenInteger) return slot;
    Slot own{};
    if (kind == SlotKind::Text) {
        own.integer = new_text(other.text(slot.integer));
        return own;
    }
    const Object& source = other.objects_[index(slot.integer)];
    own.integer = new_array(source.layout);
    if (gave_up_) return own;
    const std::vector<SlotKind>& kinds = code_.layouts[source.layout].slots;
    std::vector<Slot> element(kinds.size());
    for (std::size_t first = 0; first < source.slots.size(); first += kinds.size()) {
        for (std::size_t i = 0; i < kinds.size(); ++i)
            element[i] = adopt(other, source.slots[first + i], kinds[i]);
        append(own.integer, element.data());
    }
    return own;
}

void Heap::copy_parts(Slot* slots, std::uint32_t layout) {
    const std::vector<SlotKind>& kinds = code_.layouts[layout].slots;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (kinds[i] == SlotKind::Array) slots[i].integer = copy(slots[i].integer);
    }
}

Slot* Heap::referred(std::int64_t reference, std::uint32_t slots) {
    const auto at =
        static_cast<std::uint32_t>(static_cast<std::uint64_t>(reference) >> 32 & 0x7fffffffu);
    const auto first = static_cast<std::uint32_t>(reference);
    if (at >= objects_.size() || objects_[at].kind != Kind::Array) return nullptr;
    if (std::size_t{first} + slots > objects_[at].slots.size()) return nullptr;
    return objects_[at].slots.data() + first;
}

void Heap::mark(std::int64_t value) {
    std::uint32_t at = 0;
    if (value >> 32 == kTag) at = index(value);
    else if (value < 0)
        at = static_cast<std::uint32_t>(static_cast<std::uint64_t>(value) >> 32 & 0x7fffffffu);
    if (at < constants_ || at >= objects_.size() || objects_[at].is_marked) return;
    objects_[at].is_marked = true;
    if (objects_[at].kind == Kind::Array) pending_.push_back(at);
}

void Heap::collect(std::span<const Slot> roots) {
    for (const Slot& slot : roots) mark(slot.integer);
    while (!pending_.empty()) {
        const std::uint32_t at = pending_.back();
        pending_.pop_back();
        const std::vector<SlotKind>& kinds = code_.layouts[objects_[at].layout].slots;
        for (std::size_t i = 0; i < objects_[at].slots.size(); ++i) {
            const SlotKind kind = kinds[i % kinds.size()];
            if (kind == SlotKind::Text || kind == SlotKind::Array)
                mark(objects_[at].slots[i].integer);
        }
    }
    std::size_t live = 0;
    for (std::uint32_t at = static_cast<std::uint32_t>(constants_); at < objects_.size(); ++at) {
        Object& object = objects_[at];
        if (object.is_marked) {
            object.is_marked = false;
            live += sizeof(Object) + object.text.size() + object.slots.size() * sizeof(Slot);
        } else if (object.kind != Kind::Free) {
            elements_ -= object.slots.size();
            object.kind = Kind::Free;
            object.text = {};
            object.slots = {};
            object.count = 0;
            free_.push_back(at);
        }
    }
    allocated_ = 0;
    live_ = live;
    threshold_ = std::max(kLeastThreshold, std::min<std::size_t>(live, limits_.bytes / kGarbage));
}

}  // namespace kadr::expand
