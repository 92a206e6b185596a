//! Fathers: the reference frame of a point or frame, and the base tool of a tool (9.4 to 9.6).

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_lang::builtins;
use val3_lang::suggest::nearest;
use val3_lang::types::{BaseType, Container};
use val3_syntax::view::View;
use val3_syntax::{TextRange, TextSlice};

use super::{DataCheck, show_size_of};
use crate::db::FileRange;
use crate::items::data;
use crate::items::fathers::{hidden_father, references, root};
use crate::items::project::{DataItem, fields, items};
use crate::problem::{Problem, ProblemKind, Related, RelatedRole};
use crate::ty::Base;
use crate::xml::{Attribute, XmlElement};

/// One step of a father reference: a name, and an optional index in brackets.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReferencePart {
    /// Name of data or of a field.
    pub name: String,
    /// Index, or key with its quotes.
    pub index: Option<String>,
}

impl DataCheck<'_> {
    /// Checks a father reference: `fatherId="fTray[0]"`, `fatherId="tSlot["a"].fFrame[0]"`.
    pub(super) fn father(&mut self, found: Attribute<'_>, expected: BaseType) {
        let text = found.text().into_owned();
        let shown = SmolStr::from(text.as_str());
        if text.trim().is_empty() || self.is_hidden(&text) {
            return;
        }
        if text.split_once(':').is_some_and(|(library, _)| !library.contains('"')) {
            return self.report(found.range, ProblemKind::FatherInLibrary { father: shown });
        }
        match self.resolve(&text) {
            Resolved::Silent => {}
            Resolved::Missing(near) => self.report(found.range, ProblemKind::FatherMissing { father: shown, near }),
            Resolved::OutOfRange(size) => self.report(found.range, ProblemKind::FatherIndex { father: shown, size }),
            Resolved::Base(base) => self.father_kind(found.range, shown, expected, base),
        }
    }

    /// Reports data called `world` or `flange` with another type: one problem for all values with this father.
    pub(super) fn hidden_father(&mut self, declared: Attribute<'_>) {
        let (db, name) = (self.db, SmolStr::from(declared.text()));
        let Some(builtin) = hidden_father(db, self.project, &name) else { return };
        let Some(item) = self.item(&name).filter(|item| item.file == self.file) else { return };
        let (expected, found) = (builtin.ty.name().into(), item.base.display(db));
        let places = references(db, self.project, &name);
        let kind = ProblemKind::FatherHidden { name, expected, found, uses: places.len() };
        let related = places.into_iter().map(|place| Related { place, role: RelatedRole::Use }).collect();
        let place = FileRange { file: self.file, range: declared.range };
        self.found.problems.push(Problem { kind, place, related });
    }

    fn is_hidden(&self, reference: &str) -> bool {
        hidden_father(self.db, self.project, root(reference)).is_some()
    }

    fn father_kind(&mut self, range: TextRange, father: SmolStr, expected: BaseType, found: Base) {
        if !found.same_as(Base::of(expected)) {
            let (expected, found) = (expected.name().into(), found.display(self.db));
            self.report(range, ProblemKind::FatherKind { father, expected, found });
        }
    }

    fn resolve(&self, reference: &str) -> Resolved {
        let Some(steps) = steps(reference) else { return Resolved::Missing(None) };
        let mut steps = steps.iter();
        let Some(first) = steps.next() else { return Resolved::Missing(None) };
        let Some(item) = self.item(&first.name) else { return self.built_in(&first.name) };
        let (mut item, mut step) = (item, first);
        loop {
            if let Some(size) = out_of_range(item, step) {
                return Resolved::OutOfRange(size);
            }
            let Some(next) = steps.next() else { return Resolved::Base(item.base) };
            let Base::User(project) = item.base else {
                return if item.base == Base::Unknown { Resolved::Silent } else { Resolved::Missing(None) };
            };
            let fields = fields(self.db, project);
            let Some(field) = fields.get(next.name.as_str()) else {
                if items(self.db, project).lacks_data {
                    return Resolved::Silent;
                }
                return Resolved::Missing(nearest(&next.name, fields.keys().map(SmolStr::as_str)).map(SmolStr::from));
            };
            (item, step) = (field, next);
        }
    }

    fn built_in(&self, name: &str) -> Resolved {
        if let Some(builtin) = builtins::find(name).filter(|builtin| builtin.is_variable) {
            return Resolved::Base(Base::of(builtin.ty));
        }
        if self.items.lacks_data {
            return Resolved::Silent;
        }
        let fathers = self
            .items
            .data
            .iter()
            .filter(|(_, item)| matches!(item.base.builtin(), Some(BaseType::Frame | BaseType::Tool)));
        let names = fathers.map(|(name, _)| name.as_str()).chain(["world", "flange"]);
        Resolved::Missing(nearest(name, names).map(SmolStr::from))
    }

    /// Checks `<fFather alias name fatherIndex>` of the old dialect, where a father may be in a library.
    pub(super) fn old_fathers(&mut self, element: XmlElement<'_>) {
        let Some((base, _)) = BaseType::from_file_name(element.name()) else { return };
        let Some(expected) = base.father() else { return };
        for father in element.elements().filter(|inner| inner.name().ends_with("Father")) {
            let Some(name) = father.attribute("name").filter(|name| !name.raw.is_empty()) else { continue };
            if father.value("alias").is_some_and(|alias| !alias.is_empty()) || self.is_hidden(&name.text()) {
                continue;
            }
            let shown = SmolStr::from(name.text());
            match self.resolve(&name.text()) {
                Resolved::Missing(near) => self.report(name.range, ProblemKind::FatherMissing { father: shown, near }),
                Resolved::Base(found) => self.father_kind(name.range, shown, expected, found),
                Resolved::OutOfRange(_) | Resolved::Silent => {}
            }
        }
    }

    /// Reports circular fathers of frames and tools. Each cycle is reported once, at its first value in the file.
    pub(super) fn father_circles(&mut self, view: View<'_>) {
        let links = links(view);
        let mut state: FxHashMap<&str, bool> = FxHashMap::default();
        for (start, _) in &links.order {
            let mut path: Vec<&str> = Vec::new();
            let mut at = start.as_str();
            while let Some((father, _)) = links.father.get(at) {
                if state.insert(at, true).is_some() {
                    break;
                }
                path.push(at);
                at = father;
            }
            if let Some(from) = path.iter().position(|node| *node == at) {
                self.circle(&links, path.part(from..));
            }
        }
    }

    fn circle(&mut self, links: &FatherLinks, nodes: &[&str]) {
        let first = nodes.iter().min_by_key(|node| links.father.get(**node).map(|(_, range)| range.start()));
        let Some((_, range)) = first.and_then(|node| links.father.get(*node)) else { return };
        let chain: Vec<SmolStr> = nodes.iter().chain(nodes.first()).map(|node| bare(node)).collect();
        self.report(*range, ProblemKind::FatherCircle { chain });
    }
}

