//! Completions in `cell.toml`: keys, carriers, tools, signals, names of things, mesh files.

mod cursor;

use std::collections::{BTreeMap, BTreeSet};

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::db::{Db, Project};
use val3_analysis::items::project::items;
use val3_analysis::occurrences::Symbol;
use val3_analysis::surroundings::signal_paths;
use val3_analysis::system::{PathKind, System};
use val3_cell::CellFile;
use val3_config::{SchemaKey, ValueForm, schema_keys, schema_words, table_strings};
use val3_lang::data_path::DataPath;
use val3_lang::types::BaseType;
use val3_syntax::{TextRange, TextSize};

use super::list::{Completion, CompletionKind as Kind, CompletionList};
use crate::FilePosition;
use crate::father_paths::father_paths;
use crate::owner::{owner, surrounded};
use cursor::{TomlCursor, TomlPlace};

/// Carriers of the arm.
const ARM_CARRIERS: [&str; 3] = ["world", "base", "flange"];

/// Keys whose value is a signal, and tables whose keys are signals.
const SIGNALS: [&str; 3] = ["io", "holding", "empty"];

/// Tables of things, whose names other keys mention.
const THINGS: [&str; 4] = ["object", "part", "sensor", "conveyor"];

/// Nesting limit of folders with meshes.
const DEEPEST: usize = 4;

/// Maximum number of entries that are searched for meshes.
const MOST_ENTRIES: usize = 2000;

/// Score bonus of the application's names.
const OWN: i32 = 20;

/// Completions at a position in a `cell.toml`.
pub(super) fn complete(db: &dyn Db, at: FilePosition) -> Vec<Completion> {
    let Some((cursor, mut found)) = open(db, at) else { return Vec::new() };
    let path: Vec<&str> = cursor.path.iter().map(String::as_str).collect();
    let last = path.last().copied().unwrap_or_default();
    match cursor.place {
        TomlPlace::Header => headers(&mut found),
        TomlPlace::Key if SIGNALS.contains(&last) => signals(&mut found, &cursor),
        TomlPlace::Key if !cursor.is_quoted => keys(&mut found, &path),
        TomlPlace::Key => {}
        TomlPlace::Value => values(&mut found, &path, &cursor),
    }
    found.ranked()
}

/// Mesh files that a position in a `cell.toml` can name, in the folder of the file or below.
pub fn mesh_completions(db: &dyn Db, system: &dyn System, at: FilePosition) -> Vec<Completion> {
    let Some((cursor, mut found)) = open(db, at) else { return Vec::new() };
    if cursor.place != TomlPlace::Value || cursor.path.last().is_none_or(|key| key != "mesh") {
        return Vec::new();
    }
    let folder = at.file.path(db).parent().unwrap_or(Utf8Path::new("")).to_owned();
    for path in meshes(system, &folder) {
        add(&mut found, &cursor, path.as_str(), Kind::Path, "mesh");
    }
    found.ranked()
}

/// Returns the cursor and an empty list; `None` outside of a `cell.toml`, and in its comments.
fn open(db: &dyn Db, at: FilePosition) -> Option<(TomlCursor, CompletionList<'_>)> {
    let project = owner(db, at.file).filter(|project| project.surroundings(db) == Some(at.file))?;
    let cursor = TomlCursor::at(at.file.text(db), at.offset.into())?;
    let size = |at: usize| TextSize::try_from(at).unwrap_or_default();
    let range = TextRange::new(size(cursor.range.start), size(cursor.range.end));
    Some((cursor, CompletionList::new(db, project, at, range)))
}

fn headers(found: &mut CompletionList<'_>) {
    let (is_double, is_closed) = (found.around.0.ends_with("[["), found.is_before("]"));
    let tables = schema_keys::<CellFile>(&[]).into_iter().filter(|key| key.form == ValueForm::Tables);
    for SchemaKey { name, description, .. } in tables {
        let open = if is_double { "" } else { "[" };
        let text = format!("{open}{name}{}", if is_closed { "" } else { "]]" });
        found.add(&name, Kind::Keyword).with(|item| {
            (item.insert, item.plain) = (text.clone(), text);
            item.documentation = Some(description);
        });
    }
}

