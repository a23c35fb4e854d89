# shellcheck shell=bash
# What the commands of `x` need beside Rust, Node and npm: found on the PATH in the right
# version, or installed once into a cache outside of the clone, a folder for each version.

readonly cache=${XDG_CACHE_HOME:-$HOME/.cache}/giveway
readonly wasm_target=wasm32-unknown-unknown
readonly trunk_version=0.21.14
readonly wasm_pack_version=0.15.1
readonly rate_version=0.3.0
# The command must be of the very version of the library.
wasm_bindgen_version=$(sed -n '/^name = "wasm-bindgen"$/{n;s/^version = "\(.*\)"$/\1/p}' Cargo.lock)
readonly wasm_bindgen_version

step() { printf '\n==> %s\n' "$*"; }

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

# cargo_tool COMMAND PACKAGE VERSION [OPTION...]
cargo_tool() {
    local command=$1 package=$2 version=$3
    shift 3
    local home=$cache/tools/$package-$version
    if [[ ! -d $home ]]; then
        if [[ $("$command" --version 2>/dev/null) == "$command $version"* ]]; then return; fi
        step "Installing $package $version into $cache (some minutes, once)"
        # Little is gained by optimising a command that runs for a second, and much
        # time is lost. One folder for all, so that what they share is compiled once.
        rm -rf "$home.part"
        CARGO_TARGET_DIR=$cache/tools/build CARGO_PROFILE_RELEASE_OPT_LEVEL=1 \
            CARGO_PROFILE_RELEASE_LTO=off CARGO_PROFILE_RELEASE_CODEGEN_UNITS=16 \
            cargo install --quiet --locked --root "$home.part" --version "=$version" "$@" "$package" ||
            fail "cargo could not install $package $version"
        mv "$home.part" "$home"
    fi
    PATH=$home/bin:$PATH
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

# What builds the page.
set_up_page() {
    set_up_rust
    need_node
    lock_cache
    npm_packages
    cargo_tool trunk trunk "$trunk_version"
    cargo_tool wasm-bindgen wasm-bindgen-cli "$wasm_bindgen_version"
    rm -rf "$cache/tools/build"
    unlock_cache
}

# The checker of somebody else that must accept the proofs of certificates.
set_up_checker() {
    lock_cache
    cargo_tool rate rate "$rate_version"
    rm -rf "$cache/tools/build"
    unlock_cache
}

# What opens it.
set_up_browser() {
    local missing=()
    command -v chromium >/dev/null || missing+=(chromium)
    command -v chromedriver >/dev/null || missing+=(chromium-driver)
    if ((${#missing[@]})); then install_packages "${missing[@]}"; fi
    set_up_other_browsers
}

# Firefox and WebKitGTK, in which the main flows run, too. Where they cannot be had, those
# tests are skipped, and what older browsers lack is tested in Chromium alone.
set_up_other_browsers() {
    local missing=()
    command -v firefox-esr >/dev/null || missing+=(firefox-esr)
    command -v WebKitWebDriver >/dev/null || missing+=(webkit2gtk-driver)
    command -v Xvfb >/dev/null || missing+=(xvfb)
    if ((${#missing[@]})); then
        (install_packages "${missing[@]}") || step "Without ${missing[*]}: their tests are skipped"
    fi
}

# What runs the tests of it.
set_up_tests() {
    set_up_page
    lock_cache
    cargo_tool wasm-pack wasm-pack "$wasm_pack_version"
    rm -rf "$cache/tools/build"
    unlock_cache
    set_up_checker
    set_up_browser
}
