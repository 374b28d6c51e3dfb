# shellcheck shell=bash
# Sourced by the other scripts. quietly COMMAND…: runs it silently; if it fails, shows the end of what it said.
quietly() {
    local log status=0
    log=$(mktemp)
    "$@" >"$log" 2>&1 || status=$?
    if [ $status != 0 ]; then
        echo "failed: $*" >&2
        tail -n 60 "$log" >&2
    fi
    rm -f "$log"
    return $status
}
