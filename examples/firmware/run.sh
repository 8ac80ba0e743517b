#!/usr/bin/env bash
# Builds the library and the firmware examples for microcontrollers, and runs the firmware in QEMU. See --help.
set -euo pipefail

usage() {
    cat <<'END'
Builds the library and the firmware examples for microcontrollers, and runs the firmware in QEMU.

Usage: examples/firmware/run.sh COMMAND

Commands:
  build              The library, without features and with `embedded-graphics`, for thumbv6m, thumbv7m, thumbv7em and
                     riscv32imac; the firmware examples for their boards. `no_panic` links only if the library has no
                     panic path.
  oled [OUT]         Runs `oled` on an emulated board and saves what its panel shows: 512 x 256, each pixel 4 x 4.
                     OUT ends in .png or .ppm. [default: oled.png]
  cycles [--csv OUT] [--readme FILE] [--check]
                     Runs `cycles` on an emulated Cortex-M4: a table of instructions a shape. The CSV rows follow the
                     table, or go to OUT. In FILE, the table replaces what stands between its two `cycles` markers.
  cycles_aa [--csv OUT] [--readme FILE] [--check]
                     The same for `cycles_aa`: anti-aliased outlines, on a Cortex-M4F; the markers are `cycles_aa`.
                     Both: --check fails where there are more instructions than in examples/firmware/bars.csv.
  attributes [--csv OUT]
                     Runs `attributes` on an emulated Cortex-M4: a table of instructions a pixel of triangles whose
                     colour, texture or depth varies. The CSV rows follow the table, or go to OUT.
  cube3d             Runs `cube3d_cycles` on an emulated Cortex-M4: instructions a frame of examples/cube3d.
  frame              Runs `frame_cycles` and `band_cycles` on the same: what framebuffers and bands cost, in instructions.
  methods [--csv OUT]
                     Runs `methods` on an emulated Cortex-M4, with and without its float unit: instructions by each
                     method of the literature, as CSV rows, which go to OUT. Takes some minutes. For the charts:
                     run.sh methods --csv docs/charts/cortex-m4.csv

Environment:
  SPANFILL_TOOLCHAIN   `rustup`: the toolchain in use, with rustup's targets, which are added where they are missing.
                       `debian`: Debian's compiler in /usr/bin, building `core` from Debian's source package.
                       [default: rustup where it has the target or can add it, debian otherwise]
  CARGO_TARGET_DIR     Where to build, as for cargo.
  CI                   When set, as root and with apt-get: what is missing is installed. Otherwise one line says what
                       to install, and the exit status is 1.

Whatever could not be built or run is a failure.
END
}

# fail, need, have, cargo_for, build_firmware; and $scratch, $target_dir, in_caller_dir, once it has been sourced.
source "$(dirname "${BASH_SOURCE[0]}")/toolchain.sh"

build_everything() {
    local target
    for target in thumbv6m-none-eabi thumbv7m-none-eabi thumbv7em-none-eabi riscv32imac-unknown-none-elf; do
        echo "run.sh: the library for $target" >&2
        cargo_for "$target" build --lib
        cargo_for "$target" build --lib --features embedded-graphics
    done
    build_oled >/dev/null
    build_cycles >/dev/null
    build_firmware methods thumbv7em-none-eabi --features methods >/dev/null
    build_cycles_aa >/dev/null
    build_firmware attributes thumbv7em-none-eabi >/dev/null
    build_firmware cube3d_cycles thumbv7em-none-eabi >/dev/null
    build_firmware no_panic_varying thumbv7em-none-eabi >/dev/null
    build_frame frame_cycles >/dev/null
    build_frame band_cycles >/dev/null
    echo "run.sh: linking no_panic and no_panic_frames, which fails if the library has a panic path" >&2
    # Every shape with every blending is more than the board has room for, and need not run.
    build_firmware no_panic_frames thumbv7em-none-eabi >/dev/null
    build_firmware no_panic thumbv7m-none-eabi --features embedded-graphics \
        -- -C link-arg=--defsym=_flash_length=4M >/dev/null
}

build_oled() {
    build_firmware oled thumbv7m-none-eabi
}

build_cycles() {
    build_firmware cycles thumbv7em-none-eabi --features embedded-graphics
}

build_cycles_aa() {
    build_firmware cycles_aa thumbv7em-none-eabihf
}

# build_frame EXAMPLE
build_frame() {
    build_firmware "$1" thumbv7em-none-eabi
}

# --- Running ---------------------------------------------------------------------------------------------------------

