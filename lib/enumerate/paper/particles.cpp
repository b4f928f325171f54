#include "enumerate/paper/particles.h"

#include <algorithm>

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

/// Finds the particles that walk over a variable.
struct Owners {
    std::vector<int> chain;      ///< of every variable; -1 for the constants
    std::vector<int> fromBefore; ///< of every variable and constant; -1 if none
    std::vector<int> fromAfter;

    /// Not so at a feature seed or on a line that is fixed.
    [[nodiscard]] bool canPass(const CrossingSide& side) const {
        return chain[at(side.before)] >= 0 && chain[at(side.before)] == chain[at(side.after)] &&
               side.after == side.before + 1;
    }
};

int coordinateAfter(const Problem& problem, const Course& course, int variable) {
    const Chain& chain = problem.chains[at(course.chain)];
    return course.fromEnd ? chain.first + chain.count - variable : variable - chain.first + 1;
}

Stop stopAt(const Problem& problem, const Crossing& crossing, std::size_t side, const Owners& owners,
            const std::vector<Course>& courses) {
    const CrossingSide& other = crossing.sides[1 - side];
    Stop stop;
    const bool both =
        problem.domains[at(other.before)] == ArcState::in && problem.domains[at(other.after)] == ArcState::in;
    stop.wall = both && !owners.canPass(other);
    if (stop.wall) return stop;
    stop.left.course = owners.fromBefore[at(other.before)];
    stop.right.course = owners.fromAfter[at(other.after)];
    if (stop.left.course >= 0)
        stop.left.coordinate = coordinateAfter(problem, courses[at(stop.left.course)], other.before);
    if (stop.right.course >= 0)
        stop.right.coordinate = coordinateAfter(problem, courses[at(stop.right.course)], other.after);
    return stop;
}

void findStops(const Problem& problem, const Owners& owners, std::vector<Course>& courses) {
    for (Course& course : courses)
        course.stops.resize(at(std::max(course.length - 1, 0)));
    for (const Crossing& crossing : problem.crossings)
        for (const std::size_t k : {0U, 1U}) {
            const CrossingSide& side = crossing.sides[k];
            if (!owners.canPass(side)) continue;
            const Stop stop = stopAt(problem, crossing, k, owners, courses);
            for (const auto& [owner, variable] : {std::pair(owners.fromBefore[at(side.before)], side.before),
                                                  std::pair(owners.fromAfter[at(side.after)], side.after)})
                if (owner >= 0)
                    courses[at(owner)].stops[at(coordinateAfter(problem, courses[at(owner)], variable) - 1)] =
                        stop;
        }
}

void boundByDomains(const Problem& problem, Course& course) {
    const Chain& chain = problem.chains[at(course.chain)];
    course.max = course.length;
    for (int c = 1; c <= course.length; ++c) {
        const int variable = course.fromEnd ? chain.first + chain.count - c : chain.first + c - 1;
        if (problem.domains[at(variable)] == ArcState::out) course.max = std::min(course.max, c - 1);
    }
}

bool passes(const Arrival& arrival, const std::vector<int>& x) {
    return arrival.course >= 0 && x[at(arrival.course)] > arrival.coordinate;
}

bool ends(const Arrival& arrival, const std::vector<int>& x) {
    return arrival.course >= 0 && x[at(arrival.course)] == arrival.coordinate;
}

/// A4 at the crash point: someone else makes it a proper end.
bool crashesWell(const Stop& stop, bool met, const std::vector<int>& x) {
    return met || stop.wall || passes(stop.left, x) || passes(stop.right, x) ||
           (ends(stop.left, x) && ends(stop.right, x));
}

} // namespace

std::vector<Course> findCourses(const Problem& problem) {
    std::vector<Course> courses;
    const std::vector<int> nobody(problem.domains.size(), -1);
    Owners owners{nobody, nobody, nobody};
    for (int c = 0; c < static_cast<int>(problem.chains.size()); ++c) {
        const Chain& chain = problem.chains[at(c)];
        const bool both = chain.coveredBefore && chain.coveredAfter;
        std::fill_n(owners.chain.begin() + chain.first, chain.count, c);
        for (const bool fromEnd : {false, true}) {
            if (!(fromEnd ? chain.coveredAfter : chain.coveredBefore)) continue;
            const int id = static_cast<int>(courses.size());
            courses.push_back({c, fromEnd, chain.count, both ? (fromEnd ? id - 1 : id + 1) : -1, 0, {}});
            boundByDomains(problem, courses.back());
            for (int v = chain.first; v < chain.first + chain.count; ++v)
                (fromEnd ? owners.fromAfter : owners.fromBefore)[at(v)] = id;
        }
    }
    findStops(problem, owners, courses);
    return courses;
}

Assignment assignmentOf(const Problem& problem, const std::vector<Course>& courses,
                        const std::vector<int>& coordinates) {
    Assignment assignment(problem.domains.size(), 0);
    assignment[at(problem.in())] = 1;
    for (std::size_t i = 0; i < courses.size(); ++i) {
        const Chain& chain = problem.chains[at(courses[i].chain)];
        for (int c = 0; c < coordinates[i]; ++c)
            assignment[at(courses[i].fromEnd ? chain.first + chain.count - 1 - c : chain.first + c)] = 1;
    }
    return assignment;
}

bool validCoordinates(const std::vector<Course>& courses, const std::vector<int>& x) {
    for (std::size_t i = 0; i < courses.size(); ++i) {
        const Course& p = courses[i];
        const int opposite = p.opposite >= 0 ? x[at(p.opposite)] : 0;
        if (x[i] + opposite > p.length) return false;                            // A1
        if (x[i] == 0 && (p.opposite < 0 || opposite != p.length)) return false; // A3
        for (int c = 1; c < x[i]; ++c) {                                         // A2
            const Stop& stop = p.stops[at(c - 1)];
            if (stop.wall || passes(stop.left, x) || passes(stop.right, x)) return false;
        }
        if (x[i] > 0 && x[i] < p.length && // A4
            !crashesWell(p.stops[at(x[i] - 1)], p.opposite >= 0 && x[i] + opposite == p.length, x))
            return false;
    }
    return true;
}

} // namespace qm
