#!/usr/bin/env bash
#
# Set up everything the project needs in .rvd/ of its directory: a Python environment from
# requirements.lock, the built workspace, and env.sh, which loads both.
#
#   scripts/setup.sh [--again]          --again: from nothing, whatever is there
#
# Runs on first use of `./rvd`, and again when the lock file, a message, a package's build files,
# the place of the project or the Python changed. What a stage made counts only once the record
# of its inputs is written, which is its last act: a set-up killed at any point is repaired by
# the next. One set-up at a time: others wait, then find the work done.

set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd -P)
source "$root/scripts/state.sh"

say() { printf 'rvd: %s\n' "$*" >&2; }

# ------------------------------------------------------------------------------- what is needed

# Succeeds for a Python that the wheels exist for; prints the interpreter behind shims and links,
# so that the environment stands on a name which an upgrade of `python3` does not move.
supported_python() {
    "$1" -I - 2> /dev/null << 'PYTHON'
import os, sys
base = os.path.realpath(getattr(sys, '_base_executable', sys.executable))
print(base)
sys.exit(not (3, 10) <= sys.version_info[:2] <= (3, 13) or sys.implementation.name != 'cpython')
PYTHON
}

# Print what the Python $1 lacks as Debian packages, nothing when it is complete.
python_lacks() {
    "$1" -I - << 'PYTHON'
import importlib.util, os, sys, sysconfig
ours = os.path.realpath(sys.executable)
name = 'python3'
if ours.startswith('/usr/bin/') and ours != os.path.realpath('/usr/bin/python3'):
    name = os.path.basename(ours)
if not (importlib.util.find_spec('venv') and importlib.util.find_spec('ensurepip')):
    print(name + '-venv')
if not os.path.exists(os.path.join(sysconfig.get_path('include'), 'Python.h')):
    print(name + '-dev')
PYTHON
}

# Set `python` to the interpreter to build on, and `lacks` to the packages that complete it: the
# first complete one of the candidates, else the first that is supported, else nothing.
find_python() {
    local candidate base gaps candidates=(python3 python3.12 python3.11 python3.13 python3.10)
    [[ $ros != wheels ]] && candidates=(/usr/bin/python3 python3)       # the one ROS is built for
    [[ -n ${RVD_PYTHON:-} ]] && candidates=("$RVD_PYTHON")
    python='' lacks=''
    for candidate in "${candidates[@]}"; do
        base=$(supported_python "$candidate") || continue
        gaps=$(python_lacks "$candidate" | tr '\n' ' ')
        [[ -n $python && -n $gaps ]] || python=$base lacks=$gaps
        [[ -n $gaps ]] || break
    done
}

