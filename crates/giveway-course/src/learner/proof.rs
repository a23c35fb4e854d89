//! The proof of a plan in the hands of a learner: checked as it is, and with one byte
//! changed.

use giveway_model::{Instance, Plan, Scene, check::costs};
use giveway_proof::{Budget, Bundle, verify};
use giveway_solve::{Certificate, CertifyRequest, ExportRequest, Limits, Request, Response};

use super::{AskNumber, Effect, Learner};

/// The name of the certificate.
const NAME: &str = "plan";
/// What ends the name of a file with a proof.
const PROOF: &str = ".drat";
/// How long it may take to make it, in seconds.
const SECONDS: f64 = 20.0;

/// The proof that no plan is better than the one on the board.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Proof {
    /// Nobody asked for it.
    #[default]
    Unasked,
    /// The solver writes it.
    Asked(AskNumber),
    /// It is here, and was checked.
    Held(Box<Held>),
    /// There is none.
    Missing,
}

/// A certificate, and what the checker says of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Held {
    bundle: Bundle,
    /// The byte that was changed.
    changed: Option<Changed>,
    is_accepted: bool,
}

/// A byte that is another one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Changed {
    /// The name of its file.
    pub file: String,
    /// Its place there, from 0.
    pub at: usize,
    /// The figure that stood there, and the one that stands there now.
    pub figures: (char, char),
}

impl Held {
    fn new(bundle: Bundle) -> Self {
        let is_accepted = accepts(&bundle);
        Self {
            bundle,
            changed: None,
            is_accepted,
        }
    }

    /// Whether the checker accepts it as it is now.
    pub const fn is_accepted(&self) -> bool {
        self.is_accepted
    }

    /// The byte that was changed, if one was.
    pub const fn changed(&self) -> Option<&Changed> {
        self.changed.as_ref()
    }

    /// How many bytes all files have together.
    pub fn bytes(&self) -> usize {
        self.bundle.values().map(Vec::len).sum()
    }

    /// The same with another figure in the middle of the proof; back to what it was, where one
    /// is changed. The checker looks again.
    fn turned(&self) -> Self {
        let mut bundle = self.bundle.clone();
        let changed = match &self.changed {
            Some(before) => {
                put(&mut bundle, before, before.figures.0);
                None
            }
            None => middle(&bundle).inspect(|found| put(&mut bundle, found, found.figures.1)),
        };
        let is_accepted = accepts(&bundle);
        Self {
            bundle,
            changed,
            is_accepted,
        }
    }
}

fn accepts(bundle: &Bundle) -> bool {
    let report = verify(bundle, &Budget::default());
    report.accepted && report.conclusion.is_some()
}

/// A figure near the middle of a proof.
fn middle(bundle: &Bundle) -> Option<Changed> {
    let (file, bytes) = bundle.iter().find(|(name, _)| name.ends_with(PROOF))?;
    let half = bytes.len() / 2;
    let figures = bytes
        .iter()
        .enumerate()
        .filter(|(_, byte)| byte.is_ascii_digit());
    let (at, &byte) = figures.min_by_key(|(at, _)| at.abs_diff(half))?;
    let other = if byte == b'9' { b'1' } else { byte + 1 };
    Some(Changed {
        file: file.clone(),
        at,
        figures: (char::from(byte), char::from(other)),
    })
}

fn put(bundle: &mut Bundle, place: &Changed, figure: char) {
    let bytes = bundle.get_mut(&place.file);
    if let (Some(byte), Ok(figure)) = (
        bytes.and_then(|bytes| bytes.get_mut(place.at)),
        u8::try_from(figure),
    ) {
        *byte = figure;
    }
}

/// What is asked: a certificate that the plan is a best one.
fn request(scene: &Scene, plan: &Plan) -> Option<Request> {
    let instance = Instance::new(scene.clone()).ok()?;
    let costs = costs(&instance, plan)?;
    let objective = instance.objective().costs().iter();
    let request = CertifyRequest {
        scene: scene.clone(),
        bounds: objective.map(|&cost| (cost, costs.get(cost))).collect(),
        complete: true,
        plan: Some(plan.clone()),
        ..CertifyRequest::default()
    };
    Some(Request::Export(ExportRequest {
        certificates: vec![Certificate {
            name: NAME.to_owned(),
            request,
        }],
        limits: Limits {
            seconds: Some(SECONDS),
            ..Limits::default()
        },
    }))
}

/// What was answered: a certificate that was accepted when it was made.
fn held(response: Response) -> Proof {
    let Response::Exported(mut answer) = response else {
        return Proof::Missing;
    };
    let Some(made) = answer.certificates.remove(NAME) else {
        return Proof::Missing;
    };
    let files = made.files.into_iter();
    let bundle: Bundle = files
        .map(|(name, text)| (name, text.into_bytes()))
        .collect();
    let held = Held::new(bundle);
    if held.is_accepted && middle(&held.bundle).is_some() {
        Proof::Held(Box::new(held))
    } else {
        Proof::Missing
    }
}

impl Learner {
    /// The proof of the step's plan is asked for.
    pub(super) fn check_proof(&mut self, effects: &mut Vec<Effect>) {
        let asked = self.open.as_ref().and_then(|open| {
            let plan = open.step()?.plan.as_ref()?;
            let is_open = matches!(open.proof()?, Proof::Unasked | Proof::Missing);
            is_open.then(|| request(&open.scene, plan))?
        });
        let Some(request) = asked else { return };
        // One question at a time: what the judge was at comes first.
        self.forget(effects);
        let number = self.next_ask();
        if let Some(open) = &mut self.open {
            open.proof = Proof::Asked(number);
        }
        let request = Box::new(request);
        effects.push(Effect::Ask { number, request });
    }

    /// A byte is changed, or is again what it was.
    pub(super) fn change_byte(&mut self) {
        if let Some(open) = &mut self.open
            && let Proof::Held(held) = &open.proof
        {
            open.proof = Proof::Held(Box::new(held.turned()));
        }
    }

    /// An answer, where it is the proof that was asked for.
    pub(super) fn proved(&mut self, number: AskNumber, response: Option<Response>) {
        if let Some(open) = &mut self.open
            && open.proof == Proof::Asked(number)
        {
            open.proof = response.map_or(Proof::Missing, held);
        }
    }
}