fn keys(found: &mut CompletionList<'_>, path: &[&str]) {
    let is_start = found.around.0.rsplit('\n').next().is_some_and(|line| line.trim().is_empty());
    let of_table =
        schema_keys::<CellFile>(path).into_iter().filter(|key| !path.is_empty() || key.form != ValueForm::Tables);
    for SchemaKey { name, description, form } in of_table {
        let (snippet, plain) = match form {
            ValueForm::Text => (format!("{name} = \"$0\""), format!("{name} = \"\"")),
            ValueForm::Plain => (format!("{name} = $0"), format!("{name} = ")),
            ValueForm::List => (format!("{name} = [$0]"), format!("{name} = []")),
            ValueForm::Table => (format!("{name} = {{ $0 }}"), format!("{name} = {{ }}")),
            ValueForm::Tables => (format!("{name} = [{{ $0 }}]"), format!("{name} = [{{ }}]")),
        };
        found.add(&name, Kind::Attribute).scored(OWN).with(|item| {
            (item.insert, item.plain, item.is_snippet) = (snippet, plain, true);
            item.documentation = Some(description);
        });
    }
    let tables = schema_keys::<CellFile>(&[]).into_iter().filter(|key| is_start && key.form == ValueForm::Tables);
    for SchemaKey { name, description, .. } in tables {
        let header = format!("[[{name}]]\n");
        found.add(&name, Kind::Keyword).with(|item| {
            item.label = format!("[[{name}]]");
            (item.insert, item.plain) = (header.clone(), header);
            item.documentation = Some(description);
        });
    }
}

fn values(found: &mut CompletionList<'_>, path: &[&str], cursor: &TomlCursor) {
    match path.last().copied().unwrap_or_default() {
        "in" => carriers(found, cursor),
        "tool" => data(found, cursor, BaseType::Tool),
        "allow" => {
            bodies(found, cursor);
            things(found, cursor, THINGS.as_slice());
        }
        "part" => things(found, cursor, &["part"]),
        "objects" | "sees" => things(found, cursor, &["object", "part", "conveyor"]),
        key if SIGNALS.contains(&key) => signals(found, cursor),
        _ => {
            for word in schema_words::<CellFile>(path) {
                let is_plain = word == "true" || word == "false";
                if is_plain && !cursor.is_quoted {
                    found.add(&word, Kind::Constant);
                } else if !is_plain {
                    add(found, cursor, &word, Kind::Constant, "");
                }
            }
        }
    }
}

/// Adds a text, with quotes if the cursor is not between quotes.
fn add(found: &mut CompletionList<'_>, cursor: &TomlCursor, text: &str, kind: Kind, detail: &str) {
    let quote = if text.contains(['\\', '"']) { '\'' } else { '"' };
    let quoted = if cursor.is_quoted { text.to_owned() } else { format!("{quote}{text}{quote}") };
    found.add(text, kind).detail(|| detail.to_owned()).with(|item| {
        (item.insert, item.plain) = (quoted.clone(), quoted);
    });
}

fn carriers(found: &mut CompletionList<'_>, cursor: &TomlCursor) {
    data(found, cursor, BaseType::Frame);
    data(found, cursor, BaseType::Tool);
    things(found, cursor, &["object"]);
    for name in ARM_CARRIERS {
        add(found, cursor, name, Kind::Constant, "");
    }
    for link in links(found) {
        add(found, cursor, &link, Kind::Constant, "");
    }
}

/// Names of the arm's links.
fn links(found: &CompletionList<'_>) -> Vec<String> {
    let arm = val3_analysis::arm::arm(found.db, found.project);
    let axes = arm.as_ref().map_or(6, |arm| arm.model.axes());
    (1..=axes).map(|link| format!("link{link}")).collect()
}

/// The arm and its parts.
fn bodies(found: &mut CompletionList<'_>, cursor: &TomlCursor) {
    for name in ["arm".to_owned(), "base".to_owned()].into_iter().chain(links(found)) {
        add(found, cursor, &name, Kind::Constant, "");
    }
}

/// Frames or tools of the applications that use the file, and of their libraries.
fn data(found: &mut CompletionList<'_>, cursor: &TomlCursor, ty: BaseType) {
    for project in surrounded(found.db, found.file) {
        let before = found.items.len();
        data_of(found, cursor, ty, project);
        found.items.iter_mut().skip(before).for_each(|item| item.score += OWN);
    }
}

