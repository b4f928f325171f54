#include "cli/tools/mesh_input.h"

#include "base/joined.h"
#include "base/number_text.h"
#include "cli/system/output_file.h"
#include "cli/tools/repair_text.h"
#include "document/sections/mesh_section.h"
#include "mesh/boundary_loops.h"
#include "mesh/extent.h"
#include "mesh/files/read_mesh.h"
#include "mesh/files/write_soup.h"
#include "mesh/suspicions.h"

#include <algorithm>
#include <span>

namespace qm {

namespace {

std::string folderWithSlash(const std::string& path) {
    return path.substr(0, path.rfind('/') + 1);
}

/// The name of a repaired mesh: "part.repaired.obj" for "meshes/part.off".
std::string repairedName(const std::string& path) {
    if (path == "-") return "mesh.repaired.obj";
    const std::string name = path.substr(folderWithSlash(path).size());
    return name.substr(0, name.rfind('.')) + ".repaired.obj";
}

/// "2 boundary loops, 16 long (at vertex 0), 1.88 long (at vertex 40)".
std::string loopsText(const std::vector<BoundaryLoop>& loops) {
    constexpr std::size_t shown = 4;
    const auto textOf = [](const BoundaryLoop& loop) {
        return roundedText(loop.length) + " long (at vertex " + std::to_string(loop.vertex.idx()) + ")";
    };
    const auto first = std::span(loops).first(std::min(loops.size(), shown));
    return countText(loops.size(), "boundary loop") + ", " + joined(first, ", ", textOf) +
           (loops.size() > shown ? " and " + std::to_string(loops.size() - shown) + " more" : "");
}

} // namespace

MeshInput readMeshInput(const Tool& tool, bool repair) {
    const std::string bytes = tool.readInput();
    tool.protect(tool.inputPath());
    ReadResult read = readMesh(bytes, tool.inputPath(), {repair});
    verifyExtent(boundingBox(read.mesh));
    for (const std::string& warning : suspicions(read.mesh))
        tool.warnOfInput(warning);
    if (const std::vector<BoundaryLoop> loops = boundaryLoops(read.mesh); !loops.empty())
        tool.warnOfInput("the mesh is open: " + loopsText(loops) + ". If a hole should be none, close it");
    tool.count("vertices", read.mesh.n_vertices());
    tool.count("faces", read.mesh.n_faces());
    if (!read.repair.changed()) {
        Json section = meshToJson(tool.inputPath(), bytes, read.mesh);
        return {std::move(read.mesh), std::move(section)};
    }

    const std::string name = repairedName(tool.inputPath());
    const std::string folder = tool.outputPath() == "-" ? "" : folderWithSlash(tool.outputPath());
    const std::string repaired = writeObj(read.mesh);
    writeFile(folder + name, repaired);
    tool.protect(folder + name);
    tool.warnOfInput(repairText(read.repair) + ". The mesh is now " + folder + name);
    // Reads the file as later tools will, so that both meshes agree exactly.
    ReadResult again = readMesh(repaired, name, {});
    Json section = meshToJson(name, repaired, again.mesh);
    return {std::move(again.mesh), std::move(section)};
}

} // namespace qm
