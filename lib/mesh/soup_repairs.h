/// \file What repairs a soup of quads, step by step, each in a source of its own: fans, orientation, weld,
/// soup_edit.
#pragma once

#include "mesh/soup_edges.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace qm {

// ---- soup_edit.cpp

/// Keeps the faces whose entry is true, in their order.
/// \return how many went
std::size_t keepFaces(Soup& soup, const std::vector<bool>& kept);

/// Replaces every vertex k by vertex `target[k]`, which is not above k and its own target. Replaced ones
/// go; the others move up in their order.
/// \return how many went
std::size_t mergePoints(Soup& soup, const std::vector<std::size_t>& target);

// ---- orientation.cpp

struct Orientation {
    /// For every quad whether it must be reversed so that neighbours agree: the fewer of each component, and
    /// if it is a tie, not the component's first.
    std::vector<bool> reversed;
    /// The first quad that cannot agree with all its neighbours: the surface has one side only.
    std::optional<std::size_t> contradiction;
};

/// Quads are neighbours where just two meet at an edge.
/// \param twins  see `twinSides`
[[nodiscard]] Orientation findOrientation(const Soup& soup, const std::vector<Side>& twins);

// ---- fans.cpp

/// Visits every fan once: a maximal run of quads around a vertex, each beside the next. Open fans come first,
/// then those that are closed.
/// \param twins  of a consistently oriented soup (see `twinSides`)
/// \param visit  takes the corners of the fan, which are all at one vertex
void forEachFan(const std::vector<Side>& twins, const std::function<void(std::span<const Side>)>& visit);

/// Gives every fan but the first at its vertex a vertex of its own, at the same place, behind all others.
/// Vertices on edges of more than two quads are left alone.
/// \return how many vertices had several fans
std::size_t splitFans(Soup& soup);

// ---- weld.cpp: of a soup whose polygons are quads of four different vertices, with indices in range and
// finite coordinates. Two points lie at the same place if no coordinate differs by more than 1e-9 of the
// longest side of the faces' bounding box.

/// For every vertex the lowest one it may be welded to: at the same place, both on the border of some
/// face that has no neighbour there, and not the two ends of a side. Vertices that lie at one place for
/// another reason, interior ones say, are left alone: welding them would only make the surface worse.
[[nodiscard]] std::vector<std::size_t> weldTargets(const Soup& soup);

/// Quads to be collapsed because two opposite corners, at least one of them interior, lie at the same place.
struct Collapses {
    std::vector<bool> faceStays;
    std::vector<std::size_t> target; ///< for every vertex the one it becomes
};

/// Only where the surface stays a manifold, and no two next to each other.
[[nodiscard]] Collapses findCollapses(const Soup& soup);

} // namespace qm
