//! Certificates as an archive.

use giveway_proof::bundle::archive::unpack;
use giveway_proof::{Budget, verify};
use js_sys::{Reflect, Uint8Array};
use serde_json::{Value, json};
use wasm_bindgen::{JsCast as _, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

use super::{data, object, solve, told, warehouse};

fn export(request: &Value) -> Result<JsValue, JsValue> {
    giveway_wasm::export_certificates(&object(request), &JsValue::UNDEFINED)
}

fn request() -> Value {
    let answer = solve(&json!({ "scene": warehouse() }));
    let claimed = json!({
        "scene": warehouse(), "about": { "most": {}, "within": null }, "bounds": answer["bounds"],
        "impossible": false, "complete": answer["complete"], "within": answer["within"],
        "plan": answer["plan"],
    });
    json!({ "best": claimed })
}

#[wasm_bindgen_test]
fn the_archive_holds_what_anyone_can_check() {
    let exported = export(&request()).unwrap();
    let zip = Reflect::get(&exported, &"zip".into()).unwrap();
    let zip: Uint8Array = zip.dyn_into().expect("bytes");
    let reports = data(&Reflect::get(&exported, &"reports".into()).unwrap());
    assert_eq!(reports["best"]["certified"], "proved");
    let bundles = unpack(&zip.to_vec()).unwrap();
    assert_eq!(bundles.len(), 1);
    let report = verify(&bundles["best"], &Budget::default());
    assert_eq!(json!(report), reports["best"]);
}

#[wasm_bindgen_test]
fn what_is_wrong_is_told_with_its_place_and_what_has_no_time_is_left_out() {
    let mut wrong = request();
    wrong["best"]["scene"]["map"] = json!(7);
    let (code, place, _) = told(&export(&wrong).unwrap_err());
    assert_eq!(code, "bad-input");
    assert_eq!(place, "best.scene.map");
    let mut none = request();
    none["best"]["limits"] = json!({ "seconds": 0 });
    let exported = data(&export(&none).unwrap());
    assert_eq!(exported["reports"], json!({}));
}
