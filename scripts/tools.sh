# shellcheck shell=bash
# What the commands of `x` need beside Rust, Node and npm: found on the PATH in the right
# version, or installed once into a cache outside of the clone, a folder for each version.

readonly cache=${XDG_CACHE_HOME:-$HOME/.cache}/giveway
readonly wasm_target=wasm32-unknown-unknown
readonly wasm_pack_version=0.15.1
readonly rate_version=0.3.0
# The command must be of the very version of the library.
wasm_bindgen_version=$(sed -n '/^name = "wasm-bindgen"$/{n;s/^version = "\(.*\)"$/\1/p}' Cargo.lock)
readonly wasm_bindgen_version

# Says what begins. Where `times` names a file, the seconds that the last step took go there.
step() {
    note_time
    step_name=$* step_start=$SECONDS
    printf '\n==> %s\n' "$*"
}

note_time() {
    if [[ -n ${times:-} && -n ${step_name:-} ]]; then
        printf '%d\t%s\n' "$((SECONDS - step_start))" "$step_name" >>"$times"
    fi
    step_name=
}

fail() {
    printf 'x: %s\n' "$*" >&2
    exit 1
}

# Debian's packages, as root or through sudo.
install_packages() {
    step "Installing $* (apt-get)"
    local as_root=()
    if [[ $EUID -ne 0 ]]; then as_root=(sudo); fi
    "${as_root[@]}" apt-get update -qq || fail "apt-get update failed; install $* by hand"
    "${as_root[@]}" apt-get install -y -qq --no-install-recommends "$@" ||
        fail "apt-get could not install $*; install it by hand"
}

# The toolchain that rust-toolchain.toml names, with all of its parts. Nothing is
# downloaded where they are there already.
set_up_rust() {
    command -v cc >/dev/null || install_packages gcc libc6-dev
    command -v rustup >/dev/null || fail "rustup is missing: https://rustup.rs tells how to install it"
    local version installed
    version=$(sed -n 's/^channel = "\(.*\)"$/\1/p' rust-toolchain.toml)
    installed=$(rustup toolchain list)
    export RUSTUP_TOOLCHAIN=$version
    if [[ $'\n'$installed != *$'\n'"$version"-* && $'\n'$installed == *$'\n'stable-* ]]; then
        # The same version may go by the name of its channel.
        if [[ $(rustup run stable rustc --version) == "rustc $version "* ]]; then
            export RUSTUP_TOOLCHAIN=stable
        fi
    fi
    local parts part
    parts=$(RUSTUP_AUTO_INSTALL=0 rustup component list --installed --toolchain "$RUSTUP_TOOLCHAIN" 2>/dev/null || true)
    for part in rustc cargo rustfmt clippy "rust-std-$wasm_target"; do
        if [[ $'\n'$parts != *$'\n'"$part"* ]]; then
            step "Installing Rust $version with rustfmt, clippy and $wasm_target"
            rustup toolchain install "$RUSTUP_TOOLCHAIN" --no-self-update --profile minimal \
                --component rustfmt --component clippy --target "$wasm_target" ||
                fail "rustup could not install Rust $version"
            break
        fi
    done
}

# Two runs at once must not install the same thing: the second waits for the first.
lock_cache() {
    mkdir -p "$cache/tools"
    if command -v flock >/dev/null; then
        exec {cache_lock}>"$cache/lock"
        flock "$cache_lock"
    fi
}

unlock_cache() {
    if [[ -n ${cache_lock:-} ]]; then exec {cache_lock}>&-; fi
}

# install_tool PACKAGE VERSION OPTION... puts the commands of a package into the cache and
# onto the PATH: as somebody built them before (scripts/prebuilt.txt), else by
# `cargo install` with these options.
install_tool() {
    local package=$1 version=$2
    shift 2
    local home=$cache/tools/$package-$version
    if [[ ! -d $home ]]; then
        local why
        if why=$(node scripts/prebuilt.mjs "$package" "$version" "$home" 2>&1); then
            step "Fetched $package $version into $cache"
        else
            step "Building $package $version into $cache: some minutes, once (${why#prebuilt: })"
            # Little is gained by optimising a command that runs for a second, and much
            # time is lost. One folder for all, so that what they share is compiled once.
            rm -rf "$home.part"
            CARGO_TARGET_DIR=$cache/tools/build CARGO_PROFILE_RELEASE_OPT_LEVEL=1 \
                CARGO_PROFILE_RELEASE_LTO=off CARGO_PROFILE_RELEASE_CODEGEN_UNITS=16 \
                cargo install --quiet --locked --root "$home.part" "$@" ||
                fail "cargo could not install $package $version"
            mv "$home.part" "$home"
        fi
    fi
    PATH=$home/bin:$PATH
}

# cargo_tool COMMAND PACKAGE VERSION [OPTION...] finds a command in this version on the
# PATH, or installs it.
cargo_tool() {
    local command=$1 package=$2 version=$3
    shift 3
    if [[ ! -d $cache/tools/$package-$version ]]; then
        if [[ $("$command" --version 2>/dev/null) == "$command $version"* ]]; then return; fi
    fi
    install_tool "$package" "$version" --version "=$version" "$@" "$package"
}

