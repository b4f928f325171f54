/// \file Inspecting meshes, and making the bytes of mesh files.
#pragma once

#include "mesh/quad_mesh.h"

#include <array>
#include <string>
#include <vector>

namespace qm::test {

using FaceIndices = std::array<int, 4>;

[[nodiscard]] std::vector<Point> pointsOf(const QuadMesh& mesh);
/// The corners of every face, beginning with its first vertex in the file.
[[nodiscard]] std::vector<FaceIndices> facesOf(const QuadMesh& mesh);

/// The largest distance between points with the same number.
[[nodiscard]] double largestDistance(const QuadMesh& a, const QuadMesh& b);

/// Fails the test unless all links between halfedges, edges, faces and vertices agree, every face is a quad,
/// and every vertex has one fan, with its boundary halfedge if it lies on the boundary.
void expectConsistent(const QuadMesh& mesh);

/// Builds binary files of either byte order.
class BinaryText {
public:
    explicit BinaryText(bool littleEndian) : littleEndian_(littleEndian) {}
    /// \param type  in PLY's names: "uchar", "int16", "float" and so on
    void put(const std::string& type, double value);

    std::string bytes;

private:
    template <class Number> void putAs(double value);
    bool littleEndian_;
};

} // namespace qm::test
