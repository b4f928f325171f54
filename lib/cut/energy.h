/// \file The energy of a two-way cut (docs/METHOD.md#mesh-cut), after Golovinskiy and Funkhouser 2008
/// (docs/METHOD.md#golovinskiy-2008).
#pragma once

#include "cut/cut.h"
#include "cut/min_cut.h"
#include "cut/surface_distances.h"
#include "cut/terminals.h"

#include <vector>

namespace qm {

/// Sets up E(L) = sum of G_p(L_p) + lambda * (edges whose ends differ) for one sub-mesh after another. If
/// features are to be avoided, the weight of an edge is multiplied by 1 + Wh * theta / (pi / 2), where theta
/// is the sharpest dihedral angle at either end; at a right angle the edge costs as much as a misplaced
/// vertex.
class Energy {
public:
    /// \param labels  sub-mesh of every vertex; may change between calls
    Energy(const QuadMesh& mesh, const std::vector<double>& dihedralAngles, const CutOptions& options,
           const std::vector<SubMeshId>& labels);

    /// \param vertices       of the sub-mesh; they become the nodes, in this order
    /// \param extraordinary  the extraordinary ones of these vertices
    /// \param distances      for the same labels
    [[nodiscard]] CutProblem operator()(const std::vector<VertexId>& vertices,
                                        const std::vector<VertexId>& extraordinary,
                                        const TerminalPair& terminals, SurfaceDistances& distances);

private:
    [[nodiscard]] double penalty(double nearness) const;
    [[nodiscard]] double capacity(VertexId a, VertexId b) const;

    const QuadMesh& mesh_;
    CutOptions options_;
    const std::vector<SubMeshId>& labels_;
    /// Largest dihedral angle at every vertex; empty unless features are avoided.
    std::vector<double> sharpest_;
    std::vector<int> node_; ///< of every vertex of the present sub-mesh
};

} // namespace qm
