/// \file qm-shape: makes sample meshes, and scans of them.
#include "cli/tools/shape_request.h"
#include "document/options/options.h"

int main(int argc, char** argv) {
    qm::ShapeRequest request;
    using Limits = qm::ShapeLimits;
    return qm::runTool(
        argc, argv, "qm-shape", "Make a sample mesh, or a scan of one.", [&](qm::Tool& tool) -> qm::ToolBody {
            tool.operand("NAME", request.name, "the name of a mesh; --list shows all of them", false,
                         qm::namesOfShapes());
            tool.writes("the mesh");
            tool.option("list", request.list,
                        "list the meshes with their default resolution and number of quads");
            tool.option("resolution", request.shape.resolution, {0, Limits::maxResolution},
                        "resolution; the number of quads grows with its square. 0 is the mesh's default");
            tool.option("around", request.shape.around, {0, Limits::maxAround},
                        "instead, the number of quads around a cylinder, sphere, torus or tube; 0 leaves it "
                        "to the resolution");
            tool.option("seed", request.shape.seed, "random seed, of random meshes and of noise");
            tool.option("voxels", request.shape.voxels, {1, Limits::maxVoxels},
                        "number of cubes in a random mesh");
            tool.option("scan", request.scan, {0, Limits::maxTriangles},
                        "make a scan of about this many triangles instead of quads; 0 makes quads");
            tool.option("noise", request.noise, {qm::smallestPositive, qm::infinity},
                        "noise of a scan: standard deviation of its points from the surface, as a length or, "
                        "with %, as a share of the bounding box's diagonal");
            tool.option("format", request.format, "output format");
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
                tool.count("vertices", soup.points.size());
                tool.count("faces", soup.faceCount());
                tool.write(qm::writeRequested(soup, request, tool.outputPath()));
                return qm::exitDone;
            };
        });
}
