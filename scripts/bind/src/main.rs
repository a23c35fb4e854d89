//! What Wasm needs on its way from the compiler to a page.
//!
//! - `giveway-bind WASM FOLDER NAME` makes of compiled Wasm the files that a page loads,
//!   `NAME.js` and `NAME_bg.wasm`.
//! - `giveway-bind split WASM LATER PATHS` takes out of bound Wasm what a first visit does
//!   not run, by the paths that a file lists, and writes it as a program of its own.
//! - `giveway-bind count WASM FUNCTIONS` has bound Wasm note which of its functions run, and
//!   writes what they are called.

mod choice;
mod count;
mod split;

use std::env;
use std::error::Error;
use std::fs;
use std::process::ExitCode;

use choice::Listed;
use wasm_bindgen_cli_support::Bindgen;

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let (wasm, done) = match arguments.as_slice() {
        ["split", wasm, later, modules] => (wasm, split_file(wasm, later, modules)),
        ["count", wasm, functions] => (wasm, count_file(wasm, functions)),
        [wasm, folder, name] => (wasm, bind(wasm, folder, name)),
        others => {
            eprintln!(
                "giveway-bind: found {} arguments, expected WASM FOLDER NAME, count WASM FUNCTIONS, or split WASM LATER PATHS",
                others.len()
            );
            return ExitCode::from(2);
        }
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("giveway-bind: {wasm}: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn bind(wasm: &str, folder: &str, name: &str) -> Result<(), Box<dyn Error>> {
    let mut bindgen = Bindgen::new();
    bindgen.input_path(wasm).out_name(name).typescript(false);
    Ok(bindgen.web(true)?.generate(folder)?)
}

fn split_file(wasm: &str, later: &str, paths: &str) -> Result<(), Box<dyn Error>> {
    let listed = Listed::read(&fs::read_to_string(paths)?);
    let parts = split::split(&fs::read(wasm)?, &listed)?;
    fs::write(wasm, parts.first)?;
    fs::write(later, parts.later)?;
    Ok(())
}

fn count_file(wasm: &str, functions: &str) -> Result<(), Box<dyn Error>> {
    let counted = count::count(&fs::read(wasm)?)?;
    fs::write(wasm, counted.wasm)?;
    fs::write(functions, counted.functions)?;
    Ok(())
}
