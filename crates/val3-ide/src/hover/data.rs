//! Global data: its type, its initial value, and the chain of its fathers.

use val3_analysis::db::{Db, Project};
use val3_analysis::items::data;
use val3_analysis::items::parse;
use val3_analysis::items::project::{DataItem, items};
use val3_analysis::xml::Element;
use val3_syntax::view::View;

use super::{fenced, shape};

/// Values of a container that are shown.
const SHOWN: usize = 5;
/// Fathers that are followed; a circle ends there.
const LONGEST_CHAIN: usize = 20;

pub(super) fn hover(db: &dyn Db, project: Project, name: &str) -> Option<String> {
    let item = items(db, project).data.get(name)?;
    let access = if item.decl.public { "public " } else { "" };
    let head = format!("{access}{} {name}{}", item.decl.type_name, shape(&item.decl.sizes, item.decl.container));
    let mut text = fenced(&head);
    let values = values(db, item, name);
    if !values.is_empty() {
        text.push_str("\nstarts as\n");
        text.push_str(&fenced(&values.join("\n")));
    }
    let fathers = fathers(db, project, name);
    if fathers.len() > 1 {
        text.push_str(&format!(
            "\nhangs on {}\n",
            fathers.iter().skip(1).map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", on ")
        ));
    }
    Some(text)
}

/// The element that declares data, handed to `read`.
fn with_element<T>(db: &dyn Db, item: &DataItem, name: &str, read: impl FnOnce(Element<'_>) -> T) -> Option<T> {
    let parse = parse(db, item.file);
    let mut elements = data::elements(View::root(parse.green()));
    elements.find(|element| element.value("name").as_deref() == Some(name)).map(read)
}

/// The initial values, one a line: key, then attributes as they are written.
fn values(db: &dyn Db, item: &DataItem, name: &str) -> Vec<String> {
    let single = item.decl.sizes == [1];
    let read = |element: Element<'_>| {
        let count = element.elements().count();
        let mut lines: Vec<String> = element.elements().take(SHOWN).filter_map(|value| line(value, single)).collect();
        if count > SHOWN {
            lines.push(format!("… {} more", count - SHOWN));
        }
        lines
    };
    with_element(db, item, name, read).unwrap_or_default()
}

/// The keys of the values that a data file writes, in its order.
pub(crate) fn keys_of(db: &dyn Db, project: Project, name: &str) -> Vec<String> {
    let keys = |element: Element<'_>| {
        element.elements().filter_map(|value| value.value("key")).map(|key| key.into_owned()).collect()
    };
    let item = items(db, project).data.get(name);
    item.and_then(|item| with_element(db, item, name, keys)).unwrap_or_default()
}

fn line(value: Element<'_>, single: bool) -> Option<String> {
    let shown: Vec<String> = value
        .attributes()
        .filter(|attribute| attribute.name != "key")
        .map(|attribute| match attribute.name {
            "value" => attribute.text().into_owned(),
            name => format!("{name}={}", attribute.text()),
        })
        .collect();
    if shown.is_empty() {
        return None;
    }
    let key = value.value("key").filter(|_| !single).map(|key| format!("[{key}] ")).unwrap_or_default();
    Some(key + &shown.join(" "))
}

/// The data and its fathers, by name, up to `world`, `flange` or what cannot be followed.
fn fathers(db: &dyn Db, project: Project, name: &str) -> Vec<String> {
    let items = items(db, project);
    let mut chain = vec![name.to_owned()];
    while let Some(item) = chain.last().and_then(|last| items.data.get(last.as_str()))
        && chain.len() < LONGEST_CHAIN
    {
        let last = chain.last().map(String::as_str).unwrap_or_default();
        let father = with_element(db, item, last, |element| {
            element.elements().next().and_then(|value| value.value("fatherId").map(|father| father.into_owned()))
        });
        let Some(father) = father.flatten().filter(|father| !father.is_empty()) else { break };
        let root = father.split(['[', '.']).next().unwrap_or("").to_owned();
        if root.is_empty() || chain.contains(&root) {
            break;
        }
        chain.push(root);
    }
    chain
}
