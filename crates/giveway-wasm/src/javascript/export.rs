//! Certificates as one file.

use std::collections::BTreeMap;

use giveway_solve::{Certificate, CertifyRequest, ExportRequest, Request, Response, serve};
use js_sys::{Object, Reflect, Uint8Array};
use wasm_bindgen::{JsValue, prelude::wasm_bindgen};

use super::error::{Code, error};
use super::objects;
use super::response::{answered, with_callbacks};
use super::zip::pack;
use crate::budget::within_budget;

/// Makes certificates, checks them, and packs them into a zip archive. Requests come by
/// the names of their folders, each with its own limits.
///
/// # Errors
/// As [`solve`](super::solve).
#[wasm_bindgen(js_name = exportCertificates, skip_typescript)]
pub fn export_certificates(requests: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    with_callbacks(options, |host| {
        let requests: BTreeMap<String, CertifyRequest> = objects::read(requests)?;
        let (mut bundles, mut reports) = (BTreeMap::new(), BTreeMap::new());
        for (name, request) in requests {
            let limits = request.limits;
            let certificates = vec![Certificate { name, request }];
            let request = Request::Export(ExportRequest {
                certificates,
                limits,
            });
            let answer = match serve(&within_budget(request), host) {
                Response::Exported(answer) => answer,
                other => return answered(other),
            };
            for (name, exported) in answer.certificates {
                let files = exported.files.into_iter();
                let bundle = files
                    .map(|(file, text)| (file, text.into_bytes()))
                    .collect();
                bundles.insert(name.clone(), bundle);
                reports.insert(name, exported.report);
            }
        }
        let bytes = pack(&bundles).map_err(|fault| error(Code::BadInput, &[fault]))?;
        let exported = Object::new();
        let zip = Uint8Array::from(&bytes[..]);
        Reflect::set(&exported, &"zip".into(), &zip)?;
        Reflect::set(&exported, &"reports".into(), &objects::write(&reports)?)?;
        Ok(exported.into())
    })
}
