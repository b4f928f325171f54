#include "check/tracks/track_rules.h"

#include "base/at.h"

namespace qm::check {

namespace {

class TrackRules {
public:
    TrackRules(const LineNetwork& network, std::span<const int> x) : network_(network), x_(x) {}

    std::vector<BrokenTrackRule> run() {
        for (int way = 0; way < static_cast<int>(network_.ways.size()); ++way) {
            noOverlap(way);
            noCrossing(way);
            noIdleParticle(way);
            noDanglingEnd(way);
        }
        return std::move(broken_);
    }

private:
    [[nodiscard]] int x(int way) const { return x_[at(way)]; }
    [[nodiscard]] int length(int way) const { return network_.ways[at(way)].length(); }
    [[nodiscard]] int opposite(int way) const { return network_.ways[at(way)].opposite; }
    [[nodiscard]] bool passes(const Arrival& other) const {
        return other.way >= 0 && x(other.way) > other.coordinate;
    }
    [[nodiscard]] bool endsAt(const Arrival& other) const {
        return other.way >= 0 && x(other.way) == other.coordinate;
    }

    void broken(const char* rule, int way, std::string explanation) {
        broken_.push_back({rule, way, std::move(explanation)});
    }

    // A1: x_i + x_o <= L.
    void noOverlap(int i) {
        const int o = opposite(i);
        if (o > i && x(i) + x(o) > length(i))
            broken("A1", i,
                   "it and the opposite track overlap: " + std::to_string(x(i)) + " and " +
                       std::to_string(x(o)) + " of " + std::to_string(length(i)) + " arcs");
    }

    // A2: where T_i passes through a junction, neither the left nor the right track does.
    void noCrossing(int i) {
        for (int k = 1; k < length(i) && k < x(i); ++k) {
            const Meeting here = meetingAt(network_, i, k);
            const std::string vertex = std::to_string(here.crossing->vertex);
            if (here.crossing->seeded)
                broken("A2", i, "it passes through the feature seed at vertex " + vertex);
            if (passes(here.left()) || passes(here.right()))
                broken("A2", i, "another track passes through it at vertex " + vertex);
        }
    }

    // A3: x_i = 0 only if x_o = L; without an opposite, x_i >= 1.
    void noIdleParticle(int i) {
        if (x(i) == 0 && (opposite(i) < 0 || x(opposite(i)) < length(i)))
            broken("A3", i, "its particle stays at the source, and no opposite particle arrives there");
    }

    // A4: if 0 < x_i < L, something stops it at its crash point.
    void noDanglingEnd(int i) {
        if (x(i) <= 0 || x(i) >= length(i)) return;
        const Meeting here = meetingAt(network_, i, x(i));
        const bool metHeadOn = opposite(i) >= 0 && x(i) + x(opposite(i)) == length(i);
        const bool stoppedBySeed = here.crossing->seeded;
        const bool stoppedBySide = passes(here.left()) || passes(here.right());
        const bool allEndHere = endsAt(here.left()) && endsAt(here.right());
        if (!metHeadOn && !stoppedBySeed && !stoppedBySide && !allEndHere)
            broken("A4", i,
                   "it ends at vertex " + std::to_string(here.crossing->vertex) + ", where nothing stops it");
    }

    const LineNetwork& network_;
    std::span<const int> x_;
    std::vector<BrokenTrackRule> broken_;
};

} // namespace

std::vector<BrokenTrackRule> brokenTrackRules(const LineNetwork& network, std::span<const int> coordinates) {
    return TrackRules(network, coordinates).run();
}

} // namespace qm::check
