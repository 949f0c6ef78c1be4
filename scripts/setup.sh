#!/usr/bin/env bash
#
# Set up everything that the project needs in its own .rvd/: a Python environment from
# requirements.lock, the built workspace, and env.sh, which loads both.
#
#   scripts/setup.sh [--again]          --again: from nothing, whatever is there
#   scripts/setup.sh --basilisk PYTHON  only the environment of Basilisk, .rvd/basilisk/, by a
#                                       Python that has uv: tests and benchmark call this
#
# Runs on first use of `./rvd`, and again when the lock file, a message, a package's build files,
# the location of the project or the Python has changed. A stage counts as done only once the
# record of its inputs is written, which is its last act: a set-up killed at any point is repaired
# by the next. Only one set-up runs at a time: others wait, then find the work done.

[ -n "${BASH_VERSION:-}" ] || exec bash "$0" "$@"        # as `sh setup.sh`
set +o posix
set -euo pipefail
unset CDPATH                                    # or `cd` prints, and goes elsewhere
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd -P)
source "$root/scripts/state.sh"

say() { printf 'rvd: %s\n' "$*" >&2; }

# ------------------------------------------------------------------------------- what is needed

# Succeeds for a Python for which there are wheels; prints the interpreter behind shims and links,
# so that the environment is built on a name that an upgrade of `python3` does not move.
supported_python() {
    "$1" -I - 2> /dev/null << 'PYTHON'
import os, sys
base = os.path.realpath(getattr(sys, '_base_executable', sys.executable))
print(base)
sys.exit(not (3, 10) <= sys.version_info[:2] <= (3, 13) or sys.implementation.name != 'cpython')
PYTHON
}

# Print what the Python $1 lacks, as Debian packages; nothing if it is complete.
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

