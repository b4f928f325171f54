#include "enumerate/paper/coordinates.h"

#include "base/error.h"
#include "enumerate/paper/courses.h"

#include <algorithm>

namespace qm {
namespace {

using Visit = std::function<bool(const Assignment&)>;
using StopRequested = std::function<bool()>;

/// What the searches share.
struct Search {
    const Problem& problem;
    const Visit& visit;
    const StopRequested& stopRequested;
    const Courses courses;
    std::size_t steps = 0;

    /// Asks the caller now and then whether to stop, because most steps lead to no graph.
    bool isEnded() { return ++steps % 4096 == 0 && stopRequested(); }

    /// Visits the graph of a vector unless it lacks a variable that is in from the start. Courses know only
    /// which variables are out: one that is in may be walked by either particle of its chain.
    [[nodiscard]] bool visitGraph(const Coordinates& x) const {
        const Assignment graph = assignmentOf(problem, courses, x);
        const bool isValid = std::ranges::all_of(problem.variables(), [&](VariableId variable) {
            return graph[variable] == 1 || problem.domains[variable] != ArcState::in;
        });
        return !isValid || visit(graph);
    }
};

/// Tries all values of the coordinates from the given one on.
bool searchNaively(Search& search, Coordinates& x, CourseId i) {
    if (search.isEnded()) return false;
    if (i == search.courses.nextId()) return !validCoordinates(search.courses, x) || search.visitGraph(x);
    for (x[i] = 0; x[i] <= search.courses[i].max; ++x[i])
        if (!searchNaively(search, x, i + 1)) return false;
    return true;
}

/// Depth first over the particles with bounds L_i <= x_i <= U_i, kept on a stack for undoing.
class BoundedSearch {
public:
    BoundedSearch(Search& search, bool improved)
        : search_(search), courses_(search.courses), improved_(improved), lower_(courses_.size(), 0) {
        for (const Course& course : courses_)
            upper_.push_back(course.max);
    }

    bool run(CourseId i = CourseId(0)) {
        if (search_.isEnded()) return false;
        if (i == courses_.nextId()) return search_.visitGraph(lower_);
        for (int j = lower_[i], last = upper_[i]; j <= last; ++j) {
            const std::size_t mark = undo_.size();
            const bool goOn = !(fix(i, j) && block(courses_[i], j)) || finish(i, j);
            rewind(mark);
            if (!goOn) return false;
        }
        return true;
    }

private:
    struct Undo {
        CourseId course;
        int lower;
        int upper;
    };

    bool raise(CourseId course, int bound) {
        if (bound <= lower_[course]) return true;
        undo_.push_back({course, lower_[course], upper_[course]});
        lower_[course] = bound;
        return bound <= upper_[course];
    }

    bool reduce(CourseId course, int bound) {
        if (bound >= upper_[course]) return true;
        undo_.push_back({course, lower_[course], upper_[course]});
        upper_[course] = bound;
        return bound >= lower_[course];
    }

    bool fix(CourseId course, int value) { return raise(course, value) && reduce(course, value); }

    void rewind(std::size_t mark) {
        for (; undo_.size() > mark; undo_.pop_back()) {
            lower_[undo_.back().course] = undo_.back().lower;
            upper_[undo_.back().course] = undo_.back().upper;
        }
    }

    /// B1 and B2: restricts the other particles to what a track of length j leaves them.
    bool block(const Course& p, int j) {
        if (p.opposite.valid() && !reduce(p.opposite, p.length - j)) return false;
        for (int c = 1; c < j; ++c) {
            const Stop& stop = p.stops[Course::stopIndex(c)];
            if (stop.wall) return false;
            for (const Arrival& arrival : {stop.left, stop.right})
                if (arrival.course.valid() && !reduce(arrival.course, arrival.coordinate)) return false;
        }
        return true;
    }

    /// B3 and B4 (or B4'): continues with every valid way for a track of length j to end.
    bool finish(CourseId i, int j) {
        const Course& p = courses_[i];
        if (j == p.length) return run(i + 1);
        if (j == 0) return branch(i, p.opposite.valid() && raise(p.opposite, p.length));
        const Stop& stop = p.stops[Course::stopIndex(j)];
        return improved_ ? finishImproved(i, stop) : finishAll(i, stop, j);
    }

    bool branch(CourseId i, bool possible) { return !possible || run(i + 1); }

    /// Tries one way to end and undoes it.
    /// \return false if the visitor ended the search
    template <class Ending> bool attempt(CourseId i, const Ending& ending) {
        const std::size_t mark = undo_.size();
        const bool goOn = branch(i, ending());
        rewind(mark);
        return goOn;
    }

    bool letPass(const Arrival& arrival) {
        return arrival.course.valid() && raise(arrival.course, arrival.coordinate + 1);
    }

    bool finishImproved(CourseId i, const Stop& stop) {
        if (stop.wall) return attempt(i, [] { return true; });
        return attempt(i, [&] { return letPass(stop.left); }) &&
               attempt(i, [&] { return letPass(stop.right); });
    }

    bool finishAll(CourseId i, const Stop& stop, int j) {
        const Course& p = courses_[i];
        const int rest = p.length - j;
        const auto apart = [&] { return !p.opposite.valid() || reduce(p.opposite, rest - 1); };
        const auto bothEnd = [&] {
            return stop.left.course.valid() && stop.right.course.valid() &&
                   fix(stop.left.course, stop.left.coordinate) &&
                   fix(stop.right.course, stop.right.coordinate);
        };
        return attempt(i, [&] { return p.opposite.valid() && fix(p.opposite, rest); }) &&
               attempt(i, [&] { return apart() && letPass(stop.left); }) &&
               attempt(i, [&] { return apart() && letPass(stop.right); }) &&
               attempt(i, [&] { return apart() && (stop.wall || bothEnd()); });
    }

    Search& search_;
    const Courses& courses_;
    bool improved_;
    Coordinates lower_;
    Coordinates upper_;
    std::vector<Undo> undo_;
};

/// These searches take a call for every particle, and there is no hope for so many anyway.
constexpr std::size_t maxParticles = 5000;

} // namespace

bool forEachCoordinateVector(const Problem& problem, CoordinateMethod method, const Visit& visit,
                             const StopRequested& stopRequested) {
    Search search{problem, visit, stopRequested, findCourses(problem)};
    const std::size_t count = search.courses.size();
    if (count > maxParticles)
        throw Error("",
                    std::to_string(count) + " particles are too many for the paper's methods, which take " +
                        std::to_string(maxParticles),
                    "Use --method optimum, or a smaller --chi of qm-cut");
    if (method != CoordinateMethod::naive)
        return BoundedSearch(search, method == CoordinateMethod::improved).run();
    Coordinates x(count);
    return searchNaively(search, x, CourseId(0));
}

} // namespace qm
