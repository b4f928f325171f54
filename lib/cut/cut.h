/// \file Cutting the mesh into sub-meshes of bounded complexity (docs/METHOD.md#mesh-cut).
#pragma once

#include "base/control.h"
#include "base/id_vector.h"
#include "basecomplex/base_complex.h"
#include "mesh/quad_mesh.h"

#include <optional>
#include <vector>

namespace qm {

/// How source and sink of a two-way cut are chosen.
enum class Terminals {
    irregular, ///< centres of the two groups of extraordinary vertices (the paper's)
    farthest,  ///< the two vertices farthest apart
    box        ///< best of three cuts between opposite walls of the bounding box
};

struct CutOptions {
    double chi = 40;                            ///< a sub-mesh is cut while its quasi-complexity reaches this
    Terminals terminals = Terminals::irregular; ///< of every two-way cut
    double lambda = 1;                          ///< weight of cutting a mesh edge
    double highPenalty = 80;                    ///< Wh
    double lowPenalty = 1;                      ///< Wl
    double nearLimit = 0.4;                     ///< m1
    double farLimit = 0.5;                      ///< m2
    /// A severed edge counts the more, the sharper the edges at its ends: where they can, cuts cross features
    /// at one place and do not run along them.
    bool avoidFeatures = false;
};

struct SubMesh {
    double quasiComplexity = 0; ///< U = sum over its particles of log2(candidate stops)
    /// n_j among separatrices that start inside, up to the first vertex outside.
    std::size_t ordinaryJunctions = 0;
    std::optional<VertexId> source; ///< terminals of the cut that made it; none if it was never cut
    std::optional<VertexId> sink;
};

struct Cut {
    CutOptions options;
    std::vector<SubMeshId> labels; ///< of every vertex
    IdVector<SubMeshId, SubMesh> subMeshes;
};

/// Cuts until every sub-mesh has U < chi or does not get simpler, that is, no cut leaves both parts with a
/// smaller U; other terminals are tried before a sub-mesh is given up. Before a sub-mesh that is not
/// connected is cut, it is divided into its components; those without any particle are one sub-mesh. A
/// sub-mesh that is simple enough need not be connected. Sub-meshes are numbered by their lowest vertex;
/// isolated vertices belong to sub-mesh 0.
/// \param complex  base complex with the feature seeds
/// \param control  if it is stopped, what has been cut so far
[[nodiscard]] Cut cutMesh(const QuadMesh& mesh, const BaseComplex& complex,
                          const std::vector<double>& dihedralAngles, const CutOptions& options,
                          const Control& control = {});

/// U and n_j of every sub-mesh of a labelling, in one pass over the separatrices; terminals are left empty. A
/// particle that starts in a sub-mesh has as many candidate stops as its separatrix has arcs, when only
/// separatrices that start there count and each ends at the first vertex outside (a neighbouring vertex).
[[nodiscard]] IdVector<SubMeshId, SubMesh> measureSubMeshes(const QuadMesh& mesh, const BaseComplex& complex,
                                                            const std::vector<SubMeshId>& labels, int count);

} // namespace qm
