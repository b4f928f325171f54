# shellcheck shell=bash
# The options of every tool with values that make sense, to be sourced. An option that is new must be told here what texts it
# takes; numbers, choices and flags are known from --json-usage.
#
#   settings TOOL   "OPTION=VALUE" or "OPTION", one a line; without --output, and without those that `modes` gives
#   modes TOOL      options that stand beside all others, a mode a line: those that others have no effect without, and
#                   limits of time for what could take for ever

modes() {
    case $1 in
    qm-enum) echo --time-limit=2 ;;
    qm-remesh) echo --quads=100 ;;
    qm-prune) printf '%s\n' '' '--method=optimum --time-limit=0.5' '--method=optimum --front --time-limit=0.5' ;;
    *) echo ;;
    esac
}

# texts TOOL OPTION: values of an option that takes a text, one a line; none leaves the option out.
texts() {
    case "$1 $2" in
    *' --mesh') echo mesh ;; # a link to the right one
    *' --output') ;;         # has values of its own
    *' --reference') echo scan.stl ;; # of samples only
    'qm-features --min-length') printf '%s\n' 0 10% ;;
    'qm-export --analytic-tolerance') printf '%s\n' 0 0.5% ;;
    'qm-features --min-distance') printf '%s\n' 0.01 5% ;;
    'qm-features --min-angle') printf '%s\n' 0.2 40deg ;;
    'qm-enum --cost') printf '%s\n' segments '2*length+dihedral' ;;
    'qm-enum --part') echo 1/2 ;;
    'qm-enum --all' | 'qm-enum --list') echo graphs.jsonl ;;
    'qm-bspline --tolerance') printf '%s\n' 1% 0.05% ;;
    'qm-export --name') echo 'a part' ;;
    'qm-export --date') echo 2020-02-29T12:00:00 ;;
    'qm-shape --noise') echo 0.1% ;;
    'qm-view --show') printf '%s\n' mesh zebra,borders ;;
    'qm-view --compare') echo input ;;
    'qm-view --view') echo 0,0,1 ;;
    'qm-view --up') echo 0,1,0 ;;
    'qm-view --section') echo x:0.5 ;;
    'qm-view --png') ! type -P chromium-headless-shell chromium >/dev/null || echo picture.png ;;
    'qm-view --size') echo 200x100 ;;
    'quadmesh --tolerance') echo 1% ;;
    'quadmesh --max-patches') printf '%s\n' 1 50 ;;
    'quadmesh --quads') ! command -v blender >/dev/null || echo 200 ;;
    'quadmesh --unit') echo inch ;;
    'quadmesh --time-limit') echo 5 ;;
    'quadmesh --keep') echo stages ;;
    'quadmesh --jobs') echo 3 ;;
    *) echo "values: $1 $2: say here which texts to try" >&2 && return 1 ;;
    esac
}

# numbers TOOL OPTION MINIMUM MAXIMUM DEFAULT TYPE: the lowest number, and one on either side of the default
numbers() {
    case "$1 $2" in
    *' --improve') echo 0.5 ;;
    *' --jobs') echo 3 ;;
    'qm-shape --scan') echo 500 ;;
    *) jq -nr --arg low "$3" --arg high "$4" --arg default "$5" '
        ($default | tonumber? // 1) as $middle | ($low | tonumber? // -1e300) as $low | ($high | tonumber? // 1e300) as $high |
        [$low, $middle / 2, 2 * $middle + 1] | map(select(. > -1e300 and . <= $high and . != $middle)) | unique[]' |
        if [[ $6 == integer ]]; then grep -v '\.'; else cat; fi ;;
    esac
}

settings() {
    local name type choices low high default value
    "$1" --json-usage | jq -r --arg modes "$(modes "$1")" '.options[] | select(.group != "General options" or .name == "--jobs" or .name == "--mesh") |
            select(.name as $name | $modes | [scan("--[a-z-]+")] | index($name) | not) | [.name, .type, ([.choices[]?.name] | join(",")), .minimum // "-", .maximum // "-", .default // "-"] | join("|")' |
        while IFS='|' read -r name type choices low high default; do
            case $type in
            flag) echo "$name" ;;
            choice) for value in ${choices//,/ }; do [[ $value == "$default" ]] || echo "$name=$value"; done ;;
            number | integer) numbers "$1" "$name" "$low" "$high" "$default" "$type" | sed "s/^/$name=/" ;;
            text) texts "$1" "$name" | sed "s/^/$name=/" ;;
            *) echo "values: $1 $name: options of type $type are not known here" >&2 && return 1 ;;
            esac
        done
}
