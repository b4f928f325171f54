#include "shape/sample_meshes.h"
#include "shape/voxels.h"

#include <cmath>
#include <numbers>

namespace qm {

QuadList cubeShape(int n) {
    return refined(voxelSurface(voxelBox(1, 1, 1)), n);
}

QuadList sphereShape(int around) {
    const int n = around / 4;
    QuadList list = refined(voxelSurface(voxelBox(1, 1, 1)), {n, around / 2 - n, n});
    for (Point& point : list.points) {
        for (double& coordinate : point)
            coordinate = std::tan((2 * coordinate - 1) * std::numbers::pi / 4);
        point.normalize();
    }
    return list;
}

} // namespace qm
