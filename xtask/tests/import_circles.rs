//! At most three files of a crate depend on each other in a circle.
//!
//! A file depends on the file that defines an item which it names. Re-exports are followed to the definition.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test may fail loudly")]

mod circles;
mod edges;

use camino::{Utf8Path, Utf8PathBuf};
use cargo_metadata::MetadataCommand;

use crate::modules;

/// Largest number of files in a circle, for example a module and its parts.
const MOST: usize = 3;

/// Describes the circles of more than `most` files in the crate with the root `file`.
fn circles(file: &Utf8Path, folder: &Utf8Path, most: usize) -> Vec<String> {
    let edges = edges::edges(&modules::read(file));
    circles::circles(&edges, most).iter().map(|circle| circles::describe(&edges, circle, folder)).collect()
}

#[test]
fn no_circle_has_more_than_three_files() {
    let metadata = MetadataCommand::new().no_deps().exec().unwrap();
    let found: Vec<_> =
        modules::roots(&metadata).flat_map(|file| circles(file, &metadata.workspace_root, MOST)).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// Returns the circles of a crate that consists of `files`: path and text, the root first.
fn circles_of(files: &[(&str, &str)], most: usize) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    let folder = Utf8PathBuf::try_from(folder.path().to_owned()).unwrap();
    for (path, text) in files {
        let path = folder.join(path);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }
    circles(&folder.join(files[0].0), &folder, most)
}

#[test]
fn a_circle_is_described_by_a_shortest_cycle() {
    let files = [
        ("lib.rs", "mod a; mod b; mod c; pub use c::C;"),
        ("a.rs", "use crate::b::{self, B}; pub(crate) struct A(B); fn f() { b::g() }"),
        ("b.rs", "use crate::{c, C}; pub(crate) struct B; fn g(_: C, _: c::C) {}"),
        ("c.rs", "pub struct C; impl C { fn f() { vec![super::a::A] } }"),
    ];
    let expected = "\
3 files in a circle:
  a.rs
  b.rs
  c.rs
a shortest cycle:
  a.rs names B, b::g, crate::b::B of b.rs
  b.rs names C, c::C, crate::C of c.rs
  c.rs names super::a::A of a.rs
";
    assert_eq!(circles_of(&files, 2), [expected]);
    assert!(circles_of(&files, 3).is_empty());
}

#[test]
fn a_glob_is_followed_to_the_names_that_are_used() {
    let a = ("a.rs", "pub(crate) fn g() {} fn f() { crate::b::f() }");
    let b = |text| [("lib.rs", "mod a; mod b; mod p { pub(crate) use crate::a::*; }"), a, ("b.rs", text)];
    assert_eq!(circles_of(&b("use crate::p::*; pub(crate) fn f() { g() }"), 1).len(), 1);
    assert!(circles_of(&b("use crate::p::*; pub(crate) fn f() {}"), 1).is_empty());
}

#[test]
fn a_reexport_with_the_name_of_its_module_is_followed() {
    let b = "use crate::a; pub(crate) fn b() { a() }";
    let files = [("lib.rs", "mod a; mod b; pub use a::a;"), ("a.rs", "pub fn a() { crate::b::b() }"), ("b.rs", b)];
    assert_eq!(circles_of(&files, 1).len(), 1);
}

#[test]
fn modules_reexports_and_tests_make_no_edge() {
    let files = [
        ("lib.rs", "mod a; pub use a::A; pub struct B;"),
        ("a.rs", "mod c; use crate::B; pub struct A(B); #[cfg(test)] use c::C; #[cfg(test)] fn f() { c::f() }"),
        ("a/c.rs", "use super::A; pub(super) struct C(A);"),
    ];
    assert!(circles_of(&files, 1).is_empty());
}

#[test]
fn an_item_that_a_macro_defines_is_found() {
    let (root, b) = (("lib.rs", "mod a; mod b;"), ("b.rs", "use crate::a::Kind; pub(crate) fn f(_: Kind) {}"));
    let crate_with = |kinds: &str| circles_of(&[root, ("a.rs", kinds), b], 1);
    let defined = "macro_rules! kinds { ($($n:ident)*) => { pub enum Kind { $($n),* } } } kinds! { A B }";
    assert!(crate_with(defined).is_empty());
    assert_eq!(crate_with(&format!("{defined} fn g() {{ crate::b::f(Kind::A) }}")).len(), 1);
    assert_eq!(crate_with("macros::structs! { Kind } fn g() { crate::b::f(Kind) }").len(), 1);
}

#[test]
fn modules_that_a_macro_declares_are_read() {
    let rules = "
        macro_rules! rules { ($($m:ident)*) => { $(mod $m;)* static ALL: &[&u8] = &[$(&$m::RULE),*]; } }
        macro_rules! families { ($($f:ident { $($m:ident)* })*) => { $(mod $f { $(pub(crate) mod $m;)* })* } }
        macro_rules! rule { ($text:literal) => { pub(crate) static RULE: u8 = 0; } }
        rules! { a b }
        families! { motion { c } }";
    let b = ("b.rs", "rule! { \"\" } pub(crate) fn b() { crate::a::a() }");
    let c = ("motion/c.rs", "pub(crate) fn c() { crate::b::b() }");
    let circles = |a| circles_of(&[("lib.rs", rules), ("a.rs", a), b, c], 1);
    assert!(circles("rule! { \"\" } pub(crate) fn a() {}").is_empty());
    assert_eq!(circles("rule! { \"\" } pub(crate) fn a() { crate::motion::c::c() }").len(), 1);
}
