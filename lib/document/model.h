/// \file What the sections of a document mean: plain structs, checked against the mesh.
#pragma once

#include "basecomplex/base_complex.h"
#include "bspline/splines/surfaces.h"
#include "cut/cut.h"
#include "document/kind.h"
#include "enumerate/enumerate.h"
#include "features/features.h"
#include "layout/constraints.h"
#include "layout/cost.h"
#include "layout/layout.h"

#include <optional>
#include <string>
#include <vector>

namespace qm {

struct Document;

/// Members beyond what was asked for, or whose section the document does not have, are empty.
struct Model {
    QuadMesh mesh;
    std::string meshPath;               ///< the file it was read from
    std::vector<double> dihedralAngles; ///< by edge
    BaseComplex baseComplex;            ///< without feature seeds: the separatrices that the document numbers
    Features features;
    BaseComplex complex; ///< with feature seeds
    Constraints constraints;
    std::optional<Cut> cut;
    SubMeshes subMeshes; ///< of the cut; else the whole mesh
    GraphCost cost;      ///< from the enumeration
    std::vector<double> edgeCosts;
    std::optional<Enumeration> enumeration;
    std::optional<Layout> layout;
    std::optional<Surfaces> surfaces;

    /// What was measured or made anew because the document was edited, a sentence each.
    std::vector<std::string> notes;
};

/// Reads the mesh and all sections that are needed to work on those of a kind: up to the cut, every section;
/// for `enumeration` its graphs too; for `layout` and `surfaces` no cut and no graphs. Figures that had to be
/// measured anew, and parts of the layout that had been left out, are written into the document.
/// \param meshPath  the mesh, if not where the document says; may be empty
/// \throw FileError  with the JSON pointer of the first rule that is broken
[[nodiscard]] Model readModel(Document& document, Kind upTo, const std::string& meshPath = {});

/// The same of every section that the document has, cut and graphs too.
[[nodiscard]] Model readWholeModel(Document& document, const std::string& meshPath = {});

} // namespace qm
