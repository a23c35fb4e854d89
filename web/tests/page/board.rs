//! The board: roles, names, keys, motion.

use giveway_model::Cell;
use giveway_page::{Action, BoardAction, PlayAction, Selection, Tool, ViewAction, reduce};
use wasm_bindgen_test::wasm_bindgen_test;

use crate::stage::{Stage, drafted, press, solved, until};

#[wasm_bindgen_test]
async fn a_grid_of_named_cells() {
    let stage = Stage::of(solved()).await;
    let board = stage.find("[role=grid][aria-label=Board]").await;
    assert_eq!(board.get_attribute("aria-rowcount").as_deref(), Some("3"));
    assert_eq!(board.get_attribute("aria-colcount").as_deref(), Some("10"));
    let names = stage.all("[role=gridcell]", "aria-label");
    assert_eq!(names.len(), 30);
    for name in [
        "0, 0: start of A1, goal of A2",
        "1, 1: obstacle",
        "3, 2: charger",
        "4, 0: slow zone",
        "9, 1: free",
    ] {
        assert!(names.iter().any(|found| found == name), "{name}: {names:?}");
    }
}

#[wasm_bindgen_test]
async fn keys_go_to_a_cell_and_apply_the_tool() {
    let state = reduce(
        &solved(),
        Action::Board(BoardAction::PickTool(Tool::Obstacle)),
    );
    let stage = Stage::of(reduce(
        &state,
        Action::Board(BoardAction::MoveCursor(Cell::new(3, 1))),
    ))
    .await;
    let board = stage.find("[role=grid]").await;
    press(&board, "ArrowRight");
    press(&board, "Enter");
    let step = Action::Board(BoardAction::StepCursor {
        by: (1, 0),
        carries: false,
    });
    assert_eq!(stage.sent(), [step, Action::Board(BoardAction::UseTool)]);
}

#[wasm_bindgen_test]
async fn agents_move_evenly_with_the_clock() {
    let state = solved();
    let stage = Stage::of(state.clone()).await;
    let places = || stage.all(".agent", "transform");
    until("the agents", || places().len() == 2).await;
    let at_start = places();
    stage.clock.follow(state.view.playback, state.last_time());
    // Between two cells, which are 100 units apart.
    until("an agent between two cells", || {
        let now = places();
        now != at_start && now.iter().any(|place| !place.contains("50.0 "))
    })
    .await;
}

#[wasm_bindgen_test]
async fn an_agent_that_charged_does_so_no_longer_in_another_scene() {
    let mut state = reduce(&solved(), Action::Play(PlayAction::Pause));
    let time = state.plan().map_or(0, |plan| plan.charges("A2")[0]);
    state = reduce(&state, Action::Play(PlayAction::Seek(time)));
    let mut stage = Stage::of(state.clone()).await;
    stage.clock.follow(state.view.playback, state.last_time());
    stage.find(".chbadge[data-on]").await;
    let other = r#"{"giveway": 1, "map": ["..."], "agents":
        [{"name": "A1", "start": [0, 0], "goal": [1, 0]}, {"name": "A2", "start": [2, 0], "goal": [2, 0]}]}"#;
    stage.show(drafted(other));
    until("the other scene", || {
        stage.all("[role=gridcell]", "id").len() == 3
    })
    .await;
    until("the end of charging", || {
        stage.all(".chbadge[data-on]", "class").is_empty()
    })
    .await;
}

#[wasm_bindgen_test]
async fn a_name_is_text_whatever_it_is() {
    let scene = r#"{"giveway": 1, "map": ["..."], "agents":
        [{"name": "<b>x</b>", "start": [0, 0], "goal": [2, 0]}]}"#;
    let stage = Stage::of(drafted(scene)).await;
    let names = stage.all("[role=gridcell]", "aria-label");
    assert_eq!(names[0], "0, 0: start of <b>x</b>");
    let inspector = stage.find("[aria-label=Inspector]").await;
    let text = inspector.text_content().unwrap_or_default();
    assert!(text.contains("<b>x</b>"), "{text}");
    let inside = stage.place.query_selector("b b");
    assert_eq!(inside, Ok(None));
}

#[wasm_bindgen_test]
async fn the_overview_is_there_where_some_of_the_map_is_out_of_sight() {
    let stage = Stage::of(solved()).await;
    let board = stage.find("[role=grid]").await;
    let names = || stage.all(".overview[role=img]", "aria-label");
    assert_eq!(names().len(), 0);
    press(&board, "+");
    until("the overview", || names().len() == 1).await;
    let name = names().pop().unwrap_or_default();
    assert!(name.starts_with("Overview: columns "), "{name}");
    assert!(name.ends_with(" of 10 x 3 cells are in sight"), "{name}");
    // A dot for each of both robots, and a frame.
    let dots = stage.all(".overview .dots", "d").concat();
    assert_eq!(dots.matches('M').count(), 2, "{dots}");
    assert_eq!(stage.all(".overview .in-sight", "width").len(), 1);
    press(&board, "0");
    until("all of the map", || names().is_empty()).await;
}

#[wasm_bindgen_test]
async fn who_looks_elsewhere_is_no_longer_followed() {
    let mut state = reduce(&solved(), Action::Play(PlayAction::Pause));
    let select = BoardAction::Select(Selection::Agent(0));
    state = reduce(&state, Action::Board(select));
    state = reduce(&state, Action::View(ViewAction::Follow(true)));
    let free = reduce(&state, Action::View(ViewAction::Follow(false)));
    let mut stage = Stage::of(free).await;
    stage.show(state);
    gloo::timers::future::TimeoutFuture::new(50).await;
    let board = stage.find("[role=grid]").await;
    // Nearer and farther it goes along.
    press(&board, "+");
    press(&board, "-");
    assert_eq!(stage.sent(), []);
    press(&board, "0");
    assert_eq!(stage.sent(), [Action::View(ViewAction::Follow(false))]);
}
