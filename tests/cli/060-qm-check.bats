# Documents that the tools made are true; edited ones are not, and the place is named.

load helpers.bash

setup_file() {
    load helpers.bash
    stage surfaces block >/dev/null
}

KINDS=(basecomplex features cut enumeration layout pruned surfaces)

# spoilt FILTER KIND: the document of that kind after a jq filter, in spoilt.json
spoilt() { jq "$1" "$(stage "$2" block)" >spoilt.json; }

# untrue POINTER RULE: the document spoilt.json breaks the rule at that place, and nothing was computed in vain.
untrue() {
    run --separate-stderr qm-check spoilt.json
    assert_equal "$status" 1
    local newline=$'\n'
    assert_regex "$newline$stderr" "${newline}qm-check: spoilt.json: $1: ($2): "
    assert_regex "${lines[-1]}" '^false: [0-9]+ violations?$'
}

@test "what the tools make is true" {
    for kind in "${KINDS[@]}"; do
        quietly qm-check "$(stage "$kind" block)"
        assert_equal "${lines[-1]}" true
        assert_regex "${lines[0]}" '^ok: schema, and mesh of [0-9]+ vertices and [0-9]+ faces$'
    done
}

@test "one of a kind is told in the singular" {
    printf 'v %s\n' '0 0 0' '1 0 0' '1 1 0' '0 1 0' >one.obj
    echo 'f 1 2 3 4' >>one.obj
    qm-basecomplex --quiet one.obj | qm-cut | qm-enum | qm-merge | qm-bspline >one.json
    quietly qm-check one.json
    assert_line --index 0 'ok: schema, and mesh of 4 vertices and 1 face'
    assert_line 'ok: enumeration: 1 graph of 1 sub-mesh'
    assert_line 'ok: layout: 0 tracks, 1 segment'
}

@test "every section is in the summary" {
    quietly qm-check "$(stage surfaces block)"
    for section in 'base complex' features cut enumeration layout surfaces; do
        assert_line --regexp "^ok: $section: "
    done
}

@test "the report as JSON" {
    quietly qm-check --json -o report.json "$(stage layout block)"
    assert_equal "$(jq -c '[.ok, .violationCount, .violations]' report.json)" '[true,0,[]]'

    spoilt '.layout.cost += 1' layout
    run --separate-stderr qm-check --json spoilt.json
    assert_equal "$status" 1
    assert_equal "$(jq -c '[.ok, .violationCount, .violations[0].pointer, .violations[0].rule]' <<<"$output")" \
        '[false,2,"/layout/cost","G_T"]' # the gap to the bound is wrong as well
}

@test "from standard input, with the mesh named" {
    cp "$(sample block)" moved.obj
    jq '.mesh.path = "gone.obj"' "$(stage layout block)" >document.json
    complains qm-check document.json
    quietly qm-check --mesh moved.obj document.json
    quietly qm-check --mesh moved.obj <document.json
}

@test "what --help says of the violations that are told" {
    spoilt '.cut.labels |= map(99)' cut
    captured qm-check --json spoilt.json -o report.json
    assert_equal "$status" 1
    assert_equal "$(jq -c '[.violationCount > 3000, (.violations | length)]' report.json)" '[true,1000]'
    assert_equal "$(grep -c /cut/labels <<<"$stderr")" 20
    run qm-check --help
    assert_output --regexp 'first twenty violations'
    assert_output --regexp 'first thousand violations'
}

@test "another mesh" {
    sed 's/^v \([^ ]*\)/v 1\1/' "$(sample block)" >other.obj
    complains qm-check --mesh other.obj "$(stage layout block)"
    assert_regex "$stderr" 'the mesh has changed'
}

@test "what the schema forbids" {
    spoilt '.baseComplex.ordinaryJunctions = "many"' layout
    complains qm-check spoilt.json
    assert_regex "$stderr" '/baseComplex/ordinaryJunctions'
}

@test "base complex" {
    spoilt '.baseComplex.ordinaryJunctions += 1' basecomplex
    untrue /baseComplex/ordinaryJunctions n_j
    spoilt '.baseComplex.extraordinaryVertices |= .[1:]' basecomplex
    untrue /baseComplex/extraordinaryVertices extraordinary
    spoilt '.baseComplex.separatrices |= .[:-1]' basecomplex
    untrue /baseComplex/separatrices 'separatrix missing'
    spoilt '.baseComplex.separatrices[3].selfCrossing |= not' basecomplex
    untrue /baseComplex/separatrices/3/selfCrossing self-crossing
    spoilt '.baseComplex.separatrices[2].vertices |= reverse' basecomplex
    untrue '/baseComplex/separatrices/[0-9]+' 'separatrix twice|separatrix order'
    untrue /baseComplex/separatrices 'separatrix missing'
}

@test "cut" {
    spoilt '.cut.labels |= .[1:]' cut
    untrue /cut/labels 'labels complete'
    spoilt '.cut.labels[4] = 999' cut
    untrue /cut/labels/4 label
    spoilt '.cut.subMeshes[0].quasiComplexity += 1' cut
    untrue /cut/subMeshes/0/quasiComplexity U
    spoilt '.cut.subMeshes[0].ordinaryJunctions += 1' cut
    untrue /cut/subMeshes/0/ordinaryJunctions n_j
}

