/// \file What qm-shape is asked for: a sample mesh or a scan of one.
#pragma once

#include "base/length.h"
#include "cli/tool.h"
#include "document/option.h"
#include "mesh/soup.h"
#include "shape/shape.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

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

struct ShapeRequest {
    std::string name;
    ShapeOptions shape;
    bool list = false; ///< of the names, instead of a mesh
    int scan = 0;      ///< about how many triangles; 0: quads
    Length noise;
    NamedMeshFormat format = NamedMeshFormat::ending;
};

/// Tells the tool which options have no effect without others.
void declareNeeds(Tool& tool, const ShapeRequest& request);

/// \throw UsageError  if options contradict each other, before anything is made
void verify(const Tool& tool, const ShapeRequest& request);

[[nodiscard]] std::vector<std::string> namesOfShapes();

/// A line for every shape, below a heading.
[[nodiscard]] std::string listOfShapes();

[[nodiscard]] Soup makeRequested(const ShapeRequest& request);

/// The bytes of a file in the format that is asked for.
[[nodiscard]] std::string writeRequested(const Soup& soup, const ShapeRequest& request,
                                         std::string_view outputPath);

} // namespace qm
