//! One door for all functions: a name and a request as JSON in, an answer as JSON out.

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Mutex, PoisonError};

use giveway_formats::convert;
use giveway_model::format::{from_object, native, schema};
use giveway_model::question::from_words;
use giveway_model::{Fault, Instance, Plan, Scene, compare};
use giveway_proof::Bundle;
use giveway_solve::{Host, Limits, Proofs, Refusal, Request, Response, serve, verify};
use serde::{Deserialize, Deserializer, Serialize, de::DeserializeOwned};

use crate::{export, files, sweep};

/// What this module proved so far, for questions about its plans.
static PROOFS: Mutex<Proofs> = Mutex::new(Proofs::new());

/// What kind of thing is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Code {
    /// A request is not of the type that it should be.
    BadInput,
    /// A scene is no instance of the problem.
    BadScene,
    /// A text is not of the format.
    BadText,
    /// The program has a fault.
    Broken,
}

/// Why there is no answer; there is at least one fault.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Failure {
    /// What kind of thing is wrong.
    pub code: Code,
    /// What exactly, and where.
    pub faults: Vec<Fault>,
}

impl Failure {
    pub(crate) fn new(code: Code, faults: Vec<Fault>) -> Self {
        Self { code, faults }
    }

    pub(crate) fn input(fault: Fault) -> Self {
        Self::new(Code::BadInput, vec![fault])
    }
}

/// Calls a function by its name.
///
/// # Errors
/// When the request or what it holds is wrong. A panic, which nothing from outside should
/// cause, is told the same way.
///
/// ```
/// use giveway_solve::SilentHost;
/// let scene = r#"{ "giveway": 1, "map": [".."], "agents": [{ "name": "A", "start": [0, 0], "goal": [1, 0] }] }"#;
/// let request = format!(r#"{{ "scene": {scene} }}"#);
/// let answer = giveway_python::call("solve", &request, &SilentHost).unwrap();
/// assert!(answer.contains(r#""status":"optimal""#));
/// ```
pub fn call(function: &str, request: &str, host: &dyn Host) -> Result<String, Failure> {
    catch_unwind(AssertUnwindSafe(|| called(function, request, host))).unwrap_or_else(|_| {
        let fault = Fault::at("", "a fault of this program", "none; please report it");
        Err(Failure::new(Code::Broken, vec![fault]))
    })
}

fn called(function: &str, text: &str, host: &dyn Host) -> Result<String, Failure> {
    let request = match function {
        "solve" => Request::Solve(read(text)?),
        "check" => Request::Check(read(text)?),
        "explain" => Request::Explain(read(text)?),
        "change" => Request::Change(read(text)?),
        "audit" => Request::Audit(read(text)?),
        "freedom" => Request::Freedom(read(text)?),
        "price" => Request::Price(read(text)?),
        "delays" => Request::Delays(read(text)?),
        "order" => Request::Order(read(text)?),
        "sizing" => Request::Sizing(read(text)?),
        "plan" => Request::Plan(read(text)?),
        "together" => Request::Together(read(text)?),
        "certify" => Request::Certify(read(text)?),
        "export" => export::request(read(text)?)?,
        "verify" => return verified(&read(text)?, host),
        "compare" => return compared(read(text)?),
        "convert" => {
            let converted = convert::convert(&read(text)?);
            return write(&converted.map_err(|faults| Failure::new(Code::BadText, faults))?);
        }
        "decode" => return write(&files::decoded(&read(text)?)?),
        "read-files" => return write(&files::combined(&read(text)?)?),
        "read-movingai" => return write(&files::moving_ai(&read(text)?)?),
        "read-scene" => {
            let read = native::read_instance(text);
            let instance = read.map_err(|faults| Failure::new(Code::BadText, faults))?;
            return write(&instance.to_scene());
        }
        "read-plan" => {
            let read = native::read_plan(text);
            return write(&read.map_err(|fault| Failure::new(Code::BadText, vec![fault]))?);
        }
        "scene-of-object" => {
            let read = Instance::new(read(text)?);
            let instance = read.map_err(|faults| Failure::new(Code::BadScene, faults))?;
            return write(&instance.to_scene());
        }
        "plan-of-object" => return write(&read::<Plan>(text)?),
        "read-question" => return question(&read(text)?),
        "schema" => return Ok(schema().to_owned()),
        "sweep-tasks" => return write(&sweep::tasks(&read(text)?)?),
        "sweep-run" => return write(&sweep::row(&read(text)?, host)),
        "sweep-skipped" => return write(&sweep::skipped(&read(text)?)),
        "sweep-rows" => return write(&sweep::rows(&read(text)?)?),
        "sweep-table" => return write(&sweep::table(&read(text)?)?),
        _ => {
            let found = format!("the unknown function \"{function}\"");
            return Err(Failure::input(Fault::at("", found, "one of this package")));
        }
    };
    let kept = || PROOFS.lock().unwrap_or_else(PoisonError::into_inner);
    let request = kept().completed(request);
    let response = serve(&request, host);
    kept().keep(request, &response);
    respond(response)
}

