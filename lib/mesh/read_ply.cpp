#include "base/error.h"
#include "mesh/soup.h"
#include "mesh/text_lines.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <memory>
#include <optional>

namespace qm {
namespace {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::optional<Type> typeNamed(std::string_view name) {
    constexpr std::array<std::pair<std::string_view, Type>, 16> names{{{"char", Type::int8},
                                                                       {"int8", Type::int8},
                                                                       {"uchar", Type::uint8},
                                                                       {"uint8", Type::uint8},
                                                                       {"short", Type::int16},
                                                                       {"int16", Type::int16},
                                                                       {"ushort", Type::uint16},
                                                                       {"uint16", Type::uint16},
                                                                       {"int", Type::int32},
                                                                       {"int32", Type::int32},
                                                                       {"uint", Type::uint32},
                                                                       {"uint32", Type::uint32},
                                                                       {"float", Type::float32},
                                                                       {"float32", Type::float32},
                                                                       {"double", Type::float64},
                                                                       {"float64", Type::float64}}};
    const auto found = std::ranges::find(names, name, &std::pair<std::string_view, Type>::first);
    return found == names.end() ? std::nullopt : std::optional(found->second);
}

struct Property {
    std::string name;
    Type type{};
    std::optional<Type> countType; ///< of a list
};

struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;
};

[[noreturn]] void cutOff(const std::string& element, std::size_t found, std::size_t announced) {
    throw Error(element + " " + std::to_string(found),
                "the file ends there, its header announces " + std::to_string(announced),
                "the file seems to be cut off; get it whole");
}

/// Numbers one after the other, as the header's format has them.
class Values {
public:
    virtual ~Values() = default;
    /// Nothing at the end of the file.
    virtual std::optional<double> next(Type type) = 0;
    [[nodiscard]] virtual std::uint32_t line() const { return 0; }
};

class TextValues : public Values {
public:
    explicit TextValues(TextLines& lines) : lines_(lines) {}
    std::optional<double> next(Type) override {
        const std::string_view word = lines_.wordAnywhere();
        if (word.empty()) return std::nullopt;
        const auto value = parseNumber<double>(word);
        if (!value)
            throw Error(lines_.place(), "\"" + std::string(word.substr(0, 20)) + "\" is no number",
                        "mend the line");
        return value;
    }
    [[nodiscard]] std::uint32_t line() const override { return lines_.lineNumber(); }

private:
    TextLines& lines_;
};

class BinaryValues : public Values {
public:
    BinaryValues(std::string_view bytes, bool swapped) : bytes_(bytes), swapped_(swapped) {}
    std::optional<double> next(Type type) override {
        switch (type) {
        case Type::int8:
            return take<std::int8_t>();
        case Type::uint8:
            return take<std::uint8_t>();
        case Type::int16:
            return take<std::int16_t>();
        case Type::uint16:
            return take<std::uint16_t>();
        case Type::int32:
            return take<std::int32_t>();
        case Type::uint32:
            return take<std::uint32_t>();
        case Type::float32:
            return take<float>();
        case Type::float64:
            return take<double>();
        }
        return std::nullopt;
    }

private:
    template <class Number> std::optional<double> take() {
        if (bytes_.size() < sizeof(Number)) return std::nullopt;
        std::array<char, sizeof(Number)> raw;
        std::memcpy(raw.data(), bytes_.data(), sizeof(Number));
        bytes_.remove_prefix(sizeof(Number));
        if (swapped_) std::ranges::reverse(raw);
        return static_cast<double>(std::bit_cast<Number>(raw));
    }

    std::string_view bytes_;
    bool swapped_;
};

class PlyReader {
public:
    explicit PlyReader(std::string_view bytes) : bytes_(bytes), lines_(bytes) {}

