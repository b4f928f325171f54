/// \file Random meshes, seeds and motorcycle graphs for tests of layouts.
#pragma once

#include "basecomplex/arc_graph.h"
#include "basecomplex/base_complex.h"
#include "check/mesh/neighbourhoods.h"
#include "layout/motorcycle_graph.h"

#include <optional>
#include <random>
#include <vector>

namespace qm::test {

[[nodiscard]] QuadMesh quadMesh(const check::CheckedMesh& mesh);

/// A small mesh: cubes, squares of the plane with holes, a torus, a tube, or squares glued together at
/// random. Nothing if the random choice is no mesh.
[[nodiscard]] std::optional<QuadMesh> randomMesh(std::mt19937& random);

/// Up to `max` seeds at regular vertices.
[[nodiscard]] std::vector<Seed> randomSeeds(const QuadMesh& mesh, std::size_t max, std::mt19937& random);

/// The tracks of particles that take a random time for every edge and stop where another one has been. Every
/// motorcycle graph is possible, not only the plain one.
[[nodiscard]] std::vector<Track> randomGraph(const QuadMesh& mesh, const BaseComplex& complex,
                                             const std::vector<double>& edgeCosts, std::mt19937& random);

/// Whether the arcs are a motorcycle graph of the whole mesh, by rules 1 to 4.
[[nodiscard]] bool isMotorcycleGraph(const ArcGraph& graph, const PresentArcs& present);

} // namespace qm::test
