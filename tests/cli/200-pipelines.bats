# pipelines/layout.mk and layout.sh: the same bytes, and a cache that runs what must run and nothing else.

load helpers.bash

setup() {
    empty_folder
    cp "$(sample block)" part.obj
}

layout_mk() { make --no-print-directory -f "$ROOT/pipelines/layout.mk" "$@"; }
layout_sh() { "$ROOT/pipelines/layout.sh" "$@"; }

# The tools that a run of layout.mk started, in order, on one line.
ran() { layout_mk "$@" | sed -nE 's/^(qm-[a-z]+) .*/\1/p' | tr '\n' ' ' | sed 's/ $//'; }

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

@test "a tolerance that is missed is told and kept, unless STRICT is set" {
    run --separate-stderr layout_mk SURFACES_OPTIONS='--tolerance 1e-12' out/part.surfaces.json
    assert_success
    assert_regex "$stderr" 'tolerance is missed'
    run layout_mk STRICT=1 SURFACES_OPTIONS='--tolerance 1e-13' out/part.surfaces.json
    assert_failure
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
