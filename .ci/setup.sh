# Sourced by run.sh and test.sh: makes sure that the Debian packages a script needs are there. Those missing are named and
# installed, as root or where sudo asks for no password; otherwise, and without Debian's tools, the script stops.
# With WRC_NO_INSTALL=1 nothing is installed: what is missing is named, and the script goes on as far as it gets.

need_packages() {
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  if [ "${WRC_NO_INSTALL:-0}" = 1 ]; then
    echo "Missing Debian packages, not installed as WRC_NO_INSTALL=1 asks: ${missing[*]}"
    return 0
  fi
  local as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo -n)
  if ! command -v apt-get >/dev/null || ! "${as_root[@]}" true 2>/dev/null; then
    echo "Missing Debian packages. As root, run:  apt-get install ${missing[*]}" >&2
    echo "or say WRC_NO_INSTALL=1 if you have them by other means." >&2
    exit 3
  fi
  echo "Installing Debian packages (WRC_NO_INSTALL=1 prevents it): ${missing[*]}"
  "${as_root[@]}" apt-get update -qq
  DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}
