#include "driver/operator_events.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/diagnostics/driver.h"
#include "base/diagnostics/machine.h"
#include "base/numbers.h"

namespace kadr::driver {

namespace {

using motion::OperatorAct;
using motion::OperatorEvent;

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Takes what stands in front of a sign; nothing, and all is left, if it is not there.
std::optional<std::string_view> cut_at(std::string_view& text, std::string_view sign) {
    const std::size_t at = text.find(sign);
    if (at == std::string_view::npos) return std::nullopt;
    const std::string_view head = trimmed(text.substr(0, at));
    text = trimmed(text.substr(at + sign.size()));
    return head;
}

/// A number at the beginning, which is taken.
std::optional<double> take_number(std::string_view& text) {
    const Decimal number = parse_decimal(text.data(), text.data() + text.size());
    if (number.end == text.data() || !std::isfinite(number.value) || number.value < 0)
        return std::nullopt;
    text = trimmed(text.substr(static_cast<std::size_t>(number.end - text.data())));
    return number.value;
}

/// `5s`, `500 ms`, `1.5min` at the beginning, in s.
std::optional<double> take_time(std::string_view& text) {
    const auto number = take_number(text);
    if (!number) return std::nullopt;
    const std::size_t letters =
        std::min(text.find_first_not_of("abcdefghijklmnopqrstuvwxyz"), text.size());
    const std::string_view unit = text.substr(0, letters);
    const double factor = unit == "s" ? 1 : unit == "ms" ? 1e-3 : unit == "min" ? 60 : 0;
    if (factor == 0) return std::nullopt;
    text = trimmed(text.substr(letters));
    return *number * factor;
}

/// The whole of a text.
std::optional<double> time_of(std::string_view text) {
    const auto time = take_time(text);
    return text.empty() ? time : std::nullopt;
}

/// `50%`, `50 %`, `50` as a part.
std::optional<double> part_of(std::string_view text, double most) {
    const auto percent = take_number(text);
    const bool is_all = text.empty() || text == "%";
    if (!percent || !is_all || *percent > 100 * most) return std::nullopt;
    return *percent / 100;
}

/// `N120` or `:34` at the beginning.
bool take_block(std::string_view& text, OperatorEvent& event) {
    const bool is_line = text.starts_with(':');
    if (!is_line && !text.starts_with('N') && !text.starts_with('n')) return false;
    std::int32_t number = -1;
    const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), number);
    if (error != std::errc() || number < (is_line ? 1 : 0)) return false;
    if (is_line) event.line = static_cast<std::uint32_t>(number);
    else event.number = number;
    text = trimmed(text.substr(static_cast<std::size_t>(end - text.data())));
    return true;
}

/// `5s`, `N120`, `N120 + 2s` at the beginning.
bool take_when(std::string_view& text, OperatorEvent& event) {
    if (take_block(text, event)) {
        if (!text.starts_with('+')) return true;
        text = trimmed(text.substr(1));
    }
    const auto time = take_time(text);
    if (!time) return false;
    event.time = *time;
    return true;
}

/// Takes one of the words that stand in front of the rest.
bool take_words(std::string_view& text, std::string_view first, std::string_view second) {
    if (!text.starts_with(first)) return false;
    std::string_view behind = text.substr(first.size());
    if (!second.empty()) {
        behind = trimmed(behind);
        if (!behind.starts_with(second)) return false;
        behind.remove_prefix(second.size());
    }
    // `sets` is another word.
    const char next = behind.empty() ? ' ' : behind.front();
    if ((next >= 'a' && next <= 'z') || (next >= 'A' && next <= 'Z')) return false;
    text = trimmed(behind);
    return true;
}

/// What stands in front of a remark: `#`, but not that of a variable (`set #1004=1`).
std::string_view without_remark(std::string_view line) {
    for (std::size_t at = 0; (at = line.find('#', at)) < line.size(); ++at) {
        const char next = at + 1 < line.size() ? line[at + 1] : ' ';
        const bool is_variable = line.substr(0, at).find("set") < at &&
                                 ((next >= '0' && next <= '9') || next == '[' || next == '<');
        if (!is_variable) return trimmed(line.substr(0, at));
    }
    return trimmed(line);
}

}  // namespace

std::optional<OperatorEvent> operator_event(std::string_view text) {
    OperatorEvent event;
    std::string_view left = trimmed(text);
    if (!take_when(left, event)) return std::nullopt;
    const bool is_hold = take_words(left, "feed", "hold");
    if (is_hold || take_words(left, "cycle", "start")) {
        event.act = is_hold ? OperatorAct::FeedHold : OperatorAct::CycleStart;
        return left.empty() ? std::optional(event) : std::nullopt;
    }
    const bool is_feed = take_words(left, "feed", "override");
    if (!is_feed && !take_words(left, "rapid", "override")) return std::nullopt;
    const auto part = part_of(left, is_feed ? kMostFeedOverride : kMostRapidOverride);
    if (!part) return std::nullopt;
    event.act = is_feed ? OperatorAct::FeedOverride : OperatorAct::RapidOverride;
    event.value = *part;
    return event;
}

