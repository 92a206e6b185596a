//! A slip: a single edit in the palletiser cell, and the finding that it must cause.

/// The edited cell: `examples/palletiser`.
pub(crate) const CELL: &str = "palletiser";

/// A slip.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Mutation {
    /// Description of the slip.
    pub(crate) name: &'static str,
    /// Edited file, below `usr/usrapp`.
    pub(crate) file: &'static str,
    pub(crate) edit: Edit,
    /// Code of the finding.
    pub(crate) code: &'static str,
    /// Other expected locations, as file and text of the line; empty if the edit determines the location.
    pub(crate) places: &'static [(&'static str, &'static str)],
    /// Code of a second finding, if the slip has to be reported from two sides.
    pub(crate) also: Option<&'static str>,
}

/// Change of the file.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Edit {
    /// Replaces `find`, which occurs once in the file, by `with`. The finding is on the lines that `$0` marks in
    /// `with`, otherwise on the first line.
    Replace { find: &'static str, with: &'static str },
    /// Removes the file.
    Remove,
}

/// Creates a slip inside a file.
pub(crate) const fn slip(
    name: &'static str,
    file: &'static str,
    find: &'static str,
    with: &'static str,
    code: &'static str,
) -> Mutation {
    Mutation { name, file, edit: Edit::Replace { find, with }, code, places: &[], also: None }
}

/// Creates a slip that removes a file.
pub(crate) const fn lost(name: &'static str, file: &'static str, code: &'static str) -> Mutation {
    Mutation { name, file, edit: Edit::Remove, code, places: &[], also: None }
}

impl Mutation {
    /// Sets expected lines that differ from the edited line.
    pub(crate) const fn at(mut self, places: &'static [(&'static str, &'static str)]) -> Mutation {
        self.places = places;
        self
    }

    /// Adds a second finding, of the rule `code`.
    pub(crate) const fn also(mut self, code: &'static str) -> Mutation {
        self.also = Some(code);
        self
    }
}
