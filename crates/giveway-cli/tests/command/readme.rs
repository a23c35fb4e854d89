//! What the README shows of the command is what the command says.

use std::path::Path;

use crate::run::command;

#[test]
fn its_examples_are_what_the_command_says() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    // A packed crate has no README of the whole project.
    let Ok(readme) = std::fs::read_to_string(root.join("README.md")) else {
        return;
    };
    let examples: Vec<&str> = readme.split("```console\n$ giveway ").skip(1).collect();
    assert!(examples.len() >= 2, "{}", examples.len());
    for example in examples {
        let (line, rest) = example.split_once('\n').unwrap();
        let (shown, _) = rest.split_once("```").unwrap();
        let output = command()
            .args(line.split_whitespace())
            .current_dir(&root)
            .output()
            .unwrap();
        let said = String::from_utf8(output.stdout).unwrap();
        assert!(said.starts_with(shown.trim_end()), "{line}:\n{said}");
    }
}
