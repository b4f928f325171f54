# pipelines/layout.mk and layout.sh: the same bytes, and a cache that runs what must run and nothing else.

load helpers.bash

setup() {
    empty_folder
    cp "$(sample cube)" part.obj
}

layout_mk() { make --no-print-directory -f "$ROOT/pipelines/layout.mk" "$@"; }
layout_sh() { "$ROOT/pipelines/layout.sh" "$@"; }

# The tools that a run of layout.mk started, in order, on one line.
ran() { layout_mk "$@" | sed -nE 's/^.*run-stage (qm-[a-z]+) .*/\1/p' | tr '\n' ' ' | sed 's/ $//'; }

EVERYTHING='qm-basecomplex qm-features qm-cut qm-enum qm-merge qm-prune qm-bspline'
FROM_CUT='qm-cut qm-enum qm-merge qm-prune qm-bspline'

@test "layout.mk and layout.sh give the same bytes" {
    layout_mk out/part.surfaces.json
    quietly layout_sh part.obj -o pipe.json
    assert_same_bytes pipe.json out/part.surfaces.json
    layout_sh part.obj >pipe.json
    assert_same_bytes pipe.json out/part.surfaces.json
}

@test "... with options for the stages too" {
    export FEATURES_OPTIONS='--tau 4 --zeta 1' CUT_OPTIONS='--chi 20' ENUMERATION_OPTIONS='--best 2' PRUNED_OPTIONS='--eta -3'
    layout_mk out/part.surfaces.json
    layout_sh part.obj -o pipe.json
    assert_same_bytes pipe.json out/part.surfaces.json
    assert_equal "$(field '[.history[] | select(.tool == "qm-cut") | .options.chi] | first' pipe.json)" 20
}

@test "the first run makes every stage, the second none" {
    assert_equal "$(ran out/part.surfaces.json)" "$EVERYTHING"
    assert_equal "$(ran out/part.surfaces.json)" ''
    run ls out
    assert_output - <<'END'
part.basecomplex.json
part.cut.json
part.enumeration.json
part.features.json
part.layout.json
part.pruned.json
part.surfaces.json
END
}

@test "an option runs its stage and what follows, once" {
    layout_mk out/part.surfaces.json
    assert_equal "$(ran CUT_OPTIONS='--chi 20' out/part.surfaces.json)" "$FROM_CUT"
    assert_equal "$(ran CUT_OPTIONS='--chi 20' out/part.surfaces.json)" ''
    assert_equal "$(ran CUT_OPTIONS='--chi  20 ' out/part.surfaces.json)" ''
    assert_equal "$(ran out/part.surfaces.json)" "$FROM_CUT"
}

@test "options that change no result run nothing" {
    layout_mk out/part.surfaces.json
    assert_equal "$(ran COMMON_OPTIONS='--jobs 2 --quiet' out/part.surfaces.json)" ''
}

@test "documents that are deleted are made again only where they are needed" {
    layout_mk out/part.surfaces.json
    rm out/part.features.json out/part.layout.json
    assert_equal "$(ran out/part.surfaces.json)" ''
    assert_equal "$(ran CUT_OPTIONS='--chi 20' out/part.surfaces.json)" "qm-features $FROM_CUT"
}

@test "a changed mesh runs everything" {
    layout_mk out/part.surfaces.json
    echo '# changed' >>part.obj
    assert_equal "$(ran out/part.surfaces.json)" "$EVERYTHING"
}

@test "a file edited by hand is kept, and what follows is made anew" {
    layout_mk out/part.surfaces.json
    jq '. + {"note": "mine"}' out/part.features.json >edited
    cp edited out/part.features.json
    assert_equal "$(ran out/part.surfaces.json)" "$FROM_CUT"
    assert_same_bytes edited out/part.features.json
    assert_equal "$(field .note out/part.surfaces.json)" mine
    assert_equal "$(ran out/part.surfaces.json)" ''
}

