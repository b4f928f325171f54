#include "export/simple/elementary_numbers.h"

#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>

namespace qm {

ElementaryNumbers numbersOf(const Handle(Geom_ElementarySurface) & surface) {
    if (const auto plane = Handle(Geom_Plane)::DownCast(surface); !plane.IsNull()) return plane->Pln();
    if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface); !cylinder.IsNull())
        return cylinder->Cylinder();
    if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface); !cone.IsNull()) return cone->Cone();
    if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface); !sphere.IsNull())
        return sphere->Sphere();
    return Handle(Geom_ToroidalSurface)::DownCast(surface)->Torus();
}

} // namespace qm
