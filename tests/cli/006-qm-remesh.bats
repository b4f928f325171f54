# qm-remesh: quads from triangles, with Blender where it is installed.

load helpers.bash

blender_or_skip() { command -v blender >/dev/null || skip 'there is no Blender'; }

# fake_blender COMMAND [RESOLUTION]: in Blender's place, a script that runs the command and gives back a cube around the
# scan, whose box is 1024 units long for Blender.
fake_blender() {
    mkdir folder
    qm-shape cube --resolution "${2-1}" | awk '{ v[NR] = $0 } /^v / { for (k = 2; k < 5; ++k) if ($k > most) most = $k }
        END { for (n = 1; n <= NR; ++n) { $0 = v[n]; if ($1 == "v") for (k = 2; k < 5; ++k) $k = ($k / most - 0.5) * 1024; print } }' >cube.obj
    printf '#!/bin/bash\n%s\ncp %q "${@: -5:1}"\n' "$1" "$PWD/cube.obj" >folder/blender
    chmod +x folder/blender
    export PATH=$PWD/folder:$PATH
}

@test "a scan becomes a mesh of about so many quads" {
    blender_or_skip
    qm-shape bracket --scan 6000 -o scan.stl
    quietly qm-remesh scan.stl --quads 1200 -o part.obj
    quietly qm-basecomplex part.obj -o part.json
    quads=$(field .mesh.faces part.json)
    assert [ "$quads" -gt 900 ]
    assert [ "$quads" -lt 1500 ]
    # It stays where the scan is, and has neither holes nor other parts.
    quietly qm-summary --json part.json
    jq -e '.boundaryLoops == [] and .pieces == 1' <<<"$output"
    qm-remesh scan.stl --quads 1200 | cmp - part.obj
}

@test "every format of triangles is read, wherever the scan lies" {
    blender_or_skip
    qm-shape block --scan 3000 -o scan.obj
    for ending in ply off stl; do
        qm-shape block --scan 3000 -o "scan.$ending"
        quietly qm-remesh --quads 400 "scan.$ending" -o "$ending.obj"
    done
    assert_same_bytes ply.obj off.obj
    # Far from the origin single precision alone would leave steps.
    awk '/^v / { $2 += 1e6; $3 -= 1e6 } { print }' OFMT=%.17g CONVFMT=%.17g scan.obj >far.obj
    quietly qm-remesh --quads 400 far.obj -o far-quads.obj
    quietly qm-summary --json <(qm-basecomplex far-quads.obj) --mesh far-quads.obj
    jq -e '(.size[0] - 3 | fabs) < 0.05 and (.size[2] - 2 | fabs) < 0.05' <<<"$output"
}

@test "a scan may have edges that are very short" {
    blender_or_skip
    # A point beside the first corner of a triangle, a ten-thousandth of its sides away.
    awk '/^v / { x[++n] = $2; y[n] = $3; z[n] = $4 }
         /^f / && !done++ {
             a = $2; b = $3; c = $4; s = 1e-4
             printf "v %.17g %.17g %.17g\n", x[a] + s * (x[b] + x[c] - 2 * x[a]), y[a] + s * (y[b] + y[c] - 2 * y[a]), z[a] + s * (z[b] + z[c] - 2 * z[a])
             print "f", a, b, n + 1; print "f", b, c, n + 1; print "f", c, a, n + 1
             next
         }
         { print }' <(qm-shape block --scan 3000) >scan.obj
    quietly qm-remesh --quads 400 scan.obj -o part.obj
    quietly qm-basecomplex part.obj -o part.json
}

