//! `giveway-bind WASM FOLDER NAME`: makes of compiled Wasm the files that a page loads,
//! `NAME.js` and `NAME_bg.wasm`.

use std::env;
use std::process::ExitCode;

use wasm_bindgen_cli_support::Bindgen;

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [wasm, folder, name] = arguments.as_slice() else {
        eprintln!(
            "giveway-bind: found {} arguments, expected WASM FOLDER NAME",
            arguments.len()
        );
        return ExitCode::from(2);
    };
    let mut bindgen = Bindgen::new();
    bindgen.input_path(wasm).out_name(name).typescript(false);
    match bindgen
        .web(true)
        .and_then(|bindgen| bindgen.generate(folder))
    {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("giveway-bind: {wasm}: {error:#}");
            ExitCode::FAILURE
        }
    }
}
