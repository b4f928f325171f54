/// \file What the options of qm-shape may say.
#pragma once

#include "document/option.h"
#include "mesh/mesh_format.h"

#include <array>
#include <string_view>

namespace qm {

/// What --format may say: a format, or that the output's name tells it.
enum class NamedMeshFormat { ending, obj, off, ply, stl };

template <> struct Choices<NamedMeshFormat> {
    static constexpr std::array all{
        Choice<NamedMeshFormat>{NamedMeshFormat::ending, "ending",
                                "what the ending of the output's name says, or else obj"},
        Choice<NamedMeshFormat>{NamedMeshFormat::obj, "obj", "text"},
        Choice<NamedMeshFormat>{NamedMeshFormat::off, "off", "text"},
        Choice<NamedMeshFormat>{NamedMeshFormat::ply, "ply", "binary, double precision"},
        Choice<NamedMeshFormat>{NamedMeshFormat::stl, "stl",
                                "binary, single precision: triangles only, as --scan makes them"}};
};

[[nodiscard]] inline MeshFormat meshFormat(NamedMeshFormat format, std::string_view outputPath) {
    switch (format) {
    case NamedMeshFormat::ending:
        return formatOfName(outputPath).value_or(MeshFormat::obj);
    case NamedMeshFormat::obj:
        return MeshFormat::obj;
    case NamedMeshFormat::off:
        return MeshFormat::off;
    case NamedMeshFormat::ply:
        return MeshFormat::ply;
    case NamedMeshFormat::stl:
        break;
    }
    return MeshFormat::stl;
}

} // namespace qm
