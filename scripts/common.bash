# shellcheck shell=bash
# What the scripts of this directory share. Source it; it is no program.

set -euo pipefail

# The directory of the package.
# shellcheck disable=SC2034
checkout=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# The system's Python and tools come first: catkin breaks under a Python of pyenv or conda.
export PATH="/usr/sbin:/usr/bin:/sbin:/bin:$PATH"
unset PYTHONHOME PYTHONPATH

# Prints a progress line with the seconds since the script began.
say() {
  printf '[%4d s] %s\n' "$SECONDS" "$*"
}

# Prints why the script cannot go on, and ends it.
fail() {
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

# Sources a ROS setup file; those files do not survive `set -u`.
source_setup() {
  set +u
  # shellcheck disable=SC1090
  . "$1"
  set -u
}

# Column of scripts/packages.txt for this system: 2 on Debian 12, 3 on Ubuntu 20.04, 4 on Debian 11.
package_column() {
  local system
  system=$(. /etc/os-release && echo "$ID $VERSION_ID")
  case "$system" in
    'debian 12') echo 2 ;;
    'ubuntu 20.04') echo 3 ;;
    'debian 11') echo 4 ;;
    *) fail "this system is '$system', expected Debian 12, Ubuntu 20.04 or Debian 11" ;;
  esac
}

# How many compilers may run at once: one for each processor, and 1 GB of memory for each.
parallel_jobs() {
  local processors memory
  processors=$(nproc)
  memory=$(awk '/^MemAvailable:/ { print int($2 / 1048576) }' /proc/meminfo)
  echo $((memory < 1 ? 1 : memory < processors ? memory : processors))
}

# A port that no other ROS master uses.
free_port() {
  python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'
}

if [ -e /opt/ros/noetic/setup.bash ]; then
  source_setup /opt/ros/noetic/setup.bash
fi
