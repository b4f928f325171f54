/// \file The single steps of repairing a soup of quads; each is implemented in a file of its own: fans, weld,
/// soup_edit.
#pragma once

#include "mesh/soup/soup_edges.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace qm {

// ---- soup_edit.cpp

/// Extends a list of numbers in the file, which may be implicit, to the given length.
void writeDown(std::vector<std::uint32_t>& numbers, std::size_t count);

/// Keeps the faces marked true, in their order.
/// \return the number of faces removed
std::size_t keepFaces(Soup& soup, const std::vector<bool>& kept);

/// Replaces every vertex k by vertex `target[k]`, which must not be above k and must be its own target.
/// Removes the replaced vertices; all others keep their order.
/// \return the number of vertices removed
std::size_t mergePoints(Soup& soup, const std::vector<std::size_t>& target);

// ---- fans.cpp

/// Visits every fan once: a maximal sequence of quads around a vertex, each beside the next. Open fans come
/// first, then closed ones.
/// \param twins  of a consistently oriented soup (see `twinSides`)
/// \param visit  receives the corners of the fan, which all lie at one vertex
void forEachFan(const std::vector<Side>& twins, const std::function<void(std::span<const Side>)>& visit);

/// Gives every fan except the first one at a vertex its own copy of the vertex, appended at the end. At edges
/// of more than two quads, those are neighbours that bound the same solid (see `pairsAroundSolids`), or,
/// where these would go on sharing the edge, the same space outside; vertices on edges where as many quads do
/// not run one way as the other are left alone.
/// \return the number of vertices that had several fans
std::size_t splitFans(Soup& soup);

// ---- weld.cpp: for soups of quads with four different vertices, indices in range and finite coordinates.
// Two points lie at the same place if no coordinate differs by more than 1e-9 of the longest side of the
// faces' bounding box.

/// For every vertex, the lowest vertex to which it may be welded: at the same place, both on a border, and
/// not the two ends of a side. Vertices that share a place for another reason, such as interior ones, are
/// left alone, because welding them would only damage the surface.
[[nodiscard]] std::vector<std::size_t> weldTargets(const Soup& soup);

/// The quads to collapse because two opposite corners, at least one of them interior, lie at the same place.
struct Collapses {
    std::vector<bool> faceStays;
    std::vector<std::size_t> target; ///< for every vertex, its replacement
};

/// Only collapses that keep the surface a manifold, and no two next to each other.
[[nodiscard]] Collapses findCollapses(const Soup& soup);

} // namespace qm
