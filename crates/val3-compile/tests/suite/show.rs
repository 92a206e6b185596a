//! Images of listings, and what tests show of them.

use camino::Utf8PathBuf;
use val3_analysis::db::{Database, Project};
use val3_analysis::infer;
use val3_analysis::items::project::{folder, program_files};
use val3_analysis::load::{Workspace, load};
use val3_analysis::system::Memory;
use val3_bytecode::{Image, Program, Storage, disassemble};
use val3_test::{Fixture, ROOT};

/// Every project of a listing.
pub(crate) fn workspace(listing: &str) -> Workspace {
    let fixture = Fixture::parse(listing);
    let files = fixture.files.into_iter().map(|(path, text)| (Utf8PathBuf::from(ROOT).join(path), text));
    load(&Memory::new(files), &[ROOT.into()]).unwrap()
}

/// The project in a folder of this name.
pub(crate) fn project(workspace: &Workspace, name: &str) -> Project {
    let is_it = |project: &&Project| folder(&workspace.db, **project).file_name() == Some(name);
    *workspace.projects.iter().find(is_it).unwrap()
}

/// The image of the project `main`, whose programs have no fault.
#[track_caller]
pub(crate) fn image(listing: &str) -> Image {
    let workspace = workspace(listing);
    let main = project(&workspace, "main");
    assert_sound(&workspace.db, main);
    val3_compile::compile(&workspace.db, main).unwrap()
}

#[track_caller]
fn assert_sound(db: &Database, project: Project) {
    for file in program_files(db, project) {
        let problems = infer::problems(db, project, *file);
        assert!(problems.is_empty(), "{problems:?}");
    }
}

/// A program of an image.
#[track_caller]
pub(crate) fn program<'i>(image: &'i Image, name: &str) -> &'i Program {
    image.programs.iter().find(|program| program.name == name).unwrap()
}

/// The places of the variables of `start`, the constants of its frame, and its operations.
#[track_caller]
pub(crate) fn code(listing: &str) -> String {
    let image = image(listing);
    let start = program(&image, "start");
    let variables = start.variables.iter().map(|variable| format!("{} {}", variable.name, storage(variable.storage)));
    let constants = start.nums.iter().enumerate().filter(|(_, value)| **value != 0.0);
    let constants = constants.map(|(at, value)| format!("n{at}={value}"));
    let head: Vec<String> = variables.chain(constants).collect();
    format!("{}\n{}", head.join(", "), disassemble(start))
}

fn storage(storage: Storage) -> String {
    match storage {
        Storage::Value(lanes) => format!("n{}/t{}/l{}", lanes.num, lanes.text, lanes.link),
        Storage::Part(number) => format!("Part({number})"),
        Storage::Place(number) => format!("p{number}"),
        Storage::View(number) => format!("View({number})"),
    }
}
