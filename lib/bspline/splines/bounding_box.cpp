#include "bspline/splines/bounding_box.h"

#include "mesh/bounding_box.h"

namespace qm {

double boundingBoxDiagonal(const QuadMesh& mesh) {
    return boundingBox(mesh).diagonal();
}

} // namespace qm
