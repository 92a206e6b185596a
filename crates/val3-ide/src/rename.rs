//! Giving a name another name, everywhere at once.

mod conflicts;

use camino::Utf8Path;
use smol_str::SmolStr;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::project::items;
use val3_analysis::occurrences::Symbol;
use val3_syntax::TextRange;

use crate::FilePosition;
use crate::edit::{FileEdit, SourceChange};
use crate::navigate::{implementing, name_at};
use crate::references::{text, uses};

/// Why a name cannot be given another name, in a sentence for the user.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RenameError(pub String);

/// The name at a position if it can be renamed, and where it stands.
///
/// # Errors
/// If there is no name, or one that belongs to the language or the controller.
pub fn prepare_rename(db: &dyn Db, at: FilePosition) -> Result<(TextRange, String), RenameError> {
    let Some((_, found)) = name_at(db, at) else {
        return Err(RenameError("there is no name here that can be changed".to_owned()));
    };
    conflicts::is_ours(&found.symbol)?;
    Ok((found.range, text(&found.symbol).to_owned()))
}

/// The change that calls the name at a position `new_name`, in every file that uses it.
///
/// # Errors
/// If the name cannot be changed, or `new_name` is none, is taken, or would mean something else somewhere.
pub fn rename(db: &dyn Db, at: FilePosition, new_name: &str) -> Result<SourceChange, RenameError> {
    prepare_rename(db, at)?;
    let Some((project, found)) = name_at(db, at) else { return Ok(SourceChange::default()) };
    let symbols = together(db, &found.symbol);
    conflicts::check(db, project, &symbols, new_name)?;
    let mut change = SourceChange::default();
    for symbol in &symbols {
        let edit = |(file, _, range): (File, Project, TextRange)| FileEdit { file, range, text: new_name.to_owned() };
        change.edits.extend(uses(db, symbol).map(|(file, project, found)| edit((file, project, found.range))));
        change.moves.extend(moved_file(db, symbol, new_name));
    }
    change.edits.sort_by_key(|edit| (edit.file.path(db).clone(), edit.range.start()));
    change.edits.dedup();
    Ok(change)
}

/// The symbols that go by one name: an item of an interface and the same item of every library that stands in for it.
fn together(db: &dyn Db, symbol: &Symbol) -> Vec<Symbol> {
    let mut symbols = vec![symbol.clone()];
    match symbol {
        Symbol::Data(project, name) => {
            symbols.extend(implementing(db, *project).map(|other| Symbol::Data(other, name.clone())));
        }
        Symbol::Program(project, name) => {
            symbols.extend(implementing(db, *project).map(|other| Symbol::Program(other, name.clone())));
        }
        _ => {}
    }
    symbols
}

/// The file of a program has its name.
fn moved_file(db: &dyn Db, symbol: &Symbol, new_name: &str) -> Option<(camino::Utf8PathBuf, camino::Utf8PathBuf)> {
    let Symbol::Program(project, name) = symbol else { return None };
    let path: &Utf8Path = items(db, *project).programs.get(name)?.path(db);
    let same = path.file_stem() == Some(name.as_str());
    let extension = path.extension().unwrap_or("pgx");
    same.then(|| (path.to_owned(), path.with_file_name(SmolStr::new(new_name)).with_extension(extension)))
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use super::*;
    use crate::FileRange;
    use crate::testing::{Marked, shown};

    fn check(listing: &str, new_name: &str, expected: Expect) {
        let marked = Marked::new(listing);
        let db = marked.db();
        let shown = match rename(db, marked.at(), new_name) {
            Err(error) => format!("refused: {}\n", error.0),
            Ok(change) => {
                let edits = change.edits.iter().map(|edit| {
                    shown(db, FileRange { file: edit.file, range: edit.range }) + " -> " + &edit.text + "\n"
                });
                let moves = change
                    .moves
                    .iter()
                    .map(|(from, to)| format!("{} moves to {}\n", from.file_name().unwrap(), to.file_name().unwrap()));
                edits.chain(moves).collect()
            }
        };
        expected.assert_eq(&shown);
    }

    #[test]
    fn variables() {
        check(
            "num nCount\nnCo$0unt=nCount+1",
            "nTotal",
            expect![[r#"
            main/main.dtx:4 nCount -> nTotal
            main/start.pgx:5 nCount -> nTotal
            main/start.pgx:5 nCount -> nTotal
        "#]],
        );
        check(
            "program start()\n  num l_i\nbegin\n  l_i$0=1\nend",
            "l_j",
            expect![[r#"
            main/start.pgx:5 l_i -> l_j
            main/start.pgx:8 l_i -> l_j
        "#]],
        );
    }

    #[test]
    fn programs_take_their_file_along() {
        check(
            "call pi$0ck()\nprogram pick()\nbegin\nend",
            "grip",
            expect![[r#"
            main/main.pjx:5 pick -> grip
            main/pick.pgx:3 pick -> grip
            main/start.pgx:5 pick -> grip
            pick.pgx moves to grip.pgx
        "#]],
        );
    }

    #[test]
    fn every_library_of_an_interface() {
        check(
            "library part \"Disk://part/part.pjx\"\npart:nWei$0ght=1\n--- part\npublic num nWeight\n--- bag\npublic num nWeight",
            "nMass",
            expect![[r#"
                bag/bag.dtx:4 nWeight -> nMass
                main/start.pgx:5 nWeight -> nMass
                part/part.dtx:4 nWeight -> nMass
            "#]],
        );
    }

    #[test]
    fn what_would_break_is_refused() {
        check(
            "num nA\nnum nB\nn$0A=nB",
            "nB",
            expect![[r#"
            refused: there is data called `nB` already
        "#]],
        );
        check(
            "num nA\nn$0A=1",
            "end",
            expect![[r#"
            refused: `end` is a word of the language
        "#]],
        );
        check(
            "num nA\nn$0A=1",
            "1a",
            expect![[r#"
            refused: `1a` is no name: letters, digits and `_`, no digit first
        "#]],
        );
        check(
            "num nA\nprogram start()\n  num l_i\nbegin\n  n$0A=l_i\nend",
            "l_i",
            expect![[r#"
            refused: the program `start` has a local variable called `l_i`
        "#]],
        );
        check(
            "num nA\nprogram start()\n  num l_i\nbegin\n  nA=l_$0i\nend",
            "nA",
            expect![[r#"
            refused: the program uses the global `nA`, which the new name would hide
        "#]],
        );
        check(
            "num nA\nnA=si$0n(1)",
            "x",
            expect![[r#"
            refused: `sin` belongs to the language
        "#]],
        );
        check(
            "call oth$0er()\nprogram other()\nbegin\nend\nprogram more()\nbegin\nend",
            "More",
            expect![[r#"
            refused: there is a program called `More` already
        "#]],
        );
    }
}
