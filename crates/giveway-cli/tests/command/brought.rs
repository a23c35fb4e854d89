//! Files as people bring them: what one command reads, all of them read.

use std::path::Path;

use crate::run::{Folder, Run};

/// A folder with files that people brought.
fn folder(names: &[&str]) -> Folder {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../giveway-formats/tests/data/brought");
    let files: Vec<(&str, Vec<u8>)> = names
        .iter()
        .map(|name| (*name, std::fs::read(data.join(name)).unwrap()))
        .collect();
    Folder::with(&files)
}

/// Both outputs of a run.
fn all(run: &Run) -> String {
    format!("{}{}", run.out, run.err)
}

#[test]
fn a_map_without_a_type_is_read_by_audit() {
    let folder = folder(&["no-type.map", "no-type-plan.txt"]);
    let run = folder.run("audit no-type-plan.txt no-type.map");
    assert!(run.answer().contains("The best: proved."), "{}", run.out);
}

#[test]
fn every_command_reads_the_class_project() {
    let folder = folder(&["rows.txt"]);
    let solved = folder.run("solve rows.txt --format json --quiet");
    assert_eq!(solved.json()["costs"]["makespan"], 3);
    std::fs::write(folder.path("result.json"), &solved.out).unwrap();
    for line in [
        "solve rows.txt",
        "check rows.txt result.json",
        "audit rows.txt result.json",
        "compare rows.txt result.json result.json",
        "explain rows.txt --plan result.json arrival A1",
        "freedom rows.txt",
        "picture rows.txt result.json",
        "convert rows.txt --to giveway",
        "convert rows.txt --to class-project",
    ] {
        let run = folder.run(line);
        assert_eq!(run.exit, Some(0), "{line}: {}", all(&run));
        let says = line.starts_with("compare") || all(&run).contains("row first");
        assert!(says, "{line}: {}", all(&run));
    }
}

#[test]
fn bare_grids_are_maps_and_scenes() {
    let folder = folder(&["bare.txt"]);
    let run = folder.run("convert bare.txt --to movingai --output out");
    assert!(run.err.contains("bare grid"), "{}", run.err);
    assert!(folder.read("out/bare.map").contains("map\n...\n.@.\n..@\n"));
    let run = folder.run("solve bare.txt");
    assert!(
        run.err.contains("a map, which has no robots"),
        "{}",
        run.err
    );
    std::fs::write(folder.path("robots.map"), "a.B\r\n...\r\nb.A\r\n").unwrap();
    let run = folder.run("solve robots.map");
    assert!(
        run.out.contains("Optimal") && run.out.contains("small letter"),
        "{}",
        all(&run)
    );
    let run = folder.run_with("solve -", "a..\n..\n");
    assert!(
        run.err.contains("line 2, column 3: found a row of 2 cells"),
        "{}",
        run.err
    );
}

#[test]
fn what_clingo_prints_is_read() {
    let folder = folder(&["clingo.txt"]);
    let run = folder.run("convert clingo.txt --to giveway");
    assert!(
        run.answer_but_for_notes().contains("\"map\": [\"..\"]"),
        "{}",
        all(&run)
    );
    std::fs::write(
        folder.path("none.txt"),
        "clingo version 5.7.1\nSolving...\nUNSATISFIABLE\n",
    )
    .unwrap();
    for line in [
        "solve none.txt",
        "audit clingo.txt none.txt",
        "convert none.txt --to giveway",
    ] {
        let run = folder.run(line);
        assert!(
            run.err.contains("clingo found that there is no answer"),
            "{line}: {}",
            all(&run)
        );
        assert_eq!(run.exit, Some(1));
    }
}

#[test]
fn files_of_the_league_are_named_and_read_together() {
    let folder = folder(&["problem.json", "summary.json"]);
    let run = folder.run("solve problem.json");
    assert!(run.err.contains("a.map, a.agents, a.tasks"), "{}", run.err);
    let run = folder.run("audit summary.json");
    assert!(run.err.contains("a summary of the League"), "{}", run.err);
    let write = |name: &str, text: &str| std::fs::write(folder.path(name), text).unwrap();
    write("a.map", "type octile\nheight 1\nwidth 3\nmap\n...\n");
    write("a.agents", "1\n0\n");
    write("a.tasks", "1\n2\n");
    let run = folder.run("solve problem.json");
    assert!(run.out.contains("makespan 2"), "{}", all(&run));
    assert!(!run.out.contains("Not proved"), "{}", all(&run));
    assert!(run.out.contains("goes on without end"), "{}", run.out);
}

#[test]
fn encodings_are_read_by_every_command() {
    let folder = folder(&["utf16.map"]);
    assert!(
        folder
            .run("convert utf16.map --to giveway")
            .answer()
            .contains("\"....\"")
    );
    let scene = "{\"giveway\": 1, \"map\": [\"..\"], \"agents\": [{\"name\": \"Größe\", \"start\": [0, 0], \"goal\": [1, 0]}]}";
    let latin: Vec<u8> = scene.chars().map(|c| u8::try_from(c).unwrap()).collect();
    let wide: Vec<u8> = scene.encode_utf16().flat_map(u16::to_be_bytes).collect();
    std::fs::write(folder.path("latin.json"), latin).unwrap();
    std::fs::write(folder.path("wide.json"), wide).unwrap();
    let run = folder.run("solve latin.json");
    assert!(
        run.out.contains("Größe") && run.out.contains("Windows-1252"),
        "{}",
        all(&run)
    );
    assert!(folder.run("solve wide.json").answer().contains("Größe"));
    assert!(
        folder
            .run("convert latin.json --to class-project")
            .err
            .contains("Windows-1252")
    );
}

#[test]
fn results_are_plans_for_every_command() {
    let folder = folder(&[
        "lane.json",
        "solve-result.json",
        "adopted.json",
        "delay.json",
        "change-result.json",
    ]);
    for line in [
        "audit lane.json solve-result.json",
        "check lane.json solve-result.json",
        "compare lane.json solve-result.json solve-result.json",
        "check lane.json adopted.json --changes delay.json",
    ] {
        let run = folder.run(line);
        assert_eq!(run.exit, Some(0), "{line}: {}", all(&run));
    }
    let run = folder.run("audit lane.json change-result.json");
    assert!(
        run.out.contains("adopted after the change"),
        "{}",
        all(&run)
    );
    let run = folder.run("audit lane.json delay.json");
    assert!(
        run.err.contains("delay.json is a list of changes"),
        "{}",
        run.err
    );
}

#[test]
fn what_is_no_input_is_named() {
    let folder = Folder::with(&[
        ("picture.map", &b"\x89PNG\r\n\x1a\n\0"[..]),
        ("page.map", b"<!DOCTYPE html>"),
        (
            "geo.json",
            br#"{ "type": "FeatureCollection", "features": [] }"#,
        ),
        (
            "package.json",
            br#"{ "name": "a", "version": "1", "dependencies": {} }"#,
        ),
    ]);
    for (file, kind) in [
        ("picture.map", "a picture (PNG)"),
        ("page.map", "a web page (HTML)"),
        ("geo.json", "GeoJSON"),
        ("package.json", "a description of a package"),
    ] {
        for command in ["solve", "audit", "convert --to giveway"] {
            let run = folder.run(&format!("{command} {file}"));
            assert!(run.err.contains(kind), "{command} {file}: {}", run.err);
            assert_eq!(run.exit, Some(1));
        }
    }
}
