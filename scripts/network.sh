# Who hears the nodes that this shell starts: this machine alone, unless the user says otherwise.
# Sourced by .rvd/env.sh and scripts/bringup.sh; `rvd_campaign.flight.reach` says it of a flight.
#
# Our file of Fast DDS profiles binds every socket to 127.0.0.1. It is left out where the user names
# another file, another range or another middleware: then that decides, and `./rvd fly` says so.
# Shared memory, which that file leaves out and says why, is left out there, too, unless the user
# wants it.

rvd_network() {
    local range=${ROS_AUTOMATIC_DISCOVERY_RANGE:-} profiles=${FASTRTPS_DEFAULT_PROFILES_FILE:-}
    local ours=config/fastdds_loopback.xml
    if [[ $profiles == */$ours ]]; then         # of this shell, or of another checkout
        profiles=''
        [[ $range != SYSTEM_DEFAULT ]] || range=''
    fi
    if [[ -z $profiles && ( -z $range || $range == LOCALHOST ) &&
        ${RMW_IMPLEMENTATION:-rmw_fastrtps_cpp} == rmw_fastrtps_cpp ]]; then
        range=SYSTEM_DEFAULT profiles=${RVD_ROOT:-${BASH_SOURCE[0]%/*}/..}/$ours
        export SKIP_DEFAULT_XML_FILE=1          # no file of the working folder adds to it
        unset ROS_LOCALHOST_ONLY                # old ROS: with it rmw listens on 0.0.0.0 again
    else
        export FASTDDS_BUILTIN_TRANSPORTS=${FASTDDS_BUILTIN_TRANSPORTS:-UDPv4}
    fi
    export ROS_AUTOMATIC_DISCOVERY_RANGE=${range:-LOCALHOST}
    if [[ -n $profiles ]]; then
        export FASTRTPS_DEFAULT_PROFILES_FILE=$profiles
    else
        unset FASTRTPS_DEFAULT_PROFILES_FILE
    fi
}
rvd_network
