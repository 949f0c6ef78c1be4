#!/usr/bin/env bash
#
# The scripted bring-up: every process of a run. It asks the scenario's mission which ones there are
# and starts them; `./rvd fly` calls it and supervises.
#
#   scripts/bringup.sh SCENARIO RUN_DIR [--headless]
#
# SCENARIO   a ROS parameter file, the same for every process (see scenarios/); its keys
#            `mission`, `operator` and `processes` decide what is started
# RUN_DIR    gets bag/ and logs/; the bag must not exist yet
# --headless leaves out the markers, which only viewers need
#
# Prints `start NAME PID` for each process and `exit NAME CODE` when it has ended; ends when all
# have, or ends them on SIGINT or SIGTERM. Exit code 0 if every process ended well.

set -u
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
case "${1:-}" in
    -h | --help | '') sed -n '3,16s/^# \{0,1\}//p' "$0"; [ -n "${1:-}" ]; exit $(($? * 2)) ;;
esac
if ! [[ ":${AMENT_PREFIX_PATH:-}:" == *rvd_dynamics:* ]]; then      # workspace not sourced yet
    exec "$here/../rvd" shell "$0" "$@"
fi

[ -r "$1" ] || { echo "bringup: cannot read the scenario $1" >&2; exit 2; }
[ $# -ge 2 ] || { echo "bringup: the run folder is missing: bringup.sh SCENARIO RUN_DIR" >&2; exit 2; }
scenario=$(realpath "$1")
mkdir -p "$2/logs" || exit 2
run=$(realpath "$2")
headless=${3:-}

executable() {      # where `ros2 run` looks
    local prefix
    IFS=: read -ra prefixes <<<"$AMENT_PREFIX_PATH"
    for prefix in "${prefixes[@]}"; do
        [ -x "$prefix/lib/$1/$2" ] && { echo "$prefix/lib/$1/$2"; return; }
    done
    echo "bringup: package $1 has no executable $2" >&2
    return 1
}

export RVD_LEAN=${RVD_LEAN:-1} ROS_LOG_DIR=${ROS_LOG_DIR:-$run/logs}
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
declare -A name_of
failed=0
stop() { kill -TERM "${!name_of[@]}" 2>/dev/null; }
trap stop INT TERM

# One line a process: its name, package and executable, and what it is told besides the scenario.
# Whoever has asked the mission already (`./rvd fly`) hands the list over.
list=${RVD_PROCESSES:-$(python3 -m rvd_dynamics.diagram.roster "$scenario" "$run" $headless)} || exit 2
while read -r name package program arguments; do
    executable "$package" "$program" >/dev/null || exit 2          # before anything has started
done <<<"$list"
while read -r name package program arguments; do
    eval "own=($arguments)"
    "$(executable "$package" "$program")" --ros-args --params-file "$scenario" "${own[@]}" >"$run/logs/$name.log" 2>&1 </dev/null &
    name_of[$!]=$name
    echo "start $name $!"
done <<<"$list"

while [ ${#name_of[@]} -gt 0 ]; do
    pid=
    wait -n -p pid
    code=$?
    [ -n "${pid:-}" ] || continue                          # a signal, not an end
    echo "exit ${name_of[$pid]} $code"
    [ "$code" = 0 ] || failed=$code
    unset "name_of[$pid]"
done
exit "$failed"
