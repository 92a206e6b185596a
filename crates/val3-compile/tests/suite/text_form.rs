//! Text form of images: it assembles to an equal image.
//!
//! The helpers of other tests check this for every image.

use camino::Utf8PathBuf;
use val3_analysis::load::load;
use val3_analysis::system::Disk;
use val3_bytecode::{Image, assemble, disassemble};

/// Checks that the text form of an image assembles to an equal image.
#[track_caller]
pub(crate) fn check(image: &Image) {
    let text = disassemble(image);
    let again = assemble(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    if again != *image {
        assert_eq!(disassemble(&again), text);
        assert_eq!(&again, image);
    }
}

#[test]
fn images_of_the_examples_are_assembled_from_their_text() {
    let examples = Utf8PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples"));
    let workspace = load(&Disk, &[examples]).unwrap();
    let images = workspace.projects.iter().filter_map(|project| val3_compile::compile(&workspace.db, *project).ok());
    assert!(images.inspect(check).count() > 3);
}
