#!/usr/bin/env bats
# qm-bspline --reference: surfaces fitted to a scan.

load helpers

setup_file() {
    cd "$BATS_FILE_TMPDIR" || return
    qm-shape block -o part.obj
    qm-basecomplex part.obj | qm-features | qm-cut --chi 40 | qm-enum | qm-merge | qm-prune > part.json
    qm-shape block --scan 60000 -o clean.stl
    qm-shape block --scan 60000 --noise 0.05% -o noisy.ply
}

setup() { cd "$BATS_FILE_TMPDIR" || return; }

# Whether a small scan's noise lets the tolerance be kept is not the question here.
fit() {
    run qm-bspline part.json "$@" -o out.json
    [ "$status" -eq 0 ] || [ "$status" -eq 3 ]
}

@test "a scan is the reference, and the document says which and how well it is met" {
    fit --reference clean.stl --tolerance 0.5%
    run -0 jq -r '.surfaces.scan | .path, (.coverage > 0.99), (.percentile95 <= .max), (.sha256 | length)' out.json
    assert_output $'clean.stl\ntrue\ntrue\n64'
    run -0 jq -r '.surfaces.scan.sha256' out.json
    assert_output "$(sha256sum clean.stl | cut -d' ' -f1)"
    run -0 qm-check out.json
    assert_line --partial "deviation: no figure is less than what is measured"
}

@test "noise is taken for noise" {
    fit --reference clean.stl --tolerance 0.2%
    run -0 jq '.surfaces.scan.noise' out.json
    local -r clean=$output
    fit --reference noisy.ply --tolerance 0.2%
    run -0 jq --argjson clean "$clean" '.surfaces.scan | .noise > 2 * $clean and .rms > 0.5 * .noise' out.json
    assert_output true
}

@test "the history does not name the scan, so that equal input gives equal bytes wherever it lies" {
    fit --reference clean.stl --tolerance 1%
    run -0 jq -c '.history[-1].options | has("reference")' out.json
    assert_output false
}

@test "what is no scan of this part is refused" {
    run -1 qm-bspline part.json --reference part.json -o out.json
    assert_output --partial "part.json"
    run -1 qm-bspline part.json --reference missing.stl -o out.json
    assert_output --partial "missing.stl"
    run -1 qm-bspline part.json --reference - -o out.json </dev/null
    assert_output --partial "standard input: the file is empty"
    awk '/^v /{print "v", $2 + 1000, $3, $4; next} {print}' part.obj > far.obj
    run -1 qm-bspline part.json --reference far.obj -o out.json
    assert_output --partial "same place and unit"
}

@test "triangles that lie the wrong way round are turned over, and count" {
    qm-shape block --scan 20000 -o right.obj
    awk '/^f / && n++ % 5 == 0 {print $1, $2, $4, $3; next} {print}' right.obj > turned.obj
    fit --reference turned.obj --tolerance 0.5%
    assert_output --partial "turned.obj: "
    assert_output --partial "lie the wrong way round"
    run -0 jq '.surfaces.scan.coverage > 0.99' out.json
    assert_output true
}

@test "a scan that shows little of the part is asked about" {
    qm-shape block --scan 20000 -o whole.obj
    awk '/^v /{x[++n] = $2} /^f / && x[$2 + 0] > 0 {next} {print}' whole.obj > half.obj
    fit --reference half.obj --tolerance 0.5%
    assert_output --partial "per cent of the mesh are near the scan"
    fit --reference whole.obj --tolerance 0.5%
    refute_output --partial "are near the scan"
}

@test "interpolation has no reference and no tolerance to heed" {
    for option in '--reference clean.stl' '--tolerance 1%'; do
        run -2 qm-bspline part.json --fit interpolate $option -o out.json
        assert_output --partial "--fit smooth"
    done
}

@test "where the surfaces are farthest from the scan is told, as patch, parameters and point" {
    fit --reference clean.stl --tolerance 0.5%
    run -0 jq -c '.surfaces.scan.farthest | [(.patch >= 0), (.at | length), (.point | length)]' out.json
    assert_output '[true,2,3]'
    run qm-summary --json out.json
    assert_equal "$(jq -c .surfaces.scan.farthest <<<"$output")" "$(jq -c .surfaces.scan.farthest out.json)"
}

# quantity: what the page says that its deviation is; it fails where the page has no such layer.
quantity() { grep -oP '"quantity":"\K[^"]*(?=","unit":"mm","limit":0.0[^"]*"values")' "$1" | head -1; }

@test "a page compares the surfaces with the scan that they were fitted to" {
    fit --reference clean.stl --tolerance 0.5%
    run -0 --separate-stderr qm-view out.json -o page.html
    assert_equal "$stderr" ''
    assert_equal "$(quantity page.html)" 'distance from the scan without its noise'
    grep -q '"name":"scan","title":"distance from the scan itself"' page.html
}

@test "without the scan, which is told, a page shows what the document says of every patch" {
    mkdir -p away
    cp clean.stl away/scan.stl
    fit --reference away/scan.stl --tolerance 0.5%
    mv away/scan.stl away/other.stl
    run -0 --separate-stderr qm-view out.json -o page.html
    assert_equal "${#stderr_lines[@]}" 1
    assert_equal "$stderr" 'qm-view: away/scan.stl: the scan that out.json refers to is not there. Name the scan with --reference FILE. Until then every patch has the colour of its largest deviation'
    assert_equal "$(quantity page.html)" 'largest distance of the patch from the scan without its noise'
    run -0 --separate-stderr qm-view --reference away/other.stl out.json -o named.html
    assert_equal "$stderr" ''
    assert_equal "$(quantity named.html)" 'distance from the scan without its noise'
    run -1 qm-view --reference noisy.ply out.json -o page.html
    assert_output --partial 'noisy.ply: the scan has changed since out.json was made'
    run -1 qm-view --reference clean.stl part.json -o page.html
    assert_output --partial 'has no surfaces that were fitted to a scan'
}
