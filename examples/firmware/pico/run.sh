#!/usr/bin/env bash
# Builds the Pico's firmware, runs it on an emulated board, and compares what the display shows with what the host draws.
#
# Usage: examples/firmware/pico/run.sh [--check] [PNG_FOLDER]
#
#   --check       Fails if a pixel differs, of a picture or of an example on the simulator, a shape takes more bytes than
#                 embedded-graphics', or the small firmware takes 8 KiB.
#   PNG_FOLDER    Where the pictures that the display shows go.
#
# SPANFILL_TOOLCHAIN and CI are as for examples/firmware/run.sh.
set -euo pipefail

fail() {
    echo "pico/run.sh: $*" >&2
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
        { apt-get update && DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends "$@"; } >&2 ||
            fail "$wanted is missing, and apt-get could not install $*"
    fi
    have "$wanted" || fail "$wanted is missing; on Debian: apt-get install $*"
}

check=show
out=
for argument; do
    case $argument in
    --check) check=check ;;
    -*) fail "there is no $argument" ;;
    /*) out=$argument ;;
    *) out=$PWD/$argument ;;
    esac
done
cd "$(dirname "${BASH_SOURCE[0]}")"
unset RUSTFLAGS CARGO_ENCODED_RUSTFLAGS CARGO_BUILD_TARGET CARGO_TARGET_DIR
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

need node nodejs
need npm npm
[[ -d node_modules/rp2040js ]] || npm install --no-audit --no-fund >&2 || fail "npm could not install rp2040js"

target=thumbv6m-none-eabi
# All but `expected`, which the host runs.
bins=(--bin bus --bin small --bin hello_lcd --bin dashboard --bin bands --bin damage)
rustup_provides() {
    have rustup || return
    rustup target list --installed 2>/dev/null | grep -qx $target || rustup target add $target >/dev/null 2>&1
}
toolchain=${SPANFILL_TOOLCHAIN:-}
if [[ -z $toolchain ]]; then
    if rustup_provides; then toolchain=rustup; else toolchain=debian; fi
fi
case $toolchain in
rustup)
    rustup_provides || fail "rustup has no $target"
    cargo build --release --target $target "${bins[@]}"
    firmware=target/$target/release
    ;;
debian)
    need /usr/bin/rustc rustc-web
    need /usr/bin/cargo cargo-web
    need /usr/lib/rustlib/src/rust/library/core rust-web-src
    need ld.lld lld
    env -u LD_LIBRARY_PATH RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 /usr/bin/cargo build -Z build-std=core \
        --config "target.$target.linker = 'ld.lld'" \
        --release --target $target --target-dir target/debian-toolchain "${bins[@]}"
    firmware=target/debian-toolchain/$target/release
    ;;
*) fail "SPANFILL_TOOLCHAIN is '$toolchain': neither rustup nor debian" ;;
esac

cargo run --release --bin expected "$scratch"
for example in hello_lcd dashboard bands damage; do
    cargo run --release --bin $example "$scratch/$example.rgb565"
done
node run.mjs $firmware "$scratch" $check ${out:+"$out"}
