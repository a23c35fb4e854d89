//! Who may know whom.

use super::{BROWSER, expect_none, fs, source, under, uses};

/// The crates in the order of the workspace, with what each depends on.
fn crates() -> Vec<(String, Vec<String>)> {
    let read = |path: &str| {
        let text = fs::read_to_string(source::root().join(path)).unwrap();
        text.parse::<toml::Table>().unwrap()
    };
    let workspace = read("Cargo.toml");
    let members = workspace["workspace"]["members"].as_array().unwrap();
    let mut crates = Vec::new();
    for member in members {
        let manifest = read(&format!("{}/Cargo.toml", member.as_str().unwrap()));
        let name = manifest["package"]["name"].as_str().unwrap();
        crates.push((name.to_owned(), dependencies(&manifest)));
    }
    crates
}

/// The names in every table of dependencies, those for some targets too.
fn dependencies(manifest: &toml::Table) -> Vec<String> {
    let mut names = Vec::new();
    for (key, value) in manifest {
        match value.as_table() {
            Some(table) if key.ends_with("dependencies") => {
                names.extend(table.keys().cloned());
            }
            Some(table) if key == "target" => {
                let targets = table.values().filter_map(toml::Value::as_table);
                names.extend(targets.flat_map(dependencies));
            }
            _ => {}
        }
    }
    names
}

#[test]
fn a_crate_depends_only_on_those_before_it() {
    let crates = crates();
    let mut complaints = Vec::new();
    for (i, (name, dependencies)) in crates.iter().enumerate() {
        for (later, _) in &crates[i..] {
            if dependencies.contains(later) {
                complaints.push(format!("{name} depends on {later}"));
            }
        }
    }
    expect_none(&complaints);
}

#[test]
fn no_front_is_depended_on_but_by_the_tests() {
    // The page and its worker share the messages of the Wasm package.
    let allowed = [("giveway-web", "giveway-wasm")];
    let mut complaints = Vec::new();
    for (name, dependencies) in crates() {
        for front in [
            "giveway-cli",
            "giveway-web",
            "giveway-wasm",
            "giveway-python",
        ] {
            let excused = name == "giveway-tests" || allowed.contains(&(name.as_str(), front));
            if !excused && dependencies.iter().any(|d| d == front) {
                complaints.push(format!("{name} depends on {front}"));
            }
        }
    }
    expect_none(&complaints);
}

#[test]
fn nothing_below_a_front_depends_on_what_only_fronts_need() {
    let mut complaints = Vec::new();
    let crates = crates();
    for layer in [
        "giveway-model",
        "giveway-formats",
        "giveway-picture",
        "giveway-proof",
        "giveway-planners",
        "giveway-order",
        "giveway-solve",
        "giveway-page",
        "giveway-course",
    ] {
        let (_, dependencies) = crates.iter().find(|(name, _)| name == layer).unwrap();
        for front in [
            "web-sys",
            "js-sys",
            "wasm-bindgen",
            "yew",
            "gloo",
            "clap",
            "pyo3",
        ] {
            if dependencies.iter().any(|d| d == front) {
                complaints.push(format!("{layer} depends on {front}"));
            }
        }
    }
    expect_none(&complaints);
}

#[test]
fn only_the_solver_depends_on_a_sat_solver() {
    let mut complaints = Vec::new();
    for (name, dependencies) in crates() {
        let knows = dependencies.iter().any(|d| d.starts_with("varisat"));
        let allowed = ["giveway-solve", "giveway-proof", "giveway-tests"];
        if knows && !allowed.contains(&name.as_str()) {
            complaints.push(format!("{name} depends on varisat"));
        }
    }
    expect_none(&complaints);
}

#[test]
fn model_and_formats_do_no_io() {
    let io = [
        "std::fs",
        "std::io",
        "std::net",
        "std::env",
        "std::process",
        "std::thread",
        "std::time",
    ];
    for source in ["crates/giveway-model/src", "crates/giveway-formats/src"] {
        expect_none(&uses(source, &[], &io));
        expect_none(&uses(source, &[], BROWSER));
    }
}

#[test]
fn model_and_formats_know_no_solver() {
    let solver = ["varisat", "giveway_solve"];
    expect_none(&uses("crates/giveway-model", &[], &solver));
    expect_none(&uses("crates/giveway-formats", &[], &solver));
}

#[test]
fn pictures_know_no_surroundings_and_no_solver() {
    let surroundings = [
        "std::fs",
        "std::env",
        "std::process",
        "std::thread",
        "std::time",
        "giveway_solve",
        "resvg",
    ];
    expect_none(&uses("crates/giveway-picture", &[], &surroundings));
    expect_none(&uses("crates/giveway-picture", &[], BROWSER));
}

#[test]
fn orders_know_the_model_alone() {
    let others = [
        "varisat",
        "giveway_solve",
        "giveway_planners",
        "std::fs",
        "std::io",
        "std::env",
        "std::process",
        "std::thread",
        "std::time",
    ];
    expect_none(&uses("crates/giveway-order/src", &[], &others));
    expect_none(&uses("crates/giveway-order", &[], BROWSER));
}

#[test]
fn planners_know_no_solver_and_no_surroundings() {
    let planners = "crates/giveway-planners";
    let others = [
        "varisat",
        "giveway_solve",
        "giveway_proof",
        "std::fs",
        "std::io",
        "std::net",
        "std::env",
        "std::process",
        "std::thread",
        "std::time",
    ];
    expect_none(&uses(planners, &[], &others));
    expect_none(&uses(planners, &[], BROWSER));
}

#[test]
fn the_judge_knows_no_encoding() {
    let encoding = ["encode", "sat", "giveway_solve", "varisat"];
    expect_none(&uses("crates/giveway-model/src/check", &[], &encoding));
}

