//! `giveway picture`.

use std::fs;

use expect_test::expect;

use crate::run::{Folder, WAREHOUSE, WAREHOUSE_PLAN, two_agents};

const PLAN: &str = r#"{ "giveway": 1, "paths": {
  "A1": [[0,0],[0,1],[1,1],[2,1],[3,1]],
  "A2": [[3,0],[3,0],[3,1],[2,1],[1,1],[0,1]] } }"#;

fn folder() -> Folder {
    Folder::with(&[
        ("two.json", two_agents(&[])),
        ("plan.json", PLAN.to_owned()),
    ])
}

fn bytes(folder: &Folder, name: &str) -> Vec<u8> {
    fs::read(folder.path(name)).unwrap()
}

/// The size of the last picture of a GIF, and its pixels as red, green, blue; and how
/// many pictures there are.
fn last_of(gif: &[u8]) -> ((usize, usize), Vec<[u8; 3]>, usize) {
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut file = options.read_info(gif).unwrap();
    let size = (usize::from(file.width()), usize::from(file.height()));
    let mut canvas = vec![[0; 3]; size.0 * size.1];
    let mut count = 0;
    while let Some(frame) = file.read_next_frame().unwrap() {
        count += 1;
        for (index, pixel) in frame.buffer.chunks_exact(4).enumerate() {
            let x = usize::from(frame.left) + index % usize::from(frame.width);
            let y = usize::from(frame.top) + index / usize::from(frame.width);
            if pixel[3] > 0 {
                canvas[y * size.0 + x] = [pixel[0], pixel[1], pixel[2]];
            }
        }
    }
    (size, canvas, count)
}

#[test]
fn a_plan_at_a_time_goes_to_standard_output() {
    let folder = folder();
    let start = folder.run("picture two.json plan.json");
    assert!(start.answer().starts_with("<svg "), "{}", start.out);
    assert!(start.out.ends_with("</svg>"));
    assert!(start.out.contains("<title>two, step 0</title>"));
    let later = folder.run("picture two.json plan.json --at 2.5");
    assert!(
        later.answer().contains("Step 2 of 5. A1 is at (2, 1)."),
        "{}",
        later.out
    );
    assert!(!later.out.contains("@keyframes"));
}

#[test]
fn a_plan_moves_as_svg() {
    let folder = folder();
    folder
        .run("picture two.json plan.json --animate --look dark -o two.svg")
        .answer();
    let svg = folder.read("two.svg");
    assert!(svg.contains("@keyframes") && svg.contains("prefers-reduced-motion"));
    assert!(
        svg.contains("#23272d") && !svg.contains("#ffffff"),
        "it is not dark"
    );
    assert_eq!(
        svg,
        folder
            .run("picture two.json plan.json --animate --look dark")
            .answer()
    );
}

#[test]
fn a_png_has_the_size_asked_for() {
    let folder = folder();
    folder
        .run("picture two.json plan.json --cell 20 --at 1 --output two.png")
        .answer();
    let png = bytes(&folder, "two.png");
    assert_eq!(png.get(1..4), Some(&b"PNG"[..]));
    let number = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
    // 4 x 2 cells, 12 around them, 24 for the time.
    assert_eq!((number(16), number(20)), (104, 88));
}

#[test]
fn a_gif_shows_the_plan() {
    let folder = folder();
    folder
        .run("picture two.json plan.json --animate --cell 40 --output two.gif")
        .answer();
    let gif = bytes(&folder, "two.gif");
    let (size, pixels, count) = last_of(&gif);
    assert_eq!((size, count), ((184, 128), 41));
    // The colour a little beside the middle of a cell, where no name is.
    let at = |x: usize, y: usize| pixels[(12 + 40 * y + 20) * size.0 + 12 + 40 * x + 11];
    let (blue, sea, floor, shelf) = ([0, 90, 230], [80, 160, 130], [255; 3], [43, 49, 59]);
    assert_eq!([at(3, 1), at(0, 1)], [blue, sea]);
    assert_eq!([at(0, 0), at(2, 0)], [floor, shelf]);
    // The same plan gives the same bytes.
    folder
        .run("picture two.json plan.json --animate --cell 40 --output again.gif")
        .answer();
    assert!(gif == bytes(&folder, "again.gif"));
}

