#!/usr/bin/env bash
# Builds the documentation as a site that opens from a disk, without a network: docs/build.sh [--out DIR] [--no-install]
set -euo pipefail
caller=$PWD
cd "$(dirname "${BASH_SOURCE[0]}")/.."

out=$PWD/build/site
install_options=(--docs)
while [ $# -gt 0 ]; do
    case "$1" in
        --no-install) install_options+=(--no-install) ;;
        --out)
            [ $# -ge 2 ] && [ -n "$2" ] || { echo "build.sh: --out needs a folder" >&2; exit 2; }
            out=$2
            [[ $out == /* ]] || out=$caller/$out
            shift ;;
        -h | --help) echo "usage: docs/build.sh [--out DIR] [--no-install]     DIR: build/site by default"; exit 0 ;;
        *) echo "build.sh: unknown option $1; allowed: --out DIR, --no-install" >&2; exit 2 ;;
    esac
    shift
done
# mkdocs empties the folder.
if [ -n "$(ls -A "$out" 2> /dev/null)" ] && [ ! -f "$out/theme/equations.js" ]; then
    echo "build.sh: $out holds something else than a site; name an empty folder, or a new one" >&2
    exit 2
fi
cmake/install_dependencies.sh "${install_options[@]}"

started=$SECONDS
stage=$PWD/build/site_pages
python3 -B tests/docs/links_test.py "$PWD"
python3 -B docs/site/gather.py . "$stage"

# Equations are rendered by KaTeX, in the page; only the fonts that every browser takes.
katex=/usr/share/javascript/katex
mkdir -p "$stage/theme/katex/fonts"
cp "$katex/katex.min.js" "$katex/katex.min.css" "$stage/theme/katex/"
cp -L "$katex"/fonts/*.woff2 "$stage/theme/katex/fonts/"

mkdir -p "$stage/api"
version=$(sed -n 's/^project(aureole VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
(cat docs/site/Doxyfile; echo "OUTPUT_DIRECTORY = $stage/api"; echo "PROJECT_NUMBER = $version") | doxygen -
python3 -B docs/site/undocumented.py --xml "$stage/api/xml"
rm -r "$stage/api/xml"

AUREOLE_SITE_STAGE=$stage AUREOLE_SITE_OUT=$out PYTHONPATH=docs/site PYTHONDONTWRITEBYTECODE=1 mkdocs build --strict --quiet --clean \
    --config-file docs/site/mkdocs.yml
rm -f "$out/404.html"  # for servers: its links begin at the root of one
python3 -B docs/site/check.py "$out"
node docs/site/equations.cjs "$katex/katex.min.js" "$out"
echo "$out/index.html, in $((SECONDS - started)) s"
