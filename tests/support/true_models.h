/// \file Small meshes with true documents, and assertions on the reports about falsified ones.
#pragma once

#include "check/check_document.h"
#include "check/document/checked_document.h"
#include "support/true_document.h"

#include <gtest/gtest.h>

#include <string>

namespace qm::test {

struct Model {
    check::CheckedMesh mesh;
    check::CheckedDocument document;
};

/// The true document of a mesh, whose surfaces claim to interpolate and to be watertight.
[[nodiscard]] Model make(check::CheckedMesh mesh, const DocumentRecipe& recipe = {});

/// A plane with two holes side by side: four pairs of lines cross, and every line ends at the boundary.
[[nodiscard]] check::CheckedMesh twoHoles();
[[nodiscard]] check::CheckedMesh corner();

/// A plane with two holes, cut into a left and a right half.
[[nodiscard]] Model cut();
/// A torus with the layout given by its most curved line and a transversal.
[[nodiscard]] Model torusModel();
[[nodiscard]] Model cornerModel();
[[nodiscard]] Model twoHolesModel();
/// The surfaces of these models claim to have no errors, and promise nothing else.
[[nodiscard]] Model statingModel();
[[nodiscard]] Model statingTorus();
/// A plane with a hole, and a feature curve that crosses a line from the hole.
[[nodiscard]] Model seededModel();

[[nodiscard]] check::LayoutPart& layout(check::CheckedDocument& document);
/// A track of more than one arc that ends where another one passes.
[[nodiscard]] check::TrackPart& crashing(check::CheckedDocument& document);

/// All violations of a report as text, for messages.
[[nodiscard]] std::string listed(const check::Report& report);
[[nodiscard]] ::testing::AssertionResult found(const check::Report& report, const std::string& pointer,
                                               const std::string& rule);

} // namespace qm::test
