//! The constraint tree: an SVG whose nodes are the items of a tree.

use giveway_model::tr;
use giveway_page::Action;
use giveway_page::inside::{Fold, InsideAction, NodeBox, TreeView};
use web_sys::Element;
use yew::prelude::*;

use crate::glyph;

#[derive(Clone, PartialEq, Properties)]
pub(super) struct TreeProps {
    pub view: TreeView,
    pub send: Callback<Action>,
}

/// The tree, with the chosen node in sight.
#[component]
pub(super) fn Tree(props: &TreeProps) -> Html {
    let TreeProps { view, send } = props;
    let place = use_node_ref();
    let chosen = view.nodes.iter().find(|node| node.is_chosen);
    {
        let place = place.clone();
        let at = chosen.map(|node| node.at);
        use_effect_with(at, move |at| {
            if let (Some(at), Some(place)) = (*at, place.cast::<Element>()) {
                bring(&place, at);
            }
        });
    }
    let onkeydown = {
        let (view, send) = (view.clone(), send.clone());
        move |event: KeyboardEvent| {
            let Some(to) = towards(&view, &event.key()) else {
                return;
            };
            event.prevent_default();
            event.stop_propagation();
            send.emit(Action::Inside(InsideAction::Node(to)));
        }
    };
    let (width, height) = view.size;
    let [lines, on] = view.lines.clone();
    html! {
        <div class="treew lanes" id="lanes" ref={place}>
            <svg class="tree" role="tree" aria-label={tr!("Conflict tree")} tabindex="0" width={width.to_string()} height={height.to_string()}
                aria-activedescendant={chosen.map(|node| id(node.id))} {onkeydown}>
                <path class="e" d={lines} role="presentation" />
                <path class="e on" d={on} role="presentation" />
                <path class="e gh" d={view.ghost_lines.clone()} role="presentation" />
                { for view.nodes.iter().map(|node| node_box(node, send)) }
                <g aria-hidden="true">{ for view.ghosts.iter().map(ghost) }</g>
                { for view.folds.iter().map(fold) }
            </svg>
        </div>
    }
}

fn id(node: u64) -> String {
    format!("node-{node}")
}

fn node_box(node: &NodeBox, send: &Callback<Action>) -> Html {
    let (x, y) = node.at;
    let number = node.id;
    let choose = send.reform(move |_| Action::Inside(InsideAction::Node(number)));
    html! {
        <g key={number} id={id(number)} class={classes!("node", node.class, node.is_chosen.then_some("sel"))} role="treeitem"
            transform={format!("translate({x} {y})")} aria-label={node.name.clone()} aria-level={node.level.to_string()}
            aria-posinset={node.place.0.to_string()} aria-setsize={node.place.1.to_string()}
            aria-selected={node.is_chosen.to_string()} aria-expanded={node.is_expanded.map(|is| is.to_string())} onclick={choose}>
            { content(node) }
        </g>
    }
}

/// A branch that a split would make.
fn ghost(node: &NodeBox) -> Html {
    let (x, y) = node.at;
    html! {
        <g class={classes!("node", node.class)} transform={format!("translate({x} {y})")}>{ content(node) }</g>
    }
}

fn content(node: &NodeBox) -> Html {
    let (width, height) = NodeBox::SIZE;
    let [first, second] = node.lines.clone();
    html! {
        <>
            <rect class="nb" width={width.to_string()} height={height.to_string()} rx="8" />
            <text class="c" x="14" y="25">{ node.cost.clone() }</text>{ " " }
            <text class="t t1" x="44" y="16.5">{ first }</text>{ " " }
            <text class="t" x="44" y="30.5">{ second }</text>
            if let Some(agent) = node.agent {
                <g class={glyph::class(agent)} transform="translate(0 19)">
                    <circle class="cirb" r="8.5" /><g transform="scale(.24)">{ crate::form(agent) }</g>
                </g>
            }
        </>
    }
}

fn fold(fold: &Fold) -> Html {
    let (x, y) = fold.at;
    html! {
        <text class="fold" x={x.to_string()} y={(y + 4.0).to_string()} aria-hidden="true">{ format!("+ {}", fold.count) }</text>
    }
}

/// The node that an arrow key leads to: left the parent, right the first child, up
/// and down the one that was drawn before and after.
fn towards(view: &TreeView, key: &str) -> Option<u64> {
    let at = view.nodes.iter().position(|node| node.is_chosen)?;
    let level = view.nodes.get(at)?.level;
    let to = match key {
        "ArrowLeft" => view.nodes[..at]
            .iter()
            .rposition(|node| node.level < level)?,
        "ArrowRight" => {
            let next = view.nodes.get(at + 1)?;
            (next.level > level).then_some(at + 1)?
        }
        "ArrowUp" => at.checked_sub(1)?,
        "ArrowDown" => at + 1,
        "Home" => 0,
        "End" => view.nodes.len() - 1,
        _ => return None,
    };
    view.nodes.get(to).map(|node| node.id)
}

/// Brings a node into the left third of what is seen, and its row into sight.
fn bring(place: &Element, (x, y): (f64, f64)) {
    let (width, height) = NodeBox::SIZE;
    let (wide, high) = (
        f64::from(place.client_width()),
        f64::from(place.client_height()),
    );
    let left = f64::from(place.scroll_left());
    if x < left || x + width > left + wide * 0.66 {
        place.set_scroll_left((x - wide / 6.0).max(0.0) as i32);
    }
    let top = f64::from(place.scroll_top());
    if y < top || y + height > top + high {
        place.set_scroll_top((y - (high - height) / 2.0).max(0.0) as i32);
    }
}
