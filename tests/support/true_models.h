/// \file Small meshes with true documents, and what a report says of them when they are spoilt.
#pragma once

#include "check/check_document.h"
#include "check/checked_document.h"
#include "support/true_document.h"

#include <gtest/gtest.h>

#include <string>

namespace qm::testing {

struct Model {
    check::CheckedMesh mesh;
    check::CheckedDocument document;
};

/// The true document of a mesh, whose surfaces are stated to interpolate and to be watertight.
[[nodiscard]] Model make(check::CheckedMesh mesh, const DocumentRecipe& recipe = {});

[[nodiscard]] check::CheckedMesh twoHoles();
[[nodiscard]] check::CheckedMesh corner();

/// Two holes, cut into a left and a right half.
[[nodiscard]] Model cut();
/// A torus with the layout that its most curved line and a transversal give.
[[nodiscard]] Model torusModel();
[[nodiscard]] Model cornerModel();
[[nodiscard]] Model twoHolesModel();
/// These state that all is perfect, and promise nothing else.
[[nodiscard]] Model statingModel();
[[nodiscard]] Model statingTorus();
/// A hole, and a feature curve that crosses a line of it.
[[nodiscard]] Model seededModel();

[[nodiscard]] check::LayoutPart& layout(check::CheckedDocument& document);
/// A track that ends where another passes, and has more than one arc.
[[nodiscard]] check::TrackPart& crashing(check::CheckedDocument& document);

/// All violations, for messages.
[[nodiscard]] std::string listed(const check::Report& report);
[[nodiscard]] ::testing::AssertionResult found(const check::Report& report, const std::string& pointer,
                                               const std::string& rule);

} // namespace qm::testing
