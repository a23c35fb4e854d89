//! `giveway report`: a plan on paper, with what is proved of it.

use giveway_model::{Cost, Instance, Plan};
use giveway_picture::report::{Known, LoneDelay, Proved, Report, Subject};
use giveway_solve::audit::{AuditRequest, AuditStatus, words::headline_under};
use giveway_solve::delays::{
    AgentDelay, DelaysRequest,
    words::{passes, row},
};
use giveway_solve::words::{on_paper, proved, reach_of_bounds, reason};
use giveway_solve::{
    CheckRequest, Limits, Refusal, Request, Response, SolveAnswer, SolveRequest, serve,
};

use super::{one_standard_input, refused, unexpected};
use crate::{
    args::{Common, Report as Args},
    clock::Clock,
    exit::Exit,
    failure::Failure,
    input,
    output::{Said, files, report::Link, stream},
    progress::CommandHost,
};

pub(crate) fn run(args: &Args, common: &Common, clock: Clock) -> Result<Exit, Failure> {
    let inputs = [&args.source.instance].into_iter().chain(&args.plan);
    one_standard_input(inputs.chain(&args.changes))?;
    let mut said = Said::default();
    let mut instance = input::instance(&args.source, args.plan.as_deref(), common, &mut said)?;
    if let Some(objective) = &args.objective {
        instance = instance.with_objective(objective.clone());
    }
    let changes = args.changes.as_deref().map(input::changes).transpose()?;
    let asker = Asker {
        args,
        common,
        clock,
        instance: &instance,
    };
    let (plan, mut known, exit) = match &args.plan {
        None => asker.solved()?,
        Some(path) => {
            let plan = match &changes {
                None => input::plan(path, &instance, common, &mut said)?,
                Some(_) => input::plan_over_time(path, &instance, common, &mut said)?,
            };
            let (known, exit) = match &changes {
                None => asker.audited(&plan)?,
                Some(file) => asker.checked(&plan, file)?,
            };
            (plan, known, exit)
        }
    };
    known.date.clone_from(&args.date);
    if let Exit::Answered = exit {
        known.delays = asker.delays(&plan, changes.as_ref());
        if changes.is_none() {
            let scene = instance.to_scene();
            let link = Link::planned(args.address.as_ref(), &scene, &plan);
            known.link = link.address().map(str::to_owned);
        }
    }
    if !common.quiet {
        for note in said.notes() {
            stream::note(&format!("note: {note}"));
        }
    }
    let subject = Subject::new(&instance, &plan, changes.as_ref().map(|file| &file.changes));
    let subject = subject.map_err(|faults| match &changes {
        Some(file) => file.refused(faults),
        None => unexpected(&args.source.instance),
    })?;
    let report = Report::of(&subject, known);
    let tables = [
        (args.csv.as_ref(), subject.csv()),
        (args.robots.as_ref(), report.csv()),
    ];
    let page = report.page("en");
    let tables = tables.into_iter().filter_map(|(path, text)| {
        let path = path?.clone();
        Some(files::NewFile { path, text })
    });
    let mut written: Vec<files::NewFile> = tables.collect();
    match &args.output {
        Some(path) => written.push(files::NewFile {
            path: path.clone(),
            text: page,
        }),
        None => stream::file(page.as_bytes())?,
    }
    files::write_all(&written)?;
    Ok(exit)
}

/// What the delays of a plan may take, in seconds.
const DELAYS_SECONDS: f64 = 5.0;

/// What is asked of the service.
struct Asker<'a> {
    args: &'a Args,
    common: &'a Common,
    clock: Clock,
    instance: &'a Instance,
}

