//! Lanes and plan table: two places that scroll sideways as one.

use std::rc::Rc;

use giveway_model::tr;
use giveway_page::audit;
use giveway_page::beside as compared;
use giveway_page::inside::Note;
use giveway_page::steering::Steering;
use giveway_page::timeline::{Lane, Row, shown_names};
use giveway_page::{
    Action, Answer, BoardAction, PlayAction, Selection, Tab, ViewAction, changing, freedom, order,
    table,
};
use web_sys::Element;
use yew::prelude::*;

use super::epochs;
use super::head::{Moved, use_head};
use super::lane::{LaneLabel, LaneRow};
use super::order as links;
use super::plan_table::PlanTable;
use super::rest;
use super::ruler::Ruler;
use super::rules;
use super::seen::{Extent, Seen, use_seen};
use super::selected::{lane_of, selected_lane, selection, use_selected_in_view};
use crate::Shown;
use crate::held::use_held;
use crate::part::part;
use crate::same::Same;
use crate::timeline::plan_table::PlanTableProps;
use crate::timeline::ruler::RulerProps;

#[derive(Clone, PartialEq, Properties)]
pub(super) struct PlanProps {
    pub answer: Same<Answer>,
    /// The plan beside it.
    pub beside: Option<Same<Answer>>,
    /// Of an order: what the lanes say, in the order in which robots plan.
    pub notes: Option<Rc<Vec<Note>>>,
    pub state: Shown,
    pub send: Callback<Action>,
}

