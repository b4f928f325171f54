#include "document/sections/base_complex_section.h"

#include "document/sections/mesh_paths.h"

namespace qm {

Json baseComplexToJson(const QuadMesh& mesh, const BaseComplex& complex) {
    Json::array_t separatrices;
    separatrices.reserve(complex.separatrices.size());
    for (const Separatrix& separatrix : complex.separatrices)
        separatrices.push_back(
            {{"id", separatrices.size()},
             {"vertices", pathNumbers(mesh, separatrix.halfedges)},
             {"opposite", separatrix.opposite ? Json(separatrix.opposite->value()) : Json()},
             {"selfCrossing", separatrix.selfCrossing}});
    return {{"extraordinaryVertices", numbersOf(complex.extraordinaryVertices)},
            {"ordinaryJunctions", complex.ordinaryJunctions},
            {"separatrices", std::move(separatrices)}};
}

void verifyBaseComplex(const QuadMesh& mesh, const BaseComplex& complex, const JsonPlace& section) {
    section.requireEqual(baseComplexToJson(mesh, complex), "is not what follows from the mesh",
                         "The base complex cannot be edited: make it anew with qm-basecomplex");
}

} // namespace qm
