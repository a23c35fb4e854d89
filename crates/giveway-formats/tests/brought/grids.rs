//! Maps without a header, with a header in any order, and instances of the class project.

use giveway_formats::{Format, recognise, write};
use giveway_model::{Cell, check::check};

use super::{brought, opened, refused};

#[test]
fn a_map_needs_no_type_and_no_order() {
    for map in [
        brought("no-type.map"),
        "width 2\ntype octile\nheight 1\nmap\n..\n".to_owned(),
        "\n\nheight 1\r\nwidth 2\r\ntype octile\r\nmap\r\n..\r\n".to_owned(),
        "Width 2\nHeight 1\nmap\n..".to_owned(),
    ] {
        assert_eq!(recognise(&map), Ok(Format::MovingAi), "{map}");
        let plan = brought("no-type-plan.txt");
        let combined = opened(&[("plan.txt", &plan), ("no-type.map", &map)]).unwrap();
        assert!(check(&combined.instance, &combined.plans[0].plan).is_valid());
    }
}

#[test]
fn two_heights_are_no_height() {
    assert_eq!(
        refused("height 1\nheight 2\nwidth 2\nmap\n..\n"),
        "line 2, column 8: found \"2\", expected 1, as above"
    );
}

#[test]
fn an_instance_of_the_class_project_is_read_row_first() {
    let combined = opened(&[("rows.txt", &brought("rows.txt"))]).unwrap();
    let instance = combined.instance;
    assert_eq!(instance.grid().rows(), ["...", ".#."]);
    let agent = &instance.agents()[0];
    assert_eq!((agent.start, instance.name()), (Cell::new(0, 0), "rows"));
    assert!(
        combined.notes[0].contains("the row first"),
        "{:?}",
        combined.notes
    );
    // Without blanks, with CR LF, with two robots.
    let text = "2 3\r\n...\r\n.@.\r\n2\r\n0 0 1 2\r\n1 2 0 0\r\n";
    let agents = opened(&[("a.txt", text)])
        .unwrap()
        .instance
        .agents()
        .to_vec();
    assert_eq!(agents[1].start, Cell::new(2, 1));
    let written = write(
        Format::ClassProject,
        "it",
        Some(&opened(&[("a.txt", text)]).unwrap().instance),
        None,
    );
    assert_eq!(
        written.unwrap().files[0].1,
        "2 3\n. . .\n. @ .\n2\n0 0 1 2\n1 2 0 0\n"
    );
}

#[test]
fn what_is_wrong_with_an_instance_of_the_class_project_has_a_line() {
    let check = |text: &str, expected: &str| assert_eq!(refused(text), expected);
    check(
        "2 3\n. . .\n. @\n1\n0 0 1 2\n",
        "line 3, column 4: found a row of 2 cells, expected 3, the columns in the first line",
    );
    check(
        "1 2\n. .\n1\n0 0 0 7\n",
        "line 4, column 1: found row 0, column 7, expected a cell of the 1 rows and 2 columns, from 0, the row first",
    );
    check(
        "1 2\n. .\n2\n0 0 0 1\n",
        "line 4, column 8: found the end of the file, expected a line for each of the 2 robots",
    );
    check(
        "1 3\n. . @\n1\n0 0 0 2\n",
        "line 4, column 1: agents[0].goal: found the obstacle (2, 0), expected a free cell",
    );
}

#[test]
fn a_bare_grid_is_a_map_and_what_was_assumed_is_said() {
    for (text, rows, said) in [
        (
            &*brought("bare.txt"),
            &["...", ".#.", "..#"][..],
            "# and @ are obstacles",
        ),
        ("...\r\n.@.\r\n", &["...", ".#."], ". is free"),
        ("0 0 1\n0 1 0\n", &["..#", ".#."], "1 is an obstacle"),
        ("001\n010", &["..#", ".#."], "0 is free"),
        ("\n  . . #\n", &["..#"], ". is free"),
        ("0,0,1\n0,1,0\n", &["..#", ".#."], "0 is free"),
    ] {
        let combined = opened(&[("bare.txt", text)]).unwrap();
        assert_eq!(combined.instance.grid().rows(), rows, "{text}");
        assert!(combined.notes[0].contains(said), "{:?}", combined.notes);
    }
    // A plan is for it as for any map.
    let plan = "Agent 0: (0,0)->(0,1)->(0,2)->\n";
    let combined = opened(&[("bare.txt", &brought("bare.txt")), ("p.txt", plan)]).unwrap();
    assert!(combined.notes[0].contains("bare grid"));
    assert!(check(&combined.instance, &combined.plans[0].plan).is_valid());
}

