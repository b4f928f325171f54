#include "bspline/patch_distance.h"

#include <algorithm>
#include <cmath>

namespace qm {

double distanceToPatch(const Patch& patch, const Point& point, double u, double v,
                       const SurfacePoint& start) {
    SurfacePoint on = start;
    const auto range = domain(patch);
    double best = (on.position - point).norm();
    for (int k = 0; k < 10; ++k) {
        const Point away = on.position - point;
        const double uu = on.du.sqrnorm();
        const double vv = on.dv.sqrnorm();
        const double uv = on.du | on.dv;
        const double gu = away | on.du;
        const double gv = away | on.dv;
        const double determinant = uu * vv - uv * uv;
        if (!(determinant > 1e-12 * uu * vv)) break;
        const double stepU = std::clamp(u + (uv * gv - vv * gu) / determinant, range[0][0], range[0][1]) - u;
        const double stepV = std::clamp(v + (uv * gu - uu * gv) / determinant, range[1][0], range[1][1]) - v;
        if (std::abs(stepU) + std::abs(stepV) < 1e-6) break;
        double distance = best;
        SurfacePoint next = on;
        double share = 1;
        for (int halving = 0; halving < 5; ++halving, share /= 2) {
            next = evaluate(patch, u + share * stepU, v + share * stepV);
            distance = (next.position - point).norm();
            if (distance < best) break;
        }
        const bool settled = distance > 0.999 * best;
        best = std::min(best, distance);
        if (settled) break;
        u += share * stepU;
        v += share * stepV;
        on = next;
    }
    return best;
}

} // namespace qm
