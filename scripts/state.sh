# Where the set-up is, and whether it is up to date. Sourced by `rvd` and `scripts/setup.sh`.
#
# Expects `root`, the project's directory. It starts no Python and only two short processes
# (sha256sum), since every warm call of `./rvd` passes through here.

state=$root/.rvd
venv=$state/venv

die() {                                         # one line, exit 2: nothing was run
    printf 'rvd: %s\n' "$*" >&2
    exit 2
}

# Set `ros` to the prefix of an installed ROS 2 Jazzy, to `sourced` if the shell has one loaded
# from elsewhere, or to `wheels`. RVD_ROS_PREFIX names another prefix; `none` asks for the wheels.
find_ros() {
    local prefix=${RVD_ROS_PREFIX:-/opt/ros/jazzy}
    if [[ $prefix == none ]]; then
        ros=wheels
    elif [[ -r $prefix/setup.bash ]]; then
        ros=$prefix
    elif [[ -n ${RVD_ROS_PREFIX:-} ]]; then
        die "RVD_ROS_PREFIX=$prefix holds no setup.bash"
    elif [[ ${ROS_DISTRO:-} == jazzy && -n ${AMENT_PREFIX_PATH:-} ]]; then
        ros=sourced
    else
        ros=wheels
    fi
}

# Print what a set-up is made from; it is compared as text with what was printed when it was made.
# The version goes up when setup.sh changes so that old results no longer satisfy it.
venv_inputs() {
    echo "version 1, ROS $ros"
    sha256sum "$root/requirements.lock"
}

build_inputs() {
    local LC_ALL=C src=$root/ros2_ws/src sources package files
    find_sources
    shopt -s nullglob
    files=("$src"/*/{package.xml,setup.py,setup.cfg,CMakeLists.txt} "$src"/*/{msg,srv,action}/*)
    for package in "${sources[@]:1}"; do
        files+=("$package"/{package.xml,CMakeLists.txt} "$package"/msg/*)
    done
    shopt -u nullglob
    echo 'environment 2'                        # goes up when setup.sh writes another env.sh
    sha256sum "${files[@]}"
}

# Set `sources` to what colcon builds: the workspace, and from ros2_extra/ the packages of ROS 2
# that are not among its wheels, unless the ROS in use brings them: what is of ROS is never hidden.
find_sources() {
    local package prefix prefixes=()
    [[ $ros == /* ]] && prefixes=("$ros")
    [[ $ros == sourced ]] && IFS=: read -ra prefixes <<< "$AMENT_PREFIX_PATH"
    sources=("$root/ros2_ws/src")
    for package in "$root"/ros2_extra/*; do
        for prefix in "${prefixes[@]}"; do
            [[ $prefix == */.rvd/* || ! -e $prefix/share/${package##*/}/package.xml ]] || continue 2
        done
        sources+=("$package")
    done
}

recorded() {                                    # recorded FILE: its text, nothing if it is missing
    [[ -r $1 ]] && printf '%s' "$(<"$1")"
}

same_python() {                                 # the Python asked for, if any, is the one in use
    [[ -x $venv/bin/python ]] || return 1
    [[ -z ${RVD_PYTHON:-} ]] && return
    local asked base
    { read -r asked; read -r base; } < "$state/python" 2> /dev/null || return 1
    [[ $RVD_PYTHON == "$asked" || $RVD_PYTHON == "$base" ]]
}

up_to_date() {
    find_ros
    [[ -r $state/done && -r $state/env.sh ]] && same_python &&
        [[ "$(venv_inputs; build_inputs)" == "$(<"$state/done")" ]]
}
