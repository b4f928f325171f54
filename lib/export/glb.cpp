#include "base/at.h"
#include "base/bytes.h"
#include "base/error.h"
#include "bspline/splines/evaluate.h"
#include "export/quads.h"
#include "mesh/bounding_box.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace qm {
namespace {

using Json = nlohmann::ordered_json;

/// glTF has single precision.
float single(double coordinate) {
    if (std::abs(coordinate) > std::numeric_limits<float>::max())
        throw Error("mesh", "has coordinates that are too large for glTF", "Scale the model");
    return static_cast<float>(coordinate);
}

/// The coordinates of a mesh that is farther than this away from the origin, in its diagonals, begin at its
/// centre: single precision would round its places away.
constexpr double farAway = 10;

Point originFor(const QuadMesh& mesh) {
    const BoundingBox box = boundingBox(mesh);
    return box.centre().norm() > farAway * box.diagonal() ? box.centre() : Point(0, 0, 0);
}

/// glTF has 32 bits for the number of a vertex and for the size of the file.
std::uint32_t in32Bits(std::size_t number) {
    if (number > std::numeric_limits<std::uint32_t>::max())
        throw Error("mesh", "is too large for glTF", "Export it as PLY");
    return static_cast<std::uint32_t>(number);
}

/// A part of an sRGB colour in proportion to the light, as glTF has the colours of vertices.
std::uint8_t linear(std::uint8_t part) {
    const double share = part / 255.0;
    return static_cast<std::uint8_t>(
        std::lround(255 * (share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4))));
}

/// The one buffer of the file, and the JSON text that explains it. Every segment has its own vertices, so
/// that colours and normals end at its border.
class Builder {
public:
    /// \param origin  of the coordinates
    explicit Builder(const Point& origin) : origin_(origin) {}

    void add(const QuadMesh& mesh, const Segment& segment, const Colour& colour) {
        const auto vertices = vertexGrid(mesh, segment);
        const std::size_t width = at(segment.size[0]) + 1;
        (void)in32Bits(vertexCount_ + vertices.size());
        const auto first = static_cast<std::uint32_t>(vertexCount_);
        addVertices(mesh, vertices, width, colour);
        for (std::size_t j = 0; j + width + 1 < vertices.size(); j += width)
            for (std::size_t i = 0; i + 1 < width; ++i) {
                const auto corner = first + static_cast<std::uint32_t>(j + i);
                const auto above = corner + static_cast<std::uint32_t>(width);
                for (const std::uint32_t index : {corner, corner + 1, above + 1, corner, above + 1, above})
                    appendBytes(indices_, index);
            }
        ranges_.push_back(indices_.size());
        vertexCount_ += vertices.size();
    }

    [[nodiscard]] std::string file() const {
        std::string text = json().dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        const std::size_t size = positions_.size() + normals_.size() + colours_.size() + indices_.size();
        std::string bytes = "glTF";
        appendBytes(bytes, std::uint32_t{2});
        appendBytes(bytes, in32Bits(12 + 8 + text.size() + 8 + size));
        appendBytes(bytes, static_cast<std::uint32_t>(text.size()));
        bytes += "JSON" + text;
        appendBytes(bytes, static_cast<std::uint32_t>(size));
        bytes.append("BIN\0", 4);
        return bytes + positions_ + normals_ + colours_ + indices_;
    }

private:
    void addVertices(const QuadMesh& mesh, const std::vector<VertexId>& vertices, std::size_t width,
                     const Colour& colour) {
        const std::size_t height = vertices.size() / width;
        const auto point = [&](std::size_t i, std::size_t j) { return mesh.point(vertices[j * width + i]); };
        for (std::size_t j = 0; j < height; ++j)
            for (std::size_t i = 0; i < width; ++i) {
                const Point alongU = point(std::min(i + 1, width - 1), j) - point(i > 0 ? i - 1 : 0, j);
                const Point alongV = point(i, std::min(j + 1, height - 1)) - point(i, j > 0 ? j - 1 : 0);
                // glTF asks for unit vectors.
                const Point normal = unitNormal(alongU, alongV).value_or(Point(0, 0, 1));
                const Point place = point(i, j) - origin_;
                for (unsigned k = 0; k < 3; ++k) {
                    const float coordinate = single(place[k]);
                    low_[k] = std::min(low_[k], coordinate);
                    high_[k] = std::max(high_[k], coordinate);
                    appendBytes(positions_, coordinate);
                    appendBytes(normals_, static_cast<float>(normal[k]));
                    appendBytes(colours_, linear(colour[k]));
                }
                appendBytes(colours_, std::uint8_t{255});
            }
    }