/// Omits the index of a single value for readability: `fTray` for `fTray[0]`.
fn bare(node: &str) -> SmolStr {
    node.strip_suffix("[0]").unwrap_or(node).into()
}

enum Resolved {
    Base(Base),
    Missing(Option<SmolStr>),
    OutOfRange(SmolStr),
    /// Not reported here: another problem exists, or information is missing.
    Silent,
}

fn out_of_range(item: &DataItem, step: &ReferencePart) -> Option<SmolStr> {
    let Container::Array { .. } = item.decl.container else { return None };
    let indexes: Vec<Option<u32>> = step.index.as_ref()?.split(',').map(|index| index.trim().parse().ok()).collect();
    let sizes = &item.decl.sizes;
    let inside = indexes.len() == sizes.len()
        && indexes.iter().zip(sizes).all(|(index, size)| index.is_some_and(|index| index < *size));
    (!inside).then(|| show_size_of(&item.decl))
}

/// Splits `tSlot["a"].fFrame[0]` into its steps; `None` if it is no father reference.
pub fn steps(reference: &str) -> Option<Vec<ReferencePart>> {
    let mut steps = Vec::new();
    let mut rest = reference.trim();
    loop {
        let end = rest.find(['[', '.']).unwrap_or(rest.len());
        let (name, behind) = rest.split_at(end);
        let name = name.trim().to_owned();
        if name.is_empty() {
            return None;
        }
        let (index, behind) = match behind.strip_prefix('[') {
            Some(inner) => {
                let (index, behind) = inner.split_once(']')?;
                (Some(index.to_owned()), behind)
            }
            None => (None, behind),
        };
        steps.push(ReferencePart { name, index });
        match behind.trim_start().strip_prefix('.') {
            Some(next) => rest = next,
            None => return behind.trim().is_empty().then_some(steps),
        }
    }
}

/// Father of each value: `name[key]` to `name[key]`, with the range of the reference.
struct FatherLinks {
    father: FxHashMap<String, (String, TextRange)>,
    order: Vec<(String, TextRange)>,
}

fn links(view: View<'_>) -> FatherLinks {
    let mut links = FatherLinks { father: FxHashMap::default(), order: Vec::new() };
    for element in data::elements(view).filter(|element| element.name() == "Data") {
        let is_father = matches!(element.value("type").as_deref(), Some("frame" | "tool"));
        let Some(name) = element.value("name").filter(|_| is_father) else { continue };
        for value in element.elements() {
            let (Some(key), Some(father)) = (value.value("key"), value.attribute("fatherId")) else { continue };
            let node = format!("{name}[{key}]");
            let reference = father.text().replace('"', "");
            let reference = if reference.contains('[') { reference } else { format!("{reference}[0]") };
            links.order.push((node.clone(), father.range));
            links.father.entry(node).or_insert((reference, father.range));
        }
    }
    links
}

#[cfg(test)]
mod tests {
    use super::steps;

    fn shown(reference: &str) -> Option<String> {
        let steps = steps(reference)?;
        let step = |step: &super::ReferencePart| format!("{}({})", step.name, step.index.as_deref().unwrap_or("-"));
        Some(steps.iter().map(step).collect::<Vec<_>>().join(" "))
    }

    #[test]
    fn references_are_split_into_parts() {
        assert_eq!(shown("fTray").as_deref(), Some("fTray(-)"));
        assert_eq!(shown(" fTray[1,2] ").as_deref(), Some("fTray(1,2)"));
        assert_eq!(shown("slot[\"a\"].fIn[0].fOut").as_deref(), Some("slot(\"a\") fIn(0) fOut(-)"));
        for reference in ["", "[0]", "a[0", "a.", ".a", "a[0]b", "a[0][1]"] {
            assert_eq!(shown(reference), None, "{reference}");
        }
    }
}
