//! `docs/atlas.md` is in step with the registry.

use std::fs;
use std::path::Path;

use holdup::study::atlas::{Atlas, markdown};

#[test]
fn the_atlas_in_docs_is_in_step_with_the_registry() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/atlas.md");
    let right = markdown::markdown(&Atlas::of(|_| true));
    if fs::read_to_string(&file).unwrap_or_default() != right {
        fs::create_dir_all(file.parent().unwrap()).unwrap();
        fs::write(&file, right).unwrap();
        panic!(
            "{} was not in step with the registry and has been rewritten: run the tests again",
            file.display()
        );
    }
}
