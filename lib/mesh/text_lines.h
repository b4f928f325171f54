/// \file Words of a text, line by line, without copying.
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace qm {

/// Walks through a text. Lines end with LF, CRLF or the text; '#' begins a comment.
class TextLines {
public:
    explicit TextLines(std::string_view text) : rest_(text) {}

    /// Goes to the next line. \param continued  a backslash at the end joins it with the one after
    bool nextLine(bool continued = false) {
        if (rest_.empty()) return false;
        takeLine();
        continues_ = continued;
        return true;
    }

    /// The next word of this line; empty at its end.
    std::string_view word() {
        for (;;) {
            skipBlanks();
            if (continues_ && line_ == "\\" && !rest_.empty()) {
                takeLine();
                continue;
            }
            std::size_t length = 0;
            while (length < line_.size() && !isBlank(line_[length]))
                ++length;
            const std::string_view found = line_.substr(0, length);
            line_.remove_prefix(length);
            return found;
        }
    }

    /// The next word, on this line or a later one; empty at the end of the text.
    std::string_view wordAnywhere() {
        std::string_view found = word();
        while (found.empty() && nextLine())
            found = word();
        return found;
    }

    [[nodiscard]] std::uint32_t lineNumber() const { return number_; }
    [[nodiscard]] std::string place() const { return "line " + std::to_string(number_); }
    [[nodiscard]] bool atEnd() const { return rest_.empty(); }
    /// The line was the last one and no line end followed it.
    [[nodiscard]] bool unfinished() const { return unfinished_; }

private:
    static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

    void skipBlanks() {
        while (!line_.empty() && isBlank(line_.front()))
            line_.remove_prefix(1);
    }

    void takeLine() {
        const std::size_t end = rest_.find('\n');
        unfinished_ = end == std::string_view::npos;
        line_ = rest_.substr(0, end);
        rest_.remove_prefix(unfinished_ ? rest_.size() : end + 1);
        line_ = line_.substr(0, line_.find('#'));
        while (!line_.empty() && isBlank(line_.back()))
            line_.remove_suffix(1);
        ++number_;
    }

    std::string_view rest_;
    std::string_view line_;
    std::uint32_t number_ = 0;
    bool continues_ = false;
    bool unfinished_ = false;
};

/// The whole word as a number; nan and inf are numbers here. Nothing if it is none.
template <class Number> std::optional<Number> parseNumber(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error == std::errc::result_out_of_range) return Number{}; // under- or overflow
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return value;
}

} // namespace qm
