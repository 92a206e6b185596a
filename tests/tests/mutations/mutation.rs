//! One slip of a person: a single edit of the palletiser cell, and the finding it deserves.

/// The cell that is edited: `examples/palletiser`.
pub(crate) const CELL: &str = "palletiser";

/// One slip.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Mutation {
    /// The mistake, in words.
    pub(crate) name: &'static str,
    /// The file edited, below `usr/usrapp`.
    pub(crate) file: &'static str,
    pub(crate) edit: Edit,
    /// The code of the finding.
    pub(crate) code: &'static str,
    /// Another expected location, as file and text of its line; empty if the edit gives it.
    pub(crate) places: &'static [(&'static str, &'static str)],
    /// The code of a second finding, where the slip shows from two sides that both need to know.
    pub(crate) also: Option<&'static str>,
}

/// The change of the file.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Edit {
    /// `find`, which occurs in the file once, becomes `with`. The finding is on the lines that `$0` marks in `with`,
    /// or else on the first one.
    Replace { find: &'static str, with: &'static str },
    /// The file is gone.
    Remove,
}

/// A slip inside a file.
pub(crate) const fn slip(
    name: &'static str,
    file: &'static str,
    find: &'static str,
    with: &'static str,
    code: &'static str,
) -> Mutation {
    Mutation { name, file, edit: Edit::Replace { find, with }, code, places: &[], also: None }
}

/// A file that got lost.
pub(crate) const fn lost(name: &'static str, file: &'static str, code: &'static str) -> Mutation {
    Mutation { name, file, edit: Edit::Remove, code, places: &[], also: None }
}

impl Mutation {
    /// The finding is on one of these lines instead of the edited one.
    pub(crate) const fn at(mut self, places: &'static [(&'static str, &'static str)]) -> Mutation {
        self.places = places;
        self
    }

    /// A second finding, of the rule `code`, shows the slip from another side.
    pub(crate) const fn also(mut self, code: &'static str) -> Mutation {
        self.also = Some(code);
        self
    }
}
