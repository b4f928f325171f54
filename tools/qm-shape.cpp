/// \file qm-shape: sample meshes.
#include "cli/tool.h"
#include "mesh/write_mesh.h"
#include "shape/shape.h"

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

} // namespace

int main(int argc, char** argv) {
    std::string name;
    bool list = false;
    qm::ShapeOptions options;
    return qm::runTool(argc, argv, "qm-shape", "Make a sample mesh.", [&](qm::Tool& tool) -> qm::ToolBody {
        tool.operand("NAME", name, "which mesh; --list shows them all", false);
        tool.writes("the mesh, as OBJ");
        tool.option("list", list,
                    "list the meshes with their resolution and size, where nothing else is asked for");
        tool.option("resolution", options.resolution, {0, 10000},
                    "how fine: the number of quads grows with its square; 0 is the mesh's own");
        tool.option("seed", options.seed, "another one, another random mesh");
        tool.option("voxels", options.voxels, {1, 100000}, "how many cubes a random mesh is made of");
        tool.example("qm-shape --list");
        tool.example("qm-shape bracket -o bracket.obj");
        tool.example("qm-shape random --seed 7 --voxels 30 | qm-basecomplex > random.basecomplex.json");
        tool.verify([&] {
            if (name.empty() != list) throw qm::UsageError("name one mesh, or give --list");
        });
        return [&] {
            if (list) {
                tool.write(listOfShapes());
                return qm::exitDone;
            }
            const qm::QuadMesh mesh = qm::makeShape(name, options);
            tool.count("vertices", static_cast<double>(mesh.n_vertices()));
            tool.count("faces", static_cast<double>(mesh.n_faces()));
            tool.write(qm::writeObj(mesh));
            return qm::exitDone;
        };
    });
}