std::optional<macro::InputEvent> input_event(std::string_view text) {
    OperatorEvent when;
    std::string_view left = trimmed(text);
    if (!take_when(left, when) || !take_words(left, "set", "")) return std::nullopt;
    if (left.find('=') == std::string_view::npos) return std::nullopt;
    macro::InputEvent event;
    event.text = left;
    event.time = when.time;
    event.line = when.line;
    event.number = when.number;
    return event;
}

std::optional<interp::ProbeTouch> probe_touch(std::string_view text) {
    OperatorEvent when;
    std::string_view left = trimmed(text);
    if (!take_block(left, when) || !take_words(left, "touch", "")) return std::nullopt;
    interp::ProbeTouch touch;
    touch.line = when.line;
    touch.number = when.number;
    if (left == "none") return touch;
    while (!left.empty()) {
        const auto axis = std::ranges::find(kAxisNames, left.substr(0, 1));
        if (axis == kAxisNames.end()) return std::nullopt;
        const Decimal number = parse_decimal(left.data() + 1, left.data() + left.size());
        if (number.end == left.data() + 1 || !std::isfinite(number.value)) return std::nullopt;
        const auto index = static_cast<std::size_t>(axis - kAxisNames.begin());
        touch.axes = static_cast<AxisMask>(touch.axes | 1u << index);
        touch.at[index] = number.value;
        left = trimmed(left.substr(static_cast<std::size_t>(number.end - left.data())));
    }
    return touch.axes != 0 ? std::optional(touch) : std::nullopt;
}

std::optional<std::vector<OperatorEvent>> hold_events(std::string_view text) {
    OperatorEvent hold;
    hold.act = OperatorAct::FeedHold;
    std::string_view until = trimmed(text);
    const auto from = cut_at(until, "..");
    std::string_view when = from.value_or(until);
    if (!take_when(when, hold) || !when.empty()) return std::nullopt;
    if (!from || until.empty()) return {{hold}};
    OperatorEvent start = hold;
    start.act = OperatorAct::CycleStart;
    const auto time = time_of(until);
    const bool is_at_block = hold.line != 0 || hold.number >= 0;
    if (!time || (!is_at_block && *time <= hold.time)) return std::nullopt;
    start.time = is_at_block ? hold.time + *time : *time;
    return {{hold, start}};
}

std::optional<OverrideSequence> override_sequence(std::string_view text, OperatorAct act,
                                                  double most) {
    OverrideSequence sequence;
    std::string_view left = trimmed(text);
    for (bool is_first = true; is_first || !left.empty(); is_first = false) {
        const auto head = cut_at(left, ",");
        std::string_view item = head.value_or(left);
        if (head && left.empty()) return std::nullopt;
        if (!head) left = {};
        OperatorEvent event;
        event.act = act;
        const std::size_t colon = item.rfind(':');
        const bool is_later = colon != std::string_view::npos && colon > 0;
        if (is_later) {
            std::string_view when = trimmed(item.substr(0, colon));
            if (!take_when(when, event) || !when.empty()) return std::nullopt;
            item = trimmed(item.substr(colon + 1));
        }
        const auto part = part_of(item, most);
        if (!part || is_later == is_first) return std::nullopt;
        event.value = *part;
        if (is_later) sequence.events.push_back(event);
        else sequence.at_start = *part;
    }
    // Nothing would turn it on.
    if (sequence.events.empty() && sequence.at_start < 0.01) return std::nullopt;
    return sequence;
}

std::optional<RunEvents> read_events(Session& session, const std::string& file) {
    auto text = session.access().read(file);
    if (!text) {
        report_unread(session.messages(), diag::FileUnreadable, {}, file, text.error(),
                      session.access());
        return std::nullopt;
    }
    const FileId id = session.sources().add(file, *std::move(text));
    const std::string_view all = session.sources().text(id);
    RunEvents events;
    bool is_good = true;
    std::size_t begin = 0;
    std::uint32_t number = 0;
    while (begin < all.size()) {
        const std::size_t end = std::min(all.find('\n', begin), all.size());
        std::string_view line(all.data() + begin, end - begin);
        const std::string_view words = without_remark(line);
        begin = end + 1;
        ++number;
        if (words.empty()) continue;
        const auto first = static_cast<std::uint32_t>(words.data() - all.data());
        if (const auto event = operator_event(words)) {
            events.panel.push_back(*event);
            continue;
        }
        if (const auto touch = probe_touch(words)) {
            events.touches.push_back(*touch);
            continue;
        }
        if (auto event = input_event(words)) {
            event->file = file;
            event->file_line = number;
            events.inputs.push_back(std::move(*event));
            continue;
        }
        is_good = false;
        const auto last = static_cast<std::uint32_t>(first + words.size());
        session.messages()
            .report(diag::OperatorLineUnclear, SourceRange{id, first, last})
            .arg(words)
            .fix(
                "say when and what: `5s feed hold`, `N120 + 2s feed override 50%`, "
                "`5s set $A_IN[3]=1`, `N120 touch X25.3`");
    }
    return is_good ? std::optional(events) : std::nullopt;
}

std::string block_name(std::int64_t number, std::uint32_t line) {
    return number >= 0 ? 'N' + std::to_string(number) : ':' + std::to_string(line);
}

}  // namespace kadr::driver
