#include "mesh/files/write_soup.h"

#include "base/at.h"
#include "base/bytes.h"
#include "base/number_text.h"
#include "mesh/quad_geometry.h"

#include <algorithm>
#include <limits>

namespace qm {
namespace {

void appendPoint(std::string& text, const Point& point) {
    for (unsigned k = 0; k < 3; ++k) {
        if (k > 0) text += ' ';
        appendNumber(text, point[k]);
    }
    text += '\n';
}

/// \param first  the number of the first point in the format
void appendCorners(std::string& text, std::span<const std::int64_t> corners, std::int64_t first) {
    for (const std::int64_t corner : corners) {
        text += ' ';
        appendNumber(text, corner + first);
    }
    text += '\n';
}

std::string asObj(const Soup& soup) {
    std::string text = objPoints(soup);
    for (std::size_t k = 0; k < soup.faceCount(); ++k)
        appendObjFace(text, soup.face(k));
    return text;
}

std::string asOff(const Soup& soup) {
    std::string text = "OFF\n";
    appendNumber(text, soup.points.size());
    appendNumber(text += ' ', soup.faceCount());
    text += " 0\n";
    for (const Point& point : soup.points)
        appendPoint(text, point);
    for (std::size_t k = 0; k < soup.faceCount(); ++k) {
        appendNumber(text, soup.face(k).size());
        appendCorners(text, soup.face(k), 0);
    }
    return text;
}

std::string asPly(const Soup& soup) {
    std::string bytes = plyPoints(soup);
    for (std::size_t k = 0; k < soup.faceCount(); ++k)
        appendPlyFace(bytes, soup.face(k));
    return bytes;
}

std::string asStl(const Soup& soup) {
    constexpr std::size_t headerSize = 80;
    std::string bytes = "binary STL";
    bytes.resize(headerSize, ' ');
    appendBytes(bytes, static_cast<std::uint32_t>(soup.faceCount()));
    const auto append = [&](const Point& vector) {
        for (const double coordinate : vector)
            appendBytes(bytes, static_cast<float>(coordinate));
    };
    for (std::size_t k = 0; k < soup.faceCount(); ++k) {
        const auto corner = [&](std::size_t n) -> const Point& { return soup.points[at(soup.face(k)[n])]; };
        const Point normal = (corner(1) - corner(0)) % (corner(2) - corner(0));
        append(normal / std::max(normal.norm(), std::numeric_limits<double>::min()));
        for (std::size_t n = 0; n < 3; ++n)
            append(corner(n));
        appendBytes(bytes, std::uint16_t{0});
    }
    return bytes;
}

} // namespace

std::string writeSoup(const Soup& soup, MeshFormat format) {
    switch (format) {
    case MeshFormat::obj:
        return asObj(soup);
    case MeshFormat::off:
        return asOff(soup);
    case MeshFormat::ply:
        return asPly(soup);
    case MeshFormat::stl:
        break;
    }
    return asStl(soup);
}

std::string objPoints(const Soup& soup) {
    std::string text;
    text.reserve(soup.points.size() * 60 + soup.corners.size() * 8);
    for (const Point& point : soup.points)
        appendPoint(text += "v ", point);
    return text;
}

void appendObjFace(std::string& text, std::span<const std::int64_t> corners) {
    appendCorners(text += 'f', corners, 1);
}

std::string plyPoints(const Soup& soup, std::string_view furtherProperties) {
    std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex ";
    appendNumber(bytes, soup.points.size());
    bytes += "\nproperty double x\nproperty double y\nproperty double z\nelement face ";
    appendNumber(bytes, soup.faceCount());
    bytes += "\nproperty list uchar int vertex_indices\n";
    bytes += furtherProperties;
    bytes += "end_header\n";
    for (const Point& point : soup.points)
        for (const double coordinate : point)
            appendBytes(bytes, coordinate);
    return bytes;
}

void appendPlyFace(std::string& bytes, std::span<const std::int64_t> corners) {
    appendBytes(bytes, static_cast<std::uint8_t>(corners.size()));
    for (const std::int64_t corner : corners)
        appendBytes(bytes, static_cast<std::int32_t>(corner));
}

Soup soupOf(const QuadMesh& mesh) {
    Soup soup;
    for (const VertexId vertex : mesh.vertices())
        soup.points.push_back(mesh.point(vertex));
    for (const FaceId face : mesh.faces()) {
        for (const VertexId corner : cornersOf(mesh, face))
            soup.corners.push_back(corner.idx());
        soup.endFace(0);
    }
    return soup;
}

Soup soupOf(const Triangles& triangles) {
    Soup soup;
    soup.points = triangles.points;
    for (const auto& face : triangles.faces)
        soup.addFace(face);
    return soup;
}

std::string writeObj(const QuadMesh& mesh) {
    return writeSoup(soupOf(mesh), MeshFormat::obj);
}

} // namespace qm
