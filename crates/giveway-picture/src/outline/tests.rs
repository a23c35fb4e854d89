//! Outlines of small maps, whole and cut.

use super::*;

const SHARP: Pen = Pen {
    inset: 0,
    radius: 0,
    overlap: 0,
};
const ROUND: Pen = Pen {
    inset: 6,
    radius: 16,
    overlap: 0,
};

fn region(rows: &[&str], first: (u32, u32), size: (u32, u32)) -> Region {
    let row = |cell: Cell| rows.get(cell.y as usize)?.as_bytes().get(cell.x as usize);
    let area = Area {
        first: first.into(),
        size,
    };
    Region::new(area, |cell| row(cell) == Some(&b'#'))
}

/// Of a map that is one tile.
#[track_caller]
fn check(rows: &[&str], pen: Pen, expect: &str) {
    let whole = region(rows, (0, 0), (rows[0].len() as u32, rows.len() as u32));
    assert_eq!(whole.fill(pen), expect);
    assert_eq!(whole.edge(pen), expect);
}

#[test]
fn a_shelf_is_one_rounded_shape() {
    let corner = "a16 16 0 0 1";
    let expect =
        format!("M22 6H178{corner} 16 16V78{corner} -16 16H22{corner} -16 -16V22{corner} 16 -16Z");
    check(&["##"], ROUND, &expect);
}

#[test]
fn a_shape_with_an_inner_corner() {
    check(&["#.", "##"], SHARP, "M0 0H100V100H200V200H0V0Z");
    let pen = Pen { radius: 0, ..ROUND };
    check(&["#.", "##"], pen, "M6 6H94V106H194V194H6V6Z");
}

#[test]
fn cells_that_meet_in_a_corner_stay_apart() {
    let apart = "M0 0H100V100H0V0ZM100 100H200V200H100V100Z";
    check(&["#.", ".#"], SHARP, apart);
}

#[test]
fn a_hole_runs_the_other_way() {
    let rows = ["###", "#.#", "###"];
    let whole = region(&rows, (0, 0), (3, 3));
    let ring = "M0 0H300V300H0V0ZM100 200H200V100H100V200Z";
    assert_eq!(whole.fill(SHARP), ring);
    // The same hole, from its upper side.
    let ring = "M0 0H300V300H0V0ZM200 100H100V200H200V100Z";
    assert_eq!(whole.edge(SHARP), ring);
}

#[test]
fn nothing_has_no_path() {
    check(&["..", ".."], SHARP, "");
}

#[test]
fn a_shape_that_is_cut_reaches_over_the_border() {
    let pen = Pen {
        overlap: 8,
        ..SHARP
    };
    let left = region(&["##"], (0, 0), (1, 1));
    // A little narrower there.
    assert_eq!(left.fill(pen), "M0 0H100V2H108V98H100V100H0V0Z");
    let right = region(&["##"], (1, 0), (1, 1));
    assert_eq!(right.fill(pen), "M92 2H100V0H200V100H100V98H92V2Z");
    let right = right.edge(pen);
    // From its upper left corner around to its lower one, and 8 on.
    assert_eq!(right, "M100 0H200V100H92");
}

#[test]
fn a_shape_beside_a_tile_is_none_of_its_own() {
    let beside = region(&[".#", "##"], (0, 0), (1, 1));
    assert_eq!((beside.fill(ROUND), beside.edge(ROUND)), Default::default());
}

#[test]
fn an_inner_corner_on_a_border_is_round_all_the_same() {
    // The corner around which it turns is where the tile ends.
    let elbow = region(&["#.", "##"], (0, 1), (1, 1));
    let arc = "V90a16 16 0 0 0 16 16";
    assert!(elbow.fill(ROUND).contains(arc), "{}", elbow.fill(ROUND));
    let above = region(&["#.", "##"], (0, 0), (2, 1));
    assert!(above.edge(ROUND).contains(arc), "{}", above.edge(ROUND));
}
