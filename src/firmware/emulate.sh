#!/bin/sh
# emulate.sh MACHINE IMAGE NUMBER [QEMU OPTIONS...]: runs an image with a number as its argument (frames, states), prints
# what it writes and returns its exit status. No more than 30 minutes.
machine=$1
image=$2
number=$3
shift 3
exec timeout 1800 qemu-system-arm -M "$machine" -nographic -monitor none -serial none \
    -semihosting-config "enable=on,target=native,arg=image,arg=$number" "$@" -kernel "$image" 2>&1