#[test]
fn letters_in_a_grid_are_starts_and_goals() {
    let combined = opened(&[("two.txt", "a.B\n.#.\nb.A\n")]).unwrap();
    let agents = combined.instance.agents();
    assert_eq!(
        (agents[0].name.as_str(), agents[1].name.as_str()),
        ("A", "B")
    );
    assert_eq!(
        (agents[0].start, agents[0].goal),
        (Cell::new(0, 0), Some(Cell::new(2, 2)))
    );
    assert!(
        combined.notes[1].contains("small letter"),
        "{:?}",
        combined.notes
    );
    let one = opened(&[("one.txt", "S.#\n..G\n")]).unwrap();
    assert_eq!(one.instance.agents()[0].goal, Some(Cell::new(2, 1)));
    assert!(one.notes[1].contains("S is the start"));
    let written = write(Format::Grid, "it", Some(&combined.instance), None).unwrap();
    assert_eq!(written.files[0].1, "a.B\n.#.\nb.A\n");
    assert!(written.losses.is_empty(), "{:?}", written.losses);
}

#[test]
fn ragged_grids_are_refused_with_their_line() {
    let check = |text: &str, expected: &str| assert_eq!(refused(text), expected);
    check(
        "...\n.#\n...\n",
        "line 2, column 3: found a row of 2 cells, expected 3, as in the first row: fill short rows up with # or .",
    );
    check(
        "...\n....\n",
        "line 2, column 4: found a row of 4 cells, expected 3, as in the first row: fill short rows up with # or .",
    );
    check(
        "..#\n.1.\n",
        "line 2, column 2: found \"1\", expected 0 and 1 in every row, or . and @ (or #), not both",
    );
    check(
        "...\n\n...\n",
        "line 2, column 1: found an empty line, expected a row of 3 cells: no empty line within the grid",
    );
    check(
        "a..\n...\n",
        "line 1, column 1: found the start a without a goal, expected A, the goal of this robot, in the grid",
    );
    assert!(refused("..T\n...\n").contains("\"height\", \"width\" and \"map\""));
    assert!(refused("a.A\n.a.\n").contains("which line 1 has, too"));
    assert!(refused("...\n.?.\n").contains("line 2, column 2: found \"?\""));
}

#[test]
fn prose_and_lists_are_no_grid() {
    for text in [
        "good morning",
        "a b c",
        "# A heading\n\nAnd a text.\n",
        "1\n",
        "0\n1\n0\n",
        "x.y\nhello\n",
    ] {
        assert_ne!(recognise(text), Ok(Format::Grid), "{text}");
    }
}

#[test]
fn the_largest_maps_of_the_benchmark_are_read() {
    assert_eq!(
        opened(&[("wide.map", &brought("wide.map"))])
            .unwrap()
            .instance
            .grid()
            .width(),
        1025
    );
    // As large as orz900d and brc202d, with 5,000 robots.
    for (width, height) in [(656, 1491), (530, 481)] {
        let row = ".".repeat(width) + "\n";
        let map = format!(
            "type octile\nheight {height}\nwidth {width}\nmap\n{}",
            row.repeat(height)
        );
        let mut scenario = "version 1\n".to_owned();
        let mut paths = String::new();
        for i in 0..5_000 {
            let (x, y) = (i % width, i / width);
            let end = y + 20;
            let line = format!("0\tl.map\t{width}\t{height}\t{x}\t{y}\t{x}\t{end}\t1\n");
            scenario.push_str(&line);
            let cells: Vec<String> = (y..=y + 20).map(|y| format!("({y},{x})->")).collect();
            let line = format!("Agent {i}: {}\n", cells.concat());
            paths.push_str(&line);
        }
        let files = [("l.map", &*map), ("l.scen", &*scenario), ("p.txt", &*paths)];
        let combined = opened(&files).unwrap();
        assert_eq!(combined.instance.agents().len(), 5_000);
        assert!(check(&combined.instance, &combined.plans[0].plan).is_valid());
    }
    let told = refused("height 1\nwidth 3000\nmap\n..\n");
    assert!(
        told.contains("expected a whole number from 1 to 2048"),
        "{told}"
    );
}
