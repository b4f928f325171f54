#include "shape/voxels.h"

#include <map>

namespace qm {
namespace {

/// The eight voxels around a grid point, as bits; bit k is the one on the upper side along axis a if bit a of
/// k is set.
unsigned voxelsAround(const Voxels& voxels, const Voxel& point) {
    unsigned result = 0;
    for (unsigned k = 0; k < 8; ++k) {
        Voxel voxel = point;
        for (unsigned axis = 0; axis < 3; ++axis)
            if ((k >> axis & 1U) == 0) --voxel[axis];
        if (voxels.contains(voxel)) result |= 1U << k;
    }
    return result;
}

/// Whether those of the eight that are set are connected through common squares.
bool connected(unsigned set) {
    if (set == 0) return true;
    unsigned reached = set & -set;
    for (unsigned before = 0; before != reached;) {
        before = reached;
        for (unsigned k = 0; k < 8; ++k)
            if ((before >> k & 1U) != 0)
                for (unsigned axis = 0; axis < 3; ++axis)
                    reached |= 1U << (k ^ (1U << axis)) & set;
    }
    return reached == set;
}

} // namespace

Voxels voxelBox(int x, int y, int z) {
    Voxels result;
    for (int i = 0; i < x; ++i)
        for (int j = 0; j < y; ++j)
            for (int k = 0; k < z; ++k)
                result.insert({i, j, k});
    return result;
}

QuadList voxelSurface(const Voxels& voxels) {
    QuadList surface;
    std::map<Voxel, int> numbers;
    const auto vertex = [&](const Voxel& point) {
        const auto [entry, isNew] = numbers.try_emplace(point, static_cast<int>(surface.points.size()));
        if (isNew) surface.points.emplace_back(point[0], point[1], point[2]);
        return entry->second;
    };
    for (const Voxel& voxel : voxels)
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const int direction : {-1, 1}) {
                Voxel other = voxel;
                other[axis] += direction;
                if (voxels.contains(other)) continue;
                const std::size_t u = (axis + (direction > 0 ? 1 : 2)) % 3;
                const std::size_t v = (axis + (direction > 0 ? 2 : 1)) % 3;
                Voxel corner = voxel;
                if (direction > 0) ++corner[axis];
                std::array<int, 4> quad{};
                quad[0] = vertex(corner);
                ++corner[u];
                quad[1] = vertex(corner);
                ++corner[v];
                quad[2] = vertex(corner);
                --corner[u];
                quad[3] = vertex(corner);
                surface.quads.push_back(quad);
            }
    return surface;
}

bool surfaceIsManifoldAt(const Voxels& voxels, const Voxel& voxel) {
    for (unsigned k = 0; k < 8; ++k) {
        Voxel point = voxel;
        for (unsigned axis = 0; axis < 3; ++axis)
            if ((k >> axis & 1U) != 0) ++point[axis];
        const unsigned inside = voxelsAround(voxels, point);
        if (!connected(inside) || !connected(~inside & 0xFFU)) return false;
    }
    return true;
}

} // namespace qm
