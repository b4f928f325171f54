/// \file The numbers by which a plane, cylinder, cone, sphere or torus of OpenCASCADE is defined.
#pragma once

#include <Geom_ElementarySurface.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>
#include <variant>

namespace qm {

using ElementaryNumbers = std::variant<gp_Pln, gp_Cylinder, gp_Cone, gp_Sphere, gp_Torus>;

[[nodiscard]] ElementaryNumbers numbersOf(const Handle(Geom_ElementarySurface) & surface);

} // namespace qm
