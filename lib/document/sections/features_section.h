/// \file The section `features`.
#pragma once

#include "document/json/json_place.h"
#include "features/features.h"

namespace qm {

[[nodiscard]] Json featuresToJson(const QuadMesh& mesh, const Features& features,
                                  const FeatureOptions& options);

/// Reads features. Curves may have been edited: each must run straight along a mesh line, no edge may lie on
/// two of them, and every seed must be an interior regular vertex of its curve and the seed of no other.
[[nodiscard]] Features readFeatures(const QuadMesh& mesh, const JsonPlace& section);

/// The angle above which edges count as sharp: that of the section, or the default if there is no section.
[[nodiscard]] double sharpAngle(const Json& root);

} // namespace qm
