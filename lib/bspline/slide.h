/// \file Errors of a fit as distances: sliding along what is fitted hardly counts.
#pragma once

namespace qm {

/// How far a point may slide, as a share of an edge. More would leave the neighbourhood in which the distance
/// from the tangent tells the distance from the thing itself. A patch has more room than the curves of its
/// border, so that it can follow them.
constexpr double curveSlide = 0.12;
constexpr double patchSlide = 0.15;

/// Sliding counts at least this much as an error, so that the parametrisation stays even.
constexpr double leastSlideWeight = 0.25;

} // namespace qm
