# Shared by all tests of the tools; every .bats file loads it first.
#
#   captured COMMAND...     runs it and sets what `run --separate-stderr` sets
#   quietly TOOL ...        must succeed with nothing on standard error
#   complains TOOL ...      must exit with status 1 and exactly one line on standard error that begins with "TOOL: "
#   misused TOOL ...        must exit with status 2 and say how to get help
#   stage KIND MODEL        path of a sample document: the pipeline up to KIND on sample mesh MODEL, made once
#   sample MODEL            path of a sample mesh of qm-shape, made once

bats_require_minimum_version 1.5.0
# As `bats_load_library`, without the processes that it starts for each of their files before every test.
IFS=: read -r -a library_folders <<<"$BATS_LIB_PATH"
for folder in "${library_folders[@]}"; do
    for library in "$folder"/bats-{support,assert}/src/*.bash; do
        # shellcheck disable=SC1090  # of Debian's packages
        [[ ! -e $library ]] || source "$library"
    done
done

ROOT=$(cd "$BATS_TEST_DIRNAME/../.." && pwd)
QM_BIN=${QM_BIN:-$ROOT/bin}
export PATH="$QM_BIN:$PATH"
export LC_ALL=C
# A build with sanitizers is to be as quiet as any other where it finds nothing.
export LSAN_OPTIONS=print_suppressions=0
unset COMMON_OPTIONS QUADS QUADS_OPTIONS BASECOMPLEX_OPTIONS FEATURES_OPTIONS CUT_OPTIONS ENUMERATION_OPTIONS LAYOUT_OPTIONS \
    PRUNED_OPTIONS SURFACES_OPTIONS STEP_OPTIONS HTML_OPTIONS PNG_OPTIONS SUMMARY_OPTIONS PARTS STRICT OUT MESH_PATH \
    OPTIONS_FILE MAKEFLAGS MAKELEVEL MFLAGS

# What takes pictures of pages; empty if there is nothing.
browser=''
for program in chromium chromium-headless-shell; do
    ! hash "$program" 2>/dev/null || browser=$program
done

# The real meshes, if this machine has them.
SHARED_MESHES=${QM_SHARED_MESHES:-$ROOT/../shared/meshes}

# Every tool there is, and those that go from document to document in the order of the pipe.
all_tools() { find "$QM_BIN" -maxdepth 1 -name 'qm-*' -type f -printf '%f\n' | sort; }
FILTERS=(qm-features qm-cut qm-enum qm-merge qm-prune qm-bspline)

# The kind that a tool of the pipe writes.
kind_of() {
    case $1 in
    qm-basecomplex) echo basecomplex ;;
    qm-features) echo features ;;
    qm-cut) echo cut ;;
    qm-enum) echo enumeration ;;
    qm-merge | qm-prune) echo layout ;;
    qm-bspline) echo surfaces ;;
    esac
}

# What a tool of the pipe reads, from the sample MODEL.
input_of() {
    case $1 in
    qm-basecomplex) sample "$2" ;;
    qm-features) stage basecomplex "$2" ;;
    qm-cut) stage features "$2" ;;
    qm-enum) stage cut "$2" ;;
    qm-merge) stage enumeration "$2" ;;
    qm-prune) stage layout "$2" ;;
    qm-bspline) stage pruned "$2" ;;
    esac
}

# Every test runs in an empty folder of its own.
setup() { empty_folder; }
empty_folder() { mkdir "$BATS_TEST_TMPDIR/work" && cd "$BATS_TEST_TMPDIR/work" || exit; }

# ------------------------------------------------------------------------------------------------ samples

# Kept for all tests of one run, in a folder that the runner gives; each file appears whole or not at all.
SAMPLES=${QM_SAMPLES:-$BATS_RUN_TMPDIR/samples}

# once FILE COMMAND...: the command's output becomes FILE, unless it is there already.
once() {
    local file=$1 partial
    shift
    [[ -e $file ]] && return
    mkdir -p "$(dirname "$file")"
    partial=$(mktemp "$file.XXXXXX")
    if ! "$@" >"$partial"; then
        rm -f "$partial"
        echo "sample $file: failed: $*" >&2
        return 1
    fi
    mv "$partial" "$file"
}

sample() {
    local file=$SAMPLES/$1.obj
    once "$file" qm-shape "$1" && echo "$file"
}

stage() {
    local kind=$1 model=$2 file
    file=$SAMPLES/$model.$kind.json
    # Without the processes that find the files of all stages before it.
    [[ -e $file ]] || case $kind in
    basecomplex) once "$file" qm-basecomplex --quiet "$(sample "$model")" ;;
    features) once "$file" qm-features --quiet "$(stage basecomplex "$model")" ;;
    cut) once "$file" qm-cut --quiet --chi 20 "$(stage features "$model")" ;;
    enumeration) once "$file" qm-enum --quiet "$(stage cut "$model")" ;;
    layout) once "$file" qm-merge --quiet "$(stage enumeration "$model")" ;;
    pruned) once "$file" qm-prune --quiet "$(stage layout "$model")" ;;
    surfaces) once "$file" qm-bspline --quiet --tolerance 0.5% "$(stage pruned "$model")" ;;
    esac && echo "$file"
}

# ------------------------------------------------------------------------------------------------ verdicts

# For commands, not for functions that end the shell; without the processes that `run` starts beside the command.
captured() {
    local messages=$BATS_TEST_TMPDIR/messages results=$BATS_TEST_TMPDIR/results
    status=0
    "$@" >"$results" 2>"$messages" || status=$?
    mapfile -t lines <"$results"
    mapfile -t stderr_lines <"$messages"
    IFS= read -r -d '' output <"$results" || output=${output%$'\n'}
    IFS= read -r -d '' stderr <"$messages" || stderr=${stderr%$'\n'}
}

quietly() {
    captured "$@"
    assert_success
    assert_equal "$stderr" ''
}

# The status must be 1, and the message one line: "tool: ... what is wrong. what to do".
complains() {
    captured "$@"
    assert_complaint "${1##*/}"
}

assert_complaint() {
    assert_equal "$status" 1
    assert_equal "${#stderr_lines[@]}" 1
    assert_regex "$stderr" "^$1: "
    # No trace of a crash or of the implementation may show.
    refute_regex "$stderr" 'terminate called|std::|json\.exception|Assertion|Sanitizer|\(core dumped\)'
    assert_equal "$output" ''
}

misused() {
    captured "$@"
    assert_equal "$status" 2
    assert_regex "$stderr" "^${1##*/}: .*--help"
    assert_equal "${#stderr_lines[@]}" 1
    assert_equal "$output" ''
}

# field FILTER FILE: what jq makes of a document.
field() { jq -r "$1" "$2"; }

assert_same_bytes() { cmp "$1" "$2" || fail "$1 and $2 differ"; }
