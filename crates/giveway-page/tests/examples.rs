//! The page's examples are listed, can be read, and fit the page.

use std::fs;
use std::path::Path;

use giveway_model::format::native;
use giveway_page::{Draft, examples};

#[test]
fn every_example_can_be_opened() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../static/examples");
    let text = |name: &str| fs::read_to_string(folder.join(name)).unwrap();
    let examples = examples::read(&text("index.json")).unwrap();
    assert!(examples.len() > 3);
    for example in &examples {
        let instance = native::read_instance(&text(&example.file)).unwrap();
        assert!(Draft::new(instance.to_scene()).is_ok(), "{}", example.file);
        assert!(!example.title.is_empty() && example.line.ends_with('.'));
    }
    let files = fs::read_dir(&folder).unwrap();
    let scenes = files.filter(|file| {
        let path = file.as_ref().unwrap().path();
        path.extension()
            .is_some_and(|extension| extension == "json")
            && !path.ends_with("index.json")
    });
    assert_eq!(scenes.count(), examples.len(), "each is listed");
}