# What makes of Wasm what a page loads: a part of wasm-bindgen's command, which takes three
# times as long to build. It is new where the version or its own source is.
bind_tool() {
    local source
    source=$(cat scripts/bind/Cargo.lock scripts/bind/src/*.rs | sha256sum | cut -c 1-8)
    install_tool giveway-bind "$wasm_bindgen_version-$source" --path scripts/bind
}

# Writes the tools that are there as archives into target/tools/, with their lines for
# scripts/prebuilt.txt, so that others need not build them.
publish_tools() {
    local machine home name package version file
    machine=$(node --print '`${process.platform}-${process.arch}`')
    mkdir -p target/tools
    for home in "$cache"/tools/*/; do
        name=$(basename "$home")
        if [[ ! -d $home/bin || ! $name =~ ^([a-z-]+)-([0-9].*)$ ]]; then continue; fi
        package=${BASH_REMATCH[1]} version=${BASH_REMATCH[2]} file=$name-$machine.tar.gz
        # Without owners and times, so that the same commands make the same archive.
        tar --sort=name --owner=0 --group=0 --numeric-owner --mtime=@0 -C "$home" -cf - bin | gzip -9n > "target/tools/$file"
        printf '%s %s %s %s %s\n' "$package" "$version" "$machine" "$(sha256sum "target/tools/$file" | cut -c 1-64)" "$file"
    done
}

# wasm-opt, and the drivers of the browsers for the end-to-end tests.
npm_packages() {
    local packages
    packages=$(cat package.json package-lock.json | sha256sum | cut -c 1-12)
    local home=$cache/tools/npm-$packages
    if [[ ! -d $home ]]; then
        step "Installing the packages of package-lock.json into $cache (npm)"
        rm -rf "$home.part"
        mkdir -p "$home.part"
        cp package.json package-lock.json "$home.part"
        npm ci --prefix "$home.part" --ignore-scripts --no-audit --no-fund --loglevel=error ||
            fail "npm could not install the packages of package-lock.json"
        mv "$home.part" "$home"
    fi
    PATH=$home/node_modules/.bin:$PATH
    export NODE_PATH=$home/node_modules
}

need_node() {
    [[ -n $(command -v node) && -n $(command -v npm) ]] ||
        fail "Node and npm are missing: https://nodejs.org tells how to install them (20 or later)"
    local major
    major=$(node --print 'process.versions.node.split(".")[0]')
    ((major >= 20)) || fail "found Node $(node --version), expected 20 or later"
}

# What serves the page to somebody who works on it.
set_up_serving() {
    set_up_rust
    need_node
    lock_cache
    bind_tool
    rm -rf "$cache/tools/build"
    unlock_cache
}

# What builds the page for a host.
set_up_page() {
    set_up_rust
    need_node
    lock_cache
    npm_packages
    bind_tool
    rm -rf "$cache/tools/build"
    unlock_cache
}

# The checker of somebody else that must accept the proofs of certificates.
set_up_checker() {
    need_node
    lock_cache
    cargo_tool rate rate "$rate_version"
    rm -rf "$cache/tools/build"
    unlock_cache
}

# A Python of its own with the packages of tests/requirements.txt. Where there is no Python,
# or no index of packages can be reached, $python is empty and the tests of its package are
# skipped.
set_up_python() {
    python=
    if ! python3 -c 'import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 10))' 2>/dev/null; then
        step "Without Python 3.10 or later with venv: the tests of its package are skipped"
        return
    fi
    local version list home
    version=$(python3 -c 'import sys; print("%d.%d" % sys.version_info[:2])')
    list=crates/giveway-python/tests/requirements.txt
    # A folder of its own beside the tools, since it cannot be moved or published.
    home=$cache/python/$version-$(cat "$list" "${list%/*}/optional.txt" | sha256sum | cut -c 1-12)
    lock_cache
    if [[ ! -e $home/whole ]]; then
        step "Installing the packages of $list into $cache (pip)"
        rm -rf "$home"
        mkdir -p "$cache/python"
        python3 -m venv "$home" || fail "python3 could not make a virtual environment"
        if "$home/bin/python" -m pip install --quiet --disable-pip-version-check -r "$list"; then
            # Not for every system and version of Python; tests say so where it is missing.
            "$home/bin/python" -m pip install --quiet --disable-pip-version-check -r "${list%/*}/optional.txt" ||
                step "pip could not install Ray: sweeps on a Ray cluster are not tested"
            touch "$home/whole"
        fi
    fi
    unlock_cache
    if [[ -e $home/whole ]]; then
        python=$home/bin/python
    else
        step "pip could not install the packages of $list: the tests of the package for Python are skipped"
    fi
}

# What opens it.
set_up_browser() {
    local missing=()
    command -v chromium >/dev/null || missing+=(chromium)
    command -v chromedriver >/dev/null || missing+=(chromium-driver)
    if ((${#missing[@]})); then install_packages "${missing[@]}"; fi
    set_up_other_browsers
}

# Firefox and WebKitGTK, in which the main flows run, too. Where one of them cannot be had,
# its tests are skipped, and what older browsers lack is tested in Chromium alone.
set_up_other_browsers() {
    install_browser firefox-esr firefox-esr
    install_browser WebKitWebDriver webkit2gtk-driver
    install_browser Xvfb xvfb
}

install_browser() {
    local command=$1 package=$2
    if ! command -v "$command" >/dev/null; then
        (install_packages "$package") || step "Without $package: its tests are skipped"
    fi
}

# What runs the tests of it.
set_up_tests() {
    set_up_page
    lock_cache
    cargo_tool wasm-bindgen wasm-bindgen-cli "$wasm_bindgen_version"
    cargo_tool wasm-pack wasm-pack "$wasm_pack_version"
    rm -rf "$cache/tools/build"
    unlock_cache
    set_up_checker
    set_up_python
    set_up_browser
}
