/// \file Sample meshes: all-quad and semi-regular, made by formula.
#pragma once

#include "mesh/quad_mesh.h"
#include "mesh/triangles/triangles.h"

#include <cstdint>
#include <span>
#include <string>

namespace qm {

struct ShapeOptions {
    int resolution = 0;     ///< how fine, 1 or more; the number of quads grows with its square; 0: as listed
    int around = 0;         ///< quads around cylinder, sphere, torus and tube instead; 0: by the resolution
    std::uint64_t seed = 1; ///< of the random shapes
    int voxels = 12;        ///< cubes that a random shape is made of, 1 or more
};

/// What can be asked for.
struct ShapeLimits {
    static constexpr int maxResolution = 10'000;
    static constexpr int maxAround = 10'000;
    static constexpr int maxVoxels = 100'000;
    static constexpr int maxQuads = 10'000'000;
    static constexpr int maxTriangles = 2 * maxQuads; ///< of a scan
};

struct ShapeKind {
    const char* name;
    const char* summary; ///< what it is a sample of
    int resolution;      ///< where none is asked for
    bool random = false; ///< depends on seed and number of cubes
};

/// In alphabetical order.
[[nodiscard]] std::span<const ShapeKind> shapeKinds();

/// The same options make the same mesh everywhere.
/// \throw Error  if there is no such shape, or it would have more than ten million quads
[[nodiscard]] QuadMesh makeShape(const std::string& name, const ShapeOptions& options = {});

/// The same shape as triangles, without noise.
/// \param triangles  about so many; they take the place of resolution and number around
/// \throw Error  as above, and if the number is out of range
[[nodiscard]] Triangles makeScan(const std::string& name, double triangles, ShapeOptions options = {});

} // namespace qm
