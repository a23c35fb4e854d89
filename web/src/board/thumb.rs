//! A film as a small picture: forms without names. It is silent, since its title stands
//! beside it; while somebody points at that, it plays once through.

use std::rc::Rc;

use giveway_page::board::{CELL, FloorLook, Mark, MarkKind, Pose};
use giveway_page::form;
use giveway_picture::whole;
use gloo::render::{AnimationFrame, request_animation_frame};
use yew::prelude::*;

use super::film::Film;
use super::floor::FloorShapes;
use super::marks::{FLAG, FLAG_CLOTH, FLAG_POLE, STAR};
use super::reasons::burst;
use super::rules;
use crate::board::floor::FloorProps;
use crate::held::{Held, use_held};
use crate::part::part;

/// About how large a cell is, in pixels.
const CELL_PX: f64 = 12.0;
/// How long a step takes, in milliseconds.
const STEP_MS: f64 = 360.0;
/// How long the end is shown, in steps.
const REST: f64 = 2.0;

#[derive(Clone, Properties)]
pub(crate) struct ThumbProps {
    /// What is shown.
    pub(crate) film: Rc<Film>,
    /// Whether it plays.
    #[prop_or_default]
    pub(crate) plays: bool,
}

impl PartialEq for ThumbProps {
    fn eq(&self, other: &Self) -> bool {
        self.plays == other.plays && Rc::ptr_eq(&self.film, &other.film)
    }
}

/// The picture, as large as its place.
#[component]
pub(crate) fn Thumb(props: &ThumbProps) -> Html {
    let film = &props.film;
    let now = use_state(|| None::<f64>);
    let frame = use_held(|| None::<AnimationFrame>);
    {
        let (now, last) = (now.setter(), f64::from(film.last));
        use_effect_with(props.plays, move |&plays| {
            if plays {
                play(now, None, last, &frame);
            } else {
                drop(frame.take());
                now.set(None);
            }
        });
    }
    let time = (*now).unwrap_or_else(|| f64::from(film.time));
    let (width, height) = (film.draft.grid().width(), film.draft.grid().height());
    let flag = |mark: &Mark| flag(mark);
    let robots = film.tracks.iter().enumerate();
    let robots = robots.filter_map(|(index, track)| Some((index, track.pose(time)?)));
    let robots: Vec<(usize, Pose)> = robots.collect();
    let conflict = film.conflict.filter(|(at, _)| {
        let at = f64::from(*at);
        (at - 1.0..=at + 1.0).contains(&time)
    });
    html! {
        <svg class="map d-forms" viewBox={format!("-6 -6 {} {}", 100 * width + 12, 100 * height + 12)} aria-hidden="true">
            { part::<FloorShapes>(FloorProps { draft: Rc::clone(&film.draft), look: FloorLook::of(CELL_PX), used_by: None::<Rc<_>> }) }
            { rules::on_small(&film.draft, whole(time)) }
            { for (0..film.ways.len()).map(|index| way(film, index, time)) }
            { for film.marks.iter().map(flag) }
            { for robots.iter().filter(|(_, pose)| !pose.is_gone).map(|(index, pose)| robot(*index, pose, &robots)) }
            if let Some((_, place)) = conflict {
                { burst(place, CELL_PX) }
            }
        </svg>
    }
}

/// Shows one frame after the other, from time 0 on.
fn play(
    now: UseStateSetter<Option<f64>>,
    begun: Option<f64>,
    last: f64,
    frame: &Rc<Held<Option<AnimationFrame>>>,
) {
    let next = Rc::clone(frame);
    frame.set(Some(request_animation_frame(move |moment| {
        let begun = begun.unwrap_or(moment);
        let time = (moment - begun) / STEP_MS;
        if time > last + REST {
            now.set(None);
            return;
        }
        now.set(Some(time.min(last)));
        play(now, Some(begun), last, &next);
    })));
}

/// The way behind a robot, and the way ahead.
fn way(film: &Film, index: usize, time: f64) -> Html {
    let (way, pose) = (&film.ways[index], film.tracks[index].pose(time));
    let Some(pose) = pose else {
        return html! {};
    };
    let stop = way.last_stop(time);
    let ends = way.ends(stop, pose.at);
    html! {
        <g class={form::class(index)}>
            <polyline class="trail" points={way.behind(stop)} />
            <polyline class="trail" points={ends.behind} />
            <polyline class="ahead" points={way.ahead(stop)} />
            <polyline class="ahead" points={ends.ahead} stroke-dashoffset={format!("{:.1}", ends.ahead_offset)} />
        </g>
    }
}

fn flag(mark: &Mark) -> Html {
    let x = f64::from(mark.cell.x) * CELL + mark.shift.0;
    let y = f64::from(mark.cell.y) * CELL + mark.shift.1;
    match mark.kind {
        MarkKind::Goal => html! {
            <g class={classes!("flag", form::class(mark.agent))} transform={format!("translate({x} {y})")}>
                <path class="halo" d={FLAG} /><path class="pole" d={FLAG_POLE} /><path class="cloth" d={FLAG_CLOTH} />
            </g>
        },
        MarkKind::Waypoint => html! {
            <g class={classes!("star", form::class(mark.agent))} transform={format!("translate({} {})", x + 50.0, y + 42.0)}>
                <path class="halo" d={STAR} /><path class="body" d={STAR} />
            </g>
        },
    }
}

/// A robot; one that shares its cell stands beside the others.
fn robot(index: usize, pose: &Pose, all: &[(usize, Pose)]) -> Html {
    let is_here = |other: &Pose| {
        let apart = (other.at.x - pose.at.x).abs() + (other.at.y - pose.at.y).abs();
        apart < 0.05 && !other.is_gone
    };
    let here: Vec<usize> = all
        .iter()
        .filter(|(_, other)| is_here(other))
        .map(|(index, _)| *index)
        .collect();
    let (mut x, mut scale) = ((pose.at.x + 0.5) * CELL, 1.3);
    if here.len() > 1 {
        let place = here.iter().position(|&other| other == index).unwrap_or(0);
        x += if place == 0 { -25.0 } else { 25.0 };
        scale = 0.8;
    }
    let y = (pose.at.y + 0.5) * CELL;
    html! {
        <g class={form::class(index)} transform={format!("translate({x:.1} {y:.1}) scale({scale})")}>
            { crate::glyph::of_look(index) }
        </g>
    }
}