impl Asker<'_> {
    fn ask(&self, request: &Request) -> Response {
        let objective = self.instance.objective().clone();
        let host = CommandHost::new(self.clock, self.common.quiet, objective);
        let response = serve(request, &host);
        host.finish();
        response
    }

    fn limits(&self) -> Limits {
        self.clock.limits(Some(self.args.time_limit))
    }

    /// The best plan that is found.
    fn solved(&self) -> Result<(Plan, Known, Exit), Failure> {
        let request = Request::Solve(SolveRequest {
            scene: self.instance.to_scene(),
            objective: None,
            pareto: false,
            within: None,
            start: None,
            trace: false,
            limits: self.limits(),
            as_found: false,
        });
        let file = &self.args.source.instance;
        match self.ask(&request) {
            Response::Solved(answer) => match answer.plan.clone() {
                Some(plan) => Ok((plan, of_solved(&answer), Exit::Answered)),
                None => Err(Failure::Refused(vec![giveway_solve::words::claim(&answer)])),
            },
            Response::Refused(refusal) => Err(refused(refusal, file)),
            _ => Err(unexpected(file)),
        }
    }

    /// How good a plan is.
    fn audited(&self, plan: &Plan) -> Result<(Known, Exit), Failure> {
        let request = Request::Audit(AuditRequest {
            scene: self.instance.to_scene(),
            plan: plan.clone(),
            objective: None,
            within: None,
            limits: self.limits(),
        });
        let file = &self.args.source.instance;
        let answer = match self.ask(&request) {
            Response::Audited(answer) => answer,
            Response::Refused(refusal) => return Err(refused(refusal, file)),
            _ => return Err(unexpected(file)),
        };
        let is_proved = answer.status == AuditStatus::Optimal;
        let exit = match answer.status {
            AuditStatus::Optimal | AuditStatus::Feasible => Exit::Answered,
            AuditStatus::Illegal => Exit::Wrong,
            AuditStatus::Unknown => Exit::Unknown,
        };
        let known = Known {
            claim: if is_proved {
                proved(answer.reach.within())
            } else {
                headline_under(&answer, self.instance.assumptions()).to_string()
            },
            proved: if is_proved {
                Proved::within(answer.reach.within())
            } else {
                Proved::No
            },
            bounds: bounds(&answer.bounds),
            ..Known::default()
        };
        Ok((known, exit))
    }

    /// What each robot loses against its way alone; nothing where that is not found in time.
    fn delays(&self, plan: &Plan, changes: Option<&input::ChangesFile>) -> Vec<LoneDelay> {
        let request = Request::Delays(DelaysRequest {
            scene: self.instance.to_scene(),
            plan: Some(plan.clone()),
            changes: changes.map(|file| file.changes.clone()),
            ledger_only: true,
            // A search that took all of the time leaves some for what its plan costs whom.
            limits: Limits {
                seconds: Some(self.args.time_limit.min(DELAYS_SECONDS)),
                ..Limits::default()
            },
            ..DelaysRequest::default()
        });
        let Response::Delays(answer) = self.ask(&request) else {
            return Vec::new();
        };
        let lone = |told: &AgentDelay| LoneDelay {
            robot: told.agent.clone(),
            alone: told.alone,
            delay: told.delay,
            passes: passes(told),
            why: row(told),
        };
        answer.agents.iter().map(lone).collect()
    }

    /// Whether a plan around which the world changes keeps the rules.
    fn checked(&self, plan: &Plan, changes: &input::ChangesFile) -> Result<(Known, Exit), Failure> {
        let request = Request::Check(CheckRequest {
            scene: self.instance.to_scene(),
            plan: plan.clone(),
            changes: Some(changes.changes.clone()),
        });
        let file = &self.args.source.instance;
        let answer = match self.ask(&request) {
            Response::Checked(answer) => answer,
            Response::Refused(Refusal::Changes { faults }) => return Err(changes.refused(faults)),
            Response::Refused(refusal) => return Err(refused(refusal, file)),
            _ => return Err(unexpected(file)),
        };
        let violations = answer.violations.len();
        let known = Known {
            claim: match violations {
                0 => "The plan keeps every rule. Whether it is the best was not asked.".to_owned(),
                1 => "The plan breaks a rule.".to_owned(),
                n => format!("The plan breaks rules: {n} violations."),
            },
            remarks: answer
                .violations
                .first()
                .map(|violation| violation.message.clone())
                .into_iter()
                .collect(),
            ..Known::default()
        };
        let exit = if answer.valid {
            Exit::Answered
        } else {
            Exit::Wrong
        };
        Ok((known, exit))
    }
}

/// What a search says of its plan.
fn of_solved(answer: &SolveAnswer) -> Known {
    let (claim, is_proved) = on_paper(answer);
    let reach = reach_of_bounds(answer);
    Known {
        claim,
        proved: match reach {
            _ if is_proved => Proved::within(answer.reach.within()),
            None => Proved::Bounded,
            Some(_) => Proved::No,
        },
        remarks: answer
            .reason
            .as_ref()
            .map(reason)
            .into_iter()
            .chain(reach)
            .collect(),
        bounds: bounds(&answer.bounds),
        ..Known::default()
    }
}

fn bounds(bounds: &std::collections::BTreeMap<Cost, u32>) -> Vec<(Cost, u32)> {
    bounds.iter().map(|(&cost, &least)| (cost, least)).collect()
}
