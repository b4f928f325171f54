# quadmesh, the one command: what it writes, how it ends, and what it leaves behind.

load helpers.bash

setup() {
    empty_folder
    cp "$(sample cube)" part.obj
    export TMPDIR=$PWD/temporary
    mkdir "$TMPDIR"
}

# Nothing is left of temporary files, whatever the test did.
teardown() {
    run ls -A "$TMPDIR"
    assert_output ''
}

refused() {
    run --separate-stderr quadmesh "$@"
    assert_equal "$status" 2
    assert_equal "${#stderr_lines[@]}" 1
    assert_regex "$stderr" "^quadmesh: .*Try 'quadmesh --help'\.$"
    assert_equal "$output" ''
}

fails_with() {
    run --separate-stderr quadmesh "${@:2}"
    assert_equal "$status" 1
    assert_equal "${#stderr_lines[@]}" 1
    assert_regex "$stderr" "$1"
    assert_equal "$output" ''
}

@test "a mesh becomes a STEP file, and a summary fits a terminal" {
    cp "$(sample block)" part.obj
    quietly quadmesh part.obj -o part.step
    assert_line --regexp '^quads +3072 in 1 piece$'
    assert_line --regexp '^size +3 x 3 x 2 mm$'
    assert_line --regexp '^patches +[1-9][0-9]*$'
    assert_line --regexp '^deviation +[0-9.]+ mm, [0-9.]+% of the tolerance, 0\.00469 mm$'
    assert_line --regexp '^normals +differ by .* degrees at most, 95% by less than '
    assert_line --regexp '^shape +solid$'
    assert_line --regexp '^seconds +[0-9.]+$'
    assert [ "${#lines[@]}" -le 24 ]
    for line in "${lines[@]}"; do assert [ "${#line}" -le 80 ]; done
    assert_equal "$(head -1 part.step)" 'ISO-10303-21;'
}

@test "every ending has its format, and several are written at once" {
    cp "$(sample block)" part.obj
    quietly quadmesh part.obj -o a.step -o b.STP -o c.igs -o d.obj -o e.ply -o f.glb -o g.html -o h.json
    assert_equal "$(head -1 b.STP)" 'ISO-10303-21;'
    assert [ -s c.igs ]
    assert_equal "$(grep -c '^f ' d.obj)" 3072
    assert_equal "$(head -c 3 e.ply)" ply
    assert_equal "$(head -c 4 f.glb)" glTF
    assert_regex "$(head -c 15 g.html)" '^<!doctype html>'
    quietly qm-check h.json
}

@test "pictures need Chromium" {
    [[ $browser ]] || skip 'there is no Chromium'
    quietly quadmesh part.obj -o part.png -o part.html --view.size 320x240
    assert_equal "$(head -c 4 part.png | tail -c 3)" PNG
}

