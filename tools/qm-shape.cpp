/// \file qm-shape: makes sample meshes, and scans of them.
#include "cli/shape_request.h"
#include "document/options.h"

int main(int argc, char** argv) {
    qm::ShapeRequest request;
    using Limits = qm::ShapeLimits;
    return qm::runTool(
        argc, argv, "qm-shape", "Make a sample mesh, or a scan of one.", [&](qm::Tool& tool) -> qm::ToolBody {
            tool.operand("NAME", request.name, "which mesh; --list shows them all", false,
                         qm::namesOfShapes());
            tool.writes("the mesh");
            tool.option("list", request.list,
                        "list the meshes with their resolution and size, where nothing else is asked for");
            tool.option("resolution", request.shape.resolution, {0, Limits::maxResolution},
                        "how fine: the number of quads grows with its square; 0 is the mesh's own");
            tool.option(
                "around", request.shape.around, {0, Limits::maxAround},
                "quads around a cylinder, sphere, torus or tube instead; 0 leaves it to the resolution");
            tool.option("seed", request.shape.seed, "another one, another random mesh and other noise");
            tool.option("voxels", request.shape.voxels, {1, Limits::maxVoxels},
                        "how many cubes a random mesh is made of");
            tool.option("scan", request.scan, {0, Limits::maxTriangles},
                        "make about so many triangles, as a scanner does, instead of quads; 0 makes quads");
            tool.option("noise", request.noise, {qm::smallestPositive, qm::infinite},
                        "of a scan: standard deviation of its points from the surface, a length or, with %, "
                        "a share of the diagonal of the bounding box");
            tool.option("format", request.format, "of the output");
            qm::declareNeeds(tool, request);
            tool.example("qm-shape --list");
            tool.example("qm-shape bracket -o bracket.obj");
            tool.example("qm-shape sphere --around 30 --format off -o sphere.off");
            tool.example("qm-shape block --scan 200000 --noise 0.05% -o scan.stl");
            tool.example("qm-shape random --seed 7 --voxels 30 | qm-basecomplex > random.basecomplex.json");
            tool.verify([&] { qm::verify(tool, request); });
            return [&] {
                if (request.list) {
                    tool.write(qm::listOfShapes());
                    return qm::exitDone;
                }
                const qm::Soup soup = qm::makeRequested(request);
                tool.count("vertices", static_cast<double>(soup.points.size()));
                tool.count("faces", static_cast<double>(soup.faceCount()));
                tool.write(qm::writeRequested(soup, request, tool.outputPath()));
                return qm::exitDone;
            };
        });
}
