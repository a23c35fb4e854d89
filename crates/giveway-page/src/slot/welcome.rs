//! What is said on a first visit: what this page is, and three ways on.

use giveway_course::learner::NEXT;
use giveway_course::tour::NAME;
use giveway_model::tr;

use super::message::{Button, Kind, Message, Press, Weight, button};
use crate::{Action, SlotAction};

pub(super) fn message() -> Message {
    Message {
        kind: Kind::Welcome,
        title: tr!("Robots share a floor. Who gives way?"),
        text: tr!(
            "Giveway finds the best plan for all of them and proves that none is better. Ask about \
             anything you see, and it tells you why."
        )
        .to_owned(),
        boards: None,
        buttons: vec![
            Button {
                remark: Some(tr!("how long the tour takes" => "2 min")),
                weight: Weight::Filled,
                ..button(tr!("Take the tour"), Some("play"), Press::Learn(NAME))
            },
            button(tr!("Start the course"), Some("course"), Press::Learn(NEXT)),
            Button {
                weight: Weight::Quiet,
                ..button(
                    tr!("Just play"),
                    None,
                    Press::Act(Box::new(Action::Slot(SlotAction::Close))),
                )
            },
        ],
        close: Some(Action::Slot(SlotAction::Close)),
    }
}