@test "enumeration" {
    spoilt '.enumeration.subMeshes[0].graphs[0].cost -= 1' enumeration
    untrue /enumeration/subMeshes/0/graphs/0/cost cost
    spoilt '.enumeration.subMeshes[0].lowerBound = 1e6' enumeration
    untrue /enumeration/subMeshes/0/lowerBound bound
    spoilt '.enumeration.subMeshes[0].graphs += [.enumeration.subMeshes[0].graphs[0]]' enumeration
    untrue /enumeration/subMeshes/0/graphs/1 distinct
    spoilt '.enumeration.subMeshes[0].graphs[0].tracks |= .[1:]' enumeration
    untrue /enumeration/subMeshes/0/graphs/0/tracks 'arc rule 1'
}

@test "layout" {
    spoilt '.layout.cost += 1e-3' layout
    untrue /layout/cost G_T
    spoilt '.layout.tracks |= .[:-1]' layout
    untrue /layout/tracks A3
    untrue /layout/tracks 'arc rule 1'
    spoilt '.layout.segments |= .[:-1]' layout
    untrue /layout/segments tiling
    spoilt '.layout.segments[1].faces = .layout.segments[0].faces' layout
    untrue /layout/segments/1/faces/0 tiling
    spoilt '.layout.quality.segments += 1' layout
    untrue /layout/quality/segments quality
}

@test "a pruned layout may lack tracks, an unpruned one may not" {
    quietly qm-check "$(stage pruned block)"
    if [[ $(field '.layout.prune.removedTracks' "$(stage pruned block)") != 0 ]]; then
        spoilt '.history |= map(select(.tool != "qm-prune"))' pruned
        untrue /layout/tracks 'arc rule 1'
    fi
}

@test "surfaces" {
    quietly qm-bspline --quiet --fit interpolate "$(stage pruned block)" -o interpolated.json
    jq '.surfaces.patches[0].controlPoints[1][1][2] += 1e-3' interpolated.json >spoilt.json
    untrue /surfaces/patches/0 interpolation
    spoilt '.surfaces.patches[0].controlPoints[0][0][2] += 1e-3' surfaces
    untrue '/surfaces/patches/[0-9]+(/deviation/[a-zA-Z]+)?' '(watertight|deviation)'
    spoilt '.surfaces.patches[0].knots[0][1] = 1e6' surfaces
    untrue /surfaces/patches/0/knots/0/2 knots
    spoilt '.surfaces.patches |= .[1:]' surfaces
    untrue /surfaces/patches 'one patch per segment'
    farthest=$(field '.surfaces.patches | map(.deviation.maxFromFacets) | index(max)' "$(stage surfaces block)")
    spoilt ".surfaces.patches[$farthest].deviation.maxFromFacets *= 0.5" surfaces
    untrue "/surfaces/patches/$farthest/deviation/maxFromFacets" deviation
}

@test "a patch of one long row takes little memory" {
    awk 'BEGIN {
        n = 30000
        for (i = 0; i <= n; ++i) print "v", i, 0, 0 "\nv", i, 1, 0
        for (i = 1; i <= 2 * n; i += 2) print "f", i, i + 2, i + 3, i + 1
    }' >strip.obj
    qm-basecomplex --quiet strip.obj | qm-features | qm-cut | qm-enum | qm-merge | qm-bspline --quiet -o strip.json
    qm-check --stats strip.json 2>stats.json >/dev/null
    assert_equal "$(jq '.peakMegabytes < 500' stats.json)" true
}

@test "history" {
    spoilt '.history |= reverse' layout
    untrue /history/1 history
    spoilt '.kind = "features"' layout
    run qm-check spoilt.json
    assert_failure 1
}

@test "only twenty violations are shown, and how many there are" {
    spoilt '.baseComplex.separatrices |= map(.selfCrossing |= not)' basecomplex
    run --separate-stderr qm-check spoilt.json
    assert_equal "$status" 1
    assert_equal "${#stderr_lines[@]}" 21
    assert_regex "${stderr_lines[20]}" '^qm-check: spoilt.json: [0-9]+ violations in all$'
    run --separate-stderr qm-check --json spoilt.json
    assert_equal "$(jq '.violations | length' <<<"$output")" "$(jq '.baseComplex.separatrices | length' spoilt.json)"
}

@test "real meshes, where they are at hand" {
    [[ -d $SHARED_MESHES/dev ]] || skip "there are none"
    for mesh in duck_miq_8.obj fandisk_qex.obj gitter.off torus_regular.obj unwelded.obj; do
        qm-basecomplex --quiet "$SHARED_MESHES/dev/$mesh" | qm-features --quiet | qm-cut --quiet --chi 40 |
            qm-enum --quiet --time-limit 2 | qm-merge --quiet | qm-prune --quiet | qm-bspline --quiet --fit interpolate >"$mesh.json"
        quietly qm-check "$mesh.json"
    done
}
