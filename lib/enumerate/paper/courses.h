/// \file Where particles may stop and which others arrive there, as rules A1 to A4 need it
/// (docs/METHOD.md#valid-tracks).
#pragma once

#include "base/at.h"
#include "enumerate/state/assignment.h"

#include <vector>

namespace qm {

using CourseId = Id<struct CourseTag>;

/// The particle that arrives at a stop from one side: its course, none if no particle can arrive, and the
/// coordinate of the stop on that course.
struct Arrival {
    CourseId course;
    int coordinate = 0;
};

/// A candidate stop strictly between the ends of a course.
struct Stop {
    Arrival left;
    Arrival right;
    /// Nobody can pass, because the crossing line is there in every graph or the sub-mesh ends: stopping is
    /// always right.
    bool wall = false;
};

/// The path open to a particle: a chain, from its source on. Coordinates count variables.
struct Course {
    ChainId chain;
    bool fromEnd = false;
    int length = 0;
    CourseId opposite;       ///< of the particle from the other end; none if there is none
    int max = 0;             ///< the largest coordinate that the domains allow
    std::vector<Stop> stops; ///< indexed by `stopIndex`

    /// The index in `stops` of the stop at a coordinate from 1 to length - 1.
    [[nodiscard]] static std::size_t stopIndex(int coordinate) { return at(coordinate) - 1; }
};

using Courses = IdVector<CourseId, Course>;
/// How many variables every particle has walked.
using Coordinates = IdVector<CourseId, int>;

/// The courses of all particles of a problem, by chain.
[[nodiscard]] Courses findCourses(const Problem& problem);

/// The graph of particles at these coordinates.
[[nodiscard]] Assignment assignmentOf(const Problem& problem, const Courses& courses,
                                      const Coordinates& coordinates);

/// Whether tracks of these lengths obey rules A1 to A4.
[[nodiscard]] bool validCoordinates(const Courses& courses, const Coordinates& coordinates);

} // namespace qm
