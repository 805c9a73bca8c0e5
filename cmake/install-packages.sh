# install_packages FILE...: installs those of the listed Debian packages that are missing; silent where none is.
# Sourced by ./run and ./test.
install_packages() {
  local wanted missing sudo=""
  wanted=$(sed -e 's/#.*//' -e '/^ *$/d' "$@" | sort -u)
  missing=$(comm -23 <(echo "$wanted") \
    <(dpkg-query -W -f '${binary:Package} ${db:Status-Status}\n' 2>/dev/null |
      sed -n 's/^\([^ :]*\)[^ ]* installed$/\1/p' | sort -u) | tr '\n' ' ')
  [ -n "${missing// /}" ] || return 0
  if ! command -v apt-get >/dev/null; then
    echo "haptiv: these packages are missing, and this is no Debian that could install them: $missing" >&2
    return 3
  fi
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "haptiv: as root, please install: $missing" >&2
      return 3
    fi
    sudo="sudo"
    echo "haptiv: installing with sudo: $missing"
  else
    echo "haptiv: installing: $missing"
  fi
  $sudo env DEBIAN_FRONTEND=noninteractive apt-get update -qq &&
    $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null
}
