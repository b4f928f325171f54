#include "support/two_squares.h"

#include "mesh/files/read_mesh.h"
#include "support/mesh_text.h"
#include "support/message_of.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm::test {

QuadMesh read(const std::string& text, const std::string& name) {
    return readMesh(text, name).mesh;
}

std::string refusal(const std::string& text, const std::string& name) {
    const std::string message = messageOf([&] { (void)readMesh(text, name); });
    EXPECT_NE(message, "") << "accepted:\n" << text.substr(0, 300);
    EXPECT_EQ(message.find('\n'), std::string::npos) << "one line";
    return message;
}

std::string twoObj() {
    return "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n"
           "f 1 2 3 4\nf 2 5 6 3\n";
}

std::string twoOff() {
    return "OFF\n6 2 7\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n2 1 0\n"
           "4 0 1 2 3\n4 1 4 5 2\n";
}

std::string twoPlyHeader() {
    return "ply\nformat ascii 1.0\ncomment two squares\nelement vertex 6\n"
           "property float x\nproperty float y\nproperty float z\nelement face 2\n"
           "property list uchar int vertex_indices\nend_header\n";
}

std::string twoPly() {
    return twoPlyHeader() + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n2 1 0\n"
                            "4 0 1 2 3\n4 1 4 5 2\n";
}

std::string binaryPly(bool little, const std::string& coordinate, const std::string& index, bool extras) {
    BinaryText out(little);
    std::string header = std::string("ply\nformat binary_") + (little ? "little" : "big") + "_endian 1.0\n";
    if (extras)
        header += "comment end_header is not here\nobj_info x\nelement material 2\nproperty uchar red\n";
    header += "element vertex 6\n";
    if (extras) header += "property list uchar short tags\n";
    for (const char axis : {'x', 'y', 'z'})
        header += "property " + coordinate + " " + axis + "\n";
    if (extras) header += "property double quality\n";
    header +=
        "element face 2\nproperty list uchar " + index + " vertex_" + (extras ? "index" : "indices") + "\n";
    if (extras) header += "property uint flags\nelement empty 1000000000000\n";
    out.bytes = header + "end_header\n";
    if (extras) out.bytes += "\n\r";
    const std::vector<std::array<double, 3>> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0},
                                                    {0, 1, 0}, {2, 0, 0}, {2, 1, 0}};
    for (const auto& point : points) {
        if (extras) {
            out.put("uchar", 2);
            out.put("short", 7);
            out.put("short", -7);
        }
        for (const double value : point)
            out.put(coordinate, value);
        if (extras) out.put("double", 0.25);
    }
    for (const auto& face : std::vector<std::array<int, 4>>{{0, 1, 2, 3}, {1, 4, 5, 2}}) {
        out.put("uchar", 4);
        for (const int corner : face)
            out.put(index, corner);
        if (extras) out.put("uint", 5);
    }
    return out.bytes;
}

void expectTwoSquares(const std::string& text, const std::string& name) {
    SCOPED_TRACE(text.substr(0, 400));
    const QuadMesh mesh = read(text, name);
    EXPECT_EQ(pointsOf(mesh), pointsOf(read(twoObj(), "a.obj")));
    EXPECT_EQ(facesOf(mesh), (std::vector<FaceIndices>{{0, 1, 2, 3}, {1, 4, 5, 2}}));
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
    return text;
}

} // namespace qm::test
