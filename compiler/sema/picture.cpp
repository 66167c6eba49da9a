#include "sema/picture.h"

#include <algorithm>
#include <charconv>

#include "base/diagnostics/driver.h"
#include "base/diagnostics/sema.h"
#include "base/done.h"
#include "base/text.h"

namespace kadr::sema {

namespace {

constexpr std::size_t kMostDots = 50'000'000;  // elements of all arrays of a program
constexpr std::size_t kMostWhite = 65'535;     // of the format
constexpr std::size_t kShown = 40;             // characters of a line or word in a message

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
}

class PictureReader {
  public:
    PictureReader(std::string file, std::string_view text, const SourceRange& location,
                  DiagnosticSink& sink)
        : file_(std::move(file)), text_(text), location_(location), sink_(sink) {}

    std::optional<Picture> read() {
        const bool is_text = text_.starts_with("P2");
        if (!is_text && !text_.starts_with("P5")) {
            sink_.report(diag::ImageKind, location_).arg(file_);
            return std::nullopt;
        }
        at_ = 2;
        if (!read_head("width", kMostDots, picture_.width)) return std::nullopt;
        if (!read_head("height", kMostDots, picture_.height)) return std::nullopt;
        if (!read_head("grey value of white", kMostWhite, white_)) return std::nullopt;
        if (picture_.width > kMostDots / picture_.height) {
            sink_.report(diag::ImageTooLarge, location_).arg(picture_.width).arg(picture_.height);
            return std::nullopt;
        }
        // No more is reserved than the file can hold: its head may promise anything.
        picture_.brightness.reserve(std::min(picture_.width * picture_.height, text_.size()));
        const Done dots = is_text ? read_text_dots() : read_byte_dots();
        if (!dots) return std::nullopt;
        return std::move(picture_);
    }

  private:
    void skip_blanks() {
        while (at_ < text_.size()) {
            if (text_[at_] == '#') at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
            else if (is_blank(text_[at_])) ++at_;
            else return;
        }
    }

    std::string_view word() {
        skip_blanks();
        const std::size_t begin = at_;
        while (at_ < text_.size() && !is_blank(text_[at_]) && text_[at_] != '#') ++at_;
        return text_.substr(begin, at_ - begin);
    }

    static bool number(std::string_view word, std::size_t& value) {
        const char* end = word.data() + word.size();
        const auto read = std::from_chars(word.data(), end, value);
        return read.ec == std::errc() && read.ptr == end;
    }

    /// The location of a word that was just read; among bytes the line ends with it.
    TextLocation location_of(std::string_view word) const {
        const std::size_t begin = at_ - word.size();
        TextLocation location;
        location.file = file_;
        const std::string_view before = text_.substr(0, begin);
        location.line = static_cast<std::uint32_t>(std::ranges::count(before, '\n')) + 1;
        const std::size_t line = before.find_last_of("\r\n");
        const std::size_t first = line == std::string_view::npos ? 0 : line + 1;
        location.column = static_cast<std::uint32_t>(begin - first) + 1;
        location.length =
            static_cast<std::uint32_t>(std::clamp<std::size_t>(word.size(), 1, kShown));
        location.text =
            printable(text_.substr(first, begin - first + std::min(word.size(), kShown)));
        return location;
    }

    static std::string printable(std::string_view bytes) {
        std::string out(bytes);
        for (char& c : out) {
            if (c < ' ' || c > '~') c = '?';
        }
        return out;
    }

    DiagnosticBuilder report(const DiagnosticRow& row, std::string_view word) {
        DiagnosticBuilder builder = sink_.report(row, location_of(word));
        builder.note(location_, "the picture is read here");
        return builder;
    }

    Done read_head(std::string_view what, std::size_t most, std::size_t& value) {
        const std::string_view found = word();
        if (number(found, value) && value >= 1 && value <= most) return kDone;
        report(diag::ImageHead, found).arg(printable(found.substr(0, kShown))).arg(what);
        return kFailed;
    }

    std::size_t row() const { return picture_.brightness.size() / picture_.width + 1; }
    std::size_t column() const { return picture_.brightness.size() % picture_.width + 1; }

    Done refuse_short() {
        sink_.report(diag::ImageShort, location_)
            .arg(file_)
            .arg(text_.size())
            .arg(row())
            .arg(column())
            .arg(picture_.width)
            .arg(picture_.height);
        return kFailed;
    }

    Done refuse_long() {
        sink_.report(diag::ImageLong, location_).arg(file_).arg(at_);
        return kFailed;
    }

    void add(std::size_t grey) {
        picture_.brightness.push_back(static_cast<double>(grey) / static_cast<double>(white_));
    }

    Done read_text_dots() {
        const std::size_t dots = picture_.width * picture_.height;
        while (picture_.brightness.size() < dots) {
            const std::string_view found = word();
            if (found.empty()) return refuse_short();
            std::size_t grey = 0;
            if (!number(found, grey) || grey > white_) {
                report(diag::ImageGrey, found)
                    .arg(printable(found.substr(0, kShown)))
                    .arg(row())
                    .arg(column())
                    .arg(white_);
                return kFailed;
            }
            add(grey);
        }
        skip_blanks();
        return at_ >= text_.size() ? kDone : refuse_long();
    }

    Done read_byte_dots() {
        // One blank ends the head; a comment there would be dots.
        if (at_ >= text_.size()) return refuse_short();
        ++at_;
        const std::size_t dots = picture_.width * picture_.height;
        const std::size_t size = white_ > 255 ? 2 : 1;
        while (picture_.brightness.size() < dots) {
            if (text_.size() - at_ < size) return refuse_short();
            std::size_t grey = static_cast<unsigned char>(text_[at_]);
            if (size == 2) grey = grey * 256 + static_cast<unsigned char>(text_[at_ + 1]);
            if (grey > white_) {
                sink_.report(diag::ImageGrey, location_)
                    .arg(grey)
                    .arg(row())
                    .arg(column())
                    .arg(white_)
                    .note("at byte " + std::to_string(at_) + " of " + file_);
                return kFailed;
            }
            at_ += size;
            add(grey);
        }
        // Some programs end every file with a line end.
        std::size_t end = text_.size();
        while (end > at_ && is_blank(text_[end - 1])) --end;
        return at_ == end ? kDone : refuse_long();
    }

    std::string file_;
    std::string_view text_;
    SourceRange location_;
    DiagnosticSink& sink_;
    std::size_t at_ = 0;  // byte
    std::size_t white_ = 0;
    Picture picture_;
};

}  // namespace

std::optional<Picture> read_picture(const std::string& folder, const std::string& path,
                                    const SourceRange& location, FileAccess* access,
                                    DiagnosticSink& sink) {
    const bool is_absolute = !path.empty() && (path[0] == '/' || path[0] == '\\');
    const std::string file = is_absolute ? path : folder + path;
    if (access == nullptr) {
        sink.report(diag::FileElsewhere, location).arg(file);
        return std::nullopt;
    }
    const auto text = access->read_named(file);
    if (!text) {
        report_unread(sink, diag::ImageUnreadable, location, file, text.error(), *access);
        return std::nullopt;
    }
    return PictureReader(file, *text, location, sink).read();
}

}  // namespace kadr::sema
