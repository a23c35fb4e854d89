# shellcheck shell=bash
# The commands of `x` about what is published: docs/release.md tells how.

readonly deny_version=0.20.2
# The crates that are published, in dependency order.
readonly published=(giveway-model giveway-formats giveway-picture giveway-proof giveway-planners giveway-order giveway-solve giveway-sweep giveway-course giveway-cli)

# Versions, what crates hold, licences, workflows: some seconds, nothing is built.
test_release() {
    step "Tests: what is published"
    node --test tests/release/*.test.mjs
}

# The crates as somebody else gets them: packed, unpacked, and built from nothing else.
test_packaging() {
    step "Packing the published crates and building them from that (some minutes)"
    # One folder for all five, so that what they share is compiled once.
    CARGO_TARGET_DIR=target/packed cargo package --locked --allow-dirty "${published[@]/#/--package=}"
}

# The package for Python as pip gets it where there is no wheel: packed, installed into a new
# environment, and asked for a plan.
test_python_sources() {
    if [[ -z $python ]]; then return; fi
    step "Packing the sources of the package for Python, and installing them (some minutes)"
    node scripts/release/wheel.mjs sdist
}

# Licences, sources and known faults of all that is depended on, in Rust and for tools.
audit_dependencies() {
    lock_cache
    cargo_tool cargo-deny cargo-deny "$deny_version"
    rm -rf "$cache/tools/build"
    unlock_cache
    step "Dependencies: licences, sources, advisories"
    node scripts/release/audit.mjs
}
