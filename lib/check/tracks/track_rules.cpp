#include "check/tracks/track_rules.h"

#include "base/at.h"

namespace qm::check {

namespace {

class TrackRules {
public:
    TrackRules(const LineNetwork& network, std::span<const int> x) : network_(network), x_(x) {}

    std::vector<BrokenTrackRule> run() {
        for (way_ = 0; way_ < static_cast<int>(network_.ways.size()); ++way_) {
            noOverlap();
            noCrossing();
            noIdleParticle();
            noDanglingEnd();
        }
        return std::move(broken_);
    }

private:
    [[nodiscard]] const Way& way() const { return network_.ways[at(way_)]; }
    [[nodiscard]] int x(int way) const { return x_[at(way)]; }
    [[nodiscard]] bool passes(const Arrival& other) const {
        return other.way >= 0 && x(other.way) > other.coordinate;
    }
    [[nodiscard]] bool endsAt(const Arrival& other) const {
        return other.way >= 0 && x(other.way) == other.coordinate;
    }

    void broken(const char* rule, std::string explanation) {
        broken_.push_back({rule, way_, std::move(explanation)});
    }

    // A1: x_i + x_o <= L.
    void noOverlap() {
        if (way().opposite > way_ && x(way_) + x(way().opposite) > way().length())
            broken("A1", "it and the opposite track overlap: " + std::to_string(x(way_)) + " and " +
                             std::to_string(x(way().opposite)) + " of " + std::to_string(way().length()) +
                             " arcs");
    }

    // A2: where T_i passes through a junction, neither the left nor the right track does.
    void noCrossing() {
        for (int k = 1; k < way().length() && k < x(way_); ++k) {
            const Meeting here = meetingAt(network_, way_, k);
            const std::string vertex = std::to_string(here.crossing->vertex);
            if (here.crossing->seeded) broken("A2", "it passes through the feature seed at vertex " + vertex);
            if (passes(here.left()) || passes(here.right()))
                broken("A2", "another track passes through it at vertex " + vertex);
        }
    }

    // A3: x_i = 0 only if x_o = L; without an opposite, x_i >= 1.
    void noIdleParticle() {
        if (x(way_) > 0) return;
        if (way().opposite < 0 || x(way().opposite) < way().length())
            broken("A3", "its particle stays at the source, and no opposite particle arrives there");
    }

    // A4: if 0 < x_i < L, something stops it at its crash point.
    void noDanglingEnd() {
        if (x(way_) <= 0 || x(way_) >= way().length()) return;
        const Meeting here = meetingAt(network_, way_, x(way_));
        const bool metHeadOn = way().opposite >= 0 && x(way_) + x(way().opposite) == way().length();
        const bool stoppedBySeed = here.crossing->seeded;
        const bool stoppedBySide = passes(here.left()) || passes(here.right());
        const bool allEndHere = endsAt(here.left()) && endsAt(here.right());
        if (!metHeadOn && !stoppedBySeed && !stoppedBySide && !allEndHere)
            broken("A4",
                   "it ends at vertex " + std::to_string(here.crossing->vertex) + ", where nothing stops it");
    }

    const LineNetwork& network_;
    std::span<const int> x_;
    int way_ = 0;
    std::vector<BrokenTrackRule> broken_;
};

} // namespace

std::vector<BrokenTrackRule> brokenTrackRules(const LineNetwork& network, std::span<const int> coordinates) {
    return TrackRules(network, coordinates).run();
}

} // namespace qm::check
