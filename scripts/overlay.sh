# Load the packages of RVD_OVERLAY beside the workspace. Sourced by `rvd` and `scripts/shellrc`,
# after env.sh.
#
# RVD_OVERLAY holds install folders, separated by colons, as `colcon build` makes them: a whole one,
# isolated or merged, or that of one package. As in PATH, the first has the first word, and all of
# them come before the workspace.

# Print one line and return 2 if one of the folders cannot be loaded.
load_overlay() {
    local prefixes absolute='' prefix i script scripts options
    IFS=: read -ra prefixes <<< "${RVD_OVERLAY:-}"
    options=$(set +o)
    set +eu                                     # colcon's scripts know neither
    for ((i = ${#prefixes[@]} - 1; i >= 0; i--)); do        # what is loaded last comes first
        prefix=${prefixes[i]}
        [[ -n $prefix ]] || continue
        if [[ ! -d $prefix ]]; then
            printf 'rvd: RVD_OVERLAY: no folder %s\n' "$prefix" >&2
            return 2
        fi
        prefix=$(CDPATH= cd -- "$prefix" && pwd)      # a command may change the working directory
        if ! compgen -G "$prefix/share/ament_index/resource_index/packages/*" > /dev/null &&
            ! compgen -G "$prefix/*/share/ament_index/resource_index/packages/*" > /dev/null; then
            printf 'rvd: RVD_OVERLAY: %s holds no package: %s\n' "$prefix" \
                'give the install folder of a colcon build' >&2
            return 2
        fi
        scripts=("$prefix/local_setup.bash")
        [[ -r ${scripts[0]} ]] || scripts=("$prefix"/share/*/package.bash)     # of one package
        if [[ ! -r ${scripts[0]} ]]; then
            printf 'rvd: RVD_OVERLAY: %s has no local_setup.bash: build it with colcon\n' \
                "$prefix" >&2
            return 2
        fi
        for script in "${scripts[@]}"; do
            source "$script"
        done
        absolute=$prefix${absolute:+:$absolute}
    done
    eval "$options"
    [[ -z $absolute ]] || export RVD_OVERLAY=$absolute
}
