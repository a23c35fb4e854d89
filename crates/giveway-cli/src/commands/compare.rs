//! `giveway compare`: two plans of one instance, side by side.

use giveway_model::check::check;
use giveway_model::compare::compare;
use giveway_model::words::count;

use super::one_standard_input;
use crate::{
    args::{Common, Compare},
    exit::Exit,
    failure::Failure,
    input::{Source, foreign},
    output::{self, Said, text},
};

pub(crate) fn run(args: &Compare, common: &Common) -> Result<Exit, Failure> {
    one_standard_input(&args.files)?;
    let sources = args.files.iter().map(|path| Source::read(path));
    let sources = sources.collect::<Result<Vec<Source>, Failure>>()?;
    let wanted = foreign::Wanted {
        map: common.map.as_deref(),
        agents: args.first.agents,
        reading: args.reading,
        ruling: args.ruling,
    };
    let combined = foreign::combine(&sources, wanted)?;
    let [one, other] = combined.plans.as_slice() else {
        return Err(Failure::Usage(format!(
            "found {}, expected two plans",
            count(combined.plans.len(), "plan")
        )));
    };
    let instance = &combined.instance;
    let compared = output::Compared {
        plans: [one, other].map(|plan| output::ComparedPlan {
            file: plan.file.clone(),
            format: plan.format,
            violations: check(instance, &plan.plan).violations.len(),
            conventions: plan.words.iter().cloned().collect(),
        }),
        comparison: compare(instance, &one.plan, &other.plan),
    };
    let mut said = Said::default();
    said.add(args.ruling.notes());
    said.add(combined.notes.iter().cloned());
    said.add([one, other].into_iter().flat_map(|plan| plan.notes.clone()));
    said.assume(instance);
    output::answer(common.format, &said, &compared, |_| {
        text::compare(instance, &compared)
    })?;
    Ok(Exit::Answered)
}
