//! Certificates as one file.

use std::collections::BTreeMap;

use giveway_proof::Report;
use giveway_solve::{ExportAnswer, ExportRequest, Request, Response, serve};
use js_sys::{Reflect, Uint8Array};
use serde::Serialize;
use wasm_bindgen::{JsValue, prelude::wasm_bindgen};

use super::error::{Code, error};
use super::zip::pack;
use super::{answered, objects, with_callbacks};
use crate::budget::within_budget;

/// What is told beside the bytes.
#[derive(Serialize)]
struct Exported {
    /// What came of checking each, by their names.
    reports: BTreeMap<String, Report>,
    missing: u32,
}

/// Makes certificates, checks them, and packs them into a zip archive.
///
/// # Errors
/// As [`solve`](super::solve).
#[wasm_bindgen(js_name = exportCertificates, skip_typescript)]
pub fn export_certificates(request: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    with_callbacks(options, |host| {
        let request: ExportRequest = objects::read(request)?;
        match serve(&within_budget(Request::Export(request)), host) {
            Response::Exported(answer) => packed(*answer),
            other => answered(other),
        }
    })
}

fn packed(answer: ExportAnswer) -> Result<JsValue, JsValue> {
    let (mut bundles, mut reports) = (BTreeMap::new(), BTreeMap::new());
    for (name, exported) in answer.certificates {
        let files = exported.files.into_iter();
        let bundle = files
            .map(|(file, text)| (file, text.into_bytes()))
            .collect();
        bundles.insert(name.clone(), bundle);
        reports.insert(name, exported.report);
    }
    let bytes = pack(&bundles).map_err(|fault| error(Code::BadInput, &[fault]))?;
    let missing = answer.missing;
    let object = objects::write(&Exported { reports, missing })?;
    Reflect::set(&object, &"zip".into(), &Uint8Array::from(&bytes[..]))?;
    Ok(object)
}
