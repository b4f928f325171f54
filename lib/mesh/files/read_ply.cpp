#include "base/bytes.h"
#include "base/error.h"
#include "mesh/files/ply_header.h"
#include "mesh/soup/soup.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

namespace qm {
namespace {

/// Reads one number after another, in the format given by the header.
class Values {
public:
    /// \param lines  at the beginning of the body
    Values(TextLines& lines, PlyFormat format) : lines_(lines), bytes_(lines.rest()), format_(format) {}

    /// The next number; nothing at the end of the file.
    std::optional<double> next(PlyType type) {
        if (isText()) return nextWord();
        switch (type) {
        case PlyType::int8:
            return take<std::int8_t>();
        case PlyType::uint8:
            return take<std::uint8_t>();
        case PlyType::int16:
            return take<std::int16_t>();
        case PlyType::uint16:
            return take<std::uint16_t>();
        case PlyType::int32:
            return take<std::int32_t>();
        case PlyType::uint32:
            return take<std::uint32_t>();
        case PlyType::float32:
            return take<float>();
        case PlyType::float64:
            return take<double>();
        }
        return std::nullopt;
    }

    /// Whether only white space is left.
    bool atEnd() {
        return isText() ? lines_.wordAnywhere().empty()
                        : bytes_.find_first_not_of(" \t\r\n") == std::string_view::npos;
    }

    /// The number of the present line; 0 in binary files.
    [[nodiscard]] std::uint32_t line() const { return isText() ? lines_.lineNumber() : 0; }

private:
    [[nodiscard]] bool isText() const { return format_ == PlyFormat::ascii; }

    std::optional<double> nextWord() {
        const std::string_view word = lines_.wordAnywhere();
        if (word.empty()) return std::nullopt;
        const auto value = readFileNumber<double>(word);
        if (!value) lines_.fail(inQuotes(word) + " is no number");
        return value;
    }

    template <class Number> std::optional<double> take() {
        if (bytes_.size() < sizeof(Number)) return std::nullopt;
        const bool isLittle = format_ == PlyFormat::littleEndian;
        const auto number = numberFrom<Number>(bytes_, isLittle ? std::endian::little : std::endian::big);
        bytes_.remove_prefix(sizeof(Number));
        return static_cast<double>(number);
    }

    TextLines& lines_;
    std::string_view bytes_; ///< that are left of a binary file
    PlyFormat format_;
};

class PlyReader {
public:
    explicit PlyReader(std::string_view bytes)
        : size_(bytes.size()), lines_(bytes), header_(readPlyHeader(lines_)),
          values_(lines_, header_.format) {}

    Soup read() {
        for (const PlyElement& element : header_.elements) {
            if (element.properties.empty()) continue; // nothing is stored for it
            const bool vertex = element.name == "vertex", face = element.name == "face";
            for (std::size_t k = 0; k < element.count; ++k) {
                const Point point = readElement(element, k);
                if (vertex) addPoint(point);
                if (face) soup_.endFace(values_.line());
            }
        }
        if (!values_.atEnd())
            throw Error(values_.line() > 0 ? lines_.place() : "",
                        "the file goes on after the elements that its header announces",
                        "Correct the counts and properties in the header");
        return std::move(soup_);
    }

private:
    void addPoint(const Point& point) {
        soup_.points.push_back(point);
        if (values_.line() > 0) soup_.pointLines.push_back(values_.line());
    }

    /// \return the point, if the element is a vertex; corners are added to the soup
    Point readElement(const PlyElement& element, std::size_t k) {
        Point point(0, 0, 0);
        for (const PlyProperty& property : element.properties) {
            if (property.countType) {
                readList(element, k, property);
                continue;
            }
            const double value = next(element, k, property.type);
            if (property.role == PlyRole::x) point[0] = value;
            if (property.role == PlyRole::y) point[1] = value;
            if (property.role == PlyRole::z) point[2] = value;
        }
        return point;
    }

    void readList(const PlyElement& element, std::size_t k, const PlyProperty& property) {
        const double count = next(element, k, *property.countType);
        if (!(count >= 0) || count > static_cast<double>(size_) || count != std::floor(count))
            throw Error(placeOf(element, k), "its list has an impossible length",
                        "Use another copy of the file");
        for (auto left = static_cast<std::size_t>(count); left > 0; --left) {
            const double value = next(element, k, property.type);
            if (property.role == PlyRole::corners) soup_.corners.push_back(indexOf(value, element, k));
            if (property.role == PlyRole::strips) addToStrip(indexOf(value, element, k));
        }
        strip_ = {};
    }

    /// Every corner of a strip makes a triangle with the two before it; every second one is turned.
    void addToStrip(std::int64_t corner) {
        constexpr std::int64_t endOfStrip = -1;
        if (corner == endOfStrip) {
            strip_ = {};
            return;
        }
        if (strip_.length >= 2) {
            const auto [first, second] = strip_.last;
            const bool isTurned = strip_.length % 2 == 1;
            soup_.corners.insert(soup_.corners.end(),
                                 {isTurned ? second : first, isTurned ? first : second, corner});
            soup_.endFace(values_.line());
        }
        strip_ = {{strip_.last[1], corner}, strip_.length + 1};
    }

    double next(const PlyElement& element, std::size_t k, PlyType type) {
        const auto value = values_.next(type);
        if (!value)
            throw Error(placeOf(element, k),
                        "the file ends there, its header announces " + std::to_string(element.count),
                        cutOffHint);
        return *value;
    }

    std::int64_t indexOf(double value, const PlyElement& element, std::size_t k) const {
        constexpr double largest = 1e15; // above the number of vertices in any file
        if (value != std::floor(value))  // also true for nan
            throw Error(placeOf(element, k), "a vertex index is no whole number", "Correct the face");
        return static_cast<std::int64_t>(std::clamp(value, -largest, largest));
    }

    [[nodiscard]] std::string placeOf(const PlyElement& element, std::size_t k) const {
        const std::string line = values_.line() > 0 ? " (line " + std::to_string(values_.line()) + ")" : "";
        return element.name + " " + std::to_string(k) + line;
    }

    std::size_t size_;
    TextLines lines_;
    PlyHeader header_;
    Values values_;
    Soup soup_;
    struct Strip {
        std::array<std::int64_t, 2> last{};
        std::size_t length = 0; ///< in corners
    };
    Strip strip_; ///< as far as it is read
};

} // namespace

Soup readPly(std::string_view bytes) {
    return PlyReader(bytes).read();
}

} // namespace qm