# Set `python` to the interpreter to build on, and `lacks` to the packages that would complete it:
# the first complete candidate, else the first that is supported, else nothing.
find_python() {
    local candidate base gaps candidates=(python3 python3.12 python3.11 python3.13 python3.10)
    [[ $ros != wheels ]] && candidates=(/usr/bin/python3 python3)   # the one that ROS is built for
    [[ -n $installed ]] && candidates+=(/usr/bin/python3)
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
    [[ $(uname -s) == Linux ]] ||
        die "Linux is needed, this is $(uname -s): use docker/compose.yaml"
    if [[ $ros == wheels && $(uname -m) != x86_64 ]]; then
        die "without ROS 2 Jazzy installed only x86_64 is supported, this is $(uname -m):" \
            'install ros-jazzy-ros-base, or use docker/compose.yaml'
    fi
    [[ $root != *[[:space:]:\"\']* ]] ||
        die "ROS build tools need a path without spaces, quotes and colons, not '$root'"
    [[ -w $root ]] || die "cannot write to $root"

    local missing installed=''
    find_missing
    if [[ -n $missing && $(id -u 2> /dev/null) == 0 ]] && command -v apt-get > /dev/null; then
        stage system "installing$missing on this machine, with apt-get" install_from_the_system
        installed=yes
        find_missing
    fi
    [[ -z $missing ]] || die "missing on this machine: sudo apt-get install$missing"
    [[ $ros == wheels ]] || (load_underlay && "$python" -c 'import rclpy') 2> /dev/null ||
        die "$python cannot import rclpy of ROS 2 ($ros): RVD_PYTHON=/path/to/python names its" \
            'Python, RVD_ROS_PREFIX=none does without this ROS'
}

# Find a Python, and set `missing` to what the machine lacks, as Debian packages. CMake comes with
# the packages of the lock.
find_missing() {
    find_python
    local tool
    missing=''
    for tool in g++ make; do
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
}

# Install $missing. The lists of a fresh container are empty, those of an old machine name packages
# that are gone: then they are fetched first.
install_from_the_system() {
    local packages
    read -ra packages <<< "$missing"
    export DEBIAN_FRONTEND=noninteractive
    apt-get install -y --no-install-recommends "${packages[@]}" || {
        apt-get update
        apt-get install -y --no-install-recommends "${packages[@]}"
    }
}

# ---------------------------------------------------------------------------- progress by stage

# stage NAME LABEL COMMAND...: run the command with its output in .rvd/log/NAME.log and show the
# time it takes, on a terminal with the last line of the log. If it fails, show the end of the log
# and exit.
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
        die "set-up failed while $label; the whole log is .rvd/log/$name.log; to try again:" \
            "${again_by:-./rvd setup}"
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
    # The machine's settings may choose the index, but not what is installed, or where.
    env -u PIP_TARGET -u PIP_PREFIX -u PIP_ROOT -u PIP_REQUIREMENT -u PIP_EDITABLE \
        -u PIP_NO_BINARY -u PIP_ONLY_BINARY \
        PIP_CONSTRAINT=/dev/null PIP_USER=0 PIP_DISABLE_PIP_VERSION_CHECK=1 \
        "$venv/bin/python" -m pip "$@"
}

create_environment() {
    local options=()
    rm -f "$venv/complete"                      # the rest takes longer and may be killed
    rm -rf "$venv" "$state"/{build,install,env.sh}
    [[ $ros != wheels ]] && options=(--system-site-packages)
    "$python" -m venv "${options[@]}" "$venv"
    printf '%s\n' "${RVD_PYTHON:-}" "$python" > "$state/python"
}

# install TOOL FILE: install exactly the entries of a lock file into $venv; `uv`: that of $venv, or
# of the Python $uv.
install() {
    local tool=("$1") into=()
    [[ $1 == uv ]] && into=(--python "$venv/bin/python") &&
        tool=(env -u UV_CONSTRAINT -u UV_OVERRIDE "${uv:-$venv/bin/python}" -m uv pip)
    "${tool[@]}" install "${into[@]}" --no-deps --no-build-isolation --require-hashes -r "$2"
}

install_packages() {
    local lock=$state/install.lock tools=$state/tools.lock
    if [[ $ros == wheels ]]; then
        cp "$root/requirements.lock" "$lock"
    else
        (load_underlay &&
            "$python" "$root/scripts/lock_beside_ros.py" "$root/requirements.lock") > "$lock"
    fi
    # First come the tools that install the rest: uv, and setuptools for the one entry without a
    # wheel.
    awk '/^[A-Za-z]/ { tool = /^(uv|setuptools)==/ } tool' "$lock" > "$tools"
    install pip "$tools"
    # uv takes a third of pip's time, but does not know an index that is configured for pip.
    if pip config list | grep -E '\.(index-url|no-index|proxy)=' || ! install uv "$lock"; then
        install pip "$lock"
    fi
    if [[ $ros == wheels ]]; then
        "$venv/bin/python" "$root/scripts/repair_wheels.py"
    fi
}

# ------------------------------------------------------------------------------------- Basilisk

# Basilisk asks for older numpy, matplotlib and pillow than the project has.
set_up_basilisk() {
    local uv=$1 venv=$state/basilisk lock=$root/requirements-basilisk.lock inputs
    local again_by='the same command'
    inputs=$("$uv" -c 'import os, sys; print(os.path.realpath(sys._base_executable))')
    inputs+=$'\n'$(sha256sum "$lock")
    [[ $(recorded "$venv/complete") == "$inputs" ]] && return
    stage basilisk 'setting up Basilisk to compare with (470 MB)' install_basilisk
    echo "$inputs" > "$venv/complete"
}

install_basilisk() {
    rm -rf "$venv"
    "$uv" -m venv --without-pip "$venv"
    if "$uv" -m pip config list | grep -E '\.(index-url|no-index|proxy)=' ||
        ! install uv "$lock"; then
        "$venv/bin/python" -m ensurepip
        install pip "$lock"
    fi
}

# ------------------------------------------------------------------------------------ workspace

# The environment below the workspace: ROS and the tools, without the user's settings for colcon.
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
    local sources
    find_sources
    load_underlay
    cd "$root/ros2_ws"
    python -m colcon --log-base "$state/log/colcon" build --symlink-install \
        --base-paths "${sources[@]}" --build-base "$state/build" --install-base "$state/install" \
        --event-handlers console_direct+ --cmake-args -DBUILD_TESTING=OFF
}

# --------------------------------------------------------------------------------- environment

# Print the variables that loading ROS and the workspace sets from nothing: NAME=value,
# NUL-terminated.
loaded_variables() {
    env -i HOME="${HOME:-/}" PATH=/usr/bin:/bin bash --noprofile --norc -c '
        [[ $1 == wheels ]] && export AMENT_PREFIX_PATH=$2/venv CMAKE_PREFIX_PATH=$2/venv
        [[ $1 == /* ]] && source "$1/setup.bash"
        source "$2/install/local_setup.bash"
        exec env -0' bash "$ros" "$state" 2> /dev/null
}

# Write env.sh: the effect of loading ROS and the workspace, as assignments. Loading them takes as
# long as several Python starts at every call; env.sh takes a millisecond.
write_environment() {
    local name value
    local -A lists=([PATH]=$venv/bin)
    loaded_variables > "$state/variables" || die "the workspace in $state/install does not load"
    {
        echo '# Made by scripts/setup.sh; `source` it in bash to load ROS and the workspace.'
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
        done < "$state/variables"
        if [[ $ros == wheels ]]; then
            # What the wheels would do for themselves by starting every Python twice (45 ms each).
            for value in "$venv/lib" "$venv"/lib/python3*/site-packages/ros_*.libs; do
                lists[LD_LIBRARY_PATH]+=:$value
            done
            echo 'export _ROS_WHEELS_BOOTSTRAP_COMPLETE=1'
            echo 'unset AMENT_PREFIX_PATH CMAKE_PREFIX_PATH COLCON_PREFIX_PATH PYTHONPATH'
        else
            echo 'export PYTHONNOUSERSITE=1     # a numpy of the user would hide that of ROS'
        fi
        for name in "${!lists[@]}"; do
            echo "rvd_prepend $name ${lists[$name]@Q}"
        done
        echo 'unset PYTHONHOME PYTHONDONTWRITEBYTECODE    # without bytecode a start takes seconds'
        echo "export RVD_ROOT=${root@Q} VIRTUAL_ENV=${venv@Q}"
        echo 'source "$RVD_ROOT/scripts/network.sh"'
        echo '# There are many small processes: linear-algebra threads would only get in their way.'
        echo 'export OPENBLAS_NUM_THREADS="${OPENBLAS_NUM_THREADS:-1}"'
        echo 'export OMP_NUM_THREADS="${OMP_NUM_THREADS:-1}"'
    } > "$state/env.new"
    mv "$state/env.new" "$state/env.sh"
    rm "$state/variables"
}

# rvd_prepend VARIABLE ENTRIES: drop the entries of any .rvd, then put in front those not there yet.
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

# Import what the nodes import: this proves the set-up and leaves the bytecode for the first run.
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
from tf2_msgs.msg import TFMessage

message = RelativeState()
message.position.x = -30.0
TFMessage()
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
        [[ -n $before ]] &&
            why='the lock file, ROS, the Python or the location of the project changed'
        [[ -n $again ]] && why='requested'
        say "setting up in $state ($why): takes a minute or two and 1.7 GB"
        stage environment "making the environment ($("$python" -V 2>&1))" create_environment
        stage packages \
            "installing $(grep -c '^[A-Za-z]' "$root/requirements.lock") pinned packages" \
            install_packages
        echo "$packages" > "$venv/complete"
    fi

    before=$(recorded "$state/build/complete") || true
    if [[ $before != "$build" ]]; then
        # Colcon does not clean up after a removed file or an interrupted build.
        [[ -n $before && -z $(gone_from "$before" "$build") ]] || rm -rf "$state"/{build,install}
        rm -f "$state/build/complete"
        stage build 'building the workspace' build_workspace
        write_environment
        stage check 'checking that everything loads' check_environment
        echo "$build" > "$state/build/complete"
    fi
    [[ -r $state/env.sh ]] || write_environment
    printf '%s\n' "$packages" "$build" > "$state/done.new"
    mv "$state/done.new" "$state/done"
    say "ready after $((SECONDS - started)) s"
}

gone_from() {                                   # gone_from BEFORE NOW: files that no longer exist
    comm -23 <(cut -c67- <<< "$1" | sort) <(cut -c67- <<< "$2" | sort)
}

again='' basilisk=''
case "${1:-}" in
    '') ;;
    --again) again=yes ;;
    --basilisk) basilisk=$(command -v "${2:-}") || die '--basilisk takes a Python that has uv' ;;
    *) die "setup takes --again or nothing, not '$1'" ;;
esac
mkdir -p "$state" 2> /dev/null || die "cannot write to $root"
[[ -w $state && ( -w $state/lock || ! -e $state/lock ) ]] || die "cannot write to $state"
exec 9> "$state/lock"                           # the children hold it too if this process is killed
if ! flock --nonblock 9; then
    say 'another set-up is running here: waiting for it'
    flock 9
fi
trap 'say "interrupted; the next command repairs it"; exit 130' INT
if [[ -n $basilisk ]]; then
    set_up_basilisk "$basilisk"
    exit
fi
find_ros
unset PYTHONHOME PYTHONWARNINGS PYTHONINSPECT PYTHONHASHSEED PYTHONPLATLIBDIR PYTHONIOENCODING
unset _ROS_WHEELS_BOOTSTRAP_COMPLETE
if [[ $ros == wheels ]]; then                   # whatever else this shell has loaded
    unset PYTHONPATH AMENT_PREFIX_PATH CMAKE_PREFIX_PATH COLCON_PREFIX_PATH
fi
[[ -n $again ]] && rm -f "$state/done" "$venv/complete"
if up_to_date; then
    say "up to date: $state"
    exit 0
fi
set_up
