/// \file qm-remesh: makes quads from the triangles of a scan, by QuadriFlow as included in Blender.
#include "cli/tool.h"
#include "cli/tools/quadriflow.h"
#include "cli/tools/remesh_messages.h"
#include "cli/tools/repair_text.h"
#include "mesh/files/read_triangles.h"
#include "mesh/files/write_soup.h"

int main(int argc, char** argv) {
    qm::RemeshOptions options;
    return qm::runTool(
        argc, argv, "qm-remesh", "Make a quad mesh from a triangle mesh, with Blender.",
        [&](qm::Tool& tool) -> qm::ToolBody {
            tool.reads("SCAN", "a triangle mesh in STL, PLY, OBJ or OFF format");
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
            tool.example("qm-remesh scan.stl --quads 2000 -o part.obj");
            return [&] {
                qm::Triangles scan =
                    qm::readTriangles(tool.readInput(), tool.inputPath() == "-" ? "" : tool.inputPath());
                tool.protect(tool.inputPath());
                tool.count("triangles", scan.faces.size());
                if (const std::string done = qm::repairText(qm::repairTriangles(scan)); !done.empty())
                    tool.warnOfInput(done);
                const qm::Remeshed remeshed =
                    qm::remeshWithBlender(scan, options, tool.control("drawing").jobs);
                if (remeshed.used.seed != options.seed)
                    tool.note("made with --seed " + std::to_string(remeshed.used.seed));
                if (remeshed.used.preserveSharp != options.preserveSharp)
                    tool.warn("QuadriFlow did not end: made with --no-preserve-sharp");
                tool.count("quads", remeshed.mesh.n_faces());
                tool.count("weldedVertices", remeshed.repair.weldedVertices);
                tool.write(qm::writeObj(remeshed.mesh));
                return qm::judgeRemeshed(tool, remeshed);
            };
        });
}
