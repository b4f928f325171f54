/// \file The contents of a document's sections as plain structs, checked against the mesh.
#pragma once

#include "basecomplex/base_complex.h"
#include "bspline/splines/surfaces.h"
#include "cut/cut.h"
#include "document/kind.h"
#include "enumerate/enumerate.h"
#include "features/features.h"
#include "layout/cost.h"
#include "layout/layout.h"

#include <optional>
#include <string>
#include <vector>

namespace qm {

struct Document;

/// Members that were not asked for, or whose section the document does not have, are empty.
struct Model {
    QuadMesh mesh;
    std::string meshPath;               ///< the file it was read from
    std::vector<double> dihedralAngles; ///< by edge
    BaseComplex baseComplex; ///< without feature seeds; its separatrices are numbered as in the document
    Features features;
    BaseComplex complex; ///< with feature seeds
    Constraints constraints;
    std::optional<Cut> cut;
    SubMeshes subMeshes; ///< of the cut, if there is one; otherwise the whole mesh
    GraphCost cost;      ///< from the enumeration
    std::vector<double> edgeCosts;
    std::optional<Enumeration> enumeration;
    std::optional<Layout> layout;
    std::optional<Surfaces> surfaces;

    /// One sentence for everything that was measured or made anew because the document had been edited.
    std::vector<std::string> notes;

    [[nodiscard]] SearchedMesh searched() const {
        return {mesh, complex, dihedralAngles, subMeshes, constraints};
    }
};

/// Reads the mesh and all sections needed to work on a kind: up to the cut, every section; for `enumeration`
/// also its graphs; for `layout` and `surfaces` neither cut nor graphs. Figures measured anew, and parts of
/// the layout that were missing, are written into the document.
/// \param meshPath  the mesh file, if not the recorded one; may be empty
/// \throw FileError  with the JSON pointer of the first violation
[[nodiscard]] Model readModel(Document& document, Kind upTo, const std::string& meshPath = {});

/// The same for all sections that the document has, including cut and graphs.
[[nodiscard]] Model readWholeModel(Document& document, const std::string& meshPath = {});

} // namespace qm
