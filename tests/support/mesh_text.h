/// \file Looking into meshes, and making the bytes of mesh files.
#pragma once

#include "mesh/quad_mesh.h"

#include <array>
#include <string>
#include <vector>

namespace qm::testing {

using FaceIndices = std::array<int, 4>;

[[nodiscard]] std::vector<Point> pointsOf(const QuadMesh& mesh);
/// The corners of every face, beginning with the first of the file.
[[nodiscard]] std::vector<FaceIndices> facesOf(const QuadMesh& mesh);

/// The largest distance between points with the same number.
[[nodiscard]] double largestDistance(const QuadMesh& a, const QuadMesh& b);

/// Fails the test unless all links between halfedges, edges, faces and vertices fit, every face is a quad,
/// every vertex has one fan and boundary vertices know it.
void expectConsistent(const QuadMesh& mesh);

/// Bytes of a binary file of either byte order.
class BinaryText {
public:
    explicit BinaryText(bool littleEndian) : littleEndian_(littleEndian) {}
    /// \param type  "uchar", "int16", "float" and so on, as PLY names them
    void put(const std::string& type, double value);

    std::string bytes;

private:
    template <class Number> void putAs(double value);
    bool littleEndian_;
};

} // namespace qm::testing
