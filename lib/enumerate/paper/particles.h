/// \file Where particles may stop and who else arrives there: the setting of A1 to A4
/// (docs/METHOD.md#valid-tracks).
#pragma once

#include "enumerate/state/assignment.h"

#include <vector>

namespace qm {

/// The particle that arrives at a stop from one side: the index of its course, -1 if none does, and the
/// coordinate that the stop has there.
struct Arrival {
    int course = -1;
    int coordinate = 0;
};

/// A candidate stop strictly between the ends of a course.
struct Stop {
    Arrival left;
    Arrival right;
    /// The crossing line is there in every graph and nobody can pass it: stopping is always right.
    bool wall = false;
};

/// What a particle may walk: a chain, from its source on. Coordinates count variables.
struct Course {
    int chain = 0;
    bool fromEnd = false;
    int length = 0;
    int opposite = -1; ///< index of the course of the particle that comes the other way; -1 if none does
    int max = 0;       ///< the domains allow no stop after this coordinate
    std::vector<Stop> stops; ///< at coordinates 1 .. length - 1, so stops[c - 1] is at c
};

/// The courses of all particles of a problem, by chain.
[[nodiscard]] std::vector<Course> findCourses(const Problem& problem);

/// The arcs that particles at these coordinates have walked.
[[nodiscard]] Assignment assignmentOf(const Problem& problem, const std::vector<Course>& courses,
                                      const std::vector<int>& coordinates);

/// Whether tracks of these lengths obey A1 to A4.
[[nodiscard]] bool validCoordinates(const std::vector<Course>& courses, const std::vector<int>& coordinates);

} // namespace qm
