#include "mesh/read_mesh.h"

#include "base/error.h"
#include "mesh/build_mesh.h"
#include "mesh/suspicions.h"
#include "mesh/validate.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

namespace qm {
namespace {

std::string extension(std::string_view name) {
    const std::size_t dot = name.rfind('.');
    std::string result(dot == std::string_view::npos ? "" : name.substr(dot + 1));
    std::ranges::transform(result, result.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

Soup readSoup(std::string_view bytes, std::string_view name) {
    if (bytes.empty()) throw Error("", "the file is empty", "get it whole");
    std::string format = extension(name);
    const std::string_view firstLine = bytes.substr(0, bytes.find_first_of("\r\n"));
    if (format != "obj" && format != "off" && format != "ply") {
        if (firstLine.ends_with("OFF")) format = "off";
        if (firstLine == "ply") format = "ply";
        if (firstLine.starts_with("v ") || (format.empty() && firstLine.starts_with("#"))) format = "obj";
    }
    if (format == "obj") return readObj(bytes);
    if (format == "off") return readOff(bytes);
    if (format == "ply") return readPly(bytes);
    throw Error("", "the format is not known", "give an OBJ, OFF or PLY file");
}

void append(std::string& text, double value) {
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    text.append(buffer.data(), end);
}

} // namespace

ReadResult readMesh(std::string_view bytes, std::string_view name, const ReadOptions& options) {
    Soup soup = readSoup(bytes, name);
    ReadResult result;
    if (options.repair) {
        validateElements(soup);
        result.repair = repairSoup(soup);
    }
    result.mesh = buildMesh(soup);
    result.warnings = suspicions(result.mesh);
    return result;
}

std::string writeObj(const QuadMesh& mesh) {
    std::string text;
    for (const VertexId vertex : mesh.vertices()) {
        text += 'v';
        for (const double value : mesh.point(vertex)) {
            text += ' ';
            append(text, value);
        }
        text += '\n';
    }
    for (const FaceId face : mesh.faces()) {
        text += 'f';
        HalfedgeId halfedge = mesh.halfedge_handle(face);
        for (int k = 0; k < 4; ++k, halfedge = mesh.next_halfedge_handle(halfedge))
            text += ' ' + std::to_string(mesh.to_vertex_handle(halfedge).idx() + 1);
        text += '\n';
    }
    return text;
}

} // namespace qm