run_oled() {
    local out=${1:-oled.png} format
    case $out in
    *.png) format=png ;;
    *.ppm) format=ppm ;;
    *) fail "$out ends neither in .png nor in .ppm" ;;
    esac
    need qemu-system-arm qemu-system-arm
    local elf
    elf=$(build_oled)

    # QEMU's monitor takes commands by one pipe and answers by another; what the firmware says goes to `said`.
    mkfifo "$scratch/monitor.in" "$scratch/monitor.out"
    exec 3<>"$scratch/monitor.in" 4<>"$scratch/monitor.out"
    : >"$scratch/said"
    qemu-system-arm -machine lm3s6965evb -display none -serial none \
        -chardev pipe,id=monitor,path="$scratch/monitor" -mon chardev=monitor,mode=control \
        -semihosting-config enable=on,target=native -kernel "$elf" >"$scratch/said" 2>&1 &
    qemu=$!
    wait_until_said "oled: the scene is on the panel"

    echo '{"execute": "qmp_capabilities"}' >&3
    await_reply '"return"'
    echo '{"execute": "screendump", "arguments": {"filename": "'"$scratch/screen"'", "format": "'$format'"}}' >&3
    await_reply '"return"'
    echo '{"execute": "quit"}' >&3
    wait "$qemu"
    qemu=
    mv "$scratch/screen" "$out"
    echo "run.sh: what the panel shows is in $out" >&2
}

# Waits for a line of the firmware's, 30 seconds at most.
wait_until_said() {
    local tenths
    for ((tenths = 0; tenths < 300; tenths++)); do
        grep -qF "$1" "$scratch/said" && return
        kill -0 "$qemu" 2>/dev/null || break
        sleep 0.1
    done
    fail "the firmware did not say '$1' but: $(cat "$scratch/said")"
}

# Waits for a reply of the monitor's, skipping its greeting and its events.
await_reply() {
    local line
    while read -r -t 30 -u 4 line; do
        [[ $line == *'"error"'* ]] && fail "QEMU's monitor: $line"
        [[ $line == *"$1"* ]] && return
    done
    fail "QEMU's monitor does not answer"
}

run_frame() {
    need qemu-system-arm qemu-system-arm
    local example elf
    for example in frame_cycles band_cycles; do
        elf=$(build_frame $example)
        timeout 300 qemu-system-arm -machine mps2-an386 -icount shift=0 -nographic \
            -semihosting-config enable=on,target=native -kernel "$elf" </dev/null || fail "the firmware failed"
    done
}

# run_cycles EXAMPLE [ARGUMENT...]
run_cycles() {
    local example=$1 csv= readme= check=
    shift
    while (($#)); do
        case $1 in
        --csv) csv=$(in_caller_dir "${2:?--csv needs the name of a file}") ;;
        --readme) readme=$(in_caller_dir "${2:?--readme needs the name of a file}") ;;
        --check)
            check=yes
            shift
            continue
            ;;
        *) fail "$example does not know '$1'; see --help" ;;
        esac
        shift 2
    done
    need qemu-system-arm qemu-system-arm
    local elf
    elf=$("build_$example")

    # The firmware ends QEMU itself, with a status other than 0 if it panics. The longest run seen took 5 seconds.
    timeout 300 qemu-system-arm -machine mps2-an386 -icount shift=0 -nographic \
        -semihosting-config enable=on,target=native -kernel "$elf" </dev/null >"$scratch/said" ||
        fail "the firmware failed: $(cat "$scratch/said")"
    # An empty line parts the table from the rows.
    sed '/^$/,$d' "$scratch/said" | tee "$scratch/table"
    sed '1,/^$/d' "$scratch/said" >"$scratch/rows"
    if [[ -n $csv ]]; then
        cp "$scratch/rows" "$csv"
    else
        echo
        cat "$scratch/rows"
    fi
    [[ -z $readme ]] || put_table_into "$readme" "$example"
    [[ -z $check ]] || check_bars
}

# Fails when a row has more instructions than its bar, or when no row has a bar.
check_bars() {
    awk -F, '
        NR == FNR { if (FNR > 1) bars[$1 "," $2 "," $3 "," $4] = $5; next }
        ($1 "," $2 "," $3 "," $4) in bars {
            bar = bars[$1 "," $2 "," $3 "," $4]
            verdict = $5 <= bar ? "reached" : "NOT reached"
            printf "    %-12s %3d %-12s at most %8d instructions: %8d, %s\n", $1, $4, $2, bar, $5, verdict
            seen++
            if ($5 > bar) failed++
        }
        END { exit failed > 0 || seen == 0 }
    ' examples/firmware/bars.csv "$scratch/rows" || fail "not every bar of examples/firmware/bars.csv is reached"
}