@test "a file edited by hand is put aside when its stage must run again" {
    layout_mk out/part.surfaces.json
    jq '. + {"note": "mine"}' out/part.features.json >edited
    cp edited out/part.features.json
    run --separate-stderr layout_mk FEATURES_OPTIONS='--tau 7' out/part.surfaces.json
    assert_success
    assert_regex "$stderr" 'out/part.features.json was edited by hand'
    assert_same_bytes edited out/part.features.json.edited
    assert_equal "$(field .note out/part.surfaces.json)" null
}

@test "nothing that a stage did not write is overwritten, however often it is edited" {
    cp "$(sample cube)" part.obj
    mkdir out
    echo mine >out/part.cut.json
    run --separate-stderr layout_mk -s out/part.layout.json
    assert_success
    assert_regex "$stderr" 'It is now out/part.cut.json.edited$'
    assert_equal "$(cat out/part.cut.json.edited)" mine
    for number in 2 3; do
        echo "$number" >out/part.cut.json
        run --separate-stderr layout_mk -s CUT_OPTIONS="--chi $number" out/part.cut.json
        assert_regex "$stderr" "It is now out/part.cut.json.edited.$number$"
        assert_equal "$(cat out/part.cut.json.edited.$number)" "$number"
    done
    # What the stage wrote itself is not taken for somebody's work, even if all notes of it are gone.
    layout_mk -s CUT_OPTIONS='--chi 3' out/part.layout.json
    rm -r out/.stages out/*.edited*
    quietly layout_mk -s CUT_OPTIONS='--chi 3' out/part.layout.json
    assert_equal "$(find out -name '*.edited*')" ''
    # A stage that fails leaves it in its place.
    echo mine >out/part.cut.json
    run layout_mk -s CUT_OPTIONS='--chi x' out/part.cut.json
    assert_failure
    assert_equal "$(cat out/part.cut.json)" mine
}

@test "many models at once, each with its own options" {
    mkdir meshes more
    for i in 1 2 3; do cp part.obj meshes/part$i.obj; done
    cp "$(sample cube)" more/cube.obj
    layout_mk -j4 MESH_PATH='meshes more' CUT_OPTIONS='--chi 30' CUT_OPTIONS.part2='--chi 20'
    for i in 1 2 3; do
        layout_mk -n MESH_PATH=meshes out/part$i.surfaces.json >/dev/null
    done
    assert_equal "$(field '.history[] | select(.tool == "qm-cut") | .options.chi' out/part1.surfaces.json)" 30
    assert_equal "$(field '.history[] | select(.tool == "qm-cut") | .options.chi' out/part2.surfaces.json)" 20
    assert_equal "$(field .kind out/cube.surfaces.json)" surfaces
    # Neither order nor company changes the bytes.
    rm -r out
    layout_mk MESH_PATH=meshes CUT_OPTIONS='--chi 30' out/part3.surfaces.json
    cp out/part3.surfaces.json alone
    rm -r out
    layout_mk -j4 MESH_PATH='meshes:more' CUT_OPTIONS='--chi 30'
    assert_same_bytes alone out/part3.surfaces.json
}

@test "settings may stand in a file" {
    printf 'CUT_OPTIONS = --chi 25\nOUT = results\n' >layout.options.mk
    layout_mk results/part.cut.json
    assert_equal "$(field .cut.chi results/part.cut.json)" 25
}

@test "a mesh that is not valid leaves no file and an error" {
    echo 'f 1 2 3 4' >broken.obj
    run layout_mk out/broken.surfaces.json
    assert_failure
    assert_output --partial 'broken.obj'
    run find out -name '*.json'
    assert_output ''
    run layout_sh broken.obj -o broken.json
    assert_failure
    assert [ ! -e broken.json ]
}

@test "layout.sh without operand says how to use it" {
    run --separate-stderr layout_sh
    assert_equal "$status" 2
    assert_regex "$stderr" 'usage: layout.sh MESH'
}

@test "layout.sh takes names with blanks" {
    cp part.obj 'my part.obj'
    quietly layout_sh 'my part.obj' -o 'my part.json'
    assert_equal "$(field .kind 'my part.json')" surfaces
}

@test "a tolerance that is missed is told, kept and told again at the end, unless STRICT is set" {
    cp part.obj other.obj
    run --separate-stderr layout_mk SURFACES_OPTIONS.part='--tolerance 1e-12'
    assert_success
    assert_regex "$stderr" 'tolerance is missed'
    assert_equal "${stderr_lines[-1]}" 'layout.mk: out/part.surfaces.json: qm-bspline misses what was asked for'
    # It is kept, and told whenever the batch is made.
    run --separate-stderr layout_mk SURFACES_OPTIONS.part='--tolerance 1e-12'
    assert_equal "$stderr" 'layout.mk: out/part.surfaces.json: qm-bspline misses what was asked for'
    run layout_mk STRICT=1 SURFACES_OPTIONS.part='--tolerance 1e-13'
    assert_failure
    assert [ ! -e out/part.surfaces.json ] || assert_equal "$(field '.history[-1].options.tolerance' out/part.surfaces.json)" 1e-12
    run --separate-stderr layout_mk
    assert_success
    assert_equal "$stderr" ''
}

@test "STEP files and pages are made of what they show, and only when it has changed" {
    layout_mk out/part.step out/part.html
    assert_equal "$(head -1 out/part.step)" 'ISO-10303-21;'
    assert_equal "$(ran out/part.step out/part.html)" ''
    assert_equal "$(ran STEP_OPTIONS='--unit inch' out/part.step out/part.html)" 'qm-export'
    grep -q INCH out/part.step
}

# A tool in whose place another waits for a signal, writes its best, and says so with its status.
waiting_tool() {
    mkdir tools
    ln -s "$QM_BIN"/qm-* tools
    rm "tools/$1"
    cat >"tools/$1" <<END
#!/bin/bash
trap 'echo partial >"\${*: -1}"; exit 3' TERM INT
echo >started
while :; do sleep 0.05; done
END
    chmod +x "tools/$1"
}

@test "what an interrupt left is not taken for finished" {
    cp "$(sample cube)" part.obj
    waiting_tool qm-enum
    for signal in TERM INT; do
        rm -f started
        # A script starts what is in its background without interrupts.
        env --default-signal=INT setsid make --no-print-directory -f "$ROOT/pipelines/layout.mk" QM_BIN="$PWD/tools" out/part.surfaces.json >messages 2>&1 &
        command=$!
        for _ in {1..100}; do [[ -e started ]] && break; sleep 0.1; done
        # From the keyboard the signal reaches all of them.
        kill -"$signal" -- "-$command"
        wait "$command" || true
        for _ in {1..50}; do pgrep -g "$command" >/dev/null || break; sleep 0.1; done
        assert [ ! -e out/part.enumeration.json ]
        assert_equal "$(cat out/part.enumeration.json.interrupted)" partial
    done
    # The next make runs that stage again, and goes on.
    rm out/*.interrupted
    assert_equal "$(ran out/part.surfaces.json)" 'qm-enum qm-merge qm-prune qm-bspline'
    assert_equal "$(find out -name '*.interrupted' -o -name '.partial*')" ''
}

@test "what is killed leaves no file that looks whole" {
    cp "$(sample cube)" part.obj
    waiting_tool qm-prune
    setsid make --no-print-directory -f "$ROOT/pipelines/layout.mk" QM_BIN="$PWD/tools" out/part.surfaces.json >/dev/null 2>&1 &
    command=$!
    for _ in {1..100}; do [[ -e started ]] && break; sleep 0.1; done
    kill -KILL -- "-$command"
    wait "$command" || true
    assert [ ! -e out/part.pruned.json ]
    assert_equal "$(ran out/part.surfaces.json)" 'qm-prune qm-bspline'
}

@test "a full disk leaves no file that looks whole" {
    cp "$(sample cube)" part.obj
    layout_mk out/part.layout.json
    # The limit on the size of files stands for the disk.
    run bash -c "trap '' XFSZ; ulimit -f 8; make --no-print-directory -f '$ROOT/pipelines/layout.mk' out/part.surfaces.json"
    assert_failure
    assert_equal "$(find out -name '*pruned*' -o -name '*surfaces*' | grep -v '^out/.stages')" ''
    quietly layout_mk -s out/part.surfaces.json
    quietly qm-check out/part.surfaces.json
}

@test "meshes whose paths have blanks are made under other names" {
    cp "$(sample cube)" part.obj
    mkdir 'my parts'
    cp part.obj 'my parts/the first part.obj'
    cp part.obj 'my parts/second.obj'
    quietly layout_mk -s MESH_PATH='my parts'
    assert_equal "$(cd out && echo *.surfaces.json)" 'second.surfaces.json the_first_part.surfaces.json'
    quietly qm-check out/the_first_part.surfaces.json
    # A target with blanks is told, in one line.
    cp part.obj 'the part.obj'
    run --separate-stderr layout_mk -s 'out/the part.step'
    assert_failure
    assert_equal "$output" ''
    assert_equal "${#stderr_lines[@]}" 1
    assert_regex "$stderr" 'the part: targets have no blanks. Write underscores: the_part'
    rm 'the part.obj'
    # One that cannot be made stands alone.
    cp part.obj 'my parts/the_first part.obj'
    echo '# another' >>'my parts/the_first part.obj'
    run --separate-stderr layout_mk -s MESH_PATH='my parts'
    assert_failure
    assert_regex "$stderr" "layout.mk: my parts/the.first part.obj: left out"
    # So it is with signs that make reads.
    rm -r 'my parts' out
    mkdir a=b
    cp part.obj a=b/c=d.obj
    quietly layout_mk -s MESH_PATH=a=b out/c_d.cut.json
    quietly qm-check out/c_d.cut.json
    refused_in_one_line 'out/c=[.]*: targets have no =' 'out/c=d.cut.json'
}

# refused_in_one_line REGEX WORD...: layout.mk makes nothing
refused_in_one_line() {
    run --separate-stderr layout_mk -s "${@:2}"
    assert_failure
    assert_equal "$output" ''
    assert_equal "${#stderr_lines[@]}" 1
    assert_regex "$stderr" "$1"
}

@test "of meshes that have one name the first is made, the others are told, and the batch fails" {
    mkdir a b
    cp "$(sample cube)" a/part.obj
    cp part.obj b/part.obj
    cp "$(sample cube)" b/other.obj
    run --separate-stderr layout_mk -s MESH_PATH='a b'
    assert_failure
    assert_equal "${stderr_lines[0]}" 'layout.mk: b/part.obj: left out, as part is a/part.obj. Rename it'
    assert_regex "$stderr" 'layout.mk: not every mesh was made'
    assert_equal "$(field .mesh.faces out/part.surfaces.json)" 384
    assert_equal "$(field .kind out/other.surfaces.json)" surfaces
    # The same in one folder.
    qm-shape cube -o b/other.ply
    run --separate-stderr layout_mk -s MESH_PATH=b report
    assert_failure
    assert_line 'layout.mk: the report is out/report.html'
    assert_equal "$(grep -c 'b/other.ply: left out, as other is b/other.obj' <<<"$stderr")" 1
    # A folder that is named twice has no mesh twice.
    rm b/other.ply
    quietly layout_mk -s MESH_PATH='b ./b'
    # One that is not there is told.
    run --separate-stderr layout_mk -s MESH_PATH='b c'
    assert_failure
    assert_equal "${stderr_lines[0]}" 'layout.mk: c: is no folder'
}

@test "endings of meshes may be in capitals" {
    mkdir meshes
    cp "$(sample cube)" meshes/BIG.OBJ
    cp "$(sample cube)" meshes/small.obj
    quietly layout_mk -s MESH_PATH=meshes
    assert_equal "$(cd out && echo *.surfaces.json)" 'BIG.surfaces.json small.surfaces.json'
}

@test "a repaired mesh edited by hand is put aside when it is repaired again" {
    awk '/^f / && ++n == 5 { print } { print }' "$(sample cube)" >part.obj
    layout_mk -s BASECOMPLEX_OPTIONS=--repair out/part.basecomplex.json
    mesh=out/part.repaired.obj
    cp "$mesh" first.obj
    touch part.obj
    layout_mk -s BASECOMPLEX_OPTIONS=--repair out/part.basecomplex.json
    assert_equal "$(find out -name '*.edited*')" ''
    for number in '' .2; do
        echo "# mine$number" >>"$mesh"
        cp "$mesh" mine.obj
        touch part.obj
        run --separate-stderr layout_mk -s BASECOMPLEX_OPTIONS=--repair out/part.basecomplex.json
        assert_success
        assert_regex "$stderr" "$mesh was edited by hand.* It is now $mesh.edited$number$"
        assert_same_bytes mine.obj "$mesh.edited$number"
        assert_same_bytes first.obj "$mesh"
    done
    # A stage that fails leaves it in its place.
    echo '# mine' >>"$mesh"
    run layout_mk -s BASECOMPLEX_OPTIONS='--repair --jobs x' out/part.basecomplex.json
    assert_failure
    assert_equal "$(tail -n 1 "$mesh")" '# mine'
    assert_equal "$(echo out/*.edited*)" "$mesh.edited $mesh.edited.2"
    # Nor is it taken for what the stage wrote.
    layout_mk -s BASECOMPLEX_OPTIONS=--repair out/part.basecomplex.json
    assert [ -e "$mesh.edited.3" ]
}

# Tools, with one in the place of qm-remesh that needs no Blender.
remeshing_tools() {
    mkdir tools
    ln -s "$QM_BIN"/qm-* tools
    rm tools/qm-remesh
    # shellcheck disable=SC2016  # for the script
    printf '#!/bin/bash\nqm-shape cube >"${*: -1}"\n' >tools/qm-remesh
    chmod +x tools/qm-remesh
}

@test "what the stages made in the folder of meshes is no input" {
    remeshing_tools
    mkdir models
    cd models
    awk '/^f / && ++n == 5 { print } { print }' "$(sample cube)" >r.obj
    cp "$(sample cube)" s.OBJ
    for _ in 1 2; do
        layout_mk -s QM_BIN="$PWD/../tools" OUT=. BASECOMPLEX_OPTIONS=--repair QUADS.s=100
    done
    assert [ -e r.repaired.obj ]
    assert [ -e s.quads.obj ]
    assert_equal "$(echo *.surfaces.json)" 'r.surfaces.json s.surfaces.json'
    for _ in 1 2 3; do
        layout_mk -s QM_BIN="$PWD/../tools" OUT=. QUADS=100
    done
    assert_equal "$(echo *.surfaces.json)" 'r.surfaces.json s.surfaces.json'
    # A mesh of such a name that somebody else made is one.
    cp "$(sample cube)" mine.quads.obj
    layout_mk -s OUT=. mine.quads.cut.json
    assert [ -e mine.quads.cut.json ]
}

@test "no meshes, and settings that cannot be, are told in one line" {
    mkdir empty
    for path in '' empty; do
        refused_in_one_line "no meshes in '$path'" MESH_PATH="$path"
        refused_in_one_line "no meshes in '$path'" MESH_PATH="$path" report
    done
    for folder in '' 'o 5' a=b a:b a%b; do
        refused_in_one_line "OUT is '$folder': make needs the name of one folder" OUT="$folder"
    done
    for parts in 0 -1 x 1.5 '2 3' 1000000000 "'"; do
        refused_in_one_line "PARTS is '$parts': it must be a whole number" PARTS="$parts"
    done
    cp -r "$ROOT/pipelines" 'my pipelines'
    run --separate-stderr make -f 'my pipelines/layout.mk'
    assert_failure
    assert_equal "${#stderr_lines[@]}" 1
    assert_regex "$stderr" 'the path of layout.mk has blanks'
}

@test "triangles become quads first" {
    command -v blender >/dev/null || skip 'there is no Blender'
    rm part.obj
    qm-shape block --scan 3000 -o scan.stl
    cp "$(sample cube)" cube.obj
    quietly layout_mk -s QUADS.scan=800 SURFACES_OPTIONS='--tolerance 5%'
    assert_equal "$(cd out && echo *.obj *.surfaces.json)" 'scan.quads.obj cube.surfaces.json scan.surfaces.json'
    assert_equal "$(ran QUADS.scan=800 SURFACES_OPTIONS='--tolerance 5%' out/scan.surfaces.json)" ''
    quietly quadmesh --quiet scan.stl --quads 800 --tolerance 5% --keep stages
    assert_same_bytes stages/scan.quads.obj out/scan.quads.obj
    # All of them.
    quietly layout_mk -s QUADS=500 OUT=all all/scan.basecomplex.json
    assert [ "$(field .mesh.faces all/scan.basecomplex.json)" -lt 700 ]
}

@test "other polygons become quads first, where QUADS is the word subdivide" {
    awk '/^f / && !done++ { print "f", $2, $3, $4; print "f", $2, $4, $5; next } { print }' part.obj >mixed.obj
    rm part.obj
    quietly layout_mk -s QUADS.mixed=subdivide
    assert_equal "$(cd out && echo *.obj *.surfaces.json)" 'mixed.quads.obj mixed.surfaces.json'
    assert_equal "$(field '.surfaces.reference // "mesh" | tostring' out/mixed.surfaces.json)" mesh
    quietly quadmesh --quiet mixed.obj --subdivide --keep stages
    assert_same_bytes stages/mixed.quads.obj out/mixed.quads.obj
    assert_equal "$(field '.surfaces.patches | tojson' stages/mixed.surfaces.json)" "$(field '.surfaces.patches | tojson' out/mixed.surfaces.json)"
    quietly layout_mk -s QUADS=subdivide OUT=all all/mixed.quads.obj
    assert_same_bytes all/mixed.quads.obj out/mixed.quads.obj
}

@test "the report has a line for every model, with pictures where there is Chromium" {
    mkdir meshes
    cp "$(sample cube)" meshes/cube.obj
    echo 'f 1 2 3 4' >meshes/b\<c.obj
    run layout_mk -s MESH_PATH=meshes report
    assert_success
    assert_line 'layout.mk: the report is out/report.html'
    sed -n '/^const rows = /,/^\];$/p' out/report.html | sed '1s/^const rows = //; $s/;$//' >rows.json
    assert_equal "$(jq -c '[.[].model]' rows.json)" '["b_c","cube"]'
    assert_equal "$(jq -c '[.[].summary.quads]' rows.json)" '[null,384]'
    assert_equal "$(jq -c '[.[].files | contains(["html", "step", "surfaces.json"])]' rows.json)" '[false,true]'
    [[ ! $browser ]] || assert_equal "$(jq -c '[.[].files | contains(["png"])]' rows.json)" '[false,true]'
}

@test "the report has no figures and files of what a model was before it failed" {
    rows() {
        layout_mk -s MESH_PATH=meshes HTML_OPTIONS="$1" report >/dev/null 2>&1
        sed -n '/^const rows = /,/^\];$/p' out/report.html | sed '1s/^const rows = //; $s/;$//' >rows.json
    }
    mkdir meshes
    cp "$(sample cube)" meshes/cube.obj
    rows ''
    assert_equal "$(jq '.[0].summary.quads' rows.json)" 384
    rows '--show no-such-layer'
    assert_equal "$(jq -c '.[0] | [.summary.quads, (.files | contains(["step"])), (.files | contains(["html"]))]' rows.json)" '[384,true,false]'
    head -n 300 "$(sample cube)" >meshes/cube.obj
    rows ''
    assert_equal "$(jq -c '.[0] | [.summary, .files]' rows.json)" '[null,[]]'
    cp "$(sample cube)" meshes/cube.obj
    rows ''
    assert_equal "$(jq -c '.[0] | [.summary.quads, (.files | contains(["step", "html"]))]' rows.json)" '[384,true]'
}

@test "a model that is searched in parts has the same bytes" {
    export CUT_OPTIONS='--chi 5'
    layout_mk out/part.enumeration.json
    cp out/part.enumeration.json whole.json
    rm -r out
    layout_mk -j3 PARTS=3 out/part.layout.json
    assert_same_bytes whole.json out/part.enumeration.json
    assert_equal "$(ran PARTS=3 out/part.layout.json)" ''
    assert_equal "$(ran PARTS=3 ENUMERATION_OPTIONS='--best 2' out/part.layout.json)" 'qm-enum qm-enum qm-enum qm-enum qm-merge'
}
