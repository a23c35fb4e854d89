//! The tour on its way: it begins, goes on and ends.

use giveway_course::learner;
use giveway_course::port::BoardNumber;
use giveway_course::tour::{self, Tour};
use yew::prelude::*;

use crate::course::contents::Page;
use crate::course::tutor::Tutor;

impl Tutor {
    /// Begins the tour, from the start where somebody is on it.
    pub(in crate::course) fn begin_tour(&mut self, ctx: &Context<Self>) {
        self.act(ctx, learner::Action::Close);
        self.page = None;
        let (tour, effects) = tour::begin(self.tours);
        self.toured(Some(tour), effects);
    }

    /// Something happens on the tour; nothing, while nobody is on it.
    pub(in crate::course) fn guide(&mut self, action: tour::Action) {
        if let Some(tour) = self.tour.take() {
            let (tour, effects) = tour::reduce(tour, action);
            self.toured(tour, effects);
        }
    }

    fn toured(&mut self, tour: Option<Tour>, effects: Vec<tour::Effect>) {
        if let Some(tour) = &tour {
            self.tours = BoardNumber(tour.number().0.wrapping_add(1));
        }
        self.tour = tour;
        for effect in effects {
            match effect {
                tour::Effect::Page(message) => self.effect(learner::Effect::Page(message)),
                tour::Effect::Contents => self.page = Some(Page::Lessons),
            }
        }
    }
}
