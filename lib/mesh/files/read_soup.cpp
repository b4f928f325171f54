#include "base/error.h"
#include "mesh/files/mesh_format.h"
#include "mesh/soup/soup.h"

namespace qm {

Soup readSoup(std::string_view bytes, std::string_view name, std::size_t sides) {
    if (bytes.empty()) throw Error("", "the file is empty", "Use a complete copy");
    auto format = formatOfName(name);
    if (!format) format = formatOfBytes(bytes);
    if (!format)
        throw Error("", "the format is not known",
                    sides > 3 ? "Give an OBJ, OFF or PLY file" : "Give an OBJ, OFF, PLY or STL file");
    switch (*format) {
    case MeshFormat::obj:
        return readObj(bytes, sides);
    case MeshFormat::off:
        return readOff(bytes);
    case MeshFormat::ply:
        return readPly(bytes);
    case MeshFormat::stl:
        break;
    }
    return readStl(bytes);
}

} // namespace qm
