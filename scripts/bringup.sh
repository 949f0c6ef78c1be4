#!/usr/bin/env bash
#
# The scripted bring-up: every node of the ground loop, each as its own process.
# This is the only list of nodes; `./rvd fly` calls it and supervises.
#
#   scripts/bringup.sh SCENARIO RUN_DIR [--headless]
#
# SCENARIO   a ROS parameter file, the same for every node (see scenarios/)
# RUN_DIR    gets bag/ and logs/; the bag must not exist yet
# --headless leaves out the markers, which only viewers need
# The pilot is the scenario's `operator`: model, replay, joy, console or none.
#
# Prints `start NAME PID` for each node and `exit NAME CODE` when it has ended; ends when all
# have, or ends them on SIGINT or SIGTERM. Exit code 0 if every node ended well.

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
operator=$(sed -n 's/^ *operator: *\([a-z]*\).*/\1/p' "$scenario" | head -n 1)
operator=${operator:-model}

graph() {
    #     name                 package            executable           its own parameters

    # space segment
    start spacecraft_dynamics  rvd_dynamics       spacecraft_dynamics  scenario_file:="$scenario"
    start relative_sensor      rvd_dynamics       relative_sensor
    start onboard_guard        rvd_dynamics       onboard_guard

    # the link: one executable, run twice
    start link_back            rvd_dynamics       link_emulator
    start link_forward         rvd_dynamics       link_emulator

    # ground segment
    start state_predictor      rvd_groundstation  state_predictor
    start auto_controller      rvd_groundstation  auto_controller
    start command_blender      rvd_groundstation  command_blender

    # the pilot
    case $operator in
        model)  start operator_model   rvd_groundstation  operator_model ;;
        replay) start joystick_replay  rvd_groundstation  joystick_replay ;;
        joy)    start joy_node         joy                joy_node ;;
        console) start console         rvd_groundstation  console ;;
    esac

    # who watches
    start mission_monitor      rvd_dynamics       mission_monitor
    start bag_recorder         rvd_dynamics       bag_recorder         bag_dir:="$run/bag"
    [ "$headless" = --headless ] || start markers rvd_dynamics markers
}

# First pass: who takes part, since each node waits until its neighbours are there.
names=()
start() { names+=("$1"); }
graph
list="[$(IFS=,; echo "${names[*]}")]"

executable() {      # where `ros2 run` looks
    local prefix
    IFS=: read -ra prefixes <<<"$AMENT_PREFIX_PATH"
    for prefix in "${prefixes[@]}"; do
        [ -x "$prefix/lib/$1/$2" ] && { echo "$prefix/lib/$1/$2"; return; }
    done
    echo "bringup: package $1 has no executable $2${3:+; $3}" >&2
    return 1
}

# Second pass: start them.
export RVD_LEAN=${RVD_LEAN:-1} ROS_LOG_DIR=${ROS_LOG_DIR:-$run/logs}
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
declare -A name_of
failed=0
start() {
    local name=$1 exe own=()
    exe=$(executable "$2" "$3") || { failed=2; return; }
    for parameter in "${@:4}"; do own+=(-p "$parameter"); done
    "$exe" --ros-args -r __node:="$name" --params-file "$scenario" \
        -p nodes:="$list" "${own[@]}" \
        >"$run/logs/$name.log" 2>&1 </dev/null &
    name_of[$!]=$name
    echo "start $name $!"
}
stop() { kill -TERM "${!name_of[@]}" 2>/dev/null; }
trap stop INT TERM
graph
[ "$failed" = 0 ] || stop

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
