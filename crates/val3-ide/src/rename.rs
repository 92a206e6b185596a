//! Giving a name another name, everywhere at once.

mod conflicts;
mod keys;

use camino::Utf8Path;
use smol_str::SmolStr;
use val3_analysis::application::ENTRY_POINTS;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::project::items;
use val3_analysis::occurrences::Symbol;
use val3_syntax::TextRange;

use crate::FilePosition;
use crate::edit::{FileEdit, SourceChange};
use crate::navigate::{implemented, implementing, name_at};
use crate::references::{text, uses};

/// Why a name cannot be given another name, in a sentence for the user.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RenameError(pub String);

/// The name, or the key of a collection, at a position if it can be renamed, and where it stands.
///
/// # Errors
/// If there is no name, or one that belongs to the language or the controller.
pub fn prepare_rename(db: &dyn Db, at: FilePosition) -> Result<(TextRange, String), RenameError> {
    if let Some(found) = keys::key_at(db, at) {
        return Ok((found.range, found.key));
    }
    let Some((_, found)) = name_at(db, at) else {
        return Err(RenameError("there is no name here that can be changed".to_owned()));
    };
    conflicts::is_ours(db, &found.symbol)?;
    Ok((found.range, text(&found.symbol).to_owned()))
}

/// The change that calls the name at a position `new_name`, in every file that uses it.
///
/// # Errors
/// If the name cannot be changed, or `new_name` is none, is taken, or would mean something else somewhere.
pub fn rename(db: &dyn Db, at: FilePosition, new_name: &str) -> Result<SourceChange, RenameError> {
    prepare_rename(db, at)?;
    if let Some(found) = keys::key_at(db, at) {
        return keys::rename(db, &found, new_name);
    }
    let Some((_, found)) = name_at(db, at) else { return Ok(SourceChange::default()) };
    let symbols = together(db, &found.symbol);
    conflicts::check(db, &symbols, new_name)?;
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

/// The symbols that go by one name: an item of an interface and the same item of every library that is loaded in its
/// place, which may in turn be loaded in place of others.
fn together(db: &dyn Db, symbol: &Symbol) -> Vec<Symbol> {
    let mut symbols = vec![symbol.clone()];
    let mut next = 0;
    while let Some(symbol) = symbols.get(next).cloned() {
        for other in same_item(db, &symbol) {
            if !symbols.contains(&other) {
                symbols.push(other);
            }
        }
        next += 1;
    }
    symbols
}

/// The item of the same name in the projects that stand in for this one's or that it stands in for.
fn same_item(db: &dyn Db, symbol: &Symbol) -> Vec<Symbol> {
    let related = |project: Project| implementing(db, project).chain(implemented(db, project));
    match symbol {
        Symbol::Data(project, name) => {
            let declares = |project: &Project| items(db, *project).data.contains_key(name);
            related(*project).filter(declares).map(|project| Symbol::Data(project, name.clone())).collect()
        }
        Symbol::Program(project, name) if !ENTRY_POINTS.contains(&name.as_str()) => {
            let declares = |project: &Project| items(db, *project).programs.contains_key(name);
            related(*project).filter(declares).map(|project| Symbol::Program(project, name.clone())).collect()
        }
        _ => Vec::new(),
    }
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
            "library part \"Disk://part/part.pjx\"\npart:libLoad(\"Disk://bag\")\npart:nWei$0ght=1\n--- part\npublic num nWeight\n--- bag\npublic num nWeight",
            "nMass",
            expect![[r#"
                bag/bag.dtx:4 nWeight -> nMass
                main/start.pgx:6 nWeight -> nMass
                part/part.dtx:4 nWeight -> nMass
            "#]],
        );
    }

    #[test]
    fn names_in_texts_and_references() {
        let library = "library part \"Disk://part/part.pjx\"\npoint pA\n";
        check(
            &format!("{library}getData(\"part:pTr$0ack[0]\",pA)\n--- part\npublic point pTrack"),
            "pPath",
            expect![[r#"
                main/start.pgx:5 pTrack -> pPath
                part/part.dtx:4 pTrack -> pPath
            "#]],
        );
        check(
            &format!(
                "{library}if part:libExist(\"pi$0ck()\")\ncall part:pick()\nendIf\n--- part\npublic program pick()\nbegin\nend"
            ),
            "grip",
            expect![[r#"
                main/start.pgx:5 pick -> grip
                main/start.pgx:6 pick -> grip
                part/part.pjx:5 pick -> grip
                part/pick.pgx:3 pick -> grip
                pick.pgx moves to grip.pgx
            "#]],
        );
        check(
            "cls()\n=== main/main.dtx\n<Database><Datas><Data name=\"fTa$0ble\" type=\"frame\" /><Data name=\"pA\" type=\"pointRx\">\n<Value key=\"0\" fatherId=\"fTable[0]\" /></Data></Datas></Database>",
            "fBench",
            expect![[r#"
                main/main.dtx:1 fTable -> fBench
                main/main.dtx:2 fTable -> fBench
            "#]],
        );
    }

    #[test]
    fn what_the_project_file_names() {
        check(
            "library pa$0rt \"Disk://part/part.pjx\"\nput(part:nWeight)\n--- part\npublic num nWeight",
            "piece",
            expect![[r#"
                main/main.pjx:11 part -> piece
                main/start.pgx:5 part -> piece
            "#]],
        );
        check(
            "type Slot \"Disk://Slot/Slot.pjx\"\nSlot sSlot\nsSlot.nHe$0ight=1\n--- Slot\npublic num nHeight",
            "nSize",
            expect![[r#"
                Slot/Slot.dtx:4 nHeight -> nSize
                main/start.pgx:5 nHeight -> nSize
            "#]],
        );
        check(
            "type Slot \"Disk://Slot/Slot.pjx\"\nprogram start()\n  Slot l_s\nbegin\n  l_$0s.nHeight=1\nend\n--- Slot\npublic num nHeight",
            "l_slot",
            expect![[r#"
                main/start.pgx:5 l_s -> l_slot
                main/start.pgx:8 l_s -> l_slot
            "#]],
        );
    }

    #[test]
    fn keys_of_collections() {
        check(
            "dio dIn[\"door\",\"lamp\"]\nwait(dIn[\"do$0or\"])\ndIn[ \"door\" ]=dIn[\"lamp\"]\nputln(\"door\")",
            "gate",
            expect![[r#"
                main/main.dtx:5 door -> gate
                main/start.pgx:5 door -> gate
                main/start.pgx:6 door -> gate
            "#]],
        );
        check(
            "frame fIn[\"door\"]\ncls()\n=== main/main.dtx\n<Database><Datas><Data name=\"fIn\" xsi:type=\"collection\" type=\"frame\">\n<Value key=\"do$0or\" /></Data><Data name=\"pA\" type=\"pointRx\">\n<Value key=\"0\" fatherId=\"fIn[&quot;door&quot;]\" /></Data></Datas></Database>",
            "gate",
            expect![[r#"
                main/main.dtx:2 door -> gate
                main/main.dtx:3 door -> gate
            "#]],
        );
        check(
            "dio dIn[\"door\",\"lamp\"]\nwait(dIn[\"do$0or\"])",
            "lamp",
            expect![[r#"
            refused: `dIn` has the key `lamp` already
        "#]],
        );
        check(
            "dio dIn[\"door\"]\nstring sKey\nwait(dIn[\"do$0or\"])\nwait(dIn[sKey])",
            "gate",
            expect![[r#"
            refused: `dIn` is also asked for keys that are computed
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
            "num nA\nn$0A=nB",
            "nB",
            expect![[r#"
            refused: the program `start` uses the name `nB`, which is not declared yet
        "#]],
        );
        check(
            "num nA\nnA=nO$0ther",
            "nB",
            expect![[r#"
            refused: there is no name here that can be changed
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
            "num nA\nnA$0=1",
            "movej",
            expect![[r#"
                refused: `movej` is a word of the language
            "#]],
        );
        check(
            "num nA\nnA$0=1\ncall part()\nprogram part()\nbegin\nend",
            "part",
            expect![[r#"
                refused: there is a program called `part` already
            "#]],
        );
        check(
            "num nA\nprogram start()\n  num l_i\nbegin\n  l_$0i=1\nend\nprogram part()\nbegin\nend",
            "part",
            expect![[r#"
                refused: there is a program called `part` already
            "#]],
        );
        check(
            "call pi$0ck()\nprogram pick()\nbegin\nend\n=== val3.toml\n[lint]\nentry-points = [\"pick\"]",
            "grip",
            expect![[r#"
                refused: `pick` is called from outside of the code, as `val3.toml` says
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