/// The lanes with their ruler, and the plan table below them.
#[component]
pub(super) fn Plan(props: &PlanProps) -> Html {
    let PlanProps {
        answer,
        beside,
        notes,
        state,
        send,
    } = props;
    let draft = Same::new(Rc::clone(&state.document.draft));
    // While two plans are compared: the robots that differ. In the order at a cell: who passes it first.
    let only = notes.is_none().then(|| compared::lanes(state));
    let only = only.flatten().or_else(|| order::lanes(state));
    let lanes = use_memo(
        (answer.clone(), draft.clone(), notes.clone(), only.clone()),
        |(answer, draft, notes, only)| {
            let mut lanes = table::lanes(answer, draft);
            if let Some(only) = only {
                let place = |lane: &Lane| only.iter().position(|name| *name == lane.name);
                lanes.retain(|lane| place(lane).is_some());
                lanes.sort_by_key(place);
            }
            if let Some(notes) = notes {
                let place = |lane: &Lane| notes.iter().position(|note| note.agent == lane.agent);
                lanes.sort_by_key(place);
            }
            lanes
        },
    );
    let lanes = Same::new(lanes);
    let world = Same::new(Rc::clone(state.world()));
    let names = use_memo((lanes.clone(), world), |(lanes, world)| {
        let names: Vec<&str> = lanes.iter().map(|lane| lane.name.as_str()).collect();
        shown_names(&names, world.agents())
    });
    let names = Same::new(names);
    let batteries = lanes.iter().filter(|lane| lane.capacity.is_some()).count();
    let open = Same::new(Rc::clone(state.world_of(state.beside())));
    let others = use_memo((beside.clone(), open), |(beside, draft)| match beside {
        Some(beside) => table::lanes(beside, draft),
        None => Vec::<Lane>::new(),
    });
    let others = Same::new(others);
    let row = if beside.is_some() {
        Row::HALF
    } else if notes.is_some() {
        Row::WIDE
    } else {
        Row::of(lanes.len(), batteries)
    };
    let selected = selected_lane(state, &lanes);
    // Among many the lane of the robot selected stays below the ruler.
    let pinned = selected.filter(|_| row == Row::MANY);
    let rest = lanes.len() - usize::from(pinned.is_some());
    let plans = if beside.is_some() { 2.0 } else { 1.0 };
    let height = plans * row.height;
    let last = beside.as_ref().map_or(0, |beside| beside.makespan());
    // Waits at a goal, until it is left again.
    let led = state
        .document
        .mode
        .steering()
        .map_or(0, |own| Steering::time(own));
    let stop = notes
        .iter()
        .flat_map(|notes| notes.iter())
        .find_map(|note| note.stop.as_ref());
    let stop = stop.map_or(0, |stop| stop.time + stop.room());
    let fate = |name: &str| {
        let fate = changing::fate(state, name).or_else(|| freedom::late(state, name));
        fate.or_else(|| order::fate(state, name))
    };
    let extent = Extent {
        last: answer.makespan().max(last).max(led).max(stop),
        lanes: rest,
        lane: height,
        rows: table::rows(&lanes, pinned)[1].len(),
        least: table::least_column(answer),
        tells: lanes.iter().any(|lane| fate(&lane.name).is_some()),
    };
    let (lanes_ref, table_ref) = (use_node_ref(), use_node_ref());
    let (seen, look) = use_seen(
        extent,
        &lanes_ref,
        &table_ref,
        state.view.tab,
        state.view.table,
    );
    // What was seen was seen of the plan before this one.
    let seen = seen.within(extent);
    let axis = seen.axis(extent);
    let moved = Moved {
        head: use_node_ref(),
        thumb: use_node_ref(),
        places: [lanes_ref.clone(), table_ref.clone()],
    };
    use_head(&moved, axis, &seen, state.view.playback.playing);

    let focus = use_held(|| None::<usize>);
    let sought = selected.filter(|_| pinned.is_none());
    use_selected_in_view(sought, extent, &lanes_ref, &focus);
    let pick = {
        let (state, lanes) = (state.clone(), lanes.clone());
        let send = send.clone();
        Callback::from(move |(index, time): (usize, Option<u32>)| {
            let again = selected_lane(&state, &lanes) == Some(index);
            let to = if again && time.is_none() {
                Selection::Nothing
            } else {
                selection(&state, &lanes, index)
            };
            send.emit(Action::Board(BoardAction::Select(to)));
            // The question about a wait or a charge is there at its time; a phone has it in
            // another tab.
            if let Some(time) = time {
                send.emit(Action::Play(PlayAction::Seek(time)));
                send.emit(Action::View(ViewAction::ShowTab(Tab::Inspector)));
            }
        })
    };
    let onkeydown = {
        let (state, lanes, send) = (state.clone(), lanes.clone(), send.clone());
        move |event: KeyboardEvent| {
            let Some(at) = lane_of(&event) else { return };
            let to = match event.key().as_str() {
                "ArrowDown" => at + 1,
                "ArrowUp" if at > 0 => at - 1,
                _ => return,
            };
            if to < lanes.len() {
                event.prevent_default();
                event.stop_propagation();
                focus.set(Some(to));
                send.emit(Action::Board(BoardAction::Select(selection(
                    &state, &lanes, to,
                ))));
            }
        }
    };
    let scrolled = |from: &NodeRef, to: &NodeRef| {
        let (from, to, look) = (from.clone(), to.clone(), look.clone());
        move |_: Event| {
            if let (Some(from), Some(to)) = (from.cast::<Element>(), to.cast::<Element>())
                && to.scroll_left() != from.scroll_left()
            {
                to.set_scroll_left(from.scroll_left());
            }
            look();
        }
    };

    let time = state.view.playback.time;
    let (above, below) = Seen::beyond(&seen.lanes, rest, height);
    // From a place among the lanes that scroll to the lane.
    let lane_at = |place: usize| place + usize::from(pinned.is_some_and(|pinned| place >= pinned));
    let tab_stop = sought.filter(|index| seen.lanes.contains(index)).or(pinned);
    let tab_stop = tab_stop.unwrap_or(seen.lanes.start);
    let lane_row = |index: usize| {
        let is_pinned = pinned == Some(index);
        let row = if is_pinned { Row::PINNED } else { row };
        let name = names.get(index).cloned();
        html! {
            <LaneRow key={index} name={name.unwrap_or_default()} lanes={lanes.clone()} others={others.clone()} {index} {axis} {row} columns={seen.columns.clone()}
                in_zone={lanes.get(index).map(|lane| giveway_page::rules::in_lit_zone(state, &lane.name)).unwrap_or_default()}
                bursts={lanes.get(index).map(|lane| audit::bursts_of(state, &lane.name)).unwrap_or_default()}
                label={LaneLabel::of(lanes.get(index), time)}
                fate={lanes.get(index).and_then(|lane| fate(&lane.name))} selected={selected == Some(index)}
                note={notes.as_ref().and_then(|notes| notes.get(index)).cloned()}
                marks={lanes.get(index).and_then(|lane| freedom::lane(state, &lane.name))}
                tab_stop={index == tab_stop} {is_pinned} pick={pick.clone()} />
        }
    };
    // The names of lanes and of the table are equally wide.
    let tells = extent.tells.then_some("tells");
    let gutter = seen.gutter.then_some("gutter");
    let spacer = |height: f64| {
        let height = height.to_string();
        (height != "0")
            .then(|| html! { <svg class="spacer" width="1" {height} aria-hidden="true" /> })
    };
    html! {
        <>
            <div class={classes!("lanes", row.class(), tells, gutter)} id="lanes" ref={lanes_ref.clone()}
                onscroll={scrolled(&lanes_ref, &table_ref)}>
                <div class="rows">
                    { part::<Ruler>(RulerProps { axis, columns: seen.columns.clone(), time, thumb: moved.thumb.clone(), send: send.clone() }) }
                    { rules::show(state, axis, send) }
                    <div role="group" class={classes!(state.shows_order().then_some("in-order"))} aria-label={tr!("Lanes")} {onkeydown}>
                        { for pinned.map(lane_row) }
                        { spacer(above) }
                        { for seen.lanes.clone().map(|place| lane_row(lane_at(place))) }
                        { spacer(below) }
                        if pinned.is_none() && beside.is_none() { { links::show(state, axis, row, lanes.len()) } }
                    </div>
                    { rest::show(state, lanes.len(), send) }
                    { epochs::show(state, axis) }
                    <i class="head" ref={moved.head.clone()}></i>
                </div>
            </div>
            <div class={classes!("tblwrap", (row == Row::MANY).then_some("many"), tells, (!state.view.table || notes.is_some()).then_some("closed"), gutter)} id="plan-table" ref={table_ref.clone()}
                role="group" aria-label={tr!("Plan table")} tabindex="0"
                onscroll={scrolled(&table_ref, &lanes_ref)}>
                { part::<PlanTable>(PlanTableProps { lanes: lanes.clone(), names: names.clone(), axis, label: seen.label, columns: seen.columns.clone(), pinned, rows: seen.rows.clone(), beyond: seen.beyond_rows(extent), time }) }
            </div>
        </>
    }
}
