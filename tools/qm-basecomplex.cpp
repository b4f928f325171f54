/// \file qm-basecomplex: makes the first document of a pipe from a quad mesh, with its base complex.
#include "basecomplex/base_complex.h"
#include "cli/tool.h"
#include "cli/tools/mesh_input.h"
#include "document/document.h"
#include "document/sections/base_complex_section.h"

int main(int argc, char** argv) {
    bool repair = false;
    return qm::runTool(
        argc, argv, "qm-basecomplex", "Trace the separatrices of a quad mesh.",
        [&](qm::Tool& tool) -> qm::ToolBody {
            tool.reads("MESH", "a quad mesh in OBJ, OFF or PLY format");
            tool.writes("a document with the sections mesh and baseComplex");
            tool.schema(qm::kindName(qm::Kind::basecomplex));
            tool.option("repair", repair,
                        "weld vertices at the same place, remove degenerate and duplicate faces, flip faces "
                        "that disagree with most of their neighbours, split vertices where several fans of "
                        "faces meet, take solids apart that touch along edges; the repaired mesh is written "
                        "to NAME.repaired.obj beside the document");
            tool.example("qm-basecomplex part.obj -o part.basecomplex.json");
            tool.example(
                "qm-basecomplex part.obj | qm-features | qm-cut | qm-enum | qm-merge | qm-prune | qm-bspline "
                "> part.surfaces.json");
            return [&] {
                qm::MeshInput input = qm::readMeshInput(tool, repair);
                const qm::BaseComplex complex = qm::buildBaseComplex(input.mesh);
                tool.count("extraordinaryVertices", complex.extraordinaryVertices.size());
                tool.count("separatrices", complex.separatrices.size());
                tool.count("ordinaryJunctions", complex.ordinaryJunctions);

                qm::Document document = qm::newDocument(qm::Kind::basecomplex);
                document.root["mesh"] = std::move(input.section);
                qm::putSection(document, {qm::Kind::basecomplex,
                                          tool.name(),
                                          {{"repair", repair}},
                                          qm::baseComplexToJson(input.mesh, complex)});
                tool.write(qm::printDocument(std::move(document)));
                return qm::exitDone;
            };
        });
}
