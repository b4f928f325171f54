# What a person changes in a document holds: the stages after it follow.

load helpers.bash

setup() {
    empty_folder
    cp "$(sample genus2)" part.obj
    OUT=.
}

run_to() { make --no-print-directory -s -f "$ROOT/pipelines/layout.mk" OUT=. FEATURES_OPTIONS='--rho 0.3 --tau 8 --zeta 3' CUT_OPTIONS='--chi 40' "part.$1.json"; }

# edit KIND FILTER [JQ-OPTION]...: as with an editor: the file of the cache changes, and so does its date.
edit() {
    local file=part.$1.json
    jq "${@:3}" "$2" "$file" >edited
    cp edited "$file"
}

# Edges of the tracks, sorted.
EDGES='def edges: [.[:-1], .[1:]] | transpose[] | sort; def boundaries: [.layout.tracks[].vertices | edges] | unique;'
is() { assert_equal "$(jq "${@:3}" "$EDGES $2" "part.$1.json")" true; }

true_and_complete() {
    quietly qm-check "part.$1.json"
    is "$1" '([.layout.segments[].faces[]] | sort) == [range(.mesh.faces)]'
}

@test "a feature curve that is deleted is no boundary any more" {
    run_to layout
    count=$(field '.features.curves | length' part.features.json)
    assert [ "$count" -gt 1 ]
    seed=$(field '.features.curves[0].seed' part.features.json)
    is layout '[.layout.tracks[].vertices[0]] | index($seed) != null' --argjson seed "$seed"
    edit features 'del(.features.curves[0])'
    run_to layout
    is layout '.features.curves | length == $count - 1' --argjson count "$count"
    is layout '[.layout.tracks[].vertices[0]] | index($seed) == null' --argjson seed "$seed"
    true_and_complete layout
}

@test "a feature curve that is added becomes a boundary" {
    run_to features
    # The curves that the tool finds are taken out; then one of them comes in by hand.
    curve=$(jq -c '.features.curves[0] | {vertices, seed}' part.features.json)
    edit features '.features.curves = []'
    run_to layout
    seed=$(jq .seed <<<"$curve")
    is layout '[.layout.tracks[].vertices[0]] | index($seed) == null' --argjson seed "$seed"
    edit features '.features.curves = [$curve + {"id": 7}]' --argjson curve "$curve"
    run_to layout
    is layout '[.layout.tracks[].vertices[0]] | index($seed) != null' --argjson seed "$seed"
    is layout '.features.curves[0].id == 7'
    true_and_complete layout
}

@test "a vertex that is moved to another sub-mesh stays there" {
    run_to layout
    run_to cut
    assert [ "$(field '.cut.subMeshes | length' part.cut.json)" -gt 1 ]
    # One on the cut goes over, to the sub-mesh of a neighbour.
    move=$(jq -c '.cut.labels as $labels | [.baseComplex.separatrices[].vertices | [.[:-1], .[1:]] | transpose[]
        | select($labels[.[0]] != $labels[.[1]])] | first | {vertex: .[0], label: $labels[.[1]]}' part.cut.json)
    edit cut '.cut.labels[$move.vertex] = $move.label' --argjson move "$move"
    run --separate-stderr run_to layout
    assert_success
    is layout '.cut.labels[$move.vertex] == $move.label' --argjson move "$move"
    true_and_complete layout
}

@test "two sub-meshes that are made one are searched as one" {
    run_to cut
    edit cut '.cut.labels |= map(0) | .cut.subMeshes |= .[:1]'
    run --separate-stderr run_to layout
    assert_success
    is layout '.enumeration.subMeshes | length == 1'
    is layout '.layout.lowerBound != null and .layout.lowerBound <= .layout.cost + 1e-6'
    true_and_complete layout
}

@test "a track that is forbidden is gone from the layout, one that is required is in it" {
    edit_constraints() { edit features '.constraints = $constraints' --argjson constraints "$1"; }
    run_to layout
    # Between two junctions in the inner part of a line the tracks leave some edges, and take others.
    used=$(jq -c "$EDGES"' boundaries as $all | [.baseComplex.separatrices[].vertices | select(length > 4)
        | [.[2:-2] | edges]] | add | unique | [.[] | select(. as $e | $all | index([$e]))]' part.layout.json)
    unused=$(jq -c "$EDGES"' boundaries as $all | [.baseComplex.separatrices[].vertices | [edges]] | add | unique
        | . - $all | first' part.layout.json)
    assert [ "$unused" != null ]
    edit_constraints "{\"required\": [{\"vertices\": $unused}]}"
    run_to layout
    is layout 'boundaries | index([$edge]) != null' --argjson edge "$unused"
    true_and_complete layout
    # Not every edge can be missing: the first that can.
    for edge in $(jq -c '.[]' <<<"$used"); do
        edit_constraints "{\"forbidden\": [{\"vertices\": $edge}]}"
        # If no graph is left, it is said, and no layout is written.
        run run_to layout
        if ((status == 0)); then
            is layout 'boundaries | index([$edge]) == null' --argjson edge "$edge"
            true_and_complete layout
            return
        fi
    done
    fail 'no track of this layout can be forbidden'
}

@test "tracks are the truth: without segments and costs a layout is made anew from them" {
    run_to pruned
    patches=$(field '.layout.segments | length' part.pruned.json)
    jq '.layout |= {tracks: .tracks}' part.pruned.json >by-hand.json
    # What was missing is made anew, which is said.
    run --separate-stderr qm-bspline --tolerance 0.5% by-hand.json -o surfaces.json
    assert_success
    assert_regex "${stderr_lines[0]}" '^qm-bspline: by-hand.json: /layout'
    assert_equal "$(field '.surfaces.patches | length' surfaces.json)" "$patches"
    quietly qm-check surfaces.json
}

@test "a layout from which a track was deleted is a pruned one after qm-prune" {
    run_to pruned
    gone=$(jq -c --slurpfile pruned part.pruned.json '[$pruned[0].layout.tracks[].vertices] as $kept
        | [.layout.tracks[].vertices | select(. as $path | $kept | index([$path]) | not)] | first' part.layout.json)
    assert [ "$gone" != null ]
    jq --argjson gone "$gone" '.layout |= {tracks: [.tracks[] | select(.vertices != $gone)]}' part.layout.json >by-hand.json
    run --separate-stderr qm-prune --eta 1e9 by-hand.json -o pruned.json
    assert_success
    quietly qm-check pruned.json
}

@test "an edit that breaks a rule is refused with its place" {
    run_to cut
    edit cut '.cut.labels[3] = 99'
    complains qm-enum part.cut.json
    assert_regex "$stderr" '/cut/labels/3'
    edit features '.features.curves[0].vertices[1] = .features.curves[0].vertices[0]'
    complains qm-cut part.features.json
    assert_regex "$stderr" '/features/curves/0'
}