    Soup read() {
        readHeader();
        const std::unique_ptr<Values> values = openBody();
        for (const Element& element : elements_) {
            const bool vertex = element.name == "vertex", face = element.name == "face";
            if (element.properties.empty()) continue; // nothing is stored for it
            for (std::size_t k = 0; k < element.count; ++k)
                readElement(element, k, vertex, face, *values);
        }
        return std::move(soup_);
    }

private:
    void readHeader() {
        lines_.nextLine();
        if (lines_.word() != "ply")
            throw Error("line 1", "it does not begin with ply", "is it another format?");
        for (;;) {
            if (!lines_.nextLine())
                throw Error(lines_.place(), "the header has no end", "get the file whole");
            const std::string_view keyword = lines_.word();
            if (keyword == "end_header") return;
            if (keyword == "format") format_ = lines_.word();
            if (keyword == "element") readElementLine();
            if (keyword == "property") readPropertyLine();
        }
    }

    void readElementLine() {
        Element element;
        element.name = lines_.word();
        const auto count = parseNumber<std::int64_t>(lines_.word());
        if (!count || *count < 0) throw Error(lines_.place(), "the element has no count", "mend the header");
        element.count = static_cast<std::size_t>(*count);
        elements_.push_back(std::move(element));
    }

    Type readType(std::string_view word) const {
        const auto type = typeNamed(word);
        if (!type)
            throw Error(lines_.place(), "\"" + std::string(word.substr(0, 20)) + "\" is no type",
                        "mend the header");
        return *type;
    }

    void readPropertyLine() {
        if (elements_.empty())
            throw Error(lines_.place(), "a property comes before any element", "mend the header");
        Property property;
        std::string_view word = lines_.word();
        if (word == "list") {
            property.countType = readType(lines_.word());
            word = lines_.word();
        }
        property.type = readType(word);
        property.name = lines_.word();
        elements_.back().properties.push_back(std::move(property));
    }

    std::unique_ptr<Values> openBody() {
        if (format_ == "ascii") return std::make_unique<TextValues>(lines_);
        const bool little = format_ == "binary_little_endian", big = format_ == "binary_big_endian";
        if (!little && !big)
            throw Error("", "format " + format_ + " is not understood", "write it as ascii or binary PLY");
        const std::size_t header = bytes_.find("end_header");
        const std::size_t body = bytes_.find('\n', header) + 1;
        return std::make_unique<BinaryValues>(bytes_.substr(body),
                                              little != (std::endian::native == std::endian::little));
    }

    void readElement(const Element& element, std::size_t k, bool vertex, bool face, Values& values) {
        Point point(0, 0, 0);
        const auto next = [&](Type type) {
            const auto value = values.next(type);
            if (!value) cutOff(element.name, k, element.count);
            return *value;
        };
        for (const Property& property : element.properties) {
            if (!property.countType) {
                const double value = next(property.type);
                if (property.name == "x") point[0] = value;
                if (property.name == "y") point[1] = value;
                if (property.name == "z") point[2] = value;
                continue;
            }
            const bool corners =
                face && (property.name == "vertex_indices" || property.name == "vertex_index");
            const double count = next(*property.countType);
            if (!(count >= 0) || count > static_cast<double>(bytes_.size()))
                throw Error(element.name + " " + std::to_string(k), "its list has an impossible length",
                            "get the file anew");
            for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
                const double value = next(property.type);
                if (corners) soup_.corners.push_back(indexOf(value));
            }
        }
        if (vertex) {
            soup_.points.push_back(point);
            if (values.line() > 0) soup_.pointLines.push_back(values.line());
        }
        if (face) soup_.endFace(values.line());
    }

    /// Anything that is no index of a vertex is out of range.
    static std::int64_t indexOf(double value) {
        return value >= 0 && value < 9e15 ? static_cast<std::int64_t>(value) : -1;
    }

    std::string_view bytes_;
    TextLines lines_;
    std::string format_;
    std::vector<Element> elements_;
    Soup soup_;
};

} // namespace

Soup readPly(std::string_view bytes) {
    return PlyReader(bytes).read();
}

} // namespace qm
