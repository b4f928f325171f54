#!/usr/bin/env bash
# From a mesh to surfaces in one pipe; the same bytes as pipelines/layout.mk leaves in out/part.surfaces.json.
# usage: layout.sh MESH [OPTION]...       options are those of qm-bspline: -o FILE, ...
# Options of the stages come from the same variables as in layout.mk: CUT_OPTIONS='--chi 20' layout.sh part.obj
set -euo pipefail

if (($# == 0)); then
    sed -n '2,4s/^# //p' "$0" >&2
    exit 2
fi

# The tools: in a source tree, installed, or wherever PATH finds them.
here=$(cd "$(dirname "$0")" && pwd)
for bin in "${QM_BIN:-}" "$here/../bin" "$here/../../../bin"; do
    if [[ -n $bin && -x $bin/qm-basecomplex ]]; then
        PATH=$bin:$PATH
        break
    fi
done

# Options are lists of words: $BASECOMPLEX_OPTIONS and the others are split on purpose.
# shellcheck disable=SC2086
{
    qm-basecomplex ${COMMON_OPTIONS:-} ${BASECOMPLEX_OPTIONS:-} "$1" |
        qm-features ${COMMON_OPTIONS:-} ${FEATURES_OPTIONS:-} |
        qm-cut ${COMMON_OPTIONS:-} ${CUT_OPTIONS:-} |
        qm-enum ${COMMON_OPTIONS:-} ${ENUMERATION_OPTIONS:-} |
        qm-merge ${COMMON_OPTIONS:-} ${LAYOUT_OPTIONS:-} |
        qm-prune ${COMMON_OPTIONS:-} ${PRUNED_OPTIONS:-} |
        qm-bspline ${COMMON_OPTIONS:-} ${SURFACES_OPTIONS:-} "${@:2}"
}
