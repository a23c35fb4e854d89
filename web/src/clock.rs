//! One clock for the board and the playhead.
//!
//! The state knows whole steps only. Between two steps the clock tells its
//! listeners the time every frame, and they move what is theirs by hand; the
//! page is rendered anew once a step.

use std::cell::Cell;
use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_page::{Action, PlayAction, Playback};
use gloo::render::{AnimationFrame, request_animation_frame};
use yew::Callback;

use crate::held::Held;

/// Milliseconds of one step at speed 1: the design's `m-step`.
const STEP_MS: f64 = 480.0;
/// The longest time between two frames that is believed: a page in the
/// background gets none for long, and goes on where it was.
const LONGEST_FRAME_MS: f64 = 100.0;

/// The time shown, in steps, not whole while it plays.
#[derive(Clone)]
pub struct Clock(Rc<Inner>);

type Listener = Rc<dyn Fn(f64)>;

struct Inner {
    now: Cell<f64>,
    goal: Cell<Goal>,
    last_frame_ms: Cell<Option<f64>>,
    frame: Held<Option<AnimationFrame>>,
    listeners: Held<BTreeMap<u64, Listener>>,
    next: Cell<u64>,
    jumps: bool,
    send: Callback<Action>,
}

#[derive(Clone, Copy, Default)]
struct Goal {
    playback: Playback,
    last: u32,
}

impl PartialEq for Clock {
    fn eq(&self, other: &Self) -> bool {
        Rc::ptr_eq(&self.0, &other.0)
    }
}

/// Ends listening when it is dropped.
#[must_use]
pub struct Listening {
    clock: Clock,
    id: u64,
}

impl Drop for Listening {
    fn drop(&mut self) {
        let mut listeners = self.clock.0.listeners.take();
        let gone = listeners.remove(&self.id);
        self.clock.0.listeners.set(listeners);
        drop(gone);
    }
}

impl Clock {
    /// A clock at 0 that sends [`PlayAction::Reach`] at every step. With `jumps`,
    /// for people who want less motion, it knows whole steps only.
    pub fn new(send: Callback<Action>, jumps: bool) -> Self {
        Self(Rc::new(Inner {
            now: Cell::new(0.0),
            goal: Cell::default(),
            last_frame_ms: Cell::new(None),
            frame: Held::default(),
            listeners: Held::default(),
            next: Cell::new(0),
            jumps,
            send,
        }))
    }

    /// The same clock, at another time than 0.
    #[must_use]
    pub fn begun_at(self, time: f64) -> Self {
        self.0.now.set(time);
        self
    }

    /// The time shown, in steps.
    pub fn now(&self) -> f64 {
        let now = self.0.now.get();
        if self.0.jumps { now.floor() } else { now }
    }

    /// Calls a function with the time, at once and whenever it changes.
    pub fn listen(&self, listener: impl Fn(f64) + 'static) -> Listening {
        listener(self.now());
        let id = self.0.next.get();
        self.0.next.set(id + 1);
        let mut listeners = self.0.listeners.take();
        listeners.insert(id, Rc::new(listener));
        self.0.listeners.set(listeners);
        Listening {
            clock: self.clone(),
            id,
        }
    }

    /// Whether it plays: then every frame tells the time, and once more when it ends.
    pub fn plays(&self) -> bool {
        self.0.goal.get().playback.playing
    }

    /// Takes in what the state says of the time.
    pub fn follow(&self, playback: Playback, last: u32) {
        let inner = &self.0;
        let before = inner.goal.replace(Goal { playback, last });
        let now = inner.now.get();
        let plays = playback.playing;
        let paused = before.playback.playing && !plays && !playback.sought;
        if paused && playback.time == before.playback.time && now > f64::from(playback.time) {
            // Nobody stops between two steps, and nobody walks back.
            inner
                .send
                .emit(Action::Play(PlayAction::Seek(playback.time + 1)));
            return;
        }
        let target = f64::from(playback.time);
        let far = (target - now).abs() > 1.0 || (inner.jumps && !plays);
        let behind = plays && (now < target || now >= target + 1.0);
        if far || behind {
            inner.now.set(target);
        }
        if far || behind || plays != before.playback.playing {
            self.tell();
        }
        if plays || (inner.now.get() - target).abs() > f64::EPSILON {
            self.wake();
        }
    }

    fn tell(&self) {
        let now = self.now();
        for listener in self.0.listeners.get().values() {
            listener(now);
        }
    }

    fn wake(&self) {
        let frame = self.0.frame.take();
        if frame.is_some() {
            self.0.frame.set(frame);
            return;
        }
        self.0.last_frame_ms.set(None);
        self.next_frame();
    }

    fn next_frame(&self) {
        let clock = self.clone();
        let frame = request_animation_frame(move |at| clock.tick(at));
        self.0.frame.set(Some(frame));
    }

    fn tick(&self, at_ms: f64) {
        let inner = &self.0;
        drop(inner.frame.take());
        let since = inner.last_frame_ms.replace(Some(at_ms));
        let elapsed_ms = since.map_or(0.0, |since| (at_ms - since).clamp(0.0, LONGEST_FRAME_MS));
        let Goal { playback, last } = inner.goal.get();
        let way = elapsed_ms / STEP_MS * playback.speed.factor();
        let now = inner.now.get();
        let target = f64::from(playback.time);
        let (then, goes_on) = if playback.playing {
            let then = (now + way).min(f64::from(last));
            (then, then < f64::from(last))
        } else {
            let then = now + (target - now).clamp(-way, way);
            (then, (then - target).abs() > f64::EPSILON)
        };
        inner.now.set(then);
        self.tell();
        if goes_on {
            self.next_frame();
        }
        if playback.playing && then >= target + 1.0 {
            let steps = std::iter::successors(Some(playback.time), |time| time.checked_add(1));
            let reached = steps.take_while(|&time| f64::from(time) <= then).last();
            inner
                .send
                .emit(Action::Play(PlayAction::Reach(reached.unwrap_or(last))));
        }
    }
}
