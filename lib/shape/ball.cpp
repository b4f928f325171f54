#include "shape/ball.h"

#include "shape/voxels.h"

#include <cmath>
#include <numbers>

namespace qm {

QuadList cubeShape(int n) {
    return refined(voxelSurface(voxelBox(1, 1, 1)), n);
}

TrueSurface cubeSurface() {
    const std::vector<FlatFace> faces = boxFaces({1, 1, 1});
    return TrueSurface({faces.begin(), faces.end()});
}

TrueSurface sphereSurface() {
    return TrueSurface({Revolved{.radius = 1, .angles = {-std::numbers::pi / 2, std::numbers::pi / 2}}});
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