#[test]
fn plans_of_any_format_and_results_of_solve_are_drawn() {
    let folder = Folder::with(&[
        ("two.json", two_agents(&[])),
        ("paths.txt", "Agent 0: (0,0)->(1,0)->(1,1)->(1,2)->(1,3)->\nAgent 1: (0,3)->(0,3)->(1,3)->(1,2)->(1,1)->(1,0)->\n".to_owned()),
    ]);
    let run = folder.run("picture two.json paths.txt --at 4");
    let answer = run.answer_but_for_notes();
    assert!(answer.contains("A1 is at (3, 1)."), "{answer}");
    let solved = folder.run("solve two.json --format json").out;
    let run = folder.run_with("picture two.json - --animate", &solved);
    assert!(run.answer().contains("@keyframes"));
}

#[test]
fn batteries_chargers_slow_zones_and_waypoints_are_drawn() {
    let folder = Folder::with(&[("warehouse.json", WAREHOUSE), ("plan.json", WAREHOUSE_PLAN)]);
    for file in [
        "moving.svg --animate",
        "moving.gif --animate --cell 12",
        "still.png --at 3.5",
    ] {
        folder
            .run(&format!("picture warehouse.json plan.json -o {file}"))
            .answer();
    }
    assert!(folder.read("moving.svg").contains("stroke-dashoffset"));
}

#[test]
fn names_from_elsewhere_are_only_text() {
    let scene = two_agents(&[("A1", "<script>&"), ("\"two\"", "\"]]></svg>\"")]);
    let plan = PLAN.replace("A1", "<script>&");
    let folder = Folder::with(&[("two.json", scene), ("plan.json", plan)]);
    let run = folder.run("picture two.json plan.json --animate");
    assert!(!run.answer().contains("<script"));
    assert_eq!(run.out.matches("</svg>").count(), 1);
    folder
        .run("picture two.json plan.json --output two.png")
        .answer();
}

#[test]
fn what_is_asked_for_must_fit_together() {
    let folder = folder();
    for (line, told) in [
        (
            "-o two.png --animate",
            "found two.png to write to, expected a name that ends in .svg or .gif, as a PNG does not move",
        ),
        (
            "-o two.gif",
            "expected a name that ends in .svg or .png, or --animate",
        ),
        (
            "-o two.jpg",
            "found two.jpg to write to, expected a name that ends in .svg, .png or .gif",
        ),
        (
            "--at soon",
            "found \"soon\", expected a number of steps from 0",
        ),
        ("--at -1", "found \"-1\", expected a number of steps from 0"),
        ("--at 1 --animate", "cannot be used with '--animate'"),
        (
            "--cell 1",
            "found \"1\", expected a whole number of pixels from 2 to 256",
        ),
        ("-o plan.json", "found plan.json to write to"),
    ] {
        let run = folder.run(&format!("picture two.json plan.json {line}"));
        assert_eq!((run.exit, run.out.as_str()), (Some(2), ""), "{line}");
        assert!(run.err.contains(told), "{line}: {}", run.err);
    }
}

#[test]
fn a_file_that_was_read_is_not_written_over() {
    let folder = Folder::with(&[("two.svg", two_agents(&[])), ("plan.json", PLAN.to_owned())]);
    let run = folder.run("picture two.svg plan.json -o two.svg");
    assert_eq!(run.exit, Some(2));
    assert!(
        run.err
            .contains("two.svg is an input file and would be overwritten"),
        "{}",
        run.err
    );
    assert_eq!(folder.read("two.svg"), two_agents(&[]));
}

