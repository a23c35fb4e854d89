//! The shortest ways of the robots that rules leave no plan for, dotted.

use giveway_page::Draft;
use giveway_page::rules::{in_clash_robots, short_way};
use yew::prelude::*;

use crate::part::part;
use crate::same::Same;
use crate::{Shown, glyph};

/// On which map, and whose.
#[derive(Clone, PartialEq, Properties)]
struct ShortWaysProps {
    draft: Same<Draft>,
    robots: Vec<usize>,
}

/// The ways; nothing where there is a plan, or it is not known why there is none.
pub(super) fn show(state: &Shown) -> Html {
    let robots = in_clash_robots(state);
    if robots.is_empty() {
        return Html::default();
    }
    let draft = Same::new(state.document.draft.clone());
    part::<ShortWays>(ShortWaysProps { draft, robots })
}

#[component]
fn ShortWays(props: &ShortWaysProps) -> Html {
    let way = |&robot: &usize| {
        let cells = short_way(&props.draft, robot);
        let point =
            |cell: &giveway_model::Cell| format!("{},{}", 100 * cell.x + 50, 100 * cell.y + 50);
        let points: Vec<String> = cells.iter().map(point).collect();
        let points = points.join(" ");
        html! {
            <g key={robot} class={glyph::class(robot)}>
                <polyline class="ahead-halo" points={points.clone()} />
                <polyline class="ahead" {points} />
            </g>
        }
    };
    html! { <g class="short-ways" aria-hidden="true">{ for props.robots.iter().map(way) }</g> }
}
