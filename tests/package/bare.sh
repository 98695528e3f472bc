#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The packages on a fresh Debian that has nothing else: they install with what they depend on, the program
# works without and with a window, the Python module and the add-on for Blender (where they are built) and the
# library for other programs, and once they are purged nothing of them is left but what is the user's.
# Needs root, mmdebstrap and a mirror, that of this system; minutes.
#
#   bare.sh FOLDER      with the packages that `./run.sh --package` has made
#   BASE=FILE.tar       a system of an earlier run, or where this run is to keep its own
set -euo pipefail
packages=$(cd "$1" && pwd)
here=$(cd "$(dirname "$0")" && pwd)
samples=$here/../../resources/samples

# Mounts are this script's own, and gone with it.
if [ -z "${TOILE_BARE:-}" ]; then
    TOILE_BARE=1 exec unshare --mount --pid --fork --kill-child "$0" "$@"
fi

work=$(mktemp -d)
system=$work/system
cleanUp() {
    umount -R "$system/proc" "$system/dev" 2>/dev/null || true
    rm -rf --one-file-system "$work"
}
trap cleanUp EXIT

# Debian's own sources of this system, in either form, whatever else it has.
sources() {
    local file
    for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.{list,sources}; do
        ! grep -qs 'bookworm' "$file" || ! grep -qsE '(://|[./])debian' "$file" || echo "$file"
    done
}

within() { # COMMAND...: in the system, as root, in no language, without the settings of this shell
    env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
        ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} \
        chroot "$system" "$@"
}
as_user() {
    within setpriv --reuid=1000 --regid=1000 --clear-groups env HOME=/home/sewer \
        ${runtime:+XDG_RUNTIME_DIR="$runtime"} "$@"
}
fail() {
    echo "bare: $*" >&2
    exit 1
}
# Every path but what the system itself writes while packages come and go.
files() {
    (cd "$system" && find . -xdev \( -path ./proc -o -path ./dev -o -path ./tmp -o -path ./packages \
        -o -path ./var/cache -o -path ./var/log -o -path ./var/lib/apt -o -path ./var/lib/dpkg \) -prune \
        -o -print | sort)
}

base=${BASE:-$work/base.tar}
if [ ! -s "$base" ]; then
    echo "== A bare Debian"
    mapfile -t given < <(sources)
    mmdebstrap --quiet --variant=apt bookworm "$base" "${given[@]}"
fi
mkdir "$system"
tar -C "$system" -xf "$base" --exclude='./dev/*'
mount -t proc proc "$system/proc"
mount --rbind /dev "$system/dev"
mount --make-rslave "$system/dev"
cp /etc/resolv.conf "$system/etc/resolv.conf"

echo "== What a desktop has: a display, and places that know of programs"
within apt-get update -qq
within apt-get install -y -qq --no-install-recommends xvfb xauth shared-mime-info desktop-file-utils \
    hicolor-icon-theme man-db libglib2.0-bin fonts-dejavu-core >/dev/null 2>&1
