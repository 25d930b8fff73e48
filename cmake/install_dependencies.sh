#!/usr/bin/env bash
# Says which Debian 12 packages Aureole still needs and installs them.
#
#   cmake/install_dependencies.sh [--no-install] [--tests] [--format] [--docs]
#
#   --no-install  only check: exit 1 and name what is missing
#   --tests       also what ./test.sh needs (Vulkan validation layer, a browser, clang++, OGRE, the viewer's packages, a display in memory, what
#                 reads packages, manual pages and the headers' comments)
#   --format      also what the checks of format and habits need (clang-format 14, clang-tidy 14)
#   --docs        also what the documentation's site and its pictures are made with (mkdocs, doxygen, KaTeX, Pillow)
set -euo pipefail

packages=(
    g++ cmake ninja-build ccache python3                # build tools
    glslang-tools spirv-tools                           # kernels to validated SPIR-V
    libglm-dev libspdlog-dev libtbb-dev                 # core
    libvulkan-dev libvulkan-volk-dev                    # Vulkan backend, to build
    libvulkan1 mesa-vulkan-drivers                      # Vulkan backend, to run: loader and a device on every machine (lavapipe)
    libcli11-dev libtomlplusplus-dev nlohmann-json3-dev # application: command line, scenes, reports
    libopenexr-dev libpng-dev                           # application: images
    libzip-dev                                          # application: height maps in .npz
    python-matplotlib-data                              # application: the terrain of the demo
    doctest-dev                                         # tests
)
# The libraries of the report's charts. Where npm has come with another Node.js than Debian's, Debian's would not go with it.
command -v npm > /dev/null || packages+=(npm)

install=yes
for argument in "$@"; do
    case "$argument" in
        --no-install) install=no ;;
        --tests)
            packages+=(vulkan-validationlayers chromium)
            packages+=(clang libclang-rt-14-dev)                             # sanitizers and libFuzzer
            packages+=(dpkg-dev pkg-config man-db)                           # what reads packages and manual pages
            packages+=(doxygen)                                              # what reads the public headers' comments
            packages+=(libglfw3-dev xvfb xauth)                              # samples with windows
            packages+=(libimgui-dev)                                         # samples/viewer
            packages+=(libepoxy-dev libogre-1.12-dev libegl1 libgl1-mesa-dri) # samples/ogre
            ;;
        --format) packages+=(clang-format-14 clang-tidy-14) ;;
        --docs) packages+=(mkdocs mkdocs-material mkdocs-material-extensions python3-pymdownx doxygen libjs-katex fonts-katex python3-pil) ;;
        *) echo "install_dependencies.sh: unknown option $argument; allowed: --no-install --tests --format --docs" >&2; exit 2 ;;
    esac
done

if ! command -v dpkg-query > /dev/null; then
    echo "Packages: not a Debian system, so nothing was checked. CMake will say what it cannot find; docs/building.md lists it all."
    exit 0
fi

missing=()
for package in "${packages[@]}"; do
    # A line for each architecture that the package is known for; one of them is enough.
    dpkg-query -W -f '${db:Status-Status}\n' "$package" 2> /dev/null | grep -x installed > /dev/null || missing+=("$package")
done

if [ ${#missing[@]} = 0 ]; then
    echo "Packages: all ${#packages[@]} are installed."
    exit 0
fi
if [ $install = no ]; then
    echo "Packages: missing ${missing[*]}" >&2
    echo "Install them with: apt-get install ${missing[*]}" >&2
    exit 1
fi

as_root=()
if [ "$(id -u)" != 0 ]; then
    if ! command -v sudo > /dev/null; then
        echo "Packages: missing ${missing[*]}" >&2
        echo "Neither root nor sudo here. Have them installed with: apt-get install ${missing[*]}" >&2
        exit 1
    fi
    as_root=(sudo)
fi
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3)

echo "Packages: installing ${missing[*]}"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
# A machine whose package lists are complete enough installs without asking the network for new ones.
if ! "${apt[@]}" install --no-install-recommends "${missing[@]}" < /dev/null > "$log" 2>&1; then
    if ! { "${apt[@]}" update && "${apt[@]}" install --no-install-recommends "${missing[@]}"; } < /dev/null > "$log" 2>&1; then
        cat "$log" >&2
        echo "Packages: apt could not install ${missing[*]} (its messages are above)." >&2
        exit 1
    fi
fi
echo "Packages: installed."