@test "what is asked for reaches QuadriFlow" {
    fake_blender "printf '%s ' \"\${@: -4}\" >>${PWD@Q}/told"
    qm-shape block --scan 500 -o scan.stl
    qm-shape plate --scan 500 -o open.stl
    quietly qm-remesh scan.stl -o part.obj
    assert_equal "$(cat told)" '5000 1 0 0 '
    rm told
    quietly qm-remesh scan.stl --quads 70 --no-preserve-sharp --seed 4 -o part.obj
    assert_equal "$(cat told)" '70 0 0 4 '
    # The vertices stay where they are put, or go to the scan.
    quietly qm-remesh scan.stl --no-draw -o plain.obj
    quietly qm-remesh scan.stl -o drawn.obj
    assert_equal "$(grep -c '^v ' drawn.obj)" "$(grep -c '^v ' plain.obj)"
    run cmp drawn.obj plain.obj
    assert_failure
    rm told
    # Boundaries are kept; a result without them makes it try other seeds, and say so.
    run --separate-stderr qm-remesh open.stl --no-draw -o part.obj
    assert_success
    assert_equal "$(cat told)" '5000 1 1 0 5000 1 1 1 5000 1 1 2 '
    assert_regex "$stderr" 'the quad mesh has 0 boundary loops, the scan has 2'
}

@test "if no seed helps, an open scan does without edges along its boundary" {
    fake_blender "printf '%s ' \"\${@: -2}\" >>${PWD@Q}/told; [[ \${@: -2:1} == 0 ]] || exit 1"
    qm-shape plate --scan 500 -o open.stl
    run -0 --separate-stderr qm-remesh open.stl --seed 3 --no-draw -o part.obj
    assert_equal "$(cat told)" '1 3 1 4 1 5 0 3 '
    assert_regex "$stderr" 'the quad mesh has 0 boundary loops, the scan has 2'
    rm told
    qm-shape block --scan 500 -o closed.stl
    quietly qm-remesh closed.stl -o part.obj
    assert_equal "$(cat told)" '0 0 '
}

@test "an open scan keeps its boundary" {
    blender_or_skip
    qm-shape plate --scan 3000 -o scan.stl
    quietly qm-remesh scan.stl --quads 600 -o part.obj
    quietly qm-summary <(qm-basecomplex part.obj) --mesh part.obj
    assert_line --regexp '^shape +2 open loops'
}

@test "what the quads leave out of a scan is told, and the exit status is 3" {
    fake_blender true 8
    qm-shape cube --scan 400 -o scan.obj
    quietly qm-remesh scan.obj -o part.obj
    # A small octahedron in the middle.
    count=$(grep -c '^v ' scan.obj)
    middle=$(awk '/^v / { for (k = 2; k < 5; ++k) if ($k > most) most = $k } END { print most / 2 }' scan.obj)
    for move in '1 0 0' '-1 0 0' '0 1 0' '0 -1 0' '0 0 1' '0 0 -1'; do
        awk -v middle="$middle" '{ print "v", middle * (1 + $1 / 9), middle * (1 + $2 / 9), middle * (1 + $3 / 9) }' <<<"$move"
    done >>scan.obj
    for face in '1 3 5' '3 2 5' '2 4 5' '4 1 5' '3 1 6' '2 3 6' '4 2 6' '1 4 6'; do
        read -r a b c <<<"$face"
        echo "f $((count + a)) $((count + b)) $((count + c))"
    done >>scan.obj
    run --separate-stderr qm-remesh scan.obj -o part.obj
    assert_equal "$status" 3
    assert_equal "${#stderr_lines[@]}" 1
    assert_regex "$stderr" '^qm-remesh: scan.obj: the quads leave out [0-9.]+% of the scan, up to [0-9.]+ away, at \('
    assert [ -s part.obj ]
    # A cube that is made of a plate.
    qm-shape plate --scan 400 -o scan.obj
    run --separate-stderr qm-remesh --no-draw scan.obj -o part.obj
    assert_equal "$status" 3
    assert_regex "${stderr_lines[-1]}" '^qm-remesh: scan.obj: a vertex of the quads is [0-9.]+ away from the scan, at \('
}

