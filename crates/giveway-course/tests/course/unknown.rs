//! What the solver does not know is never "solved": for each task of the course, its own
//! solution is not accepted where answers are missing, cut short, or of something else.

use giveway_course::judge::{Judging, begin, conclude};
use giveway_solve::explain::Verdict;
use giveway_solve::{Response, SilentHost, Status, serve};

use super::tasks::each_solution;

/// The same answer, as it would be had the budget run out.
fn cut_short(mut response: Response) -> Response {
    let unproved = |status: &mut Status, complete: &mut bool| {
        *complete = false;
        *status = match *status {
            Status::Optimal | Status::Feasible => Status::Feasible,
            Status::Impossible | Status::Unknown => Status::Unknown,
        };
    };
    match &mut response {
        Response::Solved(answer) => unproved(&mut answer.status, &mut answer.complete),
        Response::Front(answer) => unproved(&mut answer.status, &mut answer.complete),
        Response::Freedom(answer) => unproved(&mut answer.status, &mut answer.complete),
        Response::Explained(answer) => answer.verdict = Verdict::Unknown,
        Response::Audited(answer) => {
            answer.complete = false;
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
        let cut: Vec<Response> = whole.iter().cloned().map(cut_short).collect();
        // A plan that is there is one, proved best or not.
        let needs_no_proof =
            whole == cut || matches!(requests.as_slice(), [one] if is_found(one, &whole));
        assert!(
            needs_no_proof || !conclude(situation, did, &cut).unwrap().is_solved(),
            "{place}: cut short"
        );
    });
    assert!(asked > 25, "{asked}");
}

/// Whether a request was for any plan, and one is there.
fn is_found(request: &giveway_solve::Request, responses: &[Response]) -> bool {
    matches!(
        (request, responses),
        (giveway_solve::Request::Solve(_), [Response::Solved(answer)]) if answer.plan.is_some()
    )
}
