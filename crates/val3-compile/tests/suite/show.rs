//! Images of listings in text form.

use camino::Utf8PathBuf;
use val3_analysis::db::{Database, Project};
use val3_analysis::infer;
use val3_analysis::items::project::{folder, program_files};
use val3_analysis::load::{Workspace, load};
use val3_analysis::system::Memory;
use val3_bytecode::{Image, Program, disassemble_program};
use val3_test::{Fixture, ROOT};

use crate::text_form;

/// Loads all projects of a listing.
pub(crate) fn workspace(listing: &str) -> Workspace {
    let fixture = Fixture::parse(listing);
    let files = fixture.files.into_iter().map(|(path, text)| (Utf8PathBuf::from(ROOT).join(path), text));
    load(&Memory::new(files), &[ROOT.into()]).unwrap()
}

/// Returns the project in a folder with this name.
pub(crate) fn project(workspace: &Workspace, name: &str) -> Project {
    let is_it = |project: &&Project| folder(&workspace.db, **project).file_name() == Some(name);
    *workspace.projects.iter().find(is_it).unwrap()
}

/// Compiles the project `main`, which must not have faults.
#[track_caller]
pub(crate) fn image(listing: &str) -> Image {
    compiled(listing, |db, main| val3_compile::compile(db, main).unwrap())
}

/// Like [`image`], with counters.
#[track_caller]
pub(crate) fn counted_image(listing: &str) -> Image {
    compiled(listing, |db, main| val3_compile::compile_as(db, main, val3_compile::CodeForm::Counted).unwrap())
}

#[track_caller]
fn compiled(listing: &str, compile: impl Fn(&Database, Project) -> Image) -> Image {
    let workspace = workspace(listing);
    let main = project(&workspace, "main");
    assert_sound(&workspace.db, main);
    let image = compile(&workspace.db, main);
    text_form::check(&image);
    image
}

#[track_caller]
fn assert_sound(db: &Database, project: Project) {
    for file in program_files(db, project) {
        let problems = infer::problems(db, project, *file);
        assert!(problems.is_empty(), "{problems:?}");
    }
}

/// Returns the image's program with this name.
#[track_caller]
pub(crate) fn program<'i>(image: &'i Image, name: &str) -> &'i Program {
    image.programs.iter().find(|program| program.name == name).unwrap()
}

/// Compiles the program `start`, and returns it as text.
#[track_caller]
pub(crate) fn code(listing: &str) -> String {
    text_of(&image(listing), "start")
}

/// Formats a program without its lines' byte ranges.
pub(crate) fn text_of(image: &Image, name: &str) -> String {
    let text = disassemble_program(image, program(image, name));
    let lines = text
        .trim()
        .lines()
        .map(|line| if line.starts_with("line ") { line.split(" at ").next().unwrap() } else { line });
    lines.map(|line| line.to_owned() + "\n").collect()
}