@test "scans that are no manifold are repaired first, and what was done is told" {
    fake_blender "cp \"\${@: -6:1}\" ${PWD@Q}/told.obj"
    qm-shape block --scan 500 -o scan.obj
    quietly qm-remesh scan.obj -o part.obj
    cp told.obj sound.obj
    awk '{ print } /^f / && ++n == 1 { print }' scan.obj >twice.obj
    run -0 --separate-stderr qm-remesh twice.obj -o part.obj
    assert_equal "$stderr" 'qm-remesh: twice.obj: 1 doubled triangle removed'
    assert_same_bytes told.obj sound.obj
    awk '/^f / && ++n == 7 { print "f", $2, $4, $3; next } { print }' scan.obj >turned.obj
    run -0 --separate-stderr qm-remesh turned.obj -o part.obj
    assert_equal "$stderr" 'qm-remesh: turned.obj: 1 triangle turned over'
    assert_same_bytes told.obj sound.obj
    # A fourth and a third side at an edge: a fin.
    awk '/^v / { ++n } /^f / && !done++ { print "v 9 9 9"; print "f", $3, $2, n + 1 } { print }' scan.obj >fin.obj
    run -0 --separate-stderr qm-remesh fin.obj -o part.obj
    assert_regex "$stderr" '1 edge of more than two triangles taken apart, 2 points where the surface touched itself split'
}

@test "a scan that has one side only is refused with the place" {
    printf 'v %s\n' '0 0 0' '0 1 0' '1 0 0' '1 1 0' '2 0 1' '2 1 1' >strip.obj
    printf 'f %s\n' '1 2 3' '2 4 3' '3 4 5' '4 6 5' '5 6 2' '6 1 2' >>strip.obj
    complains qm-remesh strip.obj
    assert_regex "$stderr" 'at \(.*\): a triangle cannot be oriented as all its neighbours are'
}

@test "without Blender it says what to install" {
    qm-shape block --scan 500 -o scan.stl
    mkdir folder
    ln -s "$QM_BIN/qm-remesh" folder
    run --separate-stderr env PATH="$PWD/folder" qm-remesh scan.stl
    assert_complaint qm-remesh
    assert_regex "$stderr" "Install Debian's package blender"
}

@test "what QuadriFlow can do nothing with is told" {
    mkdir folder
    printf '#!/bin/sh\necho Error; exit 1\n' >folder/blender
    chmod +x folder/blender
    qm-shape block --scan 500 -o scan.stl
    PATH=$PWD/folder:$PATH complains qm-remesh scan.stl
    assert_regex "$stderr" 'QuadriFlow gave up'
}

@test "where QuadriFlow does not end, it is tried without regard to sharp edges" {
    fake_blender "[[ \${@: -3:1} == 0 ]] || exec sleep 60"
    qm-shape block --scan 500 -o scan.stl
    PATH=$PWD/folder:$PATH run -0 --separate-stderr qm-remesh scan.stl --quads 8 -o part.obj
    assert_regex "$stderr" 'did not end: made with --no-preserve-sharp'
    assert [ -s part.obj ]
}

@test "an interrupt ends Blender and leaves nothing" {
    mkdir folder temporary
    printf '#!/bin/sh\necho $$ >%s/pid\nexec sleep 60\n' "$PWD" >folder/blender
    chmod +x folder/blender
    qm-shape block --scan 500 -o scan.stl
    TMPDIR=$PWD/temporary PATH=$PWD/folder:$PATH qm-remesh scan.stl -o part.obj &
    command=$!
    for _ in {1..50}; do [[ -s pid ]] && break; sleep 0.1; done
    kill -TERM "$command"
    wait "$command" || true
    assert_equal "$(ls -A temporary)" ''
    assert [ ! -e part.obj ]
    run kill -0 "$(cat pid)"
    assert_failure
}

# write_mixed FILE: a prism over a hexagon, with faces of three, four and six sides.
write_mixed() {
    cat >"$1" <<'END'
v 1 0 0
v .5 .8 0
v -.5 .8 0
v -1 0 0
v -.5 -.8 0
v .5 -.8 0
v 1 0 1
v .5 .8 1
v -.5 .8 1
v -1 0 1
v -.5 -.8 1
v .5 -.8 1
f 6 5 4 3 2 1
f 7 8 9 10
f 7 10 11
f 7 11 12
f 1 2 8 7
f 2 3 9 8
f 3 4 10 9
f 4 5 11 10
f 5 6 12 11
f 6 1 7 12
END
}