@test "without Chromium a picture is refused before the work" {
    mkdir folder
    for tool in "$QM_BIN"/* /usr/bin/{env,bash,dirname,basename,readlink,realpath,mktemp,rm,cat,sed,grep,mkdir}; do ln -s "$tool" folder; done
    PATH=$PWD/folder fails_with "^quadmesh: .*Install Debian's package chromium" part.obj -o part.step -o part.png
    assert [ ! -e part.step ]
}

@test "the document is that of the pipe" {
    quadmesh --quiet part.obj -o one.json --cut.chi 20 --features.tau=4 --features.zeta 1
    FEATURES_OPTIONS='--tau 4 --zeta 1' CUT_OPTIONS='--chi 20' SURFACES_OPTIONS='' "$ROOT/pipelines/layout.sh" part.obj -o pipe.json
    assert_same_bytes pipe.json one.json
}

@test "links are written through, and one message tells what cannot be printed" {
    ln -s target.json link.json
    ln -s target.step link.step
    quadmesh --quiet part.obj -o link.json -o link.step
    assert [ -L link.json ]
    assert [ -L link.step ]
    quietly qm-check target.json
    assert [ -s target.step ]
    run --separate-stderr bash -c 'quadmesh part.obj >/dev/full'
    assert_equal "$status:$stderr" '1:quadmesh: standard output cannot be written to'
}

@test "--keep leaves the documents that layout.mk would" {
    quadmesh --quiet part.obj --keep stages
    make -s --no-print-directory -f "$ROOT/pipelines/layout.mk" out/part.surfaces.json
    for document in out/*.json; do
        assert_same_bytes "$document" "stages/${document#out/}"
    done
    assert_equal "$(find stages -type f | wc -l)" 7
}

@test "a tolerance that is missed is told with its place, and the exit status is 3" {
    run --separate-stderr quadmesh part.obj -o part.step --tolerance 1e-12
    assert_equal "$status" 3
    assert_equal "${#stderr_lines[@]}" 1
    assert_regex "$stderr" '^quadmesh: the tolerance is missed: .* mm where 1e-12 mm are allowed, in patch [0-9]+ at \(.*\)'
    assert [ -s part.step ]
}

@test "--max-patches prunes further, and where that is not enough the exit status is 3" {
    cp "$(sample bracket)" part.obj
    quadmesh --json part.obj --tolerance 5% >all.json
    all=$(field .patches all.json)
    quadmesh --json part.obj --tolerance 5% --max-patches $((all - 1)) >fewer.json
    assert [ "$(field .patches fewer.json)" -lt "$all" ]
    run --separate-stderr quadmesh part.obj --tolerance 5% --max-patches 2
    assert_equal "$status" 3
    assert_equal "${#stderr_lines[@]}" 1
    assert_regex "$stderr" '^quadmesh: there are [0-9]+ patches where 2 are allowed'
}

@test "--json gives the same figures" {
    cp "$(sample block)" part.obj
    quietly quadmesh --json part.obj --unit inch -o part.step
    jq -e '.unit == "inch" and .quads == 3072 and .solid and .surfaces.deviation <= .surfaces.tolerance
        and .surfaces.gap < 1e-9 and .seconds > 0 and .unmet == [] and .boundaryLoops == []' <<<"$output"
    grep -q INCH part.step
}

@test "an open mesh is told with the lengths of its loops" {
    run --separate-stderr quadmesh "$(sample plate)" --tolerance 5%
    assert_success
    assert_regex "$stderr" 'the mesh is open: 2 boundary loops'
    assert_line --regexp '^shape +shell, 2 open loops, [0-9.]+, [0-9.]+ mm long$'
}

@test "a limit of time ends a search or the fit, which is told" {
    cp "$(sample genus3)" part.obj
    run --separate-stderr quadmesh part.obj --time-limit 1 --cut.chi 1e9 --tolerance 5% --json
    assert_success
    [[ -z $stderr ]] || assert_regex "$stderr" 'a limit ended the (search|fit)'
}

@test "values may be attached to the names of options" {
    cp "$(sample block)" part.obj
    quietly quadmesh -j1 -opart.step --output=v1.2=a.json --tolerance=1% --cut.chi=20 part.obj
    assert_line --regexp 'tolerance, 0\.0469 mm$'
    assert [ -s part.step ]
    assert [ -s v1.2=a.json ]
}

@test "names with blanks, and names that look like options" {
    cp part.obj 'my part.obj'
    cp part.obj ./-o.obj
    mkdir 'my folder'
    quietly quadmesh 'my part.obj' -o 'my folder/a part.step' --keep 'my stages'
    assert [ -s 'my folder/a part.step' ]
    assert [ -s 'my stages/my part.surfaces.json' ]
    quietly quadmesh ./-o.obj
    quietly quadmesh --quiet -- -o.obj
}

@test "a mesh may have a long name; where others are made of it, one that is too long is told" {
    long=$(printf '%0240d' 0)
    mv part.obj "$long.obj"
    quietly quadmesh "$long.obj" -o part.step
    for option in '--keep stages' '--quads 500' --repair --basecomplex.repair; do
        # shellcheck disable=SC2086  # a list of words
        fails_with "^quadmesh: $long.obj: the name is too long" "$long.obj" $option
    done
    mv "$long.obj" "${long:14}.obj"
    quietly quadmesh "${long:14}.obj" --keep stages --repair
}

@test "a stage that fails gives one message" {
    echo 'f 1 2 3 4' >broken.obj
    fails_with '^qm-basecomplex: .*broken\.obj: ' broken.obj -o broken.step
    assert [ ! -e broken.step ]
}

@test "a mesh that cannot be read is told with the reason" {
    fails_with '^quadmesh: no-such-file.obj: there is no such file$' no-such-file.obj
    mkdir folder.obj
    fails_with '^quadmesh: folder.obj: is a folder' folder.obj
    [[ $(id -u) != 0 ]] || return 0 # who may read everything
    chmod 0 part.obj
    fails_with '^quadmesh: part.obj: cannot be read: permission denied$' part.obj
}

@test "where nothing can be written it is told before the work" {
    mkdir folder.step
    fails_with '^quadmesh: folder.step: is a folder' part.obj -o folder.step
    fails_with '^quadmesh: nowhere/part.step: cannot be written' part.obj -o nowhere/part.step
    fails_with '^quadmesh: part.obj: is the mesh itself' part.obj -o part.obj
    fails_with '^quadmesh: part.obj: is a file. Name a folder' part.obj --keep part.obj
    fails_with '^quadmesh: part.obj/stages: cannot be made: Not a directory' part.obj --keep part.obj/stages
}

@test "no result takes the place of a mesh or document that another needs" {
    refused part.obj --repair -o part.json -o part.repaired.obj
    refused part.obj --quads 500 -o part.json -o ./part.quads.obj
    mkdir stages
    refused part.obj --repair --keep stages -o stages/part.repaired.obj
    refused part.obj --keep stages -o stages/part.layout.json
    quietly quadmesh --quiet part.obj --keep stages -o stages/part.surfaces.json -o part.repaired.obj
    quietly qm-check stages/part.surfaces.json
}

@test "searches of whole meshes are not made of pieces" {
    cp "$(sample helix)" part.obj
    for search in --enum.method=plain --enum.class=tmesh; do
        quietly quadmesh --quiet part.obj --cut.chi=20 -o cut.json
        refused part.obj "$search" --cut.chi=20
        quietly quadmesh --quiet part.obj "$search" -o whole.json
        quietly qm-check whole.json
        assert_equal "$(jq 'has("cut")' cut.json whole.json)" $'true\nfalse'
    done
}

@test "a wrong command line is told at once" {
    refused
    refused --no-such-option part.obj
    refused --json=part.obj
    refused --quiet= part.obj
    refused ''
    refused part.obj ''
    assert_regex "$stderr" 'MESH is empty'
    refused part.obj other.obj
    refused part.obj -o
    refused part.obj -o part.xyz
    refused part.obj --tolerance x
    refused part.obj --max-patches 0
    refused part.obj --jobs 1025
    refused part.obj --unit furlong
    refused part.obj --cut.chi
    refused part.obj --cut.chi x
    refused part.obj --cut.no-such-option 1
    refused part.obj --cut.avoid-features=yes
    refused part.obj --nothing.chi 1
    refused part.obj --cut.mesh other.obj
    refused part.obj -o .step
    refused part.obj -o part.step -o ./part.step
    refused part.obj --view.show no-such-layer -o part.html
    refused part.obj --view.size 3 -o part.png
    refused part.obj --view.no-key -o part.html
    refused part.obj --remesh.seed x --quads 500
    refused -- part.obj other.obj
    refused -
}

@test "an option that has no effect is told" {
    refused part.obj --view.size 10x10 -o part.step
    refused part.obj --export.join -o part.obj.json
    refused part.obj --export.colour deviation -o part.step
    refused part.obj --remesh.seed 3
    refused part.obj --export.analytic-tolerance 1% -o part.step
}

@test "options of stages that do not go with those of quadmesh are told before the work" {
    refused part.obj --enum.method plain --time-limit 5 -o part.step
    refused part.obj --prune.method optimum --prune.max-segments 10 --max-patches 5 -o part.step
    refused part.obj --bspline.fit interpolate --tolerance 1% -o part.step
    # What is for several runs, or several documents.
    refused part.obj --enum.part 1/2
    refused part.obj --enum.join
    refused part.obj --bspline.rank
    assert [ ! -e part.step ]
}

@test "options of the first pruning do not stand in the way of the next" {
    for options in '--prune.eta -5' '--prune.method optimum --prune.beta 3' '--prune.method greedy --time-limit 9' \
        '--prune.method optimum --prune.fewest-patches' '--prune.min-corner 10'; do
        # shellcheck disable=SC2086  # a list of words
        run --separate-stderr quadmesh part.obj $options --max-patches 5 --tolerance 5% -o part.step
        assert_equal "$status" 3
        assert_equal "${#stderr_lines[@]}" 1
        assert_regex "$stderr" '^quadmesh: there are [0-9]+ patches where 5 are allowed'
        rm part.step
    done
    # A limit of time holds for every search.
    quadmesh part.obj --prune.method optimum --time-limit 7 --tolerance 5% -o part.json
    jq -e '[.history[] | select(.tool | IN("qm-enum", "qm-merge", "qm-prune", "qm-bspline")).options.timeLimit]
        | length == 4 and all(. > 0 and . <= 7)' part.json
    quietly quadmesh part.obj --bspline.fit interpolate --time-limit 100
}

@test "signs that no option has, and lines within a value, are told" {
    refused part.obj '--cut.chi(' 20
    assert_regex "$stderr" 'qm-cut has no option --chi\('
    refused part.obj '--cut.c.i' 20
    refused part.obj $'--cut.chi\n' 20
    refused part.obj --cut.chi $'20\n--lambda\n3'
    assert_regex "$stderr" 'cut.chi: its value has a line break'
    refused part.obj --cut.chi=$'20\n--lambda\n3'
    refused part.obj --max-patches 1000000000
    assert_regex "$stderr" "'1000000000' is no whole number from 1 to 999999999"
}

@test "what quadmesh sets itself is not for a stage" {
    refused part.obj --remesh.quads 100 --quads 500
    refused part.obj --export.unit cm -o part.step
    refused part.obj --view.unit cm -o part.html
    refused part.obj --view.png part.png -o part.html
    refused part.obj --bspline.tolerance 1%
}

@test "--verbose tells the settings of every stage" {
    quadmesh --verbose part.obj -o part.step 2>messages >summary
    run cut -d : -f 1 messages
    assert_output "$(printf 'qm-%s\n' basecomplex features cut enum merge prune bspline export)"
}

@test "a full disk is one message, and leaves no part of a file" {
    cp "$(sample block)" part.obj
    [[ -e /dev/shm && $(id -u) == 0 ]] || skip 'a small disk can be made by root only'
    mkdir small
    mount -t tmpfs -o size=64k tmpfs small || skip 'a small disk cannot be made here'
    for output in small/part.step small/part.json; do
        run --separate-stderr quadmesh part.obj -o "$output"
        echo "$status ${#stderr_lines[@]} $stderr"
    done >told
    run ls -A small
    umount small
    assert_output ''
    assert_equal "$(grep -c "^1 1 .*small/part.*: cannot be written: No space left on device$" told)" 2
}

@test "the unit is that of all files" {
    quadmesh --quiet part.obj --unit inch -o part.step -o part.html
    grep -q "CONVERSION_BASED_UNIT('INCH'" part.step
    grep -q 'largest deviation, inch' part.html
}

@test "a file that other programs will hardly take is told, and the exit status is 3" {
    cp "$(sample block)" part.obj
    run --separate-stderr quadmesh part.obj --bspline.fit interpolate -o part.step
    assert_equal "$status" 3
    assert_equal "${#stderr_lines[@]}" 1
    assert_regex "$stderr" '^qm-export: patches are [0-9.]+ mm apart'
    assert_line --regexp '^shape +closed, but patches are apart$'
    assert [ -s part.step ]
    local told=$stderr
    run --separate-stderr quadmesh --quiet part.obj --bspline.fit interpolate -o part.step
    assert_equal "$status" 3
    assert_equal "$stderr" "$told"
}

@test "--repair mends, and the mesh lies beside the document" {
    awk '/^f / && ++n == 5 { print } { print }' part.obj >twice.obj
    run --separate-stderr quadmesh twice.obj
    assert_failure
    mkdir result
    run --separate-stderr quadmesh --repair twice.obj -o result/twice.json
    assert_success
    assert_regex "$stderr" 'duplicate face removed'
    # Nobody is sent to a mesh that is gone, but told of one that is kept.
    refute_regex "$stderr" 'mesh is now'
    run --separate-stderr quadmesh --repair twice.obj --keep kept
    assert_regex "$stderr" 'mesh is now kept/twice.repaired.obj'
    assert [ -s kept/twice.repaired.obj ]
    cd result && quietly qm-check twice.json
}

# hangs TOOL BY [after]: another is in the tool's place, and waits until there is a file `ended` where the tool's options
# are tried (BY is options) or where it works (BY is work), with `after` when it has worked. It has begun when there is a
# file `started`.
hangs() {
    rm -rf tools started ended
    mkdir tools
    ln -s "$QM_BIN"/qm-* tools
    rm "tools/$1"
    cat >"tools/$1" <<END
#!/bin/bash
by=work
[[ \${*: -1} != /dev/null ]] || by=options
[[ \$by == $2 ]] || exec '$QM_BIN/$1' "\$@"
[[ '${3-}' != after ]] || '$QM_BIN/$1' "\$@"
echo >started
for _ in {1..600}; do [[ ! -e ended ]] || break; sleep 0.05; done
END
    chmod +x "tools/$1"
}

@test "a signal ends it at once and leaves nothing" {
    for case in 'qm-export options TERM' 'qm-basecomplex work HUP' 'qm-cut work TERM' 'qm-bspline work HUP' 'qm-export work TERM'; do
        read -r tool by signal <<<"$case"
        # A command in the background of a script cannot be interrupted from the keyboard.
        hangs "$tool" "$by"
        QM_BIN=$PWD/tools quadmesh part.obj --unit mm -o part.step 2>messages &
        command=$!
        for _ in {1..200}; do [[ -e started ]] && break; sleep 0.05; done
        assert [ -e started ]
        kill -"$signal" "$command"
        wait "$command" && status=0 || status=$?
        : >ended
        assert_equal "$status" $((128 + $(kill -l "$signal")))
        assert [ ! -e part.step ]
        assert_equal "$(ls -A "$TMPDIR")" ''
    done
}

@test "what an interrupted stage leaves among the documents that are kept is named so" {
    hangs qm-bspline work after
    QM_BIN=$PWD/tools quadmesh part.obj --keep kept 2>messages &
    command=$!
    for _ in {1..400}; do [[ -e started ]] && break; sleep 0.05; done
    kill -TERM "$command"
    wait "$command" && status=0 || status=$?
    : >ended
    assert_equal "$status" 143
    assert_equal "$(<messages)" 'quadmesh: interrupted. What was found until then is kept/part.surfaces.json.interrupted'
    assert_equal "$(cd kept && echo *surfaces*)" part.surfaces.json.interrupted
    quietly qm-check kept/part.surfaces.json.interrupted
    quietly quadmesh part.obj --keep kept
    assert_equal "$(cd kept && echo *surfaces*)" part.surfaces.json
}

# frame HEIGHT QUADS: a frame of 40 x 30 with walls 4 wide, so many quads high; every vertex has valence four.
frame() {
    awk -v height="$1" -v high="$2" '
        function ring(inset, z,   side, k) {
            for (side = 0; side < 4; ++side)
                for (k = 0; k < 8; ++k) print "v", corner(side, 0, inset, k), corner(side, 1, inset, k), z
            ++rings
        }
        function end(side, axis, inset) {
            return axis == 0 ? (side % 4 == 0 || side % 4 == 3 ? inset : 40 - inset) : (side % 4 < 2 ? inset : 30 - inset)
        }
        function corner(side, axis, inset, k) {
            return (end(side, axis, inset) * (8 - k) + end(side + 1, axis, inset) * k) / 8
        }
        BEGIN {
            for (j = 0; j <= high; ++j) ring(0, height * j / high)
            ring(2, height)
            for (j = high; j >= 0; --j) ring(4, height * j / high)
            ring(2, 0)
            for (i = 0; i < rings; ++i)
                for (k = 0; k < 32; ++k) {
                    up = (i + 1) % rings
                    print "f", 32 * i + k + 1, 32 * i + (k + 1) % 32 + 1, 32 * up + (k + 1) % 32 + 1, 32 * up + k + 1
                }
        }'
}

@test "frames and tubes keep their mitred corners, and become planes" {
    for size in '60 12' '5 3'; do
        # shellcheck disable=SC2086  # two words
        frame $size >frame.obj
        quietly quadmesh frame.obj -o frame.step -o frame.json
        assert_equal "$(jq '.surfaces.deviation | .maxFromFacets < 0.1 * .max / .maxRelative * 1e-3' frame.json)" true
        assert_equal "$(jq '.surfaces.patches | length' frame.json)" 16
        assert_equal "$(grep -c 'PLANE(' frame.step)" 16
        quietly qm-check frame.json
    done
    quietly quadmesh frame.obj --prune.max-sharp-turn 180 --features.short-rho 3.14 -o paper.json
    assert_equal "$(jq '.surfaces.patches | length' paper.json)" 4
}

@test "standard output that is closed or full is an error" {
    run --separate-stderr bash -c 'quadmesh part.obj >/dev/full'
    assert_equal "$status" 1
    for words in --help --version --json-usage; do
        for place in /dev/full '&-'; do
            run --separate-stderr bash -c "quadmesh $words >$place"
            assert_equal "$status" 1
            assert_equal "$stderr" 'quadmesh: standard output cannot be written to'
        done
    done
}

@test "triangles need --quads, and --quads needs Blender" {
    qm-shape block --scan 3000 -o 'my scan.stl'
    fails_with 'my scan.stl: .* faces are not four-sided. Make quads of all faces: quadmesh --quads N' 'my scan.stl' -o scan.step
    mkdir folder
    for tool in "$QM_BIN"/* /usr/bin/{env,bash,dirname,basename,readlink,mktemp,rm,cat,sed,grep,mkdir}; do ln -s "$tool" folder; done
    PATH=$PWD/folder run --separate-stderr quadmesh 'my scan.stl' --quads 500
    assert_equal "$status" 1
    assert_regex "$stderr" "Install Debian's package blender"
    assert_equal "${#stderr_lines[@]}" 1
}

@test "--subdivide makes quads of other polygons first" {
    # One face of the part in two triangles.
    awk '/^f / && !done++ { print "f", $2, $3, $4; print "f", $2, $4, $5; next } { print }' part.obj >mixed.obj
    fails_with 'mixed.obj: .* faces are not four-sided. Make quads of all faces: quadmesh --subdivide' mixed.obj -o mixed.step
    quietly quadmesh mixed.obj --subdivide -o mixed.step -o mixed.json --keep stages
    assert_line 'mesh        mixed.quads.obj'
    assert_line --regexp '^shape +solid$'
    refute_line --regexp '^scan '
    qm-remesh --subdivide mixed.obj | cmp - stages/mixed.quads.obj
    cmp stages/mixed.quads.obj mixed.quads.obj
    # An option of the stage; and what does not go together.
    quietly quadmesh mixed.obj --subdivide --remesh.rho 1 -o other.json
    run --separate-stderr quadmesh mixed.obj --subdivide --quads 100
    assert_equal "$status" 2
    assert_regex "$stderr" '^quadmesh: --quads and --subdivide exclude one another'
    run --separate-stderr quadmesh mixed.obj --remesh.subdivide
    assert_equal "$status" 2
    assert_regex "$stderr" '^quadmesh: --remesh.subdivide is --subdivide of quadmesh itself'
}

@test "a scan becomes a STEP file" {
    command -v blender >/dev/null || skip 'there is no Blender'
    qm-shape block --scan 6000 -o 'my scan.stl'
    mkdir result
    quietly quadmesh 'my scan.stl' --quads 1500 --tolerance 5% -o scan.step -o 'result/my scan.json' --keep stages
    assert_line 'mesh        my scan.quads.obj'
    assert_line --regexp '^shape +solid$'
    # How near the surfaces are to the scan as it is, and as it is without its noise.
    assert_line --regexp '^scan +shows .*% of the mesh, noise '
    assert_line --regexp '^  distance  with its noise .* mm RMS, 95% .*, at most '
    assert_line --regexp '^deviation .* mm without it, .*% of the tolerance'
    assert [ -s 'stages/my scan.quads.obj' ]
    # The document lies beside its mesh, and is the same again.
    (cd result && quietly qm-summary 'my scan.json')
    quietly quadmesh 'my scan.stl' --quads 1500 --tolerance 5% -o again.json --json
    jq -e '.surfaces.scan | .rms < .percentile95 and .percentile95 < .max' <<<"$output"
    assert_same_bytes again.json 'result/my scan.json'
    quietly quadmesh 'my scan.stl' --quads 1500 --remesh.seed 5 --tolerance 5% -o other.json
    run cmp again.json other.json
    assert_failure
}

@test "--quiet says nothing, and a summary only where JSON is asked for" {
    quietly quadmesh --quiet part.obj
    assert_output ''
    quietly quadmesh --quiet --json part.obj
    assert_output --partial '"patches"'
}

@test "it explains itself, with examples that run" {
    quietly quadmesh --help
    assert_line --regexp '^Usage: quadmesh'
    quietly quadmesh --version
    assert_regex "${lines[0]}" '^quadmesh \(quadmesh\) [0-9]'
    quietly bash -c 'quadmesh --json-usage | jq -e ".options | length > 10"'
    while IFS= read -r example; do
        quietly bash -euc "$example"
    done < <(quadmesh --help | sed -n '/^Examples/,$ s/^  quadmesh/quadmesh/p' | grep -v -- --quads)
}
