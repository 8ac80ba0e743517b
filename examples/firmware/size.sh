#!/usr/bin/env bash
# Measures what each capability costs a firmware in flash, RAM and stack. See --help.
set -euo pipefail

usage() {
    cat <<'END'
Measures what each capability costs a firmware in flash, RAM and stack: bytes beyond a program that draws nothing, by the
sections of what was linked (fat link-time optimization, one codegen unit).

Usage: examples/firmware/size.sh [--check] [GROUP...]

Groups, all of them by default:
  shapes    Each shape with and without anti-aliasing, some together, and all; embedded-graphics' where it has them.
            Cortex-M0+ (thumbv6m), optimized for size.
  fast      The same, Cortex-M4 (thumbv7em) at level 3, and the stack that drawing takes, measured in QEMU.
  plug-in   embedded-graphics' primitives, filled and stroked: by embedded-graphics, by spanfill's styles, and by those with
            anti-aliasing. Cortex-M0+, for size.
  blends    An anti-aliased circle by each way to mix. Cortex-M0+, for size.
  methods   Each family of the methods of the literature, whole. Cortex-M0+, for size.

Without --check, the rows of these groups in docs/charts/flash.csv are replaced, and docs/charts/flash.svg is drawn anew.

Options:
  --check   Writes nothing. Fails when a number is more than 5 % from the one in docs/charts/flash.csv, or is not there.

Environment: SPANFILL_TOOLCHAIN, CARGO_TARGET_DIR and CI, as for run.sh.

Whatever could not be built or run is a failure.
END
}

source "$(dirname "${BASH_SOURCE[0]}")/toolchain.sh"

TABLE=docs/charts/flash.csv
HEADER="group,capability,library,target,opt_level,flash,ram,stack,compiler"
FOUR="triangle line circle polygon"
FOUR_AA="triangle-aa line-aa circle-aa polygon-aa"
THREE_OF_THEIRS="theirs-triangle-filled theirs-line-thin theirs-circle-filled"

# --- What is measured ------------------------------------------------------------------------------------------------

# Each line: capability | library | the words of size.rs.
shapes() {
    local shape
    for shape in $FOUR; do
        echo "$shape|spanfill|$shape"
        echo "$shape|spanfill, anti-aliased|$shape-aa"
    done
    echo "all four|spanfill|$FOUR"
    echo "all four|spanfill, anti-aliased|$FOUR_AA"
    echo "all eight|spanfill|$FOUR $FOUR_AA"
    echo "triangle, line, circle|spanfill|triangle line circle"
    echo "seed fill|spanfill|seed-fill"
    echo "triangle|embedded-graphics|theirs-triangle-filled"
    echo "line|embedded-graphics|theirs-line-thin"
    echo "circle|embedded-graphics|theirs-circle-filled"
    echo "triangle, line, circle|embedded-graphics|$THREE_OF_THEIRS"
}

plug_in() {
    local primitives="rectangle rounded-rectangle circle ellipse triangle line polyline arc sector"
    local primitive library words
    for primitive in $primitives; do
        echo "$primitive|embedded-graphics|theirs-$primitive"
        echo "$primitive|spanfill|plug-in-$primitive"
        echo "$primitive|spanfill, anti-aliased|plug-in-aa-$primitive"
    done
    while IFS='|' read -r library words; do
        echo "all nine|$library|$(for primitive in $primitives; do printf '%s ' "$words-$primitive"; done)"
    done <<<"embedded-graphics|theirs
spanfill|plug-in
spanfill, anti-aliased|plug-in-aa"
}

blends() {
    echo "Over|spanfill, anti-aliased|circle-aa"
    echo "Over, with opacity|spanfill, anti-aliased|blend-opacity"
    echo "ReadBack|spanfill, anti-aliased|blend-read-back"
    echo "InPlace|spanfill, anti-aliased|blend-in-place"
    echo "Dither|spanfill, anti-aliased|blend-dither"
    echo "Linear(Over)|spanfill, anti-aliased|blend-linear"
}

# Every family that size_methods.rs draws.
methods() {
    local family
    while read -r family; do
        echo "$family|methods|methods-$family"
    done < <(sed -n 's/.*draws("methods-\([^"]*\)").*/\1/p' examples/firmware/size_methods.rs)
}

# --- Measuring -------------------------------------------------------------------------------------------------------

# build TARGET LEVEL WORDS: prints the name of the ELF file.
build() {
    # Memory is as large as it has to be: what does not fit a board is to be measured, too.
    SPANFILL_SIZE=$3 build_firmware size "$1" --quiet --features embedded-graphics,methods \
        --config 'profile.release.lto="fat"' --config "profile.release.opt-level=$2" \
        -- -C link-arg=--defsym=_flash_length=4M -C link-arg=--defsym=_ram_length=4M
}