@test "--subdivide makes quads of polygons, without Blender" {
    write_mixed mixed.obj
    mkdir folder
    ln -s "$QM_BIN/qm-remesh" folder
    PATH=$PWD/folder quietly qm-remesh --subdivide mixed.obj -o quads.obj
    # As many quads as corners; the vertices stay where they are.
    assert_equal "$(grep -c '^f ' quads.obj)" 40
    assert_equal "$(sed -n '1,12p' quads.obj | awk '{ print $2 + 0, $3 + 0, $4 + 0 }')" "$(sed -n '1,12p' mixed.obj | awk '{ print $2 + 0, $3 + 0, $4 + 0 }')"
    quietly qm-basecomplex --quiet quads.obj -o quads.json
    quietly qm-summary --json quads.json
    jq -e '.boundaryLoops == [] and .pieces == 1' <<<"$output"
    # In a pipe, twice, and from other formats.
    qm-remesh --subdivide <mixed.obj | cmp - quads.obj
    qm-remesh --subdivide <mixed.obj | qm-remesh --subdivide -o twice.obj
    assert_equal "$(grep -c '^f ' twice.obj)" 160
    { echo OFF; echo 12 10 0; sed -n 's/^v //p' mixed.obj; awk '/^f / { printf "%d", NF - 1; for (k = 2; k <= NF; ++k) printf " %d", $k - 1; print "" }' mixed.obj; } >mixed.off
    qm-remesh --subdivide mixed.off | cmp - quads.obj
    run --separate-stderr qm-remesh --subdivide --stats mixed.obj -o quads.obj
    jq -e '.counters == { faces: 10, otherFaces: 3, quads: 40 }' <<<"$stderr"
}

@test "--rho tells which edges --subdivide leaves sharp" {
    qm-shape cube --resolution 1 -o cube.obj
    quietly qm-remesh --subdivide cube.obj -o sharp.obj
    quietly qm-remesh --subdivide --rho 3 cube.obj -o smooth.obj
    # Points in the middles of the faces: on the cube, or off it.
    assert_equal "$(tail -n +9 sharp.obj | awk '/^v / && $2 != 0 && $2 != 1 && $3 != 0 && $3 != 1 && $4 != 0 && $4 != 1' | wc -l)" 0
    run cmp sharp.obj smooth.obj
    assert_failure
}

@test "--subdivide and Blender's options exclude one another" {
    write_mixed mixed.obj
    for words in '--quads 100' --no-preserve-sharp --no-draw '--seed 3'; do
        # shellcheck disable=SC2086
        run --separate-stderr qm-remesh --subdivide $words mixed.obj
        assert_equal "$status" 2
        assert_regex "$stderr" "${words%% *} has no effect without Blender, which --subdivide does not use"
    done
    run --separate-stderr qm-remesh --rho 1 mixed.obj
    assert_equal "$status" 2
    assert_regex "$stderr" 'rho has no effect without --subdivide'
}

@test "triangles are not what --subdivide is for" {
    qm-shape block --scan 500 -o scan.obj
    qm-shape block --scan 500 -o scan.stl
    run -0 --separate-stderr qm-remesh --subdivide scan.obj -o quads.obj
    assert_regex "$stderr" 'are triangles, which make poor quads. For a scan, use --quads instead of --subdivide'
    rm quads.obj
    complains qm-remesh --subdivide scan.stl -o quads.obj
    assert_regex "$stderr" 'STL holds triangles that are not connected'
    assert [ ! -e quads.obj ]
    # The mesh itself is not written over.
    cp scan.obj same.obj
    complains qm-remesh --subdivide scan.obj -o scan.obj
    cmp scan.obj same.obj
}
