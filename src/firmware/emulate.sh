#!/bin/sh
# emulate.sh MACHINE IMAGE [QEMU OPTIONS...]: runs an image, prints what it writes; its exit status. No more than 30 minutes.
machine=$1
image=$2
shift 2
exec timeout 1800 qemu-system-arm -M "$machine" -nographic -monitor none -serial none \
    -semihosting-config enable=on,target=native "$@" -kernel "$image" 2>&1
