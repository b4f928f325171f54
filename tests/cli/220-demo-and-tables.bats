# make demo and make bench-dev: what they print and leave behind.

load helpers.bash

@test "the demo lays out its parts, prints a table, and says where the files are" {
    DEMO_SHAPES='cube plate' run --separate-stderr "$ROOT/scripts/demo" "$QM_BIN" "$PWD/out"
    assert_success
    assert_line --regexp '^part +quads'
    assert_line --regexp '^cube +384 +8 +0 +6 +-[0-9.]+ +-[0-9.]+ +0\.[0-9]+$'
    assert_line --regexp '^plate +1152 +4 '
    for line in "${lines[@]}"; do [[ $line == */* ]] || assert [ "${#line}" -le 80 ]; done
    assert_line --partial "$PWD/out/cube.step"
    assert [ -s out/cube.step ]
    for part in cube plate; do
        quietly qm-check "out/$part.surfaces.json"
    done
    # Run again it makes nothing anew, and prints the same.
    first=$output
    DEMO_SHAPES='cube plate' run --separate-stderr "$ROOT/scripts/demo" "$QM_BIN" "$PWD/out"
    assert_success
    refute_regex "$stderr" 'qm-basecomplex'
    assert [ -n "$first" ]
}

bench() { QM_SHARED_MESHES=$PWD OUT=$PWD/out run --separate-stderr "$ROOT/scripts/bench-dev" "$@"; }

@test "the table has a line for every mesh and chi, and the verdict of qm-check" {
    mkdir dev
    cp "$(sample cube)" "$(sample block)" "$(sample plate)" dev
    bench '' pipeline
    assert_success
    assert_equal "$(grep -c ' accepted$' <<<"$output")" 6
    assert_line --regexp '^cube.obj +384 +386 +8 +0 +20 +1 '
    assert_line --regexp '^block.obj .* 40 .*accepted$'
    CHI=30 bench '^block' pipeline
    assert_success
    assert_equal "$(grep -c '\.obj ' <<<"$output")" 1
    QUADS=400 bench '' pipeline
    refute_line --partial block.obj
    assert_line --partial cube.obj
}

@test "a stage that fails is a line of the table with its message, and the table goes on" {
    mkdir dev
    cp "$(sample cube)" dev/good.obj
    { cat "$(sample cube)"; echo 'f 1 2 3'; } >dev/bad.obj
    CHI=20 bench '' pipeline
    assert_failure
    assert_line --regexp '^bad.obj .*FAILED qm-basecomplex: .*it has 3 sides'
    assert_line --regexp '^good.obj .* accepted$'
    CHI=20 ENUMERATION_OPTIONS='--method nonsense' bench good pipeline
    assert_failure
    assert_line --regexp '^good.obj .*FAILED qm-enum: '
}

@test "a stage that does not end is stopped" {
    mkdir dev
    cp "$(sample block)" dev/block.obj
    CHI=1000 LIMIT=1 ENUMERATION_OPTIONS='--method naive' bench '' pipeline
    assert_failure
    assert_line --regexp '^block.obj .*FAILED qm-enum: '
}

@test "a folder that is not there" {
    bench '' pipeline
    assert_equal "$status" 1
    assert_regex "$stderr" 'QM_SHARED_MESHES'
}