run_attributes() {
    local csv=
    while (($#)); do
        case $1 in
        --csv) csv=$(in_caller_dir "${2:?--csv needs the name of a file}") ;;
        *) fail "attributes does not know '$1'; see --help" ;;
        esac
        shift 2
    done
    need qemu-system-arm qemu-system-arm
    local elf
    elf=$(build_firmware attributes thumbv7em-none-eabi)
    timeout 300 qemu-system-arm -machine mps2-an386 -icount shift=0 -nographic \
        -semihosting-config enable=on,target=native -kernel "$elf" </dev/null >"$scratch/said" ||
        fail "the firmware failed: $(cat "$scratch/said")"
    sed '/^$/,$d' "$scratch/said"
    if [[ -n $csv ]]; then
        sed '1,/^$/d' "$scratch/said" >"$csv"
    else
        sed -n '/^$/,$p' "$scratch/said"
    fi
}

run_cube3d() {
    need qemu-system-arm qemu-system-arm
    local elf
    elf=$(build_firmware cube3d_cycles thumbv7em-none-eabi)
    timeout 300 qemu-system-arm -machine mps2-an386 -icount shift=0 -nographic \
        -semihosting-config enable=on,target=native -kernel "$elf" </dev/null >"$scratch/said" ||
        fail "the firmware failed: $(cat "$scratch/said")"
    cat "$scratch/said"
}

run_methods() {
    local csv=
    while (($#)); do
        case $1 in
        --csv) csv=$(in_caller_dir "${2:?--csv needs the name of a file}") ;;
        *) fail "methods does not know '$1'; see --help" ;;
        esac
        shift 2
    done
    need qemu-system-arm qemu-system-arm
    # One compiler for both: otherwise the charts compare compilers.
    if [[ -z ${SPANFILL_TOOLCHAIN:-} ]]; then
        SPANFILL_TOOLCHAIN=debian
        if rustup_provides thumbv7em-none-eabi && rustup_provides thumbv7em-none-eabihf; then SPANFILL_TOOLCHAIN=rustup; fi
    fi
    local target elf
    for target in thumbv7em-none-eabi thumbv7em-none-eabihf; do
        elf=$(build_firmware methods "$target" --features methods)
        [[ -n $elf ]] || fail "methods was not built for $target"
        echo "run.sh: counting on $target" >&2
        timeout 1800 qemu-system-arm -machine mps2-an386 -icount shift=0 -nographic \
            -semihosting-config enable=on,target=native -kernel "$elf" </dev/null >"$scratch/said" ||
            fail "the firmware failed: $(tail -n 5 "$scratch/said")"
        # The second table goes on where the first ends.
        if [[ -s $scratch/counts ]]; then sed 1d "$scratch/said"; else cat "$scratch/said"; fi >>"$scratch/counts"
    done
    if [[ -n $csv ]]; then cat "$scratch/counts" >"$csv"; else cat "$scratch/counts"; fi
}

# put_table_into FILE NAME: replaces what stands between its two markers of that name.
put_table_into() {
    local begin="<!-- $2:begin -->" end="<!-- $2:end -->"
    grep -qF "$begin" "$1" && grep -qF "$end" "$1" || fail "$1 has no lines $begin and $end"
    awk -v table="$scratch/table" -v begin="$begin" -v end="$end" '
        index($0, end) { skipping = 0 }
        !skipping { print }
        index($0, begin) { skipping = 1; print ""; while ((getline line < table) > 0) print line; print "" }
    ' "$1" >"$scratch/readme"
    cat "$scratch/readme" >"$1"
}

# --- Here it starts --------------------------------------------------------------------------------------------------

command=${1:---help}
shift || true
case $command in
-h | --help | help)
    usage
    exit
    ;;
build | oled | cycles | cycles_aa | attributes | cube3d | frame | methods) ;;
*) fail "there is no '$command'; see --help" ;;
esac

# Empty, or the QEMU that must not outlive this script.
qemu=
trap '[[ -z $qemu ]] || kill "$qemu" 2>/dev/null; rm -rf "$scratch"' EXIT

case $command in
build) build_everything ;;
oled) run_oled "$(in_caller_dir "${1:-oled.png}")" ;;
cycles | cycles_aa) run_cycles "$command" "$@" ;;
attributes) run_attributes "$@" ;;
cube3d) run_cube3d ;;
frame) run_frame ;;
methods) run_methods "$@" ;;
esac
