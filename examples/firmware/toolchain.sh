# What builds firmware, for the scripts beside it, which source this: `source toolchain.sh`.
#
# It goes to the package's folder; $caller_dir is where the caller was, $target_dir where cargo builds, $scratch a
# folder of this run.

fail() {
    echo "${0##*/}: $*" >&2
    exit 1
}

# --- What must be installed ------------------------------------------------------------------------------------------

# need COMMAND_OR_FILE PACKAGE...: installs the packages if the first of the arguments is missing and this is CI.
need() {
    local wanted=$1
    shift
    have "$wanted" && return
    if [[ -n ${CI:-} && $(id -u) == 0 ]] && have apt-get; then
        echo "${0##*/}: installing $*" >&2
        { apt-get update && DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends "$@"; } >&2 ||
            fail "$wanted is missing, and apt-get could not install $*"
    fi
    have "$wanted" || fail "$wanted is missing; on Debian: apt-get install $*"
}

have() {
    if [[ $1 == /* ]]; then [[ -e $1 ]]; else command -v "$1" >/dev/null; fi
}

# --- Building --------------------------------------------------------------------------------------------------------

rustup_provides() {
    have rustup || return
    rustup target list --installed 2>/dev/null | grep -qx "$1" || rustup target add "$1" >/dev/null 2>&1
}

# cargo_for TARGET COMMAND [ARGUMENT...]: that cargo command by the toolchain that can build for the target.
cargo_for() {
    local target=$1 command=$2
    shift 2
    local toolchain=${SPANFILL_TOOLCHAIN:-}
    if [[ -z $toolchain ]]; then
        if rustup_provides "$target"; then toolchain=rustup; else toolchain=debian; fi
    fi
    case $toolchain in
    rustup)
        rustup_provides "$target" || fail "rustup has no $target; try: rustup target add $target"
        cargo "$command" --release --target "$target" --target-dir "$target_dir" "$@"
        ;;
    debian)
        need /usr/bin/rustc rustc-web
        need /usr/bin/cargo cargo-web
        need /usr/lib/rustlib/src/rust/library/core rust-web-src
        need ld.lld lld
        # RUSTC_BOOTSTRAP: `-Z build-std` is not a stable option of cargo.
        env -u LD_LIBRARY_PATH RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 /usr/bin/cargo "$command" -Z build-std=core \
            --config "target.$target.linker = 'ld.lld'" \
            --release --target "$target" --target-dir "$target_dir/debian-toolchain" "$@"
        ;;
    *)
        fail "SPANFILL_TOOLCHAIN is '$toolchain': neither rustup nor debian"
        ;;
    esac
}

# build_firmware EXAMPLE TARGET [ARGUMENT...]: builds it and prints the name of its ELF file.
build_firmware() {
    local example=$1 target=$2
    shift 2
    # One codegen unit: otherwise what is inlined, and so what is counted, depends on how the compiler cuts up the
    # crate.
    cargo_for "$target" rustc --config profile.release.codegen-units=1 \
        --features _firmware --example "$example" --message-format json-render-diagnostics "$@" |
        sed -n 's/.*"executable":"\([^"]*\)".*/\1/p' | tail -n 1
}

# --- Where everything is ---------------------------------------------------------------------------------------------

# An output file's name is relative to where the caller is, everything else to the package.
caller_dir=$PWD
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

# Flags for the host's compiler are none for the firmware's: they would replace those of .cargo/config.toml.
unset RUSTFLAGS CARGO_ENCODED_RUSTFLAGS CARGO_BUILD_TARGET

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

in_caller_dir() {
    case $1 in
    /*) echo "$1" ;;
    *) echo "$caller_dir/$1" ;;
    esac
}

target_dir=$(in_caller_dir "${CARGO_TARGET_DIR:-$PWD/target}")
