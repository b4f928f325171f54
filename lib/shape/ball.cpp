#include "shape/ball.h"

#include "shape/voxels.h"

#include <cmath>
#include <numbers>

namespace qm {

QuadList cubeShape(int n) {
    return refined(voxelSurface(voxelBox(1, 1, 1)), n);
}

QuadList sphereShape(int n) {
    QuadList list = cubeShape(n);
    for (Point& point : list.points) {
        for (double& coordinate : point)
            coordinate = std::tan((2 * coordinate - 1) * std::numbers::pi / 4);
        point.normalize();
    }
    return list;
}

} // namespace qm