fn data_of(found: &mut CompletionList<'_>, cursor: &TomlCursor, ty: BaseType, project: Project) {
    let own = items(found.db, project);
    for (name, path) in carrier_paths(found.db, project, ty, false) {
        add(found, cursor, &path, Kind::Data, ty.name());
        symbol(found, &path, || Symbol::Data(project, name.as_str().into()));
    }
    for (alias, library) in &own.libraries {
        let Some(interface) = library.interface else { continue };
        for (name, path) in carrier_paths(found.db, interface, ty, true) {
            let path = format!("{alias}:{path}");
            add(found, cursor, &path, Kind::Data, ty.name());
            symbol(found, &path, || Symbol::Data(interface, name.as_str().into()));
        }
    }
}

/// Sets the symbol of the last completion, if it has this label.
fn symbol(found: &mut CompletionList<'_>, label: &str, symbol: impl FnOnce() -> Symbol) {
    if let Some(item) = found.items.last_mut().filter(|item| item.label == label) {
        item.symbol = Some(symbol());
    }
}

/// Elements of a type in a project, each with the name of the variable: `fPallet`, `fPallets[1]`.
fn carrier_paths(db: &dyn Db, project: Project, ty: BaseType, is_public: bool) -> Vec<(String, String)> {
    let mut paths = Vec::new();
    for (name, item) in items(db, project).data.iter().filter(|(_, item)| item.decl.public || !is_public) {
        for path in father_paths(db, project, name, item, ty) {
            let is_only = item.decl.sizes == [1] && DataPath::new(&path).before_index() == name;
            let path = if is_only { path.replacen("[0]", "", 1) } else { path };
            paths.push((name.to_string(), path));
        }
    }
    paths
}

/// Names of other things in the file.
fn things(found: &mut CompletionList<'_>, cursor: &TomlCursor, tables: &[&str]) {
    let text = found.file.text(found.db);
    let strings = table_strings(text).into_iter().filter(|string| is_name_in(tables, &string.key));
    let names: BTreeSet<String> = strings.map(|string| string.text).collect();
    for name in names.iter().filter(|name| !name.is_empty()) {
        add(found, cursor, name, Kind::Element, "");
    }
}

/// Whether a key is the name of an entry in one of the tables, for example `object[2].name`.
fn is_name_in(tables: &[&str], key: &str) -> bool {
    let table = key.strip_suffix("].name").and_then(|entry| entry.split_once('['));
    table.is_some_and(|(table, _)| tables.contains(&table))
}

/// Signals in the configuration of the cell, and links of the applications' data.
fn signals(found: &mut CompletionList<'_>, cursor: &TomlCursor) {
    let projects = surrounded(found.db, found.file);
    let paths: BTreeMap<String, BaseType> = projects.flat_map(|project| signal_paths(found.db, project)).collect();
    for (path, ty) in paths {
        add(found, cursor, &path, Kind::Text, ty.name());
    }
}

