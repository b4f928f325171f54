/// \file The feature curves of one mesh line (docs/METHOD.md#features).
#pragma once

#include "features/features.h"
#include "mesh/mesh_lines.h"

#include <vector>

namespace qm {

/// What decides which edges make a curve. Everything here must outlive it.
struct SharpMesh {
    const QuadMesh& mesh;
    const std::vector<double>& dihedralAngles; ///< by edge, radians
    const FeatureOptions& options;
    double minLength;   ///< as in the options, in the mesh's unit
    double minDistance; ///< as in the options, in the mesh's unit
};

/// Adds the curves of a line, without seeds.
void addCurvesOf(const MeshLine& line, const SharpMesh& sharp, std::vector<FeatureCurve>& curves);

} // namespace qm
