//! Robots that are selected in the table come once more.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::tr_data;

use super::selected;
use crate::reduce::ask;
use crate::reduce::document::edit;
use crate::robots::{Column, Given, Target, take};
use crate::{Edit, State};

/// Those that are selected come once more: their starts and goals are the nearest free cells.
pub(super) fn duplicate(state: &mut State) {
    let draft = &state.document.draft;
    let mut given = Vec::new();
    for index in selected(state) {
        let Some(agent) = draft.agents().get(index) else {
            continue;
        };
        let mut cells: BTreeMap<Column, String> = Column::ALL
            .into_iter()
            .filter(|column| !column.is_result() && *column != Column::Name)
            .map(|column| (column, crate::robots::own_text(agent, column)))
            .collect();
        // What is taken gives way to its remedy: the nearest free cell.
        for _ in 0..2 {
            let mut tried: Vec<Given> = given.clone();
            tried.push(Given {
                target: Target::New,
                cells: cells.clone(),
            });
            let faults = take(draft, &tried).faults.pop().unwrap_or_default();
            for fault in faults {
                if let Some((_, text)) = fault.remedy {
                    cells.insert(fault.column, text);
                }
            }
        }
        given.push(Given {
            target: Target::New,
            cells,
        });
    }
    if given.is_empty() {
        return;
    }
    let before = draft.agents().len();
    let agents = take(draft, &given).agents;
    if agents.len() > crate::MAX_AGENTS {
        return ask::refuse(
            state,
            tr_data!(
                "At most {most} robots fit on the page.",
                most = crate::MAX_AGENTS
            ),
        );
    }
    let names = agents
        .iter()
        .skip(before)
        .map(|agent| agent.name.clone())
        .collect();
    edit(state, Edit::PutAgents(agents));
    state.view.robots.selected = Rc::new(names);
}
