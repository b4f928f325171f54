/// \file Scans of sample parts: dense triangles, with the errors of measurement.
#pragma once

#include "mesh/triangles/triangles.h"

#include <cstdint>

namespace qm {

struct QuadList;

/// Every quad becomes two triangles, divided by its shorter diagonal.
[[nodiscard]] Triangles trianglesOf(const QuadList& list);

/// Moves every point along its normal, the mean of those around it, by a normally distributed length.
/// \param deviation  the standard deviation of that length
void addNoise(Triangles& triangles, double deviation, std::uint64_t seed);

} // namespace qm
