# What both scripts of CI begin with: the repository's folder, uv, and ways to get Debian's packages.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

tools=$(mktemp -d)
trap 'rm -rf "$tools"' EXIT
python3 -m venv "$tools"
"$tools/bin/pip" install --quiet uv
export PATH="$tools/bin:$PATH"
# Hundreds of processes import the same modules: compile each once, beside nobody's sources.
unset PYTHONDONTWRITEBYTECODE
export PYTHONPYCACHEPREFIX="$tools/bytecode"

# debian COMMAND WHAT PACKAGE...: Debian's packages if the command is not here, or a word that WHAT is skipped.
debian() {
    local command=$1 skipped=$2
    shift 2
    if command -v "$command" >/dev/null; then
        return
    fi
    if [ "$(id -u)" != 0 ] || ! command -v apt-get >/dev/null ||
        ! { apt-get -qq update && DEBIAN_FRONTEND=noninteractive \
            apt-get -qq install --no-install-recommends "$@"; } >/dev/null; then
        echo "$command: not here and cannot be installed, $skipped will be skipped"
    fi
}
