#include "mesh/files/ply_header.h"

#include "base/at.h"

#include <algorithm>
#include <array>
#include <string>
#include <unordered_set>
#include <utility>

namespace qm {
namespace {

class HeaderReader {
public:
    explicit HeaderReader(TextLines& lines) : lines_(lines) {}

    PlyHeader read() {
        lines_.nextLine();
        if (lines_.word() != "ply") fail("it does not begin with ply", "Is it another format?");
        while (lines_.nextLine()) {
            const std::string_view keyword = lines_.word();
            if (keyword == "format") readFormat();
            if (keyword == "element") readElement();
            if (keyword == "property") readProperty();
            if (keyword != "end_header") continue;
            check();
            return std::move(header_);
        }
        fail("the header has no end", "Use a complete copy");
    }

private:
    static constexpr const char* correct = "Correct the header";

    [[noreturn]] void fail(const std::string& what, const char* remedy = correct) const {
        lines_.fail(what, remedy);
    }

    void readFormat() {
        if (hasFormat_) fail("the header names a format twice");
        const std::string_view name = lines_.word();
        if (name == "ascii") {
            header_.format = PlyFormat::ascii;
        } else if (name == "binary_little_endian") {
            header_.format = PlyFormat::littleEndian;
        } else if (name == "binary_big_endian") {
            header_.format = PlyFormat::bigEndian;
        } else {
            fail("format " + inQuotes(name) + " is not understood", "Write it as ascii or binary PLY");
        }
        hasFormat_ = true;
    }

    void readElement() {
        PlyElement element;
        element.name = lines_.word();
        const auto count = readFileNumber<std::int64_t>(lines_.word());
        if (!count || *count < 0) fail("the element has no count");
        element.count = at(*count);
        if (!names_.insert(element.name).second) fail("element " + inQuotes(element.name) + " occurs twice");
        header_.elements.push_back(std::move(element));
    }

    void readProperty() {
        if (header_.elements.empty()) fail("a property comes before any element");
        PlyProperty property;
        std::string_view word = lines_.word();
        if (word == "list") {
            property.countType = readType(lines_.word());
            if (*property.countType >= PlyType::float32) fail("the length of a list is no whole number");
            word = lines_.word();
        }
        property.type = readType(word);
        property.role = roleOf(property, lines_.word());
        header_.elements.back().properties.push_back(property);
    }

    [[nodiscard]] PlyType readType(std::string_view word) const {
        // Each type has two names, listed in pairs in the order of PlyType.
        constexpr std::array<std::string_view, 16> names{
            "char", "int8",  "uchar", "uint8",  "short", "int16",   "ushort", "uint16",
            "int",  "int32", "uint",  "uint32", "float", "float32", "double", "float64"};
        const auto found = std::ranges::find(names, word);
        if (found == names.end()) fail(inQuotes(word) + " is no type");
        return static_cast<PlyType>((found - names.begin()) / 2);
    }

    [[nodiscard]] PlyRole roleOf(const PlyProperty& property, std::string_view name) const {
        const std::string& element = header_.elements.back().name;
        if (element == "vertex" && !property.countType) {
            if (name == "x") return PlyRole::x;
            if (name == "y") return PlyRole::y;
            if (name == "z") return PlyRole::z;
        }
        if (property.countType && (name == "vertex_indices" || name == "vertex_index")) {
            if (element == "face") return PlyRole::corners;
            if (element == "tristrips") return PlyRole::strips;
        }
        return PlyRole::other;
    }

    void check() const {
        if (!hasFormat_) fail("the header names no format");
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex")
                for (const PlyRole role : {PlyRole::x, PlyRole::y, PlyRole::z})
                    requireOne(element, role, "the vertices do not have one x, y and z each");
            if (element.name == "face")
                requireOne(element, PlyRole::corners, "the faces do not have one list vertex_indices each");
            if (element.name == "tristrips")
                requireOne(element, PlyRole::strips, "the strips do not have one list vertex_indices each");
        }
    }

    void requireOne(const PlyElement& element, PlyRole role, const char* otherwise) const {
        if (element.count > 0 && std::ranges::count(element.properties, role, &PlyProperty::role) != 1)
            fail(otherwise);
    }

    TextLines& lines_;
    PlyHeader header_;
    std::unordered_set<std::string> names_; ///< of the elements
    bool hasFormat_ = false;
};

} // namespace

PlyHeader readPlyHeader(TextLines& lines) {
    return HeaderReader(lines).read();
}

} // namespace qm
