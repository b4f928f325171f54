# qm-summary: figures of any document, and limits.

load helpers.bash

figures() { run --separate-stderr qm-summary --json "$@"; }

@test "the figures are those of the document" {
    local document
    document=$(stage surfaces block)
    figures "$document"
    assert_success
    for pair in .quads=.mesh.faces .vertices=.mesh.vertices '.patches=(.layout.segments | length)' \
        .surfaces.deviation=.surfaces.deviation.max .surfaces.gap=.surfaces.deviation.largestGap \
        .surfaces.maxFromFacets=.surfaces.deviation.maxFromFacets .surfaces.folds=.surfaces.deviation.folds \
        .surfaces.largestNormalAngle=.surfaces.deviation.largestNormalAngle \
        .surfaces.percentile95NormalAngle=.surfaces.deviation.percentile95NormalAngle \
        .surfaces.farthest=.surfaces.farthest; do
        assert_equal "$(jq -c "${pair%%=*}" <<<"$output")" "$(jq -c "${pair#*=}" "$document")"
    done
    assert_equal "$(jq .surfaces.tolerance <<<"$output")" "$(jq '.diagonal * 0.005' <<<"$output")"
}

@test "documents of every kind have a summary" {
    for kind in basecomplex features cut enumeration layout pruned surfaces; do
        quietly qm-summary "$(stage $kind cube)"
        assert_line --regexp '^quads +384 in 1 piece$'
    done
    figures "$(stage cut cube)"
    assert_equal "$(jq -c '[.patches, .surfaces, .solid]' <<<"$output")" '[null,null,false]'
}

@test "a limit that is off unless given shows no default" {
    run qm-summary --json-usage
    assert_equal "$(jq -c '.options[] | select(.name == "--max-patches") | has("default")' <<<"$output")" false
    assert_equal "$(jq '.options[] | select(.name == "--max-normal-angle").default' <<<"$output")" 1
}

@test "boundary loops are listed, the longest first" {
    figures "$(stage basecomplex plate)"
    jq -e '.boundaryLoops | length == 2 and .[0].length > .[1].length and all(.edges > 3)' <<<"$output"
    quietly qm-summary "$(stage basecomplex plate)"
    assert_line --regexp '^shape +2 open loops, '
}

@test "a limit that is not met is a line, and status 3" {
    run --separate-stderr qm-summary --max-patches 2 "$(stage pruned block)"
    assert_equal "$status" 3
    assert_regex "$stderr" 'patches where 2 are allowed'
    quietly qm-summary --max-patches 1000 "$(stage pruned block)"
}

@test "a missed tolerance, a jump of normals and gaps are not met" {
    jq '(.history[] | select(.tool == "qm-bspline") | .options.tolerance) = 1e-9
        | .surfaces.deviation.largestNormalAngle = 7 | .surfaces.deviation.largestGap = 0.1' "$(stage surfaces block)" >poor.json
    run --separate-stderr qm-summary --max-normal-angle 5 poor.json --mesh "$(sample block)"
    assert_equal "$status" 3
    assert_equal "${#stderr_lines[@]}" 3
    assert_regex "${stderr_lines[0]}" 'the tolerance is missed: .* in patch [0-9]+ at \('
    assert_regex "${stderr_lines[1]}" 'normals differ by 7 degrees across a smooth border where 5 are allowed'
    assert_regex "${stderr_lines[2]}" 'patches are 0.1 mm apart'
    assert_line --regexp '^shape +closed, but patches are apart$'
}

@test "what interpolates is not held to what it does not promise" {
    qm-bspline --fit interpolate "$(stage pruned block)" -o paper.json
    quietly qm-summary --unit cm paper.json
    assert_line --regexp '^deviation +[0-9.]+ cm$'
}

@test "a tolerance that is none is refused" {
    for none in -1 0 '"-1%"' '"much"'; do
        jq "(.history[] | select(.tool == \"qm-bspline\") | .options.tolerance) = $none" "$(stage surfaces block)" >wrong.json
        complains qm-summary --mesh "$(sample block)" wrong.json
        assert_regex "$stderr" '/history/[0-9]/options/tolerance: is no tolerance'
    done
}

@test "a place that is on no patch is refused" {
    jq '.surfaces.farthest.patch = 99' "$(stage surfaces block)" >wrong.json
    complains qm-summary --mesh "$(sample block)" wrong.json
    assert_regex "$stderr" '/surfaces/farthest/patch'
    jq '.surfaces.farthest.at[1] = -1' "$(stage surfaces block)" >wrong.json
    complains qm-summary --mesh "$(sample block)" wrong.json
    assert_regex "$stderr" '/surfaces/farthest/at/1'
    jq '.surfaces.farthest.point[0] += 0.1' "$(stage surfaces block)" >wrong.json
    run --separate-stderr qm-check --mesh "$(sample block)" wrong.json
    assert_equal "$status" 1
    assert_regex "$stderr" '/surfaces/farthest/point'
}

@test "places that may fold are told, and are where they are said to be" {
    jq '.surfaces |= (.foldPlaces = [.farthest] | .deviation.folds = 1 | .patches[.farthest.patch].deviation.folds = 1)' \
        "$(stage surfaces block)" >folded.json
    patch=$(field .surfaces.farthest.patch folded.json)
    run --separate-stderr qm-summary --mesh "$(sample block)" folded.json
    assert_line --regexp '^folds +1 piece of patches may fold over$'
    assert_line --regexp "^  first +in patch $patch at \("
    figures --mesh "$(sample block)" folded.json
    assert_equal "$(jq -c .surfaces.fold <<<"$output")" "$(jq -c .surfaces.farthest folded.json)"
    run --separate-stderr qm-export --mesh "$(sample block)" folded.json -o folded.step
    assert_regex "$stderr" "1 piece of patches may fold over, 1 of them in patch $patch at \([-0-9e., ]+\)\."
    run --separate-stderr qm-check --mesh "$(sample block)" folded.json
    refute_regex "$stderr" foldPlaces
    jq '.surfaces.foldPlaces[0].point[2] += 0.1 | .surfaces.foldPlaces += [{patch: 99, at: [0, 0], point: [0, 0, 0]}]' folded.json >wrong.json
    run --separate-stderr qm-check --mesh "$(sample block)" wrong.json
    assert_equal "$status" 1
    assert_regex "$stderr" '/surfaces/foldPlaces/0/point'
    assert_regex "$stderr" '/surfaces/foldPlaces/1: .* no patch'
    assert_regex "$stderr" 'there are 2 places for 1 folds'
    complains qm-summary --mesh "$(sample block)" wrong.json
    assert_regex "$stderr" '/surfaces/foldPlaces/1/patch'
}
