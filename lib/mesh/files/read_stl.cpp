#include "base/bytes.h"
#include "base/error.h"
#include "mesh/files/text_lines.h"
#include "mesh/soup/soup.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace qm {
namespace {

/// Compares words regardless of case, because some programs write capitals.
bool isWord(std::string_view word, std::string_view keyword) {
    return std::ranges::equal(word, keyword, {},
                              [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
}

constexpr std::size_t headerSize = 84; // 80 bytes of arbitrary text and the number of facets
constexpr std::size_t facetSize = 50;  // normal, three points, two bytes of attributes

/// The size of a binary file according to its number of facets.
std::size_t announcedSize(std::string_view bytes) {
    return headerSize + facetSize * std::size_t{numberFrom<std::uint32_t>(bytes.substr(headerSize - 4))};
}

Soup readBinary(std::string_view bytes) {
    if (bytes.size() < headerSize) throw Error("", "the file ends within its header", cutOffHint);
    if (announcedSize(bytes) != bytes.size())
        throw Error("",
                    "it is no STL, or not whole: for the " +
                        std::to_string((announcedSize(bytes) - headerSize) / facetSize) +
                        " facets that its header announces it should have " +
                        std::to_string(announcedSize(bytes)) + " bytes, not " + std::to_string(bytes.size()),
                    "Use a complete copy");
    Soup soup;
    soup.points.reserve(3 * (bytes.size() / facetSize));
    for (std::size_t facet = headerSize; facet < bytes.size(); facet += facetSize) {
        for (std::size_t corner = 1; corner <= 3; ++corner) {
            const auto coordinate = [&](std::size_t k) -> double {
                return numberFrom<float>(bytes.substr(facet + 12 * corner + 4 * k));
            };
            soup.corners.push_back(static_cast<std::int64_t>(soup.points.size()));
            soup.points.emplace_back(coordinate(0), coordinate(1), coordinate(2));
        }
        soup.endFace(0);
    }
    return soup;
}

/// Reads any number of solids, each with its facets. Names and normals are ignored.
class TextStl {
public:
    explicit TextStl(std::string_view text) : lines_(text) {}

    Soup read() {
        for (std::string_view word = lines_.wordAnywhere(); !word.empty(); word = lines_.wordAnywhere()) {
            if (!isWord(word, "solid")) fail(word, "solid");
            readSolid();
        }
        return std::move(soup_);
    }

private:
    void readSolid() {
        lines_.nextLine(); // skips the name of the solid
        std::string_view word = lines_.wordAnywhere();
        for (; isWord(word, "facet"); word = lines_.wordAnywhere())
            readFacet();
        if (!isWord(word, "endsolid")) fail(word, "facet or endsolid");
        lines_.nextLine();
    }

    void readFacet() {
        expect("normal");
        for (int k = 0; k < 3; ++k)
            (void)lines_.wordAnywhere();
        expect("outer");
        expect("loop");
        const std::uint32_t line = lines_.lineNumber();
        std::string_view word = lines_.wordAnywhere();
        for (; isWord(word, "vertex"); word = lines_.wordAnywhere())
            readPoint();
        if (!isWord(word, "endloop")) fail(word, "vertex or endloop");
        expect("endfacet");
        soup_.endFace(line);
    }

    void readPoint() {
        Point point;
        for (unsigned k = 0; k < 3; ++k) {
            const std::string_view word = lines_.wordAnywhere();
            const auto value = readFileNumber<double>(word);
            if (!value) fail(word, "a number");
            point[k] = *value;
        }
        soup_.corners.push_back(static_cast<std::int64_t>(soup_.points.size()));
        soup_.points.push_back(point);
        soup_.pointLines.push_back(lines_.lineNumber());
    }

    void expect(std::string_view wanted) {
        if (const std::string_view word = lines_.wordAnywhere(); !isWord(word, wanted)) fail(word, wanted);
    }

    [[noreturn]] void fail(std::string_view found, std::string_view wanted) const {
        const std::string what = "expected " + std::string(wanted) + ", ";
        if (found.empty()) lines_.fail(what + "but the file ends", cutOffHint);
        lines_.fail(what + "found " + inQuotes(found),
                    lines_.unfinished() ? cutOffHint : "Correct the line, or use another copy of the file");
    }

    TextLines lines_;
    Soup soup_;
};

/// Binary files may begin with "solid", too; they are recognised by their size, or by bytes that no text has.
bool isText(std::string_view bytes) {
    if (!isWord(TextLines(bytes).wordAnywhere(), "solid")) return false;
    if (bytes.size() >= headerSize && announcedSize(bytes) == bytes.size()) return false;
    return bytes.substr(0, headerSize).find('\0') == std::string_view::npos;
}

} // namespace

Soup readStl(std::string_view bytes) {
    return isText(bytes) ? TextStl(bytes).read() : readBinary(bytes);
}

} // namespace qm
