/// \file Quads around one vertex.
#pragma once

#include "mesh/quad_mesh.h"

#include <array>

namespace qm::test {

/// Quads around vertex 0 in the plane z = 0, counter-clockwise; vertex 1 + k is the end of the k-th edge that
/// leaves vertex 0.
/// \param turn  the angle that all quads fill together, in degrees; at 360 they form a closed fan
[[nodiscard]] QuadMesh star(int quads, double turn = 360);

/// A closed fan of quads around vertex 0 inside two rings of quads, slightly bent. Vertex 1 + 2 k is the end
/// of the k-th edge that leaves vertex 0.
[[nodiscard]] QuadMesh bentFan(int quads);

/// A circle around the z axis.
struct FanRing {
    double radius = 0;
    double height = 0;
};

/// Triangles around vertex 0, which is on the z axis, each divided into three quads, and a ring of quads
/// around them.
/// \param rings  of the vertices at the ends of edges from vertex 0, in the middles of the triangles, on their
///               outline, and around that
[[nodiscard]] QuadMesh dividedFan(int triangles, double height, const std::array<FanRing, 4>& rings);

} // namespace qm::test
