/// \file A layout to which tracks are added (docs/METHOD.md#pruning).
#pragma once

#include "layout/borders.h"
#include "layout/layout.h"
#include "prune/pruned_mesh.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace qm {

/// Collects tracks that divide segments. The mesh must outlive this.
class AddedTracks {
public:
    /// \param layout     as made by `buildLayout`; transversals are no borders here, as they are drawn anew
    /// \param forbidden  edges over which no track goes
    AddedTracks(const PrunedMesh& pruned, const Layout& layout, const std::vector<EdgeId>& forbidden);

    [[nodiscard]] const Borders& borders() const { return borders_; }
    /// Those that the layout had before.
    [[nodiscard]] const std::vector<Track>& earlierTracks() const { return earlier_; }

    /// Adds a track that goes straight on from a border to the next one.
    /// \param first  leaves a border, and is none itself
    /// \return where it arrives; nothing if it would go over a forbidden edge, and is left out
    std::optional<HalfedgeId> addFrom(HalfedgeId first);

    /// Adds a track through an edge inside a segment, to the next borders on both sides, or once around.
    void addThrough(HalfedgeId inside);

    [[nodiscard]] std::size_t count() const { return added_.size(); }

    /// The layout with all of them.
    [[nodiscard]] Layout layout() const;

private:
    /// What goes straight on to the next border, or back to its own beginning.
    [[nodiscard]] std::vector<HalfedgeId> pathFrom(HalfedgeId first) const;
    bool add(const std::vector<HalfedgeId>& path);

    const PrunedMesh& pruned_;
    std::vector<Track> earlier_, added_;
    Borders borders_;
    std::vector<bool> isForbidden_; ///< by edge
};

} // namespace qm