#[test]
fn only_one_place_a_crate_names_the_sat_solver() {
    let sat = [
        "crates/giveway-solve/src/sat/",
        "crates/giveway-proof/src/prove/",
        "tests/",
    ];
    let varisat = ["varisat", "varisat_formula", "varisat_checker"];
    expect_none(&uses("", &sat, &varisat));
}

#[test]
fn the_solver_has_no_clock_no_files_and_no_page() {
    let surroundings = [
        "std::fs",
        "std::net",
        "std::env",
        "std::process",
        "std::thread",
        "std::time",
        "giveway_cli",
        "giveway_web",
    ];
    expect_none(&uses("crates/giveway-solve/src", &[], &surroundings));
    expect_none(&uses("crates/giveway-solve/src", &[], BROWSER));
    // A proof is written into a writer, which is how a solve is stopped.
    let sat = ["crates/giveway-solve/src/sat/"];
    expect_none(&uses("crates/giveway-solve/src", &sat, &["std::io"]));
}

#[test]
fn a_clock_only_ends_a_search() {
    // The budget asks the clock, the checker of proofs has a limit of its own, and
    // explanations and prices share out the seconds that are left: all of it under a limit of
    // seconds only.
    let places = [
        "crates/giveway-solve/src/budget.rs",
        "crates/giveway-solve/src/budget/tell.rs",
        "crates/giveway-solve/src/host.rs",
        "crates/giveway-solve/src/verify.rs",
        "crates/giveway-solve/src/certify.rs",
        "crates/giveway-solve/src/certify/export.rs",
        "crates/giveway-solve/src/explain/reasons.rs",
        "crates/giveway-solve/src/price/serve.rs",
    ];
    let clocks = ["wall_seconds", "seconds_left"];
    let files = source::rust_files();
    let mut complaints = Vec::new();
    for layer in ["crates/giveway-solve/src", "crates/giveway-planners/src"] {
        for file in under(&files, layer) {
            let is_place = places.contains(&file.path.as_str());
            let asks = |clock: &&str| file.text.contains(*clock);
            if !is_place && !file.path.contains("/tests") && clocks.iter().any(asks) {
                complaints.push(format!("{} asks a clock", file.path));
            }
        }
    }
    expect_none(&complaints);
}

#[test]
fn the_state_of_the_page_is_plain_data() {
    let state = "crates/giveway-page/src";
    let surroundings = [
        "std::fs",
        "std::io",
        "std::net",
        "std::env",
        "std::process",
        "std::thread",
        "std::time",
        "RefCell",
        "giveway_web",
    ];
    // Its tests read the maps that the page holds, and ask the solver.
    let tests = ["crates/giveway-page/src/tests"];
    expect_none(&uses(state, &tests, &surroundings));
    expect_none(&uses(state, &[], BROWSER));
    // It tells what should be solved, and leaves the solving to the page.
    let solving = ["giveway_solve::serve", "giveway_solve::service"];
    expect_none(&uses(state, &tests, &solving));
}

#[test]
fn lessons_are_plain_data() {
    let course = "crates/giveway-course/src";
    let surroundings = [
        "std::fs",
        "std::io",
        "std::net",
        "std::env",
        "std::process",
        "std::thread",
        "std::time",
        "RefCell",
        "giveway_page",
        "giveway_web",
    ];
    expect_none(&uses(course, &[], &surroundings));
    expect_none(&uses(course, &[], BROWSER));
    // They tell what the solver should be asked, and leave the asking to others.
    let solving = ["giveway_solve::serve", "giveway_solve::service"];
    expect_none(&uses(course, &[], &solving));
}

#[test]
fn certificates_trust_no_solver() {
    let proof = "crates/giveway-proof/src";
    expect_none(&uses(proof, &[], &["giveway_solve"]));
    let surroundings = [
        "std::fs",
        "std::net",
        "std::env",
        "std::process",
        "std::thread",
        "std::time",
    ];
    expect_none(&uses(proof, &[], &surroundings));
    expect_none(&uses(proof, &[], BROWSER));
}

#[test]
fn the_checker_of_proofs_knows_texts_only() {
    let others = [
        "crate::plain",
        "crate::exhaust",
        "crate::bundle",
        "crate::prove",
        "crate::claim",
        "giveway_model",
        "varisat",
    ];
    expect_none(&uses("crates/giveway-proof/src/drat", &[], &others));
    // And the formulas know neither who proves them nor who searches instead.
    let plain = "crates/giveway-proof/src/plain";
    let tested = ["crates/giveway-proof/src/plain/cnf.rs"];
    let others = ["crate::prove", "crate::drat", "crate::exhaust", "varisat"];
    expect_none(&uses(plain, &tested, &others));
}

#[test]
fn the_oracle_shares_nothing_with_the_solver_or_the_judge() {
    let judged = [
        "giveway_solve",
        "giveway_proof",
        "check",
        "giveway_model::Grid",
    ];
    expect_none(&uses("tests/src/oracle", &[], &judged));
}

#[test]
fn no_hash_is_random() {
    let random = ["HashSet", "RandomState", "DefaultHasher"];
    expect_none(&uses("", &[], &random));
    // A hash map is named only where it is given a hasher without a seed.
    let mut complaints = Vec::new();
    for file in source::rust_files() {
        let lines: Vec<&str> = file.text.lines().collect();
        for used in source::paths(&file) {
            let text = lines.get(used.line - 1).unwrap();
            if used.contains("HashMap") && !text.contains("BuildHasher") {
                complaints.push(format!("{}:{}: {text}", file.path, used.line));
            }
        }
    }
    expect_none(&complaints);
}
