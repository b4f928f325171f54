/// \file qm-remesh: makes quads from the triangles of a scan, by QuadriFlow as included in Blender, or of any
/// polygons, by subdivision.
#include "cli/tool.h"
#include "cli/tools/remesh_input.h"
#include "cli/tools/subdivision.h"
#include "mesh/dihedral.h"

#include <numbers>

int main(int argc, char** argv) {
    qm::RemeshOptions options;
    bool subdivide = false;
    double rho = qm::defaultRho;
    return qm::runTool(
        argc, argv, "qm-remesh", "Make a quad mesh from triangles, with Blender, or from other polygons.",
        [&](qm::Tool& tool) -> qm::ToolBody {
            tool.reads("SCAN", "a triangle mesh in STL, PLY, OBJ or OFF format, or any polygons");
            tool.writes("a quad mesh in OBJ format");
            tool.explain("Uses QuadriFlow as built into Blender 3 and 4, which must be installed. Where it "
                         "fails or leaves holes, other seeds are tried, without regard to sharp edges "
                         "if it does not end, and then an open scan without holding edges to its "
                         "boundary; small holes that the scan has not are closed. Exit "
                         "status 3, with a warning: the mesh is written, but leaves out a part of the scan "
                         "or lies elsewhere, by more than two of its edges.");
            tool.option("quads", options.quads, qm::Range{8, 10'000'000}, "approximate number of quads");
            tool.option("preserve-sharp", options.preserveSharp,
                        "do not align edges with the sharp edges of the scan");
            tool.option("draw", options.draw,
                        "leave the vertices where QuadriFlow puts them, with edges and corners cut off, "
                        "instead of drawing them to the scan");
            tool.option("seed", options.seed, qm::Range{0, 1'000'000},
                        "random seed; each gives another mesh");
            tool.option(
                "subdivide", subdivide,
                "instead, for meshes of quads and other polygons: divide every face into as many "
                "quads as it has corners, without Blender. Vertices stay where they are; new ones lie "
                "on a smooth surface through them");
            tool.option("rho", rho, qm::Range{0, std::numbers::pi},
                        "with --subdivide: edges of larger dihedral angles are sharp, in radians; pi makes "
                        "all of a coarse mesh smooth");
            tool.needs({"quads", "no-preserve-sharp", "no-draw", "seed"},
                       "Blender, which --subdivide does not use", [&] { return !subdivide; });
            tool.needs({"rho"}, "--subdivide", [&] { return subdivide; });
            tool.example("qm-remesh scan.stl --quads 2000 -o part.obj");
            tool.example("qm-remesh --subdivide part.obj -o quads.obj");
            return [&] { return subdivide ? qm::subdivideInput(tool, rho) : qm::remeshInput(tool, options); };
        });
}
