#include "base/at.h"
#include "base/number_text.h"
#include "mesh/files/text_lines.h"
#include "mesh/soup/soup.h"

#include <algorithm>
#include <utility>

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
        // The number of edges is not needed, and may be missing unless every count has a line of its own.
        if (lines_.lineNumber() != line || !lines_.lineIsEmpty()) lines_.wordAnywhere();
        // Usually every element has a line of its own, so that colours can be recognised; some files have no
        // line breaks at all.
        hasLines_ = lines_.lineIsEmpty();
        // Every number takes at least two bytes, which limits the memory that a wrong count can claim.
        soup_.points.reserve(std::min(points, size_ / 6));
        soup_.corners.reserve(4 * std::min(faces, size_ / 8));
        for (std::size_t k = 0; k < points; ++k)
            readPoint(points);
        for (std::size_t k = 0; k < faces; ++k)
            readFace(faces);
        checkEnd(faces);
        return std::move(soup_);
    }

private:
    /// Reads the optional word OFF, with any of ST, C and N before it for texture, colours and normals; "4"
    /// and "n" change the dimension.
    void readHeader() {
        const std::string_view word = lines_.wordAnywhere();
        if (readFileNumber<std::int64_t>(word)) {
            pendingCount_ = word;
            return;
        }
        if (!word.ends_with("OFF")) lines_.fail("it does not begin with OFF", "Is it another format?");
        if (word.find_first_of("4n") != std::string_view::npos)
            lines_.fail("points of " + inQuotes(word) + " are not in three dimensions",
                        "Write a plain OFF file");
        if (const std::string_view next = lines_.word(); next == "BINARY")
            lines_.fail("binary OFF is not understood", "Write it as text, or as binary PLY");
        else if (!next.empty())
            pendingCount_ = next;
    }

    std::size_t readCount(const std::string& what) {
        const std::string_view word =
            pendingCount_.empty() ? lines_.wordAnywhere() : std::exchange(pendingCount_, {});
        const auto count = readFileNumber<std::int64_t>(word);
        if (!count || *count < 0) lines_.fail("the number of " + what + " is missing", "Correct the header");
        return at(*count);
    }

    /// \param found  the elements before it, with their number
    [[noreturn]] void cutOff(const std::string& found, std::size_t announced) const {
        lines_.fail("the file ends after " + found + ", its header says " + std::to_string(announced),
                    cutOffHint);
    }

    void beginElement() {
        if (hasLines_) lines_.nextLine();
    }

    /// Reads three coordinates; the rest of the line, such as colours, is ignored.
    void readPoint(std::size_t announced) {
        Point point;
        beginElement();
        for (unsigned k = 0; k < 3; ++k) {
            const std::string_view word = lines_.wordAnywhere();
            if (word.empty()) cutOff(countText(soup_.points.size(), "vertex", "vertices"), announced);
            const auto value = readFileNumber<double>(word);
            if (!value)
                lines_.fail("vertex " + std::to_string(soup_.points.size()) + ": " + inQuotes(word) +
                            " is no number");
            point[k] = *value;
        }
        soup_.points.push_back(point);
        soup_.pointLines.push_back(lines_.lineNumber());
    }

    void readFace(std::size_t announced) {
        beginElement();
        const std::int64_t count = readIndex(announced);
        const std::uint32_t line = lines_.lineNumber();
        if (count < 0 || at(count) > size_)
            lines_.fail("face " + std::to_string(soup_.faceCount()) + " cannot have that many vertices");
        for (std::int64_t k = 0; k < count; ++k)
            soup_.corners.push_back(readIndex(announced));
        soup_.endFace(line);
    }

    std::int64_t readIndex(std::size_t announced) {
        const std::string_view word = lines_.wordAnywhere();
        if (word.empty()) cutOff(countText(soup_.faceCount(), "face"), announced);
        const auto index = readFileNumber<std::int64_t>(word);
        if (!index)
            lines_.fail("face " + std::to_string(soup_.faceCount()) + ": " + inQuotes(word) +
                        " is no whole number");
        return *index;
    }

    /// Throws if more elements follow than announced, because they would be lost.
    void checkEnd(std::size_t announced) {
        beginElement();
        if (!lines_.wordAnywhere().empty())
            lines_.fail("the file goes on after the " + countText(announced, "face") +
                            " that its header announces",
                        "Correct the counts in the header");
    }

    std::size_t size_;
    TextLines lines_;
    std::string_view pendingCount_;
    bool hasLines_ = true;
    Soup soup_;
};

} // namespace

Soup readOff(std::string_view text) {
    return OffReader(text).read();
}

} // namespace qm
