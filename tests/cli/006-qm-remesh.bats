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
