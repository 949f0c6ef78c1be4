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
# have. On SIGINT, SIGTERM or SIGHUP, or when one has failed, it ends them: the recorder last, so
# that the bag holds what the others said at the end, and by SIGKILL what does not go; on SIGUSR1,
# which comes when `fly` was killed, within 4 seconds. It tells of a signal: `told SIGNAL`. Nodes
# do not outlive it, however it ends (lifeline.py). Exit code 0 if every process ended well.

[ -n "${BASH_VERSION:-}" ] || exec bash "$0" "$@"        # as `sh bringup.sh`
set +o posix
set -u
unset CDPATH                                    # or `cd` prints, and goes elsewhere
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
case "${1:-}" in
    -h | --help | '') sed -n '3,19s/^# \{0,1\}//p' "$0"; [ -n "${1:-}" ]; exit $(($? * 2)) ;;
esac
if ! [[ ":${AMENT_PREFIX_PATH:-}:" == *rvd_dynamics:* ]]; then      # workspace not sourced yet
    exec "$here/../rvd" shell "$0" "$@"
fi

source "$here/network.sh"               # heard on this machine alone, unless somebody asks for more
[ -r "$1" ] || { echo "bringup: cannot read scenario $1" >&2; exit 2; }
[ $# -ge 2 ] || {
    echo "bringup: the run folder is missing: bringup.sh SCENARIO RUN_DIR" >&2
    exit 2
}
scenario=$(realpath -- "$1"; echo .)
scenario=${scenario%??}                 # and not the end of a name that is a line feed
mkdir -p -- "$2/logs" || exit 2
run=$(realpath -- "$2"; echo .)
run=${run%??}
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
export PYTHONSAFEPATH=1                 # no file of the working folder takes a module's place
export RVD_PARENT=$$                    # the nodes end when this shell has gone
STOP_S=8 BAG_S=5                    # what the others, and then the recorder, get to end in order
declare -A name_of
failed=0 stage=run recorder='' timer=''

say() { echo "$@" 2>/dev/null; }        # that nobody reads it is no reason to stop flying
trap '' PIPE
others() { jobs -p | grep -vxF -e "$recorder" -e "$timer"; }
tell() {                                # tell SIGNAL PID...; a stopped process cannot end itself
    [ $# -gt 1 ] && kill -s "$@" 2>/dev/null && kill -s CONT "${@:2}" 2>/dev/null
}
end_within() {                          # end_within SECONDS PID...
    local seconds=$1
    shift
    tell TERM "$@"
    [ -z "$timer" ] || kill "$timer" 2>/dev/null
    sleep "$seconds" &
    timer=$!
}
stop() {
    [ $stage = run ] || return
    stage=others
    end_within $STOP_S $(others)
}
told() {                                # told SIGNAL
    [ $stage != run ] || say "told $1"
    stop
}
hurry() {                               # nobody waits for this run any more
    STOP_S=2.5 BAG_S=1.5
    case $stage in
        run) told SIGUSR1 ;;
        others) end_within $STOP_S $(others) ;;
        recorder) end_within $BAG_S $recorder ;;
    esac
}
trap 'told SIGINT' INT
trap 'told SIGTERM' TERM
trap 'told SIGHUP' HUP
trap hurry USR1
trap 'kill -KILL $(jobs -p) 2>/dev/null' EXIT

# One line a process, the recorder's last: its name, package and executable, and what it is told
# besides the scenario. Whoever has asked the mission already (`./rvd fly`) hands the list over.
list=${RVD_PROCESSES:-$(python3 -m rvd_dynamics.diagram.roster "$scenario" "$run" $headless)} ||
    exit 2
while read -r name package program arguments; do
    executable "$package" "$program" >/dev/null || exit 2          # before anything has started
done <<<"$list"
while read -r name package program arguments; do
    [ $stage = run ] || break
    eval "own=($arguments)"
    "$(executable "$package" "$program")" --ros-args --params-file "$scenario" "${own[@]}" \
        >"$run/logs/$name.log" 2>&1 </dev/null &
    name_of[$!]=$name
    say "start $name $!"
done <<<"$list"
[ $stage = run ] && recorder=$!

while [ ${#name_of[@]} -gt 0 ]; do
    if [ $stage = others ] && [ -z "$(others)" ]; then
        stage=recorder
        end_within $BAG_S $recorder
    fi
    wait -n -p pid
    code=$?
    if [ -z "${pid:-}" ]; then                                     # a signal, not an end
        [ -n "$(jobs -p)" ] || break
    elif [ "$pid" = "$timer" ]; then
        timer=
        if [ $stage = others ]; then tell KILL $(others); else tell KILL $recorder; fi
    elif [ -n "${name_of[$pid]:-}" ]; then
        say "exit ${name_of[$pid]} $code"
        unset "name_of[$pid]"
        [ "$code" = 0 ] || { [ "$failed" != 0 ] || failed=$code; stop; }   # the run cannot go on
    fi
done
exit "$failed"
