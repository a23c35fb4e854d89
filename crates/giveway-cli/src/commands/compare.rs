//! `giveway compare`: two plans of one instance, side by side.

use giveway_model::check::check;
use giveway_model::compare::compare;
use giveway_model::words::count;

use super::one_standard_input;
use crate::{
    args::{Common, Compare},
    exit::Exit,
    failure::Failure,
    input::{self, Source, foreign},
    output::{self, text},
};

pub(crate) fn run(args: &Compare, common: &Common) -> Result<Exit, Failure> {
    one_standard_input(&args.files)?;
    let sources = args.files.iter().map(|path| Source::read(path));
    let sources = sources.map(|source| input::bare(source?));
    let sources = sources.collect::<Result<Vec<Source>, Failure>>()?;
    let wanted = foreign::Wanted {
        map: common.map.as_deref(),
        agents: args.first.agents,
        reading: args.reading,
    };
    let gathered = foreign::gather(&sources, wanted)?;
    let [one, other] = gathered.plans.as_slice() else {
        return Err(Failure::Usage(format!(
            "found {}, expected two plans",
            count(gathered.plans.len(), "plan")
        )));
    };
    let instance = &gathered.instance;
    let compared = output::Compared {
        plans: [one, other].map(|plan| output::ComparedPlan {
            file: plan.file.clone(),
            format: plan.format,
            violations: check(instance, &plan.plan).violations.len(),
        }),
        comparison: compare(instance, &one.plan, &other.plan),
    };
    output::answer(common.format, &compared, |_| {
        text::compare(instance, &compared)
    })?;
    Ok(Exit::Answered)
}
