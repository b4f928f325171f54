# qm-bspline: patches for the segments of a layout.

load helpers.bash

setup_file() {
    load helpers.bash
    stage pruned block >/dev/null
}

@test "a patch for every segment, in their order" {
    quietly qm-bspline "$(stage pruned block)" -o block.json
    assert_equal "$(field '[.surfaces.patches[].segment] == [range(.layout.segments | length)]' block.json)" true
    quietly qm-check block.json -o verdict
}

@test "a tolerance is a length, or with % a share of the diagonal; the document says which" {
    quietly qm-bspline --fit tolerance --tolerance 0.1% "$(stage pruned block)" -o share.json
    assert_equal "$(field '.history[-1].options.tolerance' share.json)" 0.1%
    assert_equal "$(field '.surfaces.deviation.maxRelative <= 0.001' share.json)" true
    quietly qm-check share.json -o verdict
    quietly qm-bspline --fit tolerance --tolerance 0.05 "$(stage pruned block)" -o length.json
    assert_equal "$(field '.history[-1].options.tolerance' length.json)" 0.05
    assert_equal "$(field '.surfaces.deviation.max <= 0.05' length.json)" true
    quietly qm-check length.json -o verdict
}

@test "a tighter tolerance takes no fewer control points" {
    points() { field '[.surfaces.patches[].controlPoints | length * (.[0] | length)] | add' "$1"; }
    quietly qm-bspline --fit tolerance --tolerance 1% "$(stage pruned block)" -o loose.json
    quietly qm-bspline --fit tolerance --tolerance 0.01% "$(stage pruned block)" -o tight.json
    assert [ "$(points loose.json)" -le "$(points tight.json)" ]
}

@test "what is no tolerance is a usage error" {
    for text in 0 -1 -1% % 1%% much 1e999 nan; do
        misused qm-bspline --fit tolerance --tolerance "$text" "$(stage pruned block)"
    done
}