within useradd --create-home --uid 1000 sewer
runtime=$(as_user mktemp -d)
mkdir -p "$system/home/sewer/patterns" "$system/packages"
cp "$samples/tshirt.obj" "$samples/cap.obj" "$here/../data/sample.toile" "$system/home/sewer/patterns"
chown -R 1000:1000 "$system/home/sewer"
cp "$packages"/*.deb "$system/packages"
ours=(toile libtoile-dev)
! compgen -G "$packages/python3-toile_*.deb" >/dev/null || ours+=(python3-toile)
! compgen -G "$packages/toile-blender_*.deb" >/dev/null || ours+=(toile-blender)
install_ours() { # PACKAGE [OTHER...], saying why not
    within sh -c 'p=$1; shift; apt-get install -y -qq --no-install-recommends /packages/"$p"_*.deb "$@"' \
        install "$@" >"$work/apt" 2>&1 || { cat "$work/apt"; fail "$1 does not install"; }
    within dpkg -L "$1" >>"$work/listed"
}
files >"$work/before"

echo "== Installed by apt, with what it depends on"
install_ours toile
echo "$(within dpkg-query -W -f='${Package} ${Version}, ${Installed-Size} kB' toile), with $(
    grep -c '^Setting up' "$work/apt") packages"

echo "== The program, without a window"
as_user toile --version
as_user sh -c 'cd ~/patterns && toile flatten tshirt.obj --unit mm -o tshirt.svg -o tshirt.dxf -o tshirt.pdf' |
    tail -n 1
for made in tshirt.svg tshirt.dxf tshirt.pdf; do
    [ -s "$system/home/sewer/patterns/$made" ] || fail "$made is not there"
done
within readlink -f /etc/alternatives/libblas.so.3-x86_64-linux-gnu | grep -q openblas ||
    fail "the BLAS is a slow one"
as_user man -w toile >/dev/null || fail "there is no manual page"

echo "== Pictures: a thumbnail as file managers ask for it, and the window on a display"
as_user sh -c 'cd ~/patterns && toile render tshirt.obj -o thumbnail --thumbnail 128'
as_user sh -c 'cd ~/patterns && gio info -a standard::content-type sample.toile tshirt.obj' |
    grep content-type | tr -d '\n'
echo
as_user sh -c 'cd ~/patterns && xvfb-run -a -s "-screen 0 1400x900x24" toile tshirt.obj --unit mm --screenshot window.png'
as_user sh -c 'cd ~ && xvfb-run -a -s "-screen 0 1400x900x24" toile --screenshot patterns/welcome.png'
for made in thumbnail window.png welcome.png; do
    head -c 8 "$system/home/sewer/patterns/$made" | cmp -s - <(printf '\x89PNG\r\n\x1a\n') ||
        fail "$made is no picture"
done
[ -z "${KEEP:-}" ] || cp "$system"/home/sewer/patterns/*.png "$KEEP"

if [[ " ${ours[*]} " == *" python3-toile "* ]]; then
    echo "== The Python module"
    install_ours python3-toile
    as_user sh -c "cd ~/patterns && python3 -c '
import toile
flat = toile.load(\"tshirt.obj\", unit=\"mm\").flatten()
assert sum(seam.right_length is not None for seam in flat.seams) == 14
assert all(abs(seam.error or 0) < 1e-6 for seam in flat.seams)
print(toile.__file__)'" || fail "the Python module flattens nothing"
fi

if [[ " ${ours[*]} " == *" toile-blender "* ]]; then
    echo "== The add-on for Blender, packed and installed as docs/blender.md says"
    install_ours toile-blender
    as_user python3 /usr/share/toile/blender/make_zip.py /home/sewer/patterns/toile-blender.zip
    as_user blender --background --factory-startup --python-exit-code 1 --python-expr "if True:
        import bpy
        bpy.ops.preferences.addon_install(filepath='/home/sewer/patterns/toile-blender.zip')
        bpy.ops.preferences.addon_enable(module='toile_blender')
        bpy.ops.mesh.primitive_grid_add()
        assert bpy.ops.toile.flatten() == {'FINISHED'}, bpy.context.scene.toile.said
        assert 'Toile' in bpy.context.object.data.uv_layers" >"$work/blender" 2>&1 ||
        { cat "$work/blender"; fail "the add-on flattens nothing"; }
fi

echo "== The library, in another program"
install_ours libtoile-dev g++ cmake make
cp -r "$here/consumer" "$system/home/sewer/consumer"
chown -R 1000:1000 "$system/home/sewer/consumer"
as_user sh -c 'cd ~ && cmake -S consumer -B made && cmake --build made' >"$work/made" 2>&1 ||
    { cat "$work/made"; fail "nothing can be built with the library"; }
as_user sh -c '~/made/consumer ~/patterns/tshirt.obj' | tail -n 1
rm -r "$system/home/sewer/made" "$system/home/sewer/consumer"

echo "== Purged"
(cd "$system/home/sewer" && find . -type f -exec sha256sum {} + | sort) >"$work/own"
within apt-get purge -y -qq "${ours[@]}" g++ cmake make >/dev/null 2>&1
within apt-get autoremove --purge -y -qq >/dev/null 2>&1
files >"$work/after"
(cd "$system/home/sewer" && find . -type f -exec sha256sum {} + | sort) | cmp - "$work/own" ||
    fail "what is the user's own has changed"
[ -s "$work/own" ] || fail "the user has nothing"
# Of the package itself nothing; of all that came with it, nothing that names it.
while IFS= read -r path; do
    [ ! -e "$system$path" ] || [ -d "$system$path" ] || echo "$path"
done <"$work/listed" >"$work/left"
comm -13 "$work/before" "$work/after" | grep -v '^./home/sewer' | grep -i toile >>"$work/left" || true
[ ! -s "$work/left" ] || fail "left behind: $(cat "$work/left")"
comm -13 "$work/before" "$work/after" | grep -v '^./home/sewer' >"$work/others" || true
[ ! -s "$work/others" ] || { echo "Left by what it depends on:"; cat "$work/others"; }
comm -23 "$work/before" "$work/after" >"$work/lost" || true
[ ! -s "$work/lost" ] || fail "gone that was there before: $(cat "$work/lost")"
echo "== Passed: nothing is left but $(wc -l <"$work/own") files of the user's own"