# section_bytes ELF SECTION...: the bytes of these sections.
section_bytes() {
    local elf=$1 sum=0 name size
    shift
    # Number, name, type, address, offset, size.
    while read -r name size; do
        [[ " $* " != *" $name "* ]] || sum=$((sum + 16#$size))
    done < <(readelf --sections --wide "$elf" | sed -n 's/^ *\[ *[0-9]*\] \(\.[^ ]*\) *[A-Z_]* *[0-9a-f]* [0-9a-f]* \([0-9a-f]*\) .*/\1 \2/p')
    echo "$sum"
}

flash_of() {
    section_bytes "$1" .text .rodata .data
}

ram_of() {
    section_bytes "$1" .data .bss
}

# stack_of TARGET LEVEL WORDS: how deep the stack goes.
stack_of() {
    local elf
    elf=$(build "$1" "$2" "stack $3")
    timeout 60 qemu-system-arm -machine mps2-an386 -nographic -semihosting-config enable=on,target=native \
        -kernel "$elf" </dev/null >"$scratch/said" || fail "the firmware failed: $(cat "$scratch/said")"
    sed -n 's/^stack //p' "$scratch/said"
}

compiler_of() {
    readelf --string-dump .comment "$1" | sed -n 's/.*rustc version \([^ ]*\).*/\1/p' | head -n 1
}

# measure GROUP TARGET LEVEL: reads what is to be measured, prints rows.
measure() {
    local group=$1 target=$2 level=$3 capability library words elf empty_elf flash ram stack empty_stack
    empty_elf=$scratch/empty
    elf=$(build "$target" "$level" "")
    [[ -n $elf ]] || fail "the empty program could not be built for $target"
    cp "$elf" "$empty_elf"
    [[ $group != fast ]] || empty_stack=$(stack_of "$target" "$level" "")
    while IFS='|' read -r capability library words; do
        echo "${0##*/}: $group, $capability, $library" >&2
        elf=$(build "$target" "$level" "$words")
        [[ -n $elf ]] || fail "$words could not be built for $target"
        flash=$(($(flash_of "$elf") - $(flash_of "$empty_elf")))
        ram=$(($(ram_of "$elf") - $(ram_of "$empty_elf")))
        local compiler
        compiler=$(compiler_of "$elf")
        stack=
        if [[ $group == fast ]]; then
            stack=$(($(stack_of "$target" "$level" "$words") - empty_stack))
        fi
        echo "$group,\"$capability\",\"$library\",$target,${level//\"/},$flash,$ram,$stack,$compiler"
    done
}

measure_group() {
    case $1 in
    shapes) shapes | measure shapes thumbv6m-none-eabi '"s"' ;;
    fast) shapes | measure fast thumbv7em-none-eabi 3 ;;
    plug-in) plug_in | measure plug-in thumbv6m-none-eabi '"s"' ;;
    blends) blends | measure blends thumbv6m-none-eabi '"s"' ;;
    methods) methods | measure methods thumbv6m-none-eabi '"s"' ;;
    esac
}

# --- Comparing -------------------------------------------------------------------------------------------------------

# check NEW: every row of it is in the table, and its numbers are within 5 % (or 32 bytes).
check() {
    awk -v table="$TABLE" '
        # Fields between commas that are not quoted.
        function split_row(row, fields,    quoted, i, c, n) {
            n = 1; fields[1] = ""; quoted = 0
            for (i = 1; i <= length(row); i++) {
                c = substr(row, i, 1)
                if (c == "\"") quoted = !quoted
                else if (c == "," && !quoted) fields[++n] = ""
                else fields[n] = fields[n] c
            }
            return n
        }
        function name(fields) { return fields[1] ", " fields[2] ", " fields[3] ", " fields[4] " at " fields[5] }
        function compare(what, new, old, of,    off) {
            off = new - old
            if (off < 0) off = -off
            if (off > 32 && off * 20 > old + 0) { print of ": " what " was " old ", is " new; failed = 1 }
        }
        BEGIN {
            while ((getline row < table) > 0) { split_row(row, f); known[name(f)] = row }
        }
        {
            split_row($0, new)
            if (!(name(new) in known)) { print name(new) ": not in " table; failed = 1; next }
            split_row(known[name(new)], old)
            compare("flash", new[6], old[6], name(new))
            compare("RAM", new[7], old[7], name(new))
            compare("stack", new[8], old[8], name(new))
            if (new[9] != old[9] && !told[new[9]]++) print "the table is by rustc " old[9] ", this is " new[9]
            rows++
        }
        END {
            if (!rows) { print "nothing was measured"; failed = 1 }
            exit failed
        }
    ' "$1" >&2 || fail "not what $TABLE says; examples/firmware/size.sh writes it anew"
    echo "${0##*/}: $(wc -l <"$1") measurements are within 5 % of $TABLE" >&2
}

# merge NEW GROUP...: the table with the rows of these groups replaced, in the order of all groups.
merge() {
    local new=$1 group
    shift
    {
        echo "$HEADER"
        for group in "${GROUPS_OF_ALL[@]}"; do
            if [[ " $* " == *" $group "* ]]; then
                grep "^$group," "$new"
            elif [[ -e $TABLE ]]; then
                grep "^$group," "$TABLE" || true
            fi
        done
    } >"$scratch/table"
    mkdir -p "$(dirname "$TABLE")"
    cp "$scratch/table" "$TABLE"
}

# --- Here it starts --------------------------------------------------------------------------------------------------

GROUPS_OF_ALL=(shapes fast plug-in blends methods)
checking=
groups=()
for argument in "$@"; do
    case $argument in
    -h | --help | help)
        usage
        exit
        ;;
    --check) checking=yes ;;
    shapes | fast | plug-in | blends | methods) groups+=("$argument") ;;
    *) fail "there is no '$argument'; see --help" ;;
    esac
done
((${#groups[@]})) || groups=("${GROUPS_OF_ALL[@]}")
need readelf binutils
[[ " ${groups[*]} " != *" fast "* ]] || need qemu-system-arm qemu-system-arm

: >"$scratch/new"
for group in "${groups[@]}"; do
    measure_group "$group" >>"$scratch/new"
done
if [[ -n $checking ]]; then
    check "$scratch/new"
else
    merge "$scratch/new" "${groups[@]}"
    cargo run --quiet --release --example flash_chart -- "$TABLE" docs/charts/flash.svg
fi
