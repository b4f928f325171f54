# qm-export: files for other programs.

load helpers.bash

setup_file() {
    load helpers.bash
    stage surfaces block >/dev/null
}

patches() { field '.surfaces.patches | length' "$(stage surfaces "$1")"; }

@test "STEP has faces named by their segments and is a solid" {
    quietly qm-bspline --tolerance 0.5% "$(stage pruned block)" -o block.json
    quietly qm-export block.json -o block.step
    assert_equal "$(grep -o "ADVANCED_FACE('segment [0-9]*'" block.step | sort -u | wc -l)" "$(patches block)"
    assert_equal "$(grep -c "MANIFOLD_SOLID_BREP" block.step)" 1
    grep -q "SI_UNIT(.MILLI.,.METRE.)" block.step
}

@test "the parts of a mesh are parts of the STEP file, each with a name" {
    printf '%s\n' 'v 0 0 0' 'v 1 0 0' 'v 1 1 0' 'v 0 1 0' 'v 5 0 0' 'v 6 0 0' 'v 6 1 0' 'v 5 1 0' 'f 1 2 3 4' 'f 5 6 7 8' >two.obj
    qm-basecomplex -q two.obj | qm-features | qm-cut | qm-enum -q | qm-merge -q | qm-bspline --tolerance 0.5% | qm-export --format step >two.step
    run grep -o "PRODUCT('[^']*'" two.step
    assert_output "PRODUCT('two 1'
PRODUCT('two 2'"
    assert_equal "$(grep -c "ADVANCED_FACE('segment " two.step)" 2
}

@test "a closed mesh inside another that looks the other way is a cavity" {
    # A cube of half the size in the middle of a cube, its faces turned.
    qm-shape cube -o cube.obj
    awk '/^v /{ v[++n] = $0; $2 = $2 / 2 + 0.25; $3 = $3 / 2 + 0.25; $4 = $4 / 2 + 0.25; w[n] = $0 }
         /^f /{ f[++m] = $0 }
         END { for (k = 1; k <= n; ++k) print v[k]; for (k = 1; k <= n; ++k) print w[k]
               for (k = 1; k <= m; ++k) { print f[k]; split(f[k], c); print "f", c[5] + n, c[4] + n, c[3] + n, c[2] + n } }' \
        cube.obj >hollow.obj
    qm-basecomplex -q hollow.obj | qm-features | qm-cut | qm-enum -q | qm-merge -q | qm-prune -q | qm-bspline -q >hollow.json
    captured qm-export --stats --analytic hollow.json -o hollow.step
    assert_success
    [[ $stderr == *'"solids": 1, "cavities": 1'*'"valid": 1'* ]]
    assert_equal "$(grep -c BREP_WITH_VOIDS hollow.step)" 1
    assert_equal "$(grep -c CLOSED_SHELL\(\'\' hollow.step)" 3 # one of them oriented
    quietly qm-summary hollow.json
    assert_regex "$output" 'shape +solid with a cavity'
    quietly qm-summary --json hollow.json
    jq -e '.pieces == 2 and .cavities == 1' <<<"$output"
}

@test "simple surfaces on request" {
    qm-bspline --tolerance 0.1% "$(stage pruned torus)" -o torus.json
    quietly qm-export torus.json -o plain.step
    quietly qm-export --analytic --analytic-tolerance 1% torus.json -o analytic.step
    refute grep -q TOROIDAL_SURFACE plain.step
    assert_equal "$(grep -c TOROIDAL_SURFACE analytic.step)" "$(grep -c ADVANCED_FACE analytic.step)"
    quietly qm-export --analytic --analytic-tolerance 0.114891 torus.json -o length.step # 1% of the diagonal
    assert_same_bytes analytic.step length.step
    quietly qm-export --analytic --analytic-tolerance 0 torus.json -o none.step
    assert_same_bytes plain.step none.step
}

@test "edges that move to analytic faces stay within their tolerance on other faces" {
    qm-shape helix --resolution 8 -o helix.obj
    qm-basecomplex -q helix.obj | qm-features | qm-cut -q | qm-enum -q | qm-merge -q | qm-prune -q | qm-bspline -q >helix.json
    captured qm-export --stats --analytic helix.json -o helix.step
    assert_success
    [[ $stderr == *'"valid": 1'* ]]
    assert [ "$(jq .counters.simpleFaces <<<"${stderr_lines[-1]}")" -gt 0 ]
}

@test "smooth edges stay smooth beside analytic faces, and the largest angle is told" {
    for tolerance in 0.1% 1% 3%; do
        captured qm-export --stats --join --analytic --analytic-tolerance "$tolerance" "$(stage surfaces bracket)" -o bracket.step
        assert_success
        jq -e '.counters | .simpleFaces > 0 and .newAngle < 1.1' <<<"${stderr_lines[-1]}"
    done
    captured qm-export --stats "$(stage surfaces bracket)" -o bracket.step
    jq -e '.counters.newAngle == 0' <<<"${stderr_lines[-1]}"
}

@test "neighbours that are one surface become one face" {
    qm-bspline --fit interpolate "$(stage layout plate)" -o plate.json
    quietly qm-export --quiet plate.json -o apart.step
    quietly qm-export --quiet --join plate.json -o joined.step
    assert [ "$(grep -c ADVANCED_FACE joined.step)" -lt "$(grep -c ADVANCED_FACE apart.step)" ]
    grep -q "ADVANCED_FACE('segments [0-9]* [0-9]" joined.step
}

@test "a patch that meets itself is several faces" {
    quietly qm-export "$(stage surfaces torus)" -o torus.step
    assert_equal "$(patches torus)" 1
    assert_equal "$(grep -c "ADVANCED_FACE('segment 0'" torus.step)" 4
}

@test "options that have no effect are wrong" {
    misused qm-export --analytic-tolerance 1% "$(stage surfaces block)" -o block.step
    misused qm-export --join "$(stage surfaces block)" -o block.ply
    misused qm-export --analytic "$(stage surfaces block)" -o block.obj
    misused qm-export --unit cm "$(stage surfaces block)" -o block.glb
    misused qm-export --colour deviation "$(stage surfaces block)" -o block.step
}

@test "the unit is declared" {
    quietly qm-export --unit cm "$(stage surfaces block)" -o block.stp
    grep -q "SI_UNIT(.CENTI.,.METRE.)" block.stp
}

@test "gaps are a warning with figures, and status 3" {
    qm-bspline --quiet --fit interpolate "$(stage pruned block)" -o gaps.json
    for format in step iges; do
        run -3 --separate-stderr qm-export --unit m --format $format gaps.json -o block.step
        assert_equal "${#stderr_lines[@]}" 1
        assert_regex "$stderr" '^qm-export: patches are 0\.00[0-9]+ m apart, and STEP joins what is nearer than 1e-07 m\. '
        assert [ -s block.step ]
    done
    quietly qm-export --unit m "$(stage surfaces block)" -o block.step
}

@test "an open shell is told with how many edges are open" {
    qm-bspline --quiet "$(stage pruned plate)" -o plate.json
    run -0 --separate-stderr qm-export plate.json -o plate.step
    assert_equal "${#stderr_lines[@]}" 1
    assert_regex "$stderr" '^qm-export: 1 open shell, 0 solids: [0-9]+ edges of [0-9]+ on the boundary of the mesh\. '
    quietly qm-export --quiet plate.json -o plate.step
}

@test "a mesh that is too small for the format is told, and status 3" {
    awk '/^v / { print "v", $2 * 1e-7, $3 * 1e-7, $4 * 1e-7; next } { print }' "$(sample cube)" >tiny.obj
    qm-basecomplex tiny.obj | qm-enum | qm-merge | qm-bspline -o tiny.json
    run -3 --separate-stderr qm-export tiny.json -o tiny.step
    assert_equal "${#stderr_lines[@]}" 1
    assert_regex "$stderr" '^qm-export: the mesh, [0-9.e-]+ mm across, is too small: .* 1e-07 mm\. Scale it up'
}

@test "IGES, by the output's name or by request" {
    quietly qm-export "$(stage surfaces block)" -o block.igs
    qm-export --format iges <"$(stage surfaces block)" >same.igs
    assert_same_bytes block.igs same.igs
    quietly qm-export "$(stage surfaces block)" -o BLOCK.IGS
    assert_same_bytes block.igs BLOCK.IGS
}

@test "OBJ has a group for every segment and all quads" {
    quietly qm-export "$(stage layout block)" -o block.obj
    assert_equal "$(grep -c '^g segment_' block.obj)" "$(field '.layout.segments | length' "$(stage layout block)")"
    assert_equal "$(grep -c '^f ' block.obj)" "$(field '.mesh.faces' "$(stage layout block)")"
    assert_equal "$(grep -c '^v ' block.obj)" "$(field '.mesh.vertices' "$(stage layout block)")"
}

@test "the mesh is not overwritten by its own export" {
    cp "$(sample block)" block.obj
    qm-basecomplex block.obj | qm-enum | qm-merge -o block.json
    cp block.obj before.obj
    complains qm-export block.json -o block.obj
    assert_equal "$stderr" "qm-export: block.obj: is the mesh that the result refers to. Name another file"
    complains qm-export --mesh before.obj --format ply block.json -o before.obj
    assert_same_bytes block.obj before.obj
    quietly qm-export block.json -o segments.obj
}

@test "a document is not overwritten by what is no document" {
    cp "$(stage surfaces block)" block.json
    for command in 'qm-export --format obj' qm-summary qm-check qm-view; do
        complains $command block.json -o ./block.json
        assert_equal "$stderr" "${command%% *}: ./block.json: is the input. Name another file"
    done
    assert_same_bytes "$(stage surfaces block)" block.json
}

@test "a name that no product can have is refused" {
    misused qm-export --name "$(printf 'y%.0s' {1..1500})" "$(stage surfaces block)" -o block.igs
    misused qm-export --name $'\xff' "$(stage surfaces block)" -o block.step
    quietly qm-export --name "$(printf 'y%.0s' {1..1000})" "$(stage surfaces block)" -o block.igs
}

@test "PLY and glTF begin as they must" {
    quietly qm-export "$(stage surfaces block)" --colour deviation -o block.ply
    assert_equal "$(head -n 1 block.ply)" ply
    quietly qm-export "$(stage layout block)" -o block.glb
    assert_equal "$(head -c 4 block.glb)" glTF
}

@test "the same bytes every time" {
    for format in step iges obj ply glb; do
        qm-export --format $format "$(stage surfaces block)" >one
        qm-export --format $format --jobs 1 "$(stage surfaces block)" >two
        assert_same_bytes one two
    done
}

@test "STEP needs surfaces" {
    complains qm-export --format step "$(stage layout block)"
    assert_regex "$stderr" 'qm-bspline'
    complains qm-export --format ply --colour deviation "$(stage layout block)"
}

@test "a format must be known" {
    misused qm-export "$(stage surfaces block)"
    misused qm-export "$(stage surfaces block)" -o block.xyz
    misused qm-export "$(stage surfaces block)" --format stl
    misused qm-export "$(stage surfaces block)" --format step --unit mile
}

@test "products are named by the mesh's file or by --name, whatever its letters" {
    quietly qm-export "$(stage surfaces block)" -o part.step
    grep -q "PRODUCT('block','block'" part.step
    grep -q "^FILE_NAME('block','1970-01-01T00:00:00'" part.step
    quietly qm-export --name "Öse 'a', left" "$(stage surfaces block)" -o part.step
    grep -q "PRODUCT('\\\\X2\\\\00D6\\\\X0\\\\se ''a''\\\\X2\\\\002C\\\\X0\\\\ left'" part.step
    quietly qm-export --name bolt "$(stage surfaces block)" -o part.igs
    grep -q '4Hbolt' part.igs
    misused qm-export --name bolt "$(stage layout block)" -o part.obj
}

@test "a product has a name also where that of the mesh's file is not UTF-8" {
    cp "$(sample block)" $'bl\xffck.obj'
    quietly qm-export --mesh $'bl\xffck.obj' "$(stage surfaces block)" -o part.step
    grep -q "^FILE_NAME('bl?ck'" part.step
}

@test "files have the date that is asked for, and none of their own" {
    quietly qm-export --date 2026-11-22 "$(stage surfaces block)" -o part.step
    grep -q "^FILE_NAME('block','2026-11-22T00:00:00'" part.step
    quietly qm-export --date 2026-11-22T10:20:30 "$(stage surfaces block)" -o part.igs
    grep -q '20261122.102030' part.igs
    cp "$(sample block)" block.obj
    touch -d '2020-02-29 12:34:56 UTC' block.obj
    quietly qm-export --date mesh --mesh block.obj "$(stage surfaces block)" -o part.step
    grep -q "'2020-02-29T12:34:56'" part.step
    for date in today 2026-13-01 2026-02-30 2026-01-01T25:00:00 26-1-1 2026-01-01T; do
        misused qm-export --date "$date" "$(stage surfaces block)" -o part.step
    done
    misused qm-export --date 2026-11-22 "$(stage layout block)" -o part.obj
}
