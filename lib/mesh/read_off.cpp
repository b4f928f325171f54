#include "base/error.h"
#include "mesh/soup.h"
#include "mesh/text_lines.h"

namespace qm {
namespace {

class OffReader {
public:
    explicit OffReader(std::string_view text) : size_(text.size()), lines_(text) {}

    Soup read() {
        readHeader();
        const std::size_t points = readCount("vertices");
        const std::uint32_t line = lines_.lineNumber();
        const std::size_t faces = readCount("faces");
        // The number of edges says nothing and may be missing, unless every count has a line of its own.
        if (lines_.lineNumber() != line) lines_.wordAnywhere();
        // Every element takes two bytes at least: a count beyond that must not be allocated.
        soup_.points.reserve(std::min(points, size_ / 2));
        soup_.corners.reserve(std::min(faces * 4, size_ / 2));
        for (std::size_t k = 0; k < points; ++k)
            readPoint(points);
        for (std::size_t k = 0; k < faces; ++k)
            readFace(faces);
        return std::move(soup_);
    }

private:
    /// OFF with any of ST, C and N before it, for texture, colours and normals; "4" and "n" change the
    /// dimension.
    void readHeader() {
        const std::string_view word = lines_.wordAnywhere();
        if (!word.ends_with("OFF"))
            throw Error(lines_.place(), "it does not begin with OFF", "is it another format?");
        if (word.starts_with('4') || word.starts_with('n'))
            throw Error(lines_.place(), "points of " + std::string(word) + " are not in three dimensions",
                        "write a plain OFF file");
        if (const std::string_view next = lines_.word(); next == "BINARY")
            throw Error(lines_.place(), "binary OFF is not understood", "write it as text, or as binary PLY");
        else if (!next.empty())
            pendingCount_ = next;
    }

    std::size_t readCount(const std::string& what) {
        const std::string_view word =
            pendingCount_.empty() ? lines_.wordAnywhere() : std::exchange(pendingCount_, {});
        const auto count = parseNumber<std::int64_t>(word);
        if (!count || *count < 0)
            throw Error(lines_.place(), "the number of " + what + " is missing", "mend the header");
        return static_cast<std::size_t>(*count);
    }

    [[noreturn]] void cutOff(const std::string& what, std::size_t found, std::size_t announced) const {
        throw Error(lines_.place(),
                    "the file ends after " + std::to_string(found) + " " + what + ", its header says " +
                        std::to_string(announced),
                    "the file seems to be cut off; get it whole");
    }

    /// Three numbers; what else is on the line of the last of them, colours say, is passed over.
    void readPoint(std::size_t announced) {
        Point point;
        lines_.nextLine();
        for (unsigned k = 0; k < 3; ++k) {
            const std::string_view word = lines_.wordAnywhere();
            if (word.empty()) cutOff("vertices", soup_.points.size(), announced);
            const auto value = parseNumber<double>(word);
            if (!value)
                throw Error(lines_.place(),
                            "vertex " + std::to_string(soup_.points.size()) + ": \"" +
                                std::string(word.substr(0, 20)) + "\" is no number",
                            "mend the line");
            point[k] = *value;
        }
        soup_.points.push_back(point);
        soup_.pointLines.push_back(lines_.lineNumber());
    }

    void readFace(std::size_t announced) {
        lines_.nextLine();
        const std::size_t face = soup_.faceCount();
        const std::int64_t count = readIndex(announced);
        const std::uint32_t line = lines_.lineNumber();
        if (count < 0 || static_cast<std::size_t>(count) > size_)
            throw Error(lines_.place(), "face " + std::to_string(face) + " cannot have that many vertices",
                        "mend the line");
        for (std::int64_t k = 0; k < count; ++k)
            soup_.corners.push_back(readIndex(announced));
        soup_.endFace(line);
    }

    std::int64_t readIndex(std::size_t announced) {
        const std::string_view word = lines_.wordAnywhere();
        if (word.empty()) cutOff("faces", soup_.faceCount(), announced);
        const auto index = parseNumber<std::int64_t>(word);
        if (!index)
            throw Error(lines_.place(),
                        "face " + std::to_string(soup_.faceCount()) + ": \"" +
                            std::string(word.substr(0, 20)) + "\" is no whole number",
                        "mend the line");
        return *index;
    }

    std::size_t size_;
    TextLines lines_;
    std::string_view pendingCount_;
    Soup soup_;
};

} // namespace

Soup readOff(std::string_view text) {
    return OffReader(text).read();
}

} // namespace qm
