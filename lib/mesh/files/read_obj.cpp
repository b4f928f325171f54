#include "base/error.h"
#include "base/number_text.h"
#include "mesh/files/text_lines.h"
#include "mesh/soup/soup.h"

#include <algorithm>
#include <utility>

namespace qm {
namespace {

class ObjReader {
public:
    ObjReader(std::string_view text, std::size_t sides)
        : lines_(text, Backslash::joinsLines), sides_(sides) {}

    Soup read() {
        soup_.firstIndex = 1;
        while (lines_.nextLine()) {
            const std::string_view keyword = lines_.word();
            if (keyword == "v") readPoint();
            if (keyword == "f") readFace();
        }
        return std::move(soup_);
    }

private:
    /// Reads three coordinates; weights or colours after them are ignored.
    void readPoint() {
        const std::uint32_t line = lines_.lineNumber();
        Point point;
        for (unsigned k = 0; k < 3; ++k) {
            const std::string_view word = lines_.word();
            const auto value = readFileNumber<double>(word);
            if (!value)
                lines_.fail("vertex " + std::to_string(soup_.points.size()) +
                                (word.empty() ? " has fewer than three coordinates"
                                              : ": " + inQuotes(word) + " is no number"),
                            lines_.unfinished() ? cutOffHint : "Correct the line");
            point[k] = *value;
        }
        soup_.points.push_back(point);
        soup_.pointLines.push_back(line);
    }

    void readFace() {
        const std::uint32_t line = lines_.lineNumber();
        const std::size_t face = soup_.faceCount();
        for (std::string_view word = lines_.word(); !word.empty(); word = lines_.word())
            soup_.corners.push_back(cornerOf(word));
        soup_.endFace(line);
        // If it is like the face before, the model has such faces.
        const std::size_t expected = face == 0 ? sides_ : std::min(sides_, soup_.face(face - 1).size());
        if (lines_.unfinished() && soup_.face(face).size() < expected)
            throw Error(soup_.facePlace(face),
                        "the last line ends after " + countText(soup_.face(face).size(), "corner"),
                        cutOffHint);
    }

    /// Reads "7", "7/1", "7//2" or "7/1/2"; numbers count from 1 or, if negative, back from the last vertex.
    std::int64_t cornerOf(std::string_view word) const {
        const auto index = readFileNumber<std::int64_t>(word.substr(0, word.find('/')));
        if (!index || *index == 0)
            lines_.fail("face " + std::to_string(soup_.faceCount()) + ": " + inQuotes(word) +
                            " is no vertex index",
                        lines_.unfinished() ? cutOffHint : "Correct the line; indices count from 1");
        const auto points = static_cast<std::int64_t>(soup_.points.size());
        if (*index < -points)
            lines_.fail("face " + std::to_string(soup_.faceCount()) + ": vertex index " +
                        std::to_string(*index) + " is out of range: there are " + std::to_string(points) +
                        " vertices before it");
        return *index > 0 ? *index - 1 : points + *index;
    }

    TextLines lines_;
    std::size_t sides_;
    Soup soup_;
};

} // namespace

Soup readObj(std::string_view text, std::size_t sides) {
    if (text.ends_with('\0')) text.remove_suffix(1); // some programs write the end of their string, too
    // Unknown statements are passed over, so lines would be lost where zeros have taken their place.
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
        TextLines lines(text.substr(0, zero + 1));
        while (lines.nextLine()) {
        }
        lines.fail("it holds a zero byte, as no text does",
                   "The file seems to be damaged, or is in UTF-16. Use another copy, or save it as UTF-8");
    }
    return ObjReader(text, sides).read();
}

} // namespace qm