/// Paths of STL and GLB files in a folder and below, relative to the folder.
fn meshes(system: &dyn System, folder: &Utf8Path) -> Vec<Utf8PathBuf> {
    let (mut found, mut open, mut searched) = (Vec::new(), vec![(Utf8PathBuf::new(), 0)], 0);
    while let Some((below, depth)) = open.pop() {
        for name in system.list(&folder.join(&below)).unwrap_or_default() {
            searched += 1;
            let path = below.join(&name);
            let extension = path.extension().map(str::to_ascii_lowercase);
            let is_hidden = name.starts_with('.') || system.is_link(&folder.join(&path));
            if searched > MOST_ENTRIES || is_hidden {
                continue;
            }
            match extension.as_deref() {
                Some("stl" | "glb") => found.push(path),
                Some(_) => {}
                None if depth < DEEPEST && system.kind(&folder.join(&path)) == Some(PathKind::Folder) => {
                    open.push((path, depth + 1));
                }
                None => {}
            }
        }
    }
    found.sort();
    found
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use crate::completion::completions;
    use crate::mesh_completions;
    use crate::testing::MarkedListing;

    const APPLICATION: &str = "frame fPallet\nframe fRows[2]\ntool tGrip\nnum nA\nlibrary part \"Disk://part/part.pjx\"\ncls()\n\
        --- part\npublic frame fNest\nframe fOwn\n=== /val3.toml\narm = \"tx2-60l\"\n=== /cad/rack.stl\nsolid\n=== /cad/note.txt\n\n=== /cell.toml\n";

    fn check(cell: &str, expected: Expect) {
        let marked = MarkedListing::new(&format!("{APPLICATION}{cell}"));
        let mut found = completions(marked.db(), marked.at());
        found.extend(mesh_completions(marked.db(), &marked.system, marked.at()));
        let lines = found.iter().map(|item| format!("{} -> {}\n", item.label, item.plain.trim_end().escape_debug()));
        expected.assert_eq(&lines.collect::<String>());
    }

    #[test]
    fn carriers_are_frames_tools_things_and_parts_of_the_arm() {
        check(
            "[[object]]\nname = \"plate\"\n[[object]]\nin = \"$0\"\n",
            expect![[r#"
                fPallet -> fPallet
                fRows[0] -> fRows[0]
                fRows[1] -> fRows[1]
                part:fNest -> part:fNest
                tGrip -> tGrip
                base -> base
                flange -> flange
                link1 -> link1
                link2 -> link2
                link3 -> link3
                link4 -> link4
                link5 -> link5
                link6 -> link6
                plate -> plate
                world -> world
            "#]],
        );
        check(
            "[[object]]\nin = fPal$0",
            expect![[r#"
            fPallet -> \"fPallet\"
        "#]],
        );
    }

    #[test]
    fn a_feed_names_parts() {
        check(
            "[[part]]\nname = \"carton\"\n[[object]]\nname = \"plate\"\n[[conveyor]]\nfeed = { part = \"$0\" }",
            expect![[r#"
                carton -> carton
            "#]],
        );
    }

    #[test]
    fn signals_are_those_of_the_configuration_and_of_data() {
        let boards = "=== /configs/bio.cfx\n<bio><bioDin index=\"0\" /></bio>\n";
        let data = r#"=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="aiVacuum" access="private" xsi:type="array" type="aio" size="1">
      <Value key="0" link="ModbusSrv-0\Modbus-Word\Vacuum" />
    </Data>
    <Data name="tGrip" access="private" xsi:type="array" type="tool" size="1">
      <Value key="0" fatherId="flange[0]" ioLink="FastIO\fOut0" />
    </Data>
  </Datas>
</Database>
"#;
        check(
            &format!("[[sensor]]\nio = '$0'\n{boards}{data}"),
            expect![[r#"
                BasicIO-1\%I0 -> BasicIO-1\\%I0
                FastIO\fOut0 -> FastIO\\fOut0
                ModbusSrv-0\Modbus-Word\Vacuum -> ModbusSrv-0\\Modbus-Word\\Vacuum
            "#]],
        );
    }

    #[test]
    fn keys_are_those_of_the_table() {
        check(
            "cl$0",
            expect![[r#"
            clearance -> clearance =
        "#]],
        );
        check(
            "[[object]]\nbo$0",
            expect![[r#"
            box -> box = []
        "#]],
        );
        check(
            "[[object]]\nshapes = [{ sphere = { ra$0",
            expect![[r#"
            radius -> radius =
        "#]],
        );
        check(
            "[[obj$0",
            expect![[r#"
            object -> object]]
        "#]],
        );
    }

    #[test]
    fn values_are_words_meshes_and_names() {
        check(
            "[[object]]\nunit = \"$0\"",
            expect![[r#"
            m -> m
            mm -> mm
        "#]],
        );
        check(
            "[[object]]\nhull = $0",
            expect![[r#"
            false -> false
            true -> true
        "#]],
        );
        check(
            "[[object]]\nmesh = \"$0\"",
            expect![[r#"
            cad/rack.stl -> cad/rack.stl
        "#]],
        );
        check(
            "allow = [[\"rack\", \"ra$0\"]]\n[[object]]\nname = \"rack\"",
            expect![[r#"
            rack -> rack
        "#]],
        );
        check("[[object]]\nname = \"$0\"", expect![[r#""#]]);
    }
}
