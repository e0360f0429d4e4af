#!/bin/sh
# Installs what `make web` builds the page with and what its tests run in: Debian packages, among them
# Chromium, and playwright-core from npm, in tests/web/node_modules. Does nothing if everything is
# installed.
set -eu
self=setup-web
. "$(dirname "$0")/debian.sh"

# Node may be there without Debian's package.
node="nodejs npm"
if command -v node >/dev/null 2>&1 && command -v npm >/dev/null 2>&1; then
    node=""
fi

# install_packages ends the shell that it runs in if there is nothing to do.
(install_packages "clang-19 lld-19 wasi-libc libclang-rt-19-dev-wasm32 binaryen chromium python3-markdown-it
python3-pygments $node" "$@")
case "${1:-}" in
"") ;;
*) exit 0 ;;
esac

cd "$(dirname "$0")/../tests/web"
if [ -d node_modules ] && npm ls >/dev/null 2>&1; then
    say "playwright-core is there"
    exit 0
fi
log=$(mktemp)
trap 'rm -f "$log"' EXIT
trap 'exit 1' INT TERM HUP
# The browser is Debian's.
step "installing playwright-core" env PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD=1 npm ci --no-audit --no-fund
say "done"
