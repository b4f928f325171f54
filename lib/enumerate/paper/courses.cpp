#include "enumerate/paper/courses.h"

#include <algorithm>

namespace qm {
namespace {

/// For every variable its chain, and the particles that can walk over it.
struct Owners {
    IdVector<VariableId, ChainId> chain;       ///< none for the constants
    IdVector<VariableId, CourseId> fromBefore; ///< none for constants, and if no particle comes from there
    IdVector<VariableId, CourseId> fromAfter;

    /// Whether particles can pass this side; not at a feature seed or on a fixed line.
    [[nodiscard]] bool canPass(const CrossingSide& side) const {
        return !side.seeded && chain[side.before].valid() && chain[side.before] == chain[side.after] &&
               side.after == side.before + 1;
    }
};

/// The variable that a particle walks last on its way to a coordinate, which is at least 1.
VariableId variableBefore(const Problem& problem, const Course& course, int coordinate) {
    const Chain& chain = problem.chains[course.chain];
    return course.fromEnd ? chain.first + chain.count - coordinate : chain.first + coordinate - 1;
}

int coordinateAfter(const Problem& problem, const Course& course, VariableId variable) {
    const Chain& chain = problem.chains[course.chain];
    const int places = variable.value() - chain.first.value();
    return course.fromEnd ? chain.count - places : places + 1;
}

Stop stopAt(const Problem& problem, const Crossing& crossing, std::size_t side, const Owners& owners,
            const Courses& courses) {
    const CrossingSide& other = crossing.sides[1 - side];
    Stop stop;
    const bool both =
        problem.domains[other.before] == ArcState::in && problem.domains[other.after] == ArcState::in;
    stop.wall = both && !owners.canPass(other);
    if (stop.wall) return stop;
    stop.left.course = owners.fromBefore[other.before];
    stop.right.course = owners.fromAfter[other.after];
    if (stop.left.course.valid())
        stop.left.coordinate = coordinateAfter(problem, courses[stop.left.course], other.before);
    if (stop.right.course.valid())
        stop.right.coordinate = coordinateAfter(problem, courses[stop.right.course], other.after);
    return stop;
}

void findStops(const Problem& problem, const Owners& owners, Courses& courses) {
    // Where chains have no crossing, or an open one, the sub-mesh ends, and so does the track of whoever
    // arrives.
    for (Course& course : courses)
        course.stops.assign(Course::stopIndex(std::max(course.length, 1)), Stop{{}, {}, true});
    for (const Crossing& crossing : problem.crossings)
        for (const std::size_t k : {0U, 1U}) {
            const CrossingSide& side = crossing.sides[k];
            if (crossing.open || !owners.canPass(side)) continue;
            const Stop stop = stopAt(problem, crossing, k, owners, courses);
            for (const auto& [owner, variable] : {std::pair(owners.fromBefore[side.before], side.before),
                                                  std::pair(owners.fromAfter[side.after], side.after)})
                if (owner.valid()) {
                    const int coordinate = coordinateAfter(problem, courses[owner], variable);
                    courses[owner].stops[Course::stopIndex(coordinate)] = stop;
                }
        }
}

void boundByDomains(const Problem& problem, Course& course) {
    course.max = 0;
    while (course.max < course.length &&
           problem.domains[variableBefore(problem, course, course.max + 1)] != ArcState::out)
        ++course.max;
}

bool passes(const Arrival& arrival, const Coordinates& x) {
    return arrival.course.valid() && x[arrival.course] > arrival.coordinate;
}

bool ends(const Arrival& arrival, const Coordinates& x) {
    return arrival.course.valid() && x[arrival.course] == arrival.coordinate;
}

/// A4: whether a track that ends at this stop ends properly.
bool crashesWell(const Stop& stop, bool met, const Coordinates& x) {
    return met || stop.wall || passes(stop.left, x) || passes(stop.right, x) ||
           (ends(stop.left, x) && ends(stop.right, x));
}

} // namespace

Courses findCourses(const Problem& problem) {
    Courses courses;
    const std::size_t variables = problem.domains.size();
    Owners owners{IdVector<VariableId, ChainId>(variables), IdVector<VariableId, CourseId>(variables),
                  IdVector<VariableId, CourseId>(variables)};
    for (const ChainId c : problem.chains.ids()) {
        const Chain& chain = problem.chains[c];
        const bool both = chain.coveredBefore && chain.coveredAfter;
        for (const VariableId v : chain.variables())
            owners.chain[v] = c;
        for (const bool fromEnd : {false, true}) {
            if (!(fromEnd ? chain.coveredAfter : chain.coveredBefore)) continue;
            const CourseId id = courses.nextId();
            courses.push_back(
                {c, fromEnd, chain.count, both ? (fromEnd ? id - 1 : id + 1) : CourseId(), 0, {}});
            boundByDomains(problem, courses.back());
            for (const VariableId v : chain.variables())
                (fromEnd ? owners.fromAfter : owners.fromBefore)[v] = id;
        }
    }
    findStops(problem, owners, courses);
    return courses;
}

Assignment assignmentOf(const Problem& problem, const Courses& courses, const Coordinates& coordinates) {
    Assignment assignment(problem.domains.size(), 0);
    assignment[problem.in()] = 1;
    for (const CourseId i : courses.ids())
        for (int c = 1; c <= coordinates[i]; ++c)
            assignment[variableBefore(problem, courses[i], c)] = 1;
    return assignment;
}

bool validCoordinates(const Courses& courses, const Coordinates& x) {
    for (const CourseId i : courses.ids()) {
        const Course& p = courses[i];
        const int opposite = p.opposite.valid() ? x[p.opposite] : 0;
        if (x[i] + opposite > p.length) return false;                                 // A1
        if (x[i] == 0 && (!p.opposite.valid() || opposite != p.length)) return false; // A3
        for (int c = 1; c < x[i]; ++c) {                                              // A2
            const Stop& stop = p.stops[Course::stopIndex(c)];
            if (stop.wall || passes(stop.left, x) || passes(stop.right, x)) return false;
        }
        if (x[i] > 0 && x[i] < p.length && // A4
            !crashesWell(p.stops[Course::stopIndex(x[i])], p.opposite.valid() && x[i] + opposite == p.length,
                         x))
            return false;
    }
    return true;
}

} // namespace qm
