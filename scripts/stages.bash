# shellcheck shell=bash
# Running and timing stages of the pipe, for the scripts that print tables; to be sourced.
#
#   run_stage FILE TOOL [OPTION]...   writes FILE; sets stage_seconds, stage_megabytes and, if it fails, stage_message
#   selected_meshes FOLDER REGEX      the mesh files of a folder whose name matches, the smallest first
#   figure FILTER FILE                what jq makes of a document
#
# Set by the caller: stage_limit, the seconds after which a stage counts as failed.

: "${stage_limit:=600}"

# shellcheck disable=SC2034  # what it sets is for the caller
run_stage() {
    local file=$1 tool=$2 log=$1.log status=0
    shift 2
    stage_seconds=- stage_megabytes=0 stage_message=''
    rm -f "$file"
    timeout --kill-after=5 "$stage_limit" "$tool" --quiet --stats "$@" -o "$file" 2>"$log" </dev/null || status=$?
    # 3: the document is there, but misses what was asked for.
    if ((status == 0 || status == 3)); then
        read -r stage_seconds stage_megabytes < <(tail -n 1 "$log" | jq -r '[.seconds, (.peakMegabytes | ceil)] | join(" ")')
        return 0
    fi
    # The message is the last line that is no statistics.
    stage_message=$(grep -v '^{' "$log" | tail -n 1) || true
    # 124 and 137 are timeout's own; a tool that was told to stop may have left any other.
    case $status in
    124 | 137) stage_message="$tool: did not end within $stage_limit s" ;;
    esac
    : "${stage_message:=$tool: ended with status $status}"
    return 1
}

selected_meshes() {
    find "$1" -maxdepth 1 -type f \( -name '*.obj' -o -name '*.off' -o -name '*.ply' \) -printf '%s %p\n' |
        sort -n | cut -d' ' -f2- | while IFS= read -r mesh; do
        if [[ $(basename "$mesh") =~ $2 ]]; then printf '%s\n' "$mesh"; fi
    done
}

figure() { jq -r "$1" "$2"; }
