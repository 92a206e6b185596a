//! Names of bodies.

/// Names of all bodies: the base, the links, the things.
pub(crate) fn body_names<'n>(things: impl Iterator<Item = &'n str>, axes: usize) -> impl Iterator<Item = String> {
    let links = (1..=axes).map(|link| format!("link{link}"));
    std::iter::once("base".to_owned()).chain(links).chain(things.map(str::to_owned))
}
