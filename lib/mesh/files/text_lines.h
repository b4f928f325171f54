/// \file Reading a text word by word and line by line, without copying.
#pragma once

#include <charconv>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace qm {

/// What to do about a file that ends too early.
constexpr const char* cutOffHint = "The file seems to be cut off. Use a complete copy";

/// What a backslash at the end of a line means.
enum class Backslash { character, joinsLines };

/// Walks through a text. Lines end with LF, CRLF or CR, all of which may occur in one text; '#' begins a
/// comment. A byte order mark at the beginning, which some editors write, is passed over.
class TextLines {
public:
    explicit TextLines(std::string_view text, Backslash backslash = Backslash::character)
        : rest_(text), backslash_(backslash) {
        if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
        const std::size_t end = rest_.find_first_of("\r\n");
        isReturnAlone_ =
            end != std::string_view::npos && rest_[end] == '\r' && !rest_.substr(end).starts_with("\r\n");
    }

    /// Goes to the next line; after the last one follows an empty line.
    bool nextLine() {
        const bool found = !rest_.empty();
        takeLine();
        return found;
    }

    /// The next word of this line; empty at its end.
    std::string_view word() {
        while (lineIsEmpty() && joined_ && !rest_.empty())
            takeLine();
        std::size_t length = 0;
        while (length < line_.size() && !isBlank(line_[length]))
            ++length;
        const std::string_view found = line_.substr(0, length);
        line_.remove_prefix(length);
        return found;
    }

    /// The next word, on this line or a later one; empty at the end of the text.
    std::string_view wordAnywhere() {
        std::string_view found = word();
        while (found.empty() && nextLine())
            found = word();
        return found;
    }

    /// Whether no word is left on this line.
    bool lineIsEmpty() {
        while (!line_.empty() && isBlank(line_.front()))
            line_.remove_prefix(1);
        return line_.empty();
    }

    [[nodiscard]] std::uint32_t lineNumber() const { return number_; }
    [[nodiscard]] std::string place() const { return "line " + std::to_string(number_); }
    /// Throws an Error at this line.
    [[noreturn]] void fail(const std::string& what, const char* remedy = "Correct the line") const;
    /// Whether this is the last line and has no line end.
    [[nodiscard]] bool unfinished() const { return unfinished_; }
    /// The text after this line.
    [[nodiscard]] std::string_view rest() const { return rest_; }

private:
    static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

    void takeLine() {
        if (!rest_.empty()) ++number_;
        std::size_t end = 0;
        while (end < rest_.size() && rest_[end] != '\n' && rest_[end] != '\r')
            ++end;
        unfinished_ = end == rest_.size();
        line_ = rest_.substr(0, end);
        rest_.remove_prefix(end);
        if (!unfinished_) rest_.remove_prefix(rest_.starts_with("\r\n") && !isReturnAlone_ ? 2 : 1);
        line_ = line_.substr(0, line_.find('#'));
        while (!line_.empty() && isBlank(line_.back()))
            line_.remove_suffix(1);
        joined_ = backslash_ == Backslash::joinsLines && line_.ends_with('\\');
        if (joined_) line_.remove_suffix(1);
    }

    std::string_view rest_;
    std::string_view line_;
    std::uint32_t number_ = 0;
    Backslash backslash_;
    /// The first line ends with CR alone. Then LF is no part of such an end: it may be the first byte of what
    /// follows a header.
    bool isReturnAlone_ = false;
    bool joined_ = false;
    bool unfinished_ = false;
};

/// Whether a decimal number that no floating-point type can hold is too small, and not too large.
[[nodiscard]] bool isTiny(std::string_view number);

/// The whole word as a number, which may be nan or inf; nothing if it is no number. A value out of range
/// becomes the type's lowest or largest value; for floating point, zero or an infinity.
template <class Number> std::optional<Number> readFileNumber(std::string_view word) {
    if (word.starts_with('+')) {
        word.remove_prefix(1);
        if (word.starts_with('-')) return std::nullopt;
    }
    const char* const last = word.data() + word.size();
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), last, value);
    if (error == std::errc::invalid_argument || end != last) return std::nullopt;
    if (error == std::errc()) return value;
    using Limits = std::numeric_limits<Number>;
    const bool negative = word.starts_with('-');
    if constexpr (std::is_integral_v<Number>) {
        return negative ? Limits::min() : Limits::max();
    } else {
        long double wide = 0;
        if (std::from_chars(word.data(), last, wide).ec == std::errc())
            return static_cast<Number>(wide); // rounds to zero or to infinity
        if (isTiny(word)) return Number{};
        return negative ? -Limits::infinity() : Limits::infinity();
    }
}

/// The beginning of a word in quotes, for messages; bytes other than printable ASCII become '?'.
[[nodiscard]] std::string inQuotes(std::string_view word);

} // namespace qm
