#!/usr/bin/env bash
# Builds the page, serves it, and tests it in headless Chromium. See --help.
set -euo pipefail

usage() {
    cat <<'END'
Builds the page that shows the crate in a browser, serves it, and tests it.

Usage: examples/web/run.sh COMMAND

Commands:
  build                 The page, in examples/web/target/site: any server of files can serve it from there.
  serve [PORT]          Builds it and serves it on this machine. [default: 8000]
  check                 Builds it, draws the same pictures by a program of the host, and compares every canvas, in Node: the
                        dashboard, and every method with every option.
  test                  The same, then works the page's controls in headless Chromium, and compares the canvases that it
                        shows: the dashboard, and every subject by every family of methods.
  screenshot [OUT.png]  Builds it and saves what the page looks like. [default: page.png]

Environment:
  SPANFILL_TOOLCHAIN    `rustup`: the toolchain in use, with rustup's target, which is added where it is missing.
                        `debian`: Debian's compiler in /usr/bin, building `std` from Debian's source package.
                        [default: rustup where it has the target or can add it, debian otherwise]
  CHROMIUM              The browser. [default: chromium]
  CI                    When set, as root and with apt-get: what is missing is installed. Otherwise one line says what
                        to install, and the exit status is 1.

Whatever could not be built or run is a failure.
END
}

fail() {
    echo "web/run.sh: $*" >&2
    exit 1
}

have() {
    if [[ $1 == /* ]]; then [[ -e $1 ]]; else command -v "$1" >/dev/null; fi
}

# need COMMAND_OR_FILE PACKAGE...: installs the packages if the first of the arguments is missing and this is CI.
need() {
    local wanted=$1
    shift
    have "$wanted" && return
    if [[ -n ${CI:-} && $(id -u) == 0 ]] && have apt-get; then
        echo "web/run.sh: installing $*" >&2
        { apt-get update && DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends "$@"; } >&2 ||
            fail "$wanted is missing, and apt-get could not install $*"
    fi
    have "$wanted" || fail "$wanted is missing; on Debian: apt-get install $*"
}

target=wasm32-unknown-unknown
site=target/site

rustup_provides() {
    have rustup || return
    rustup target list --installed 2>/dev/null | grep -qx $target || rustup target add $target >/dev/null 2>&1
}

build() {
    local toolchain=${SPANFILL_TOOLCHAIN:-} built
    if [[ -z $toolchain ]]; then
        if rustup_provides; then toolchain=rustup; else toolchain=debian; fi
    fi
    case $toolchain in
    rustup)
        rustup_provides || fail "rustup has no $target; try: rustup target add $target"
        cargo build --release --lib --target $target
        built=target/$target/release
        ;;
    debian)
        need /usr/bin/rustc rustc-web
        need /usr/bin/cargo cargo-web
        need /usr/lib/rustlib/src/rust/library/core rust-web-src
        need wasm-ld lld
        # libstd-rust-dev-wasm32 is older than the edition. RUSTC_BOOTSTRAP: `-Z build-std` is not a stable option of cargo.
        env -u LD_LIBRARY_PATH RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 /usr/bin/cargo build -Z build-std=std,panic_abort \
            --config "target.$target.linker = 'wasm-ld'" --release --lib --target $target --target-dir target/debian-toolchain
        built=target/debian-toolchain/$target/release
        ;;
    *) fail "SPANFILL_TOOLCHAIN is '$toolchain': neither rustup nor debian" ;;
    esac
    mkdir -p $site
    cp index.html page.js test.js "$built/spanfill_web.wasm" $site
    echo "web/run.sh: the page is in $PWD/$site" >&2
}

run_check() {
    need node nodejs
    build
    cargo run --release --bin expected "$scratch"
    node check.mjs $site "$scratch"
}

run_test() {
    need "$chromium" chromium
    run_check
    node serve.mjs $site 0 "$scratch" "$chromium"
}

screenshot() {
    need node nodejs
    need "$chromium" chromium
    build
    node serve.mjs $site 0 >"$scratch/said" &
    server=$!
    local tenths
    for ((tenths = 0; tenths < 100; tenths++)); do
        grep -q http "$scratch/said" && break
        sleep 0.1
    done
    timeout 120 "$chromium" --headless --no-sandbox --disable-gpu --disable-quic --no-first-run --hide-scrollbars \
        --disable-background-networking --disable-component-update --disable-sync --user-data-dir="$scratch/profile" \
        --window-size=1240,2580 --screenshot="$1" \
        "$(sed -n 's/.*\(http.*\)/\1?screenshot/p' "$scratch/said")" 2>"$scratch/log" || fail "$chromium: $(cat "$scratch/log")"
    [[ -s $1 ]] || fail "$chromium saved no picture: $(cat "$scratch/log")"
}

in_caller_dir() {
    case $1 in
    /*) echo "$1" ;;
    *) echo "$caller_dir/$1" ;;
    esac
}

caller_dir=$PWD
cd "$(dirname "${BASH_SOURCE[0]}")"
# Flags for the host's compiler would replace those of .cargo/config.toml.
unset RUSTFLAGS CARGO_ENCODED_RUSTFLAGS CARGO_BUILD_TARGET CARGO_TARGET_DIR
chromium=${CHROMIUM:-chromium}
scratch=$(mktemp -d)
# Empty, or the server that must not outlive this script.
server=
trap '[[ -z $server ]] || kill "$server" 2>/dev/null; rm -rf "$scratch"' EXIT

case ${1:---help} in
-h | --help | help) usage ;;
build) build ;;
serve)
    need node nodejs
    build
    node serve.mjs $site "${2:-8000}"
    ;;
check) run_check ;;
test) run_test ;;
screenshot) screenshot "$(in_caller_dir "${2:-page.png}")" ;;
*) fail "there is no '$1'; see --help" ;;
esac
