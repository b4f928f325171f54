/// \file qm-shape: sample meshes, and scans of them.
#include "cli/mesh_choices.h"
#include "cli/tool.h"
#include "document/options.h"
#include "mesh/write_soup.h"
#include "shape/scan.h"
#include "shape/shape.h"

#include <algorithm>
#include <string>

namespace {

std::string padded(const std::string& text, std::size_t width) {
    return text + std::string(width - std::min(width, text.size()), ' ');
}

std::string listOfShapes() {
    std::string list = "NAME         RESOLUTION  QUADS\n";
    for (const qm::ShapeKind& kind : qm::shapeKinds())
        list += padded(kind.name, 13) + padded(std::to_string(kind.resolution), 12) +
                padded(std::to_string(qm::makeShape(kind.name).n_faces()), 7) + kind.summary + '\n';
    return list;
}

struct Request {
    std::string name;
    qm::ShapeOptions shape;
    int scan = 0; ///< about how many triangles; 0: quads
    qm::Length noise;
    qm::NamedMeshFormat format = qm::NamedMeshFormat::ending;
};

qm::Soup make(const Request& request) {
    if (request.scan == 0) return qm::soupOf(qm::makeShape(request.name, request.shape));
    qm::Triangles scan = qm::makeScan(request.name, request.scan, request.shape);
    if (request.noise.value > 0)
        qm::addNoise(scan, request.noise.length(qm::diagonalOf(scan)), request.shape.seed);
    return qm::soupOf(scan);
}

/// A wrong command line is one before anything is made.
void check(const qm::Tool& tool, const Request& request, bool list) {
    if (request.name.empty() != list) throw qm::UsageError("name one mesh, or give --list");
    if (request.shape.around > 0 && tool.given("resolution"))
        throw qm::UsageError("--around and --resolution exclude one another");
    if (request.scan > 0 && (tool.given("resolution") || tool.given("around")))
        throw qm::UsageError("--scan says how fine the scan is, without --resolution and --around");
    if (request.scan == 0 && tool.given("noise")) throw qm::UsageError("--noise is for --scan");
    if (request.scan == 0 && meshFormat(request.format, tool.outputPath()) == qm::MeshFormat::stl)
        throw qm::UsageError("STL holds triangles only: give --scan, or another format");
}

} // namespace

int main(int argc, char** argv) {
    Request request;
    bool list = false;
    return qm::runTool(
        argc, argv, "qm-shape", "Make a sample mesh, or a scan of one.", [&](qm::Tool& tool) -> qm::ToolBody {
            tool.operand("NAME", request.name, "which mesh; --list shows them all", false);
            tool.writes("the mesh");
            tool.option("list", list,
                        "list the meshes with their resolution and size, where nothing else is asked for");
            tool.option("resolution", request.shape.resolution, {0, 10000},
                        "how fine: the number of quads grows with its square; 0 is the mesh's own");
            tool.option(
                "around", request.shape.around, {0, 10000},
                "quads around a cylinder, sphere, torus or tube instead; 0 leaves it to the resolution");
            tool.option("seed", request.shape.seed, "another one, another random mesh and other noise");
            tool.option("voxels", request.shape.voxels, {1, 100000},
                        "how many cubes a random mesh is made of");
            tool.option("scan", request.scan, {0, 20'000'000},
                        "make about so many triangles, as a scanner does, instead of quads; 0 makes quads");
            tool.option("noise", request.noise, {qm::smallestPositive, qm::infinite},
                        "of a scan: standard deviation of its points from the surface, a length or, with %, "
                        "a share of "
                        "the diagonal of the bounding box");
            tool.option("format", request.format, "of the output");
            tool.example("qm-shape --list");
            tool.example("qm-shape bracket -o bracket.obj");
            tool.example("qm-shape sphere --around 30 --format off -o sphere.off");
            tool.example("qm-shape block --scan 200000 --noise 0.05% -o scan.stl");
            tool.example("qm-shape random --seed 7 --voxels 30 | qm-basecomplex > random.basecomplex.json");
            tool.verify([&] { check(tool, request, list); });
            return [&] {
                if (list) {
                    tool.write(listOfShapes());
                    return qm::exitDone;
                }
                const qm::Soup soup = make(request);
                tool.count("vertices", static_cast<double>(soup.points.size()));
                tool.count("faces", static_cast<double>(soup.faceCount()));
                tool.write(qm::writeSoup(soup, qm::meshFormat(request.format, tool.outputPath())));
                return qm::exitDone;
            };
        });
}
