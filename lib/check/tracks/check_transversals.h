/// \file Do transversals only divide annuli? (docs/METHOD.md#layout)
#pragma once

#include "check/document/report.h"
#include "check/mesh/neighbourhoods.h"
#include "check/tracks/check_graph.h"

#include <span>
#include <string>

namespace qm::check {

/// A transversal runs straight and inside from one track or boundary to another, and meets no track between.
/// \param tracks        all of the layout, the transversals among them
/// \param transversals  those to be tested
/// \param pointer       of the list of tracks
void checkTransversals(const Neighbourhoods& around, std::span<const ReadTrack> tracks,
                       std::span<const ReadTrack> transversals, const std::string& pointer, Report& report);

} // namespace qm::check
