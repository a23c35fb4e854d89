//! Inspector and tools.

use giveway_page::planners::By;
use giveway_page::{Action, BoardAction, Selection, SolveAction, Tool, WorkerAction, reduce};
use giveway_solve::plan::Planner;
use giveway_solve::{SilentHost, serve};
use wasm_bindgen_test::wasm_bindgen_test;

use crate::stage::{Stage, click, solved};

#[wasm_bindgen_test]
async fn the_plan_as_a_whole_and_its_agents_to_pick() {
    let stage = Stage::of(solved()).await;
    let costs = stage
        .find("[aria-label=Inspector] table[aria-label=Costs]")
        .await;
    let text = costs.text_content().unwrap_or_default();
    for part in ["Makespan18", "Sum of costs35", "Charges3"] {
        assert!(text.contains(part), "{part}: {text}");
    }
    click(
        &stage
            .find("[aria-label=Inspector] .choices li:nth-child(2) button")
            .await,
    );
    assert_eq!(
        stage.sent(),
        [Action::Board(BoardAction::Select(Selection::Agent(1)))]
    );
}

#[wasm_bindgen_test]
async fn the_agent_that_is_selected() {
    let state = reduce(
        &solved(),
        Action::Board(BoardAction::Select(Selection::Agent(1))),
    );
    let stage = Stage::of(state).await;
    let title = stage.find("[aria-label=Inspector] h2").await;
    assert_eq!(title.text_content().as_deref(), Some("A2"));
}

#[wasm_bindgen_test]
async fn one_tool_is_pressed() {
    let stage = Stage::of(reduce(
        &solved(),
        Action::Board(BoardAction::PickTool(Tool::Charger)),
    ))
    .await;
    let pressed = stage.all("[role=toolbar] [aria-pressed=true]", "aria-label");
    assert_eq!(pressed, ["Charger"]);
    click(&stage.find("[role=toolbar] [aria-label='Slow zone']").await);
    assert_eq!(
        stage.sent(),
        [Action::Board(BoardAction::PickTool(Tool::SlowZone))]
    );
}

#[wasm_bindgen_test]
async fn planners_side_by_side() {
    let plan = Action::Solve(SolveAction::Plan(Planner::Pibt));
    let state = reduce(&solved(), plan);
    let (job, request) = state.work.request().expect("it runs");
    let response = Box::new(serve(&request, &SilentHost));
    let state = reduce(
        &state,
        Action::Worker(WorkerAction::Respond { job, response }),
    );
    let stage = Stage::of(state).await;
    let table = stage.find("table[aria-label=Planners]").await;
    let text = table.text_content().unwrap_or_default();
    for part in ["18, 35, 3", "proved best", "PIBT cannot plan for waypoints"] {
        assert!(text.contains(part), "{part}: {text}");
    }
    click(&stage.find("table[aria-label=Planners] th button").await);
    assert_eq!(
        stage.sent(),
        [Action::Solve(SolveAction::ShowPlan(By::Search))]
    );
}
