# SPDX-License-Identifier: GPL-3.0-or-later
# What the commands built from this project's sources have in common; sourced by each.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

# answer_help TOOL WORD...: prints the help that is stored in toolchain/help and ends, so that it
# needs nothing built. A test holds these files to what the programs print.
answer_help() {
    local tool=$1 word file
    shift
    [ $# -eq 0 ] && return
    for word; do
        case $word in
        --help | -h)
            file=$root/toolchain/help/$tool.txt
            [ -f "$root/toolchain/help/$tool-$1.txt" ] && file=$root/toolchain/help/$tool-$1.txt
            sed "s#@ROOT@#$root#g" "$file"
            exit 0
            ;;
        esac
    done
}

# run_tool TOOL PROGRAM WORD...: installs and builds what is missing, then becomes the program,
# whose output alone goes to standard output.
run_tool() {
    local tool=$1 program=$2
    shift 2
    answer_help "$tool" "$@"
    "$root/toolchain/setup" fly >&2
    "$root/toolchain/build" "host:$program" >&2
    exec "$root/build/host/$program" "$@"
}
