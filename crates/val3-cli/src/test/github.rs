//! Results as workflow commands of GitHub Actions: each failure becomes a note at its line in the pull request.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;

use super::tested::{Tested, described};
use crate::format::github::{data, property};
use crate::paths::Paths;

/// Writes one command a failure, at the line of the innermost program.
pub(super) fn write(tested: &[Tested], paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
    for Tested { case, result } in tested {
        let Some(failure) = &result.failure else { continue };
        let place = failure.places.iter().find(|place| !place.file.is_empty());
        let (file, line) = place.map_or((&case.file, case.line), |place| (&place.file, place.line));
        let file = property(&paths.in_repository(file.as_str().into()));
        let title = property(&case.name());
        writeln!(
            out,
            "::error file={file},line={line},title={title}::{}",
            data(&described(failure, paths).join("\n"))
        )?;
    }
    Ok(())
}
