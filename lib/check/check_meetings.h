/// \file Do patches meet as well as the document states?
#pragma once

#include "check/check_figures.h"

namespace qm::check {

/// Gaps and angles between normals: at 16 samples of every edge at which two patches meet, the first and the
/// last at 1/200 of the edge from its ends; and along every line within a patch at which a knot is repeated
/// as often as the degree says. Takes the arguments of `checkFigures`, which calls it.
void checkMeetings(const Context& context, const LayoutPart& layout, const SurfacesPart& part,
                   Report& report);

/// Reports a figure of a patch that is less than what is found.
/// \param slack  for rounding
/// \param where  ends the sentence
/// \return whether it is less
bool checkFigure(std::size_t patch, const char* figure, const std::optional<double>& stated, double found,
                 double slack, const std::string& where, Report& report);

} // namespace qm::check
