/// \file The edges that separate regions (docs/METHOD.md#layout).
#pragma once

#include "base/at.h"
#include "layout/motorcycle_graph.h"
#include "mesh/quad_mesh.h"

#include <algorithm>
#include <span>
#include <vector>

namespace qm {

/// The mesh boundary, and the paths along edges that are added to it. The mesh must outlive this.
class Borders {
public:
    explicit Borders(const QuadMesh& mesh) : mesh_(&mesh), isBorder_(mesh.n_edges()) {
        for (const EdgeId edge : mesh.edges())
            isBorder_[at(edge)] = mesh.is_boundary(edge);
    }
    Borders(const QuadMesh& mesh, std::span<const Track> tracks) : Borders(mesh) {
        for (const Track& track : tracks)
            add(track.halfedges);
    }

    void add(HalfedgeId halfedge) { set(halfedge, true); }
    void add(const std::vector<HalfedgeId>& path) {
        for (const HalfedgeId halfedge : path)
            set(halfedge, true);
    }
    /// \param path  not on the mesh boundary
    void remove(const std::vector<HalfedgeId>& path) {
        for (const HalfedgeId halfedge : path)
            set(halfedge, false);
    }

    [[nodiscard]] bool isBorder(EdgeId edge) const { return isBorder_[at(edge)]; }
    [[nodiscard]] bool isBorder(HalfedgeId halfedge) const { return isBorder(mesh_->edge_handle(halfedge)); }

    /// Whether a border passes a vertex or ends there.
    [[nodiscard]] bool hasBorder(VertexId vertex) const {
        return std::ranges::any_of(mesh_->voh_range(vertex),
                                   [&](HalfedgeId leaving) { return isBorder(leaving); });
    }

private:
    void set(HalfedgeId halfedge, bool isBorder) { isBorder_[at(mesh_->edge_handle(halfedge))] = isBorder; }

    const QuadMesh* mesh_;
    std::vector<bool> isBorder_; ///< by edge
};

} // namespace qm
