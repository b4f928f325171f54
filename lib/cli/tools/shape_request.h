/// \file Requests to qm-shape: a sample mesh, or a scan of one.
#pragma once

#include "base/length.h"
#include "cli/tool.h"
#include "document/options/option.h"
#include "mesh/soup/soup.h"
#include "shape/shape.h"

#include <string>
#include <string_view>
#include <vector>

namespace qm {

/// The values of --format: a format, or to use the extension of the output's name.
enum class NamedMeshFormat { ending, obj, off, ply, stl };

template <> struct Choices<NamedMeshFormat> {
    using enum NamedMeshFormat;
    static constexpr Choice<NamedMeshFormat> all[]{
        {ending, "ending", "what the ending of the output's name says, or else obj"},
        {obj, "obj", "text"},
        {off, "off", "text"},
        {ply, "ply", "binary, double precision"},
        {stl, "stl", "binary, single precision: triangles only, as --scan makes them"}};
};

struct ShapeRequest {
    std::string name;
    ShapeOptions shape;
    bool list = false; ///< list the names instead of making a mesh
    int scan = 0;      ///< approximate number of triangles; 0 for quads
    Length noise;
    NamedMeshFormat format = NamedMeshFormat::ending;
};

/// Declares which options have no effect without others.
void declareNeeds(Tool& tool, const ShapeRequest& request);

/// \throw UsageError  if options contradict each other; called before anything is made
void verify(const Tool& tool, const ShapeRequest& request);

[[nodiscard]] std::vector<std::string> namesOfShapes();

/// One line for every shape, below a heading.
[[nodiscard]] std::string listOfShapes();

/// \throw Error  if there is no such shape, or its points are too far away
[[nodiscard]] Soup makeRequested(const ShapeRequest& request);

/// The contents of a file in the requested format.
[[nodiscard]] std::string writeRequested(const Soup& soup, const ShapeRequest& request,
                                         std::string_view outputPath);

} // namespace qm
