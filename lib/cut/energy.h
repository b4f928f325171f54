/// \file The energy of a two-way cut (docs/METHOD.md#mesh-cut), after Golovinskiy and Funkhouser 2008
/// (docs/METHOD.md#golovinskiy-2008).
#pragma once

#include "cut/cut.h"
#include "cut/min_cut.h"
#include "cut/surface_distances.h"
#include "cut/terminals.h"

#include <vector>

namespace qm {

/// Sets up E(L) = sum of G_p(L_p) + lambda * (edges whose ends differ) for one sub-mesh after the other. When
/// features are to be avoided, an edge with a sharp edge at one of its ends counts 1 + Wh * theta / (pi / 2)
/// times, theta being the angle of the sharpest there; at a right angle that is as much as a misplaced vertex
/// costs.
class Energy {
public:
    /// \param labels  sub-mesh of every vertex; may change between calls
    Energy(const QuadMesh& mesh, const std::vector<double>& dihedralAngles, const CutOptions& options,
           const std::vector<SubMeshId>& labels);

    /// \param vertices       of the sub-mesh: they become the nodes, in this order
    /// \param extraordinary  vertices among them
    /// \param distances      on the same labels
    [[nodiscard]] CutProblem operator()(const std::vector<VertexId>& vertices,
                                        const std::vector<VertexId>& extraordinary,
                                        const TerminalPair& terminals, SurfaceDistances& distances);

private:
    [[nodiscard]] double penalty(double nearness) const;
    [[nodiscard]] double capacity(VertexId a, VertexId b) const;

    const QuadMesh& mesh_;
    CutOptions options_;
    const std::vector<SubMeshId>& labels_;
    std::vector<double> sharpest_; ///< edge at every vertex; empty unless features are to be avoided
    std::vector<int> node_;        ///< of every vertex of the sub-mesh at hand
};

} // namespace qm
