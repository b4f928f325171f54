/// \file The section `features`.
#pragma once

#include "document/json_place.h"
#include "features/features.h"

namespace qm {

[[nodiscard]] Json featuresToJson(const QuadMesh& mesh, const Features& features,
                                  const FeatureOptions& options);

/// Curves may have been edited: each must run straight along a mesh line, no edge may lie on two, and every
/// seed must be an interior regular vertex of its curve that bears no other.
[[nodiscard]] Features readFeatures(const QuadMesh& mesh, const JsonPlace& section);

/// The angle above which edges count as sharp: that of the section, or the default if there is none.
[[nodiscard]] double sharpAngle(const Json& root);

} // namespace qm
