#include "export/simple/straight_seam.h"

#include "export/simple/curve_on_surface.h"

#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <cmath>
#include <cstddef>
#include <gp_Ax1.hxx>
#include <gp_Lin.hxx>

namespace qm {
namespace {

/// Half-angle, and radius where the axis begins.
std::optional<std::array<double, 2>> profileOf(const SimpleSurface& surface) {
    if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface.surface); !cylinder.IsNull())
        return std::array{0.0, cylinder->Radius()};
    if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface.surface); !cone.IsNull())
        return std::array{cone->SemiAngle(), cone->RefRadius()};
    return std::nullopt;
}

gp_XYZ awayFrom(const gp_Ax1& axis, const gp_Pnt& point) {
    const gp_XYZ from = point.XYZ() - axis.Location().XYZ();
    return from - axis.Direction().XYZ() * from.Dot(axis.Direction().XYZ());
}

} // namespace

bool areOneRuledSurface(const SimpleSurface& one, const SimpleSurface& other, double resolution) {
    const auto first = profileOf(one);
    const auto second = profileOf(other);
    constexpr double sameAngle = 1e-9;
    const gp_Ax1& axis = one.surface->Axis();
    const gp_Ax1& along = other.surface->Axis();
    if (!first || !second || std::abs((*first)[0] - (*second)[0]) > sameAngle ||
        axis.Direction().Angle(along.Direction()) > sameAngle ||
        awayFrom(axis, along.Location()).Modulus() > resolution)
        return false;
    const double height = (along.Location().XYZ() - axis.Location().XYZ()).Dot(axis.Direction().XYZ());
    return std::abs((*first)[1] + height * std::tan((*first)[0]) - (*second)[1]) <= resolution;
}

std::optional<std::array<gp_Pnt, 2>> straightened(const SimpleSurface& ruled,
                                                  const std::array<gp_Pnt, 2>& ends,
                                                  const std::array<std::vector<SimpleSurface>, 2>& others) {
    const gp_Ax1& axis = ruled.surface->Axis();
    const std::array<gp_XYZ, 2> away{awayFrom(axis, ends[0]), awayFrom(axis, ends[1])};
    if (!(away[0].Dot(away[1]) > 0)) return std::nullopt;
    const gp_XYZ middle = (away[0].Normalized() + away[1].Normalized()).Normalized();
    std::array<gp_Pnt, 2> onLine;
    for (std::size_t k = 0; k < 2; ++k)
        onLine.at(k) = commonPoint(ends.at(k).XYZ() + middle * away.at(k).Modulus() - away.at(k), {ruled});
    if (!(onLine[0].Distance(onLine[1]) > ends[0].Distance(ends[1]) / 2)) return std::nullopt;
    const gp_Lin line(onLine[0], gp_Dir(onLine[1].XYZ() - onLine[0].XYZ()));
    const gp_XYZ along = line.Direction().XYZ();
    std::array<gp_Pnt, 2> result = onLine;
    constexpr int rounds = 100; // as many as for a common point
    for (std::size_t k = 0; k < 2; ++k)
        for (int round = 0; round < rounds && !others.at(k).empty(); ++round) {
            const gp_XYZ on = commonPoint(result.at(k), others.at(k)).XYZ();
            result.at(k) = line.Location().XYZ() + along * (on - line.Location().XYZ()).Dot(along);
        }
    return result;
}

} // namespace qm
