//! What the solver does not know is never "solved": for each task of the course, its own
//! solution is not accepted where answers are missing, cut short, or of something else.

use giveway_course::judge::{Judging, Situation, begin, conclude};
use giveway_course::lesson::{Statement, Task};
use giveway_solve::explain::Verdict;
use giveway_solve::{Reach, Request, Response, SilentHost, Status, serve};

use super::tasks::each_solution;

/// How an answer proves less than it seems to.
#[derive(Clone, Copy, Debug)]
enum Cut {
    /// The budget ran out.
    Short,
    /// It holds up to a horizon only.
    Within,
}

/// The same answer, proving less.
fn cut(mut response: Response, cut: Cut) -> Response {
    let unproved = |status: &mut Status, reach: &mut Reach| {
        *reach = reach.of_bounds();
        *status = match (*status, cut) {
            (status, Cut::Within) => status,
            (Status::Optimal | Status::Feasible, Cut::Short) => Status::Feasible,
            (Status::Impossible | Status::Unknown, Cut::Short) => Status::Unknown,
        };
    };
    match &mut response {
        Response::Solved(answer) => unproved(&mut answer.status, &mut answer.reach),
        Response::Front(answer) => unproved(&mut answer.status, &mut answer.reach),
        Response::Freedom(answer) => unproved(&mut answer.status, &mut answer.reach),
        Response::Explained(answer) => {
            answer.reach = answer.reach.of_bounds();
            if matches!(cut, Cut::Short) {
                answer.verdict = Verdict::Unknown;
            }
        }
        Response::Audited(answer) => {
            answer.reach = answer.reach.of_bounds();
            answer.better = None;
            answer.better_costs = None;
        }
        _ => {}
    }
    response
}

#[test]
fn answers_that_prove_nothing_solve_nothing() {
    let mut asked = 0;
    each_solution(|place, situation, did| {
        let Some(Judging::Ask(requests)) = begin(situation, did) else {
            return;
        };
        asked += 1;
        let whole: Vec<Response> = requests.iter().map(|r| serve(r, &SilentHost)).collect();
        assert!(
            conclude(situation, did, &whole).unwrap().is_solved(),
            "{place}"
        );
        assert!(
            !conclude(situation, did, &[]).unwrap().is_solved(),
            "{place}: nothing"
        );
        let other = vec![serve(&super::tasks::check_request(situation), &SilentHost); whole.len()];
        assert!(
            !conclude(situation, did, &other).unwrap().is_solved(),
            "{place}: other"
        );
        for how in [Cut::Short, Cut::Within] {
            let less: Vec<Response> = whole.iter().map(|r| cut(r.clone(), how)).collect();
            // A plan that is there is one, proved best or not.
            let needs_no_proof = whole == less
                || matches!(requests.as_slice(), [one] if is_found(one, situation, &whole));
            let verdict = conclude(situation, did, &less).unwrap();
            assert!(needs_no_proof || !verdict.is_solved(), "{place}: {how:?}");
        }
    });
    assert!(asked > 25, "{asked}");
}

/// Whether a task asks for any plan, and one is there.
fn is_found(request: &Request, situation: Situation<'_>, responses: &[Response]) -> bool {
    let wants_any = matches!(
        &situation.step.task,
        Some(Task::Paint(task)) if matches!(task.until, Statement::Solvable {})
    );
    let is_there = matches!(responses, [Response::Solved(answer)] if answer.plan.is_some());
    wants_any && is_there && matches!(request, Request::Solve(_))
}
