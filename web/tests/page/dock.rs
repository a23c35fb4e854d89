//! The timeline: slider, transport, lanes, plan table.

use giveway_page::{Action, PlayAction, reduce};
use wasm_bindgen_test::wasm_bindgen_test;

use crate::stage::{Stage, click, drafted, press, solved};

#[wasm_bindgen_test]
async fn the_slider_tells_the_time_and_takes_keys() {
    let state = reduce(
        &reduce(&solved(), Action::Play(PlayAction::Pause)),
        Action::Play(PlayAction::Seek(7)),
    );
    let stage = Stage::of(state).await;
    let slider = stage.find("[role=slider][aria-label=Time]").await;
    let value = |name| slider.get_attribute(name);
    assert_eq!(value("aria-valuenow").as_deref(), Some("7"));
    assert_eq!(value("aria-valuemax").as_deref(), Some("18"));
    assert_eq!(value("aria-valuetext").as_deref(), Some("7 of 18"));
    for (key, action) in [
        ("ArrowRight", Action::Play(PlayAction::StepForward)),
        ("ArrowLeft", Action::Play(PlayAction::StepBack)),
        ("Home", Action::Play(PlayAction::Seek(0))),
        ("End", Action::Play(PlayAction::Seek(18))),
    ] {
        press(&slider, key);
        assert_eq!(stage.sent(), [action], "{key}");
    }
}

#[wasm_bindgen_test]
async fn the_transport_says_what_its_buttons_do() {
    let stage = Stage::of(reduce(&solved(), Action::Play(PlayAction::Pause))).await;
    for (title, action) in [
        ("Play (Space)", Action::Play(PlayAction::Play)),
        ("Step forward (.)", Action::Play(PlayAction::StepForward)),
        ("To end (End)", Action::Play(PlayAction::Seek(18))),
    ] {
        click(&stage.find(&format!("button[title='{title}']")).await);
        assert_eq!(stage.sent(), [action], "{title}");
    }
    let back = stage.find("button[title='Step back (,)']").await;
    assert!(back.has_attribute("disabled"), "there is no step before 0");
}

#[wasm_bindgen_test]
async fn the_plan_table_counts_rows_and_times() {
    let stage = Stage::of(solved()).await;
    let table = stage.find("table[aria-label=Plan]").await;
    // Cells and levels of two agents, below the times.
    assert_eq!(table.get_attribute("aria-rowcount").as_deref(), Some("5"));
    assert_eq!(table.get_attribute("aria-colcount").as_deref(), Some("20"));
}

#[wasm_bindgen_test]
async fn without_a_plan_there_is_no_time() {
    let stage = Stage::of(drafted(r#"{"giveway": 1, "map": [".."], "agents": []}"#)).await;
    assert_eq!(stage.place.query_selector("[role=slider]"), Ok(None));
}