check_machine() {
    [[ $(uname -s) == Linux ]] || die "Linux is needed, this is $(uname -s): use docker/compose.yaml"
    if [[ $ros == wheels && $(uname -m) != x86_64 ]]; then
        die "without ROS 2 Jazzy installed only x86_64 is supported, this is $(uname -m):" \
            'install ros-jazzy-ros-base, or use docker/compose.yaml'
    fi
    [[ $root != *[[:space:]:\"\']* ]] ||
        die "ROS build tools need a path without spaces, quotes and colons, not '$root'"
    [[ -w $root ]] || die "cannot write to $root"

    find_python
    local tool missing=''
    for tool in cmake g++ make; do
        command -v "$tool" > /dev/null || missing+=" $tool"
    done
    if [[ -z $python ]]; then
        [[ -n ${RVD_PYTHON:-} ]] && die "RVD_PYTHON=$RVD_PYTHON is not a Python 3.10 to 3.13"
        command -v python3 > /dev/null &&
            die "Python 3.10 to 3.13 is needed, python3 is $(python3 -V 2>&1 | cut -d' ' -f2):" \
                "install one, or ROS 2 Jazzy; RVD_PYTHON=/path/to/python chooses"
        missing+=' python3 python3-venv python3-dev'
    else
        missing+=${lacks:+ ${lacks% }}
    fi
    [[ -z $missing ]] || die "missing on this machine: sudo apt-get install$missing"
    [[ $ros == wheels ]] || (load_underlay && "$python" -c 'import rclpy') 2> /dev/null ||
        die "$python cannot import rclpy of ROS 2 ($ros): RVD_PYTHON=/path/to/python names its" \
            'Python, RVD_ROS_PREFIX=none does without this ROS'
}

# ---------------------------------------------------------------------------- progress by stage

# stage NAME LABEL COMMAND...: run it with its output in .rvd/log/NAME.log; show the time it takes,
# on a terminal with the last line of the log. Ends the set-up with the log's end when it fails.
stage() {
    local name=$1 label=$2 log=$state/log/$1.log start=$SECONDS reporter status
    shift 2
    mkdir -p "$state/log"
    report_progress "$label" "$log" "$start" & reporter=$!
    set +e                                      # or the subshell would not stop at an error
    (set -e; "$@") > "$log" 2>&1 < /dev/null
    status=$?
    set -e
    kill "$reporter" 2> /dev/null || true
    wait "$reporter" 2> /dev/null || true
    [[ -t 2 ]] && printf '\r\e[K' >&2
    if ((status)); then
        tail -n 15 "$log" >&2
        die "set-up failed while $label; the whole log is .rvd/log/$name.log, try again: ./rvd setup"
    fi
    say "$label: $((SECONDS - start)) s"
}

report_progress() {
    local label=$1 log=$2 start=$3 shown=$SECONDS line
    [[ -t 2 ]] || say "$label ..."
    while sleep 0.5 && kill -0 $$ 2> /dev/null; do
        if [[ -t 2 ]]; then
            line=$(tail -n 1 "$log" 2> /dev/null | tr -d '\r' | cut -c1-40) || line=''
            printf '\r\e[Krvd: %s ... %d s  %s' "$label" $((SECONDS - start)) "$line" >&2
        elif ((SECONDS - shown >= 15)); then
            shown=$SECONDS
            say "$label ... $((SECONDS - start)) s"
        fi
    done
}

# --------------------------------------------------------------------------- Python environment

pip() {
    # Settings of the machine choose the index; none may change what is installed, or where.
    env -u PIP_TARGET -u PIP_PREFIX -u PIP_ROOT -u PIP_REQUIREMENT -u PIP_EDITABLE -u PIP_NO_BINARY \
        -u PIP_ONLY_BINARY PIP_CONSTRAINT=/dev/null PIP_USER=0 PIP_DISABLE_PIP_VERSION_CHECK=1 \
        "$venv/bin/python" -m pip "$@"
}

create_environment() {
    local options=()
    rm -f "$venv/complete"                      # the rest takes longer, and may be killed
    rm -rf "$venv" "$state"/{build,install,env.sh}
    [[ $ros != wheels ]] && options=(--system-site-packages)
    "$python" -m venv "${options[@]}" "$venv"
    printf '%s\n' "${RVD_PYTHON:-}" "$python" > "$state/python"
}

# install TOOL FILE: the entries of a lock file, exactly these.
install() {
    local tool=("$1")
    [[ $1 == uv ]] && tool=(env -u UV_CONSTRAINT -u UV_OVERRIDE "$venv/bin/python" -m uv pip)
    "${tool[@]}" install --no-deps --no-build-isolation --require-hashes -r "$2"
}

install_packages() {
    local lock=$state/install.lock tools=$state/tools.lock
    if [[ $ros == wheels ]]; then
        cp "$root/requirements.lock" "$lock"
    else
        (load_underlay && "$python" "$root/scripts/lock_beside_ros.py" "$root/requirements.lock") > "$lock"
    fi
    # First what installs the rest: uv, and setuptools for the one entry that has no wheel.
    awk '/^[A-Za-z]/ { tool = /^(uv|setuptools)==/ } tool' "$lock" > "$tools"
    install pip "$tools"
    # uv takes a third of pip's time, but knows nothing of an index that is set for pip.
    if pip config list | grep -E '\.(index-url|no-index|proxy)=' || ! install uv "$lock"; then
        install pip "$lock"
    fi
    if [[ $ros == wheels ]]; then
        "$venv/bin/python" "$root/scripts/repair_wheels.py"
    fi
}

# ------------------------------------------------------------------------------------ workspace

# The environment below the workspace: ROS and the tools, and no settings of the user for colcon.
load_underlay() {
    export PATH=$venv/bin:$PATH COLCON_HOME=$state/colcon
    if [[ $ros == wheels ]]; then
        export AMENT_PREFIX_PATH=$venv CMAKE_PREFIX_PATH=$venv
    elif [[ $ros != sourced ]]; then
        set +u
        source "$ros/setup.bash"
        set -u
        PATH=$venv/bin:$PATH
    fi
}

build_workspace() {
    load_underlay
    cd "$root/ros2_ws"
    python -m colcon --log-base "$state/log/colcon" build --symlink-install --base-paths src \
        --build-base "$state/build" --install-base "$state/install" \
        --event-handlers console_direct+ --cmake-args -DBUILD_TESTING=OFF
}

# --------------------------------------------------------------------------------- environment

# Print NAME=value, each ended by a NUL, as loading ROS and the workspace sets them from nothing.
loaded_variables() {
    env -i HOME="$HOME" PATH=/usr/bin:/bin bash --noprofile --norc -c '
        [[ $1 == wheels ]] && export AMENT_PREFIX_PATH=$2/venv CMAKE_PREFIX_PATH=$2/venv
        [[ $1 == /* ]] && source "$1/setup.bash"
        source "$2/install/local_setup.bash"
        exec env -0' bash "$ros" "$state" 2> /dev/null
}

# Write env.sh: what loading ROS and the workspace does, as assignments. Loading them anew takes
# the time of several Python starts at every call, this takes a millisecond.
write_environment() {
    local name value
    local -A lists=([PATH]=$venv/bin)
    {
        echo '# Made by scripts/setup.sh; `source` it in bash to have ROS and the workspace loaded.'
        declare -f rvd_prepend
        while IFS='=' read -r -d '' name value; do
            case $name in
                HOME | PWD | OLDPWD | SHLVL | _) ;;
                PATH)
                    value=:$value
                    lists[PATH]+=${value%:/usr/bin:/bin} ;;
                *PATH) lists[$name]=${value%:} ;;
                *) echo "export $name=${value@Q}" ;;
            esac
        done < <(loaded_variables)
        if [[ $ros == wheels ]]; then
            # What the wheels do for themselves by starting every Python twice (45 ms each).
            for value in "$venv/lib" "$venv"/lib/python3*/site-packages/ros_*.libs; do
                lists[LD_LIBRARY_PATH]+=:$value
            done
            echo 'export _ROS_WHEELS_BOOTSTRAP_COMPLETE=1'
            echo 'unset AMENT_PREFIX_PATH CMAKE_PREFIX_PATH COLCON_PREFIX_PATH PYTHONPATH'
        else
            echo 'export PYTHONNOUSERSITE=1     # a numpy of the user would hide the one of ROS'
        fi
        for name in "${!lists[@]}"; do
            echo "rvd_prepend $name ${lists[$name]@Q}"
        done
        echo 'unset PYTHONHOME PYTHONDONTWRITEBYTECODE    # without bytecode a start takes seconds'
        echo "export RVD_ROOT=${root@Q} VIRTUAL_ENV=${venv@Q}"
        echo 'export ROS_AUTOMATIC_DISCOVERY_RANGE="${ROS_AUTOMATIC_DISCOVERY_RANGE:-LOCALHOST}"'
        echo '# Many small processes: threads for their linear algebra only get in the way.'
        echo 'export OPENBLAS_NUM_THREADS="${OPENBLAS_NUM_THREADS:-1}"'
        echo 'export OMP_NUM_THREADS="${OMP_NUM_THREADS:-1}"'
    } > "$state/env.new"
    mv "$state/env.new" "$state/env.sh"
}

# rvd_prepend VARIABLE ENTRIES: put in front those not there yet; entries of any .rvd go first.
rvd_prepend() {
    local entry old=() new=() kept='' front=''
    IFS=: read -ra old <<< "${!1:-}"
    IFS=: read -ra new <<< "$2"
    for entry in "${old[@]}"; do
        [[ -n $entry && $entry != */.rvd/* ]] && kept+=:$entry
    done
    for entry in "${new[@]}"; do
        [[ -n $entry && $kept: != *:"$entry":* ]] && front+=:$entry
    done
    kept=$front$kept
    export "$1=${kept#:}"
}

# Import what the nodes import: proves the set-up, and leaves the bytecode for the first run.
check_environment() {
    source "$state/env.sh"
    python - << 'PYTHON'
import filterpy.kalman
import matplotlib.pyplot
import mcap.writer
import numpy
import rclpy
import rosbags.rosbag2
import scipy.linalg
import yaml

import rvd_campaign
import rvd_dynamics
import rvd_groundstation
from rvd_interfaces.msg import RelativeState

message = RelativeState()
message.position.x = -30.0
print('numpy', numpy.__version__, 'rclpy', rclpy.__file__)
PYTHON
}

# ------------------------------------------------------------------------------------------ main

set_up() {
    local started=$SECONDS why packages build before
    check_machine
    rm -f "$state/done"
    packages=$(venv_inputs) build=$(build_inputs)

    before=$(recorded "$venv/complete") || true
    if [[ $before != "$packages" ]] || ! same_python; then
        why='first use'
        [[ -d $venv ]] && why='the last set-up was interrupted'
        [[ -n $before ]] && why='the lock file, ROS, the Python or the place of the project changed'
        [[ -n $again ]] && why='asked for'
        say "setting up in $state ($why): a minute or two, 1 GB"
        stage environment "making the environment ($("$python" -V 2>&1))" create_environment
        stage packages "installing $(grep -c '^[A-Za-z]' "$root/requirements.lock") pinned packages" \
            install_packages
        echo "$packages" > "$venv/complete"
    fi

    before=$(recorded "$state/build/complete") || true
    if [[ $before != "$build" ]]; then
        # What a removed file left behind, or an interrupted build, is not for colcon to mend.
        [[ -n $before && -z $(gone_from "$before" "$build") ]] || rm -rf "$state"/{build,install}
        rm -f "$state/build/complete"
        stage build 'building the workspace' build_workspace
        write_environment
        stage check 'checking that all of it loads' check_environment
        echo "$build" > "$state/build/complete"
    fi
    [[ -r $state/env.sh ]] || write_environment
    printf '%s\n' "$packages" "$build" > "$state/done.new"
    mv "$state/done.new" "$state/done"
    say "ready after $((SECONDS - started)) s"
}

gone_from() {                                   # gone_from BEFORE NOW: files that are no more
    comm -23 <(cut -c67- <<< "$1" | sort) <(cut -c67- <<< "$2" | sort)
}

case "${1:-}" in
    '') again='' ;;
    --again) again=yes ;;
    *) die "setup takes --again or nothing, not '$1'" ;;
esac
mkdir -p "$state" 2> /dev/null || die "cannot write to $root"
exec 9> "$state/lock"                           # held by all children too, if this one is killed
if ! flock --nonblock 9; then
    say 'another set-up is at work here: waiting for it'
    flock 9
fi
trap 'say "interrupted; the next call repairs it"; exit 130' INT
find_ros
unset PYTHONHOME _ROS_WHEELS_BOOTSTRAP_COMPLETE
if [[ $ros == wheels ]]; then                   # whatever else this shell has loaded
    unset PYTHONPATH AMENT_PREFIX_PATH CMAKE_PREFIX_PATH COLCON_PREFIX_PATH
fi
[[ -n $again ]] && rm -f "$state/done" "$venv/complete"
if up_to_date; then
    say "up to date: $state"
    exit 0
fi
set_up