    /// \param component  5121, 5125 or 5126: bytes, 32 bit integers or floating point numbers
    static Json accessor(int view, std::size_t offset, int component, std::size_t count, const char* type) {
        return {{"bufferView", view},
                {"byteOffset", offset},
                {"componentType", component},
                {"count", count},
                {"type", type}};
    }

    [[nodiscard]] Json accessors() const {
        Json positions = accessor(0, 0, 5126, vertexCount_, "VEC3");
        positions["min"] = low_;
        positions["max"] = high_;
        Json colours = accessor(2, 0, 5121, vertexCount_, "VEC4");
        colours["normalized"] = true;
        Json all{std::move(positions), accessor(1, 0, 5126, vertexCount_, "VEC3"), std::move(colours)};
        for (std::size_t begin = 0; const std::size_t end : ranges_) {
            all.push_back(accessor(3, begin, 5125, (end - begin) / sizeof(std::uint32_t), "SCALAR"));
            begin = end;
        }
        return all;
    }

    [[nodiscard]] Json json() const {
        Json root{{"asset", {{"version", "2.0"}, {"generator", "qm-export"}}}};
        if (ranges_.empty()) return root;
        Json segments = Json::array(), nodes = Json::array(), meshes = Json::array();
        for (std::size_t k = 0; k < ranges_.size(); ++k) {
            segments.push_back(k);
            nodes.push_back({{"name", "segment " + std::to_string(k)}, {"mesh", k}});
            meshes.push_back({{"primitives",
                               {{{"attributes", {{"POSITION", 0}, {"NORMAL", 1}, {"COLOR_0", 2}}},
                                 {"material", 0},
                                 {"indices", k + 3}}}}});
        }
        if (origin_ != Point(0, 0, 0)) {
            const std::size_t whole = nodes.size();
            nodes.push_back({{"name", "model"},
                             {"translation", {origin_[0], origin_[1], origin_[2]}},
                             {"children", std::exchange(segments, Json::array({whole}))}});
        }
        root["scene"] = 0;
        root["scenes"] = {{{"nodes", std::move(segments)}}};
        root["nodes"] = std::move(nodes);
        root["meshes"] = std::move(meshes);
        root["materials"] = {{{"doubleSided", true},
                              {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0.8}}}}};
        root["accessors"] = accessors();
        std::size_t offset = 0;
        for (const std::string* part : {&positions_, &normals_, &colours_, &indices_}) {
            root["bufferViews"].push_back({{"buffer", 0},
                                           {"byteOffset", offset},
                                           {"byteLength", part->size()},
                                           {"target", part == &indices_ ? 34963 : 34962}});
            offset += part->size();
        }
        root["buffers"] = {{{"byteLength", offset}}};
        return root;
    }

    Point origin_;
    std::string positions_;
    std::string normals_;
    std::string colours_;
    std::string indices_;
    std::vector<std::size_t> ranges_; ///< end of each segment's indices, in bytes
    std::size_t vertexCount_ = 0;
    std::array<float, 3> low_ = {INFINITY, INFINITY, INFINITY};
    std::array<float, 3> high_ = {-INFINITY, -INFINITY, -INFINITY};
};

} // namespace

std::string quadsAsGlb(const QuadMesh& mesh, const Layout& layout, const std::vector<Colour>& colours) {
    Builder builder(originFor(mesh));
    for (std::size_t s = 0; s < layout.segments.size(); ++s)
        builder.add(mesh, layout.segments[s], colours[s]);
    return builder.file();
}

} // namespace qm
