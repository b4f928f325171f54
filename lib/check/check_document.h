/// \file Is a whole document true of its mesh?
///
/// Everything here is computed anew from the mesh's points and faces, and nothing of the modules that make
/// documents takes part. Points, faces and JSON come from qm-check, which reads them as all tools do.
#pragma once

#include "check/document/checked_document.h"
#include "check/document/report.h"
#include "check/mesh/neighbourhoods.h"

namespace qm::check {

/// Checks the sections in their order. What depends on a broken section is not checked: seeds and labels
/// determine what a track may be, and surfaces belong to segments. Linear in mesh and document, but for
/// sorting.
/// \throw Error  if the mesh is no oriented 2-manifold of quads
[[nodiscard]] Report checkDocument(const CheckedMesh& mesh, const CheckedDocument& document,
                                   Report report = Report(), unsigned jobs = 1);

} // namespace qm::check