fn respond(response: Response) -> Result<String, Failure> {
    match response {
        Response::Solved(answer) => write(&answer),
        Response::Front(answer) => write(&answer),
        Response::Checked(answer) => write(&answer),
        Response::Explained(answer) => write(&answer),
        Response::Certified(report) => write(&report),
        Response::Exported(answer) => write(&answer),
        Response::Changed(answer) => write(&answer),
        Response::Audited(answer) => write(&answer),
        Response::Freedom(answer) => write(&answer),
        Response::Priced(answer) => write(&answer),
        Response::Delays(answer) => write(&answer),
        Response::Order(answer) => write(&answer),
        Response::Sized(answer) => write(&answer),
        Response::Planned(answer) => write(&answer),
        Response::Together(answer) => write(&answer),
        Response::Refused(refusal) => {
            let code = match refusal {
                Refusal::Scene { .. } => Code::BadScene,
                _ => Code::BadInput,
            };
            Err(Failure::new(code, refusal.faults()))
        }
    }
}

/// Reads a request; its faults have the keys on the way to their place, and no line of a
/// text that nobody sees.
fn read<T: DeserializeOwned>(text: &str) -> Result<T, Failure> {
    struct Object<T>(T);

    impl<'de, T: Deserialize<'de>> Deserialize<'de> for Object<T> {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            from_object(deserializer).map(Self)
        }
    }

    let object = native::read_object::<Object<T>>(text);
    object.map(|object| object.0).map_err(|fault| {
        let (line, column) = (None, None);
        Failure::input(Fault {
            line,
            column,
            ..fault
        })
    })
}

/// The instance of the scene of a request.
pub(crate) fn instance(scene: Scene) -> Result<Instance, Failure> {
    Instance::new(scene).map_err(|faults| {
        let faults = Refusal::Scene { faults }.faults();
        Failure::new(Code::BadScene, faults)
    })
}

fn write<T: Serialize>(data: &T) -> Result<String, Failure> {
    serde_json::to_string(data).map_err(|error| {
        let fault = Fault::at("", error.to_string(), "data that JSON can hold");
        Failure::new(Code::Broken, vec![fault])
    })
}

/// What is checked again: the files of a certificate, and how long that may take.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct VerifyRequest {
    files: BTreeMap<String, String>,
    #[serde(default, deserialize_with = "from_object")]
    limits: Limits,
}

fn verified(request: &VerifyRequest, host: &dyn Host) -> Result<String, Failure> {
    let files = request.files.iter();
    let files: Bundle = files
        .map(|(name, text)| (name.clone(), text.clone().into_bytes()))
        .collect();
    write(&verify(&files, request.limits, host))
}

/// Two plans of one scene.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CompareRequest {
    scene: Scene,
    plans: [Plan; 2],
}

fn compared(request: CompareRequest) -> Result<String, Failure> {
    let instance = instance(request.scene)?;
    let [one, other] = &request.plans;
    write(&compare::compare(&instance, one, other))
}

/// A question in the words of the command.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Words {
    words: Vec<String>,
}

fn question(request: &Words) -> Result<String, Failure> {
    match from_words(&request.words) {
        Ok(question) => write(&question),
        Err(error) => Err(Failure::input(error.fault())),
    }
}

#[cfg(test)]
mod tests;
