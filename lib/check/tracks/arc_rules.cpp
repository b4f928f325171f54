#include "check/tracks/arc_rules.h"

#include "base/at.h"
#include "base/disjoint_sets.h"

#include <algorithm>

namespace qm::check {

namespace {

/// An undirected separatrix.
struct ArcLine {
    const Way* way = nullptr; ///< one of its directions; the one with a source, if only one has
    bool twoSources = false;
    std::vector<char> arcs; ///< whether each is in the graph
    bool full = false;      ///< every arc is
};

/// One line's two arcs at a junction.
struct Side {
    int line = -1;
    bool before = false;
    bool after = false;
    [[nodiscard]] int present() const { return before + after; }
};

/// Groups of lines that are joined by crossings; each crossing must be cracked by a line of its group.
class Groups {
public:
    explicit Groups(std::size_t lines) : joined_(lines), left_(lines, 1) {}

    /// \return false if the group of the two lines has more crossings than lines now
    bool addCrossing(int a, int b) {
        const std::size_t one = joined_.find(at(a)), other = joined_.find(at(b));
        joined_.join(one, other);
        int& left = left_[joined_.find(one)];
        if (one != other) left = left_[one] + left_[other];
        return --left >= 0;
    }

private:
    DisjointSets joined_;
    std::vector<int> left_; ///< of a group's representative: lines less crossings
};

class ArcRules {
public:
    ArcRules(const Neighbourhoods& around, const LineNetwork& network, std::span<const char> present)
        : around_(around), network_(network), present_(present), sides_(network.crossings.size()) {}

    std::vector<BrokenArcRule> run(std::size_t count, ArcRuleSet rules) {
        readLines();
        if (edgesOnLines_ != count)
            broken("whole arcs",
                   std::to_string(count - edgesOnLines_) + " of its edges lie on no separatrix");
        everySource();
        for (std::size_t c = 0; c < sides_.size(); ++c)
            junction(static_cast<int>(c));
        if (rules == ArcRuleSet::ofTMeshes) return std::move(broken_);
        for (const ArcLine& line : lines_)
            oneGap(line);
        cracks();
        return std::move(broken_);
    }

private:
    void broken(const char* rule, std::string explanation) {
        broken_.push_back({rule, std::move(explanation)});
    }

    [[nodiscard]] std::string ends(const ArcLine& line) const {
        return "the line from vertex " + std::to_string(around_.from(line.way->steps.front())) + " over " +
               std::to_string(around_.to(line.way->steps.front())) + " to " +
               std::to_string(around_.to(line.way->steps.back()));
    }
    [[nodiscard]] std::string place(int crossing) const {
        return "vertex " + std::to_string(network_.crossings[at(crossing)].vertex);
    }

    void readLines() {
        for (std::size_t w = 0; w < network_.ways.size(); ++w) {
            const Way& way = network_.ways[w];
            if (way.opposite >= 0 && at(way.opposite) < w) continue;
            ArcLine line{&way, way.opposite >= 0, {}, false};
            for (int arc = 0; arc < way.length(); ++arc)
                line.arcs.push_back(readArc(line, arc));
            line.full = std::ranges::count(line.arcs, 1) == way.length();
            for (int c = 1; c < way.length(); ++c)
                sides_[at(way.stops[at(c) - 1])].push_back(
                    {static_cast<int>(lines_.size()), line.arcs[at(c) - 1] != 0, line.arcs[at(c)] != 0});
            lines_.push_back(std::move(line));
        }
    }

    char readArc(const ArcLine& line, int arc) {
        const int begin = line.way->stepsTo(arc);
        const int end = line.way->stepsTo(arc + 1);
        int in = 0;
        for (int i = begin; i < end; ++i)
            in += present_[at(around_.edge(line.way->steps[at(i)]))] ? 1 : 0;
        edgesOnLines_ += at(in);
        if (in != 0 && in != end - begin)
            broken("whole arcs", "only a part of an arc of " + ends(line) + " is in the graph");
        return in == end - begin ? 1 : 0;
    }

    // Rule 1: every arc at an extraordinary vertex and both arcs of a seed's line, that is, at every source.
    void everySource() {
        for (const ArcLine& line : lines_) {
            if (!line.arcs.front()) broken("arc rule 1", "the first arc of " + ends(line) + " is missing");
            if (line.twoSources && line.arcs.size() > 1 && !line.arcs.back())
                broken("arc rule 1", "the last arc of " + ends(line) + " is missing");
        }
    }

    // Rule 2: at a junction, if exactly one arc of one line is in, both arcs of the other are.
    void junction(int crossing) {
        const auto& sides = sides_[at(crossing)];
        if (sides.size() < 2) return; // the other line starts here at a seed, with both arcs
        for (int i = 0; i < 2; ++i)
            if (sides[at(i)].present() == 1 && sides[at(1 - i)].present() != 2)
                broken("arc rule 2", "a dead end or an L at " + place(crossing));
    }

    // Rule 3: at most one gap between two sources; a prefix from a single one.
    void oneGap(const ArcLine& line) {
        int gaps = 0;
        for (std::size_t arc = 1; arc < line.arcs.size(); ++arc)
            gaps += line.arcs[arc - 1] && !line.arcs[arc];
        if (line.twoSources && gaps > 1) broken("arc rule 3", ends(line) + " has more than one gap");
        const bool prefix = std::is_sorted(line.arcs.rbegin(), line.arcs.rend());
        if (!line.twoSources && !prefix) broken("arc rule 3", ends(line) + " goes on after a gap");
    }

    // Rule 4: every + is a crack in one of its lines, and every line that two particles cover has at most
    // one crack.
    void cracks() {
        Groups groups(lines_.size());
        for (std::size_t c = 0; c < sides_.size(); ++c) {
            const auto& sides = sides_[c];
            if (std::ranges::any_of(sides, [](const Side& s) { return s.present() < 2; })) continue;
            const int first = sides.front().line;
            const int second = sides.back().line; // the same where the other line starts here at a seed
            const bool firstCracks = canCrack(first);
            const bool secondCracks = canCrack(second);
            if (!firstCracks && !secondCracks)
                broken("arc rule 4", "neither line can be cracked at " + place(static_cast<int>(c)));
            else if (!groups.addCrossing(firstCracks ? first : second, secondCracks ? second : first))
                broken("arc rule 4", "more crossings than cracks around " + place(static_cast<int>(c)));
        }
    }
    [[nodiscard]] bool canCrack(int line) const {
        return lines_[at(line)].twoSources && lines_[at(line)].full;
    }

    const Neighbourhoods& around_;
    const LineNetwork& network_;
    std::span<const char> present_;
    std::vector<ArcLine> lines_;
    std::vector<std::vector<Side>> sides_; ///< of every crossing
    std::size_t edgesOnLines_ = 0;
    std::vector<BrokenArcRule> broken_;
};

} // namespace

std::vector<BrokenArcRule> brokenArcRules(const Neighbourhoods& around, const LineNetwork& network,
                                          std::span<const char> present, std::size_t count,
                                          ArcRuleSet rules) {
    return ArcRules(around, network, present).run(count, rules);
}

} // namespace qm::check