#[test]
fn faults_name_their_place_and_nothing_is_written() {
    let folder = Folder::with(&[
        ("two.json", two_agents(&[])),
        ("plan.json", PLAN.to_owned()),
        (
            "other.json",
            r#"{ "giveway": 1, "paths": { "B9": [[0,0]] } }"#.to_owned(),
        ),
        (
            "broken.json",
            "{ \"giveway\": 1,\n  \"paths\": 7 }".to_owned(),
        ),
    ]);
    folder.refuses(
        "picture two.json other.json -o two.svg",
        &expect![[r#"
            exit 1
            other.json: paths.B9: found a robot that the instance does not have, and none that it has, expected paths of its robots
        "#]],
    );
    folder.refuses("picture two.json broken.json -o two.svg", &expect![[r#"
        exit 1
        broken.json: line 2, column 12: paths: found the number 7, expected an object by the names of robots
    "#]]);
    let run = folder.run("picture two.json plan.json -o no/such/folder.svg");
    assert_eq!((run.exit, run.out.as_str()), (Some(1), ""));
    let told = "no/such/folder.svg: cannot write: ";
    assert!(run.err.starts_with(told), "{}", run.err);
    assert!(!folder.path("two.svg").exists());
}

#[test]
fn a_gif_that_would_be_too_large_is_refused() {
    let long: Vec<&str> = std::iter::repeat_n("[0,0]", 4000).collect();
    let plan = format!(
        r#"{{ "giveway": 1, "paths": {{ "A1": [{}] }} }}"#,
        long.join(",")
    );
    let folder = Folder::with(&[("two.json", two_agents(&[])), ("plan.json", plan)]);
    let run = folder.run("picture two.json plan.json --animate -o two.gif");
    assert_eq!(run.exit, Some(1));
    assert!(
        run.err.contains("The GIF is too large: 4000 frames of"),
        "{}",
        run.err
    );
    assert!(!folder.path("two.gif").exists());
}

/// Each robot looks different on a picture without fonts, whatever letters its name has.
#[test]
fn names_in_any_script_are_told_apart() {
    for names in [
        ["\u{8f66}1", "\u{410}1", "\u{2603}"],
        ["\u{5d0}\u{5d1}", "\u{5d2}", "\u{1f916}"],
        ["carrier", "carton", "cart"],
        [
            "Transporter_in_hall_East_01",
            "Transporter_in_hall_East_02",
            " ",
        ],
    ] {
        let agents: Vec<String> = (0..3)
            .map(|x| {
                format!(
                    r#"{{ "name": "{}", "start": [{x}, 0], "goal": [{x}, 0] }}"#,
                    names[x]
                )
            })
            .collect();
        let scene = format!(
            r#"{{ "giveway": 1, "map": ["..."], "agents": [{}] }}"#,
            agents.join(", ")
        );
        let paths: Vec<String> = (0..3)
            .map(|x| format!(r#""{}": [[{x}, 0]]"#, names[x]))
            .collect();
        let plan = format!(r#"{{ "giveway": 1, "paths": {{ {} }} }}"#, paths.join(", "));
        let folder = Folder::with(&[("names.json", scene), ("plan.json", plan)]);
        // One look for all: what is different then is what stands on the forms.
        let run = folder.run("picture names.json plan.json --cell 64 -o names.png");
        assert_eq!(run.exit, Some(0), "{}", run.err);
        let svg = folder.run("picture names.json plan.json --cell 64").out;
        assert_eq!(svg.matches("<title>").count(), 4, "{names:?}");
        let badges: Vec<&str> = svg
            .split("font-weight=\"700\"")
            .skip(1)
            .filter_map(|text| text.split('>').nth(1)?.split('<').next())
            .collect();
        assert_eq!(badges.len(), 3, "{names:?}: {badges:?}");
        assert!(
            badges.iter().all(|badge| !badge.trim().is_empty()),
            "{badges:?}"
        );
        assert!(
            badges[0] != badges[1] && badges[1] != badges[2] && badges[0] != badges[2],
            "{badges:?}"
        );
    }
}
