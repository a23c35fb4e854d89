//! Certificates as files: made, and checked as anyone would check them.

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{format::from_object, message::read_map};
use giveway_proof::{Report, bundle::export_checked};
use serde::{Deserialize, Serialize};

use super::{CertifyRequest, within};
use crate::{Host, Limits, Progress, Refusal};

/// A claim that can be certified by itself.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(deny_unknown_fields)]
pub struct Certificate {
    /// A name for its folder: letters, digits and hyphens.
    pub name: String,
    /// The claims to certify. The limits in it are not used.
    pub request: CertifyRequest,
}

/// Make certificates as files, and check them.
#[derive(
    Clone, Debug, Default, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(deny_unknown_fields)]
pub struct ExportRequest {
    /// The claims, each with a name of its own.
    pub certificates: Vec<Certificate>,
    /// The budget of all of them; for making the files of each there is half of what
    /// is left.
    #[serde(default, deserialize_with = "from_object")]
    pub limits: Limits,
}

/// Certificates as files.
#[derive(
    Clone, Debug, Default, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(deny_unknown_fields)]
pub struct ExportAnswer {
    /// The certificates that there was time for, by their names: the files of each,
    /// and what came of checking them.
    #[borsh(deserialize_with = "read_map")]
    pub certificates: BTreeMap<String, Exported>,
    /// How many there was no time for.
    pub missing: u32,
}

/// A certificate as files.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(deny_unknown_fields)]
pub struct Exported {
    /// The texts of its files by their names.
    #[borsh(deserialize_with = "read_map")]
    pub files: BTreeMap<String, String>,
    /// The report of checking them.
    pub report: Report,
}

/// Makes certificates as files and checks them, one after the other until the time
/// is over.
pub(crate) fn export(request: &ExportRequest, host: &dyn Host) -> Result<ExportAnswer, Refusal> {
    let start = host.wall_seconds();
    let of = u32::try_from(request.certificates.len()).unwrap_or(u32::MAX);
    let mut answer = ExportAnswer::default();
    for (done, certificate) in (0..).zip(&request.certificates) {
        let left = request.limits.seconds;
        let left = left.map(|limit| limit - (host.wall_seconds() - start));
        if host.cancelled() || left.is_some_and(|left| left <= 0.0) {
            answer.missing = of.saturating_sub(done);
            break;
        }
        host.progress(&Progress::Exporting { done, of });
        let limits = Limits {
            seconds: left,
            ..request.limits
        };
        let exported = one(&certificate.request, limits, host)?;
        answer
            .certificates
            .insert(certificate.name.clone(), exported);
    }
    Ok(answer)
}

fn one(request: &CertifyRequest, limits: Limits, host: &dyn Host) -> Result<Exported, Refusal> {
    let instance = request.instance()?;
    let solved = request.claims(&instance);
    let (bundle, report) = within((limits, &instance), host, |making, checking| {
        export_checked(&solved, making, checking)
    });
    // All of them are written as texts.
    let text = |bytes: Vec<u8>| String::from_utf8_lossy(&bytes).into_owned();
    let files = bundle.into_iter();
    Ok(Exported {
        files: files.map(|(name, bytes)| (name, text(bytes))).collect(),
        report,
    })
}

#[cfg(test)]
mod tests {
    use giveway_model::{Instance, Scene, format::native};
    use giveway_proof::{Bundle, verify};

    use super::*;
    use crate::freedom::FreedomRequest;
    use crate::{Request, Response, SilentHost, serve};

    /// Two agents that must pass each other at a side pocket.
    const SCENE: &str = r##"{ "giveway": 1, "map": ["....", "#.##"],
        "agents": [{ "name": "a", "start": [0, 0], "goal": [3, 0] },
                   { "name": "b", "start": [3, 0], "goal": [0, 0] }] }"##;

    fn claims(scene: &Scene) -> Vec<Certificate> {
        let request = FreedomRequest {
            scene: scene.clone(),
            ..FreedomRequest::default()
        };
        match serve(&Request::Freedom(request), &SilentHost) {
            Response::Freedom(answer) => {
                let instance = Instance::new(scene.clone()).unwrap();
                answer.certificates(&instance)
            }
            other => panic!("{other:?}"),
        }
    }

    fn exported(seconds: Option<f64>) -> (usize, ExportAnswer) {
        let certificates = claims(&native::read_scene(SCENE).unwrap());
        let number = certificates.len();
        let limits = Limits {
            seconds,
            ..Limits::default()
        };
        let request = Request::Export(ExportRequest {
            certificates,
            limits,
        });
        match serve(&request, &SilentHost) {
            Response::Exported(answer) => (number, *answer),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn every_claim_has_its_files_and_they_hold() {
        let (number, answer) = exported(None);
        assert!(number > 3, "{number}");
        assert_eq!((answer.certificates.len(), answer.missing), (number, 0));
        for (name, Exported { files, report }) in answer.certificates {
            assert!(report.accepted, "{name}: {report:?}");
            let bytes = files.into_iter();
            let mut bundle: Bundle = bytes.map(|(file, text)| (file, text.into())).collect();
            let again = verify(&bundle, &giveway_proof::Budget::default());
            assert_eq!(again, report, "{name}");
            // The other way round: files that were changed do not hold.
            bundle.get_mut("instance.json").unwrap().push(b' ');
            assert!(!verify(&bundle, &giveway_proof::Budget::default()).accepted);
        }
    }

    #[test]
    fn what_there_is_no_time_for_is_counted() {
        let (number, answer) = exported(Some(0.0));
        assert_eq!(
            (answer.certificates.len(), answer.missing as usize),
            (0, number)
        );
    }
}
