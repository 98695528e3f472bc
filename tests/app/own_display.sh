#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs a test on a display of its own: tests that run side by side would else cover each other's
# windows, and what is on the screen, the clipboard and the focus are the display's. Where there is no
# Xvfb, or it cannot start, the test has the display there is.
#
#   own_display.sh PROGRAM [ARGUMENT...]
set -u
command -v Xvfb >/dev/null || exec "$@"

folder=$(mktemp -d) || exit 1
server=
cleanUp() {
    [ -z "$server" ] || kill "$server" 2>/dev/null
    rm -rf "$folder"
}
trap cleanUp EXIT
trap 'exit 1' HUP INT TERM

# Xvfb chooses a free number itself and tells it when it is ready for programs.
Xvfb -displayfd 3 -screen 0 1600x1000x24 +extension GLX -noreset -nolisten tcp \
    3>"$folder/number" >"$folder/log" 2>&1 &
server=$!
until grep -qs . "$folder/number"; do
    if ! kill -0 "$server" 2>/dev/null; then
        echo "Xvfb did not start:" >&2
        cat "$folder/log" >&2
        [ -n "${DISPLAY:-}" ] || exit 1
        rm -rf "$folder"
        exec "$@"
    fi
    sleep 0.02
done
DISPLAY=":$(cat "$folder/number")"
rm -rf "$folder"
export DISPLAY
unset WAYLAND_DISPLAY XAUTHORITY
"$@"
